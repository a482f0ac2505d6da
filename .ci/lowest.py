"""Print the lowest versions that pyproject.toml allows, as constraints for pip: `make test-lowest` installs them."""

import re
import tomllib
from pathlib import Path

project = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
extras = project["optional-dependencies"]
for requirement in [
    *project["dependencies"],
    *(one for name in ("render", "plot", "experiments", "notebook") for one in extras[name]),
]:
    if lowest := re.match(r"([\w.-]+)>=([\w.]+)", requirement):
        print("==".join(lowest.groups()))

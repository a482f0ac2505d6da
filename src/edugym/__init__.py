"""EduGym: a reinforcement-learning course you can run.

Importing it registers the environments with Gymnasium, and nothing more: every other name is loaded when it is first
used. `__init__.pyi` lists the public names; an agent, a wrapper or an environment is also found by the name of its file
(`edugym.QLearning` in `agents/q_learning.py`).
"""

import ast
import importlib
import importlib.util
import sys
from functools import cache
from pathlib import Path
from typing import Any

from edugym.system.interrupts import SignalGuard

with SignalGuard():  # Python ignores a Ctrl-C that comes at certain moments of an import
    from edugym._old_names import install
    from edugym.adapters.registration import in_snake_case, register_environments

__version__ = "0.2.0"

register_environments()
install()


@cache
def _homes() -> dict[str, str]:
    """The module of each public name, as `__init__.pyi` lists them."""
    imports = ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")).body
    return {name.name: str(part.module) for part in imports if isinstance(part, ast.ImportFrom) for name in part.names}


def __getattr__(name: str) -> Any:
    """Load a public name when it is first used."""
    if name == "__all__":  # for `from edugym import *`
        return __dir__()
    home = _homes().get(name)
    meant = [one for one in _homes() if one.lower() == name.lower()]
    if meant and home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}: is {meant[0]!r} meant?")
    file = in_snake_case(name)
    for folder in ("agents", "mdp", "envs"):
        if home is None and file != name and importlib.util.find_spec(f"edugym.{folder}.{file}"):
            home = f"edugym.{folder}.{file}"
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if home not in sys.modules:
        with SignalGuard():
            importlib.import_module(home)
    return getattr(importlib.import_module(home), name)


def __dir__() -> list[str]:
    """The public names, for completion."""
    return sorted(_homes())

"""Files of figures."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image

from edugym.experiments.figures import Sheet, VisitMap, save_figure

SAVE = """
import sys
import numpy as np
from edugym.experiments.figures import Sheet, VisitMap, save_figure

save_figure(Sheet("map", [[VisitMap(np.arange(6.0).reshape(2, 3), 10)]]).draw(), sys.argv[1])
"""


def test_axes_stand_for_their_figure(tmp_path: Path) -> None:
    """They are what one draws on."""
    one, other = (Sheet("map", [[VisitMap(np.arange(6.0).reshape(2, 3), 10)]]).draw() for _ in range(2))
    paths = [*save_figure(one, tmp_path / "figure"), *save_figure(other.axes[0], tmp_path / "axes")]
    png, svg, png_of_axes, svg_of_axes = (path.read_bytes() for path in paths)
    assert (png_of_axes, svg_of_axes) == (png, svg)


def test_the_same_figure_is_the_same_file(tmp_path: Path) -> None:
    """In two processes with different hash seeds: there is no date and no random name in it."""
    for name, seed in (("one", "1"), ("two", "2")):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "SOURCE_DATE_EPOCH": seed}
        subprocess.run([sys.executable, "-c", SAVE, str(tmp_path / f"{name}.pdf")], check=True, env=environment)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one.png", "one.svg", "two.png", "two.svg"]
    for ending in ("png", "svg"):
        digests = {hashlib.sha256((tmp_path / f"{name}.{ending}").read_bytes()).hexdigest() for name in ("one", "two")}
        assert len(digests) == 1
    assert (tmp_path / "one.png").read_bytes().startswith(b"\x89PNG")
    assert "<svg" in (tmp_path / "one.svg").read_text()
    with Image.open(tmp_path / "one.png") as picture:
        assert picture.size == (806, 464)  # 160 pixels for each of 5.04 and 2.9 inches

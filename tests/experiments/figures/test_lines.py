"""Lines over anything else than training steps."""

import numpy as np

from edugym.experiments.figures import Lines
from tests.experiments.figures.samples import heights, new_axes


def test_lines_and_theory() -> None:
    """Each method has a line, and theory has a dashed one."""
    x = np.arange(3.0)
    ax = Lines(x, {"A": x}, x_label="x", y_label="y", theory={"x²": x * x}).draw(new_axes())
    assert [(line.get_label(), heights(line)) for line in ax.lines] == [("A", [0, 1, 2]), ("x²", [0, 1, 4])]
    assert [line.get_linestyle() for line in ax.lines] == ["-", "--"]
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_yscale()) == ("x", "y", "linear")
    assert ax.get_legend() is not None


def test_the_scale_can_be_logarithmic() -> None:
    """For shares that shrink by powers."""
    x = np.arange(3.0)
    assert Lines(x, {"A": 0.5**x}, log=True).draw(new_axes()).get_yscale() == "log"

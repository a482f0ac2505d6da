"""What `report.txt` and `cells.txt` notice, and what they let pass."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from edugym.experiments.results.claims import Above, Claim
from edugym.experiments.results.statistics import Interval
from tests.course.lessons import records

LINE = "n = 1: 0.25 [0.1, 1e-05] of 20"


@pytest.mark.parametrize(
    ("now", "noticed"),
    [
        (LINE, False),
        ("n = 1: 0.2501 [0.1, 1e-05] of 20", False),
        ("n = 1: 0.25 [0.1, 1.001e-05] of 20", False),
        ("n = 1: 0.252 [0.1, 1e-05] of 20", True),
        ("n = 1: -0.25 [0.1, 1e-05] of 20", True),
        ("n = 1: 0.25 [0.1, 1e-05] of 21", True),
        ("n = 2: 0.25 [0.1, 1e-05] of 20", True),
        ("m = 1: 0.25 [0.1, 1e-05] of 20", True),
        (f"{LINE}\n{LINE}", True),
        ("", True),
    ],
)
def test_differences(now: str, noticed: bool) -> None:
    """Digits after the third may be others on another machine; whole numbers and words may not."""
    assert bool(records.differences(LINE, now)) == noticed
    assert bool(records.differences(f"{LINE}\n{LINE}\n", f"{LINE}\n{now}\n")) == noticed


def test_claims_and_figures_in_lines() -> None:
    """With their bounds, the claims that test a reason, and the ends and mean of what is drawn, without its colours."""
    claim = Claim("It learns", "return", Interval(1.5, 1.0, 2.0, 9), Above(0.5), "it must", ("Without, it does not",))
    control = Claim("Without, it does not", "return", Interval(0.0, 0.0, 0.0, 9), Above(-1.0), remark="as expected")
    assert [*records.claims([claim, control])] == [
        "1. It learns",
        "   return: 1.5 [1, 2] of 9",
        "   Above 0.5; reason; tested by 2",
        "2. Without, it does not",
        "   return: 0 [0, 0] of 9",
        "   Above -1; remark",
    ]
    ax = Figure().subplots()
    ax.plot([0, 1, 2, 3], [4, 5, 6, 9], color="red", label="ours")
    ax.plot([0, 1, 2, 3], [1, np.nan, 1, 1])
    ax.bar([0], [7], label="bars")
    ax.imshow([[0, 2]])
    ax.quiver([0, 1], [2, 2], [3, 3], [5, 5])
    ax.set(xticks=[], ylim=(-1, 10))
    assert [*records.axis(ax)] == ["x ticks at nothing", "y from -1 to 10"]
    assert [*records.drawn(ax)] == [
        "ours: 4 ... 9, 4 around 6, over 0 ... 3, 4 around 1.5",
        "line: 1 1 1",
        "bars: 7",
        "1 patches: -0.4 ... -0.4, 5 around -0.08; 0 ... 0, 5 around 2.8",
        "picture 1 x 2: 0 2",
        "1 shapes: 0 ... 3, 4 around 1.75; 2 ... 5, 4 around 3.5",
    ]

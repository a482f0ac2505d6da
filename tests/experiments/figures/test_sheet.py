"""Sheets: figures of several panels."""

import math
import os
import subprocess
import sys
from io import BytesIO
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot
from PIL import Image

from edugym import Results
from edugym.experiments.figures import Curves, Sheet, VisitMap, save_figure
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.sheet import in_pairs
from edugym.experiments.figures.style import PANEL_SIZE
from tests.experiments.figures.samples import made_results

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def two_rows() -> Sheet:
    """Return a row of curves above a row of maps."""
    visits = np.arange(6.0).reshape(2, 3)
    curves = Curves(made_results(), "left", optimum=1.0)
    maps = [VisitMap(visits, 10, "small"), VisitMap(10 * visits, 10, "large")]
    return Sheet("figure", [[curves, curves._replace(title="right")], maps])


def test_panels_are_in_their_places() -> None:
    """There is one legend, one label for each row, and one scale of colours."""
    drawn = two_rows().draw()
    panels = [ax for ax in drawn.axes if ax.get_title()]
    assert [ax.get_title() for ax in panels] == ["left", "right", "small", "large"]
    assert [ax.get_ylabel() for ax in panels] == ["return (greedy)", "", "state", ""]
    assert [text.get_text() for text in drawn.legends[0].get_texts()] == ["A", "B", "optimum"]
    assert all(ax.get_legend() is None for ax in panels)
    assert {ax.images[0].norm.vmax for ax in panels[2:]} == {50.0}
    assert len(drawn.axes) == 5  # one scale of colours
    before = dict(mpl.rcParams)
    width, height = Image.open(BytesIO(two_rows()._repr_png_())).size  # as a notebook shows it
    assert width > height > 300
    assert "left, right, small, large" in repr(two_rows())
    assert (dict(mpl.rcParams), pyplot.get_fignums()) == (before, [])  # nothing global changes


class Labelled(SimpleNamespace):
    """A panel with n labels."""

    title = "labelled"

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw lines without points."""
        assert ax is not None
        for k in range(self.n):
            ax.plot([], [], label=f"{9 - k}")
        ax.set(ylabel=getattr(self, "y_label", "y"), xlabel=f"last: {place.last}")
        return ax


@pytest.mark.parametrize(("columns", "labels", "in_a_row"), [(1, 0, 0), (1, 3, 2), (2, 3, 3), (3, 6, 5)])
def test_the_size_of_a_sheet(columns: int, labels: int, in_a_row: int) -> None:
    """It grows with its panels, and with the lines of its legend, in which a label takes two inches."""
    rows: Any = [[Labelled(n=labels) for _ in range(columns)]] * 2
    drawn: Any = Sheet("sheet", rows).draw()
    width, height = drawn.get_size_inches()
    assert width == pytest.approx(max(columns, 1.4) * PANEL_SIZE[0])
    assert height == pytest.approx(2 * PANEL_SIZE[1] + 0.25 * math.ceil(labels / in_a_row if in_a_row else 0))
    assert [legend._ncols for legend in drawn.legends] == [in_a_row] * bool(labels)
    assert [ax.get_xlabel() for ax in drawn.axes] == [f"last: {k == columns - 1}" for k in range(columns)] * 2
    assert not labels or [text.get_text() for text in drawn.legends[0].get_texts()] == [
        f"{9 - k}" for k in range(labels)
    ]


def test_a_label_of_the_y_axis_is_left_out_only_where_it_is_the_same() -> None:
    """As that of the first panel of its row. Where there is no panel, axes are empty."""
    a, b = (Labelled(n=0, y_label=label) for label in "ab")
    rows: Any = [[a, b, a], [a]]
    drawn = Sheet("sheet", rows).draw()
    assert [ax.get_ylabel() for ax in drawn.axes if ax.axison] == ["a", "b", "", "a"]
    assert [ax.axison for ax in drawn.axes] == [True] * 4 + [False] * 2
    assert in_pairs("name", [*rows[0], a, b]) == Sheet("name", [[a, b], [a, a], [b]])
    empty = Results(made_results().table.iloc[:0], {"A": {}})  # as after an interruption before the first run
    drawn = Sheet("figure", [[Curves(empty, "nothing")], []]).draw()
    assert [ax.axison for ax in drawn.axes] == [True, False]
    assert len(Sheet("figure", []).draw().axes) == 1


SAVE = """
import sys
import numpy as np
from edugym.experiments.figures import Sheet, VisitMap, save_figure

save_figure(Sheet("map", [[VisitMap(np.arange(6.0).reshape(2, 3), 10)]]).draw(), sys.argv[1])
"""


def test_the_same_figure_is_the_same_file(tmp_path: Path) -> None:
    """In another process too: there is no date and no random name in it. Axes stand for their figure."""
    map_of_six = Sheet("map", [[VisitMap(np.arange(6.0).reshape(2, 3), 10)]])
    for name in ("one", "two"):
        files = tmp_path / f"{name}.png", tmp_path / f"{name}.svg"
        assert save_figure(map_of_six.draw().axes[0], tmp_path / f"{name}.x") == files
    environment = {**os.environ, "PYTHONHASHSEED": "1", "SOURCE_DATE_EPOCH": "1"}
    subprocess.run([sys.executable, "-c", SAVE, str(tmp_path / "two.pdf")], check=True, env=environment)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one.png", "one.svg", "two.png", "two.svg"]
    for ending in ("png", "svg"):
        assert (tmp_path / f"one.{ending}").read_bytes() == (tmp_path / f"two.{ending}").read_bytes()
    with Image.open(tmp_path / "one.png") as picture:
        assert (picture.format, picture.size) == ("PNG", (806, 464))  # 160 pixels for each of 5.04 and 2.9 inches
    assert "<svg" in (tmp_path / "one.svg").read_text()

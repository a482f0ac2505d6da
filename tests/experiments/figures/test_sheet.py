"""Sheets: figures of several panels."""

from typing import TYPE_CHECKING, NamedTuple

import matplotlib as mpl
import numpy as np
from matplotlib import pyplot

from edugym import Results
from edugym.experiments.figures import Curves, Lines, Sheet, VisitMap
from edugym.experiments.figures.panel import ALONE, Place
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


def test_a_sheet_takes_any_panel() -> None:
    """A new kind of panel needs no change elsewhere."""

    class Dot(NamedTuple):
        title: str

        def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
            assert ax is not None
            ax.plot([1], [2], "o", label="dot")
            return ax

    drawn = Sheet("dots", [[Dot("one"), Dot("two")]]).draw()
    assert [len(ax.lines) for ax in drawn.axes] == [1, 1]
    assert [text.get_text() for text in drawn.legends[0].get_texts()] == ["dot"]


def test_the_legend_does_not_run_out_of_the_figure() -> None:
    """Many labels take several rows, also above a single panel."""
    x = np.arange(3.0)
    panel = Lines(x, {f"a method with a long name, {i}": x for i in range(7)}, "climbs")
    drawn = Sheet("figure", [[panel]]).draw()
    drawn.draw_without_rendering()
    box = drawn.legends[0].get_window_extent()
    assert box.x0 >= 0
    assert box.x1 <= drawn.bbox.x1


def test_empty_results_leave_empty_axes() -> None:
    """As after an interruption before the first run."""
    empty = Results(made_results().table.iloc[:0], {"A": {}})
    drawn = Sheet("figure", [[Curves(empty, "nothing")], []]).draw()
    assert [ax.axison for ax in drawn.axes] == [True, False]
    assert len(Sheet("figure", []).draw().axes) == 1


def test_a_sheet_shows_itself_in_a_notebook() -> None:
    """As a picture, and in few words elsewhere; nothing global changes."""
    before = dict(mpl.rcParams)
    assert two_rows()._repr_png_().startswith(b"\x89PNG")
    assert repr(two_rows()) == "<Sheet 'figure': left, right, small, large>"
    assert dict(mpl.rcParams) == before
    assert pyplot.get_fignums() == []

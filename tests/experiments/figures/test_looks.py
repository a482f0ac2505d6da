"""How panels look: what is said on them, in which colours, and what is left out."""

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_hex, to_rgba

from edugym.experiments.figures import Curves, Lines, Sheet, VisitMap
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.sheet import in_pairs
from edugym.experiments.figures.style import PANEL_SIZE, STROKES, stroke
from edugym.experiments.results.statistics import mean_interval
from edugym.rendering.palette import INK
from tests.experiments.figures.samples import figure_of, made_results, new_axes

X = np.arange(3.0)
LABELS: dict[str, Any] = {"title": "Title", "x_label": "x", "y_label": "y"}
THEORY = {label: X + k for k, label in enumerate(("one", "two", "three"))}
PANELS: dict[str, Callable[[], Any]] = {
    "curves": lambda: Curves(made_results(), "Title", optimum=1.0, soft_optimum=0.5, y_label="y"),
    "against": lambda: Against(
        [0.1, 0.2, 0.4], {m: [np.array([k, k + 1.0]) for k in X] for m in "AB"}, theory=THEORY, **LABELS
    ),
    "lines": lambda: Lines(X, {"A": X, "B": 2 * X}, theory=THEORY, **LABELS),
    "visits": lambda: VisitMap(np.ones((2, 3)), 10, "Title", "y"),
}


@pytest.mark.parametrize("name", PANELS)
def test_every_panel_is_dressed_alike(name: str) -> None:
    """Its title and labels in ink, a frame on two sides, and no legend on a sheet, which has one for all."""
    panel = PANELS[name]()
    ax = panel.draw(new_axes())
    assert (ax.get_title(), ax.get_ylabel()) == ("Title", "y")
    assert ax.get_xlabel() == ("x" if name in ("against", "lines") else "training steps")
    assert {part.get_color() for part in (ax.title, ax.xaxis.label, ax.yaxis.label)} == {INK}
    assert [ax.title.get_fontsize(), ax.xaxis.label.get_fontsize(), ax.yaxis.label.get_fontsize()] == [10, 9, 9]
    assert {side: spine.get_visible() for side, spine in ax.spines.items()} == {
        "left": True, "bottom": True, "top": False, "right": False,
    }  # fmt: skip
    assert (ax.get_legend() is not None) is (name != "visits")
    on_a_sheet = panel.draw(new_axes(), Place([panel], last=False))
    assert on_a_sheet.get_legend() is None
    assert len(on_a_sheet.figure.axes) == 1
    assert len(panel.draw(new_axes(), ALONE).figure.axes) == (2 if name == "visits" else 1)
    assert panel.draw().figure.get_size_inches().tolist() == [5.2, 3.6]


@pytest.mark.parametrize("name", ["curves", "against", "lines"])
def test_lines_of_methods_and_of_theory(name: str) -> None:
    """Methods in colours of their own, which their bands share; what they are compared with thin, behind, in ink."""
    ax = PANELS[name]().draw(new_axes())
    methods, theory = ax.lines[:2], ax.lines[2:]
    assert [line.get_label() for line in methods] == ["A", "B"]
    assert [line.get_color() for line in methods] == [STROKES[0].color, STROKES[1].color]
    assert [line.get_linestyle() for line in methods] == ["-", "--"]
    assert {line.get_linewidth() for line in methods} == {1.6}
    assert {(line.get_color(), line.get_linewidth(), line.get_zorder()) for line in theory} == {(INK, 0.9, 1)}
    if name != "lines":
        assert [to_hex(band.get_facecolor()[0]) for band in ax.collections] == [one.color for one in STROKES[:2]]
        assert {band.get_alpha() for band in ax.collections} == {0.16}
        assert {float(band.get_linewidth()[0]) for band in ax.collections} == {0.0}
        dashes = [line._dash_pattern[1] for line in theory]  # in widths of the line
        assert dashes[0] == pytest.approx([4.5, 2.7])
        assert dashes[1] == pytest.approx([1.35, 1.8])
        assert dashes[2:] == dashes[:1] * (len(dashes) - 2)


def test_strokes_begin_again() -> None:
    """After the last one; the colours are those of Okabe and Ito, and neighbours have other dashes."""
    assert [stroke(k) for k in range(-1, 9)] == [STROKES[-1], *STROKES, *STROKES[:2]]
    assert [one.color for one in STROKES] == [
        "#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#4d4d4d",
    ]  # fmt: skip
    assert all(str(one.linestyle) != str(other.linestyle) for one, other in pairwise(STROKES))
    dashes: Any = [one.linestyle[1] for one in STROKES if one.linestyle != "solid"]
    assert dashes == [(6, 1.5), (2, 1), (6, 1.5, 1.5, 1.5), (6, 1.5), (2, 1)]


def test_the_bands_of_a_parameter() -> None:
    """Student's intervals of each row, at its place."""
    ax = PANELS["against"]().draw(new_axes())
    (band, _) = ax.collections
    assert isinstance(band, PolyCollection)
    corners = {(round(float(x), 6), round(float(y), 6)) for x, y in np.asarray(band.get_paths()[0].vertices)}
    for x, value in zip((0.1, 0.2, 0.4), X, strict=True):
        interval = mean_interval([value, value + 1])
        assert {(x, round(interval.low, 6)), (x, round(interval.high, 6))} <= corners
    assert [line.get_marker() for line in ax.lines] == ["o", "o", "None", "None", "None"]
    assert (ax.lines[0].get_xdata() == [0.1, 0.2, 0.4]).all()


def test_scales() -> None:
    """A logarithmic axis has ticks at the places only; the steps of curves begin at 0 and end with the training."""
    ax = PANELS["against"]()._replace(log=True).draw(new_axes())
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "linear")
    assert ax.get_xticks().tolist() == [0.1, 0.2, 0.4]
    assert ax.get_xticks(minor=True).tolist() == []
    assert len(PANELS["against"]().draw(new_axes()).get_xticks()) <= 7
    curves = PANELS["curves"]().draw(new_axes())
    assert curves.get_xlim() == (0, 300)
    assert curves.xaxis.get_major_formatter()(1_234_567, 0) == "1\N{NO-BREAK SPACE}234\N{NO-BREAK SPACE}567"
    assert len(curves.xaxis.get_major_locator().tick_values(0, 300)) <= 6
    assert (PANELS["lines"]().draw(new_axes()).get_xscale(), PANELS["lines"]().draw(new_axes()).get_yscale()) == (
        "linear",
    ) * 2


def test_maps_are_dark_where_visits_are_many() -> None:
    """On a logarithmic scale, and white where nobody was."""
    image: Any = VisitMap(np.array([[1.0, 10.0, 100.0, 0.0]]), 10).draw(new_axes()).images[0]
    image.figure.draw_without_rendering()
    colours = image.to_rgba(image.get_array())[:, 0]
    light = colours[:, :3].sum(axis=1)
    assert light[0] > light[1] > light[2]
    assert colours[3][3] == 0.0  # transparent
    assert image.norm(10.0) == pytest.approx(0.5)
    assert image.get_interpolation() == "nearest"
    nothing = VisitMap(np.zeros((2, 2)), 10).draw(new_axes()).images[0].norm
    assert (nothing.vmin, nothing.vmax) == (0.1, 1.0)
    assert VisitMap([[3]], 10).draw(new_axes()).get_ylabel() == "state"


def test_curves_show_what_was_asked_for() -> None:
    """The column, the methods in their order, and no share of what is smoothed."""
    results = made_results()
    ax = Curves(results, column="episodes", methods=["B", "A"]).draw(new_axes())
    assert ax.get_ylabel() == "episodes ended"
    assert [(line.get_label(), line.get_color()) for line in ax.lines] == [
        ("B", STROKES[0].color),
        ("A", STROKES[1].color),
    ]
    shared = Curves(results, column="training_return", share=True, methods=["A"])
    results.table["training_return"] = results.table["return"]
    assert shared.draw(new_axes()).get_ylabel() == "return (while exploring)"
    smooth = Curves(results, methods=["A"], share=True, smooth=2)
    assert smooth.draw(new_axes()).lines[0].get_ydata().tolist() == [0, 0.125, 0.375, 0.625]  # type: ignore[union-attr]
    assert Curves(results, y_label="").draw(new_axes()).get_ylabel() == ""


class Labelled:
    """A panel with some labels."""

    title = "labelled"

    def __init__(self, n: int, y_label: str = "y") -> None:
        """With so many labels."""
        self.n, self.y_label = n, y_label

    def draw(self, ax: Axes | None = None, place: Place = ALONE) -> Axes:
        """Draw lines without points."""
        assert ax is not None
        for k in range(self.n):
            ax.plot([], [], label=f"{9 - k}", color=stroke(k).color)
        ax.set(ylabel=self.y_label, xlabel=f"last: {place.last}")
        return ax


@pytest.mark.parametrize(
    ("columns", "labels", "width", "height", "in_a_row"),
    [(1, 0, 1.4, 0.0, 0), (1, 2, 1.4, 0.25, 2), (1, 3, 1.4, 0.5, 2), (2, 3, 2.0, 0.25, 3), (3, 6, 3.0, 0.5, 5)],
)
def test_the_size_of_a_sheet(columns: int, labels: int, width: float, height: float, in_a_row: int) -> None:
    """Each panel has its place, and each line of the legend a quarter of an inch; a label takes two inches."""
    drawn: Any = Sheet("sheet", [[Labelled(labels) for _ in range(columns)]] * 2).draw()
    assert drawn.get_size_inches() == pytest.approx([width * PANEL_SIZE[0], 2 * PANEL_SIZE[1] + height])
    assert [legend._ncols for legend in drawn.legends] == [in_a_row] * bool(labels)
    assert [ax.get_xlabel() for ax in drawn.axes] == [f"last: {k == columns - 1}" for k in range(columns)] * 2
    if labels:
        handles = drawn.legends[0].get_lines()
        assert [to_rgba(line.get_color()) for line in handles] == [to_rgba(stroke(k).color) for k in range(labels)]
        assert [text.get_text() for text in drawn.legends[0].get_texts()] == [f"{9 - k}" for k in range(labels)]
        assert not drawn.legends[0].get_frame_on()


def test_a_label_of_the_y_axis_is_left_out_only_where_it_is_the_same() -> None:
    """As that of the first panel of its row."""
    drawn = Sheet("sheet", [[Labelled(0, "a"), Labelled(0, "b"), Labelled(0, "a")], [Labelled(0, "a")]]).draw()
    assert [ax.get_ylabel() for ax in drawn.axes if ax.axison] == ["a", "b", "", "a"]
    assert [ax.axison for ax in drawn.axes] == [True] * 4 + [False] * 2


def test_panels_in_pairs() -> None:
    """Two in a row, the last one by itself if their number is odd."""
    panels = [Labelled(k) for k in range(5)]
    assert in_pairs("name", panels) == Sheet("name", [panels[:2], panels[2:4], panels[4:]])
    assert figure_of(in_pairs("name", panels[:1]).draw().axes[0]).get_size_inches()[0] == pytest.approx(1.4 * 3.6)

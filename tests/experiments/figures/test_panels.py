"""What all panels share, lines over anything else than training steps, and maps of visits."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_hex

from edugym.experiments.figures import Curves, Lines, VisitMap
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.panel import Place, With
from edugym.experiments.figures.style import REFERENCE, SOFT_REFERENCE, STROKES, Stroke, stroke
from edugym.rendering.palette import INK
from tests.experiments.figures.samples import figure_of, heights, made_results, new_axes

X = np.arange(3.0)
LABELS: dict[str, Any] = {"title": "Title", "x_label": "x", "y_label": "y"}
THEORY = {label: X + k for k, label in enumerate(("one", "two", "three"))}
ROWS = {"A": [np.array([k, k + 1.0]) for k in X], "B": [np.array([3.0, 3.0]) for _ in X]}
PANELS: dict[str, Callable[[], Any]] = {
    "curves": lambda: Curves(made_results(2), "Title", optimum=1.0, soft_optimum=0.5, y_label="y"),
    "against": lambda: Against([0.1, 0.2, 0.4], ROWS, theory=THEORY, **LABELS),
    "lines": lambda: Lines(X, {"A": X, "B": 2 * X}, theory=THEORY, **LABELS),
    "visits": lambda: VisitMap(np.ones((2, 3)), 10, "Title", "y"),
    "with more": lambda: With(Lines(X, {"A": X}, **LABELS), lambda ax: ax.axhline(1.0, label="more")),
}


@pytest.mark.parametrize("name", PANELS)
def test_every_panel_is_dressed_alike(name: str) -> None:
    """Its title and labels, a frame on two sides, and no legend on a sheet, which has one for all."""
    panel = PANELS[name]()
    ax = panel.draw()
    assert (ax.get_title(), ax.get_ylabel()) == ("Title", "y")
    assert ax.get_xlabel() == ("x" if name in ("against", "lines", "with more") else "training steps")
    assert {part.get_color() for part in (ax.title, ax.xaxis.label, ax.yaxis.label)} == {INK}
    assert {side for side, spine in ax.spines.items() if spine.get_visible()} == {"left", "bottom"}
    shown = {text.get_text() for text in ax.get_legend().get_texts()} if name != "visits" else set()
    assert shown == {line.get_label() for line in ax.lines}
    assert len(ax.figure.axes) == (2 if name == "visits" else 1)
    on_a_sheet = panel.draw(new_axes(), Place([panel], last=False))
    assert on_a_sheet.get_legend() is None
    assert len(on_a_sheet.figure.axes) == 1


@pytest.mark.parametrize("name", ["curves", "against", "lines"])
def test_lines_of_methods_and_of_theory(name: str) -> None:
    """Methods in strokes of their own, with a band each; what they are compared with behind, in two looks."""
    ax = PANELS[name]().draw(new_axes())
    methods, theory = ax.lines[:2], ax.lines[2:]
    assert [line.get_label() for line in methods] == ["A", "B"]
    assert [line.get_color() for line in methods] == [one.color for one in STROKES[:2]]
    labels = ["optimum", "best ε-soft policy"] if name == "curves" else [*THEORY]
    assert [line.get_label() for line in theory] == labels
    assert {line.get_color() for line in theory} == {INK}
    assert max(line.get_zorder() for line in theory) < min(line.get_zorder() for line in methods)
    assert [len(ax.collections)] == [0 if name == "lines" else 2]
    dashes = [line._dash_pattern[1] for line in theory]
    assert name == "lines" or dashes[0] != dashes[1]
    assert name != "against" or dashes[2] == dashes[0]
    assert len({one.color for one in STROKES}) == len(STROKES)
    assert [stroke(k) for k in range(9)] == [*STROKES, *STROKES[:2]]  # after the last one the first comes again
    assert {key for key in REFERENCE if REFERENCE[key] != SOFT_REFERENCE[key]} == {"linestyle"}


@pytest.mark.parametrize("kind", [Curves, Lines, Against])
def test_strokes_that_are_chosen(kind: Any) -> None:
    """By the label of the method, with the band in the same colour; the others have that of their place."""
    own = Stroke("#123456", "solid")
    data: dict[Any, dict[str, Any]] = {
        Curves: {"results": made_results(2)},
        Lines: {"x": X, "lines": {"A": X, "B": X}},
        Against: {"x": X, "measured": {"A": [X, X, X], "B": [X, X, X]}},
    }
    ax = kind(**data[kind], strokes={"A": own, "unknown": own}).draw(new_axes())
    assert [line.get_color() for line in ax.lines] == [own.color, stroke(1).color]
    bands = [to_hex(band.get_facecolor()[0]) for band in ax.collections]
    assert bands == ([] if kind is Lines else [own.color, stroke(1).color])


def test_steps_are_labelled_by_a_few_round_numbers() -> None:
    """With a space between thousands."""
    axis: Any = PANELS["curves"]().draw(new_axes()).xaxis
    assert axis.get_major_formatter()(1_234_567, 0) == "1\N{NO-BREAK SPACE}234\N{NO-BREAK SPACE}567"
    for last, ticks in ((300, [0, 100, 200, 300]), (1, [0, 1])):
        assert axis.get_major_locator().tick_values(0, last).tolist() == ticks


def test_maps_show_states_upwards() -> None:
    """Time runs to the right; the more visits the darker, on a logarithmic scale, which is beside the map."""
    visits = np.array([[4.0, 1.0, 0.0], [2.0, 2.0, 1.0]])
    ax = VisitMap(visits, 1_000, y_label="height").draw(new_axes())
    image: Any = ax.images[0]
    assert (image.origin, [*image.get_extent()]) == ("lower", [0, 1_000, -0.5, 2.5])
    shown = image.get_array()
    assert shown.filled(0).tolist() == visits.T.tolist()
    assert shown.mask.tolist() == [[False, False], [False, False], [True, False]]
    assert (image.norm.vmin, image.norm.vmax) == (0.4, 4)
    light = image.to_rgba(shown)[..., :3].sum(axis=-1)
    assert light[1, 0] > light[0, 1] > light[0, 0]
    assert (ax.get_ylabel(), figure_of(ax).axes[1].get_ylabel()) == ("height", "visits in 500 steps")
    nothing = VisitMap(np.zeros((2, 2)), 10).draw(new_axes()).images[0].norm
    assert (nothing.vmin, nothing.vmax) == (0.1, 1.0)
    for wrong in (np.ones(3), -np.ones((2, 2)), np.full((2, 2), np.nan)):
        with pytest.raises(ValueError, match=r"visits .*\(n_intervals, n_states\)"):
            VisitMap(wrong, 10).draw(new_axes())


def test_maps_on_a_sheet_share_a_scale() -> None:
    """The same number has the same colour, and only the last map of a row has the scale beside it."""
    maps = [VisitMap(np.full((2, 3), number), 10) for number in (1, 50)]
    ax = maps[0].draw(new_axes(), Place(maps, last=False))
    assert (ax.images[0].norm.vmin, ax.images[0].norm.vmax) == (0.005, 50)
    assert len(ax.figure.axes) == 1
    only = VisitMap(np.array([[2.0, 50.0]]), 10)
    norm: Any = only.draw(new_axes(), Place([Lines(np.ones(1), {}), only])).images[0].norm
    assert (norm.vmin, norm.vmax) == (2, 50)  # beside other panels it shows all that it has


def test_values_and_scales() -> None:
    """Means against a parameter, or values as given; on a logarithmic axis of parameters a tick at each place."""
    for name, heights_of in (("against", [[0.5, 1.5, 2.5], [3, 3, 3]]), ("lines", [[0, 1, 2], [0, 2, 4]])):
        ax = PANELS[name]().draw(new_axes())
        assert [heights(line) for line in ax.lines[:3]] == [*heights_of, [0, 1, 2]]
        assert (ax.get_xscale(), ax.get_yscale()) == ("linear", "linear")
        assert ax.get_xticks().tolist() != [0.1, 0.2, 0.4]
    assert Lines(X, {"A": 0.5**X}, log=True).draw(new_axes()).get_yscale() == "log"
    ax = Against([0.003, 0.01, 1.0], ROWS, log=True).draw(new_axes())
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "linear")
    assert [label.get_text() for label in ax.get_xticklabels()] == ["0.003", "0.01", "1"]
    assert ax.get_xticks(minor=True).tolist() == []

"""Figures: what they show is what was measured, and the same figure is the same file."""

import hashlib
import os
import subprocess
import sys
from functools import partial
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from matplotlib.lines import Line2D

from edugym import QLearning, Results, repeat
from edugym.lessons import report as lessons
from edugym.plotting import draw, learning_curves, lines, save_figure, visitation_map
from edugym.plotting.style import STROKES
from edugym.results.statistics import mean_interval, proportion_interval

mpl.use("agg")


def results(repetitions: int = 4) -> Results:
    """Two methods with returns made by hand: 0 or 1 of "A", and numbers of "B"."""
    agents = {label: partial(QLearning.create) for label in "AB"}
    table = repeat("Boulder", agents, 300, repetitions=repetitions, evaluate_every=100, jobs=1).table
    ones = (table["repetition"] * 100 < table["step"]).astype(float)
    table["return"] = ones.where(table["method"] == "A", 10.0 + table["repetition"] + table["step"] / 100)
    return Results(table)


@pytest.fixture
def ax() -> Axes:
    """Axes in memory."""
    return Canvas().subplots()


def canvas(ax: Axes) -> Canvas:
    """The figure that the axes are in."""
    figure = ax.figure
    assert isinstance(figure, Canvas)
    return figure


def points(line: Line2D) -> list[tuple[float, float]]:
    """Where a line goes."""
    return [(float(x), float(y)) for x, y in np.asarray(line.get_xydata(), float)]


def heights(line: Line2D) -> list[float]:
    """How high a line is at each of its points."""
    return [y for _, y in points(line)]


def band(ax: Axes, i: int) -> tuple[list[float], list[float]]:
    """The lower and upper edge of the i-th band, at each step."""
    vertices = ax.collections[i].get_paths()[0].vertices
    assert isinstance(vertices, np.ndarray)
    steps = sorted({x for x, _ in vertices})
    edges = [[y for x, y in vertices if x == step] for step in steps]
    return [min(y) for y in edges], [max(y) for y in edges]


def test_curves_are_means_with_intervals(ax: Axes) -> None:
    """The line is the mean over repetitions, and the band Student's interval."""
    learning_curves(results(), ax)
    line = ax.lines[1]
    expected = [mean_interval([10, 11, 12, 13]), mean_interval([13, 14, 15, 16])]
    assert line.get_label() == "B"
    assert [step for step, _ in points(line)] == [0, 100, 200, 300]
    assert heights(line)[0::3] == [interval.estimate for interval in expected]
    low, high = band(ax, 1)
    assert low[0::3] == pytest.approx([interval.low for interval in expected])
    assert high[0::3] == pytest.approx([interval.high for interval in expected])


def test_shares_have_wilsons_band(ax: Axes) -> None:
    """Where nobody has succeeded yet there is doubt all the same."""
    learning_curves(results(), ax, methods=["A"], share=True)
    assert heights(ax.lines[0]) == [0, 0.25, 0.5, 0.75]
    low, high = band(ax, 0)
    assert low == pytest.approx([proportion_interval(k, 4).low for k in range(4)])
    assert high == pytest.approx([proportion_interval(k, 4).high for k in range(4)])


def test_a_single_run_has_no_band(ax: Axes) -> None:
    """One repetition says nothing about others."""
    learning_curves(results(repetitions=1), ax)
    assert not np.isnan(heights(ax.lines[0])).any()
    assert all(len(collection.get_paths()) == 0 for collection in ax.collections)


def test_smoothing_looks_back(ax: Axes) -> None:
    """Each point averages itself and what came before it."""
    learning_curves(results(), ax, methods=["B"], smooth=3)
    assert heights(ax.lines[0]) == [11.5, 12.0, 12.5, 13.5]
    with pytest.raises(ValueError, match="smooth must be 1 or more, but is 0"):
        learning_curves(results(), ax, smooth=0)


def test_optima_are_dashed_lines(ax: Axes) -> None:
    """Both, with their names in the legend."""
    learning_curves(results(), ax, optimum=20.0, soft_optimum=18.0, optimum_label="best")
    dashed = {line.get_label(): heights(line)[0] for line in ax.lines[2:]}
    assert dashed == {"best": 20.0, "best ε-soft policy": 18.0}
    assert all(line.get_linestyle() != "-" for line in ax.lines[2:])
    legend = ax.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["A", "B", "best", "best ε-soft policy"]


def test_axes_are_labelled(ax: Axes) -> None:
    """By what is drawn, unless told otherwise."""
    learning_curves(results(), ax)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("training steps", "return (greedy)")
    learning_curves(results(), ax, column="training_return", y_label="reward", title="On-line", legend=False)
    assert (ax.get_ylabel(), ax.get_title()) == ("reward", "On-line")
    canvas(ax).draw_without_rendering()
    assert "100" in [label.get_text() for label in ax.get_xticklabels()]


def test_methods_keep_their_strokes(ax: Axes) -> None:
    """By their place in the order, which a selection can keep."""
    learning_curves(results(), ax)
    assert [line.get_color() for line in ax.lines] == [STROKES[0].color, STROKES[1].color]
    assert len({stroke.color for stroke in STROKES}) == len(STROKES)


def test_unknown_names_are_refused(ax: Axes) -> None:
    """Methods and columns."""
    with pytest.raises(ValueError, match="method must be one of 'A', 'B', but is 'C'"):
        learning_curves(results(), ax, methods=["C"])
    with pytest.raises(ValueError, match="column must be one of"):
        learning_curves(results(), ax, column="seed")


def test_nothing_global_changes(ax: Axes, tmp_path: Path) -> None:
    """Neither the settings of Matplotlib nor its open figures."""
    before = dict(mpl.rcParams)
    learning_curves(results(), ax)
    visitation_map(np.ones((2, 3)), 10, ax)
    save_figure(draw(described()), tmp_path / "figure")
    assert dict(mpl.rcParams) == before
    assert pyplot.get_fignums() == []


def test_without_axes_there_is_a_new_figure() -> None:
    """As everywhere in Matplotlib."""
    ax = learning_curves(results())
    assert pyplot.get_fignums() == [canvas(ax).number]
    pyplot.close("all")


def test_maps_show_states_upwards(ax: Axes) -> None:
    """Time to the right, states upwards, and what was never visited blank."""
    visits = np.array([[4.0, 1.0, 0.0], [2.0, 2.0, 1.0]])
    visitation_map(visits, 1_000, ax, y_label="height")
    image = ax.images[0]
    shown = image.get_array()
    assert isinstance(shown, np.ma.MaskedArray)
    assert image.origin == "lower"
    assert (image.norm.vmin, image.norm.vmax) == (0.4, 4)
    assert shown.filled(0).tolist() == visits.T.tolist()
    assert shown.mask.tolist() == [[False, False], [False, False], [True, False]]
    assert list(image.get_extent()) == [0, 1_000, -0.5, 2.5]
    assert ax.get_ylabel() == "height"
    assert len(ax.figure.axes) == 2  # with the scale of the colours


def test_maps_can_share_a_scale(ax: Axes) -> None:
    """The same number has the same colour in two maps."""
    visitation_map(np.ones((2, 3)), 10, ax, largest=50, colour_bar=False)
    assert ax.images[0].norm.vmax == 50
    assert len(ax.figure.axes) == 1


@pytest.mark.parametrize("visits", [np.ones(3), -np.ones((2, 2))])
def test_other_arrays_are_no_visits(visits: Any, ax: Axes) -> None:
    """The shape is named."""
    with pytest.raises(ValueError, match=r"visits must have shape \(n_intervals, n_states\)"):
        visitation_map(visits, 10, ax)


def test_lines_and_theory(ax: Axes) -> None:
    """A line a method, and dashes for what theory says."""
    x = np.arange(3.0)
    lines(x, {"A": x}, ax, theory={"x²": x * x}, x_label="x", y_label="y")
    assert [(line.get_label(), heights(line)) for line in ax.lines] == [("A", [0, 1, 2]), ("x²", [0, 1, 4])]
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x", "y")


def described() -> lessons.Figure:
    """Two rows of each kind of panel."""
    visits = np.arange(6.0).reshape(2, 3)
    curves = lessons.Curves("left", results(), optimum=1.0)
    row = [lessons.VisitMap("small", visits, 10), lessons.VisitMap("large", 10 * visits, 10)]
    return lessons.Figure("figure", [[curves, curves], row])


def test_descriptions_are_drawn() -> None:
    """Each panel in its place, with one legend, one label a row and one scale of colours."""
    drawn = draw(described())
    panels = [ax for ax in drawn.axes if ax.get_title()]
    assert [ax.get_title() for ax in panels] == ["left", "left", "small", "large"]
    assert [ax.get_ylabel() for ax in panels] == ["return", "", "state", ""]
    assert [text.get_text() for text in drawn.legends[0].get_texts()] == ["A", "B", "optimum"]
    assert {ax.images[0].norm.vmax for ax in panels[2:]} == {50.0}
    assert len(drawn.axes) == 5  # one bar of colours


def test_a_single_panel_has_its_own_legend() -> None:
    """And a theory beside its lines."""
    x = np.arange(3.0)
    panel = lessons.Lines("climbs", x, {"A": x}, "height", "share", {"theory": x})
    drawn = draw(lessons.Figure("figure", [[panel]]))
    assert drawn.axes[0].get_legend() is not None
    assert drawn.legends == []


def test_nothing_to_draw_is_drawn() -> None:
    """Of an experiment that was interrupted at once, empty axes are left."""
    empty = Results(results().table.iloc[:0], {"A": {}})
    assert len(draw(lessons.Figure("figure", [[lessons.Curves("nothing", empty)], []])).axes) == 2


SAVE = """
import sys
import numpy as np
from matplotlib.figure import Figure
from edugym.plotting import save_figure, visitation_map

figure = Figure()
visitation_map(np.arange(6.0).reshape(2, 3), 10, figure.subplots())
save_figure(figure, sys.argv[1])
"""


def test_the_same_figure_is_the_same_file(tmp_path: Path) -> None:
    """In two processes, with different hash seeds: no date, no random names."""
    for name, seed in (("one", "1"), ("two", "2")):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "SOURCE_DATE_EPOCH": seed}
        subprocess.run([sys.executable, "-c", SAVE, str(tmp_path / f"{name}.pdf")], check=True, env=environment)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one.png", "one.svg", "two.png", "two.svg"]
    for ending in ("png", "svg"):
        digests = {hashlib.sha256((tmp_path / f"{name}.{ending}").read_bytes()).hexdigest() for name in ("one", "two")}
        assert len(digests) == 1
    assert (tmp_path / "one.png").read_bytes().startswith(b"\x89PNG")
    assert "<svg" in (tmp_path / "one.svg").read_text()

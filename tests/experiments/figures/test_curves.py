"""Learning curves: the drawing shows the data."""

import numpy as np
import pytest
from matplotlib import pyplot
from matplotlib.axes import Axes

from edugym import Results
from edugym.experiments.figures import Curves
from edugym.experiments.figures.curves import LABELS, SHARE_LABEL
from edugym.experiments.results.statistics import mean_interval, proportion_interval
from tests.experiments.figures.samples import figure_of, heights, made_results, new_axes
from tests.messages import named


def band(ax: Axes, i: int) -> tuple[list[float], list[float]]:
    """The lower and upper edge of the i-th band at each step."""
    vertices = ax.collections[i].get_paths()[0].vertices
    assert isinstance(vertices, np.ndarray)
    steps = sorted({x for x, _ in vertices})
    edges = [[y for x, y in vertices if x == step] for step in steps]
    return [min(y) for y in edges], [max(y) for y in edges]


def test_curves_are_means_with_intervals() -> None:
    """The line is the mean over repetitions, and the band is Student's interval."""
    ax = Curves(made_results()).draw(new_axes())
    line = ax.lines[1]
    expected = [mean_interval([10, 11, 12, 13]), mean_interval([13, 14, 15, 16])]
    assert line.get_label() == "B"
    assert np.asarray(line.get_xdata()).tolist() == [0, 100, 200, 300]
    assert heights(line)[0::3] == [interval.estimate for interval in expected]
    low, high = band(ax, 1)
    assert low[0::3] == pytest.approx([interval.low for interval in expected])
    assert high[0::3] == pytest.approx([interval.high for interval in expected])


def test_shares_have_wilsons_band() -> None:
    """The band does not shrink to nothing where no run has succeeded yet."""
    ax = Curves(made_results(), methods=["A"], share=True).draw(new_axes())
    assert heights(ax.lines[0]) == [0, 0.25, 0.5, 0.75]
    low, high = band(ax, 0)
    assert low == pytest.approx([proportion_interval(k, 4).low for k in range(4)])
    assert high == pytest.approx([proportion_interval(k, 4).high for k in range(4)])


def test_smoothing() -> None:
    """A point averages itself and those before it, but for what is missing; by episodes (3 · 1 + 5) / 4 is 2."""
    table = made_results(repetitions=1).table
    table["return"] = table["step"].map({0: 3.0, 100: np.nan, 200: np.nan, 300: 5.0})
    table["training_return"] = table["step"].map({0: np.nan, 100: 1.0, 200: np.nan, 300: 5.0})
    table["episodes"] = table["step"].map({0: 0, 100: 3, 200: 0, 300: 1})
    curves = Curves(Results(table), methods=["A"], smooth=2)
    assert curves.points("A")[1][:, 0].tolist() == pytest.approx([3.0, 3.0, np.nan, 5.0], nan_ok=True)
    assert heights(Curves(made_results(), methods=["B"], smooth=3).draw(new_axes()).lines[0]) == [11.5, 12, 12.5, 13.5]
    ax = curves._replace(column="training_return", smooth=4).draw(new_axes())
    assert heights(ax.lines[0])[1:] == [1.0, 1.0, 2.0]
    assert len(ax.collections[0].get_paths()) == 0  # one repetition says nothing about others: it has no band


def test_optima_are_lines_to_compare_with() -> None:
    """Zero is a best value like any other."""
    for best in (20.0, 0.0):
        ax = Curves(made_results(2), optimum=best, soft_optimum=best, soft_label="soft").draw(new_axes())
        assert {line.get_label(): heights(line) for line in ax.lines[2:]} == {"optimum": [best] * 2, "soft": [best] * 2}


def test_curves_show_what_was_asked_for() -> None:
    """The column, the methods in their order, the labels, and a part of the y axis."""
    results = made_results(2)
    default = Curves(results, "Title")
    ax = default.draw(new_axes())
    assert (ax.get_title(), ax.get_xlabel(), ax.get_xlim()) == ("Title", "training steps", (0, 300))
    labels = {default._replace(column=column).draw(new_axes()).get_ylabel() for column in LABELS}
    assert labels == set(LABELS.values())
    share = Curves(results, methods=["A"], share=True)
    assert share.draw(new_axes()).get_ylabel() == SHARE_LABEL
    results.table["training_return"] = results.table["return"]
    assert share._replace(column="training_return").draw(new_axes()).get_ylabel() == LABELS["training_return"]
    other = default._replace(column="episodes", methods=["B", "A"], y_label="", y_range=(-4.0, 1.5)).draw(new_axes())
    assert (other.get_ylabel(), other.get_ylim()) == ("", (-4.0, 1.5))
    assert [line.get_label() for line in other.lines] == ["B", "A"]
    smooth = Curves(results, methods=["A"], share=True, smooth=2)  # what is smoothed is no share
    assert heights(smooth.draw(new_axes()).lines[0])[:3] == [0, 0.25, 0.75]


def test_unknown_names_are_refused() -> None:
    """Of methods and of columns."""
    with pytest.raises(ValueError, match=r"methods .*'A', 'B'.*'C'"):
        Curves(made_results(), methods=["C"]).draw(new_axes())
    with pytest.raises(ValueError, match=r"column .*'seed'"):
        Curves(made_results(), column="seed").draw(new_axes())
    with pytest.raises(ValueError, match=named("smooth", 1, 1_000_000, 0)):
        Curves(made_results(), smooth=0).draw(new_axes())
    with pytest.raises(ValueError, match=r"results .*'results.csv'$"):
        Curves("results.csv").draw(new_axes())  # type: ignore[arg-type]


def test_without_axes_there_is_a_new_figure() -> None:
    """As everywhere in Matplotlib."""
    figure = figure_of(Curves(made_results()).draw())
    assert [figure.number] == pyplot.get_fignums()

"""Learning curves: the drawing shows the data."""

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot
from matplotlib.axes import Axes

from edugym import Results
from edugym.experiments.figures import Curves
from edugym.experiments.figures.style import STROKES
from edugym.experiments.results.statistics import mean_interval, proportion_interval
from tests.experiments.figures.samples import figure_of, heights, made_results, new_axes, points


def band(ax: Axes, i: int) -> tuple[list[float], list[float]]:
    """Return the lower and upper edge of the i-th band at each step."""
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
    assert [step for step, _ in points(line)] == [0, 100, 200, 300]
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


def test_a_single_run_has_no_band() -> None:
    """One repetition says nothing about others."""
    ax = Curves(made_results(repetitions=1)).draw(new_axes())
    assert not np.isnan(heights(ax.lines[0])).any()
    assert all(len(collection.get_paths()) == 0 for collection in ax.collections)


def test_smoothing_looks_back() -> None:
    """Each point averages itself and the points before it."""
    assert heights(Curves(made_results(), methods=["B"], smooth=3).draw(new_axes()).lines[0]) == [11.5, 12, 12.5, 13.5]
    with pytest.raises(ValueError, match="smooth must be 1 or more, but is 0"):
        Curves(made_results(), smooth=0).draw(new_axes())


def test_smoothed_training_returns_weigh_episodes() -> None:
    """Three episodes with return 1 and one with return 5 average to 2; a point without an episode changes nothing."""
    table = made_results(repetitions=1).table
    table["training_return"] = table["step"].map({0: np.nan, 100: 1.0, 200: np.nan, 300: 5.0})
    table["episodes"] = table["step"].map({0: 0, 100: 3, 200: 0, 300: 1})
    curves = Curves(Results(table), column="training_return", methods=["A"], smooth=4)
    assert heights(curves.draw(new_axes()).lines[0])[1:] == [1.0, 1.0, 2.0]


def test_smoothing_leaves_out_what_is_missing() -> None:
    """A return that was not measured is no return of 0."""
    table = made_results(repetitions=1).table
    table["return"] = table["step"].map({0: 3.0, 100: np.nan, 200: np.nan, 300: 5.0})
    curves = Curves(Results(table), methods=["A"], smooth=2).points("A")
    assert curves[0].tolist() == pytest.approx([3.0, 3.0, np.nan, 5.0], nan_ok=True)


def test_the_soft_optimum_by_another_name() -> None:
    """Where "ε-soft" is not explained yet."""
    ax = Curves(made_results(), soft_optimum=18.0, soft_label="best that slips").draw(new_axes())
    assert ax.lines[-1].get_label() == "best that slips"


def test_optima_are_dashed_lines() -> None:
    """Both are in the legend, whose ground hides lines that would run through its text."""
    ax = Curves(made_results(), optimum=20.0, soft_optimum=18.0).draw(new_axes())
    assert {line.get_label(): heights(line)[0] for line in ax.lines[2:]} == {"optimum": 20, "best ε-soft policy": 18}
    assert all(line.get_linestyle() != "-" for line in ax.lines[2:])
    legend = ax.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["A", "B", "optimum", "best ε-soft policy"]
    assert legend.get_frame().get_alpha() == 1.0
    assert legend.get_frame_on()


def test_optima_of_zero_are_drawn() -> None:
    """Zero is a best value like any other."""
    ax = Curves(made_results(), optimum=0.0, soft_optimum=0.0, y_label="").draw(new_axes())
    assert [line.get_label() for line in ax.lines[2:]] == ["optimum", "best ε-soft policy"]
    assert ax.get_ylabel() == ""


def test_labels_describe_the_column() -> None:
    """A share is not called a return, and returns while exploring say so, unless the panel has its own label."""
    ax = Curves(made_results()).draw(new_axes())
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("training steps", "return (greedy)")
    figure_of(ax).draw_without_rendering()
    assert "100" in [label.get_text() for label in ax.get_xticklabels()]
    share = Curves(made_results(), methods=["A"], share=True)
    assert share.draw(new_axes()).get_ylabel() == "share of runs with return 1 (greedy)"
    training = Curves(made_results(), "On-line", column="training_return")
    assert training.draw(new_axes()).get_ylabel() == "return (while exploring)"
    ax = training._replace(y_label="reward").draw(new_axes())
    assert (ax.get_ylabel(), ax.get_title()) == ("reward", "On-line")


def test_methods_keep_their_strokes() -> None:
    """The order of the methods gives the colours."""
    ax = Curves(made_results()).draw(new_axes())
    assert [line.get_color() for line in ax.lines] == [STROKES[0].color, STROKES[1].color]
    assert len({stroke.color for stroke in STROKES}) == len(STROKES)


def test_a_range_of_the_y_axis() -> None:
    """It cuts off what is beyond."""
    assert Curves(made_results(), y_range=(-4.0, 1.5)).draw(new_axes()).get_ylim() == (-4.0, 1.5)


def test_unknown_names_are_refused() -> None:
    """Of methods and of columns."""
    with pytest.raises(ValueError, match="method must be one of 'A', 'B', but is 'C'"):
        Curves(made_results(), methods=["C"]).draw(new_axes())
    with pytest.raises(ValueError, match="column must be one of"):
        Curves(made_results(), column="seed").draw(new_axes())
    with pytest.raises(ValueError, match=r"results must be Results, as repeat gives .*, but is 'results.csv'$"):
        Curves("results.csv").draw(new_axes())  # type: ignore[arg-type]


def test_without_axes_there_is_a_new_figure() -> None:
    """As everywhere in Matplotlib; no setting changes."""
    before = dict(mpl.rcParams)
    ax = Curves(made_results()).draw()
    assert pyplot.get_fignums() == [figure_of(ax).number]
    assert dict(mpl.rcParams) == before

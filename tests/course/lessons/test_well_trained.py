"""What figures and tables of the lessons show of agents that have learned, on numbers made up by hand."""

import inspect
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym.envs.golf import Golf
from edugym.experiments.figures.style import STROKES
from edugym.experiments.results.statistics import mean_interval
from edugym_course.lessons.depth import figures as depth_figures
from edugym_course.lessons.depth import methods as depth_methods
from edugym_course.lessons.dimensionality import methods
from edugym_course.lessons.dimensionality.figures import Dots as Columns
from edugym_course.lessons.model_based import figures as model_based_figures
from edugym_course.lessons.model_based import plans as model_based_plans
from edugym_course.lessons.signal import figures as signal_figures
from edugym_course.lessons.signal import methods as signal_methods
from edugym_course.lessons.signal.figures import Greedy
from edugym_course.lessons.stochasticity import figures as stochasticity_figures
from edugym_course.lessons.stochasticity import methods as stochasticity_methods
from edugym_course.lessons.stochasticity.figures import Dots, Games
from edugym_course.lessons.stochasticity.methods import Played, played
from tests.course.lessons.made_up import Curve, made_up
from tests.experiments.figures.samples import heights, new_axes

SHARES = [0.1, 0.0, 0.2, 0.3, 0.1, 0.1, 0.05, 0.05, 0.0, 0.05, 0.05]
"""Of games of golf: lost, and won with 1 to 10 hits."""


def test_mean_and_spread_of_games() -> None:
    """A win with k hits returns 1.1 - k / 10, a lost game -1."""
    one = played([np.array(SHARES), np.eye(11)[3]], 10)
    returns = np.array([-1.0, 1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1])
    mean = float(np.dot(SHARES, returns))
    assert one.mean.tolist() == pytest.approx([mean, 0.8])
    assert one.spread.tolist() == pytest.approx([np.dot(SHARES, (returns - mean) ** 2) ** 0.5, 0.0], abs=1e-7)
    assert one.lost.tolist() == [0.1, 0.0]


def test_bars_of_games() -> None:
    """Lost ones first, and those with six hits or more in one bar; the bars of two methods stand side by side."""
    two = {"one": played([np.array(SHARES)], 10), "other": played([np.eye(11)[2], np.eye(11)[0]], 10)}
    ax = Games(two).draw(new_axes())
    bars: list[Any] = [*ax.patches]
    assert [bar.get_height() for bar in bars[:7]] == pytest.approx([0.1, 0.0, 0.2, 0.3, 0.1, 0.1, 0.2])
    assert [bar.get_height() for bar in bars[7:]] == [0.5, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0]
    assert [bar.get_x() for bar in (bars[0], bars[7], bars[8])] == pytest.approx([-0.4, 0.0, 1.0])
    assert [label.get_text() for label in ax.get_xticklabels()] == ["lost", "1", "2", "3", "4", "5", "6+"]


def test_dots_have_intervals() -> None:
    """Each method has a dot at its mean, on a line from one end of the interval to the other, in its colour."""
    values = np.array([1.0, 2.0, 6.0])
    ax = Dots({"one": np.zeros(3), "other": values}).draw(new_axes())
    interval = mean_interval(values)
    assert [heights(line) for line in ax.lines[2:]] == [[interval.low, interval.high], [3.0]]
    assert [line.get_color() for line in ax.lines] == [STROKES[k].color for k in (0, 0, 1, 1)]
    assert [np.asarray(line.get_xdata()).tolist() for line in ax.lines] == [[0, 0], [0], [1, 1], [1]]
    assert ax.get_xlim() == (-0.6, 1.6)


def test_mean_spread_and_lost_balls() -> None:
    """Each has a panel, with all players; who loses more than 1 ball in 100 drives."""
    lost = np.array([0.0, 0.01, 0.011, 0.02])
    one = Played(np.full(4, 0.7), np.full(4, 0.2), lost, np.zeros((4, 11)))
    other = Played(np.full(4, 0.6), np.full(4, 0.3), lost[::-1], np.zeros((4, 11)))
    panels: Any = stochasticity_figures.outcomes({"one": one, "other": other}).rows[0]
    assert [panel.title for panel in panels] == ["mean", "spread", "lost balls"]
    assert [[values.tolist()[0] for values in panel.measured.values()] for panel in panels] == [
        [0.7, 0.6], [0.2, 0.3], [0.0, 0.02],
    ]  # fmt: skip
    assert stochasticity_methods.share_of_drivers(one) == 0.5
    assert stochasticity_methods.lead(one, other).estimate == pytest.approx(0.1)
    learned: Any = stochasticity_figures.frontier_figure({"a": (0.5, 0.1), "b": (0.6, 0.2)}, ["b"], {"one": one})
    assert learned.learned == {"one": (pytest.approx(0.7), pytest.approx(0.2))}


def test_runs_by_their_first_swing() -> None:
    """Two of three drive: how many, their mean return, and their share of lost balls."""
    task = Golf.create(observe_hits=True)
    rng = np.random.default_rng(0)
    shape = (task.width, task.length, task.max_hits + 1)
    tee = np.ravel_multi_index(tuple(task.observation(task.initial(rng), rng)), shape)
    agents = [SimpleNamespace(Q=np.zeros((int(np.prod(shape)), 3))) for _ in range(3)]
    for agent, swing in zip(agents, (2, 1, 2), strict=True):
        agent.Q[tee, swing] = swing
    label = stochasticity_methods.NEUTRAL
    results = made_up({label: [{10: 0.0}] * 3}, agents={label: agents})
    one = Played(np.array([0.5, 0.7, 0.9]), np.zeros(3), np.array([0.02, 0.0, 0.04]), np.zeros((3, 11)))
    groups = stochasticity_methods.by_first_swing(results, {label: one})[label]
    assert groups == {"chip": (1, 0.7, 0.0), "drive": (2, pytest.approx(0.7), pytest.approx(0.03))}
    assert stochasticity_methods.values_on_the_tee(results)[label] == pytest.approx([0.0, 1 / 3, 4 / 3])


def test_items_that_were_found() -> None:
    """Item 1 counts 4 in a state, item 2 counts 2 and item 3 counts 1; a run has found what it has acted with."""
    tables = np.zeros((2, 800, 4))
    tables[0, 8 * 50 + 4, 2] = tables[0, 8 * 20 + 6, 0] = tables[1, 8 * 30 + 4, 1] = 1.0
    kinds = [
        [SimpleNamespace(Q=-table) for table in tables],
        [SimpleNamespace(Q=table, known=table) for table in tables],
        [SimpleNamespace(Q=table, last=table) for table in tables],
        [SimpleNamespace(Q=0 * table, model=SimpleNamespace(visits=table)) for table in tables],
    ]
    for agents in kinds:
        results = made_up({"one": [{10: 0.0}] * 2}, agents={"one": agents})
        assert model_based_plans.items_found(results, "one").tolist() == [1.0, 0.5, 0.0]


def test_the_best_rate_of_each_depth() -> None:
    """By the return averaged over training, not by that of the end."""
    names = [depth_methods.label(n) for n in depth_methods.BY_DEPTH]
    low = made_up({name: [{0: 0.0, 5: 2.0 * k, 10: 0.0}] for k, name in enumerate(names)})
    high = made_up({name: [{0: 0.0, 5: 3.0, 10: 9.0 - 4.0 * k}] for k, name in enumerate(names)})
    assert depth_figures.best_rates({0.1: low, 0.3: high}) == dict(
        zip(depth_methods.BY_DEPTH, (0.3, 0.3, 0.1, 0.1), strict=True)
    )


SLOW_AND_FAST: list[Curve] = [
    {0: 0.0, 10: 0.99, 20: 0.0, 60: 0.0},
    {0: 0.0, 10: 0.98, 20: 0.99, 60: 1.0},
    {0: 0.0, 10: 0.0, 20: 0.0, 60: 1.0},
]
SELDOM = [SLOW_AND_FAST[0], *[{0: 0.0, 10: 0.5, 20: 0.5, 60: 0.5}] * 2]


@pytest.mark.parametrize(("curves", "median"), [(SLOW_AND_FAST, 20.0), (SELDOM, math.inf)])
def test_the_run_in_the_middle(curves: list[Curve], median: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """A level counts when it is reached for the first time; a run that never gets there takes for ever."""
    results = made_up({"one": curves}, 60)
    assert model_based_figures.steps_to(results, "one", 0.99) == median
    clock = model_based_figures.Clock(results, {"one": np.ones((1, 60), np.int64)}, step_ms=1000.0, target_us=1.0)
    assert clock.seconds_to("one", 0.99) == pytest.approx(median)
    monkeypatch.setattr(methods, "learn", lambda task, label, *more, **how: made_up({label: curves}, 60))
    assert {*methods.steps_to_solve(3).values()} == {median}


def test_the_second_half_of_training() -> None:
    """The last three of five points, whose mean, median and share below 5 count in lesson 6."""
    results = made_up(
        {"Q-learning": [{0: 0.0, 10: 1.0, 20: 5.0, 30: 9.0, 40: 2.0}, dict.fromkeys(range(0, 50, 10), 4.0)]}, 40
    )
    assert signal_methods.late(results, "Q-learning").tolist() == pytest.approx([16 / 3, 4.0])
    assert signal_methods.median_late(results).tolist() == [5.0, 4.0]
    assert signal_methods.time_below(results, "Q-learning", 5.0).tolist() == pytest.approx([1 / 3, 1.0])
    assert signal_methods.after(results, 30).tolist() == [9.0, 4.0]


def test_how_words_are_answered() -> None:
    """Half of the players obey, the others take 1 for 0 and 0 for 1; each word has a row, each action a column."""
    obeys, confused = (
        SimpleNamespace(greedy=lambda row, rng, of=of: of[row % 4]) for of in ((0, 1, 2, 3), (1, 0, 2, 3))
    )
    shares = [
        signal_figures.answers(made_up({"Q-learning": [{10: 0.0}]}, agents={"Q-learning": [agent]}), 0.0).shares
        for agent in (obeys, confused)
    ]
    assert shares[0].tolist() == np.eye(4).tolist()
    assert shares[1][:2].tolist() == np.eye(4)[[1, 0]].tolist()
    bars: list[Any] = [*Greedy(np.array([[0.1, 0.2, 0.3, 0.4], [0.4, 0.3, 0.2, 0.1]])).draw(new_axes()).patches]
    assert [(round(bar.get_x(), 6), round(bar.get_width(), 6)) for bar in bars[::2]] == [
        (0, 0.1),
        (0.1, 0.2),
        (0.3, 0.3),
        (0.6, 0.4),
    ]
    assert [bar.get_y() + bar.get_height() / 2 for bar in bars[:2]] == [0.0, 1.0]


def test_returns_on_columns_of_training_and_on_others() -> None:
    """The first are a full dot above an empty one for the others; bars end where returns do."""
    by_column = np.array([[0.9, 0.7], [-0.5, 0.1], [0.9, 0.7], [-0.5, 0.1], [0.9, 0.7]])
    ax = Columns({"one": by_column, "other": np.ones((5, 3))}).draw(new_axes())
    bars, dots = ax.lines[0:4:2], ax.lines[1:4:2]
    places = [(float(np.asarray(dot.get_xdata())[0]), heights(dot)[0]) for dot in dots]
    assert places == [pytest.approx((0.8, -0.14)), pytest.approx((-0.2, 0.14))]
    assert [str(dot.get_markerfacecolor()) for dot in dots] == [str(dots[0].get_color()), "white"]
    ends = [np.asarray(bar.get_xdata()).tolist() for bar in bars]
    assert ends == [pytest.approx([-0.4706, 1.0], abs=1e-3), [-1.0, 1.0]]
    assert [label.get_text() for label in ax.get_yticklabels()] == ["one", "other"]
    assert ax.get_ylim()[0] > ax.get_ylim()[1]


def test_levels_at_which_attitudes_are_compared() -> None:
    """From 0.0075 to 0.0225: that takes too long for the transcript."""
    levels = inspect.signature(stochasticity_figures.crossing_by_attitude).parameters["levels"].default
    assert levels == pytest.approx(np.arange(0.0075, 0.0226, 0.0015))

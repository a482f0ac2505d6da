"""The figures of lesson 9."""

import re
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import With, on_axes
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import BLACK, BROWN, PURPLE, REFERENCE, Stroke, dress, plot_line, stroke
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Reals
from edugym_course.lessons.model_based.methods import (
    DECAYING,
    DYNA_10,
    DYNA_50,
    EPSILON,
    LEARNED,
    MORE_RANDOM,
    NOISES,
    OPTIMUM,
    PLANNING_DISCOUNT,
    Q_LEARNING,
    R_MAX,
    SLOW_DYNA,
    SWEEPING,
    WRONG,
    Maker,
    compare,
    exact_model,
)
from edugym_course.lessons.model_based.plans import Plan, look_ahead, used_and_seen
from edugym_course.reporting import for_mdp

if TYPE_CHECKING:
    from matplotlib.axes import Axes

STROKES: Mapping[str, int] = MappingProxyType(
    {
        Q_LEARNING: 0,
        DYNA_10: 1,
        DYNA_50: 2,
        SWEEPING: 3,
        R_MAX: 4,
        MORE_RANDOM: 5,
        DECAYING: 6,
        SLOW_DYNA: 5,
    }
)
"""The stroke of each method, the same in all figures."""


OWN = (
    stroke(6),
    Stroke(BROWN, "solid"),
    Stroke(PURPLE, (0, (6, 1.5))),
    Stroke(BLACK, (0, (6, 1.5, 1.5, 1.5))),
)
"""The strokes of a reader's own methods, in their order."""


def looks_of(methods: Iterable[str]) -> dict[str, Stroke]:
    """Return the look of the line of each method; Dyna with another number of updates has that of Dyna-10."""
    methods = [*methods]
    looks: dict[str, Stroke] = {}
    own = 0
    for method in methods:
        other_dyna = re.fullmatch(r"Dyna-\d+", method) and DYNA_10 not in methods
        index = STROKES.get(method, STROKES[DYNA_10] if other_dyna else None)
        looks[method] = OWN[own % len(OWN)] if index is None else stroke(index)
        own += index is None
    return looks


def close(lines: Lines, low: float, high: float) -> With:
    """Return a part of the y axis of other lines."""
    return With(lines._replace(title=f"{lines.title}: {low:g} to {high:g}"), lambda ax: ax.set_ylim(low, high))


class Clock(NamedTuple):
    """Learning curves over time instead of steps.

    Attributes:
        results: the results to draw.
        targets: by method, how many targets each step computed (see `targets_computed`).
        step_ms: how long a step in the world takes, in milliseconds.
        target_us: how long it takes to compute a target, in microseconds; that is done while the step takes its time.
        title: the text above the axes.
    """

    results: Results
    targets: Mapping[str, Integers]
    step_ms: float
    target_us: float
    title: str = ""

    def seconds(self, method: str) -> Reals:
        """Return when the points of the curves of a method are reached, shape (points, n_repetitions).

        A step takes as long as the world, or as its targets if they take longer.
        """
        curves = self.results.curves(method)
        each = np.maximum(self.step_ms * 1e-3, self.targets[method] * self.target_us * 1e-6)
        passed = np.pad(each.cumsum(axis=1), ((0, 0), (1, 0)))
        seconds: Reals = np.broadcast_to(passed[:, curves.index].T, curves.shape)
        return seconds

    def seconds_to(self, method: str, level: float) -> float:
        """Return the time that half of the runs need for a greedy return of `level`; inf for never."""
        reached = self.results.curves(method).to_numpy(float) >= level
        return float(np.median(np.where(reached, self.seconds(method), np.inf).min(axis=0)))

    def mean(self, method: str) -> tuple[Reals, Reals]:
        """Return moments in seconds, and the mean return of the runs at each of them.

        Each run has a clock of its own, so it would not do to take the mean of their times as well: a run that
        computes more in the same steps also knows more.
        """
        seconds, returns = self.seconds(method), self.results.curves(method).to_numpy(float)
        moments: Reals = np.geomspace(seconds[1].min(), seconds[-1].max(), 400)
        runs = [np.interp(moments, seconds[:, k], returns[:, k]) for k in range(returns.shape[1])]
        return moments, np.mean(runs, axis=0)

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the curves."""
        for method, look in looks_of(self.results.methods).items():
            plot_line(ax, look, *self.mean(method), method)
        ax.axhline(OPTIMUM, label="optimum", **REFERENCE)
        ax.set_xscale("log")
        ax.set_ylim(-100.0, 100.0)
        dress(ax, "seconds", "return (greedy)", self.title)


class Knowledge(NamedTuple):
    """For each method, the return of its policy beside that of the best plan by what it has seen.

    Attributes:
        measured: by method, both of every run, each of shape (n_runs,).
        title: the text above the axes.
    """

    measured: Mapping[str, tuple[Reals, Reals]]
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw both."""
        looks = looks_of(self.measured)
        for row, (method, both) in enumerate(self.measured.items()):
            policy, seen = (mean_interval(values) for values in both)
            colour = looks[method].color
            for place_of, found, filled in ((row - 0.12, seen, False), (row + 0.12, policy, True)):
                ax.plot([found.low, found.high], [place_of, place_of], color=colour, linewidth=1.4)
                face = colour if filled else "white"
                ax.plot(found.estimate, place_of, "o", color=colour, markerfacecolor=face, markersize=7)
        ax.axvline(OPTIMUM, label="optimum", **REFERENCE)
        ax.plot([], [], "o", color="#333333", label="its policy")
        ax.plot([], [], "o", color="#333333", markerfacecolor="white", label="the best plan by what it has seen")
        ax.set_yticks(range(len(self.measured)), [*self.measured])
        ax.invert_yaxis()
        dress(ax, f"return after training ({len(next(iter(self.measured.values()))[0])} runs)", "", self.title)


def steps_to(results: Results, method: str, level: float) -> float:
    """Return the training steps after which half of the runs have had a greedy return of `level`; inf for never."""
    reached = results.curves(method) >= level
    return float(np.median(np.where(reached.any(), reached.idxmax(), np.inf)))


def learning(results: Results, title: str = "", **how: Any) -> Curves:
    """Return the learning curves of all methods, with the optimum; other arguments as of `Curves`."""
    how = {"optimum": OPTIMUM, "y_range": (-100.0, 100.0), **how}
    return Curves(results, title, strokes=looks_of(results.methods), **how)


def learning_curves(results: Results, epsilon: float = EPSILON) -> Sheet:
    """Return the paper's figure, and beside it the returns while the methods explore."""
    soft = value_iteration(exact_model(), epsilon=epsilon).start
    exploring = learning(results, "while exploring", column="training_return", optimum=None, soft_optimum=soft)
    return Sheet("learned", [[learning(results, "without exploring"), exploring]])


def clocks(results: Results, targets: Mapping[str, Integers], step_ms: float = 100.0, target_us: float = 10.0) -> Sheet:
    """Return the same curves over time, where steps cost nothing, and where they cost something."""
    titles = {0.0: "steps cost nothing", step_ms: f"a step takes {step_ms:g} ms"}
    return Sheet("clocks", [[Clock(results, targets, cost, target_us, title) for cost, title in titles.items()]])


def look_ahead_lines(results: Results, depths: Sequence[int] = range(16)) -> Lines:
    """Return what agents get that look ahead in the exact model, against the depth."""
    lines = {"knows nothing": np.array([look_ahead(None, depth) for depth in depths])}
    for method in results.methods:
        agents = results.complete_agents(method).values()
        lines[method] = np.array([np.mean([look_ahead(agent.Q, depth) for agent in agents]) for depth in depths])
    return Lines(
        np.array(depths, float),
        lines,
        "planning to act",
        "steps that it looks ahead",
        "return",
        {"optimum": np.full(len(depths), OPTIMUM)},
        strokes=looks_of(lines),
    )


def race(own: Mapping[str, Maker], repetitions: int = 20, **how: Any) -> Sheet:
    """Return the learning curves of the reader's own agents beside those of the lesson.

    Args:
        own: by label, functions that make an agent for the shop, which is the MDP itself.
        repetitions: the number of runs of each method.
        **how: more arguments of `compare`.
    """
    mine = {label: for_mdp(make) for label, make in own.items()}
    others = {label: LEARNED[label] for label in (Q_LEARNING, DYNA_10, R_MAX)}
    results = compare({**others, **mine}, repetitions=repetitions, **how)
    curves = learning(results, "without exploring", y_range=(-510.0, 110.0))
    return Sheet("race", [[curves, Knowledge(used_and_seen(results), "what they do with what they know")]])


def figures(
    learned: Results, remedied: Results, right: Results, wrong: Results, plans: Mapping[float, list[Plan]]
) -> list[Sheet]:
    """Return the figures: learning curves, remedies, and the share of plans that fail."""
    y_range = (0.0, 100.0)
    soft = value_iteration(exact_model(), epsilon=EPSILON).start
    greedy = learning(learned, "learned model", y_range=y_range)
    shown: dict[str, Any] = {"column": "training_return", "optimum": None, "soft_optimum": soft, "y_range": y_range}
    exploring = learning(learned, "while exploring", **shown)
    better = learning(remedied, "more exploration", y_range=y_range)
    return [
        Sheet("model_based", [[greedy, exploring]]),
        Sheet("remedies", [[better]]),
        given_curves(right, wrong),
        Sheet("wrong_plans", [[plan_lines({PLANNING_DISCOUNT: plans})]]),
    ]


def given_curves(right: Results, wrong: Results) -> Sheet:
    """Return the learning curves with a given model that is right, and with one that is wrong."""
    titles = {"given model, right": right, f"given model, noise {WRONG:g}": wrong}
    return Sheet("given_model", [[learning(results, title, y_range=None) for title, results in titles.items()]])


def plan_lines(by_discount: Mapping[float, Mapping[float, list[Plan]]]) -> Lines:
    """Return the share of plans that never end, against the noise of the model, for each discount."""
    shares = {
        f"γ = {discount:g}": np.array([np.mean([not plan.ends for plan in plans[noise]]) for noise in NOISES])
        for discount, plans in by_discount.items()
    }
    return Lines(
        np.array(NOISES),
        shares,
        "plans by value iteration with a wrong model",
        "noise in the rewards of the model",
        "share that never get to the exit",
    )

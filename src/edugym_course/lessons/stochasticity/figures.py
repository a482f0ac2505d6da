"""The figures of lesson 8."""

from collections.abc import Mapping, Sequence
from itertools import cycle
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.envs.golf import DISTANCES, SWINGS, Golf
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import Panel, With, on_axes
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import REFERENCE, SOFT_REFERENCE, VERMILION, dress, plot_line, stroke
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import GRASS, GREEN, WATER, WHITE, blend
from edugym_course.lessons.stochasticity.exact import crossing, from_the_tee, optimum, soft_optimum, weighted
from edugym_course.lessons.stochasticity.methods import (
    EPSILON,
    LEVEL,
    RISKS,
    Maker,
    Played,
    by_first_swing,
    landings,
    learn,
    play,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes


LEVEL_LABEL = "stochasticity level"
FIRST_FREE = 5
"""The first stroke that no player of the lesson has."""


class Course(NamedTuple):
    """The course from above, with the places where many balls land.

    Attributes:
        balls: shape (n, 2): the places.
        aim: where they should land.
        title: the text above the axes.
    """

    balls: Reals
    aim: tuple[float, float]
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the course."""
        from matplotlib.patches import Circle, Rectangle

        golf = Golf.create()
        flag = golf.width / 2, golf.length - golf.width / 2
        ax.add_patch(Rectangle((0, 0), golf.width, golf.length, facecolor=blend(GRASS, WHITE, 0.3), zorder=0))
        ax.add_patch(Circle(flag, golf.green_radius, facecolor=blend(GRASS, GREEN, 0.7), zorder=0.5))
        ax.set_facecolor(WATER)
        ax.plot(*self.balls.T, ".", color="#222222", markersize=2, alpha=0.5, label="balls")
        ax.plot(*self.aim, "+", color=VERMILION, markersize=9, markeredgewidth=2, label="aim")
        ax.plot(golf.width / 2, 0.15, "^", color="white", markeredgecolor="#222222", markersize=6, label="tee")
        ax.set_aspect("equal")
        ax.set_xlim(-2.5, golf.width + 2.5)
        ax.set_ylim(-0.8, golf.length + 0.8)
        dress(ax, "x, in cells", "y, in cells", self.title)


class Dots(NamedTuple):
    """One number of each method: the mean over repetitions, with its 95 % interval.

    Attributes:
        measured: by label of the method, shape (n_repetitions,).
        title: the text above the axes.
        y_label: the label of the y axis.
        theory: by label, numbers to compare with, drawn as lines.
    """

    measured: Mapping[str, Reals]
    title: str = ""
    y_label: str = ""
    theory: Mapping[str, float] = MappingProxyType({})

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the dots."""
        for i, (method, values) in enumerate(self.measured.items()):
            interval = mean_interval(values)
            ax.plot([i, i], [interval.low, interval.high], color=stroke(i).color, linewidth=2)
            ax.plot(i, interval.estimate, "o", color=stroke(i).color, markersize=7, label=method)
        for (label, value), look in zip(self.theory.items(), cycle((REFERENCE, SOFT_REFERENCE)), strict=False):
            ax.axhline(value, label=label, **look)
        ax.set_xlim(-0.6, len(self.measured) - 0.4)
        dress(ax, "method", self.y_label, self.title)
        ax.set_xticks([])


class Games(NamedTuple):
    """How the games of each method end: lost, or won with 1, 2, ... hits; means over repetitions.

    Attributes:
        played: by label of the method, how it plays.
        title: the text above the axes.
        most: won games with so many hits or more are one bar.
    """

    played: Mapping[str, Played]
    title: str = ""
    most: int = 6

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the bars."""
        names = ["lost", *(str(hits) for hits in range(1, self.most)), f"{self.most}+"]
        width = 0.8 / len(self.played)
        for i, (method, games) in enumerate(self.played.items()):
            mean = games.games.mean(axis=0)
            bars = [mean[0], *mean[1 : self.most], mean[self.most :].sum()]
            at = np.arange(len(bars)) + width * (i - (len(self.played) - 1) / 2)
            ax.bar(at, bars, width, color=stroke(i).color, label=method)
        ax.set_xticks(np.arange(len(names)), names)
        dress(ax, "lost, or won with so many hits", "share of games", self.title)


class Crossing(Lines):
    """Lines against the level, and the level at which drive and chip are worth the same."""

    __slots__ = ()

    @property
    def change(self) -> float:
        """The level from which on the chip is worth more."""
        return crossing()

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the lines."""
        for i, (swing, line) in enumerate(self.lines.items(), start=FIRST_FREE):  # other colours than those of players
            plot_line(ax, stroke(i), self.x, line, swing)
        ax.axvline(self.change, label=f"the crossing, level {self.change:.4f}", **SOFT_REFERENCE)
        dress(ax, self.x_label, self.y_label, self.title)


class Frontier(NamedTuple):
    """Mean and spread of the returns of many players, and the frontier of those that are worth choosing.

    Attributes:
        rules: shape (n, 2): mean and spread of players with rules.
        frontier: shape (m, 2): those of them that no other one beats.
        learned: by label, the mean and the spread of learned players: a mean over repetitions.
        title: the text above the axes.
    """

    rules: Reals
    frontier: Reals
    learned: Mapping[str, tuple[float, float]]
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the players."""
        mean, spread = self.rules.T
        ax.plot(spread, mean, "o", color="#bbbbbb", markersize=4, label="players with rules")
        best = self.frontier[np.argsort(self.frontier[:, 1])]
        ax.plot(best[:, 1], best[:, 0], "k.-", linewidth=1, label="your frontier")
        for i, (label, (its_mean, its_spread)) in enumerate(self.learned.items()):
            ax.plot(its_spread, its_mean, "D", color=stroke(i).color, markersize=7, label=label)
        ax.set_xlim(-0.02, 0.42)
        ax.set_ylim(0.45, 0.9)
        dress(ax, "standard deviation of the return", "mean return", self.title)


def landings_figure(level: float = LEVEL) -> Sheet:
    """Return where a thousand balls from the tee land, for each swing."""
    task = Golf.create(stochasticity_level=level)
    tee = task.initial(np.random.default_rng(0))
    panels = [Course(landings(k, level)[0], task.aim(tee, DISTANCES[k]), SWINGS[k]) for k in range(len(SWINGS))]
    return Sheet("landings", [panels])


def weights_figure(risks: Mapping[str, float] = RISKS) -> Sheet:
    """Return the weight of a TD error, and the weighted error, against the error."""
    deltas = np.linspace(-2.0, 2.0, 201)
    weights = {label: 1.0 + np.tanh(risk * deltas / 2.0) for label, risk in risks.items()}
    moves = {label: weighted(risk, deltas) for label, risk in risks.items()}
    return Sheet(
        "weights",
        [
            [
                Lines(deltas, weights, "the weight of a TD error", "TD error δ", "2σ(βδ)"),
                Lines(deltas, moves, "the weighted error", "TD error δ", "2σ(βδ) δ"),
            ]
        ],
    )


def learning_curves(results: Results, level: float = LEVEL, epsilon: float = EPSILON) -> Sheet:
    """Return a panel of greedy games and one of training games, with what is possible for who sees the ball.

    Args:
        results: what `learn` returned.
        level: the stochasticity level.
        epsilon: ε of the training.
    """
    return Sheet("stochasticity", [_curves(results, level, epsilon)])


def _curves(results: Results, level: float, epsilon: float) -> list[Panel]:
    best = optimum(level)
    soft = soft_optimum(level, epsilon) if level > 0 else None
    bottom = min(0.3, best - 0.6)
    return [
        Curves(results, "greedy", optimum=best, y_range=(bottom, 1.0)),
        Curves(
            results,
            "while exploring",
            column="training_return",
            optimum=best,
            soft_optimum=soft,
            y_range=(bottom, 1.0),
        ),
    ]


def outcomes(played: Mapping[str, Played], level: float = LEVEL) -> Sheet:
    """Return mean, spread and lost balls of the methods."""
    return Sheet("outcomes", [_outcomes(played, level)])


def _outcomes(played: Mapping[str, Played], level: float) -> list[Panel]:
    columns = {
        field: {label: getattr(one, field) for label, one in played.items()} for field in ("mean", "spread", "lost")
    }
    return [
        Dots(columns["mean"], "mean", "mean return (greedy)", {"optimum": optimum(level)}),
        Dots(columns["spread"], "spread", "standard deviation of the return"),
        Dots(columns["lost"], "lost balls", "share of lost balls"),
    ]


def slider_figure(results: Results, played: Mapping[str, Played], level: float, epsilon: float) -> Sheet:
    """Return learning curves, how games end, and mean, spread and lost balls."""
    return Sheet(
        "sliders", [[*_curves(results, level, epsilon), Games(played, "how games end")], _outcomes(played, level)]
    )


def crossing_lines(levels: Sequence[float] = tuple(np.linspace(0.005, 0.0225, 15))) -> Crossing:
    """Return the exact worth of a drive and of a chip from the tee, against the level."""
    return Crossing(
        np.array(levels),
        {swing: np.array([from_the_tee(level)[swing] for level in levels]) for swing in ("drive", "chip")},
        "first this swing, then best play",
        LEVEL_LABEL,
        "expected return",
    )


def crossing_by_attitude(
    levels: Sequence[float] = tuple(np.linspace(0.0075, 0.0225, 11)), risks: Mapping[str, float] = RISKS
) -> With:
    """Return how much more a drive is worth than a chip, exactly, for several attitudes to risk.

    What is far below 0 is cut off.
    """
    lines = {}
    for label, risk in risks.items():
        worths = [from_the_tee(level, 0.25, risk=risk) for level in levels]
        lines[label] = np.array([worth["drive"] - worth["chip"] for worth in worths])
    leads = Lines(
        np.array(levels),
        lines,
        "from the tee, computed exactly",
        LEVEL_LABEL,
        "worth of drive less chip",
        {"drive and chip are equal": np.zeros(len(levels))},
    )
    return With(leads, lambda ax: ax.set_ylim(-0.2, 0.1))


def against_level(
    levels: Sequence[float] = (0.005, 0.01, 0.0125, 0.015, 0.0175, 0.02), **how: Any
) -> tuple[Against, Against]:
    """Return mean return and lost balls of learned players against the level; arguments as in `learn`."""
    runs = [play(learn(level=level, evaluation_episodes=1, **how), level=level) for level in levels]
    mean, lost = (
        {label: [getattr(run[label], field) for run in runs] for label in runs[0]} for field in ("mean", "lost")
    )
    best = {"optimum": np.array([optimum(level) for level in levels])}
    return (
        Against(levels, mean, "what they earn", LEVEL_LABEL, "mean return (greedy)", best),
        Against(levels, lost, "what they lose", LEVEL_LABEL, "share of lost balls"),
    )


def lake_figure(dry: Results, slippery: Results, best_on_ice: float) -> Sheet:
    """Return the learning curves of several learning rates on the frozen lake, not slippery and slippery."""
    return Sheet(
        "lake",
        [
            [
                Curves(dry, "not slippery", optimum=1.0, y_range=(-0.03, 1.05)),
                Curves(slippery, "slippery", optimum=best_on_ice, y_range=(-0.03, 1.05)),
            ]
        ],
    )


def frontier_figure(
    rules: Mapping[str, tuple[float, float]], best: Sequence[str], played: Mapping[str, Played]
) -> Frontier:
    """Return players with rules, the frontier among them, and learned players.

    Args:
        rules: by label, mean and spread.
        best: the labels on the frontier.
        played: by label, how learned players play.
    """
    return Frontier(
        np.array([*rules.values()]),
        np.array([rules[label] for label in best]).reshape(-1, 2),
        {label: (float(one.mean.mean()), float(one.spread.mean())) for label, one in played.items()},
        f"level {LEVEL:g}",
    )


def race(own: Mapping[str, Maker], players: Mapping[str, Played], *, level: float = LEVEL, **how: Any) -> Sheet:
    """Return the lesson's figure of mean, spread and lost balls with methods of the reader's own beside its three.

    It prints with which swing their runs start.

    Args:
        own: by label, functions that make agents.
        players: how the three play; empty leaves them out.
        level: the stochasticity level.
        **how: more arguments of `learn`.
    """
    results = learn(level=level, risks={}, own=own, evaluation_episodes=1, **how)
    theirs = play(results, level=level)
    for label, swings in by_first_swing(results, theirs).items():
        starts = ", ".join(f"{runs} with a {swing}" for swing, (runs, _, _) in swings.items())
        print(f"{label:15}: first swings of {len(theirs[label].mean)} runs: {starts}")
    return outcomes({**players, **theirs}, level)._replace(name="race")

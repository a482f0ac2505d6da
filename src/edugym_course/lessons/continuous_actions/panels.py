"""The panels of lesson 7."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.envs.trashbot.geometry import REACH
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.panel import ALONE, Place, With, on_axes
from edugym.experiments.figures.style import (
    REFERENCE,
    SOFT_REFERENCE,
    TEAL,
    VERMILION,
    add_legend,
    axes_or_new,
    dress,
    stroke,
    strokes_of,
)
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import INK
from edugym_course.lessons.continuous_actions.exact import best_return, deliveries, room
from edugym_course.lessons.continuous_actions.methods import WIDTH, name
from edugym_course.lessons.continuous_actions.ppo import ACTIONS, CONTINUOUS
from edugym_course.lessons.continuous_actions.release import Climbed, Reward, density, reward, slopes, value

if TYPE_CHECKING:
    from matplotlib.axes import Axes

COLOURS: Mapping[str, str] = MappingProxyType({label: stroke(i).color for i, label in enumerate(ACTIONS)})
"""The colour of each kind of actions, in every figure of the lesson."""
BOX_RED = VERMILION


def shade(share: float) -> tuple[float, float, float]:
    """Return a colour between teal (0), for a policy before it has learned, and pink (1), for one after that."""
    return 0.55 * share + 0.25, 0.65 * (1 - share) + 0.1, 0.75 - 0.25 * share


def with_best(curves: Curves, best: Mapping[str, float]) -> With:
    """Return learning curves, and for methods a dotted line in their colour: the best return that is possible."""

    def best_return_of_each(ax: "Axes") -> None:
        for method, drawn in strokes_of(curves.shown, curves.strokes).items():
            if method in best:
                ax.axhline(best[method], **{**SOFT_REFERENCE, "color": drawn.color, "linewidth": 1.0})
        ax.plot([], [], label="best possible", **SOFT_REFERENCE)

    return With(curves, best_return_of_each)


def run_by_run(curves: Curves) -> With:
    """Return learning curves with each run as a thin line in the place of the band."""

    def runs(ax: "Axes") -> None:
        for band, (method, drawn) in zip(ax.collections, strokes_of(curves.shown, curves.strokes).items(), strict=True):
            band.set_visible(False)
            ax.plot(*curves.points(method), color=drawn.color, linewidth=0.6, alpha=0.5)

    return With(curves, runs)


class Places(NamedTuple):
    """Where in the container the box can be let go, a row of dots for each number of bins.

    Attributes:
        bins: the numbers of bins.
        width: of the container.
        title: the text above the axes.
    """

    bins: Sequence[int]
    width: float = WIDTH
    title: str = "where the box can be let go"

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the rows."""
        free = room(self.width)
        rows = [*self.bins, None]
        for y, n in enumerate(rows):
            colour = COLOURS.get(name(n) if n else CONTINUOUS, "#7f7f7f")
            if n is None:
                ax.plot([-free, free], [y, y], color=colour, linewidth=3, solid_capstyle="butt")
                continue
            places = deliveries(n, self.width).places
            ax.plot(places, np.full(len(places), y), "o", color=colour, markersize=3.5, alpha=0.7)
            if len(places):
                nearest = places[np.abs(places).argmin()]
                ax.plot(nearest, y, "o", markersize=9, fillstyle="none", color=INK)
            else:
                ax.text(0, y, "nowhere", ha="center", va="center", fontsize=8, color=INK)
        ax.axvline(0, **REFERENCE)
        for wall in (-free, free):
            ax.axvline(wall, color=TEAL, linewidth=2, alpha=0.5)
        ax.set_yticks(range(len(rows)), [str(n) if n else "real" for n in rows])
        ax.set_xlim(-1.15 * free, 1.15 * free)
        ax.set_ylim(-0.6, len(rows) - 0.4)
        dress(ax, "distance from the middle (the upper arm is 1)", "bins", self.title)


class BestReturns(NamedTuple):
    """The best return for each number of bins, and with continuous actions.

    Attributes:
        bins: the numbers of bins.
        width: of the container.
        title: the text above the axes.
    """

    bins: Sequence[int]
    width: float = WIDTH
    title: str = "the best possible return"

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the points."""
        best = [best_return(n, self.width) for n in self.bins]
        ax.plot(self.bins, best, color="#b0b0b0", linewidth=1, zorder=1)
        for n, top in zip(self.bins, best, strict=True):
            ax.plot(n, top, "o", color=COLOURS.get(name(n), "#7f7f7f"), markersize=6)
        ax.axhline(best_return(None), label="continuous", color=COLOURS[CONTINUOUS], linewidth=1.4)
        ax.set_ylim(min(3.6, min(best) - 0.2), 5.1)
        ax.set_xticks(self.bins)
        dress(ax, "bins for each joint", "best return", self.title)


class Landscape(NamedTuple):
    """The reward of an action, and policies as densities below it.

    Attributes:
        policies: by label, μ and σ.
        pays: the reward.
        title: the text above the axes.
        ends: of the x axis.
    """

    policies: Mapping[str, tuple[float, float]]
    pays: Reward = reward
    title: str = ""
    ends: tuple[float, float] = (-2.5, 2.5)

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the reward as a line, and each policy as a filled curve,."""
        actions = np.linspace(*self.ends, 801)
        ax.plot(actions, self.pays(actions), label="reward", color=INK, linewidth=1.3)
        n = max(len(self.policies) - 1, 1)
        for i, (label, (mean, spread)) in enumerate(self.policies.items()):
            heights = np.minimum(density(actions, mean, spread), 4.4)
            ax.fill_between(actions, -2.6, -2.6 + 1.5 * heights, color=shade(i / n), alpha=0.35, label=label)
        ax.set_ylim(-2.7, 4.6)
        dress(ax, "action a: where the box is let go", "reward", self.title)


class Slope(NamedTuple):
    """J over the mean of a Gaussian policy, with the slope at one mean as estimated from actions.

    Attributes:
        mean: μ.
        spread: σ.
        estimate: of the slope.
        title: the text above the axes.
    """

    mean: float
    spread: float
    estimate: float
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the curve and two lines with the slopes."""
        means = np.linspace(-2.5, 2.5, 101)
        ax.plot(means, [value(m, self.spread) for m in means], color="#8a6d3b", linewidth=1.8, label="J(μ)")
        here, exact = value(self.mean, self.spread), slopes(self.mean, self.spread)[0]
        looks: tuple[tuple[float, str, dict[str, Any]], ...] = (
            (self.estimate, "slope from actions and scores", {"color": BOX_RED, "linewidth": 3.0, "alpha": 0.6}),
            (exact, "slope by finite differences", {"color": INK, "linestyle": "dashed", "linewidth": 1.2}),
        )
        for tangent, label, look in looks:
            ax.plot(self.mean + np.array([-0.5, 0.5]), here + tangent * np.array([-0.5, 0.5]), label=label, **look)
        ax.plot(self.mean, here, "o", color=INK, markersize=5)
        ax.set_ylim(-2.3, 4.3)
        dress(ax, "mean μ of the policy", "J(μ), the expected reward", self.title)


class Noise(NamedTuple):
    """The standard deviation of the estimated slope, for every baseline.

    Attributes:
        policies: by label, μ and σ.
        title: the text above the axes.
    """

    policies: Mapping[str, tuple[float, float]]
    title: str = "noise of the estimate, for every baseline"

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw a line for each policy on `ax`, with a dot at b = J, and return the axes."""
        ax = axes_or_new(ax)
        z = np.linspace(-6.0, 6.0, 4_001)
        weights = density(z, 0.0, 1.0) * (z[1] - z[0])
        baselines = np.linspace(-2.0, 6.0, 81)
        n = max(len(self.policies) - 1, 1)
        for i, (label, (mean, spread)) in enumerate(self.policies.items()):
            paid, of_mean = reward(mean + spread * z), z / spread

            def deviation(b: float, paid: Reals = paid, of_mean: Reals = of_mean) -> float:
                terms = (paid - b) * of_mean
                return float(np.sqrt((weights * terms**2).sum() - (weights * terms).sum() ** 2))

            line = ax.plot(baselines, [deviation(b) for b in baselines], label=label, linewidth=1.6)[0]
            line.set_color(shade(i / n))
            ax.plot(0.0, deviation(0.0), "s", color=line.get_color(), markersize=6)
            j = value(mean, spread)
            ax.plot(j, deviation(j), "o", color=line.get_color(), markersize=7)
        ax.plot([], [], "s", color=INK, label="no baseline, b = 0")
        ax.plot([], [], "o", color=INK, label="b = J")
        ax.set_ylim(0, None)
        dress(ax, "baseline b", "standard deviation of one estimate", self.title)
        if place.alone:
            add_legend(ax)
        return ax


class Climbs(NamedTuple):
    """How much policies get while they learn: the mean over runs, with its 95 % band.

    Attributes:
        climbed: by label, the runs.
        title: the text above the axes.
        strokes: the number of the stroke of each, in order.
        top: the best possible reward.
    """

    climbed: Mapping[str, Climbed]
    title: str = ""
    strokes: Sequence[int] = (4, 5)
    top: float = 4.0

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw a line for each label."""
        for number, (label, runs) in zip(self.strokes, self.climbed.items(), strict=False):
            n = len(runs.values) // 40 or 1
            blocks = runs.values[: len(runs.values) // n * n].reshape(-1, n, runs.values.shape[1]).mean(axis=1)
            x, mean = n * (0.5 + np.arange(len(blocks))), blocks.mean(axis=1)
            error = 1.98 * blocks.std(axis=1, ddof=1) / np.sqrt(blocks.shape[1])
            colour = stroke(number).color
            ax.plot(x, mean, color=colour, linestyle=stroke(number).linestyle, linewidth=1.6, label=label)
            ax.fill_between(x, mean - error, mean + error, color=colour, alpha=0.16, linewidth=0)
        ax.axhline(self.top, label="optimum", **REFERENCE)
        ax.set_ylim(-2.2, self.top + 0.4)
        dress(ax, "updates", "mean reward", self.title)


class Map(NamedTuple):
    """The learned values over the places of the wrist, and the way that the agent takes.

    Attributes:
        values: shape (n, n): over y and x.
        way: shape (n_steps, 2): the places of the wrist.
        title: the text above the axes.
    """

    values: Reals
    way: Any
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the map."""
        ends = (-REACH, REACH, -REACH, REACH)
        ax.imshow(self.values, origin="lower", extent=ends, cmap="viridis", vmin=0.0, vmax=4.0, aspect="equal")
        ax.plot(*np.transpose(self.way), color="white", linewidth=2.4)
        ax.plot(*np.transpose(self.way), "o-", color=BOX_RED, linewidth=1.2, markersize=3)
        ax.set_ylim(-0.6, REACH)
        dress(ax, "wrist, x", "wrist, y", self.title)

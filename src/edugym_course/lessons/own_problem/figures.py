"""The figures of lesson 10."""

from collections.abc import Mapping, Sequence
from itertools import cycle
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.exact.values import Values
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.panel import With, on_axes
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import (
    PALE_AMBER,
    PALE_BLUE,
    PALE_GREEN,
    REFERENCE,
    SOFT_REFERENCE,
    Stroke,
    dress,
    plot_with_band,
    stroke,
)
from edugym.experiments.results.statistics import by_point, mean_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals, named_actions
from edugym.rendering.palette import INK, RED, SHADE
from edugym_course.lessons.own_problem.bedroom import SLEEP, clock
from edugym_course.lessons.own_problem.exact import best_policy, solve, what_happens
from edugym_course.lessons.own_problem.morning import Morning, WithBonus

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ACTION_COLOURS = ("#dfe6ee", PALE_AMBER, RED, PALE_BLUE, PALE_GREEN, "#cdb4db", "#d9c7a3")
"""Of the first, second, ... action on a map of a policy; after the last the first comes again."""
MOST_CELLS = 40
"""How many places a map has on each side at most."""


REWARD_STROKES = (stroke(0), stroke(5), Stroke("#8c564b", (0, (2, 1))), stroke(6), Stroke("#117733", "dashdot"))
"""The looks of rewards from which Q-learning learns: its own for the one that was meant, and those of no method."""


class PolicyMap(NamedTuple):
    """The best action in every state, for states that are one number or two.

    The first number of a state is the place on the x axis, the second the place on the y axis. A cell has the colour
    and the first letter of its action; where several are best it has all of their letters.

    Attributes:
        values: the values, from planning.
        names: the names of the actions, in order.
        title: the text above the axes.
        x_label: the meaning of the first number.
        y_label: the meaning of the second number.
        x_ticks: the names of the places on the x axis; None numbers them.
        y_ticks: the names of the places on the y axis; None numbers them.
    """

    values: Values
    names: Sequence[str]
    title: str = ""
    x_label: str = "first number of the state"
    y_label: str = "second number of the state"
    x_ticks: Sequence[str] | None = None
    y_ticks: Sequence[str] | None = None

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the map."""
        from matplotlib.patches import Rectangle
        from matplotlib.ticker import MaxNLocator

        model, policy = self.values.model, self.values.greedy_policy()
        letters = initials(self.names)
        used: set[int] = set()
        xs, ys = [0], [0]
        for s, state in enumerate(model.states):
            if model.terminal[s]:
                continue
            x, y = state if isinstance(state, tuple) else (state, 0)
            best = np.flatnonzero(policy[s]).tolist()
            used |= {*best}
            for part, action in enumerate(best):
                colour = ACTION_COLOURS[action % len(ACTION_COLOURS)]
                corner = (x - 0.5 + part / len(best), y - 0.5)
                ax.add_patch(Rectangle(corner, 1 / len(best), 1, facecolor=colour, edgecolor="white", linewidth=0.8))
            ax.text(x, y, "/".join(letters[a] for a in best), ha="center", va="center", fontsize=8, color=INK)
            xs.append(x)
            ys.append(y)
        ax.set_xlim(min(xs) - 0.5, max(xs) + 0.5)
        ax.set_ylim(min(ys) - 0.5, max(ys) + 0.5)
        ax.set_facecolor(SHADE)
        for action, name in enumerate(self.names):
            colour = ACTION_COLOURS[action % len(ACTION_COLOURS)]
            ax.add_patch(Rectangle((0, 0), 0, 0, facecolor=colour, label=f"{letters[action]}: {name}"))
        dress(ax, self.x_label, self.y_label if max(ys) > min(ys) else "", self.title)
        ax.xaxis.set_major_locator(MaxNLocator(integer=True))
        ax.yaxis.set_major_locator(MaxNLocator(integer=True))
        if self.x_ticks is not None:
            ax.set_xticks(range(len(self.x_ticks)), self.x_ticks, rotation=45)
        if self.y_ticks is not None:
            ax.set_yticks(range(len(self.y_ticks)), self.y_ticks)
        elif max(ys) == min(ys):
            ax.set_yticks([])


def can_be_drawn(values: Values) -> bool:
    """Whether the states are one whole number each or two, and few enough for a map."""
    parts = [state if isinstance(state, tuple) else (state, 0) for state in values.model.states]
    if not all(len(part) == 2 and all(isinstance(x, int) for x in part) for part in parts):
        return False
    return all(np.ptp([part[k] for part in parts]) < MOST_CELLS for k in range(2))


def initials(names: Sequence[str]) -> list[str]:
    """Return a short, different name for each action: its first letter, or its number where letters are the same."""
    letters = [name[:1] for name in names]
    return letters if len({*letters}) == len(names) else [str(k) for k in range(len(names))]


def names_of(mdp: Any) -> list[str]:
    """Return the names of the actions, or their numbers."""
    n = int(mdp.action_space.n)
    given = {action: name for name, action in named_actions(mdp).items()}
    return [str(given.get(action, action)) for action in range(n)]


def morning_map(mdp: Any, title: str = "") -> PolicyMap:
    """Return the map of the best policy of a morning: time to the right, depth of sleep upwards."""
    times = [clock(time, mdp.length) for time in range(mdp.length)]
    return PolicyMap(solve(mdp), names_of(mdp), title, "time", "", times, SLEEP)


def policies(tasks: Mapping[str, Any]) -> Sheet:
    """Return the maps of the best policies for several rewards, two in a row."""
    panels = [morning_map(mdp, title) for title, mdp in tasks.items()]
    return Sheet("policies", [panels[k : k + 2] for k in range(0, len(panels), 2)])


class Bands(NamedTuple):
    """A line for each reward with its 95 % interval, over an axis of budgets.

    Attributes:
        x: shape (n,): the budgets.
        measured: by label, shape (n, n_repetitions).
        title: the text above the axes.
        x_label: the label of the x axis.
        y_label: the label of the y axis.
        optimum: the best possible value, a dashed line; None draws none.
    """

    x: Sequence[float]
    measured: Mapping[str, Reals]
    title: str = ""
    x_label: str = ""
    y_label: str = ""
    optimum: float | None = None

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the lines."""
        x = np.asarray(self.x, float)
        for look, (label, values) in zip(cycle(REWARD_STROKES), self.measured.items(), strict=False):
            plot_with_band(ax, look, x, by_point(values), label)
        if self.optimum is not None:
            ax.axhline(self.optimum, label="optimum", **REFERENCE)
        ax.set_xscale("log", base=2)
        ax.set_xticks(x, [f"{value:g}" for value in x], rotation=45)
        ax.minorticks_off()
        dress(ax, self.x_label, self.y_label, self.title)


class Compared(NamedTuple):
    """The exact value of what each method has learned: the mean over runs with its 95 % interval.

    Attributes:
        measured: by label of the method, shape (n_repetitions,).
        title: the text above the axes.
        optimum: the best possible value, a dashed line.
    """

    measured: Mapping[str, Reals]
    title: str = ""
    optimum: float | None = None

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw a dot for each method."""
        for i, values in enumerate(self.measured.values()):
            interval = mean_interval(values)
            ax.plot(i, interval.estimate, "o", color=stroke(i).color, markersize=7)
            ax.plot([i, i], [interval.low, interval.high], color=stroke(i).color, linewidth=2)
        if self.optimum is not None:
            ax.axhline(self.optimum, label="optimum", **REFERENCE)
        ax.set_xlim(-0.6, len(self.measured) - 0.4)
        dress(ax, "", "expected return", self.title)
        ax.set_xticks(range(len(self.measured)), self.measured, rotation=20)


def race(
    results: Results, learned: Mapping[str, Reals], optimum: float, random: float, title: str = "at the end"
) -> Sheet:
    """Return learning curves, and beside them, under a title, what the policies at the end are worth."""

    def of_random_actions(ax: "Axes") -> None:
        ax.axhline(random, label="random actions", **SOFT_REFERENCE)

    curves = With(Curves(results, "learning", optimum=optimum), of_random_actions)
    return Sheet("learned", [[curves, Compared(learned, title, optimum)]])


def weights_sheet(ring: float = 4.0, late: float = 10.0, bonus: float = 0.0) -> Sheet:
    """Return the map of the best policy for some weights, and above it what happens on average.

    Args:
        ring: what a ring costs.
        late: what oversleeping costs.
        bonus: what is paid each time she wakes.
    """
    mdp = Morning(ring=float(ring), late=float(late))
    night = what_happens(mdp, best_policy(WithBonus(mdp, float(bonus))))
    happens = f"rings {night.rings:.1f}, wakings {night.wakings:.1f}, oversleeps {night.late:.0%}"
    told = f"sleep {night.sleep:.0f} min, {happens}"
    return Sheet("weights", [[morning_map(WithBonus(mdp, float(bonus)), told)]])

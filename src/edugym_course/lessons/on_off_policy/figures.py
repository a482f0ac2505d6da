"""The figures of lesson 2."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.envs.roadrunner import Roadrunner
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import ALONE, Place, on_axes
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import SOFT_REFERENCE, axes_or_new, dress, stroke
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import INK
from edugym_course.lessons.on_off_policy.exact import ROAD, best_run, best_soft_return, deadly_actions, soft_return_of
from edugym_course.lessons.on_off_policy.methods import (
    EPSILON,
    KINDS,
    N_STEPS,
    Maker,
    compare,
    most_frequent,
    online,
    walk,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FAST_RUN, SAFE_RUN = "fast run (4 steps)", "safe run (5 steps)"
SECOND_RUN = "second safe run (5 steps)"


class Paths(NamedTuple):
    """Paths through cells, whose colour says how dangerous they are.

    Attributes:
        danger: shape (rows, columns): a number that is written into the cell and colours it; NaN leaves it empty.
        paths: by label, the cells of a path, as (column, row).
        title: the text above the axes.
        x_label: the label of the columns.
        y_label: the label of the rows.
        most: the number that gets the darkest colour.
        numbers: whether the numbers are written into the cells.
        down: whether row 0 is at the top, as on a grid that is seen from above.
        strokes: which stroke each path has; by default the first, second, ...
    """

    danger: Reals
    paths: Mapping[str, Sequence[tuple[int, int]]]
    title: str = ""
    x_label: str = ""
    y_label: str = ""
    most: float = 3.0
    numbers: bool = True
    down: bool = False
    strokes: Sequence[int] = (0, 1, 2)

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw cells and paths."""
        from matplotlib.patheffects import withStroke

        rows, columns = self.danger.shape
        ax.imshow(self.danger, cmap="Reds", vmin=0, vmax=2 * self.most, origin="upper" if self.down else "lower")
        ax.set_aspect("equal" if self.down else "auto")
        if self.numbers:
            for (row, column), number in np.ndenumerate(self.danger):
                if not np.isnan(number):
                    ax.text(
                        column - 0.44,
                        row + 0.24,
                        f"{number:.0f}",
                        ha="left",
                        va="center",
                        fontsize=7,
                        color=INK,
                        zorder=4,
                        path_effects=[withStroke(linewidth=2.0, foreground="white")],  # lines run through it
                    )
        for i, (label, path) in zip(self.strokes, self.paths.items(), strict=False):
            shift = 0.11 * (i - (len(self.paths) - 1) / 2)  # so that no path hides another
            x, y = np.array(path, float).T + shift
            color, linestyle = stroke(i)
            ax.plot(x, y, color=color, linestyle=linestyle, linewidth=1.8, label=label)
            ax.plot(x, y, "o", color=color, markersize=5)
        ax.set_xticks(np.arange(columns))
        ax.set_yticks(np.arange(rows))
        ax.set_xticks(np.arange(columns + 1) - 0.5, minor=True)
        ax.set_yticks(np.arange(rows + 1) - 0.5, minor=True)
        ax.grid(which="minor", color="white", linewidth=1)
        ax.tick_params(which="minor", length=0)
        dress(ax, self.x_label, self.y_label, self.title)


def learning_curves(
    results: Results, task: Roadrunner = ROAD, epsilon: float | None = EPSILON, title: str = ""
) -> Sheet:
    """Return a panel of greedy episodes and one of training episodes, with what is possible on this road.

    Args:
        results: what `compare` returned.
        task: the road, for the two lines of what is possible.
        epsilon: ε of the training; None if it changes, so that there is no line for it.
        title: what is added to the titles.
    """
    model = finite_model(task)
    best = best_soft_return(model, 0.0)
    best_soft = None if epsilon is None else best_soft_return(model, epsilon)
    lowest = 1.6 * (best_soft_return(model, EPSILON) if best_soft is None else best_soft)
    after = f", {title}" if title else ""
    greedy = Curves(results, f"greedy{after}", optimum=best, y_range=(best - 2.5, best + 0.5))
    exploring = Curves(
        results,
        f"while exploring{after}",
        column="training_return",
        optimum=best,
        soft_optimum=best_soft,
        y_range=(min(lowest, best - 2.5), best + 0.5),
    )
    return Sheet("on_off_policy", [[greedy, exploring]])


class Switch(Lines):
    """Lines, and the ε at which the best of them changes."""

    __slots__ = ()

    @property
    def change(self) -> float:
        """The ε from which on the safe run is the better one: where the two lines cross."""
        fast, safe = (self.lines[run] for run in (FAST_RUN, SAFE_RUN))
        return float(np.interp(0.0, safe - fast, self.x))

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the lines on `ax`, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        ax.axvline(self.change, label=f"the change, ε = {self.change:.3f}", **SOFT_REFERENCE)
        super().draw(ax, place)
        ax.lines[-1].set_zorder(3)  # the best one lies on the other two
        return ax


def switch_lines(model: FiniteModel) -> Switch:
    """Return the exact returns of the fast and of the safe run, and the best ε-soft return, against ε."""
    epsilons = np.linspace(0.0, EPSILON, 41)
    return Switch(
        epsilons,
        {
            FAST_RUN: np.array([soft_return_of(model, epsilon, 0.01) for epsilon in epsilons]),
            SAFE_RUN: np.array([soft_return_of(model, epsilon, EPSILON) for epsilon in epsilons]),
        },
        "what each run is worth when it slips",
        "ε",
        "expected return",
        {"best ε-soft policy": np.array([best_soft_return(model, epsilon) for epsilon in epsilons])},
    )


def in_the_plane() -> Paths:
    """Return position and speed as a map: the deadly actions in each state, and the best runs through it.

    The second safe run begins like the fast one, and goes on from its third state as is best for a runner that slips.
    """
    fast = best_run(0.0)
    runs = {
        FAST_RUN: fast,
        SAFE_RUN: best_run(EPSILON),
        SECOND_RUN: [*fast[:2], *best_run(EPSILON, start=fast[2])],
    }
    return Paths(
        deadly_actions(ROAD),
        {label: [(state.x, state.dx) for state in states] for label, states in runs.items()},
        "in how many of 3 actions a runner falls or stalls",
        "position",
        "speed",
    )


def shortfall_against_epsilon(
    epsilons: Sequence[float] = (0.005, 0.01, 0.02, 0.03, 0.05, 0.075, 0.1), *, repetitions: int = 10, **how: Any
) -> Against:
    """Return how much less than the best ε-soft policy the methods earn while they explore, against ε."""
    model = finite_model(ROAD)
    best = [best_soft_return(model, epsilon) for epsilon in epsilons]
    runs = [compare(epsilon=epsilon, repetitions=repetitions, **how) for epsilon in epsilons]
    return Against(
        epsilons,
        {method: [online(run, method) - most for run, most in zip(runs, best, strict=True)] for method in KINDS},
        "what the methods lose while exploring",
        "ε",
        "return, less the best possible",
        {"best ε-soft policy": np.zeros(len(epsilons))},
    )


def online_against_rate(
    rates: Sequence[float] = (0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7), *, repetitions: int = 10, **how: Any
) -> Against:
    """Return what the methods earn while they explore against the learning rate: Figure 6.3 of the book, on a road."""
    runs = [compare(learning_rate=rate, repetitions=repetitions, **how) for rate in rates]
    best = best_soft_return(finite_model(ROAD), EPSILON)
    return Against(
        rates,
        {method: [online(run, method) for run in runs] for method in KINDS},
        "second half of training",
        "learning rate α",
        "return (while exploring)",
        {"best ε-soft policy": np.full(len(rates), best)},
        log=True,
    )


def cliff_figure(results: Results) -> Sheet:
    """Return the greedy walks on CliffWalking that most runs end with, and the returns of training."""
    grid = np.zeros((4, 12))
    grid[3, 1:11] = 1.0
    return Sheet(
        "cliff",
        [
            [
                Paths(
                    grid,
                    {
                        method: most_frequent([walk(agent) for agent in results.complete_agents(method).values()])
                        for method in KINDS
                    },
                    "greedy walks on CliffWalking",
                    "column",
                    "row",
                    most=1.0,
                    numbers=False,
                    down=True,
                ),
                Curves(results, "while exploring", column="training_return", optimum=-13.0, y_range=(-100.0, 0.0)),
            ]
        ],
    )


def race(own: Mapping[str, Maker], *, repetitions: int = 10, n_steps: int = N_STEPS, **how: Any) -> Sheet:
    """Return the lesson's figure with methods of the reader's own beside its three."""
    results = compare(own=own, repetitions=repetitions, n_steps=n_steps, **how)
    return learning_curves(results)._replace(name="race")

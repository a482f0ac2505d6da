"""The figures of lesson 4."""

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.envs.catch import Fall
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import ALONE, Place, With, on_axes
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import (
    BLACK,
    BROWN,
    DEEP_BLUE,
    PURPLE,
    REFERENCE,
    SKY_BLUE,
    VERMILION,
    Stroke,
    add_legend,
    dress,
    stroke,
)
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import INK
from edugym_course.lessons.dimensionality.methods import (
    GENERAL,
    LINEAR,
    NETWORK,
    NUMBERS,
    OFFSET,
    PIXELS,
    POSITIONS,
    TABLE,
    TILES,
    learn,
    network,
    on_board,
    pixels,
    play_on,
    seen,
    table,
)
from edugym_course.lessons.dimensionality.networks import (
    DQN_GRID,
    DQN_IMAGE,
    OUR_PPO,
    PPO_DARK,
    PPO_GRID,
    PPO_IMAGE,
    STORED,
)
from edugym_course.lessons.dimensionality.sharing import COLUMN, SMALL, labels
from edugym_course.lessons.dimensionality.sharing import STORED as SHARED
from edugym_course.lessons.dimensionality.sizes import different_boards, n_weights, rows_of_table
from edugym_course.lessons.dimensionality.tasks import COLUMNS, ROWS, TRAINED, WITHHELD
from edugym_course.lessons.dimensionality.triad import w_to_2w

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LOOKS: Mapping[str, Stroke] = {
    TABLE: stroke(0),
    PIXELS: stroke(0),
    POSITIONS: Stroke(SKY_BLUE, "solid"),
    LINEAR: stroke(1),
    OFFSET: stroke(2),
    TILES: stroke(3),
    NETWORK: stroke(5),
    NUMBERS: Stroke(VERMILION, (0, (1, 1))),
    SMALL: stroke(6),
    COLUMN: Stroke(BROWN, "solid"),
    DQN_GRID: Stroke(VERMILION, "solid"),
    DQN_IMAGE: Stroke(VERMILION, "solid"),
    PPO_GRID: stroke(6),
    OUR_PPO: Stroke(PURPLE, "solid"),
    PPO_IMAGE: stroke(6),
    PPO_DARK: Stroke("#8c8c8c", (0, (1, 1))),
    "dense table, image": Stroke("#08306b", "solid"),
    "dense table, grid": Stroke(DEEP_BLUE, (0, (6, 1.5))),
    "dense table, positions": Stroke(SKY_BLUE, (0, (2, 1))),
    "boards that occur": Stroke(PURPLE, (0, (1, 2))),
    "weights of a network (64 hidden units)": Stroke(VERMILION, (0, (6, 1.5))),
}
OWN = (Stroke(BLACK, "solid"), Stroke("#666600", (0, (6, 1.5))), Stroke(PURPLE, (0, (2, 1))))
"""The strokes of methods that are not in `LOOKS`, in their order."""
FEW = 3
CAR_RANGE = (-1_030.0, -100.0)
ARROWS = ("←", "•", "→")
CAUGHT, MISSED = "#cfe8d5", "#f4c7c3"


def looks_of(methods: Iterable[str]) -> dict[str, Stroke]:
    """Return the stroke of each method."""
    methods = [*methods]
    own = [method for method in methods if method not in LOOKS]
    return {method: LOOKS.get(method) or OWN[own.index(method) % len(OWN)] for method in methods}


class Learning(Curves):
    """Learning curves of which a few runs are drawn one by one."""

    __slots__ = ()

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the curves on `ax`, by default in a new figure, and return the axes."""
        ax = super().draw(ax, place)
        for (method, look), band in zip(looks_of(self.shown).items(), [*ax.collections], strict=False):
            steps, values = self.points(method)
            if values.shape[1] <= FEW:  # too few runs for an interval: each is drawn
                band.remove()
                ax.plot(steps, values, color=look.color, linewidth=0.7, alpha=0.6)
        if self.results.methods[0] in (POSITIONS, NETWORK) and len(self.results.methods) == 2:
            ax.get_lines()[0].set(linewidth=4.0, alpha=0.6)  # the second line may lie on it
            if place.alone:
                add_legend(ax)
        return ax


def learning(results: Results, title: str, **how: Any) -> Learning:
    """Return learning curves in the colours of the lesson; other arguments as of `Curves`."""
    how = {"optimum": 1.0, "y_range": (-1.05, 1.05), **how}
    return Learning(results, title, strokes=looks_of(how.get("methods", results.methods)), **how)


class Dots(NamedTuple):
    """For each method, the mean return on balls from the columns of training and from those that were withheld.

    Attributes:
        tests: by method, the returns of every run by column, shape (COLUMNS, n_runs).
        title: the text above the axes.
    """

    tests: Mapping[str, Reals]
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw both."""
        for row, (by_column, look) in enumerate(zip(self.tests.values(), looks_of(self.tests).values(), strict=True)):
            for at, columns, filled in ((row - 0.14, TRAINED, True), (row + 0.14, WITHHELD, False)):
                found = mean_interval(by_column[[*columns]].mean(axis=0))
                ax.plot([max(found.low, -1.0), min(found.high, 1.0)], [at, at], color=look.color, linewidth=1.4)
                ax.plot(found.estimate, at, "o", color=look.color, markerfacecolor=look.color if filled else "white")
        ax.plot([], [], "o", color=INK, label=f"balls from columns {_listed(TRAINED)} (training)")
        ax.plot([], [], "o", color=INK, markerfacecolor="white", label=f"from columns {_listed(WITHHELD)} (withheld)")
        ax.axvline(1.0, label="optimum", **REFERENCE)
        ax.set_xlim(-1.08, 1.08)
        ax.set_yticks(range(len(self.tests)), [*self.tests])
        ax.invert_yaxis()
        dress(ax, "return (greedy)", "", self.title)


class PolicyMap(NamedTuple):
    """What an agent does in each state with the ball in one row, and whether it then catches the ball.

    The paddle's column is on the horizontal axis, so that an arrow points to the cell where the paddle goes.

    Attributes:
        agent: the agent.
        what: what it sees, as in `methods.GENERAL`.
        ball_y: the row of the ball.
        title: the text above the axes.
    """

    agent: Any
    what: str
    ball_y: int
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the arrows."""
        from matplotlib.patches import Rectangle

        rng = np.random.default_rng(0)
        for ball in range(COLUMNS):
            for paddle in range(COLUMNS):
                state = Fall(ball, self.ball_y, paddle)
                action, caught = play_on(self.agent, self.what, state, rng)
                colour = CAUGHT if caught else MISSED
                ax.add_patch(Rectangle((paddle - 0.48, ball - 0.48), 0.96, 0.96, facecolor=colour, edgecolor="white"))
                ax.text(paddle, ball, ARROWS[action], ha="center", va="center", fontsize=11, color=INK)
        for column in WITHHELD:
            frame = Rectangle((-0.5, column - 0.5), COLUMNS, 1.0, fill=False, edgecolor=INK, linewidth=1.6)
            ax.add_patch(frame)
        ax.set(xlim=(-0.6, COLUMNS - 0.4), ylim=(-0.6, COLUMNS - 0.4))
        ax.set_xticks(range(COLUMNS))
        ax.set_yticks(range(COLUMNS))
        dress(ax, "column of the paddle", "column of the ball", self.title)


def _listed(columns: Sequence[int]) -> str:
    return ", ".join(map(str, columns))


def table_and_network(panels: Mapping[str, Results]) -> Sheet:
    """Return a panel of learning curves for each kind of observation."""
    curves = [learning(results, title) for title, results in panels.items()]
    half = -(-len(curves) // 2)
    return Sheet("dimensionality", [curves[:half], curves[half:]] if len(curves) > 3 else [curves])


def boards_figure(
    columns: int = 5,
    levels: int = 0,
    *,
    epsilon: float = 0.1,
    alpha: float = 0.5,
    gamma: float = 0.9,
    n_steps: int = 20_000,
    repetitions: int = 10,
) -> Sheet:
    """Return the learning curve of a table on a board of some size, and with a noisy pixel on the usual board."""
    from edugym.agents.strategies import EpsilonGreedy

    make = table(exploration=EpsilonGreedy(epsilon), learning_rate=alpha, discount=gamma)
    how: dict[str, Any] = {"n_steps": n_steps, "repetitions": repetitions, "jobs": 1}
    size = learn(on_board(columns, "vectorised"), TABLE, make, **how)
    noise = learn(pixels(levels=levels, capacity=60_000), TABLE, make, **how)
    settings = f"ε = {epsilon:g}, α = {alpha:g}, γ = {gamma:g}"
    titles = (
        f"{columns} columns, {2 * columns} rows, no noise\n{settings}",
        f"one pixel of {levels} levels\n{settings}" if levels else f"no noise\n{settings}",
    )
    return Sheet("boards", [[learning(one, title) for one, title in zip((size, noise), titles, strict=True)]])


def network_figure(
    hidden: int, sigma: float, *, alpha: float, gamma: float, epsilon: float, n_steps: int = 5_000, repetitions: int = 3
) -> Sheet:
    """Return the learning curve of DQN with some settings, under noise."""
    from edugym.agents.strategies import EpsilonGreedy

    make = network(hidden=hidden, learning_rate=alpha, discount=gamma, exploration=EpsilonGreedy(epsilon))
    results = learn(seen(sigma=sigma), NETWORK, make, n_steps=n_steps, points=10, repetitions=repetitions, jobs=1)
    title = f"{hidden} hidden units, σ = {sigma:g}\nε = {epsilon:g}, α = {alpha:g}, γ = {gamma:g}"
    return Sheet("network", [[learning(results, title)]])


def withheld(tests: Mapping[str, Reals], own: Mapping[str, Reals] | None = None) -> Sheet:
    """Return the test on withheld columns, the reader's own agents last."""
    both = {**tests, **(own or {})}
    return Sheet("generalisation", [[Dots(both, f"trained with balls from columns {_listed(TRAINED)}")]])


def policy_maps(general: Mapping[str, Results], labels: Sequence[str], ball_y: int = 5, run: int = 0) -> Sheet:
    """Return what some agents of `methods.generalise` do, with the ball in one row."""
    maps = [PolicyMap(general[label].agents[label][run], GENERAL[label][0], ball_y, label) for label in labels]
    return Sheet("policies", [maps])


def ever_learned(agent: Any) -> Any:
    """Return, for each pixel, whether any weight from it has ever had a gradient other than 0, shape (ROWS, COLUMNS).

    Adam's average of the squared gradients is 0 only where all of them were.
    """
    return (agent.square.first[:-1] > 0.0).any(axis=1).reshape(ROWS, COLUMNS)


def size_sheet(sizes: Sequence[int] = (3, 4, 5, 6, 7, 8, 9, 10)) -> Sheet:
    """Return the sizes of tables and of a network, as powers of ten, against the size of the board."""
    dense = {
        f"dense table, {name}": np.array([math.log10(rows_of_table(kind, 2 * n, n)) for n in sizes])
        for kind, name in (("rgb", "image"), ("grid", "grid"), ("vectorised", "positions"))
    }
    occur = np.array([math.log10(different_boards(2 * n, n)[1]) for n in sizes])
    weights = np.array([math.log10(n_weights(2 * n, n)) for n in sizes])
    lines = {**dense, "boards that occur": occur, "weights of a network (64 hidden units)": weights}
    names = "columns (and twice as many rows)", "power of ten"
    panel = Lines(np.array(sizes, float), lines, "how large?", *names, log=True, strokes=looks_of(lines))
    return Sheet("table_sizes", [[panel]])


def costs_figure(costs: Mapping[int, Mapping[str, float]]) -> Sheet:
    """Return the steps that a table and a network need, against the size of the board (`methods.steps_to_solve`)."""
    sizes = [*costs]
    lines = {label: np.array([costs[n][label] for n in sizes]) for label in (TABLE, NETWORK)}
    names = "columns (and twice as many rows)", "training steps to a return of 0.99"
    title = "cost against the size of the board"
    return Sheet("costs", [[Lines(np.array(sizes, float), lines, title, *names, strokes=looks_of(lines))]])


def growth(gamma: float = 0.9, alpha: float = 0.1, copy_every: int = 20, n_updates: int = 100) -> Sheet:
    """Return the weight of the deadly triad, with one of its three parts left out, or softened by an old target."""
    lines = {
        "the triad": w_to_2w(n_updates, gamma, alpha),
        f"target copied every {copy_every}": w_to_2w(n_updates, gamma, alpha, copy_every),
        "both steps, as on-policy": w_to_2w(n_updates, gamma, alpha, whole_way=True),
    }
    title = f"γ = {gamma:g}, α = {alpha:g}"
    names = "updates", "weight w (should become 0)"
    panel = Lines(np.arange(n_updates + 1.0), lines, title, *names, log=True, strokes=looks_of(lines))
    return Sheet("triad", [[panel]])


def stored_networks(live: Mapping[str, Any] | None = None) -> Sheet:
    """Return the stored learning curves of all networks, and those of runs made just now as black lines.

    Args:
        live: by label, the `Run`.
    """
    results = STORED.load()

    def single_runs(ax: "Axes") -> None:
        for label, run in (live or {}).items():
            ax.plot(run.steps, run.returns, color=BLACK, linewidth=1.0, label=label)

    grid = learning(results, "grid (50 numbers)", methods=[DQN_GRID, PPO_GRID, OUR_PPO])
    image = learning(results, "image (150)", methods=[DQN_IMAGE, PPO_IMAGE, PPO_DARK])
    return Sheet("networks", [[grid, With(image, single_runs)]])


def shared_by_column(label: str) -> Reals:
    """Return the stored returns of a network by column, shape (COLUMNS, n_repetitions)."""
    results = SHARED.load()
    return np.array([results.final(name) for name in labels(label)])


def car_figure(results: Results) -> Sheet:
    """Return the training returns of the car."""
    how: dict[str, Any] = {"column": "training_return", "y_label": "mean return of the episodes"}
    return Sheet("car", [[learning(results, "MountainCar", optimum=None, y_range=CAR_RANGE, **how)]])

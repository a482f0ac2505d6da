"""The figures of lesson 5."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import With, on_axes
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import (
    DEEP_BLUE,
    PALE_AMBER,
    PALE_BLUE,
    PALE_GREEN,
    REFERENCE,
    SOFT_REFERENCE,
    VERMILION,
    dress,
    stroke,
)
from edugym.experiments.results.statistics import Interval, mean_interval
from edugym.experiments.results.tables import Results
from edugym.rendering.palette import INK, SHADE, WHITE
from edugym_course.lessons.memory.network import WINDOWS
from edugym_course.lessons.memory.players import (
    DISCOUNT,
    EPSILON,
    LEARNING_RATE,
    joined,
    late,
    learn_all,
    learn_on,
    name,
)
from edugym_course.lessons.memory.windows import (
    DOORS,
    Moment,
    action_law,
    best_play,
    best_values,
    never_errs,
    smallest_window,
    twins,
    window_law,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DOOR_COLOURS = (PALE_BLUE, PALE_AMBER, PALE_GREEN)
FRAMES_ALONE, WITH_ACTIONS = "observations alone", "observations and actions"
BEST = "best play with this window"
STEPS = 100_000
"""The training steps of the lesson's runs."""


def with_best(curves: Curves, best: Mapping[str, float]) -> With:
    """Return learning curves, and for each method a dotted line in its colour: the best play that its window allows."""

    def best_play_of_each(ax: "Axes") -> None:
        for i, method in enumerate(curves.results.methods):
            ax.axhline(best[method], **{**SOFT_REFERENCE, "color": stroke(i).color, "linewidth": 1.1})
        ax.plot([], [], label=BEST, **SOFT_REFERENCE)

    return With(curves, best_play_of_each)


class Walk(NamedTuple):
    """Perfect play as two rows of cells, observations and actions, with the window on them.

    Attributes:
        doors: the right doors, one for each place of the longest corridor that is shown.
        step: the present step, from 0; later steps are not shown.
        k: the number of observations in the window; 0 shows none.
        actions: whether the window also shows the actions between them.
        title: the text above the axes.
        pointing: whether arrows point to where the right door was marked, and where it was opened last.
    """

    doors: tuple[int, ...]
    step: int
    k: int = 0
    actions: bool = False
    title: str = ""
    pointing: bool = True

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the cells."""
        from matplotlib.patches import Polygon

        steps = [(length, p) for length in range(1, len(self.doors) + 1) for p in range(length)]
        for t, (length, p) in enumerate(steps[: self.step + 1]):
            marked = p == length - 1
            door = self.doors[p]
            self._cell(ax, t, 1.0, DOOR_COLOURS[door] if marked else SHADE, f"{door}" if marked else "–")
            now = t == self.step
            self._cell(ax, t, 0.0, WHITE if now else DOOR_COLOURS[door], "?" if now else f"{door}")
            if p == 0:
                ax.text(t - 0.42, 1.72, f"corridor {length}" if length > 1 else "1", fontsize=8, color=INK)
                ax.plot([t - 0.5, t - 0.5], [-0.5, 2.1], color=INK, linewidth=0.6)
        if self.k:
            left, right, low = self.step - self.k + 0.5, self.step + 0.5, -0.5 if self.actions else 0.52
            corners = [(left, 1.5), (right, 1.5), (right, 0.52), (right - 1, 0.52), (right - 1, low), (left, low)]
            ax.add_patch(Polygon(corners, fill=False, edgecolor=VERMILION, linewidth=2.2, zorder=5))
        length, p = steps[self.step]
        if self.pointing and p < length - 1:
            back = length - 1
            self._arrow(ax, self.step - back, 0.95, f"opened {back} steps ago")
            marked_at = p * (p + 3) // 2
            self._arrow(ax, marked_at, 1.75, f"marked {self.step - marked_at} steps ago")
        first = min(0, self.step - self.k + 1)
        ax.set_xlim(first - 0.6, len(steps) - 0.4)
        ax.set_ylim(-2.6 if self.pointing else -0.7, 2.3)
        ax.set_yticks([0, 1], ["door opened", "observation"], fontsize=8)
        ax.set_xticks(range(len(steps)))
        dress(ax, "step", "", self.title)
        ax.spines[["left", "bottom"]].set_visible(False)
        ax.tick_params(length=0)

    def _cell(self, ax: "Axes", x: float, y: float, colour: str, text: str) -> None:
        from matplotlib.patches import Rectangle

        ax.add_patch(Rectangle((x - 0.42, y - 0.38), 0.84, 0.76, facecolor=colour, edgecolor="white"))
        ax.text(x, y, text, ha="center", va="center", fontsize=9, color=INK)

    def _arrow(self, ax: "Axes", x: float, depth: float, text: str) -> None:
        """Draw an arrow from the present step back to another one, below the cells."""
        y = -0.5 - depth
        ax.plot([self.step, self.step, x], [-0.4, y, y], color=INK, linewidth=0.9)
        ax.annotate("", (x, -0.45), (x, y - 0.02), arrowprops={"arrowstyle": "->", "color": INK, "linewidth": 0.9})
        ax.text((x + self.step) / 2, y + 0.08, text, fontsize=8, ha="center", va="bottom", color=INK)


def walk_figure(doors: Sequence[int], step: int, k: int = 0, actions: bool = False, title: str = "") -> Sheet:
    """Return the picture of perfect play up to a step, with the window."""
    return Strip("walk", [[Walk(tuple(doors), step, k, actions, title)]])


class Strip(Sheet):
    """A sheet of wide, low panels."""

    __slots__ = ()

    def draw(self) -> Any:
        """Draw all panels, one below the other."""
        figure = super().draw()
        figure.set_size_inches(8.2, (2.4 if len(self.rows) == 1 else 1.9) * len(self.rows))
        return figure


def twin_figure(k: int, length: int, actions: bool = False) -> Sheet:
    """Return two moments that look the same in the window and need different doors.

    Raises:
        ValueError: the window is enough, so there are none.
    """
    pair = twins(k, length, actions)
    if pair is None:
        raise ValueError(f"k = {k} is enough for corridor {length}, so no two moments are confused")

    def shown(moment: Moment) -> Walk:
        door = [p for n in range(1, length + 1) for p in range(n)][moment.step]
        title = f"the right door is {moment.doors[door]}"
        return Walk(moment.doors, moment.step, k, actions, title, pointing=False)

    return Strip("twins", [[shown(moment)] for moment in pair])


def compare_windows(
    frames: Results, both: Results, num_doors: int = DOORS, titles: Sequence[str] = (FRAMES_ALONE, WITH_ACTIONS)
) -> Sheet:
    """Return the learning curves of windows without and with actions, with the best play that each window allows."""
    panels = []
    top = 1.1 * max(best_play(int(label[4:]), True, num_doors).value for label in both.methods)
    for results, actions, title in zip((frames, both), (False, True), titles, strict=True):
        best = {label: best_play(int(label[4:]), actions, num_doors).value for label in results.methods}
        panels.append(with_best(Curves(results, title, y_range=(0.0, top)), best))
    return Sheet("windows", [panels])


def one_window(
    k: int = 3,
    num_doors: int = DOORS,
    *,
    epsilon: float = EPSILON,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    n_steps: int = 50_000,
    repetitions: int = 10,
) -> Sheet:
    """Return the learning curves of one window, without and with actions, with the best play for each.

    Args:
        k: the number of observations.
        num_doors: the number of doors at every place.
        epsilon: ε.
        learning_rate: α.
        discount: γ.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each.
    """
    how: dict[str, Any] = {"epsilon": epsilon, "learning_rate": learning_rate, "discount": discount}
    how |= {"n_steps": n_steps, "repetitions": repetitions, "num_doors": num_doors}
    kinds = {FRAMES_ALONE: False, WITH_ACTIONS: True}
    parts = [_renamed(learn_all([k], actions, **how), label, k) for label, actions in kinds.items()]
    best = {label: best_play(k, actions and k > 1, num_doors).value for label, actions in kinds.items()}
    title = f"k = {k}, {num_doors} doors, ε = {epsilon:g}, α = {learning_rate:g}, γ = {discount:g}"
    return Sheet("one_window", [[with_best(Curves(joined(parts), title), best)]])


def window_lines(lengths: Sequence[int]) -> With:
    """Return the smallest windows of perfect play, found by trying all doors, and circles for what both laws say."""
    lines = Lines(
        np.array(lengths, float),
        {
            FRAMES_ALONE: np.array([smallest_window(length) for length in lengths], float),
            WITH_ACTIONS: np.array([smallest_window(length, actions=True) for length in lengths], float),
        },
        "perfect play through corridor L",
        "L",
        "smallest window",
    )

    def circles(ax: "Axes") -> None:
        for label, law in (("the laws", window_law), ("", action_law)):
            ax.plot(lengths, [*map(law, lengths)], "o", color=INK, fillstyle="none", markersize=7, label=label)

    return With(lines, circles)


class Worth(NamedTuple):
    """What a window is worth: without an error, at best, and as learned.

    Attributes:
        ks: the numbers of observations.
        sure: the return of perfect play through the longest corridor in which the window never errs.
        best: the return of the best play.
        learned: by label, the points: k, and the mean with its interval.
        title: the text above the axes.
        top: the upper end of the y axis.
    """

    ks: Sequence[int]
    sure: Sequence[float]
    best: Sequence[float]
    learned: Mapping[str, Sequence[tuple[int, Interval]]]
    title: str
    top: float

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw lines and points."""
        ax.step(
            [*self.ks, self.ks[-1] + 0.6],
            [*self.sure, self.sure[-1]],
            where="post",
            label="without any error (the law)",
            **REFERENCE,
        )
        ax.plot(self.ks, self.best, label=BEST, **SOFT_REFERENCE)
        for i, (label, points) in enumerate(self.learned.items()):
            if points:
                means = [interval.estimate for _, interval in points]
                spread = [
                    [interval.estimate - interval.low for _, interval in points],
                    [interval.high - interval.estimate for _, interval in points],
                ]
                ks = [k for k, _ in points]
                look: dict[str, Any] = {
                    "color": (DEEP_BLUE, VERMILION)[i],
                    "marker": "os"[i],
                    "markersize": 5,
                    "linestyle": "none",
                }
                ax.errorbar(ks, means, spread, label=label, capsize=2, **look)
        ax.set_ylim(0, self.top)
        ax.set_xticks(self.ks)
        dress(ax, "observations in the window, k", "return (greedy)", self.title)


def worth(tables: Sequence[Results], networks: Results, windows: int = 7) -> Sheet:
    """Return what windows are worth, without and with actions, beside what tables and networks have learned."""
    panels = []
    ks = [*range(1, windows + 1)]
    for results, actions, title in zip(tables, (False, True), (FRAMES_ALONE, WITH_ACTIONS), strict=True):
        sure = [n * (n + 1) / 2 for n in (never_errs(k, actions) for k in ks)]
        learned = {
            "Q-learning": [(int(label[4:]), mean_interval(late(results, label))) for label in results.methods],
            "DQN": [
                (k, mean_interval(late(networks, label)))
                for label, (k, shown) in WINDOWS.items()
                if shown == actions and label in networks.methods
            ],
        }
        panels.append(Worth(ks, sure, best_values(windows, actions).tolist(), learned, title, 25.0))
    return Sheet("worth", [panels])


def network_figure(networks: Results, recurrent: Results | None = None) -> Sheet:
    """Return the learning curves of DQN, and those of recurrent PPO if they are given."""
    results = networks if recurrent is None else joined([networks, recurrent])
    title = "DQN on windows" if recurrent is None else "DQN on windows, and a learned memory"
    return Sheet("networks", [[Curves(results, title, y_range=(0.0, 25.0))]])


def race(
    own: Mapping[str, Any], *, repetitions: int = 30, n_steps: int = STEPS, log: bool = False, **how: Any
) -> Sheet:
    """Return the lesson's figure with tasks of the reader's own: Q-learning on them, beside windows of 4.

    Args:
        own: by label, tasks, such as a corridor seen through a window of the reader's own.
        repetitions: the number of runs of each.
        n_steps: the training steps of each run.
        log: whether the y axis is logarithmic.
        **how: more arguments of `edugym.experiments.repeat`.
    """
    how = {"repetitions": repetitions, "n_steps": n_steps, **how}
    frames, both = (learn_all([4], actions, **how) for actions in (False, True))
    parts = [_renamed(frames, FRAMES_ALONE, 4), _renamed(both, WITH_ACTIONS, 4)]
    settings: dict[str, Any] = {"learning_rate": LEARNING_RATE, "discount": DISCOUNT, "epsilon": EPSILON}
    parts += [learn_on(task, label, **settings, **how) for label, task in own.items()]
    curves = Curves(joined(parts), "yours, and windows of 4")
    return Sheet("race", [[With(curves, lambda ax: ax.set_yscale("log" if log else "linear"))]])


def _renamed(results: Results, label: str, k: int) -> Results:
    """Return results of one method under another label."""
    return Results(results.table.assign(method=label), {label: results.agents[name(k)]})

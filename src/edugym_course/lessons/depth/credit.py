"""How far the reward of the last step is handed back, when the same episode is repeated."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from edugym.envs.study import EXAM_REWARD
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import axes_or_new, dress
from edugym.mdp.protocol import Reals
from edugym_course.lessons.depth.methods import LEARNING_RATE, label, maker
from edugym_course.lessons.depth.targets import DAYS

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def handed_back(n: float, learning_rate: float = LEARNING_RATE, episodes: int = 150, days: int = DAYS) -> Reals:
    """Repeat one episode whose last step pays 10, and return the values on its path.

    This is the `learn` of n-step SARSA itself, on a path of one state and one action a day.

    Args:
        n: how many rewards the target has.
        learning_rate: α.
        episodes: how often the episode is repeated.
        days: its length.

    Returns:
        Shape (episodes + 1, days): the value of the action of each day, before the first episode and after each.
    """
    agent = maker(n, learning_rate=learning_rate, total_days=days)((days + 1, 1))
    values = [agent.Q[:days, 0].copy()]
    for _ in range(episodes):
        for day in range(days):
            last = day == days - 1
            agent.learn(day, 0, EXAM_REWARD if last else 0.0, day + 1, 0, last, False)
        values.append(agent.Q[:days, 0].copy())
    return np.array(values)


class CreditMap(NamedTuple):
    """The value of the action of each day, episode by episode.

    Attributes:
        values: shape (episodes + 1, days).
        title: the text above the axes.
    """

    values: Reals
    title: str = ""

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the map on `ax`, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        episodes, days = self.values.shape[0] - 1, self.values.shape[1]
        picture = ax.imshow(
            self.values.T,
            cmap="viridis_r",
            vmin=0.0,
            vmax=EXAM_REWARD,
            origin="lower",
            aspect="auto",
            interpolation="nearest",
            extent=(0, episodes, -0.5, days - 0.5),
        )
        dress(ax, "episodes, all the same", "day", self.title)
        if place.last:
            bar = ax.figure.colorbar(picture, ax=ax, pad=0.02)
            bar.set_label("Q of the action of that day", fontsize=8)
            bar.ax.tick_params(labelsize=7)
            bar.outline.set_visible(False)
        return ax


def credit_maps(depths: Sequence[float] = (1, 3, math.inf), learning_rate: float = LEARNING_RATE) -> Sheet:
    """Return a map for each depth: how far the reward of the exam has been handed back."""
    return Sheet("credit", [[CreditMap(handed_back(n, learning_rate), label(n)) for n in depths]])

"""The panels of lesson 0: a map of values with arrows, the rewards of a way, the picture of an environment."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.adapters.registration import make_environment
from edugym.envs.supermarket import Supermarket
from edugym.experiments.figures.panel import ALONE, Place, on_axes
from edugym.experiments.figures.style import VERMILION, axes_or_new, dress, plot_line, stroke
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import INK
from edugym.rendering.pixels import to_pixels
from edugym_course.lessons.model_based.maps import STEPS_OF, FloorMap

if TYPE_CHECKING:
    from matplotlib.axes import Axes

REWARD_COLOUR = "#9aa0a6"


class ValueMap(NamedTuple):
    """What each cell of the supermarket is worth, with an arrow for the best action, and a way.

    Attributes:
        Q: shape (800, 4): action values by state; NaN where nothing is known.
        title: the text above the axes.
        items: what is in the bag: the sum of 4, 2 and 1 for items 1, 2 and 3.
        way: a way, as states.
        bar: whether the scale of colours stands beside the map.
        highest: the value of the darkest colour.
    """

    Q: Any
    title: str = ""
    items: int = 0
    way: tuple[int, ...] = ()
    bar: bool = True
    highest: float = 95.0

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the map on `ax`, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        floor = FloorMap(self.Q, self.title, self.items, highest=self.highest)
        floor.draw(ax, place._replace(last=self.bar))
        y, x, dy, dx = np.array(self.arrows(), float).reshape(-1, 4).T
        size: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1.5, "width": 0.008, "headwidth": 4.0}
        ax.quiver(x, y, dx, dy, color=INK, pivot="mid", **size)
        if self.way:
            y, x = np.array(self.way) // 80, np.array(self.way) // 8 % 10
            ax.plot(x, y, color=VERMILION, linewidth=3.0, alpha=0.55, solid_capstyle="round")
        return ax

    def arrows(self) -> list[tuple[float, float, float, float]]:
        """Return an arrow for each cell, (y, x, dy, dx): slanted where two are equally good, none where more are."""
        shop, found = Supermarket.create(), list[tuple[float, float, float, float]]()
        for cell in range(100):
            row = self.Q[8 * cell + self.items]
            if cell in (shop.exit, shop.start) or np.isnan(row).all():
                continue
            best = np.flatnonzero(row >= np.nanmax(row) - 1e-9)
            dy, dx = STEPS_OF[best].sum(axis=0) / np.sqrt(len(best))
            if len(best) <= 2 and (dy or dx):
                found.append((cell // 10, cell % 10, float(dy), float(dx)))
        return found


class RewardBars(NamedTuple):
    """The reward of each step of a way.

    Attributes:
        rewards: shape (n_steps,): the rewards, or what each of them counts.
        title: the text above the axes.
        x_label: what the steps are.
        y_label: what the bars are.
        returns: shape (n_steps,): the return from each step on, drawn as a line; None draws none.
    """

    rewards: Reals
    title: str = ""
    x_label: str = "time step t"
    y_label: str = "points"
    returns: Reals | None = None

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the bars."""
        steps = np.arange(float(len(self.rewards)))
        ax.bar(
            steps,
            self.rewards,
            width=0.8,
            color=REWARD_COLOUR,
            label=None if self.returns is None else "reward of this step",
        )
        if self.returns is not None:
            plot_line(ax, stroke(0), steps, self.returns, "return from this step on")
        ax.axhline(0.0, color=INK, linewidth=0.6)
        top = self.rewards if self.returns is None else self.returns
        ax.set_ylim(-3.0, max(52.0, 1.1 * float(top.max())))
        dress(ax, self.x_label, self.y_label, self.title)


class Picture(NamedTuple):
    """An environment at the start of an episode.

    Attributes:
        environment: its name.
        title: the text above it.
    """

    environment: str
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the picture."""
        env: Any = make_environment(self.environment)
        env.reset(seed=0)
        ax.imshow(to_pixels(env.unwrapped.scene()))
        ax.set_title(self.title, color=INK, fontsize=9)
        ax.set_axis_off()

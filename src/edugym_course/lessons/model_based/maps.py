"""Maps of the supermarket: values on its floor, and the way that a plan takes."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.agents.dyna_q import DynaQ
from edugym.agents.planning import Updates
from edugym.agents.prioritised_sweeping import PrioritisedSweeping
from edugym.envs.supermarket import WALL, Supermarket
from edugym.exact.value_iteration import best_values
from edugym.exact.values import sweeps
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.sheet import Sheet, in_pairs
from edugym.experiments.figures.style import axes_or_new
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import BLUE, BRICK, GREEN, INK, PAPER, RED
from edugym_course.lessons.model_based.methods import DISCOUNT, exact_model
from edugym_course.lessons.model_based.plans import follow_plan

if TYPE_CHECKING:
    from matplotlib.axes import Axes

WORTH = PAPER, "#8ecfc9", "#3d8fc4"
"""The colours of values, from 0 on; arrows can be seen on the darkest too."""
WALK = 46
"""The seed of a random walk that leaves with no item."""
STEPS_OF = np.array([(-1, 0), (1, 0), (0, -1), (0, 1)])
"""What the actions add to (y, x)."""


class FloorMap(NamedTuple):
    """What each cell of the supermarket is worth, with what is in the bag.

    Attributes:
        Q: shape (800, 4): action values by state; NaN where nothing is known.
        title: the text above the axes.
        items: what is in the bag: the sum of 4, 2 and 1 for items 1, 2 and 3.
        arrows: whether to draw the best action in each cell that is worth something.
        path: a way, as states.
        highest: the value of the darkest colour.
        label: what the colours mean.
    """

    Q: Any
    title: str = ""
    items: int = 0
    arrows: bool = False
    path: tuple[int, ...] = ()
    highest: float = 50.0
    label: str = "value of the cell"

    def values(self) -> Reals:
        """Return the value of each cell, shape (10, 10); NaN where nothing is known."""
        known = ~np.isnan(self.Q).all(axis=1)
        V = np.full(800, np.nan)
        V[known] = np.nanmax(self.Q[known], axis=1)
        values: Reals = V.reshape(100, 8)[:, self.items].reshape(10, 10)
        return values

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the map on `ax`, by default in a new figure, and return the axes."""
        from matplotlib.colors import LinearSegmentedColormap, ListedColormap

        ax = axes_or_new(ax)
        shop = Supermarket.create()
        values = self.values()
        colours = LinearSegmentedColormap.from_list("worth", WORTH)
        picture = ax.imshow(values, cmap=colours, vmin=0.0, vmax=self.highest)
        walls = np.ma.masked_not_equal(shop.cells, WALL)
        ax.imshow(walls, cmap=ListedColormap([BRICK]), alpha=0.9)
        # One is in the cell of an item with that item in the bag only, and nothing is done at the exit.
        seen = ~np.isnan(values) | (shop.cells == WALL) | (shop.cells & ~self.items > 0)
        seen.ravel()[shop.exit] = True
        unknown = np.ma.masked_where(seen, np.ones((10, 10)))
        ax.imshow(unknown, cmap=ListedColormap(["#d9d9d9"]))
        for item, colour in ((4, RED), (2, BLUE), (1, GREEN)):
            if not self.items & item:
                y, x = np.argwhere(shop.cells == item)[0]
                ax.plot(x, y, "o", color=colour, markersize=7, markeredgecolor=INK)
        for cell, letter in ((shop.start, "in"), (shop.exit, "out")):
            ax.text(cell % 10, cell // 10, letter, ha="center", va="center", fontsize=7, color=INK)
        if self.arrows:
            self._draw_arrows(ax, values)
        if self.path:
            y, x = np.array(self.path) // 80, np.array(self.path) // 8 % 10
            ax.plot(x, y, color=INK, linewidth=1.6)
            if len(self.path) > 1 and self.path[-1] // 8 != shop.exit:
                ax.plot(x[-1], y[-1], "X", color=INK, markersize=10)
        ax.set_title(self.title, color=INK, fontsize=9)
        ax.set_xticks([])
        ax.set_yticks([])
        ax.spines[:].set_visible(False)
        if place.last and not self.path:
            bar = ax.figure.colorbar(picture, ax=ax, pad=0.02, shrink=0.85)
            bar.set_label(self.label, fontsize=8)
            bar.ax.tick_params(labelsize=7)
        return ax

    def _draw_arrows(self, ax: "Axes", values: Reals) -> None:
        """Draw the best action of each cell with a value above 0; of several, the first."""
        for y, x in np.argwhere(np.nan_to_num(values) > 0.0):
            if y == 0:
                continue  # the entrance has its label
            row = self.Q[80 * y + 8 * x + self.items]
            dy, dx = 0.36 * STEPS_OF[int(np.nanargmax(row))]
            style = {"arrowstyle": "->", "color": INK, "linewidth": 0.8}
            ax.annotate("", (x + dx, y + dy), (x - dx, y - dy), arrowprops=style)


def random_walk() -> list[tuple[int, int, float, int, bool]]:
    """Return the transitions of a random walk that leaves with no item: (state, action, reward, next state, ended)."""
    shop, rng = Supermarket.create(), np.random.default_rng(WALK)
    state, steps = shop.initial(rng), list[tuple[int, int, float, int, bool]]()
    while not shop.terminal(state):
        action = int(rng.integers(4))
        next_state = shop.transition(state, action, rng)
        steps.append(
            (state, action, shop.reward(state, action, next_state, rng), next_state, shop.terminal(next_state))
        )
        state = next_state
    return steps


def after_walk(kind: Any, updates: int) -> Reals:
    """Return the action values after the random walk and some planning updates; NaN where nothing was tried.

    Args:
        kind: `DynaQ` or `PrioritisedSweeping`; the first is Q-learning without planning.
        updates: how many, all of them after the walk.
    """
    agent = kind.create((800, 4), learning_rate=1.0, discount=DISCOUNT, planning_steps=0)
    for step in random_walk():
        agent.learn(*step)
    agent._replace(planning=Updates(float(updates))).plan(np.random.default_rng(0))
    values: Reals = np.where(agent.model.visits > 0, agent.Q, np.nan)
    return values


def spreading(updates: int = 60) -> Sheet:
    """Return what three learners know after the same walk: by Q-learning, Dyna and prioritised sweeping."""
    maps = {
        "Q-learning: no planning": after_walk(DynaQ, 0),
        f"Dyna: {updates} updates": after_walk(DynaQ, updates),
        f"prioritised sweeping: {updates}": after_walk(PrioritisedSweeping, updates),
    }
    return Sheet("spreading", [[FloorMap(Q, title, arrows=True) for title, Q in maps.items()]])


def who_knows_the_way(updates: int) -> tuple[str, ...]:
    """Return who knows a way from the entrance to the exit after the same walk and so many updates."""
    kinds = {"Dyna": DynaQ, "prioritised sweeping": PrioritisedSweeping}
    start = 8 * Supermarket.create().start
    return tuple(name for name, kind in kinds.items() if np.nanmax(after_walk(kind, updates)[start]) > 0.0)


def dynamic_programming(n_sweeps: tuple[int, ...] = (1, 3, 8, 30), discount: float = DISCOUNT) -> Sheet:
    """Return the values of the shop with an empty bag after some sweeps over the exact model."""
    model = exact_model()
    wanted, panels = {*n_sweeps}, list[FloorMap]()
    for sweep, (_, Q) in enumerate(sweeps(model, best_values(0.0), discount)):
        if sweep in wanted:
            table = np.full((800, 4), np.nan)
            table[list(model.states)] = Q
            title = f"after {sweep} sweep{'s' if sweep > 1 else ''}"
            panels.append(FloorMap(table, title, arrows=True, highest=90.0))
        if sweep >= max(wanted):
            break
    return in_pairs("dynamic_programming", panels)


def wrong_plan(noise: float = 1.5, draw: int = 0, gamma: float = 0.95) -> Sheet:
    """Return the way of a plan that was made with a wrong model, and whether it gets to the exit."""
    plan = follow_plan(noise, draw, gamma)
    how = f"return {plan.total:g}" if plan.ends else "a wall, for ever" if plan.bumps else "round and round, for ever"
    floor = np.full((800, 4), np.nan)
    floor[list(exact_model().states)] = 0.0
    title = f"noise {noise:g}, draw {draw}, γ = {gamma:g}: {how}"
    return Sheet("wrong_plan", [[FloorMap(floor, title, path=plan.path)]])

"""Boards of Catch as 50 numbers in a row, in the order of the board or in another one."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.wrapper import wrapper
from edugym_course.lessons.dimensionality.tasks import COLUMNS, ROWS, catch

NOISE = 0.1


@wrapper
class Shuffled(NamedTuple):
    """A task whose pixels stand in a row, in some order.

    Attributes:
        mdp: the task.
        order: shape (n_pixels,): which pixel stands where.
        board: room for a board of the task.
        sigma: the standard deviation of the normal noise in every pixel; 0 for none.
    """

    mdp: Any
    order: Integers
    board: Reals
    sigma: float = 0.0

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """A number for each pixel."""
        return spaces.Box(0.0, 1.0, (len(self.order),), np.float64)

    def observation(self, state: Any, rng: Random) -> Any:
        """The pixels in their order."""
        pixels = np.empty(len(self.order))
        self.observe_into(state, rng, pixels)
        return pixels

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """The same, written into `out`."""
        self.mdp.observe_into(state, rng, self.board)
        for k in range(len(self.order)):
            out[k] = self.board.flat[self.order[k]]
            if self.sigma > 0.0:
                out[k] = min(max(out[k] + rng.normal(0.0, self.sigma), 0.0), 1.0)


def in_a_row(task: Any) -> Shuffled:
    """Return a task with its pixels in a row, in the order of the board."""
    return Shuffled(task, np.arange(ROWS * COLUMNS), np.zeros((ROWS, COLUMNS)))


def shuffled_board(layout_seed: int) -> Any:
    """Return the noisy board with the pixels in an order that belongs to a seed."""
    order = np.random.default_rng(layout_seed).permutation(ROWS * COLUMNS)
    return Shuffled(catch("grid"), order, np.zeros((ROWS, COLUMNS)), NOISE)

"""A board of Catch with noise, whose pixels stand in another order."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.lessons.dimensionality.tasks import COLUMNS, ROWS, noisy
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.wrapper import wrapper

NOISE = 0.1


@wrapper
class Shuffled(NamedTuple):
    """A task whose pixels stand in another order.

    Attributes:
        mdp: the task.
        order: shape (n_pixels,): which pixel stands where.
        board: room for a board of the task.
    """

    mdp: Any
    order: Integers
    board: Reals

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """As many pixels, in a row."""
        return spaces.Box(0.0, 1.0, (len(self.order),), np.float32)

    def observation(self, state: Any, rng: Random) -> Any:
        """The pixels in their new order."""
        pixels = np.empty(len(self.order), np.float32)
        self.observe_into(state, rng, pixels)
        return pixels

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """The same, written into `out`."""
        self.mdp.observe_into(state, rng, self.board)
        for k in range(len(self.order)):
            out[k] = self.board.flat[self.order[k]]


def shuffled_board(layout_seed: int) -> Shuffled:
    """Return the noisy board with the pixels in an order that belongs to a seed."""
    order = np.random.default_rng(layout_seed).permutation(ROWS * COLUMNS)
    return Shuffled(noisy(sigma=NOISE), order, np.zeros((ROWS, COLUMNS), np.float32))

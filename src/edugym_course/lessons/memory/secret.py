"""The corridor of the open challenge: its marks are signs in a script that must be learned."""

from typing import Any, NamedTuple

import numpy as np

from edugym.envs.memory_corridor import Corridor, MemoryCorridor
from edugym.mdp.protocol import Integers, Random
from edugym.mdp.wrapper import wrapper

SECRET_DOORS = 10
SECRET_STEPS = 100


@wrapper
class SecretMarks(NamedTuple):
    """A corridor whose marks do not show the number of the right door, but a sign for it.

    Attributes:
        mdp: the corridor.
        signs: shape (num_doors,): the sign of each door.
    """

    mdp: Any
    signs: Integers

    def observation(self, state: Corridor, rng: Random) -> int:
        """The sign of the right door at the last place, elsewhere the number of doors."""
        seen = int(self.mdp.observation(state, rng))
        return int(self.signs[seen]) if seen < len(self.signs) else seen


def secret_corridor(layout_seed: int) -> SecretMarks:
    """Make a corridor with ten doors, episodes of at most 100 steps, and signs that belong to a seed."""
    corridor = MemoryCorridor.create(SECRET_DOORS, SECRET_STEPS)
    return SecretMarks(corridor, np.random.default_rng(layout_seed).permutation(SECRET_DOORS))

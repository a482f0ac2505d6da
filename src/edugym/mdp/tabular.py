"""Observations of several whole numbers as one: the row of a table."""

import math
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import MDP, Integers, Random, writes_in_place
from edugym.mdp.sizes import number_of_rows, table_lows, table_sizes
from edugym.mdp.wrapper import wrapper


@wrapper
class Tabular(NamedTuple):
    """An MDP that shows its observation (i, j, ...) as the index in a table of `sizes`, the last number fastest.

    Attributes:
        mdp: the task, which observes a tuple of whole numbers.
        sizes: shape (n,): how many values each of them takes.
        lows: shape (n,): the lowest value of each.
        seen: shape (n,): room for the present observation, where the task writes it in place.
    """

    mdp: Any
    sizes: Integers
    lows: Integers
    seen: Integers

    @property
    def observation_space(self) -> spaces.Discrete:
        """The rows of the table."""
        return spaces.Discrete(math.prod(self.sizes.tolist()))

    def observation(self, state: Any, rng: Random) -> int:
        """The row of the table for the observation of the task."""
        return self.row(self.mdp.observation(state, rng))

    def row(self, parts: Any) -> int:
        """The row of the table for several numbers."""
        row = 0
        for k in range(len(self.sizes)):
            row = row * int(self.sizes[k]) + int(parts[k]) - int(self.lows[k])
        return row

    @classmethod
    def create(cls, mdp: MDP[Any, Any]) -> "Tabular":
        """The wrapper for an MDP that observes whole numbers.

        Raises:
            ValueError: it observes something else, or numbers nested in one another, or has 2^63 different
                observations or more.
        """
        space = mdp.observation_space
        if isinstance(space, spaces.Discrete):
            raise ValueError(f"mdp observes one whole number already, an element of {space}: it needs no Tabular")
        sizes = table_sizes(space)
        parts = space.spaces if isinstance(space, spaces.Tuple) else ()
        if not all(isinstance(part, spaces.Discrete) for part in parts) or len(space.shape or ()) > 1:
            raise ValueError(f"observation_space of an MDP must be flat for a table, but is {space}")
        number_of_rows(sizes)
        kind = TabularInPlace if writes_in_place(mdp) else cls
        return kind(mdp, np.array(sizes), np.array(table_lows(space)), np.zeros(len(sizes), np.int64))


class TabularInPlace(Tabular):
    """The same for an MDP that writes its observation into an array: no step makes a new one."""

    __slots__ = ()

    def observation(self, state: Any, rng: Random) -> int:
        """The row of the table for the observation of the task."""
        self.mdp.observe_into(state, rng, self.seen)
        return self.row(self.seen)


def tabular_mdp(mdp: MDP[Any, Any]) -> Any:
    """The MDP with its observations as the rows of a table; unchanged if they are already.

    Raises:
        ValueError: its observations are not whole numbers, or it does not number them from 0.
    """
    space = mdp.observation_space
    if isinstance(space, spaces.Discrete):
        if space.start != 0:
            raise ValueError(f"an MDP must number its observations from 0, but its observation space is {space}")
        return mdp
    return Tabular.create(mdp)

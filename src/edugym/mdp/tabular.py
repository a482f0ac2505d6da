"""Observations of whole numbers as rows of a table: how many there are, and an MDP that shows them so."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import in_short
from edugym.mdp.protocol import MDP, Integers, Random, writes_in_place
from edugym.mdp.wrapper import wrapper
from edugym.system.memory import in_digits

MOST_ROWS = 2**63 - 1
"""The largest number of rows that machine code can count."""


GOAL_PARTS = ("observation", "achieved_goal", "desired_goal")
"""The parts of an observation of a goal environment, as Gymnasium-Robotics defines it."""


def parts_for_row(space: spaces.Dict) -> tuple[str, ...]:
    """The names of those parts of a dictionary, in their order, that tell its row in a table.

    In a goal environment they are the observation and the desired goal: what is achieved follows from the observation.
    """
    if space.spaces.keys() == {*GOAL_PARTS}:
        return "observation", "desired_goal"
    return tuple(space.spaces)


def space_of_row(space: spaces.Space[Any]) -> spaces.Space[Any]:
    """What a Gymnasium environment shows, as a table numbers it: the parts of a dictionary as a Tuple."""
    if isinstance(space, spaces.Dict):
        return spaces.Tuple([space.spaces[name] for name in parts_for_row(space)])
    return space


def table_sizes(space: spaces.Space[Any]) -> tuple[int, ...]:
    """How many values each whole number in an element of `space` takes.

    Raises:
        ValueError: there are other things than whole numbers in it.
    """
    if isinstance(space, spaces.Discrete):
        return (int(space.n),)
    if isinstance(space, spaces.MultiDiscrete):
        return tuple(int(n) for n in np.ravel(space.nvec))
    if isinstance(space, spaces.MultiBinary):
        return (2,) * math.prod(space.shape)
    if isinstance(space, spaces.Tuple):
        return tuple(size for part in space.spaces for size in table_sizes(part))
    raise ValueError(f"a table needs observations that are whole numbers, but the observation space is {space}")


def table_lows(space: spaces.Space[Any]) -> Sequence[int]:
    """The lowest value of each whole number in an element of `space`."""
    if isinstance(space, spaces.Tuple):
        return [low for part in space.spaces for low in table_lows(part)]
    if isinstance(space, spaces.Discrete | spaces.MultiDiscrete):
        return [int(low) for low in np.ravel(space.start)]
    return [0] * len(table_sizes(space))


def number_of_rows(sizes: Sequence[int]) -> int:
    """The number of rows of a table for several numbers, which take so many values each.

    Raises:
        ValueError: there are 2^63 rows or more.
    """
    rows = math.prod(sizes)
    if rows > MOST_ROWS:
        raise ValueError(
            f"the rows of a table over {in_digits(rows)} observations do not fit 63 bits: give rows only to those that"
            " occur (edugym.Hashed)"
        )
    return rows


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
            ValueError: it is no MDP, observes something else, or numbers nested in one another, or has 2^63 different
                observations or more.
        """
        space = getattr(mdp, "observation_space", None)
        if not isinstance(space, spaces.Space):
            raise ValueError(
                f"mdp must be an MDP, whose observation_space is a Gymnasium space, but is {in_short(mdp)}"
            )
        if isinstance(space, spaces.Discrete):
            raise ValueError(f"mdp observes one whole number already, an element of {space}: it needs no Tabular")
        sizes = table_sizes(space)
        parts = space.spaces if isinstance(space, spaces.Tuple) else ()
        if not all(isinstance(part, spaces.Discrete) for part in parts) or len(space.shape or ()) > 1:
            raise ValueError(f"observation_space of an MDP must be flat for a table, but is {space}")
        number_of_rows(sizes)
        lows, seen = np.array(table_lows(space), np.int64), np.zeros(len(sizes), np.int64)
        kind = TabularInPlace if writes_in_place(mdp) else cls
        return kind(mdp, np.array(sizes, np.int64), lows, seen)


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

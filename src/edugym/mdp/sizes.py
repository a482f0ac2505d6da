"""How large the spaces of a task are: as rows of a table, or as vectors."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import in_short
from edugym.system.memory import in_digits

MOST_ROWS = 2**63 - 1
"""The largest number of rows that machine code can count."""


def table_size(environment: Any) -> tuple[int, int]:
    """The shape (n_states, n_actions) of a table of action values for an environment.

    Args:
        environment: an MDP, a Gymnasium environment, or the shape itself.

    Raises:
        ValueError: it is no environment, its observations are not whole numbers, or its actions are not 0, 1, ...
    """
    if isinstance(environment, tuple) and not hasattr(environment, "_fields"):
        return check_shape(environment, "(n_states, n_actions)")
    if isinstance(environment, type):
        name = environment.__name__
        made = f"{name}.create(...)" if hasattr(environment, "create") else f"{name}(...)"
        raise ValueError(f"environment must be a value, but is the class {name}: make one with {made}")
    if not hasattr(environment, "action_space"):
        raise ValueError(
            f"environment must be an MDP, a Gymnasium environment or a shape, but is {in_short(environment)}"
        )
    actions = environment.action_space
    if not isinstance(actions, spaces.Discrete) or actions.start != 0:
        raise ValueError(f"a table needs the actions 0, 1, ..., but the action space is {actions}")
    n_states: int = math.prod(table_sizes(environment.observation_space))
    return n_states, int(actions.n)


def check_shape(shape: tuple[Any, ...], name: str) -> tuple[int, int]:
    """Refuse a shape that is not two whole numbers of 1 or more.

    Args:
        shape: what was given in place of an environment.
        name: what the two numbers are.

    Raises:
        ValueError: it is something else.
    """
    if len(shape) != 2 or not all(isinstance(size, int | np.integer) and size >= 1 for size in shape):
        raise ValueError(
            f"environment must be an environment or the shape {name} of a table, two whole numbers of 1 or more, but is"
            f" {shape!r}"
        )
    return int(shape[0]), int(shape[1])


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


def vector_length(space: spaces.Space[Any]) -> int:
    """How many numbers an observation is as a vector.

    Raises:
        ValueError: it is none.
    """
    if isinstance(space, spaces.Box):
        return math.prod(space.shape)
    try:
        if isinstance(space, spaces.MultiBinary):
            raise ValueError
        return sum(table_sizes(space))
    except ValueError:
        raise ValueError(
            f"a vector needs observations that are numbers, but the observation space is {space}"
        ) from None


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

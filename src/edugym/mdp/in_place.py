"""Observations of any form (a number, a tuple, an array) written into an array that is there already."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import MDP, Random, writes_in_place
from edugym.mdp.tabular import tabular_mdp
from edugym.mdp.wrapper import wrapper


@wrapper
class OneNumber(NamedTuple):
    """An MDP that observes a number, which it also writes into an array of length 1."""

    mdp: Any

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the number."""
        out[0] = self.mdp.observation(state, rng)


@wrapper
class SeveralNumbers(NamedTuple):
    """An MDP that observes a tuple of numbers, which it also writes into an array of the same length."""

    mdp: Any

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the numbers."""
        parts = self.mdp.observation(state, rng)
        for k in range(len(out)):
            out[k] = parts[k]


@wrapper
class WholeArray(NamedTuple):
    """An MDP that observes an array, which it also copies into another of the same shape."""

    mdp: Any

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Copy the array."""
        out[:] = self.mdp.observation(state, rng)


def in_place(mdp: MDP[Any, Any]) -> Any:
    """The MDP with a method `observe_into(state, rng, out)`, where `out` is an array like `blank(mdp)`.

    Raises:
        ValueError: it observes no numbers, or others than its observation space says.
    """
    space = mdp.observation_space
    if isinstance(space, spaces.Tuple):
        mdp = tabular_mdp(mdp)
        space = mdp.observation_space
    if not isinstance(space, spaces.Discrete | spaces.MultiDiscrete | spaces.MultiBinary | spaces.Box):
        raise ValueError(f"the observations of mdp must be numbers, but its observation space is {space}")
    if writes_in_place(mdp):
        return mdp
    rng = np.random.default_rng(0)
    sample = mdp.observation(mdp.initial(rng), rng)
    if np.shape(sample) != (space.shape or ()) and not (np.ndim(sample) == 0 and space.shape == (1,)):
        raise ValueError(f"mdp observes {sample!r}, which is not as its observation space says: {space}")
    if np.ndim(sample) == 0:
        return OneNumber(mdp)
    return WholeArray(mdp) if isinstance(sample, np.ndarray) else SeveralNumbers(mdp)


def blank(mdp: MDP[Any, Any]) -> Any:
    """An array of zeros that can take an observation: of int64 for whole numbers, else of float64."""
    space = mdp.observation_space
    whole = space.dtype is not None and np.issubdtype(space.dtype, np.integer)
    return np.zeros(space.shape or (1,), np.int64 if whole else np.float64)


def written(self: Any, state: Any, rng: Random) -> Any:
    """`observation` of a wrapper that has `observe_into` and a field `blank`: a new array at every call."""
    out = np.empty_like(self.blank)
    self.observe_into(state, rng, out)
    return out

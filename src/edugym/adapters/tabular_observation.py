"""Number the observations of any Gymnasium environment, or any MDP, so that they are rows of a table."""

from collections.abc import Iterator
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.parameters import in_short
from edugym.mdp.protocol import MDP
from edugym.mdp.sizes import number_of_rows, table_lows, table_sizes
from edugym.mdp.tabular import tabular_mdp


class TabularObservation(gymnasium.ObservationWrapper[int, Any, Any]):
    """Number the observations of a Gymnasium environment 0, 1, ..., so that an agent can use them as rows of a table.

    The last number of an observation varies fastest: (i, j) of sizes (3, 4) becomes row 4 i + j. For an MDP,
    `edugym.Tabular` does the same.

    Args:
        env: an environment with a Discrete, MultiDiscrete or MultiBinary observation space, or a (nested) Tuple of
            these. For others see `edugym.Discretised`, `edugym.Hashed`, and agents without a table.

    Raises:
        ValueError: the observation space is of another kind, or the table would have 2^63 rows or more.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """See the class."""
        super().__init__(env)
        self._sizes = table_sizes(env.observation_space)
        self._is_plain = isinstance(env.observation_space, spaces.Discrete)
        self._lows = [int(low) for low in table_lows(env.observation_space)]
        rows: spaces.Space[Any] = spaces.Discrete(number_of_rows(self._sizes))
        self.observation_space = rows

    def observation(self, observation: Any) -> int:
        """The row of the table that stands for an observation.

        Raises:
            ValueError: the observation is not in the observation space of the environment.
        """
        if self._is_plain and isinstance(observation, int | np.integer):
            row = int(observation) - self._lows[0]
            if 0 <= row < self._sizes[0]:
                return row
        parts = list(_numbers(observation))
        fits = len(parts) == len(self._lows) and all(
            _is_whole(part) and 0 <= int(part) - low < size
            for part, low, size in zip(parts, self._lows, self._sizes, strict=True)
        )
        if not fits:
            raise ValueError(
                f"observation {in_short(observation)} is not in the observation space {self.env.observation_space} that"
                f" {self.env.unwrapped} declares"
            )
        row = 0
        for part, low, size in zip(parts, self._lows, self._sizes, strict=True):
            row = row * size + int(part) - low
        return row


def _numbers(observation: Any) -> Iterator[Any]:
    """The whole numbers in an observation: a number, an array, or a tuple of these, nested as it may be."""
    if isinstance(observation, tuple):
        for part in observation:
            yield from _numbers(part)
    else:
        yield from np.ravel(observation)


def _is_whole(part: Any) -> bool:
    """Whether a part of an observation is a whole number; 2.0 is one."""
    if isinstance(part, float | np.floating):
        return part.is_integer()
    return isinstance(part, int | np.integer | np.bool_)


def tabular(environment: MDP[Any, Any] | gymnasium.Env[Any, Any]) -> Any:
    """The MDP or Gymnasium environment with each observation replaced by the index of its row in a table.

    An MDP, or an environment of this package, whose observations are already 0, 1, ... is returned unchanged. Any other
    environment is wrapped, and the wrapper checks each observation.

    Raises:
        ValueError: the observations are not whole numbers, an MDP does not number them from 0, or the table would have
            2^63 rows or more.
    """
    if not isinstance(environment, gymnasium.Env):
        return tabular_mdp(environment)
    space = environment.observation_space
    is_foreign = not isinstance(environment.unwrapped, MDPEnv)  # then its observations must be checked
    is_table = isinstance(space, spaces.Discrete) and space.start == 0 and not is_foreign
    return environment if is_table else TabularObservation(environment)

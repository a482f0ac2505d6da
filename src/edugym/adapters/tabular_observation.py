"""The observations of any Gymnasium environment, or any MDP, as the rows of a table."""

import math
from collections.abc import Iterator
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.mdp.protocol import MDP
from edugym.mdp.tabular import table_lows, table_sizes, tabular_mdp


class TabularObservation(gymnasium.ObservationWrapper[int, Any, Any]):
    """`Tabular` for any Gymnasium environment whose observations are whole numbers, or tuples or arrays of them.

    Args:
        env: an environment with a Discrete, MultiDiscrete or MultiBinary observation space, or a (nested) Tuple of
            these.

    Raises:
        ValueError: its observations are something else.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """See the class."""
        super().__init__(env)
        self._sizes = table_sizes(env.observation_space)
        self._is_plain = isinstance(env.observation_space, spaces.Discrete)
        self._lows = np.array(table_lows(env.observation_space))
        rows: spaces.Space[Any] = spaces.Discrete(math.prod(self._sizes))
        self.observation_space = rows

    def observation(self, observation: Any) -> int:
        """The row of the table that stands for an observation.

        Raises:
            ValueError: the observation is not in the observation space of the environment.
        """
        if self._is_plain and isinstance(observation, int | np.integer):
            row = int(observation) - int(self._lows[0])
            if 0 <= row < self._sizes[0]:
                return row
        parts = np.array(list(_numbers(observation)), np.int64)
        if parts.shape != self._lows.shape or not ((self._lows <= parts) & (parts < self._lows + self._sizes)).all():
            raise ValueError(
                f"observation {observation!r} is not in the observation space {self.env.observation_space} that"
                f" {self.env.unwrapped} declares"
            )
        return int(np.ravel_multi_index(tuple(parts - self._lows), self._sizes))


def _numbers(observation: Any) -> Iterator[Any]:
    """The whole numbers in an observation: a number, an array, or a tuple of these, nested as it may be."""
    if isinstance(observation, tuple):
        for part in observation:
            yield from _numbers(part)
    else:
        yield from np.ravel(observation)


def tabular(environment: MDP[Any, Any] | gymnasium.Env[Any, Any]) -> Any:
    """The MDP or Gymnasium environment with its observations as the rows of a table.

    An MDP, or an environment that plays one, is returned unchanged if they are that already; of any other environment
    each observation is checked.

    Raises:
        ValueError: its observations are not whole numbers, or an MDP does not number them from 0.
    """
    if not isinstance(environment, gymnasium.Env):
        return tabular_mdp(environment)
    space = environment.observation_space
    is_foreign = not isinstance(environment.unwrapped, MDPEnv)  # whose observations have to be checked
    is_table = isinstance(space, spaces.Discrete) and space.start == 0 and not is_foreign
    return environment if is_table else TabularObservation(environment)

"""The observations of any Gymnasium environment, or any MDP, as the rows of a table."""

import math
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import MDP
from edugym.mdp.tabular import table_lows, table_sizes, tabular_mdp


class TabularObservation(gymnasium.ObservationWrapper[int, Any, Any]):
    """`Tabular` for any Gymnasium environment whose observations are whole numbers, or tuples or arrays of them.

    Args:
        env: an environment with a Discrete, MultiDiscrete or MultiBinary observation space, or a Tuple of these.

    Raises:
        ValueError: its observations are something else.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """See the class."""
        super().__init__(env)
        self._sizes = table_sizes(env.observation_space)
        self._lows = np.array(table_lows(env.observation_space))
        rows: spaces.Space[Any] = spaces.Discrete(math.prod(self._sizes))
        self.observation_space = rows

    def observation(self, observation: Any) -> int:
        """The row of the table that stands for an observation."""
        parts = (
            np.concatenate([np.ravel(part) for part in observation]) if isinstance(observation, tuple) else observation
        )
        return int(np.ravel_multi_index(tuple(np.ravel(parts) - self._lows), self._sizes))


def tabular(environment: MDP[Any, Any] | gymnasium.Env[Any, Any]) -> Any:
    """The MDP or Gymnasium environment with its observations as the rows of a table; unchanged if they are already.

    Raises:
        ValueError: its observations are not whole numbers, or an MDP does not number them from 0.
    """
    if not isinstance(environment, gymnasium.Env):
        return tabular_mdp(environment)
    space = environment.observation_space
    is_table = isinstance(space, spaces.Discrete) and space.start == 0
    return environment if is_table else TabularObservation(environment)

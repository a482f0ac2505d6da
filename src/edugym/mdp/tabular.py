"""Observations of several whole numbers as one: the row of a table."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import MDP, Random


class Tabular(NamedTuple):
    """An MDP whose observation (i, j, ...) is shown as its index in a table of `sizes`, the last number fastest.

    Attributes:
        mdp: the task, which observes a tuple of whole numbers.
        sizes: how many values each of them takes.
        lows: the lowest value of each.
    """

    mdp: Any
    sizes: tuple[int, ...]
    lows: tuple[int, ...]

    @property
    def observation_space(self) -> spaces.Discrete:
        """The rows of the table."""
        return spaces.Discrete(math.prod(self.sizes))

    @property
    def action_space(self) -> spaces.Space[Any]:
        """The task's actions."""
        space: spaces.Space[Any] = self.mdp.action_space
        return space

    @property
    def max_steps(self) -> int:
        """The task's step limit (there is none where the task has none)."""
        limit: int = self.mdp.max_steps
        return limit

    def initial(self, rng: Random) -> Any:
        """The task's initial state."""
        return self.mdp.initial(rng)

    def transition(self, state: Any, action: int, rng: Random) -> Any:
        """The task's dynamics."""
        return self.mdp.transition(state, action, rng)

    def reward(self, state: Any, action: int, next_state: Any, rng: Random) -> float:
        """The task's reward."""
        reward: float = self.mdp.reward(state, action, next_state, rng)
        return reward

    def terminal(self, state: Any) -> bool:
        """The task's end."""
        terminal: bool = self.mdp.terminal(state)
        return terminal

    def observation(self, state: Any, rng: Random) -> int:
        """The row of the table that stands for what the task shows."""
        parts = self.mdp.observation(state, rng)
        row = 0
        for k in range(len(self.sizes)):
            row = row * self.sizes[k] + int(parts[k]) - self.lows[k]
        return row


class TabularObservation(gymnasium.ObservationWrapper[int, Any, Any]):
    """The same for any Gymnasium environment whose observations are whole numbers, or tuples or arrays of them.

    Args:
        env: an environment with a Discrete, MultiDiscrete or MultiBinary observation space, or a Tuple of these.

    Raises:
        ValueError: its observations are something else.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """See the class."""
        super().__init__(env)
        self._sizes = table_sizes(env.observation_space)
        self._lows = np.array(_lows(env.observation_space))
        rows: spaces.Space[Any] = spaces.Discrete(math.prod(self._sizes))
        self.observation_space = rows

    def observation(self, observation: Any) -> int:
        """The row of the table that stands for an observation."""
        parts = (
            np.concatenate([np.ravel(part) for part in observation]) if isinstance(observation, tuple) else observation
        )
        return int(np.ravel_multi_index(tuple(np.ravel(parts) - self._lows), self._sizes))


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


def _lows(space: spaces.Space[Any]) -> Sequence[int]:
    if isinstance(space, spaces.Tuple):
        return [low for part in space.spaces for low in _lows(part)]
    if isinstance(space, spaces.Discrete | spaces.MultiDiscrete):
        return [int(low) for low in np.ravel(space.start)]
    return [0] * len(table_sizes(space))


def tabular(environment: MDP[Any, Any] | gymnasium.Env[Any, Any]) -> Any:
    """The MDP or Gymnasium environment with its observations as the rows of a table; the same where they are already.

    Raises:
        ValueError: its observations are not whole numbers, or an MDP does not number them from 0.
    """
    space = environment.observation_space
    if isinstance(space, spaces.Discrete) and space.start == 0:
        return environment
    if isinstance(environment, gymnasium.Env):
        return TabularObservation(environment)
    if isinstance(space, spaces.Discrete):
        raise ValueError(f"an MDP must number its observations from 0, but its observation space is {space}")
    return Tabular(environment, table_sizes(space), tuple(_lows(space)))


def table_size(environment: Any) -> tuple[int, int]:
    """The shape (n_states, n_actions) of a table of action values for an environment.

    Args:
        environment: an MDP, a Gymnasium environment, or the shape itself.

    Raises:
        ValueError: it is no environment, its observations are not whole numbers, or its actions are not 0, 1, ...
    """
    if isinstance(environment, tuple) and not hasattr(environment, "_fields"):
        return int(environment[0]), int(environment[1])
    if not hasattr(environment, "action_space"):
        raise ValueError(f"environment must be an MDP, a Gymnasium environment or a shape, but is {environment!r}")
    actions = environment.action_space
    if not isinstance(actions, spaces.Discrete) or actions.start != 0:
        raise ValueError(f"a table needs the actions 0, 1, ..., but the action space is {actions}")
    n_states: int = math.prod(table_sizes(environment.observation_space))
    return n_states, int(actions.n)

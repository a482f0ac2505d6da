"""Players whose scores are known: random play scores 0, and the best play 1."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym import finite_model, value_iteration
from edugym.mdp.protocol import Integers, Random


class RandomPlay(NamedTuple):
    """Any action, with the same probability; `n_actions` is how many there are."""

    n_actions: int
    tabular: bool = False

    def act(self, state: Any, rng: Random) -> int:
        """Any action."""
        return int(rng.random() * self.n_actions)

    def greedy(self, state: Any, rng: Random) -> int:
        """Any action."""
        return int(rng.random() * self.n_actions)

    def learn(self, reward: float) -> None:
        """Learn nothing."""


class RandomTurns(NamedTuple):
    """The same for actions that are two numbers from -1 to 1."""

    tabular: bool = False

    def act(self, state: Any, rng: Random) -> Any:
        """Any action."""
        return np.array([2.0 * rng.random() - 1.0, 2.0 * rng.random() - 1.0], np.float32)

    def greedy(self, state: Any, rng: Random) -> Any:
        """Any action."""
        return self.act(state, rng)

    def learn(self, reward: float) -> None:
        """Learn nothing."""


def random_play(environment: Any) -> Any:
    """Random play for an environment."""
    space = environment.action_space
    return RandomPlay(int(space.n)) if isinstance(space, spaces.Discrete) else RandomTurns()


class Known(NamedTuple):
    """The action that is known to be best, by the row of the observation in a table; shape (n_rows,)."""

    actions: Integers

    def act(self, state: int, rng: Random) -> int:
        """The best action."""
        return int(self.actions[state])

    def greedy(self, state: int, rng: Random) -> int:
        """The best action."""
        return int(self.actions[state])

    def learn(self, reward: float) -> None:
        """Learn nothing."""


def best_play(environment: Any) -> Known:
    """The exact policy of a task whose observation tells the state."""
    model = finite_model(environment.unwrapped.mdp)
    task = model.table_task()
    best = value_iteration(model, 0.999).greedy_policy()  # the discount prefers the shortest of equally good ways
    actions = np.zeros(int(task.observation_space.n), np.int64)
    going_on = ~model.terminal  # where the task has ended, an observation may be that of another state
    actions[model.observations()[going_on]] = best.argmax(axis=1)[going_on]
    return Known(actions)

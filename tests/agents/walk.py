"""Small tasks with chance and known values, for the agents' oracles."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym import finite_model, value_iteration
from edugym.mdp.protocol import Random, Reals


class Walk(NamedTuple):
    """Walk left (0) or right (1) from the middle of a line until an end: 1 on the left, 2 on the right.

    Attributes:
        n: the last place; the first is 0.
        slip: the probability of a step the other way.
    """

    n: int = 4
    slip: float = 0.25

    def initial(self, rng: Random) -> int:
        """In the middle."""
        return self.n // 2

    def transition(self, state: int, action: int, rng: Random) -> int:
        """One place on, or the other way."""
        step = 1 if action == 1 else -1
        return state - step if rng.random() < self.slip else state + step

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """What the end pays, less a tenth a step."""
        if next_state == 0:
            return 0.9
        return 1.9 if next_state == self.n else -0.1

    def terminal(self, state: int) -> bool:
        """At the ends."""
        return state == 0 or state == self.n

    def observation(self, state: int, rng: Random) -> int:
        """The place."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The places."""
        return spaces.Discrete(self.n + 1)

    @property
    def action_space(self) -> spaces.Discrete:
        """Left and right."""
        return spaces.Discrete(2)


class Gamble(NamedTuple):
    """Example 6.7: right (even actions) ends with 0; left leads to B, where every action pays N(mean, 1) and ends."""

    mean: float
    n_actions: int

    def initial(self, rng: Random) -> int:
        """A."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """A to B on the left, else the end."""
        return 1 if state == 0 and action % 2 == 1 else 2

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """Only from B."""
        return rng.normal(self.mean, 1.0) if state == 1 else 0.0

    def terminal(self, state: int) -> bool:
        """The end."""
        return state == 2

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """A, B and the end."""
        return spaces.Discrete(3)

    @property
    def action_space(self) -> spaces.Discrete:
        """Many."""
        return spaces.Discrete(self.n_actions)


def exact_values(mdp: Any, discount: float, epsilon: float = 0.0) -> Reals:
    """The exact optimal Q (among ε-soft policies), by the states that the agent observes, 0 where it ends."""
    model = finite_model(mdp)
    Q = np.zeros((mdp.observation_space.n, mdp.action_space.n))
    Q[list(model.states)] = value_iteration(model, discount, epsilon=epsilon).Q
    return Q

"""Small tasks with chance and known values, for the agents' oracles."""

from typing import Any

import numpy as np

from edugym import finite_model, value_iteration
from edugym.mdp.protocol import Reals
from tests.compiled.cells import cell

NOTEBOOK = cell("""
class Walk(NamedTuple):
    n: int = 4
    slip: float = 0.25
    def initial(self, rng): return self.n // 2
    def transition(self, state, action, rng):
        step = 1 if action == 1 else -1
        return state - step if rng.random() < self.slip else state + step
    def reward(self, state, action, next_state, rng):
        return 0.9 if next_state == 0 else 1.9 if next_state == self.n else -0.1
    def terminal(self, state): return state == 0 or state == self.n
    def observation(self, state, rng): return state
    observation_space = property(lambda self: spaces.Discrete(self.n + 1))
    action_space = property(lambda self: spaces.Discrete(2))

class Gamble(NamedTuple):
    def initial(self, rng): return 0
    def transition(self, state, action, rng): return 1 if state == 0 and action % 2 == 1 else 2
    def reward(self, state, action, next_state, rng): return rng.normal(-0.1, 1.0) if state == 1 else 0.0
    def terminal(self, state): return state == 2
    def observation(self, state, rng): return state
    observation_space = property(lambda self: spaces.Discrete(3))
    action_space = property(lambda self: spaces.Discrete(10))
""")
Walk = NOTEBOOK["Walk"]
"""Walk left (0) or right (1) from the middle of a line, with slips, until an end: 1 on the left, 2 on the right."""
Gamble = NOTEBOOK["Gamble"]
"""Example 6.7: right (even actions) ends with 0; left leads to B, where every action pays N(-0.1, 1) and ends."""


def exact_values(mdp: Any, discount: float, epsilon: float = 0.0) -> Reals:
    """The exact optimal Q (among ε-soft policies), by the states that the agent observes, 0 where it ends."""
    model = finite_model(mdp)
    Q = np.zeros((mdp.observation_space.n, mdp.action_space.n))
    Q[list(model.states)] = value_iteration(model, discount, epsilon=epsilon).Q
    return Q

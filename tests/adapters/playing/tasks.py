"""What the tests of playing play."""

from typing import Any, NamedTuple

import gymnasium
from gymnasium import spaces

from tests.compiled.cells import cell

TASKS = """
class Walk(NamedTuple):
    max_steps: int = 4
    action_names = "left", "right"
    observation_space = property(lambda self: spaces.Discrete(5))
    action_space = property(lambda self: spaces.Discrete(2))
    def initial(self, rng): return 2
    def transition(self, state, action, rng): return state + 2 * action - 1
    def reward(self, state, action, next_state, rng): return 1.5 if next_state == 4 else 0.0
    def terminal(self, state): return state in (0, 4)
    def observation(self, state, rng): return state

class Still(gymnasium.Env):
    def __init__(self, action_space, observation=0): self.action_space, self.shown = action_space, observation
    def reset(self, *, seed=None, options=None): return self.shown, {}
"""
KINDS = cell(TASKS, {"__name__": __name__, "NamedTuple": NamedTuple, "gymnasium": gymnasium, "spaces": spaces})
Walk: Any = KINDS["Walk"]
"""Five places in a row; the walker starts in the middle, and the right end pays."""
Still: Any = KINDS["Still"]
"""An environment with any actions and observations, in which nothing happens and nothing can be seen."""

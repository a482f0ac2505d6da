"""A task for wrappers, and what an MDP shows on a random walk, interpreted and as machine code."""

from typing import Any

import numpy as np

from edugym import MDPEnv
from edugym.compiled.compiler import compiled
from edugym.mdp.protocol import Random, Reals
from tests.compiled.cells import cell

Shows: Any = cell("""
class Shows(NamedTuple):
    observation_space: object
    shown: object = None
    action_space: object = spaces.Discrete(2)
    def initial(self, rng): return (0.0, 0.0)
    def transition(self, state, action, rng): return action
    def reward(self, state, action, next_state, rng): return float(np.ravel(action)[0])
    def terminal(self, state): return False
    def observation(self, state, rng): return state if self.shown is None else self.shown
""")["Shows"]
"""Shows the same at every step, or its state, which is the last action."""


def watch(n_steps: int, mdp: Any, rng: Random, shown: Reals) -> None:
    """Take random steps, and note the observations (rows of a table) and rewards, shape (n_steps, 2)."""
    state = mdp.initial(rng)
    for step in range(n_steps):
        action = int(rng.random() * 2)
        next_state = mdp.transition(state, action, rng)
        shown[step, 1] = mdp.reward(state, action, next_state, rng)
        shown[step, 0] = mdp.observation(next_state, rng)
        state = mdp.initial(rng) if mdp.terminal(next_state) else next_state


def watched(mdp: Any, n_steps: int = 2_000, *, machine_code: bool = False) -> Reals:
    """What `watch` notes."""
    shown, rng = np.zeros((n_steps, 2)), np.random.default_rng(5)
    loop = compiled(watch, n_steps, mdp, rng, shown) if machine_code else watch
    loop(n_steps, mdp, rng, shown)
    return shown


def episode(task: Any, actions: list[int]) -> list[Any]:
    """What is shown in an episode."""
    env = MDPEnv(task)
    return [env.reset(seed=0)[0], *(env.step(action)[0] for action in actions)]

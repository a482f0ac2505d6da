"""What an MDP shows on a random walk, interpreted and as machine code."""

from typing import Any

import numpy as np

from edugym.compiled.compiler import compiled
from edugym.mdp.protocol import Random, Reals


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

"""The loops over the copies of a vector environment. They run as machine code where that is possible."""

from typing import Any, NamedTuple

from gymnasium.vector import AutoresetMode

from edugym.mdp.protocol import MDP, Random

MODES = [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP, AutoresetMode.DISABLED]
NEXT_STEP, SAME_STEP, DISABLED = range(3)
ACTION_OUTSIDE, STATE_LOST, OVER_AT_START = -1, -2, -3
"""What the loops return instead of a number of episodes: what is wrong.

An action is none, a state does not fit its storage, or an episode starts in a terminal state.
"""


class Batch(NamedTuple):
    """The copies less their states, and what a step gives: arrays with one place, or row, for each copy.

    (With the states in it, which may be in a list, Numba would need fifty microseconds a call to find its type.)
    """

    steps: Any
    over: Any
    observations: Any
    final_observations: Any
    rewards: Any
    terminations: Any
    truncations: Any


def reset_copies(n: int, mdp: MDP[Any, Any], rng: Random, mask: Any, states: Any, batch: Batch) -> int:
    """Start an episode in the first `n` copies, where `mask` says so, and observe them all."""
    for i in range(n):
        if mask[i]:
            if not states.store(i, mdp.initial(rng)):
                return STATE_LOST
            batch.steps[i] = 0
            batch.over[i] = False
        state = states.load(i)
        batch.observations.put(i, mdp, state, rng)
        if mask[i] and mdp.terminal(state):
            return OVER_AT_START
    return 0


def step_copies(
    n: int,
    mdp: MDP[Any, Any],
    rng: Random,
    actions: Any,
    whole: Any,
    n_actions: int,
    max_steps: int,
    autoreset: int,
    states: Any,
    batch: Batch,
) -> int:
    """Step the first `n` copies, and return how many episodes ended, or what is wrong (a negative number)."""
    for i in range(len(whole)):
        if whole[i] < 0 or whole[i] >= n_actions:
            return ACTION_OUTSIDE
    finished = 0
    for i in range(n):
        if batch.over[i] and autoreset == NEXT_STEP:
            state = mdp.initial(rng)
            if not states.store(i, state):
                return STATE_LOST
            batch.observations.put(i, mdp, state, rng)
            if mdp.terminal(state):
                return OVER_AT_START
            batch.steps[i] = 0
            batch.over[i] = False
            batch.rewards[i] = 0.0
            batch.terminations[i] = False
            batch.truncations[i] = False
            continue
        state = states.load(i)
        next_state = mdp.transition(state, actions[i], rng)
        batch.rewards[i] = mdp.reward(state, actions[i], next_state, rng)
        terminated = mdp.terminal(next_state) | 0  # stops at None and 0.5, which are no answers
        batch.steps[i] += 1
        truncated = batch.steps[i] == max_steps and not terminated
        batch.terminations[i] = terminated
        batch.truncations[i] = truncated
        batch.over[i] = terminated or truncated
        if batch.over[i]:
            finished += 1
            if autoreset == SAME_STEP:
                batch.final_observations.put(i, mdp, next_state, rng)
                next_state = mdp.initial(rng)
                batch.steps[i] = 0
                batch.over[i] = False
        batch.observations.put(i, mdp, next_state, rng)
        if batch.steps[i] == 0 and mdp.terminal(next_state):
            return OVER_AT_START
        if not states.store(i, next_state):
            return STATE_LOST
    return finished

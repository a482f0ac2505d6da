"""One episode of training, as the agent explores, to be replayed and watched."""

from collections.abc import Callable
from typing import Any

import numpy as np

from edugym.training.contract import learner


def attempt(make: Callable[[Any], Any], mdp: Any, after: int, seed: int = 0) -> list[int]:
    """Train an agent, and return its actions in one episode, exploring included.

    It is the first episode that starts when at least `after` training steps are done.

    This is the loop of Sutton and Barto in plain Python. Where nothing is random, as on a wall of Boulder, the actions
    are enough to replay the episode.

    Args:
        make: makes the agent for the MDP.
        mdp: the MDP, with a step limit, `max_steps`.
        after: how many training steps come before the episode, at least: they are whole episodes, so there may be more.
        seed: the seed of the agent.
    """
    agent = make(mdp)
    pupil, rng, steps = learner(agent), np.random.default_rng(seed), 0
    while True:
        state, actions, terminated = mdp.initial(rng), list[int](), False
        while not terminated and len(actions) < mdp.max_steps:
            action = agent.act(state, rng)
            next_state = mdp.transition(state, action, rng)
            reward = mdp.reward(state, action, next_state, rng)
            actions.append(int(action))
            terminated = mdp.terminal(next_state)
            pupil.learn(state, action, reward, next_state, terminated, len(actions) == mdp.max_steps)
            state = next_state
        if steps >= after:
            return actions
        steps += len(actions)

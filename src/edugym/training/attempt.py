"""Record the actions of one training episode, exploration included, to replay and watch it."""

from collections.abc import Callable
from typing import Any

import numpy as np

from edugym.checks.contract import contract_of, learner
from edugym.mdp.task import task_of


def attempt(make: Callable[[Any], Any], mdp: Any, after: int, seed: int = 0) -> list[int]:
    """Train an agent, and return its actions in one training episode, exploration included.

    It is the first episode that starts after at least `after` training steps. Where nothing is random, as on a wall of
    Boulder, the actions are enough to replay it.

    This is the loop of Q-learning (Sutton and Barto, the box of section 6.5) in plain Python.

    Args:
        make: makes the agent for the MDP. It is off-policy: its `learn` takes no `next_action`.
        mdp: an MDP with a step limit, `max_steps`.
        after: the minimum number of training steps before the episode. Only whole episodes count, so there may be more.
        seed: the seed of the agent and of the MDP.

    Raises:
        ValueError: the agent is on-policy, or the MDP has no step limit.
    """
    agent, limit = make(mdp), task_of(mdp, "mdp").max_steps
    contract = contract_of(agent)
    if contract.is_on_policy:
        raise ValueError(f"make must give an off-policy agent, but learn of {type(agent).__name__} takes `next_action`")
    if limit is None:
        raise ValueError(f"mdp must have a step limit, `max_steps`, but {type(mdp).__name__} has none")
    learning = learner(contract)  # its `learn` passes on only what the agent's own `learn` takes
    rng, steps = np.random.default_rng(seed), 0
    while True:
        state, actions, terminated = mdp.initial(rng), list[int](), False
        observation = mdp.observation(state, rng)
        while not terminated and len(actions) < limit:
            action = agent.act(observation, rng)
            next_state = mdp.transition(state, action, rng)
            reward = mdp.reward(state, action, next_state, rng)
            next_observation = mdp.observation(next_state, rng)
            actions.append(int(action))
            terminated = bool(mdp.terminal(next_state))
            truncated = not terminated and len(actions) == limit
            learning.learn(observation, action, reward, next_observation, terminated, truncated)
            state, observation = next_state, next_observation
        if steps >= after:
            return actions
        steps += len(actions)

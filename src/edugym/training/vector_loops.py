"""The interaction loop with vectors as rewards. It is plain Python and can be compiled, as in `training.loops`."""

import math
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from edugym.mdp.protocol import Actor, Integers, Random, Reals

Carry: TypeAlias = tuple[Any, Any, int, Reals]
"""What the loop carries from step to step: the state, its observation, and this episode's steps and returns so far."""


class Episodes(NamedTuple):
    """The training episodes that ended.

    Attributes:
        returns: shape (as many as there are steps, n_objectives): the undiscounted returns of each.
        ends: of the same length: the training step at which each ended, from 1 on.
        so_far: shape (2,): how many episodes ended, and how many steps were taken.
    """

    returns: Reals
    ends: Integers
    so_far: Integers


def start(mdp: Any, n_objectives: int, mdp_rng: Random) -> Carry:
    """The carry before the first step."""
    state = mdp.initial(mdp_rng)
    return state, mdp.observation(state, mdp_rng), 0, np.zeros(n_objectives)


def as_vector(rewards: Any, n_objectives: int) -> Reals:
    """The rewards as a new array of shape (n_objectives,).

    Raises:
        ValueError: one is not finite.
    """
    vector = np.zeros(n_objectives)
    for i in range(n_objectives):
        vector[i] = rewards[i]
        if not math.isfinite(vector[i]):
            raise ValueError("a reward is no finite number")
    return vector


def off_policy(
    n_steps: int,
    mdp: Any,
    agent: Any,
    max_steps: int,
    mdp_rng: Random,
    agent_rng: Random,
    episodes: Episodes,
    carry: Carry,
) -> Carry:
    """Take `n_steps` steps, learning before the next action is chosen, as `edugym.training.loops.off_policy` does.

    Args:
        n_steps: how many steps to take; episodes follow each other.
        mdp: the task with several objectives.
        agent: the agent, wrapped by `edugym.checks.contract.learner`.
        max_steps: after how many steps an episode is truncated.
        mdp_rng: what the task draws from.
        agent_rng: what the agent draws from.
        episodes: where the episodes that end are noted.
        carry: where to start: what `start` or the previous call returned.

    Returns:
        The carry after the last step.
    """
    state, observation, steps, total = carry
    for _ in range(n_steps):
        action = agent.act(observation, agent_rng)
        next_state = mdp.transition(state, action, mdp_rng)
        rewards = as_vector(mdp.rewards(state, action, next_state), len(total))
        reward = mdp.reward(state, action, next_state, mdp_rng)
        terminated = mdp.terminal(next_state)
        next_observation = mdp.observation(next_state, mdp_rng)
        steps += 1
        for i in range(len(total)):
            total[i] += rewards[i]
        truncated = steps == max_steps and not terminated
        agent.learn(observation, action, reward, next_observation, terminated, truncated, rewards)
        state, observation = next_state, next_observation
        episodes.so_far[1] += 1
        if terminated or truncated:
            episodes.returns[episodes.so_far[0]] = total
            episodes.ends[episodes.so_far[0]] = episodes.so_far[1]
            episodes.so_far[0] += 1
            state = mdp.initial(mdp_rng)
            observation = mdp.observation(state, mdp_rng)
            steps, total = 0, np.zeros(len(total))
    return state, observation, steps, total


def play_episodes(
    n_episodes: int, mdp: Any, actor: Actor[Any], max_steps: int, mdp_rng: Random, actor_rng: Random, returns: Reals
) -> None:
    """Play without learning, at most `max_steps` steps an episode.

    The undiscounted returns are written into `returns`, shape (n_episodes, n_objectives).
    """
    for episode in range(n_episodes):
        state = mdp.initial(mdp_rng)
        returns[episode] = 0.0
        steps = 0
        terminated = False
        while steps < max_steps and not terminated:
            action = actor.act(mdp.observation(state, mdp_rng), actor_rng)
            next_state = mdp.transition(state, action, mdp_rng)
            returns[episode] += as_vector(mdp.rewards(state, action, next_state), returns.shape[1])
            terminated = mdp.terminal(next_state)
            state = next_state
            steps += 1

"""The same loops for any Gymnasium environment, in plain Python."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Actor, Random
from edugym.training.loops import Carry, Log, OnPolicyCarry


def off_policy(
    n_steps: int, env: gymnasium.Env[Any, Any], agent: Any, max_steps: int, agent_rng: Random, log: Log, carry: Carry
) -> Carry:
    """Take `n_steps` steps, learning before the next action is chosen (Q-learning, section 6.5).

    The agent bootstraps where the environment truncates, and not where it terminates. Arguments and result are those of
    `edugym.training.loops.off_policy`; the environment keeps its state and random stream itself, so the carry has no
    state.
    """
    _, observation, steps, total = carry
    for _ in range(n_steps):
        action = agent.act(observation, agent_rng)
        next_observation, reward, terminated, truncated, _ = env.step(given(action, env))
        steps += 1
        total += float(reward)
        truncated = (truncated or steps == max_steps) and not terminated
        agent.learn(observation, action, float(reward), next_observation, terminated, truncated)
        observation = next_observation
        if terminated or truncated:
            log.returns[0] += total
            log.episodes[0] += 1
            observation, _ = env.reset()
            steps, total = 0, 0.0
    return None, observation, steps, total


def on_policy(
    n_steps: int,
    env: gymnasium.Env[Any, Any],
    agent: Any,
    max_steps: int,
    agent_rng: Random,
    log: Log,
    carry: OnPolicyCarry,
) -> OnPolicyCarry:
    """Take `n_steps` steps, choosing the next action before learning, which uses it (SARSA, section 6.4)."""
    _, observation, action, steps, total = carry
    for _ in range(n_steps):
        next_observation, reward, terminated, truncated, _ = env.step(given(action, env))
        next_action = action if terminated else agent.act(next_observation, agent_rng)
        steps += 1
        total += float(reward)
        truncated = (truncated or steps == max_steps) and not terminated
        agent.learn(observation, action, float(reward), next_observation, next_action, terminated, truncated)
        observation, action = next_observation, next_action
        if terminated or truncated:
            log.returns[0] += total
            log.episodes[0] += 1
            observation, _ = env.reset()
            action = agent.act(observation, agent_rng)
            steps, total = 0, 0.0
    return None, observation, action, steps, total


def play_episode(
    env: gymnasium.Env[Any, Any], actor: Actor[Any], max_steps: int, environment_rng: Random, actor_rng: Random
) -> float:
    """Play an episode without learning, in an environment seeded from `environment_rng`; its undiscounted return."""
    observation, _ = env.reset(seed=draw_seed(environment_rng))
    total = 0.0
    for _ in range(max_steps):
        observation, reward, terminated, truncated, _ = env.step(given(actor.act(observation, actor_rng), env))
        total += float(reward)
        if terminated or truncated:
            break
    return total


def given(action: Any, env: gymnasium.Env[Any, Any]) -> Any:
    """An action as the environment takes it: a tuple of real numbers, or an array, becomes an array of its own."""
    space = env.action_space
    return np.array(action, space.dtype) if isinstance(space, spaces.Box) else action


def draw_seed(rng: Random) -> int:
    """A seed for `reset`."""
    return int(rng.integers(2**31))

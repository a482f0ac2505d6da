"""The same loops for any Gymnasium environment, in plain Python."""

from typing import Any

import gymnasium

from edugym.mdp.protocol import Actor, Random, Reals
from edugym.training.loops import Log, Moment


def start_in_gymnasium(env: gymnasium.Env[Any, Any], agent: Any, environment_rng: Random, agent_rng: Random) -> Moment:
    """The moment before the first step, the environment seeded from `environment_rng`."""
    observation, _ = env.reset(seed=int(environment_rng.integers(2**31)))
    action = agent.act(observation, agent_rng) if getattr(agent, "on_policy", False) else 0
    return None, observation, action, 0, 0.0


def learn_in_gymnasium(
    n_steps: int,
    env: gymnasium.Env[Any, Any],
    agent: Any,
    max_steps: int,
    environment_rng: Random,
    agent_rng: Random,
    log: Log,
    moment: Moment,
) -> Moment:
    """Take `n_steps` steps. The agent bootstraps where the environment truncates, and not where it terminates."""
    on_policy = getattr(agent, "on_policy", False)
    _, observation, action, steps, total = moment
    for _ in range(n_steps):
        if not on_policy:
            action = agent.act(observation, agent_rng)
        next_observation, reward, terminated, truncated, _ = env.step(action)
        steps += 1
        total += float(reward)
        truncated = (truncated or steps == max_steps) and not terminated
        if on_policy:
            next_action = agent.act(next_observation, agent_rng)
            agent.learn(observation, action, float(reward), next_observation, next_action, terminated, truncated)
            action = next_action
        else:
            agent.learn(observation, action, float(reward), next_observation, terminated, truncated)
        observation = next_observation
        if terminated or truncated:
            log.returns[0] += total
            log.episodes[0] += 1
            observation, _ = env.reset()
            if on_policy:
                action = agent.act(observation, agent_rng)
            steps, total = 0, 0.0
    return None, observation, action, steps, total


def play_in_gymnasium(
    n_episodes: int,
    env: gymnasium.Env[Any, Any],
    actor: Actor[Any],
    max_steps: int,
    environment_rng: Random,
    actor_rng: Random,
    returns: Reals,
) -> None:
    """Play without learning, and write each episode's undiscounted return into `returns`, shape (n_episodes,)."""
    for episode in range(n_episodes):
        observation, _ = env.reset(seed=int(environment_rng.integers(2**31)))
        returns[episode] = 0.0
        for _ in range(max_steps):
            observation, reward, terminated, truncated, _ = env.step(actor.act(observation, actor_rng))
            returns[episode] += float(reward)
            if terminated or truncated:
                break

"""The interaction loops of agent and MDP, written as in the textbook.

They are plain Python and can be compiled. A long run is split into chunks: each call starts from a `Carry`, what the
loop carries from step to step, and returns the one at which it stopped. The result is exactly that of one long call.

Environment and agent have random streams of their own (`environment_rng`, `agent_rng`), so the random numbers of one
never depend on how many the other has drawn.

References: Sutton and Barto, 2nd edition: the boxes of sections 6.4 (SARSA) and 6.5 (Q-learning).
"""

from typing import Any, NamedTuple, TypeAlias

from edugym.mdp.protocol import MDP, Actor, Integers, Observation, Random, Reals, State

Carry: TypeAlias = tuple[Any, Any, int, float]
"""What a loop carries from step to step: the state, its observation, and this episode's steps and return so far."""
OnPolicyCarry: TypeAlias = tuple[Any, Any, Any, int, float]
"""Like `Carry`, with the next action, which is already chosen, as the third element."""


class Log(NamedTuple):
    """Sums over the training episodes that ended since the sums were last set to zero.

    Attributes:
        returns: shape (1,): the sum of their undiscounted returns.
        episodes: shape (1,): how many ended.
    """

    returns: Reals
    episodes: Integers


def start_off_policy(mdp: MDP[State, Observation], environment_rng: Random) -> Carry:
    """The carry before the first step."""
    state = mdp.initial(environment_rng)
    return state, mdp.observation(state, environment_rng), 0, 0.0


def start_on_policy(
    mdp: MDP[State, Observation], agent: Actor[Any], environment_rng: Random, agent_rng: Random
) -> OnPolicyCarry:
    """The carry before the first step, with the first action already chosen."""
    state, observation, steps, total = start_off_policy(mdp, environment_rng)
    return state, observation, agent.act(observation, agent_rng), steps, total


def off_policy(
    n_steps: int,
    mdp: MDP[Any, Any],
    agent: Any,
    max_steps: int,
    environment_rng: Random,
    agent_rng: Random,
    log: Log,
    carry: Carry,
) -> Carry:
    """Take `n_steps` steps, learning before the next action is chosen (Q-learning, section 6.5).

    Args:
        n_steps: how many steps to take; episodes follow each other.
        mdp: the task.
        agent: the agent, wrapped by `edugym.checks.contract.learner`. The wrapper's `learn` takes everything that
            this loop passes.
        max_steps: after how many steps an episode is truncated.
        environment_rng: what the task draws from.
        agent_rng: what the agent draws from.
        log: where the returns of the episodes that end are added up.
        carry: where to start: what `start_off_policy` or the previous call returned.

    Returns:
        The carry after the last step.
    """
    state, observation, steps, total = carry
    for _ in range(n_steps):
        action = agent.act(observation, agent_rng)
        next_state = mdp.transition(state, action, environment_rng)
        reward = mdp.reward(state, action, next_state, environment_rng)
        terminated = mdp.terminal(next_state)
        next_observation = mdp.observation(next_state, environment_rng)
        steps += 1
        total += reward
        truncated = steps == max_steps and not terminated
        agent.learn(observation, action, reward, next_observation, terminated, truncated)
        state, observation = next_state, next_observation
        if terminated or truncated:
            log.returns[0] += total
            log.episodes[0] += 1
            state = mdp.initial(environment_rng)
            observation = mdp.observation(state, environment_rng)
            steps, total = 0, 0.0
    return state, observation, steps, total


def on_policy(
    n_steps: int,
    mdp: MDP[Any, Any],
    agent: Any,
    max_steps: int,
    environment_rng: Random,
    agent_rng: Random,
    log: Log,
    carry: OnPolicyCarry,
) -> OnPolicyCarry:
    """Take `n_steps` steps. Choose the next action first, then learn from it (SARSA, section 6.4).

    After a terminal state there is no next action: `learn` is given the last action in its place, and must ignore it.
    When an episode is truncated, a next action is chosen and `learn` may use it, but it is never executed. Arguments
    and result are as in `off_policy`, except for the carry: it also holds the next action, and the first one comes
    from `start_on_policy`.
    """
    state, observation, action, steps, total = carry
    for _ in range(n_steps):
        next_state = mdp.transition(state, action, environment_rng)
        reward = mdp.reward(state, action, next_state, environment_rng)
        terminated = mdp.terminal(next_state)
        next_observation = mdp.observation(next_state, environment_rng)
        next_action = action if terminated else agent.act(next_observation, agent_rng)
        steps += 1
        total += reward
        truncated = steps == max_steps and not terminated
        agent.learn(observation, action, reward, next_observation, next_action, terminated, truncated)
        state, observation, action = next_state, next_observation, next_action
        if terminated or truncated:
            log.returns[0] += total
            log.episodes[0] += 1
            state = mdp.initial(environment_rng)
            observation = mdp.observation(state, environment_rng)
            action = agent.act(observation, agent_rng)
            steps, total = 0, 0.0
    return state, observation, action, steps, total


def play_episodes(
    n_episodes: int,
    mdp: MDP[Any, Any],
    actor: Actor[Any],
    max_steps: int,
    environment_rng: Random,
    actor_rng: Random,
    returns: Reals,
) -> None:
    """Play without learning, at most `max_steps` steps an episode, and write the undiscounted returns into `returns`.

    The shape of `returns` is (n_episodes,).
    """
    for episode in range(n_episodes):
        state = mdp.initial(environment_rng)
        steps, total = 0, 0.0
        terminated = False
        while steps < max_steps and not terminated:
            action = actor.act(mdp.observation(state, environment_rng), actor_rng)
            next_state = mdp.transition(state, action, environment_rng)
            total += mdp.reward(state, action, next_state, environment_rng)
            terminated = mdp.terminal(next_state)
            state = next_state
            steps += 1
        returns[episode] = total

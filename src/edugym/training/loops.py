"""The loops in which an agent meets an MDP, as in the textbook, and nothing else.

They are plain Python that `execution` also runs as machine code, in chunks: each takes the `moment` at which it
starts and returns the one at which it stops, so that a thousand chunks are one run, bit for bit.

Environment and agent draw from streams of their own (`environment_rng`, `agent_rng`), so that what one of them draws
never shifts what the other gets.

References: Sutton and Barto, 2nd edition: the boxes of section 6.4 (SARSA) and 6.5 (Q-learning).
"""

from typing import Any, NamedTuple, TypeAlias

from edugym.mdp.protocol import MDP, Actor, Integers, Observation, Random, Reals, State

Moment: TypeAlias = tuple[Any, Any, int, int, float]


class Log(NamedTuple):
    """Sums over the training episodes that ended since the sums were last set to zero.

    Attributes:
        returns: shape (1,): the sum of their undiscounted returns.
        episodes: shape (1,): how many ended.
    """

    returns: Reals
    episodes: Integers


def start(mdp: MDP[State, Observation], agent: Any, environment_rng: Random, agent_rng: Random) -> Moment:
    """The moment before the first step: (state, observation, action, steps of this episode, its return so far)."""
    state = mdp.initial(environment_rng)
    observation = mdp.observation(state, environment_rng)
    action = agent.act(observation, agent_rng) if getattr(agent, "on_policy", False) else 0
    return state, observation, action, 0, 0.0


def off_policy(
    n_steps: int,
    mdp: MDP[Any, Any],
    agent: Any,
    max_steps: int,
    environment_rng: Random,
    agent_rng: Random,
    log: Log,
    moment: Moment,
) -> Moment:
    """Take `n_steps` steps, learning before the next action is chosen (Q-learning, section 6.5)."""
    state, observation, action, steps, total = moment
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
    return state, observation, action, steps, total


def on_policy(
    n_steps: int,
    mdp: MDP[Any, Any],
    agent: Any,
    max_steps: int,
    environment_rng: Random,
    agent_rng: Random,
    log: Log,
    moment: Moment,
) -> Moment:
    """Take `n_steps` steps, choosing the next action before learning, which uses it (SARSA, section 6.4)."""
    state, observation, action, steps, total = moment
    for _ in range(n_steps):
        next_state = mdp.transition(state, action, environment_rng)
        reward = mdp.reward(state, action, next_state, environment_rng)
        terminated = mdp.terminal(next_state)
        next_observation = mdp.observation(next_state, environment_rng)
        next_action = agent.act(next_observation, agent_rng)
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
    """Play without learning, and write each episode's undiscounted return into `returns`, shape (n_episodes,)."""
    for episode in range(n_episodes):
        state = mdp.initial(environment_rng)
        total = 0.0
        for _ in range(max_steps):
            action = actor.act(mdp.observation(state, environment_rng), actor_rng)
            next_state = mdp.transition(state, action, environment_rng)
            total += mdp.reward(state, action, next_state, environment_rng)
            state = next_state
            if mdp.terminal(state):
                break
        returns[episode] = total


class GreedyActor(NamedTuple):
    """An agent as it acts when it is evaluated: by the action that it believes best."""

    agent: Any

    def act(self, state: Any, rng: Random) -> int:
        """The agent's greedy action."""
        action: int = self.agent.greedy(state, rng)
        return action


class OneStepAgent(NamedTuple):
    """An off-policy agent whose `learn` need not know of truncation, in a loop that tells it."""

    agent: Any

    def act(self, state: Any, rng: Random) -> int:
        """The agent's action."""
        action: int = self.agent.act(state, rng)
        return action

    def learn(self, state: Any, action: int, reward: float, next_state: Any, terminated: bool, truncated: bool) -> None:
        """Let the agent learn."""
        self.agent.learn(state, action, reward, next_state, terminated)


class OneStepOnPolicyAgent(NamedTuple):
    """An on-policy agent whose `learn` need not know of truncation, in a loop that tells it."""

    agent: Any

    @property
    def on_policy(self) -> bool:
        """So that the loop chooses the next action before it learns."""
        return True

    def act(self, state: Any, rng: Random) -> int:
        """The agent's action."""
        action: int = self.agent.act(state, rng)
        return action

    def learn(
        self,
        state: Any,
        action: int,
        reward: float,
        next_state: Any,
        next_action: int,
        terminated: bool,
        truncated: bool,
    ) -> None:
        """Let the agent learn."""
        self.agent.learn(state, action, reward, next_state, next_action, terminated)

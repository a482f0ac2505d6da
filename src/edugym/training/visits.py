"""How often an agent meets each state, and when: what it explores, made visible."""

from typing import Any, NamedTuple

import numpy as np

from edugym.checks.contract import FOR_OBJECTIVES, LEARN_PARAMETERS, contract_of, forget_episode, learner
from edugym.checks.parameters import number_of_steps, whole_number
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.task import table_size
from edugym.system.memory import require_memory
from edugym.training.evaluated import actor

MOST_INTERVALS = 1_000_000


class VisitRecorder(NamedTuple):
    """An agent that acts and learns as the one inside it, and counts the states it meets in training.

    It draws no random number, so that the run is the same as without it, bit for bit.

    Attributes:
        agent: the agent.
        learner: the same agent, in the form that the loops ask for.
        actor: the same agent as it acts when it is evaluated.
        visits: shape (n_intervals, n_states): how often each state was met in each interval of the training: every
            state in which it acted, and every terminal state that it entered.
        steps: shape (1,): the training steps so far.
        interval: shape (1,): the present interval.
        ends: shape (n_intervals - 1,): after how many steps each interval ends, but for the last, which never does.
    """

    agent: Any
    learner: Any
    actor: Any
    visits: Integers
    steps: Integers
    interval: Integers
    ends: Integers

    @property
    def recorded(self) -> Any:
        """The agent."""
        return self.agent

    def act(self, state: int, rng: Random) -> int:
        """The agent's action."""
        action: int = self.agent.act(state, rng)
        return action

    def greedy(self, state: int, rng: Random) -> int:
        """The action by which the agent is evaluated."""
        action: int = self.actor.act(state, rng)
        return action

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Count, and let the agent learn."""
        self.record(state, next_state, terminated)
        self.learner.learn(state, action, reward, next_state, terminated, truncated)

    def forget_episode(self) -> None:
        """Let the agent forget an episode that was not played to its end."""
        forget_episode(self.agent)

    def record(self, state: int, next_state: int, terminated: bool) -> None:
        """Count a step that was taken in `state`, and where it led if that is an end."""
        self.visits[self.interval[0], state] += 1
        if terminated:
            self.visits[self.interval[0], next_state] += 1
        self.steps[0] += 1  # a division at every step would take longer than what follows
        while self.interval[0] < len(self.ends) and self.steps[0] >= self.ends[self.interval[0]]:
            self.interval[0] += 1


class _Around(NamedTuple):
    """An agent that is told more than `VisitRecorder` is.

    Attributes:
        agent: the agent, with what counts around it.
        visits: shape (n_intervals, n_states): the counts, as in `VisitRecorder`.
    """

    agent: VisitRecorder
    visits: Integers

    @property
    def recorded(self) -> Any:
        """The agent."""
        return self.agent.agent

    def act(self, state: int, rng: Random) -> int:
        """The agent's action."""
        return self.agent.act(state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action by which the agent is evaluated."""
        return self.agent.greedy(state, rng)

    def forget_episode(self) -> None:
        """Let the agent forget an episode that was not played to its end."""
        self.agent.forget_episode()


class OnPolicyVisitRecorder(_Around):
    """The same for agents that learn from the action they will take next (SARSA)."""

    __slots__ = ()

    def learn(
        self,
        state: int,
        action: int,
        reward: float,
        next_state: int,
        next_action: int,
        terminated: bool,
        truncated: bool,
    ) -> None:
        """Count, and let the agent learn."""
        self.agent.record(state, next_state, terminated)
        self.agent.learner.learn(state, action, reward, next_state, next_action, terminated, truncated)


class VectorVisitRecorder(_Around):
    """The same for agents that learn from a vector of rewards."""

    __slots__ = ()

    def learn(
        self,
        state: int,
        action: int,
        reward: float,
        next_state: int,
        terminated: bool,
        truncated: bool,
        rewards: Reals,
    ) -> None:
        """Count, and let the agent learn."""
        self.agent.record(state, next_state, terminated)
        self.agent.learner.learn(state, action, reward, next_state, terminated, truncated, rewards)


def record_visits(
    agent: Any, environment: Any, n_steps: int, *, n_intervals: int = 100
) -> VisitRecorder | OnPolicyVisitRecorder | VectorVisitRecorder:
    """The agent, with a table `visits` that fills as it trains.

    ```python
    from edugym import Boulder, QLearning, record_visits, train

    mdp = Boulder.create(height=10)
    watched = record_visits(QLearning.create(mdp), mdp, 20_000)
    train(mdp, watched, 20_000, seed=1)
    print("visits of each state:", watched.visits.sum(axis=0))
    ```

    ```text
    visits of each state: [3239 2608 2269 2051 1891 1784 1686 1577 1495 1400 1332]
    ```

    Args:
        agent: an agent whose states are whole numbers; its own tables are changed in place as ever. It may be one for
            `edugym.objectives.train_vectors`, too.
        environment: an MDP or Gymnasium environment with whole numbers for observations and actions, or the shape
            (n_states, n_actions) of a table for it.
        n_steps: how many steps it will be trained for, 1 or more.
        n_intervals: into how many equal intervals they are divided, from 1 to 1 000 000.

    Raises:
        ValueError: a parameter is not as above.
    """
    n_steps = number_of_steps("n_steps", n_steps)
    n_intervals = whole_number("n_intervals", n_intervals, 1, MOST_INTERVALS)
    shape = n_intervals, table_size(environment)[0]
    require_memory("visits", shape, "take fewer n_intervals")
    visits = np.zeros(shape, np.int64)
    contract = contract_of(agent, (*LEARN_PARAMETERS, "rewards"))
    evaluated = actor(contract) if contract.has_greedy else agent
    takes_vectors = "rewards" in contract.learns_from
    learns = learner(contract, FOR_OBJECTIVES if takes_vectors else LEARN_PARAMETERS)
    ends = np.array([-(-k * n_steps // n_intervals) for k in range(1, n_intervals)], np.int64)
    steps, interval = np.zeros(1, np.int64), np.zeros(1, np.int64)
    recorder = VisitRecorder(agent, learns, evaluated, visits, steps, interval, ends)
    if takes_vectors:
        return VectorVisitRecorder(recorder, visits)
    return OnPolicyVisitRecorder(recorder, visits) if contract.is_on_policy else recorder

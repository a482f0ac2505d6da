"""Pareto Q-learning: a set of vectors for each action."""

from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.settings import Discount, Part, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action
from edugym.agents.vector_tables import OfActions
from edugym.checks.parameters import an_array
from edugym.exact.points import pareto_front
from edugym.mdp.multi_objective import table_shape
from edugym.mdp.protocol import Integers, Random, Reals

DIGITS = 9
"""Vectors that agree in so many digits after the point count as one."""


@shows_settings
class ParetoQLearning(NamedTuple):
    """Learn all Pareto-optimal policies at once: each action has a *set* of vectors, one for each good way to go on.

        R̄(S, A)  <- R̄(S, A) + [R - R̄(S, A)] / N(S, A)            N counts, so this is the mean of the rewards
        ND(S, A) <- the Pareto-optimal ones of all vectors in Q(S', a), for all a;  only 0 if S' is terminal
        where Q(s, a) = { R̄(s, a) + γ v : v in ND(s, a) }

    Nothing is weighted, so nothing is missed in a dent of the front. In the end `front(state)` is the Pareto front of
    the returns from a state on, and `follow(point)` plays an episode that earns one of them.

    While it learns, the value of an action is how many of the state's Pareto-optimal vectors are its own.

    Attributes:
        mean_rewards: R̄, shape (n_states, n_actions, n_objectives).
        visits: N, shape (n_states, n_actions).
        futures: ND: `futures[s][a]` is an array of shape (n_vectors, n_objectives), without vectors before a is tried.
        share: shape (1, n_actions): how many Pareto-optimal vectors come from each action, in the state that was
            looked at last.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen; it takes `share` as the values.

    Choices: Van Moffaert and Nowé have three ways to evaluate sets; this is that by cardinality. Vectors that agree in
    nine digits count as one. Of a next state that is drawn, ND(S, A) knows only the last one, so this agent is for
    tasks without chance in the next state. Where an episode can go on for ever, the sets may grow without end. It runs
    interpreted: machine code has no sets that grow and shrink.

    References: Van Moffaert and Nowé (2014), Multi-objective reinforcement learning using sets of Pareto dominating
    policies.
    """

    mean_rewards: Annotated[Reals, Table(("states", "actions", "objectives"))]
    visits: Annotated[Integers, Table(("states", "actions"))]
    futures: Annotated[list[list[Reals]], Part()]
    share: OfActions
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    @property
    def can_be_compiled(self) -> bool:
        """No: its sets have no fixed size."""
        return False

    def learn(self, state: int, action: int, rewards: Reals, next_state: int, terminated: bool) -> None:
        """Learn the mean of the rewards, and take over what is Pareto-optimal in S'."""
        self.visits[state, action] += 1
        self.mean_rewards[state, action] += (rewards - self.mean_rewards[state, action]) / self.visits[state, action]
        self.futures[state][action] = np.zeros((1, len(rewards))) if terminated else self.front(next_state)

    def vectors(self, state: int, action: int) -> Reals:
        """The set Q(s, a), shape (n_vectors, n_objectives)."""
        futures = self.futures[state][action]
        returns: Reals = self.mean_rewards[state, action] + self.discount * futures
        return returns

    def front(self, state: int) -> Reals:
        """The Pareto-optimal vectors of a state, shape (n_vectors, n_objectives), ascending in the first objective."""
        sets = [self.vectors(state, action) for action in range(len(self.futures[state]))]
        points = np.concatenate(sets)
        different = dict(zip(map(tuple, points.round(DIGITS).tolist()), points, strict=True))
        points = np.array([different[key] for key in sorted(different)]).reshape(-1, points.shape[1])
        optimal: Reals = points[pareto_front(points)]
        return optimal

    def look_at(self, state: int) -> None:
        """Write into `share` how many of the Pareto-optimal vectors come from each action."""
        sets = [self.vectors(state, action).round(DIGITS) for action in range(len(self.futures[state]))]
        optimal = pareto_front(np.concatenate(sets))
        owners = np.repeat(np.arange(len(sets)), [len(vectors) for vectors in sets])
        self.share[0] = np.bincount(owners[optimal], minlength=len(sets))

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        self.look_at(state)
        return self.exploration.choose(self.share, 0, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the most Pareto-optimal vectors."""
        self.look_at(state)
        return greedy_action(self.share, 0, rng)

    def follow(self, point: Any) -> "Follower":
        """A player of one episode that is to earn the returns `point`, one from the front of the first state.

        Raises:
            ValueError: it is no vector with a number for each objective.
        """
        return Follower(self, np.array(an_array("point", point, (self.mean_rewards.shape[2],))))

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "ParetoQLearning":
        """A new agent for a task.

        Args:
            environment: a task with several objectives (see `edugym.mdp.multi_objective`), or the shape (n_states,
                n_actions, n_objectives).
            **settings: the fields of the class that have a default.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        states, actions, objectives = table_shape(environment)
        futures = [[np.zeros((0, objectives)) for _ in range(actions)] for _ in range(states)]
        parts = {"futures": futures}
        return new(cls, None, settings, parts, states=states, actions=actions, objectives=objectives)


class Follower:
    """Plays one episode by the sets of `ParetoQLearning`, towards one vector of returns.

    In each state it takes the action with the vector that is closest to what is still to be earned; after it the
    future of that vector is still to be earned.
    """

    def __init__(self, agent: ParetoQLearning, point: Reals) -> None:
        """See `ParetoQLearning.follow`."""
        self._agent, self.rest = agent, point

    def act(self, state: int, rng: Random) -> int:
        """The action on the way to the point; a random one where the agent knows nothing."""
        agent, best, distance = self._agent, int(rng.integers(self._agent.visits.shape[1])), np.inf
        rest = self.rest
        for action, futures in enumerate(agent.futures[state]):
            for future, returns in zip(futures, agent.vectors(state, action), strict=True):
                if np.abs(returns - self.rest).sum() < distance:
                    best, distance, rest = action, np.abs(returns - self.rest).sum(), future
        self.rest = rest
        return best

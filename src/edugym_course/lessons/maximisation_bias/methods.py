"""What lesson 17 does: learners walk past a casino, over and over, and it is noted when they go in."""

import threading
from collections.abc import Iterator, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.agents.double_q_learning import DoubleQLearning
from edugym.agents.expected_sarsa import ExpectedSARSA
from edugym.agents.maxmin_q_learning import MaxminQLearning
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.casino import CASINO, IN, STREET
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Reals

N_MACHINES, N_EPISODES, REPETITIONS = 10, 300, 100
LEARNING_RATE, EPSILON, DISCOUNT = 0.1, 0.1, 1.0
Q_LEARNING, DOUBLE, EXPECTED = "Q-learning", "double Q-learning", "expected SARSA"
RIGHT_AT_FIRST = "Q-learning, all machines at −0.1 at first"
TWO, EIGHT = "maxmin Q-learning, N = 2", "maxmin Q-learning, N = 8"


def right_at_first(mdp: Any, **settings: Any) -> QLearning:
    """Return a Q-learner whose first values are right in the casino that does not pay."""
    agent = QLearning.create(mdp, **settings)
    agent.Q[CASINO] = -0.1
    return agent


METHODS: Mapping[str, Any] = MappingProxyType(
    {
        Q_LEARNING: QLearning.create,
        RIGHT_AT_FIRST: right_at_first,
        EXPECTED: ExpectedSARSA.create,
        DOUBLE: DoubleQLearning.create,
        TWO: partial(MaxminQLearning.create, n_tables=2),
        EIGHT: partial(MaxminQLearning.create, n_tables=8),
    }
)
IN_THE_FIGURE = (Q_LEARNING, EXPECTED, DOUBLE, TWO)
MIDDLE = slice(30, 100)
"""Episodes 31 to 100: the casino has been seen by then, and estimates rest on few tries."""
PAYING = MappingProxyType({"n_machines": 3, "advantage": 1.0})
"""A casino that pays: the last of three machines wins 0.9 on average, and the others lose 0.1."""
LONG, LATE = 600, slice(300, 600)
"""How many episodes there, and which count."""

ROUNDING = 1e-9
"""Means that differ by less are equal: sums of the same payoffs may differ in their last digit."""


class Walks(NamedTuple):
    """What learners did, by run and episode.

    Attributes:
        went_in: shape (runs, episodes): 1 for an episode that led into the casino, else 0.
        earned: shape (runs, episodes): the return of each episode.
    """

    went_in: Reals
    earned: Reals

    def share(self, episodes: slice = MIDDLE) -> Reals:
        """The share of these episodes that led into the casino, by run."""
        share: Reals = self.went_in[:, episodes].mean(axis=1)
        return share

    def income(self, episodes: slice = LATE) -> Reals:
        """The mean return of these episodes, by run."""
        income: Reals = self.earned[:, episodes].mean(axis=1)
        return income


def agent_of(
    method: str,
    mdp: Any,
    learning_rate: float = LEARNING_RATE,
    n_tables: int | None = None,
    epsilon: float = EPSILON,
) -> Any:
    """Return a new agent with the settings of the lesson; with `n_tables`, maxmin Q-learning with so many."""
    make = METHODS[method] if n_tables is None else partial(MaxminQLearning.create, n_tables=n_tables)
    return make(mdp, learning_rate=learning_rate, discount=DISCOUNT, exploration=EpsilonGreedy(epsilon))


def walk(mdp: Any, agent: Any, n_episodes: int, seed: int) -> tuple[Reals, Reals]:
    """Let an agent learn for some episodes, and return whether it went in and what it earned, by episode."""
    rng = np.random.default_rng(seed)
    went_in, earned = np.zeros((2, n_episodes))
    for episode in range(n_episodes):
        state, terminated = mdp.initial(rng), False
        while not terminated:
            action = agent.act(state, rng)
            next_state = mdp.transition(state, action, rng)
            reward = mdp.reward(state, action, next_state, rng)
            terminated = mdp.terminal(next_state)
            agent.learn(state, action, reward, next_state, terminated)
            went_in[episode] += state == STREET and action == IN
            earned[episode] += reward
            state = next_state
    return went_in, earned


def walks(
    method: str,
    n_episodes: int = N_EPISODES,
    *,
    learning_rate: float = LEARNING_RATE,
    n_tables: int | None = None,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
    **casino: Any,
) -> Walks:
    """Let new agents learn, over repetitions.

    Args:
        method: its label in `METHODS`.
        n_episodes: how many.
        learning_rate: α.
        n_tables: with a number, the agents are maxmin Q-learners with so many tables.
        repetitions: how many agents.
        seed: of the repetitions.
        stop: set by whoever wants no more.
        **casino: the parameters of Casino.
    """
    mdp = make_mdp("Casino", **casino)
    runs = [
        walk(mdp, agent_of(method, mdp, learning_rate, n_tables), n_episodes, number)
        for number in seeds(seed, repetitions, stop)
    ]
    return Walks(*np.array(runs).reshape(-1, 2, n_episodes).swapaxes(0, 1))


def values(
    method: str,
    n_episodes: int,
    *,
    epsilon: float = EPSILON,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
    **casino: Any,
) -> Reals:
    """The action values of agents after some episodes, shape (runs, 3, n_actions); for the arguments see `walks`."""
    mdp = make_mdp("Casino", **casino)
    found = []
    for number in seeds(seed, repetitions, stop):
        agent = agent_of(method, mdp, epsilon=epsilon)
        walk(mdp, agent, n_episodes, number)
        found.append(agent.Q)
    return np.array(found).reshape(-1, 3, int(mdp.action_space.n))


def goes_in(Q: Reals) -> Reals:
    """Whether going in has the highest value, 1 or 0, by run; Q has the shape (runs, 3, n_actions)."""
    street = Q[:, STREET]
    best: Reals = (street[:, IN] > np.delete(street, IN, axis=1).max(axis=1)).astype(float)
    return best


def best_income() -> float:
    """What the best ε-greedy policy earns in the casino that pays, exactly."""
    return value_iteration(finite_model(make_mdp("Casino", **PAYING)), DISCOUNT, epsilon=EPSILON).start


class Tried(NamedTuple):
    """What sample means say after every machine was tried n times, by repetition.

    Attributes:
        largest: the largest mean; of several tables, the largest of the smallest means.
        second_opinion: what as many new tries say of the machine that looks best.
    """

    largest: Reals
    second_opinion: Reals


def tried(
    n_tries: int,
    n_tables: int = 1,
    *,
    repetitions: int = 1000,
    seed: int = 0,
    stop: threading.Event | None = None,
    **casino: Any,
) -> Tried:
    """Try every machine n times for each table, over repetitions."""
    mdp = make_mdp("Casino", **casino)
    found = []
    for number in seeds(seed, repetitions, stop):
        rng = np.random.default_rng(number)
        means = _means(mdp, n_tries, n_tables, rng).min(axis=0)
        best = rng.choice(np.flatnonzero(means > means.max() - ROUNDING))
        found.append((means[best], _means(mdp, n_tries, 1, rng)[0, best]))
    return Tried(*np.array(found).reshape(-1, 2).T)


def _means(mdp: Any, n_tries: int, n_tables: int, rng: np.random.Generator) -> Reals:
    """The mean payoff of each machine in n tries, shape (n_tables, n_machines)."""
    k = mdp.n_machines
    wins = rng.binomial(n_tries, 0.5, (n_tables, k))
    means: Reals = (wins * mdp.payoffs[:k, 0] + (n_tries - wins) * mdp.payoffs[:k, 1]) / n_tries
    return means


def seeds(seed: int, repetitions: int, stop: threading.Event | None = None) -> Iterator[int]:
    """A seed for each repetition, until somebody stops."""
    for child in np.random.SeedSequence(seed).spawn(repetitions):
        if stop is not None and stop.is_set():
            return
        yield int(child.generate_state(1)[0])

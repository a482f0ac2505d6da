"""The exact policy of an agent, against its definition, and against what it is seen to do."""

import copy
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import (
    UCB,
    EpsilonGreedy,
    Greedy,
    LinearDecay,
    QLearning,
    ScheduledEpsilonGreedy,
    Softmax,
    finite_model,
    make_mdp,
)
from edugym.exact.policies import policy_of, soft
from edugym.mdp.protocol import Random, Reals
from tests.exact.tasks import Gambler, Hidden, Walk, Ways


class Table(NamedTuple):
    """An agent that acts by given probabilities, shape (observations, A)."""

    probabilities: Reals

    def act(self, state: int, rng: Random) -> int:
        """Draw an action."""
        return int(rng.choice(self.probabilities.shape[1], p=self.probabilities[state]))


def supermarket() -> tuple[Any, Any, Any]:
    """The task, its model, and an agent that has learnt a little of it, with many ties."""
    mdp = make_mdp("Supermarket")
    agent = QLearning.create(mdp, exploration=EpsilonGreedy(0.2))
    agent.Q[:] = np.random.default_rng(0).integers(0, 3, agent.Q.shape)
    return mdp, finite_model(mdp), agent


def test_an_epsilon_greedy_agent() -> None:
    """(1 - ε) shared by the best actions, and ε by all; by observation, not by row."""
    _, model, agent = supermarket()
    policy = policy_of(agent, model)
    greedy = policy_of(agent, model, greedy=True)
    for s, state in enumerate(model.states):
        best = agent.Q[state] == agent.Q[state].max()
        shared = best / best.sum() if not model.terminal[s] else np.full(4, 0.25)
        assert greedy[s] == pytest.approx(shared)
        assert policy[s] == pytest.approx(0.8 * shared + 0.05)


@pytest.mark.parametrize(
    "exploration",
    [
        Greedy(),
        EpsilonGreedy(0.3),
        Softmax(0.7),
        ScheduledEpsilonGreedy.create(LinearDecay(0.9, 0.1, 5)),
        UCB.create((3, 4), 0.5),
    ],
    ids=lambda strategy: type(strategy).__name__,
)
def test_every_strategy_is_followed_exactly(exploration: Any) -> None:
    """What the agent does next, many times over from the same moment, and it is left as it was."""
    model = finite_model(Ways())
    agent = QLearning(np.random.default_rng(1).integers(0, 2, (7, 4)).astype(float), exploration=exploration)
    if isinstance(exploration, UCB):
        counts = np.random.default_rng(2).integers(1, 4, (7, 4))
        agent = agent._replace(exploration=UCB(counts, np.zeros((1, 4)), 0.5))
    before = copy.deepcopy(agent)
    policy = policy_of(agent, model)
    assert policy.sum(axis=1) == pytest.approx(1.0)
    rng = np.random.default_rng(0)
    for s in (1, 3, 5):
        actions = [copy.deepcopy(agent).act(s, rng) for _ in range(600)]
        shares = np.bincount(actions, minlength=4) / 600
        assert (np.abs(shares - policy[s]) <= 6 * np.sqrt(policy[s] * (1 - policy[s]) / 600) + 1e-12).all()
    assert str(agent) == str(before)


def test_what_the_agent_sees_is_what_counts() -> None:
    """Where states look alike the agent acts alike; where the observation is random, by what it sees on average."""
    left, right = np.array([0.5, 0.2, 0.2, 0.1]), np.array([0.0, 0.1, 0.1, 0.8])
    policy = policy_of(Table(np.array([left, right])), finite_model(Hidden()))
    assert policy[1] == pytest.approx(left)
    assert policy[2] == pytest.approx(left)
    assert policy[5] == pytest.approx(right)
    assert policy[3] == pytest.approx(0.75 * left + 0.25 * right)
    assert policy[0].tolist() == policy[6].tolist() == [0.25] * 4


class Odd(NamedTuple):
    """An agent that returns what it should not."""

    action: Any

    def act(self, state: int, rng: Random) -> Any:
        """Return it."""
        return self.action


@pytest.mark.parametrize("action", [None, -1, 1, 0.5, "0", True, False, np.array([0])])
def test_actions_that_are_not_there(action: Any) -> None:
    """As when it is trained."""
    with pytest.raises(ValueError, match=r"act must return an action from 0 to 0, but returns"):
        policy_of(Odd(action), finite_model(Walk()))


def test_what_is_no_agent() -> None:
    """A class, a table, nothing; and an agent that draws what cannot be followed."""
    model = finite_model(Walk())
    for wrong in (QLearning, np.zeros((7, 1)), None):
        with pytest.raises(ValueError, match=r"agent must be an agent, with a method act\(state, rng\), but is"):
            policy_of(wrong, model)

    class Noisy(NamedTuple):
        def act(self, state: int, rng: Random) -> int:
            return int(rng.normal() > 0)

    with pytest.raises(ValueError, match=r"cannot follow rng\.normal"):
        policy_of(Noisy(), model)


def test_an_agent_without_a_greedy_policy() -> None:
    """Its policy is how it acts; what it may not return is told by the method that was asked."""
    model, right = finite_model(Hidden()), np.array([[0.5, 0.2, 0.2, 0.1], [0.0, 0.1, 0.1, 0.8]])
    assert np.array_equal(policy_of(Table(right), model, greedy=True), policy_of(Table(right), model))

    class Lost(Table):
        def greedy(self, state: int, rng: Random) -> int:
            return 4

    with pytest.raises(ValueError, match="greedy must return an action from 0 to 3, but returns 4"):
        policy_of(Lost(right), model, greedy=True)


def test_an_agent_that_cannot_be_looked_into() -> None:
    """One that counts, and holds what cannot be pickled, also counts from where it was in every state."""

    class Counting:
        def __init__(self) -> None:
            self.counts, self.held = [0], lambda: None

        def act(self, state: int, rng: Random) -> int:
            self.counts[0] += 1
            return (self.counts[0] - 1) % 4

    agent = Counting()
    assert policy_of(agent, finite_model(Ways()))[1:6].tolist() == [[1.0, 0.0, 0.0, 0.0]] * 5
    assert agent.counts == [0]


def test_too_many_ties(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fifty equal actions are drawn in 2^49 ways: the message says what the matter is."""
    monkeypatch.setattr("edugym.exact.policies.MAX_WAYS", 100)
    model = finite_model(Gambler())
    with pytest.raises(ValueError, match="can go more than 100 ways: are many actions equally good"):
        policy_of(QLearning.create(Gambler()), model)


def test_soft() -> None:
    """A share ε of each row goes to all actions alike."""
    greedy = np.array([[0.0, 1.0], [0.5, 0.5], [1.0, 0.0]])
    assert soft(greedy, 0.2).tolist() == [[0.1, 0.9], [0.5, 0.5], [0.9, 0.1]]
    assert soft(np.array([[0.0, 1.0, 0.0, 0.0]]), 0.5).tolist() == [[0.125, 0.625, 0.125, 0.125]]

"""The exact policy of an agent, against its definition, and against what it is seen to do."""

import copy
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import UCB, EpsilonGreedy, Greedy, LinearDecay, QLearning, ScheduledEpsilonGreedy, Softmax, make_mdp
from edugym.exact.model import finite_model
from edugym.exact.policies import policy_of, soft
from edugym.mdp.protocol import Random, Reals
from tests.exact.tasks import GAMBLER, Hidden, Walk


class Table(NamedTuple):
    """An agent that acts by given probabilities, shape (observations, A)."""

    probabilities: Reals

    def act(self, state: int, rng: Random) -> int:
        """Draw an action."""
        return int(rng.choice(self.probabilities.shape[1], p=self.probabilities[state]))


def test_an_epsilon_greedy_agent() -> None:
    """(1 - ε) shared by the best actions, of which there are many, and ε by all; by observation, not by row."""
    mdp = make_mdp("Supermarket")
    model, agent = finite_model(mdp), QLearning.create(mdp, exploration=EpsilonGreedy(0.2))
    agent.Q[:] = np.random.default_rng(0).integers(0, 3, agent.Q.shape)
    policy, greedy = policy_of(agent, model), policy_of(agent, model, greedy=True)
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
        UCB(np.random.default_rng(2).integers(1, 4, (7, 4)), np.zeros((1, 4)), 0.5),
    ],
    ids=lambda strategy: type(strategy).__name__,
)
def test_every_strategy_is_followed_exactly(exploration: Any) -> None:
    """What the agent does next, many times over from the same moment, and it is left as it was."""
    model = finite_model(Walk(4))
    agent = QLearning(np.random.default_rng(1).integers(0, 2, (7, 4)).astype(float), exploration=exploration)
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
    """Where states look alike it acts alike, where the observation is random by what it sees, and so without greedy."""
    left, right = np.array([0.5, 0.2, 0.2, 0.1]), np.array([0.0, 0.1, 0.1, 0.8])
    model, agent = finite_model(Hidden(4)), Table(np.array([left, right]))
    policy = policy_of(agent, model)
    assert policy[1] == pytest.approx(left)
    assert policy[2] == pytest.approx(left)
    assert policy[5] == pytest.approx(right)
    assert policy[3] == pytest.approx(0.75 * left + 0.25 * right)
    assert policy[0].tolist() == policy[6].tolist() == [0.25] * 4
    assert np.array_equal(policy_of(agent, model, greedy=True), policy)


def acting(choose: Any, name: str = "act") -> Any:
    """An agent that chooses in this way when it acts, or is greedy."""
    return SimpleNamespace(**{"act": lambda state, rng: 0, name: choose})


def test_wrong_agents() -> None:
    """Actions that are not there, as when it is trained; noise; and what is no agent."""
    wrong = [(acting(lambda *_, a=action: a), "act must .* 0 to 0") for action in (None, -1, 1, 0.5, "0", True, False)]
    wrong += [
        (acting(lambda state, rng: rng.normal() > 0), r"cannot follow rng\.normal"),
        (acting(lambda *_: 4, "greedy"), "greedy must return an action from 0 to 0, but returns 4"),
        (QLearning, r"agent must be an agent, with a method act\(state, rng\), but is"),
    ]
    for agent, message in wrong:
        with pytest.raises(ValueError, match=message):
            policy_of(agent, finite_model(Walk()), greedy=hasattr(agent, "greedy"))


def test_an_agent_that_cannot_be_looked_into() -> None:
    """One that counts, and holds what cannot be pickled, also counts from where it was in every state."""

    class Counting:
        def __init__(self) -> None:
            self.counts, self.held = [0], lambda: None

        def act(self, state: int, rng: Random) -> int:
            self.counts[0] += 1
            return (self.counts[0] - 1) % 4

    agent = Counting()
    assert policy_of(agent, finite_model(Walk(4)))[1:6].tolist() == [[1.0, 0.0, 0.0, 0.0]] * 5
    assert agent.counts == [0]


def test_too_many_ties(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fifty equal actions are drawn in 2^49 ways: the message says what the matter is."""
    monkeypatch.setattr("edugym.exact.policies.MAX_WAYS", 100)
    with pytest.raises(ValueError, match="can go more than 100 ways: are many actions equally good"):
        policy_of(QLearning.create(GAMBLER), finite_model(GAMBLER))


def test_soft() -> None:
    """A share ε of each row goes to all actions alike."""
    greedy = np.array([[0.0, 1.0], [0.5, 0.5], [1.0, 0.0]])
    assert soft(greedy, 0.2).tolist() == [[0.1, 0.9], [0.5, 0.5], [0.9, 0.1]]
    assert soft(np.array([[0.0, 1.0, 0.0, 0.0]]), 0.5).tolist() == [[0.125, 0.625, 0.125, 0.125]]

"""Expected SARSA: its update by hand, and its fixed point."""

import numpy as np
import pytest

from edugym import SARSA, EpsilonGreedy, ExpectedSARSA, Softmax
from tests.agents.case import Case
from tests.agents.walk import Walk, exact_values

CASES = {
    "ExpectedSARSA": Case(ExpectedSARSA, lambda e: ExpectedSARSA.create(e, learning_rate=0.5, discount=0.5), True),
    "ExpectedSARSA, softmax": Case(ExpectedSARSA, lambda e: ExpectedSARSA.create(e, exploration=Softmax(0.3))),
}


@pytest.mark.parametrize(
    ("values", "terminated", "target"),
    [
        ([3.0, 5.0], False, 1 + 0.9 * (0.2 * 3 + 0.8 * 5)),  # ε = 0.4: the best with 0.6 + 0.2
        ([5.0, 5.0], False, 1 + 0.9 * 5),
        ([3.0, 5.0], True, 1.0),  # nothing comes after an end
    ],
)
def test_update(values: list[float], terminated: bool, target: float) -> None:
    """Equation 6.9 with α = 0.5, γ = 0.9 and ε = 0.4 changes one entry."""
    agent = ExpectedSARSA(np.array([[1.0, 2.0], values]), 0.5, 0.9, EpsilonGreedy(0.4))
    agent.learn(0, 1, 1.0, 1, terminated)
    assert agent.Q[0, 1] == pytest.approx(2 + 0.5 * (target - 2), rel=1e-15)
    agent.Q[0, 1] = 2.0
    assert agent.Q.tolist() == [[1.0, 2.0], values]


def test_the_mean_of_sarsas_updates_is_its_update() -> None:
    """Over the actions that may come next, each by its probability."""
    Q, exploration = np.random.default_rng(0).normal(size=(2, 4)), Softmax(0.7)
    expected = ExpectedSARSA(Q.copy(), 0.3, 0.9, exploration)
    expected.learn(0, 2, 1.0, 1, False)
    mean = 0.0
    for b in range(4):
        sarsa = SARSA(Q.copy(), 0.3, 0.9, exploration)
        sarsa.learn(0, 2, 1.0, 1, b, False)
        mean += exploration.probability(Q, 1, b) * sarsa.Q[0, 2]
    assert expected.Q[0, 2] == pytest.approx(mean, rel=1e-14)


@pytest.mark.parametrize("epsilon", [0.0, 0.3])
def test_its_fixed_point_is_the_best_epsilon_soft_policy(epsilon: float) -> None:
    """Without chance in the task, whatever the learning rate: the exact values, of every pair."""
    mdp = Walk(slip=0.0)
    exact = exact_values(mdp, 0.9, epsilon=epsilon)
    agent = ExpectedSARSA.create(mdp, discount=0.9, learning_rate=1, exploration=EpsilonGreedy(epsilon))
    rng = np.random.default_rng(0)
    for _ in range(2_000):
        s, a = int(rng.integers(1, 4)), int(rng.integers(2))
        n = mdp.transition(s, a, rng)
        agent.learn(s, a, mdp.reward(s, a, n, rng), n, mdp.terminal(n))
    assert pytest.approx(exact, abs=1e-8) == agent.Q
    assert exact_values(mdp, 0.9, epsilon=0.15) != pytest.approx(exact, abs=1e-2)

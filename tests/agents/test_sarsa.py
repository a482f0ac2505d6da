"""SARSA: its update by hand, and the exact values it leaves alone."""

import numpy as np
import pytest

from edugym import SARSA, EpsilonGreedy, finite_model
from tests.agents.case import Case
from tests.agents.walk import Walk, exact_values

CASES = {"SARSA": Case(SARSA, lambda env: SARSA.create(env, learning_rate=0.5, discount=0.5), True)}


@pytest.mark.parametrize(
    ("next_action", "terminated", "expected"),
    [
        (0, False, 2 + 0.5 * (1 + 0.9 * 3 - 2)),  # = 2.85: the action that comes counts, though it is not the best
        (1, False, 2 + 0.5 * (1 + 0.9 * 5 - 2)),  # = 3.75
        (1, True, 2 + 0.5 * (1 - 2)),  # = 1.5: nothing comes after an end
    ],
)
def test_update(next_action: int, terminated: bool, expected: float) -> None:
    """Equation 6.7 with α = 0.5 and γ = 0.9 changes one entry."""
    table = [[1.0, 2.0], [3.0, 5.0]]
    agent = SARSA(np.array(table), 0.5, 0.9)
    agent.learn(0, 1, 1.0, 1, next_action, terminated)
    assert agent.Q[0, 1] == pytest.approx(expected, rel=1e-15)
    agent.Q[0, 1] = 2.0
    assert agent.Q.tolist() == table


def test_its_mean_step_is_zero_at_the_values_of_its_policy() -> None:
    """At the exact values of the best ε-greedy policy the expected TD error of every pair vanishes."""
    mdp, discount, exploration = Walk(), 0.9, EpsilonGreedy(0.3)
    model, Q = finite_model(mdp), exact_values(mdp, discount, epsilon=0.3)
    for s in (1, 2, 3):
        for a in (0, 1):
            step = 0.0
            for outcome in model.outcomes(s, a):
                for b in (0, 1):
                    agent = SARSA(Q.copy(), 1.0, discount)
                    agent.learn(s, a, outcome.reward, outcome.next_state, b, outcome.terminated)
                    share = outcome.probability * exploration.probability(Q, outcome.next_state, b)
                    step += share * (agent.Q[s, a] - Q[s, a])
            assert step == pytest.approx(0.0, abs=1e-8)
    assert not np.allclose(Q, exact_values(mdp, discount), atol=1e-2)  # with ε = 0 these are others

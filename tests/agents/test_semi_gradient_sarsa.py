"""Semi-gradient SARSA's update, worked out by hand."""

import numpy as np
import pytest

from edugym import SemiGradientSARSA, TileCoding
from tests.agents.case import Case

CASES = {"SemiGradientSARSA": Case(SemiGradientSARSA, SemiGradientSARSA.create)}


@pytest.mark.parametrize(
    ("terminated", "error"),
    [
        (False, 1 + 0.5 * (3 * 4 + 20) - (2 * 1 + 10)),  # = 5: the next action, 1, counts
        (True, 1 - (2 * 1 + 10)),  # = -11: nothing comes after an end
    ],
)
def test_update(terminated: bool, error: float) -> None:
    """Weights as below, S = (2, 0), S' = (0, 3), and a constant of 1; A = 0, A' = 1, R = 1, α = 0.1, γ = 0.5."""
    agent = SemiGradientSARSA.create((2, 2), learning_rate=0.1, discount=0.5)
    agent.weights[:] = [[1, 2], [3, 4], [10, 20]]
    agent.learn(np.array([2.0, 0.0]), 0, 1.0, np.array([0.0, 3.0]), 1, terminated)
    assert agent.weights == pytest.approx(np.array([[1 + 0.1 * error * 2, 2], [3, 4], [10 + 0.1 * error, 20]]))


def test_a_rate_of_1_corrects_the_whole_error_with_tiles() -> None:
    """Eight tiles share the work."""
    agent = SemiGradientSARSA.create((1, 2), learning_rate=1.0, features=TileCoding.create((1, 2)))
    agent.learn(np.array([0.4]), 1, 7.0, np.array([0.5]), 0, True)
    rng = np.random.default_rng(0)
    agent.greedy(np.array([0.4]), rng)
    assert agent.Q.tolist() == [[0.0, 7.0]]
    assert np.count_nonzero(agent.weights) == 8

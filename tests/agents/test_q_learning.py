"""Q-learning's update, worked out by hand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from edugym import QLearning
from edugym.mdp.protocol import Reals
from tests.agents.case import Case

CASES = {"QLearning": Case(QLearning, lambda env: QLearning.create(env, learning_rate=0.5, discount=0.5), True)}


def agent_with(Q: list[list[float]], learning_rate: float = 0.5, discount: float = 0.9) -> QLearning:
    """An agent with these values."""
    return QLearning(np.array(Q), learning_rate, discount)


@pytest.mark.parametrize(
    ("state", "action", "reward", "next_state", "terminated", "expected"),
    [
        (0, 1, 1.0, 1, False, 2 + 0.5 * (1 + 0.9 * 5 - 2)),  # = 3.75: the best of [3, 5] counts
        (0, 1, 1.0, 1, True, 2 + 0.5 * (1 - 2)),  # = 1.5: nothing comes after an end
        (1, 0, -1.0, 0, False, 3 + 0.5 * (-1 + 0.9 * 2 - 3)),  # = 1.9
        (1, 1, 0.0, 1, False, 5 + 0.5 * (0 + 0.9 * 5 - 5)),  # = 4.75: back to itself, the value before the update
        (0, 0, 2.0, 2, False, 1 + 0.5 * (2 + 0.9 * -1 - 1)),  # = 1.05: all values negative
    ],
)
def test_update(state: int, action: int, reward: float, next_state: int, terminated: bool, expected: float) -> None:
    """Equation 6.8 with α = 0.5 and γ = 0.9 changes one entry."""
    table = [[1.0, 2.0], [3.0, 5.0], [-4.0, -1.0]]
    agent = agent_with(table)
    agent.learn(state, action, reward, next_state, terminated)
    assert agent.Q[state, action] == pytest.approx(expected, rel=1e-15)
    agent.Q[state, action] = table[state][action]
    assert agent.Q.tolist() == table


values = st.floats(-1e3, 1e3)


@given(arrays(np.float64, (3, 2), elements=values), st.floats(0.01, 1), st.floats(0, 1), values, st.booleans())
def test_update_is_the_textbook_line(Q: Reals, alpha: float, gamma: float, reward: float, end: bool) -> None:
    """The same as the line that everyone writes with NumPy."""
    agent = QLearning(Q.copy(), alpha, gamma)
    agent.learn(0, 1, reward, 2, end)
    Q[0, 1] += alpha * (reward + gamma * (not end) * Q[2].max() - Q[0, 1])
    assert pytest.approx(Q) == agent.Q


def test_initial_values_are_optimistic_on_demand() -> None:
    """Every entry starts from `initial_value` (section 2.6)."""
    assert (np.full((2, 3), 5.0) == QLearning.create((2, 3), initial_value=5).Q).all()
    assert not QLearning.create((2, 3)).Q.any()
    assert QLearning.create((2, 3), initial_value=5).Q.dtype == np.float64

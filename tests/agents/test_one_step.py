"""The agents that learn from one step at a time: their updates by hand, and their biases.

SARSA and expected SARSA are compared with methods of several steps in `test_special_cases`.
"""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import edugym as eg
from edugym.mdp.protocol import Reals
from tests.agents.walk import Gamble

TABLE = [[1.0, 2.0], [3.0, 5.0], [-4.0, -1.0]]


values = st.floats(-1e3, 1e3)


@given(arrays(np.float64, (3, 2), elements=values), st.floats(0.01, 1), st.floats(0, 1), values, st.booleans())
def test_q_learning_is_the_textbook_line(Q: Reals, alpha: float, gamma: float, reward: float, end: bool) -> None:
    """The same as the line that everyone writes with NumPy."""
    agent = eg.QLearning(Q.copy(), alpha, gamma)
    agent.learn(0, 1, reward, 2, end)
    Q[0, 1] += alpha * (reward + gamma * (not end) * Q[2].max() - Q[0, 1])
    assert pytest.approx(Q) == agent.Q


def test_initial_values_are_optimistic_on_demand() -> None:
    """Every entry starts from `initial_value` (section 2.6)."""
    for value in (5, 0):
        Q = eg.QLearning.create((2, 3), initial_value=value).Q
        assert np.array_equal(Q, np.full((2, 3), float(value)))
        assert Q.dtype == np.float64
    assert not eg.QLearning.create((2, 3)).Q.any()


def test_the_first_updates_of_counting_by_hand() -> None:
    """Three times from state 0 to state 1, where max Q(1, ·) = 4; the third is an end, but the bonus is paid."""
    agent, learned = eg.CountBased.create((2, 2), bonus=2.0, learning_rate=0.5, discount=0.5), 0.0
    agent.Q[1] = [-1.0, 4.0]
    for visit, following in ((1, 4.0), (2, 4.0), (3, 0.0)):
        agent.learn(0, 1, 1.0, 1, visit == 3)
        learned += 0.5 * (1 + 2 / math.sqrt(visit) + 0.5 * following - learned)
        assert agent.Q[0].tolist() == pytest.approx([0, learned])
    assert agent.visits.tolist() == [0, 3]


ONE, TWO = [[1, 2], [3, 5]], [[4, 6], [8, 7]]


@pytest.mark.parametrize(
    ("coin", "Q1", "terminated", "value"),
    [
        (0, ONE, False, 2 + 0.5 * (1 + 0.9 * 7 - 2)),  # the best of [3, 5] is 1, of which Q₂ says 7
        (1, ONE, False, 6 + 0.5 * (1 + 0.9 * 3 - 6)),  # the best of [8, 7] is 0, of which Q₁ says 3
        (0, [[1, 2], [5, 5]], False, 2 + 0.5 * (1 + 0.9 * 7.5 - 2)),  # of equally good actions the mean of 8 and 7
        (0, ONE, True, 2 + 0.5 * (1 - 2)),
        (1, ONE, True, 6 + 0.5 * (1 - 6)),
    ],
)
def test_update_of_double_q_learning(coin: int, Q1: Any, terminated: bool, value: float) -> None:
    """The box of section 6.7 changes one entry of one table, and the mean; α = 0.5, γ = 0.9."""
    one, two = np.array(Q1, float), np.array(TWO, float)
    agent = eg.DoubleQLearning((one + two) / 2, one, two, np.array([coin]), 0.5, 0.9)
    agent.learn(0, 1, 1.0, 1, terminated)
    after = [np.array(Q1, float), np.array(TWO, float)]
    after[coin][0, 1] = value
    assert [pytest.approx(table, rel=1e-15) for table in after] == [agent.Q1, agent.Q2]
    assert np.array_equal(agent.Q, (agent.Q1 + agent.Q2) / 2)


def test_the_coin_is_fair_and_tossed_for_every_action() -> None:
    """Within five standard deviations."""
    agent, rng, tosses = eg.DoubleQLearning.create((2, 2)), np.random.default_rng(0), []
    for _ in range(4_000):
        agent.act(0, rng)
        tosses.append(int(agent.coin[0]))
    assert np.mean(tosses) == pytest.approx(0.5, abs=5 * 0.5 / 4_000**0.5)


def test_double_q_learning_does_not_take_noise_for_value() -> None:
    """Figure 6.5: Q-learning hopes for B, where nothing is to be had; double Q-learning does not."""

    def hope(kind: Any) -> Any:
        found, mdp = [], Gamble()
        for seed in range(10):
            agent = kind.create(mdp, discount=1, exploration=eg.EpsilonGreedy(1))
            eg.train(mdp, agent, 5_000, seed=seed, evaluate_every=5_000)
            found.append(agent.Q[0, 1::2].mean())
        return eg.mean_interval(found)

    assert hope(eg.QLearning).low > 0.1  # the truth is -0.1
    assert hope(eg.DoubleQLearning).high < 0


THREE = [[[1, 2], [3, 5]], [[4, 6], [8, 4]], [[2, 3], [7, 9]]]


@pytest.mark.parametrize(
    ("turn", "terminated", "value", "smallest"),
    [
        (0, False, 2 + 0.5 * (1 + 0.9 * 4 - 2), 3),  # the minima of state 1 are [3, 4]; now Q₃ has the least, 3
        (1, False, 6 + 0.5 * (1 + 0.9 * 4 - 6), 2),
        (2, True, 3 + 0.5 * (1 - 3), 2),
        (1, True, 6 + 0.5 * (1 - 6), 2),
        (0, True, 2 + 0.5 * (1 - 2), 1.5),
    ],
)
def test_update_of_maxmin_q_learning(turn: int, terminated: bool, value: float, smallest: float) -> None:
    """The box changes one entry of one of three tables, and the minimum; α = 0.5, γ = 0.9."""
    tables = np.array(THREE, float)
    agent = eg.MaxminQLearning(tables.min(axis=0), tables.copy(), np.array([turn]), 0.5, 0.9)
    agent.learn(0, 1, 1.0, 1, terminated)
    tables[turn, 0, 1] = value
    assert pytest.approx(tables, rel=1e-15) == agent.tables
    assert np.array_equal(agent.Q, agent.tables.min(axis=0))
    assert agent.Q[0, 1] == pytest.approx(smallest)


@given(st.integers(1, 5), st.integers(0, 10**6), st.floats(0.01, 1), st.floats(0, 1))
def test_maxmin_q_learning_agrees_with_numpy(n_tables: int, seed: int, alpha: float, gamma: float) -> None:
    """To 1e-12, over fifty random steps, with tables that the agent has drawn."""
    rng = np.random.default_rng(seed)
    agent = eg.MaxminQLearning.create((4, 3), n_tables=n_tables, learning_rate=alpha, discount=gamma, initial_value=2)
    Q = np.full((n_tables, 4, 3), 2.0)
    for _ in range(50):
        s, n, reward, end = rng.integers(4), rng.integers(4), rng.normal(), bool(rng.random() < 0.2)
        a = agent.act(int(s), rng)
        i = agent.turn[0]
        agent.learn(int(s), a, reward, int(n), end)
        Q[i, s, a] = (1 - alpha) * Q[i, s, a] + alpha * (reward + (0 if end else gamma * Q.min(axis=0)[n].max()))
    assert np.abs(agent.tables - Q).max() < 1e-12
    assert np.abs(agent.Q - Q.min(axis=0)).max() < 1e-12


def test_every_table_has_its_turn() -> None:
    """Each of five in a fifth of the steps, within five standard deviations."""
    agent, rng = eg.MaxminQLearning.create((2, 2), n_tables=5), np.random.default_rng(0)
    turns = []
    for _ in range(4_000):
        agent.act(0, rng)
        turns.append(int(agent.turn[0]))
    assert np.bincount(turns) / 4_000 == pytest.approx(0.2, abs=5 * 0.4 / 4_000**0.5)


@pytest.mark.parametrize("risk", [-2.0, 0.0, 0.7])
@pytest.mark.parametrize(
    ("reward", "terminated", "delta"),
    [(1.0, False, 1 + 0.9 * 5 - 2), (1.0, True, 1 - 2), (-9.0, False, -9 + 0.9 * 5 - 2)],
)
def test_update_of_risk_sensitive_q_learning(risk: float, reward: float, terminated: bool, delta: float) -> None:
    """α = 0.25: Q + α 2 δ / (1 + exp(-βδ)), and no other entry."""
    agent = eg.RiskSensitiveQLearning(np.array(TABLE), risk, 0.25, 0.9)
    agent.learn(0, 1, reward, 1, terminated)
    assert agent.Q[0, 1] == pytest.approx(2 + 0.25 * 2 * delta / (1 + math.exp(-risk * delta)), rel=1e-12)
    agent.Q[0, 1] = 2.0
    assert agent.Q.tolist() == TABLE


def test_surprises_of_any_size_do_not_overflow() -> None:
    """A huge good one weighs nothing to who avoids risk, and twice to who seeks it."""
    for risk, value in ((-2.0, 0.0), (2.0, 1e300)):
        agent = eg.RiskSensitiveQLearning.create((1, 1), risk=risk, learning_rate=0.5)
        agent.learn(0, 0, 1e300, 0, True)
        assert agent.Q[0, 0] == value


@pytest.mark.parametrize(
    ("kind", "more", "following"), [(eg.LinearQLearning, (), 32), (eg.SemiGradientSARSA, (0,), 19)]
)
@pytest.mark.parametrize("terminated", [True, False])
def test_update_of_linear_values(kind: Any, more: Any, following: float, terminated: bool) -> None:
    """S = (2, 0), S' = (0, 3), and a constant of 1; A = 0, A' = 0, R = 1, α = 0.1, γ = 0.5.

    Q(S, A) = 2·1 + 10 = 12; Q(S', ·) = (3·3 + 10, 3·4 + 20) = (19, 32).
    """
    agent = kind.create((2, 2), learning_rate=0.1, discount=0.5)
    agent.weights[:] = [[1, 2], [3, 4], [10, 20]]
    agent.learn(np.array([2.0, 0.0]), 0, 1.0, np.array([0.0, 3.0]), *more, terminated)
    error = 1 + (0 if terminated else 0.5 * following) - 12
    assert agent.weights == pytest.approx(np.array([[1 + 0.1 * error * 2, 2], [3, 4], [10 + 0.1 * error, 20]]))


def test_a_rate_of_1_corrects_the_whole_error_with_tiles() -> None:
    """Eight tiles share the work."""
    agent = eg.SemiGradientSARSA.create((1, 2), learning_rate=1.0, features=eg.TileCoding.create((1, 2)))
    agent.learn(np.array([0.4]), 1, 7.0, np.array([0.5]), 0, True)
    agent.greedy(np.array([0.4]), np.random.default_rng(0))
    assert agent.Q.tolist() == [[0.0, 7.0]]
    assert np.count_nonzero(agent.weights) == 8

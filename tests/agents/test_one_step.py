"""The agents that learn from one step at a time: their updates by hand, their fixed points, and their biases."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import edugym as eg
from edugym.mdp.protocol import Reals
from edugym_course.lessons.dimensionality.baird import weights_of_solid
from tests.agents.walk import Gamble

TABLE = [[1.0, 2.0], [3.0, 5.0], [-4.0, -1.0]]


def sarsa(Q: Reals) -> eg.SARSA:
    """α = 0.25 and γ = 0.9."""
    return eg.SARSA(Q, 0.25, 0.9)


def expected(Q: Reals) -> eg.ExpectedSARSA:
    """The best action of [3, 5] has a probability of 0.6 + 0.2, the other one of 0.2."""
    return eg.ExpectedSARSA(Q, 0.25, 0.9, eg.EpsilonGreedy(0.4))


def q_learning(Q: Reals) -> eg.QLearning:
    """α = 0.25 and γ = 0.9."""
    return eg.QLearning(Q, 0.25, 0.9)


@pytest.mark.parametrize(
    ("make", "step", "target"),
    [
        (q_learning, (0, 1, 1.0, 1, False), 1 + 0.9 * 5),  # the best of [3, 5] counts
        (q_learning, (0, 1, 1.0, 1, True), 1),  # nothing comes after an end
        (q_learning, (1, 1, 0.0, 1, False), 0.9 * 5),  # back to itself, the value before the update
        (q_learning, (0, 0, 2.0, 2, False), 2 + 0.9 * -1),  # all values negative
        (sarsa, (0, 1, 1.0, 1, 0, False), 1 + 0.9 * 3),  # the action that comes counts, though it is not the best
        (sarsa, (0, 1, 1.0, 1, 1, False), 1 + 0.9 * 5),
        (sarsa, (0, 1, 1.0, 1, 1, True), 1),
        (expected, (0, 1, 1.0, 1, False), 1 + 0.9 * (0.2 * 3 + 0.8 * 5)),
        (expected, (0, 1, 1.0, 1, True), 1),
    ],
)
def test_update(make: Any, step: tuple[Any, ...], target: float) -> None:
    """Equations 6.7 to 6.9 with α = 0.25 change one entry a quarter of the way to the target."""
    agent = make(np.array(TABLE))
    agent.learn(*step)
    state, action, *_ = step
    assert agent.Q[state, action] == pytest.approx(0.75 * TABLE[state][action] + 0.25 * target, rel=1e-14)
    agent.Q[state, action] = TABLE[state][action]
    assert agent.Q.tolist() == TABLE


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
    assert (np.full((2, 3), 5.0) == eg.QLearning.create((2, 3), initial_value=5).Q).all()
    assert not eg.QLearning.create((2, 3)).Q.any()
    assert eg.QLearning.create((2, 3), initial_value=5).Q.dtype == np.float64


def test_the_first_updates_of_counting_by_hand() -> None:
    """Three times from state 0 to state 1, with β = 2, α = 1/2, γ = 1/2 and max Q(1, ·) = 4.

    Visit 1: R+ = 1 + 2/√1 = 3,      target 3 + 4/2 = 5:      Q = 0 + (5 - 0)/2 = 5/2.
    Visit 2: R+ = 1 + 2/√2 = 2.4142, target 4.4142:           Q = 5/2 + (4.4142 - 5/2)/2 = 3.4571.
    Visit 3: an end: nothing comes after, but the bonus is paid:
             R+ = 1 + 2/√3 = 2.1547, target 2.1547:           Q = 3.4571 + (2.1547 - 3.4571)/2 = 2.8059.
    """
    agent = eg.CountBased.create((2, 2), bonus=2.0, learning_rate=0.5, discount=0.5)
    agent.Q[1] = [-1.0, 4.0]
    for terminated, learned in ((False, 2.5), (False, 3.4571), (True, 2.8059)):
        agent.learn(0, 1, 1.0, 1, terminated)
        assert agent.Q[0].tolist() == pytest.approx([0, learned], abs=5e-5)
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
        found, mdp = [], Gamble(-0.1, 10)
        for seed in range(10):
            agent = kind.create(mdp, discount=1, exploration=eg.EpsilonGreedy(1))
            eg.train(mdp, agent, 5_000, seed=seed, evaluate_every=5_000)
            found.append(agent.Q[0, 1::2].mean())
        return eg.mean_interval(found)

    assert hope(eg.QLearning).low > 0.1  # the truth is -0.1
    assert hope(eg.DoubleQLearning).high < 0


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


@pytest.mark.parametrize("risk", [-2.0, -0.5, 0.0, 1.0])
def test_a_normal_reward_is_worth_its_mean_and_half_beta_variances(risk: float) -> None:
    """At μ + β s²/2 the mean update over N(μ, s²) is 0 (by quadrature), and at another value it is not."""
    mean, deviation = 0.3, 0.8
    nodes, weights = np.polynomial.hermite_e.hermegauss(100)

    def mean_update(value: float) -> float:
        total = 0.0
        for node, weight in zip(nodes, weights, strict=True):
            agent = eg.RiskSensitiveQLearning(np.array([[value]]), risk, 1.0, 1.0)
            agent.learn(0, 0, mean + deviation * node, 0, True)
            total += weight * (agent.Q[0, 0] - value)
        return float(total / weights.sum())

    worth = mean + risk * deviation**2 / 2
    assert mean_update(worth) == pytest.approx(0.0, abs=1e-8)
    assert abs(mean_update(worth + 0.1)) > 0.01


def test_surprises_of_any_size_do_not_overflow() -> None:
    """A huge good one weighs nothing to who avoids risk, and twice to who seeks it."""
    for risk, value in ((-2.0, 0.0), (2.0, 1e300)):
        agent = eg.RiskSensitiveQLearning.create((1, 1), risk=risk, learning_rate=0.5)
        agent.learn(0, 0, 1e300, 0, True)
        assert agent.Q[0, 0] == value


def test_who_avoids_risk_does_not_bet() -> None:
    """The bet is worth 0.2 + β/2: -0.3 at β = -1; the control at β = 0 bets."""

    def betting(risk: float) -> Any:
        bets, mdp = [], Gamble(0.2, 2)
        for seed in range(12):
            agent = eg.RiskSensitiveQLearning.create(mdp, risk=risk, learning_rate=0.005)
            eg.train(mdp, agent, 20_000, seed=seed, evaluate_every=20_000)
            bets.append(agent.Q[0, 1] > agent.Q[0, 0])
        return eg.proportion_interval(sum(bets), len(bets))

    assert betting(-1.0).high < 0.4
    assert betting(0.0).low > 0.6


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


def test_the_deadly_triad_diverges() -> None:
    """Features, bootstrapping and a behaviour that is not what is learned: weights grow without bound.

    Without the third they do not: always the greedy action, or SARSA, which learns the values of the same behaviour.
    """

    def largest(kind: Any = eg.LinearQLearning, exploration: Any = None) -> list[float]:
        """The largest weight in each of three runs of 2 000 steps, of the largest at the start."""
        runs = [weights_of_solid(kind, exploration, 2_000, seed) for seed in range(3)]
        return [float(np.abs(weights).max() / np.abs(weights[0]).max()) for weights in runs]

    assert min(largest()) > 50
    assert max(largest(exploration=eg.EpsilonGreedy(0.0))) <= 1
    assert max(largest(eg.SemiGradientSARSA)) <= 1

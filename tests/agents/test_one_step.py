"""The agents that learn from one step at a time: their updates by hand, their fixed points, and their biases."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from edugym import (
    SARSA,
    CountBased,
    DoubleQLearning,
    EpsilonGreedy,
    ExpectedSARSA,
    LinearQLearning,
    QLearning,
    RiskSensitiveQLearning,
    SemiGradientSARSA,
    Softmax,
    TileCoding,
    finite_model,
    mean_interval,
    proportion_interval,
    train,
)
from edugym.mdp.protocol import Reals
from edugym_course.lessons.dimensionality.baird import weights_of_solid
from tests.agents.walk import Gamble, Walk, exact_values

TABLE = [[1.0, 2.0], [3.0, 5.0], [-4.0, -1.0]]


def sarsa(Q: Reals) -> SARSA:
    """α = 0.5 and γ = 0.9."""
    return SARSA(Q, 0.5, 0.9)


def expected(Q: Reals) -> ExpectedSARSA:
    """The best action of [3, 5] has a probability of 0.6 + 0.2, the other one of 0.2."""
    return ExpectedSARSA(Q, 0.5, 0.9, EpsilonGreedy(0.4))


def q_learning(Q: Reals) -> QLearning:
    """α = 0.5 and γ = 0.9."""
    return QLearning(Q, 0.5, 0.9)


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
    """Equations 6.7 to 6.9 with α = 0.5 change one entry half the way to the target."""
    agent = make(np.array(TABLE))
    agent.learn(*step)
    state, action, *_ = step
    assert agent.Q[state, action] == pytest.approx((TABLE[state][action] + target) / 2, rel=1e-15)
    agent.Q[state, action] = TABLE[state][action]
    assert agent.Q.tolist() == TABLE


values = st.floats(-1e3, 1e3)


@given(arrays(np.float64, (3, 2), elements=values), st.floats(0.01, 1), st.floats(0, 1), values, st.booleans())
def test_q_learning_is_the_textbook_line(Q: Reals, alpha: float, gamma: float, reward: float, end: bool) -> None:
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


def test_sarsas_mean_step_is_zero_at_the_values_of_its_policy() -> None:
    """At the exact values of the best ε-greedy policy the expected TD error of every pair vanishes."""
    mdp, discount, exploration = Walk(), 0.9, EpsilonGreedy(0.3)
    model, Q = finite_model(mdp), exact_values(mdp, discount, epsilon=0.3)
    for s, a in ((s, a) for s in (1, 2, 3) for a in (0, 1)):
        step = 0.0
        for outcome in model.outcomes(s, a):
            for b in (0, 1):
                agent = SARSA(Q.copy(), 1.0, discount)
                agent.learn(s, a, outcome.reward, outcome.next_state, b, outcome.terminated)
                share = outcome.probability * exploration.probability(Q, outcome.next_state, b)
                step += share * (agent.Q[s, a] - Q[s, a])
        assert step == pytest.approx(0.0, abs=1e-8)
    assert not np.allclose(Q, exact_values(mdp, discount), atol=1e-2)  # with ε = 0 these are others


def test_the_mean_of_sarsas_updates_is_that_of_expected_sarsa() -> None:
    """Over the actions that may come next, each by its probability."""
    Q, exploration = np.random.default_rng(0).normal(size=(2, 4)), Softmax(0.7)
    agent = ExpectedSARSA(Q.copy(), 0.3, 0.9, exploration)
    agent.learn(0, 2, 1.0, 1, False)
    mean = 0.0
    for b in range(4):
        sampled = SARSA(Q.copy(), 0.3, 0.9, exploration)
        sampled.learn(0, 2, 1.0, 1, b, False)
        mean += exploration.probability(Q, 1, b) * sampled.Q[0, 2]
    assert agent.Q[0, 2] == pytest.approx(mean, rel=1e-14)


@pytest.mark.parametrize("epsilon", [0.0, 0.3])
def test_expected_sarsas_fixed_point_is_the_best_epsilon_soft_policy(epsilon: float) -> None:
    """Without chance in the task, whatever the learning rate: the exact values, of every pair."""
    mdp, rng = Walk(slip=0.0), np.random.default_rng(0)
    agent = ExpectedSARSA.create(mdp, discount=0.9, learning_rate=1, exploration=EpsilonGreedy(epsilon))
    for _ in range(2_000):
        s, a = int(rng.integers(1, 4)), int(rng.integers(2))
        n = mdp.transition(s, a, rng)
        agent.learn(s, a, mdp.reward(s, a, n, rng), n, mdp.terminal(n))
    assert pytest.approx(exact_values(mdp, 0.9, epsilon=epsilon), abs=1e-8) == agent.Q
    assert pytest.approx(exact_values(mdp, 0.9, epsilon=0.15), abs=1e-2) != agent.Q


def test_the_first_updates_of_counting_by_hand() -> None:
    """Three times from state 0 to state 1, with β = 2, α = 1/2, γ = 1/2 and max Q(1, ·) = 4.

    Visit 1: R+ = 1 + 2/√1 = 3,      target 3 + 4/2 = 5:      Q = 0 + (5 - 0)/2 = 5/2.
    Visit 2: R+ = 1 + 2/√2 = 2.4142, target 4.4142:           Q = 5/2 + (4.4142 - 5/2)/2 = 3.4571.
    Visit 3: an end: nothing comes after, but the bonus is paid:
             R+ = 1 + 2/√3 = 2.1547, target 2.1547:           Q = 3.4571 + (2.1547 - 3.4571)/2 = 2.8059.
    """
    agent = CountBased.create((2, 2), bonus=2.0, learning_rate=0.5, discount=0.5)
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
    agent = DoubleQLearning((one + two) / 2, one, two, np.array([coin]), 0.5, 0.9)
    agent.learn(0, 1, 1.0, 1, terminated)
    after = [np.array(Q1, float), np.array(TWO, float)]
    after[coin][0, 1] = value
    assert [pytest.approx(table, rel=1e-15) for table in after] == [agent.Q1, agent.Q2]
    assert np.array_equal(agent.Q, (agent.Q1 + agent.Q2) / 2)


def test_the_coin_is_fair_and_tossed_for_every_action() -> None:
    """Within five standard deviations."""
    agent, rng, tosses = DoubleQLearning.create((2, 2)), np.random.default_rng(0), []
    for _ in range(4_000):
        agent.act(0, rng)
        tosses.append(int(agent.coin[0]))
    assert np.mean(tosses) == pytest.approx(0.5, abs=5 * 0.5 / 4_000**0.5)


def test_double_q_learning_does_not_take_noise_for_value() -> None:
    """Figure 6.5: Q-learning hopes for B, where nothing is to be had; double Q-learning does not."""

    def hope(kind: Any) -> Any:
        found, mdp = [], Gamble(-0.1, 10)
        for seed in range(10):
            agent = kind.create(mdp, discount=1, exploration=EpsilonGreedy(1))
            train(mdp, agent, 5_000, seed=seed, evaluate_every=5_000)
            found.append(agent.Q[0, 1::2].mean())
        return mean_interval(found)

    assert hope(QLearning).low > 0.1  # the truth is -0.1
    assert hope(DoubleQLearning).high < 0


@pytest.mark.parametrize("risk", [-2.0, 0.0, 0.7])
@pytest.mark.parametrize(
    ("reward", "terminated", "delta"),
    [(1.0, False, 1 + 0.9 * 5 - 2), (1.0, True, 1 - 2), (-9.0, False, -9 + 0.9 * 5 - 2)],
)
def test_update_of_risk_sensitive_q_learning(risk: float, reward: float, terminated: bool, delta: float) -> None:
    """α = 0.25: Q + α 2 δ / (1 + exp(-βδ)), and no other entry."""
    agent = RiskSensitiveQLearning(np.array(TABLE), risk, 0.25, 0.9)
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
            agent = RiskSensitiveQLearning(np.array([[value]]), risk, 1.0, 1.0)
            agent.learn(0, 0, mean + deviation * node, 0, True)
            total += weight * (agent.Q[0, 0] - value)
        return float(total / weights.sum())

    worth = mean + risk * deviation**2 / 2
    assert mean_update(worth) == pytest.approx(0.0, abs=1e-8)
    assert abs(mean_update(worth + 0.1)) > 0.01


def test_surprises_of_any_size_do_not_overflow() -> None:
    """A huge good one weighs nothing to who avoids risk, and twice to who seeks it."""
    for risk, value in ((-2.0, 0.0), (2.0, 1e300)):
        agent = RiskSensitiveQLearning.create((1, 1), risk=risk, learning_rate=0.5)
        agent.learn(0, 0, 1e300, 0, True)
        assert agent.Q[0, 0] == value


def test_who_avoids_risk_does_not_bet() -> None:
    """The bet is worth 0.2 + β/2: -0.3 at β = -1; the control at β = 0 bets."""

    def betting(risk: float) -> Any:
        bets, mdp = [], Gamble(0.2, 2)
        for seed in range(12):
            agent = RiskSensitiveQLearning.create(mdp, risk=risk, learning_rate=0.005)
            train(mdp, agent, 20_000, seed=seed, evaluate_every=20_000)
            bets.append(agent.Q[0, 1] > agent.Q[0, 0])
        return proportion_interval(sum(bets), len(bets))

    assert betting(-1.0).high < 0.4
    assert betting(0.0).low > 0.6


@pytest.mark.parametrize(("kind", "more", "following"), [(LinearQLearning, (), 32), (SemiGradientSARSA, (0,), 19)])
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
    agent = SemiGradientSARSA.create((1, 2), learning_rate=1.0, features=TileCoding.create((1, 2)))
    agent.learn(np.array([0.4]), 1, 7.0, np.array([0.5]), 0, True)
    agent.greedy(np.array([0.4]), np.random.default_rng(0))
    assert agent.Q.tolist() == [[0.0, 7.0]]
    assert np.count_nonzero(agent.weights) == 8


def test_the_deadly_triad_diverges() -> None:
    """Features, bootstrapping and a behaviour that is not what is learned: weights grow without bound.

    Without the third they do not: always the greedy action, or SARSA, which learns the values of the same behaviour.
    """

    def largest(kind: Any = LinearQLearning, exploration: Any = None) -> list[float]:
        """The largest weight in each of three runs of 2 000 steps, of the largest at the start."""
        runs = [weights_of_solid(kind, exploration, 2_000, seed) for seed in range(3)]
        return [float(np.abs(weights).max() / np.abs(weights[0]).max()) for weights in runs]

    assert min(largest()) > 50
    assert max(largest(exploration=EpsilonGreedy(0.0))) <= 1
    assert max(largest(SemiGradientSARSA)) <= 1

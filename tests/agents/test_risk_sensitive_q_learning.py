"""Risk-sensitive Q-learning: its update by hand, its exact fixed point, and what it prefers."""

import math
from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym import RiskSensitiveQLearning, proportion_interval, train
from edugym.mdp.protocol import Random
from tests.agents.case import Case

CASES = {
    "RiskSensitiveQLearning, neutral": Case(
        RiskSensitiveQLearning,
        lambda env: RiskSensitiveQLearning.create(env, risk=0, learning_rate=0.5, discount=0.5),
        True,
    ),
    "RiskSensitiveQLearning, averse": Case(RiskSensitiveQLearning, lambda e: RiskSensitiveQLearning.create(e, risk=-2)),
    "RiskSensitiveQLearning, seeking": Case(RiskSensitiveQLearning, lambda e: RiskSensitiveQLearning.create(e, risk=1)),
}


@pytest.mark.parametrize("risk", [-2.0, 0.0, 0.7])
@pytest.mark.parametrize(
    ("reward", "terminated", "delta"),
    [(1.0, False, 1 + 0.9 * 5 - 2), (1.0, True, 1 - 2), (-9.0, False, -9 + 0.9 * 5 - 2)],
)
def test_update(risk: float, reward: float, terminated: bool, delta: float) -> None:
    """α = 0.25: Q + α 2 δ / (1 + exp(-βδ)), and no other entry."""
    table = [[1.0, 2.0], [3.0, 5.0]]
    agent = RiskSensitiveQLearning(np.array(table), risk, 0.25, 0.9)
    agent.learn(0, 1, reward, 1, terminated)
    assert agent.Q[0, 1] == pytest.approx(2 + 0.25 * 2 * delta / (1 + math.exp(-risk * delta)), rel=1e-12)
    agent.Q[0, 1] = 2.0
    assert agent.Q.tolist() == table


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


class Bet(NamedTuple):
    """Keep what one has (0), or bet: a gain of 0.2 on average, and a standard deviation of 1."""

    def initial(self, rng: Random) -> int:
        """The only decision."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """The end."""
        return 1

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """N(0.2, 1) for the bet."""
        return rng.normal(0.2, 1.0) if action == 1 else 0.0

    def terminal(self, state: int) -> bool:
        """After the decision."""
        return state == 1

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """Before and after."""
        return spaces.Discrete(2)

    @property
    def action_space(self) -> spaces.Discrete:
        """Keep or bet."""
        return spaces.Discrete(2)


def test_who_avoids_risk_does_not_bet() -> None:
    """The bet is worth 0.2 + β/2: -0.3 at β = -1; the control at β = 0 bets."""

    def betting(risk: float) -> Any:
        bets = []
        for seed in range(12):
            agent = RiskSensitiveQLearning.create(Bet(), risk=risk, learning_rate=0.005)
            train(Bet(), agent, 20_000, seed=seed, evaluate_every=20_000)
            bets.append(agent.Q[0, 1] > agent.Q[0, 0])
        return proportion_interval(sum(bets), len(bets))

    assert betting(-1.0).high < 0.4
    assert betting(0.0).low > 0.6

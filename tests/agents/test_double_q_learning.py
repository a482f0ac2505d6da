"""Double Q-learning: its update by hand, and the bias that it does not have."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym import DoubleQLearning, EpsilonGreedy, QLearning, mean_interval, train
from edugym.mdp.protocol import Random


def agent_with(Q1: Any, Q2: Any, coin: int) -> DoubleQLearning:
    """An agent with these tables, α = 0.5, γ = 0.9."""
    one, two = np.array(Q1, float), np.array(Q2, float)
    return DoubleQLearning((one + two) / 2, one, two, np.array([coin]), 0.5, 0.9)


ONE, TWO = [[1, 2], [3, 5]], [[4, 6], [8, 7]]


@pytest.mark.parametrize(
    ("coin", "terminated", "expected"),
    [
        (0, False, 2 + 0.5 * (1 + 0.9 * 7 - 2)),  # the best of [3, 5] is 1, of which Q₂ says 7
        (1, False, 6 + 0.5 * (1 + 0.9 * 3 - 6)),  # the best of [8, 7] is 0, of which Q₁ says 3
        (0, True, 2 + 0.5 * (1 - 2)),
        (1, True, 6 + 0.5 * (1 - 6)),
    ],
)
def test_update(coin: int, terminated: bool, expected: float) -> None:
    """The box of section 6.7 changes one entry of one table, and the mean."""
    agent = agent_with(ONE, TWO, coin)
    agent.learn(0, 1, 1.0, 1, terminated)
    changed, other = (agent.Q1, agent.Q2) if coin == 0 else (agent.Q2, agent.Q1)
    assert changed[0, 1] == pytest.approx(expected, rel=1e-15)
    assert other.tolist() == (TWO if coin == 0 else ONE)
    assert np.array_equal(agent.Q, (agent.Q1 + agent.Q2) / 2)
    changed[0, 1] = (ONE if coin == 0 else TWO)[0][1]
    assert changed.tolist() == (ONE if coin == 0 else TWO)


def test_equally_good_actions_count_with_their_mean() -> None:
    """Q₁ holds both for best; Q₂ says 8 and 7."""
    agent = agent_with([[0, 0], [5, 5]], TWO, 0)
    agent.learn(0, 0, 0.0, 1, False)
    assert agent.Q1[0, 0] == pytest.approx(0.5 * 0.9 * 7.5)


def test_the_coin_is_fair_and_tossed_for_every_action() -> None:
    """Within five standard deviations."""
    agent, rng = DoubleQLearning.create((2, 2)), np.random.default_rng(0)
    tosses = []
    for _ in range(4_000):
        agent.act(0, rng)
        tosses.append(int(agent.coin[0]))
    assert np.mean(tosses) == pytest.approx(0.5, abs=5 * 0.5 / 4_000**0.5)


class Biased(NamedTuple):
    """Example 6.7: right (even actions) ends with 0; left leads to B, where every action pays N(-0.1, 1) and ends."""

    n: int = 10

    def initial(self, rng: Random) -> int:
        """A."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """A to B on the left, else the end."""
        return 1 if state == 0 and action % 2 == 1 else 2

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """Only from B."""
        return rng.normal(-0.1, 1.0) if state == 1 else 0.0

    def terminal(self, state: int) -> bool:
        """The end."""
        return state == 2

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """A, B and the end."""
        return spaces.Discrete(3)

    @property
    def action_space(self) -> spaces.Discrete:
        """Many."""
        return spaces.Discrete(self.n)


def test_it_does_not_take_noise_for_value() -> None:
    """Figure 6.5: Q-learning hopes for B, where nothing is to be had; double Q-learning does not."""
    mdp = Biased()

    def hope(kind: Any) -> Any:
        found = []
        for seed in range(10):
            agent = kind.create(mdp, discount=1, exploration=EpsilonGreedy(1))
            train(mdp, agent, 5_000, seed=seed, evaluate_every=5_000)
            found.append(agent.Q[0, 1::2].mean())
        return mean_interval(found)

    assert hope(QLearning).low > 0.1  # the truth is -0.1
    assert hope(DoubleQLearning).high < 0

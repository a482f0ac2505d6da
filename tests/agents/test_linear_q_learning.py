"""Q-learning on features: its update by hand, where it is a table, where it diverges, and what it learns."""

from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import EpsilonGreedy, LinearQLearning, SemiGradientSARSA, TileCoding, train
from edugym_course.lessons.dimensionality.baird import weights_of_solid
from tests.agents.case import Case

CASES = {
    "LinearQLearning": Case(LinearQLearning, LinearQLearning.create),
}


@pytest.mark.parametrize(
    ("terminated", "error"),
    [
        (False, 1 + 0.5 * (3 * 4 + 20) - (2 * 1 + 10)),  # = 5: the best next action counts
        (True, 1 - (2 * 1 + 10)),  # = -11
    ],
)
def test_update(terminated: bool, error: float) -> None:
    """Weights as below, S = (2, 0), S' = (0, 3), and a constant of 1; A = 0, R = 1, α = 0.1, γ = 0.5."""
    agent = LinearQLearning.create((2, 2), learning_rate=0.1, discount=0.5)
    agent.weights[:] = [[1, 2], [3, 4], [10, 20]]
    agent.learn(np.array([2.0, 0.0]), 0, 1.0, np.array([0.0, 3.0]), terminated)
    assert agent.weights == pytest.approx(np.array([[1 + 0.1 * error * 2, 2], [3, 4], [10 + 0.1 * error, 20]]))


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


def mountain_car(learning_rate: float, seed: int) -> float:
    """The mean return in MountainCar after 30 000 steps, with 8 tilings of 8 by 8."""
    env = gymnasium.make("MountainCar-v0", disable_env_checker=True)
    settings = {"learning_rate": learning_rate, "discount": 1.0, "exploration": EpsilonGreedy(0.0)}
    agent = LinearQLearning.create(env, features=TileCoding.create(env), **settings)
    return float(train(env, agent, 30_000, seed=seed, evaluate_every=30_000, evaluation_episodes=10).returns[-1])


@pytest.mark.slow
def test_it_learns_mountain_car_with_tiles() -> None:
    """To under 150 steps (figure 10.2 has some 130 to 150 then); without learning it never gets out of the valley."""
    assert np.mean([mountain_car(0.5, seed) for seed in range(3)]) > -150
    assert mountain_car(5e-324, 0) == -200

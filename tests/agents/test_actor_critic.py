"""The one-step actor-critic's update, worked out by hand, and its policy."""

import math

import numpy as np
import pytest

from edugym import ActorCritic
from edugym.agents.softmax import draw_action, follow_log_gradient, softmax
from tests.agents.case import Case

CASES = {"ActorCritic": Case(ActorCritic, ActorCritic.create)}


@pytest.mark.parametrize(
    ("terminated", "error"),
    [(False, 1 + 0.5 * 4 - 2), (True, 1 - 2)],  # = 1: the next state is worth 4; = -1: nothing comes after an end
)
def test_update(terminated: bool, error: float) -> None:
    """V = (2, 4), equal preferences for three actions: π = 1/3 each, ∇ln π(1) = (-1/3, 2/3, -1/3); I = 1."""
    agent = ActorCritic.create((2, 3), learning_rate=0.3, value_learning_rate=0.1, discount=0.5)
    agent.V[:] = [2, 4]
    agent.learn(0, 1, 1.0, 1, terminated, False)
    assert agent.V.tolist() == [2 + 0.1 * error, 4]
    assert agent.preferences[0] == pytest.approx(0.3 * error * np.array([-1, 2, -1]) / 3)
    assert not agent.preferences[1].any()


def test_later_steps_of_an_episode_count_less_for_the_actor() -> None:
    """I is 1, γ, γ², and 1 again after an end or a truncation."""
    agent, seen = ActorCritic.create((1, 2), discount=0.5), []
    for terminated, truncated in ((False, False), (False, False), (False, True), (True, False), (False, False)):
        seen.append(agent.weight[0])
        agent.learn(0, 0, 0.0, 0, terminated, truncated)
    assert seen == [1, 0.5, 0.25, 1, 1]


def test_softmax_and_draws_agree() -> None:
    """π = (1, 2, 5)/8 for the preferences 0, ln 2, ln 5; of 4 000 draws each action has its share, within 4 σ."""
    preferences, p = np.array([[0.0, math.log(2), math.log(5)]]), np.zeros(3)
    softmax(preferences, 0, p)
    assert p == pytest.approx(np.array([1, 2, 5]) / 8)
    softmax(preferences + 1e4, 0, p)  # no exponential is too large
    assert p == pytest.approx(np.array([1, 2, 5]) / 8)
    rng = np.random.default_rng(0)
    counts = np.bincount([draw_action(p, rng) for _ in range(4_000)], minlength=3)
    assert (np.abs(counts - 4_000 * p) < 4 * np.sqrt(4_000 * p * (1 - p))).all()


def test_the_gradient_is_that_of_the_logarithm() -> None:
    """Against differences: (ln π(a|θ + h e_b) - ln π(a|θ - h e_b)) / 2h."""
    rng, h = np.random.default_rng(1), 1e-6
    preferences, p = rng.normal(size=(1, 4)), np.zeros(4)
    for action in range(4):
        softmax(preferences, 0, p)
        followed = preferences.copy()
        follow_log_gradient(followed, 0, action, p, 1.0)
        for b in range(4):
            log = []
            for sign in (1, -1):
                moved = preferences.copy()
                moved[0, b] += sign * h
                softmax(moved, 0, p)
                log.append(math.log(p[action]))
            assert followed[0, b] - preferences[0, b] == pytest.approx((log[0] - log[1]) / (2 * h), abs=1e-8)

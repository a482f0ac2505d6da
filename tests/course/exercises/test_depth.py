"""The exercises of lesson 3: their rules are right, and what the text says of the solutions is so."""

import math
from typing import Any

import numpy as np
import pytest

from edugym import EpsilonGreedy, NStepSARSA
from edugym_course.grading import WrongAnswer
from edugym_course.lessons.depth.exercises import exercise_1
from edugym_course.lessons.depth.exercises.cutting import cases, hand_back, outcomes
from edugym_course.lessons.depth.exercises.episodes import Episode, learn_from
from edugym_course.lessons.depth.exercises.ratio import ratio
from edugym_course.lessons.depth.methods import (
    BY_DEPTH,
    MONTE_CARLO,
    ONE_STEP,
    compare,
    expected_returns,
    label,
    maker,
    passes,
)
from tests.course.lessons.answers import solution

LESSON = "03_depth"
SETTINGS = {"learning_rate": 0.25, "discount": 0.5}


def test_the_ratio_by_hand() -> None:
    """ε = 0.4 and four actions: the greedy one has probability 0.7; the first action does not count."""
    assert ratio([True, True, True], 0.4, 4) == pytest.approx(1 / 0.7**2)
    assert ratio([False, True], 0.4, 4) == pytest.approx(1 / 0.7)
    assert ratio([True, True, False], 0.4, 4) == 0.0
    assert ratio([False], 0.4, 4) == 1.0


def test_ratio_makes_the_mean_right() -> None:
    """Weighted by their ratios, the probabilities of what ε-greedy does add up to that of the greedy policy."""
    epsilon, n_actions = 0.3, 5
    g = 1 - epsilon + epsilon / n_actions
    ways = [(g if one else 1 - g) * (g if two else 1 - g) for one in (True, False) for two in (True, False)]
    ratios = [ratio([True, one, two], epsilon, n_actions) for one in (True, False) for two in (True, False)]
    assert np.dot(ways, ratios) == pytest.approx(1.0)


def test_hand_back_by_hand() -> None:
    """Two steps, α = γ = 1/2. The last action is exploring after its update, and cuts."""
    Q = np.zeros((6, 3))
    Q[1] = [4.0, 0.0, -1.0]
    hand_back(Q, Episode([0, 1], [2, 1], [1.0, 2.0]), learning_rate=0.5, discount=0.5)
    assert Q[1].tolist() == [4.0, 1.0, -1.0]  # G = 2, Q = 0 + (2 - 0) / 2; then G = 4
    assert Q[0].tolist() == [0.0, 0.0, 1.5]  # G = 1 + 4 / 2 = 3


def test_without_the_cut_it_is_monte_carlo() -> None:
    """The same as the package's agent with n = ∞."""
    for case in cases(3):
        agent = maker(math.inf, learning_rate=0.25, discount=0.5)((6, 3))
        agent.Q[:] = case.Q
        for episode, mine in zip(case.episodes, outcomes([case], {**SETTINGS, "cut": "never"}), strict=True):
            learn_from(agent, episode)
            np.testing.assert_allclose(agent.Q, mine, rtol=1e-12)


QUIET = [
    ({}, "Right"),
    ({"learning_rate": 0.01}, "it has a learning rate of 0.01, and it should be 0.1$"),
    ({"learning_rate": 1.0}, "it has a learning rate of 1, and it should be 0.1$"),
    ({"discount": 0}, "it has a discount of 0, and it should be 1$"),
    ({"discount": 0.99}, "it has a discount of 0.99, and it should be 1$"),
    ({"n": 9}, "its targets have 9 rewards, and Monte Carlo has n=math.inf$"),
    ({"n": 1}, "but its targets have 1 reward, and Monte Carlo has n=math.inf$"),
    ({"n": 3, "learning_rate": 0.5, "discount": 0.9}, "3 rewards, .*; and it has a learning .*; and it has a discount"),
    ({"learning_rate": 0.7}, "the first action should be .*: that is no n-step SARSA with a usual learning rate$"),
]


@pytest.mark.parametrize(("how", "says"), QUIET)
def test_how_deep_and_how_fast_the_quiet_agent_learns(how: dict[str, Any], says: str) -> None:
    """Whatever differs from the agent of the experiment is told, with the number that it has."""

    def quiet(study: Any) -> NStepSARSA:
        settings = {"n": math.inf, "learning_rate": 0.1, "discount": 1.0, **how}
        return NStepSARSA.create(study, exploration=EpsilonGreedy(0.0), **settings)

    if not how:
        assert exercise_1(quiet, 0).startswith(says)
    else:
        with pytest.raises(WrongAnswer, match=says):
            exercise_1(quiet, 0)


@pytest.mark.slow
def test_what_the_solutions_reach() -> None:
    """Without exploration Monte Carlo passes on fewer layouts; cut targets end above all depths, and start early."""
    own = {"quiet": solution(LESSON, 1, "quiet"), "mine": solution(LESSON, 3, "MyAgent").create}
    results = compare(depths=BY_DEPTH, own=own, repetitions=40, seed=1)
    share = {method: passes(results, method).mean() for method in results.methods}
    assert share["quiet"] < share[MONTE_CARLO] - 0.1
    ends = {method: expected_returns(results, method).mean() for method in results.methods}
    assert ends["mine"] > max(ends[label(n)] for n in BY_DEPTH)
    early = {method: results.curves(method).loc[2_500].mean() for method in results.methods}
    assert early["mine"] > early[ONE_STEP] + 2

"""The exercises of lesson 2: their rule is the package's, and what the text says of the road is so."""

from typing import Any

import numpy as np
import pytest

from edugym import EpsilonGreedy, ExpectedSARSA, QLearning, finite_model, make_mdp
from edugym_course.lessons.on_off_policy import exercises
from edugym_course.lessons.on_off_policy.exact import best_run, switch


@pytest.mark.parametrize("target_epsilon", [0.0, 0.3, 1.0])
def test_the_rule_is_that_of_the_packages_agents(target_epsilon: float) -> None:
    """It is expected SARSA with another ε; with ε_π = 0 it is Q-learning."""
    settings = {"learning_rate": 0.25, "discount": 0.75}
    rule = exercises.TWO_POLICIES
    cases = rule.cases((6, 3), 5)
    outcomes = rule.outcomes(cases, {**settings, "epsilon": 0.9, "target_epsilon": target_epsilon})
    for case, outcome in zip(cases, outcomes, strict=True):
        agent: Any = ExpectedSARSA.create((6, 3), exploration=EpsilonGreedy(target_epsilon), **settings)
        if target_epsilon == 0:
            agent = QLearning.create((6, 3), **settings)
        agent.Q[:] = case.tables["Q"]
        for now, tables in zip(case.transitions, outcome, strict=True):
            agent.learn(now.state, now.action, now.reward, now.next_state, now.terminated)
            np.testing.assert_allclose(agent.Q, tables["Q"], rtol=1e-12)


def test_the_penalty() -> None:
    """A little above it the fast run is the best at ε = 0.1, and a little below it the safe one."""
    assert len(best_run(0.1, negative_reward=exercises.PENALTY + 0.01)) == 5
    assert len(best_run(0.1, negative_reward=exercises.PENALTY - 0.01)) == 6
    task = make_mdp("Roadrunner", negative_reward=exercises.PENALTY)
    assert switch(finite_model(task), tolerance=1e-6) == pytest.approx(0.1, abs=1e-3)


@pytest.mark.parametrize("size", range(10, 16))
@pytest.mark.parametrize("penalty", [-40.0, -200.0])
def test_roads_of_exercise_2_change_once(size: int, penalty: float) -> None:
    """Below the change the best run is the fastest, and above it never, so that every search finds the same."""
    model = finite_model(make_mdp("Roadrunner", size=size, negative_reward=penalty))
    change = switch(model, tolerance=1e-6)
    assert 0.005 < change < 0.15
    lengths = {
        epsilon: len(best_run(epsilon, size=size, negative_reward=penalty)) for epsilon in np.arange(0.0, 0.21, 0.01)
    }
    for epsilon, length in lengths.items():
        assert (length > lengths[0.0]) == (epsilon > change)

"""The exercises of lesson 2: their rule is the package's, and what the text says of the road is so."""

from typing import Any

import numpy as np
import pytest

from edugym import DynaQ, EpsilonGreedy, ExpectedSARSA, QLearning, finite_model, make_mdp
from edugym_course.grading.updates import Transition
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


@pytest.mark.parametrize(
    ("mean", "value"),
    [
        ("π", 8.5),  # 0.75 * 10 + 0.25 * 4
        ("nothing", 0.0),
        ("greedy", 10.0),
        ("mean", 4.0),
        ("behaviour", 7.0),  # 0.5 * 10 + 0.5 * 4
        ("inverted", 5.5),  # 0.25 * 10 + 0.75 * 4
        ("next action", 6.0),
        ("sum", 11.5),
        ("others", 8.0),  # 0.75 * 10 + 0.25 * (4 - 4 + 6) / 3
        ("all of max", 11.0),
        ("no random part", 7.5),
        ("only the random part", 1.0),
        ("three", 7.5 + 4 / 3),
        ("min", 6.5),
        ("whole table", 9.25),  # 0.75 * 10 + 0.25 * 7
        ("sampled", 9.0),
        ("index", 2.5),
        ("old", 8.0),
        ("left", 6.75),  # 0.75 * 8 + 0.25 * 3
    ],
)
def test_the_value_of_the_next_state_by_hand(mean: str, value: float) -> None:
    """With ε_π = 0.25 and ε = 0.5; with a learning rate and a discount of 1 and no reward it becomes Q(S, A)."""
    Q = np.array([(1.0, 2.0, 8.0, 1.0), (14.0,) * 4, (4.0, -4.0, 10.0, 6.0)])
    now = Transition(0, 1, 0.0, 2, 3, terminated=False, truncated=False)
    settings = {"learning_rate": 1.0, "discount": 1.0, "target_epsilon": 0.25, "epsilon": 0.5}
    exercises.two_policies_update({"Q": Q}, now, mean=mean, **settings)
    assert Q[0, 1] == pytest.approx(value)


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


@pytest.mark.slow
def test_the_challenge() -> None:
    """Costs are divided the other way round: the methods of the lesson get a fifth of the points, optimism more."""

    def optimist(road: object) -> QLearning:
        return QLearning.create(road, learning_rate=1.0, discount=1.0, exploration=EpsilonGreedy(0.0))

    score = exercises.CHALLENGE.score(optimist, "Ada")
    assert score.rows["possible"] == (-2.0, -2.0)
    assert score.points == pytest.approx(72, abs=6)
    assert score.points == pytest.approx(100 * -2.0 / score.rows["your agent"][1])
    assert score.ahead.low > 0
    for method in exercises.CHALLENGE.baselines:
        assert 15 < 100 * -2.0 / score.rows[method][1] < 25
    dyna = exercises.CHALLENGE.score(
        lambda road: DynaQ.create(road, learning_rate=1.0, discount=1.0, exploration=EpsilonGreedy(0.0)), "Ada"
    )
    assert score.points < dyna.points < 100

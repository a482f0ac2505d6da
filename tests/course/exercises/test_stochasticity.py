"""The exercises of lesson 8: their rule is the package's where both agree, and their cases tell mistakes apart."""

from typing import Any

import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import WrongAnswer
from edugym_course.grading.one_step import Q_LEARNING
from edugym_course.lessons.stochasticity import exercises
from edugym_course.lessons.stochasticity.exact import crossing


def test_without_an_attitude_it_is_q_learning() -> None:
    """With κ = 0 the rule is that of the package's agent."""
    settings = {"learning_rate": 0.25, "discount": 0.75}
    rule = exercises.TWO_WEIGHTS
    cases = rule.cases((6, 3), 5)
    for case, outcome in zip(cases, rule.outcomes(cases, {**settings, "kappa": 0.0}), strict=True):
        agent = QLearning.create((6, 3), **settings)
        agent.Q[:] = case.tables["Q"]
        for now, tables in zip(case.transitions, outcome, strict=True):
            agent.learn(now.state, now.action, now.reward, now.next_state, now.terminated)
            np.testing.assert_allclose(agent.Q, tables["Q"], rtol=1e-12)


def test_bad_surprises_weigh_more() -> None:
    """With κ above 0 a value falls by more, and rises by less, than that of Q-learning."""
    settings = {"learning_rate": 0.25, "discount": 0.75}
    cases = exercises.TWO_WEIGHTS.cases((6, 3), 5)
    plain = Q_LEARNING.outcomes(cases, settings)
    averse = exercises.TWO_WEIGHTS.outcomes(cases, {**settings, "kappa": 0.5})
    for case, one, other in zip(cases, plain, averse, strict=True):
        change, mine = one[0]["Q"] - case.tables["Q"], other[0]["Q"] - case.tables["Q"]
        np.testing.assert_allclose(mine, np.where(change > 0, 0.5, 1.5) * change, atol=1e-12)


def test_the_level() -> None:
    """The answer to exercise 1 is where the text says, and differs from the estimate."""
    level = crossing(0.02, 0.025, max_hits=exercises.HITS)
    assert level == pytest.approx(0.0232, abs=1e-4)


@pytest.mark.parametrize(
    ("names", "strange"),
    [(["A", "Zoe"], "'Zoe'"), ([0, "A"], "0"), (["A", ("B", 1.0)], r"\('B', 1\.0\)"), ([["A"], "B"], r"\['A'\]")],
)
def test_what_is_no_name_of_a_player(names: list[Any], strange: str) -> None:
    """Another text, a number, a pair, a list."""
    with pytest.raises(WrongAnswer, match=f"should hold names such as 'A', but holds {strange}$"):
        exercises.exercise_2(lambda players: names, 0)

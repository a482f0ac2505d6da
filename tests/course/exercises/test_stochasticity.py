"""The exercises of lesson 8: their rule is the package's where both agree, and their cases tell mistakes apart."""

from collections.abc import Callable, Mapping
from itertools import combinations
from typing import Any

import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import WrongAnswer
from edugym_course.grading.one_step import Q_LEARNING
from edugym_course.grading.updates import Transition
from edugym_course.lessons.stochasticity import exercises
from edugym_course.lessons.stochasticity.exact import crossing, optimum


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


@pytest.mark.parametrize(
    ("how", "good", "bad"),
    [
        ({}, -0.4, 2.4),
        ({"weigh": "inverted"}, 1.4, 3.6),
        ({"weigh": "reward"}, 1.4, 3.6),
        ({"weigh": "target"}, -0.4, 3.6),
        ({"weigh": "value"}, 1.4, 3.6),
        ({"weigh": "none"}, 0.5, 3.0),
        ({"weigh": "always good"}, -0.4, 3.6),
        ({"weigh": "always bad"}, 1.4, 2.4),
        ({"weigh": "good only"}, -0.4, 3.0),
        ({"weigh": "bad only"}, 0.5, 2.4),
        ({"weigh": "κ and -κ"}, -1.9, 3.4),
        ({"weigh": "κ alone"}, -0.1, 3.4),
        ({"weigh": "2σ"}, -1 + 3 / (1 + np.exp(1.8)), 4 - 2 / (1 + np.exp(-1.2))),
        ({"weigh": "2σ inverted"}, -1 + 3 / (1 + np.exp(-1.8)), 4 - 2 / (1 + np.exp(1.2))),
        ({"weigh": "halves"}, -0.7, 3.2),
        ({"weigh": "squared"}, -0.76, 1.44),
        ({"weigh": "only bad"}, -1.0, 2.4),
        ({"weigh": "only good"}, -0.4, 4.0),
        ({"weigh": "on the target"}, -0.1, 3.6),  # the brackets are 0.4 * 2 + 1 and 1.6 * 2 - 4
        ({"step": "minus", "weigh": "inverted"}, -3.4, 4.4),
        ({"step": "no old"}, -0.6, 5.6),  # the target is 2 in both steps
        ({"step": "only"}, 0.4, 1.6),
        ({"step": "only difference"}, 0.6, -1.6),
    ],
)
def test_weights_by_hand(how: dict[str, str], good: float, bad: float) -> None:
    """A δ of 3 is added to -1, and one of -2 to 4: with a weight w they become -1 + 1.5 w and 4 - w."""
    for old, reward, value, new in ((-1.0, -2.0, 8.0, good), (4.0, 1.0, 2.0, bad)):
        Q = np.array([(0.0, old), (value, -3.0)])
        now = Transition(0, 1, reward, 1, 0, terminated=False, truncated=False)
        settings: dict[str, Any] = {"learning_rate": 0.5, "discount": 0.5, "kappa": 0.6, **how}
        exercises.two_weights_update({"Q": Q}, now, **settings)
        assert Q[0, 1] == pytest.approx(new)


def test_the_weight_of_a_step_that_changes_the_wrong_row() -> None:
    """It is that of the surprise in this row: Q(S', A) goes 0.4 * 0.5 of the way from -3 to the target, 2."""
    Q = np.array([(0.0, 9.0), (8.0, -3.0)])
    now = Transition(0, 1, -2.0, 1, 0, terminated=False, truncated=False)
    exercises.two_weights_update({"Q": Q}, now, learning_rate=0.5, discount=0.5, kappa=0.6, step="next row")
    assert Q.tolist() == [[0.0, 9.0], [8.0, pytest.approx(-2.0)]]


@pytest.mark.parametrize("seed", range(5))
def test_mistakes_at_the_frontier_differ(seed: int) -> None:
    """Each gives other names than the right rule, and than every other mistake, in one case or more."""
    cases = exercises.made_up_players(seed)
    rules: dict[str, Callable[[Mapping[str, exercises.Pair]], set[str]]] = dict(exercises.FRONTIER_MISTAKES)
    rules["right"] = lambda players: exercises._unbeaten(players, exercises._beats)
    given = {sentence: [rule(players) for players in cases] for sentence, rule in rules.items()}
    for one, other in combinations(given, 2):
        assert given[one] != given[other], f"{one} / {other}"


def test_the_level() -> None:
    """The answer to exercise 1 is where the text says, and differs from the estimate."""
    level = crossing(0.02, 0.025, max_hits=exercises.HITS)
    assert level == pytest.approx(0.0232, abs=1e-4)


@pytest.mark.slow
def test_the_challenge() -> None:
    """The neutral player gets about four fifths of the points; exploring less, and learning faster, gets more."""
    assert pytest.approx(optimum(0.015), abs=5e-4) == exercises.OPTIMUM
    score = exercises.CHALLENGE.score(
        lambda game: QLearning.create(game, learning_rate=0.1, discount=1.0), "Ada Lovelace"
    )
    assert 70 < score.points < 95
    assert score.rows["possible"] == (exercises.OPTIMUM, exercises.OPTIMUM)


@pytest.mark.parametrize(
    ("names", "strange"),
    [(["A", "Zoe"], "'Zoe'"), ([0, "A"], "0"), (["A", ("B", 1.0)], r"\('B', 1\.0\)"), ([["A"], "B"], r"\['A'\]")],
)
def test_what_is_no_name_of_a_player(names: list[Any], strange: str) -> None:
    """Another text, a number, a pair, a list."""
    with pytest.raises(WrongAnswer, match=f"should hold names such as 'A', but holds {strange}$"):
        exercises.exercise_2(lambda players: names, 0)

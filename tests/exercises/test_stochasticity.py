"""The exercises of lesson 8: their rule is the package's where both agree, and their cases tell mistakes apart."""

from collections.abc import Callable, Mapping
from itertools import combinations

import numpy as np
import pytest

from edugym import QLearning
from edugym.exercises import stochasticity as exercises
from edugym.grading.one_step import Q_LEARNING
from edugym.lessons.stochasticity.exact import crossing, optimum


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

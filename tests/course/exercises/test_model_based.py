"""The exercises of lesson 9: their rules are the package's, and what their text says of the agents is so."""

import numpy as np
import pytest

from edugym import DynaQ
from edugym_course.lessons.model_based.exercises.imagining import imagined
from edugym_course.lessons.model_based.exercises.students import SHAPE, memories
from edugym_course.lessons.model_based.exercises.sweeping import Model, swept
from edugym_course.lessons.model_based.methods import OPTIMUM, compare
from edugym_course.lessons.model_based.plans import used_and_seen
from tests.course.lessons.answers import solution

LESSON = "09_model_based"


def test_the_rule_of_dyna_q_plus_is_that_of_the_packages_agent() -> None:
    """For pairs that were tried, that ended the episode, and that were never tried."""
    for case in memories(5):
        agent = DynaQ.create(SHAPE, discount=0.75, exploration_bonus=2.0)
        agent.Q[:] = case.Q
        s, a = case.state, case.action
        if case.last[s, a]:
            next_state = int(case.next_states[s, a])
            agent.model.observe(s, a, case.rewards[s, a], next_state, bool(case.ends[s, a]))
        agent.model.steps[0], agent.model.last_visit[s, a] = case.now, case.last[s, a]
        right = agent.imagined_target(s, a, np.random.default_rng(0))
        assert imagined(case, discount=0.75, kappa=2.0) == pytest.approx(right)


def test_sweeps_settle_at_the_values_by_hand() -> None:
    """A chain of two known pairs to the end: 3, and -1 + 0.5 * 100 where the next state has an unknown action."""
    known, rewards = np.zeros(SHAPE, np.int64), np.zeros(SHAPE)
    next_states, ends = known.copy(), known.copy()
    known[1, 0] = known[2, 0] = ends[1, 0] = 1
    rewards[1, 0], rewards[2, 0], next_states[2, 0] = 3.0, -1.0, 1
    Q = swept(Model(np.full(SHAPE, 100.0), known, rewards, next_states, ends), discount=0.5)
    assert (Q[1, 0], Q[2, 0]) == (3.0, 49.0)
    assert (Q[known == 0] == 100.0).all()


def test_an_error_that_pays() -> None:
    """With the error of the solution bumping for ever is worth what the best way is, and with a smaller one less."""
    v, gamma = 40.0, 0.75
    e = solution(LESSON, 1, "smallest_error")(v, gamma)
    for error, worth in ((e, v), (e - 1, v - 1 / (1 - gamma))):
        assert sum((error - 1) * gamma**k for k in range(200)) == pytest.approx(worth)


@pytest.mark.slow
def test_what_the_solutions_reach() -> None:
    """R-max finds the best way; Dyna-Q+ has seen the shop, and its policy goes on asking."""
    makers = {"mine": solution(LESSON, 3, "MyRMax").create, "plus": solution(LESSON, 2, "DynaPlus").create}
    results = compare(makers, repetitions=5)
    known = used_and_seen(results)
    assert (results.final("mine") == OPTIMUM).all()
    assert known["plus"][1].mean() > 90.0
    assert known["plus"][0].mean() < 0.0

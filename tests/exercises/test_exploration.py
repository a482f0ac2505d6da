"""The exercises of lesson 1: their rule is the package's, and what their text says of the walls is so."""

from typing import Any

import numpy as np
import pytest

from edugym import CountBased, make_mdp
from edugym.exercises import exploration as exercises
from edugym.lessons.exploration import EPSILON_GREEDY, METHODS, compare, race
from edugym.plotting import Curves, Lines
from tests.lessons.answers import solution

LESSON = "01_exploration"


def test_the_rule_is_that_of_the_packages_agent() -> None:
    """But for the count of tries, which `CountBased` does not have."""
    settings = {"learning_rate": 0.25, "discount": 0.75, "bonus": 3.0}
    cases = exercises.EXPLORER.cases((6, 3), 5)
    for case, outcome in zip(cases, exercises.EXPLORER.outcomes(cases, settings), strict=True):
        agent = CountBased.create((6, 3), **settings)
        agent.Q[:], agent.visits[:] = case.tables["Q"], case.tables["visits"]
        for now, tables in zip(case.transitions, outcome, strict=True):
            agent.learn(now.state, now.action, now.reward, now.next_state, now.terminated)
            np.testing.assert_allclose(agent.Q, tables["Q"], rtol=1e-12)
            np.testing.assert_array_equal(agent.visits, tables["visits"])


def test_epsilon() -> None:
    """Half of the climbs, to rounding; one wrong grip in 145 steps."""
    share = (1 - exercises.EPSILON / 2) ** 100
    assert share == pytest.approx(0.5, abs=1e-12)
    assert round(2 / exercises.EPSILON) == 145


@pytest.mark.slow
def test_what_the_solutions_reach() -> None:
    """The optimist solves height 30 where ε-greedy fails; the explorer solves 100."""
    makers = {"optimist": solution(LESSON, 2, "optimist"), "explorer": solution(LESSON, 3, "MyExplorer").create}
    middle = compare(30, methods={**makers, EPSILON_GREEDY: METHODS[EPSILON_GREEDY]}, repetitions=10)
    assert middle.final("optimist").mean() == 1
    assert middle.final(EPSILON_GREEDY).mean() < 0.2
    high = compare(100, methods=makers, repetitions=10)
    assert high.final("explorer").mean() > 0.9


@pytest.mark.slow
def test_a_race_shows_all_methods() -> None:
    """The paper's three and the reader's own, one panel for each height, and their progress on the highest."""

    def mine(wall: Any) -> CountBased:
        return CountBased.create((wall.height + 1, wall.n_grips), bonus=2.0)

    sheet = race({"mine": mine}, (3, 4), repetitions=2, n_steps=200)
    *panels, progress = [panel for row in sheet.rows for panel in row]
    shown = [panel.results.methods for panel in panels if isinstance(panel, Curves)]
    assert shown == [[*METHODS, "mine"]] * 2
    assert isinstance(progress, Lines)
    assert [*progress.lines] == [*METHODS, "mine"]
    assert progress.x[-1] == 200


def test_walls_of_the_lesson_can_be_given() -> None:
    """Answers may use the fields of the wall."""
    wall = make_mdp("Boulder", height=4)
    assert solution(LESSON, 2, "optimist")(wall).Q.shape == (5, 2)

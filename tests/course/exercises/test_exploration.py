"""The exercises of lesson 1: their rule is the package's, and what their text says of the walls is so."""

from typing import Any

import numpy as np
import pytest

from edugym import SARSA, CountBased, repeat
from edugym.training.run import Run
from edugym_course.grading.updates import Transition
from edugym_course.lessons.exploration import exercises
from edugym_course.lessons.exploration.exercises.explorer import check_act
from edugym_course.lessons.exploration.methods import EPSILON_GREEDY, METHODS, N_STEPS, compare
from tests.course.lessons.answers import solution

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


def test_at_the_end_the_bonus_counts() -> None:
    """It belongs to the state that is entered; a mistake leaves it out there."""
    for novelty, value in (("1/√n", 9.0), ("not at the end", 6.0)):
        tables = {"visits": np.array([4, 3]), "tries": np.array([[3, 8], [5, 2]]), "Q": np.ones((2, 2))}
        now = Transition(0, 1, 6.0, 1, 0, terminated=True, truncated=False)
        exercises.EXPLORER.rule(tables, now, learning_rate=1.0, discount=0.5, bonus=6.0, novelty=novelty)
        assert tables["Q"][0, 1] == value


def test_what_an_explorer_is_asked_could_have_happened() -> None:
    """A state was visited as often as its grips were tried: an explorer may look at either."""

    class Explorer:
        """Takes what it knows too little of, else the best."""

        def __init__(self) -> None:
            self.Q, self.visits, self.tries = np.zeros((101, 3)), np.zeros(101, int), np.zeros((101, 3), int)

        def act(self, state: int, rng: np.random.Generator) -> int:
            """Compare the two counts, then act."""
            assert self.visits[state] == self.tries[state].sum()
            seen.append(self.tries[state].tolist())
            untried = np.flatnonzero(self.tries[state] == 0)
            best = np.flatnonzero(self.Q[state] == self.Q[state].max())
            return int(rng.choice(untried if untried.size else best))

    seen: list[list[int]] = []
    check_act(Explorer(), 3)
    assert [0, 0, 0] in seen
    assert [7, 1, 2] in seen


def test_epsilon() -> None:
    """Half of the climbs, to rounding; one wrong grip in 145 steps."""
    share = (1 - exercises.EPSILON / 2) ** 100
    assert share == pytest.approx(0.5, abs=1e-12)
    assert round(2 / exercises.EPSILON) == 145


def test_runs_that_solve_the_lake_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that end at 1: here the first two of Go-Explore, and all of the reader's own agent."""

    def trained(environment: Any, agent: Any, n_steps: int, *, seed: int, **how: Any) -> Run:
        made.append(agent)
        n_own = sum(isinstance(one, SARSA) for one in made)
        n_last = sum(type(one).__name__ == "GoExplore" for one in made)
        solves = n_own > 0 if isinstance(agent, SARSA) else type(agent).__name__ == "GoExplore" and n_last <= 2
        ends = np.array([1.0, 1.0 if solves else 0.99])
        return Run(np.array([0, n_steps]), ends, np.zeros(2), np.zeros(2, int), agent, seed, 0.0, True)

    made: list[Any] = []
    monkeypatch.setattr("edugym.experiments.repeat.train", trained)
    lake = {"map_name": "8x8", "is_slippery": False}
    methods = {**METHODS, "mine": SARSA.create}
    answer = repeat("FrozenLake-v1", methods, N_STEPS, repetitions=5, parameters=lake, jobs=1)
    assert exercises.exercise_4(answer, 0).startswith(
        "Right. Runs that solve the lake: ε-greedy 0 of 5, novelty reward 0 of 5, Go-Explore 2 of 5, mine 5 of 5. "
    )


@pytest.mark.slow
def test_what_the_solutions_reach() -> None:
    """The optimist solves height 30 where ε-greedy fails; the explorer solves 100."""
    makers = {"optimist": solution(LESSON, 2, "optimist"), "explorer": solution(LESSON, 3, "MyExplorer").create}
    middle = compare(30, methods={**makers, EPSILON_GREEDY: METHODS[EPSILON_GREEDY]}, repetitions=10)
    assert middle.final("optimist").mean() == 1
    assert middle.final(EPSILON_GREEDY).mean() < 0.2
    high = compare(100, methods=makers, repetitions=10)
    assert high.final("explorer").mean() > 0.9

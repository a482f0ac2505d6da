"""The exercises of lesson 10: the numbers in the checks are those of the exact model, and mistakes differ."""

from functools import partial

import numpy as np
import pytest

from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.own_problem import exercises
from edugym_course.lessons.own_problem.exercises import chimes
from tests.course.grading.test_checking import noted_limits
from tests.course.lessons.made_up import Circle


def test_problems_that_are_none() -> None:
    """A class, one with too few states or actions, and one that the package refuses; the sentence is the same."""
    with pytest.raises(WrongAnswer, match=r"^my_problem must be a value, but is the class Mine: make one"):
        exercises.exercise_4(type("Mine", (chimes.UsedToChimes,), {"__slots__": ()}), 0)
    for states, actions in ((3, 2), (4, 1)):
        with pytest.raises(WrongAnswer, match=f"four states or more, but has {actions} and {states}$"):
            exercises.exercise_4(Stairs(states=states, actions=actions), 0)
    broken = type("Broken", (Stairs,), {"__slots__": (), "observation": lambda self, state, rng: state + 1})
    with pytest.raises(WrongAnswer, match=r"^(?!my_problem raises)"):
        exercises.exercise_4(broken(), 0)


class Stairs(Circle):
    """Steps that are taken best by every other action in turn; each try but the last costs 1."""

    __slots__ = ()

    def transition(self, state: int, action: int, rng: np.random.Generator) -> int:
        """Up, with a probability of 0.9 or 0.1."""
        up = rng.random() < 0.9
        return state + int(up == (action == state % self.actions))

    def reward(self, state: int, action: int, next_state: int, rng: np.random.Generator) -> float:
        """A cost, but at the top."""
        return 0.0 if next_state == self.states - 1 else -1.0


def test_the_smallest_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    """Four states and two actions; 3 steps up take 3 / 0.9 tries, of which the last is free; a large one has time."""
    limits = noted_limits(monkeypatch, exercises)
    assert exercises.exercise_4(Stairs(states=4), 0) == "A problem: 4 states, 2 actions, optimum -2.333."
    assert limits == [("my_problem", 30.0), ("my_problem", 300.0), ("my_problem", 30.0)]
    assert exercises.exercise_4(Stairs(states=5, actions=3), 0) == "A problem: 5 states, 3 actions, optimum -3.444."


def test_where_a_step_can_lead_is_told() -> None:
    """A ring in light sleep wakes her always; in deep sleep with probability 0.9, and else she is dozing."""
    asleep = chimes._ways(partial(chimes.UsedToChimes().transition, (3, 2, 1), 2), "")
    dozing = chimes._ways(partial(chimes.UsedToChimes().transition, (3, 1, 1), 2), "")
    assert chimes._told(asleep) == "(4, 0, 1) (p = 0.9) or (4, 1, 1) (p = 0.1)"
    assert chimes._told(dozing) == "(4, 0, 1) (p = 1)"

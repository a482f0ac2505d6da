"""The exercises of lesson 10: the numbers in the checks are those of the exact model, and mistakes differ."""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
import pytest
from gymnasium.spaces import Discrete

from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.own_problem import exercises
from edugym_course.lessons.own_problem.exact import solve
from edugym_course.lessons.own_problem.morning import Morning
from tests.course.grading.test_checking import noted_limits


@pytest.mark.parametrize(("late", "action"), [(exercises.LATE - 0.001, 0), (exercises.LATE + 0.001, 2)])
def test_where_the_policy_flips(late: float, action: int) -> None:
    """The cost that is worked out by hand is where the exact policy changes."""
    values = solve(Morning(late=late))
    assert values.Q[values.model.row((7, 2))].argmax() == action


@pytest.mark.parametrize("seed", [59, 130])
def test_the_shaping_mistake_is_the_one_that_fits_all_cases(seed: int) -> None:
    """Numbers are drawn so that no two mistakes give the same; with some seeds they once did."""

    def no_bill(r: float, potential: Callable[[str], float], s: str, s2: str, end: bool, g: float) -> float:
        return r if end else r + g * potential(s2) - potential(s)

    with pytest.raises(WrongAnswer, match="still has to be paid"):
        exercises.exercise_2(no_bill, seed)


def test_problems_that_are_none() -> None:
    """A class, one with too few states or actions, and one that the package refuses; the sentence is the same."""
    with pytest.raises(WrongAnswer, match=r"^my_problem must be a value, but is the class Mine: make one"):
        exercises.exercise_4(type("Mine", (exercises.UsedToChimes,), {"__slots__": ()}), 0)
    for states, actions in ((3, 2), (4, 1)):
        with pytest.raises(WrongAnswer, match=f"four states or more, but has {actions} and {states}$"):
            exercises.exercise_4(Stairs(states, actions), 0)
    broken = type("Broken", (Stairs,), {"__slots__": (), "observation": lambda self, state, rng: state + 1})
    with pytest.raises(WrongAnswer, match=r"^(?!my_problem raises)"):
        exercises.exercise_4(broken(), 0)


class Stairs(NamedTuple):
    """Steps that are taken best by every other action in turn; each try but the last costs 1."""

    states: int = 4
    actions: int = 2

    @property
    def action_names(self) -> tuple[str, ...]:
        """Names without a meaning."""
        return tuple(f"action {a}" for a in range(self.actions))

    @property
    def action_space(self) -> Discrete:
        """One or more."""
        return Discrete(self.actions)

    @property
    def observation_space(self) -> Discrete:
        """The steps."""
        return Discrete(self.states)

    def initial(self, rng: np.random.Generator) -> int:
        """At the bottom."""
        return 0

    def transition(self, state: int, action: int, rng: np.random.Generator) -> int:
        """Up, with a probability of 0.9 or 0.1."""
        up = rng.random() < 0.9
        return state + int(up == (action == state % self.actions))

    def reward(self, state: int, action: int, next_state: int, rng: np.random.Generator) -> float:
        """A cost, but at the top."""
        return 0.0 if next_state == self.states - 1 else -1.0

    def terminal(self, state: int) -> bool:
        """At the top."""
        return state == self.states - 1

    def observation(self, state: int, rng: np.random.Generator) -> int:
        """The whole state."""
        return state


def test_the_smallest_problem() -> None:
    """Four states and two actions; 3 steps up take 3 / 0.9 tries, of which the last is free."""
    assert exercises.exercise_4(Stairs(), 0) == "A problem: 4 states, 2 actions, optimum -2.333."
    assert exercises.exercise_4(Stairs(states=5, actions=3), 0) == "A problem: 5 states, 3 actions, optimum -3.444."


def test_a_large_problem_has_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Five minutes, and half a minute for what should be there at once."""
    asked = noted_limits(monkeypatch, exercises)
    exercises.exercise_4(Stairs(), 0)
    assert asked == [("my_problem", 30.0), ("my_problem", 300.0)]


def test_where_a_step_can_lead_is_told() -> None:
    """A ring in light sleep wakes her always; in deep sleep with probability 0.9, and else she is dozing."""
    asleep = exercises._ways(partial(exercises.UsedToChimes().transition, (3, 2, 1), 2), "")
    dozing = exercises._ways(partial(exercises.UsedToChimes().transition, (3, 1, 1), 2), "")
    assert exercises._told(asleep) == "(4, 0, 1) (p = 0.9) or (4, 1, 1) (p = 0.1)"
    assert exercises._told(dozing) == "(4, 0, 1) (p = 1)"

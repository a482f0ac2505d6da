"""Wrong answers that are right in most cases: the checks have the case in which they are wrong, and say what it is.

Each is a solution in which one expression is replaced. They are of three kinds: searches for the largest value that
start from a fixed number; one number that stands for another, or is taken twice; and rewards that stand for the end.
"""

import re
from functools import cache
from importlib import import_module
from itertools import combinations, permutations
from typing import Any

import build
import pytest

from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES, STARTS
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.values import same
from tests.course.lessons.answers import Answer, read_answers, read_exercises, verdict

MAXIMA = {
    ("00_loop", 3): "max(self.Q[next_state])",
    ("01_exploration", 3): "max(self.Q[next_state])",
    ("02_on_off_policy", 3): "max(self.Q[next_state])",
    ("03_depth", 3): "max(self.Q[s])",
    ("04_dimensionality", 2): "self.value(next_state, 0)",
    ("04_dimensionality", 3): "self.Q[0].max()",
    ("08_stochasticity", 3): "max(self.Q[next_state])",
    ("09_model_based", 2): "max(self.Q[next_state])",
    ("09_model_based", 3): "max(self.Q[self.next_states[s, a]])",
}
"""Where a largest value is searched for."""
NUMBERS = {
    ("00_loop", 3): ("learning_rate", "discount"),
    ("01_exploration", 3): ("learning_rate", "discount", "bonus"),
    ("02_on_off_policy", 3): ("learning_rate", "discount", "target_epsilon", "epsilon"),
    ("03_depth", 3): ("learning_rate", "discount"),
    ("04_dimensionality", 2): ("learning_rate", "discount"),
    ("07_continuous_actions", 3): ("learning_rate", "value_learning_rate", "discount"),
    ("08_stochasticity", 3): ("learning_rate", "discount", "kappa"),
    ("09_model_based", 2): ("discount", "kappa"),
}
"""The numbers that a solution reads from the fields of its agent; the last of lesson 2 only its `act` reads."""
ENDS = {
    ("00_loop", 3): "reward if terminated",
    ("01_exploration", 3): "0.0 if terminated",
    ("02_on_off_policy", 3): "if not terminated",
    ("04_dimensionality", 2): "if not terminated",
    ("04_dimensionality", 3): "memory.terminated[row] == 1",
    ("08_stochasticity", 3): "0.0 if terminated",
    ("09_model_based", 2): "0.0 if ended",
    ("09_model_based", 3): "self.ends[s, a] == 1 else",
}
"""Where a solution asks for the end."""
REWARDS = {"04_dimensionality 3": "memory.rewards[row]", "09_model_based 3": "self.rewards[s, a]"}
OTHERS = [
    ("00_loop", 2, "values == values.max()", "values >= values.max() - 0.001", "values that differ are no ties"),
    ("02_on_off_policy", 3, "self.target_epsilon", "max(self.epsilon, self.target_epsilon)", ""),
    ("02_on_off_policy", 3, "self.target_epsilon", "min(self.epsilon, self.target_epsilon)", ""),
    ("04_dimensionality", 1, "256 ** (rows", "256.0 ** (rows", "whole number with"),
    ("04_dimensionality", 1, "2 ** (rows", "2.0 ** (rows", "whole number with"),
    ("04_dimensionality", 1, "2 ** (rows", "np.int64(2) ** (rows", "whole number with"),
    (
        "04_dimensionality",
        2,
        "x = self.features(state)",
        "x = self.features(state); state[0] = 5.0",
        "writes into `state`",
    ),
    ("06_signal", 2, "joint[x, y] > 0", "joint[x, y] > 0.0001", "very small entries are left out"),
    ("09_model_based", 2, "self.last[s, a] == 0", "self.last[s, a] <= 1", "only 0 means"),
    ("09_model_based", 3, "if self.known[s, a] == 1", "if self.rewards[s, a] != 0", "may have a reward of 0"),
]
"""Lesson, exercise, what is replaced, by what, and what is said."""


@cache
def _lesson(lesson: str) -> Any:
    return read_answers(lesson)[0], *read_exercises(build.lesson_sources()[lesson])


def said_of(lesson: str, number: int, old: str, new: str) -> str:
    """What the check says of a solution with another expression in it, "" if it is right."""
    setup, imports, exercises = _lesson(lesson)
    exercise = exercises[number - 1]
    assert old in exercise.solution
    lines = exercise.solution.replace(old, new).splitlines()
    code = "\n".join(["import numpy as np", *(line for line in lines if "# own:" not in line)])
    return verdict(Answer(lesson, number, False, new, (), code + "\n"), exercise, (imports, setup))


LOWEST = max(STARTS)


@pytest.mark.parametrize("start", [LOWEST, *(pytest.param(n, marks=pytest.mark.slow) for n in STARTS if n != LOWEST)])
@pytest.mark.parametrize("place", MAXIMA, ids=str)
def test_no_search_for_the_largest_value_starts_from_a_number(place: tuple[str, int], start: int) -> None:
    """However low. The sentence names the number."""
    said = said_of(*place, MAXIMA[place], f"max(-{start}.0, {MAXIMA[place]})")
    assert re.search(rf"(starts from|not with|and not) {f'−{start}' if start else '0'}\b", said), said


SWAPPED = [
    pytest.param(place, name, new, marks=() if place[0] == "00_loop" else pytest.mark.slow)
    for place, names in NUMBERS.items()
    for name in names
    if name != "epsilon"
    for new in (*(f"self.{one}" for one in names if one != name), f"(1 - self.{name})", f"(2 * self.{name})", "1.0")
]


@pytest.mark.parametrize(("place", "name", "new"), SWAPPED)
def test_no_number_stands_for_another(place: tuple[str, int], name: str, new: str) -> None:
    """Nor for itself taken twice, or for 1: in made-up cases all of these differ."""
    assert said_of(*place, f"self.{name}", new)


def test_made_up_learning_rates_and_discounts_are_told_apart() -> None:
    """α, 2α, 1 − α, γ, 1 − γ, 2γ and 1: no two are equal, whichever are drawn."""
    for rate in LEARNING_RATES:
        for discount in DISCOUNTS:
            numbers = [rate, 2 * rate, 1 - rate, discount, 1 - discount, 2 * discount, rate * discount, 1.0]
            assert all(abs(one - other) > 0.01 for one, other in permutations(numbers, 2)), (rate, discount)


COMPARED = [
    ("00_loop", 1, "exercises"),
    ("03_depth", 2, "exercises.ratio"),
    ("04_dimensionality", 2, "exercises.linear"),
    ("05_memory", 1, "exercises.rows"),
    ("07_continuous_actions", 1, "exercises"),
    ("09_model_based", 1, "exercises"),
    ("10_own_problem", 2, "exercises.shaping"),
]
"""The exercises whose answers give several numbers, and where these are compared."""


@pytest.mark.parametrize(("lesson", "number", "module"), COMPARED)
def test_no_two_mistakes_look_alike(lesson: str, number: int, module: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Any two of them differ in one case or more, and each from what is right: so the one that is named was made."""
    compared = list[list[NumberCase]]()

    def noted(cases: list[NumberCase], *otherwise: str, **named: str) -> None:
        compared.append(cases)
        compare_all(cases, *otherwise, **named)

    folder = f"edugym_course.lessons.{lesson.partition('_')[2]}"
    monkeypatch.setattr(import_module(f"{folder}.{module}"), "compare_all", noted)
    setup, imports, exercises = _lesson(lesson)
    exercise = exercises[number - 1]
    assert verdict(Answer(lesson, number, True, "right", (), exercise.solution), exercise, (imports, setup)) == ""
    assert compared
    for cases in compared:
        for one, other in combinations(["right", *cases[0].mistakes], 2):
            gives = [{"right": case.expected, **case.mistakes} for case in cases]
            assert not all(same(numbers[one], numbers[other]) for numbers in gives), (one, other)


@pytest.mark.slow
@pytest.mark.parametrize("test", ["{} == 0", "{} != 0", "{} > 0", "abs({}) == 1"])
@pytest.mark.parametrize("place", ENDS, ids=str)
def test_no_reward_stands_for_the_end(place: tuple[str, int], test: str) -> None:
    """Nor does its absence."""
    asked = test.format(REWARDS.get(f"{place[0]} {place[1]}", "reward"))
    old = ENDS[place]
    new = re.sub(r"not terminated", f"not ({asked})", old)
    new = re.sub(r"if (terminated|ended)$", f"if {asked}", new)
    new = asked if old.startswith("memory") else asked + " else" if old.startswith("self.ends") else new
    assert new != old
    assert said_of(*place, old, new)


@pytest.mark.parametrize(("lesson", "number", "old", "new", "says"), OTHERS)
def test_what_was_once_accepted(lesson: str, number: int, old: str, new: str, says: str) -> None:
    """Answers of readers."""
    said = said_of(lesson, number, old, new)
    assert said
    assert says in said

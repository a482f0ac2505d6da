"""Numbers of a student's own: every exercise that declares them, its solutions, and what is said of a copied answer."""

import inspect
import re
from collections.abc import Callable
from functools import cache
from typing import Any

import build
import own_numbers
import pytest
from rules import is_exercise, without_marks

from edugym_course.grading import WrongAnswer, check
from edugym_course.grading.own_numbers import (
    draw_numbers,
    numbers_of_others,
    ordinary_numbers,
    own_parameters,
    passes,
    told,
)
from edugym_course.lab.records import number_of
from edugym_course.lessons.stochasticity.exact import CROSSINGS, crossing
from edugym_course.teaching.assignment import Task, tasks_of
from edugym_course.teaching.marks import with_own_numbers
from tests.course.lessons.answers import LONG_CHECKS, cells_of, notebook_of, read_exercises


def takes_long(lesson: str, task: Task) -> bool:
    """Whether the answer to an exercise is that runs were made, which takes half a minute, or its check takes long."""
    return "experiment_seed" in own_parameters(task.check()) or f"{lesson}-{task.number}" in LONG_CHECKS


SOURCES = build.lesson_sources()


@cache
def tasks(lesson: str) -> list[Task]:
    """The exercises of a lesson."""
    return tasks_of(build.teacher_edition(notebook_of(SOURCES[lesson])))


OWN = [
    pytest.param(name, task.number, marks=[pytest.mark.slow] * takes_long(name, task), id=f"{name}-{task.number}")
    for name in SOURCES
    for task in tasks(name)
    if own_parameters(task.check())
]


@cache
def exercise_of(lesson: str, number: int) -> tuple[Callable[..., str], str, str, str]:
    """The check of an exercise, the name of its answer, its solution with marks, and what runs before it."""
    cells = cells_of(SOURCES[lesson])
    task = tasks(lesson)[number - 1]
    return (
        task.check(),
        task.answer,
        [*filter(is_exercise, cells)][number - 1].source,
        read_exercises(SOURCES[lesson])[0],
    )


def solved(lesson: str, number: int, numbers: dict[str, Any]) -> Any:
    """The solution of an exercise for a student's numbers."""
    _, answer, source, imports = exercise_of(lesson, number)
    namespace: dict[str, Any] = {"__name__": "__main__"}
    exec(imports, namespace)
    exec(without_marks(with_own_numbers(source, numbers) if numbers else source), namespace)
    return eval(answer, namespace)


def test_the_page_has_every_number() -> None:
    """It is what the code makes; each exercise has one number, so that it can be said whose answer it is."""
    page = own_numbers.PAGE.read_text(encoding="utf-8")
    assert page == own_numbers.page(), "run python docs/own_numbers.py"
    told = {
        (number, int(exercise))
        for number, section in re.findall(r"^## Lesson (\w+): (.*?)(?=^## |\Z)", page, re.MULTILINE | re.DOTALL)
        for exercise in re.findall(r"^\| (\d+) \|", section, re.MULTILINE)
    }
    assert told == {(number_of(name), task.number) for name in SOURCES for task in tasks(name)}
    assert all(len(own_parameters(task.check())) == 1 for name in SOURCES for task in tasks(name))


@pytest.mark.parametrize(("lesson", "number"), OWN)
def test_an_answer_is_right_for_one_student(lesson: str, number: int) -> None:
    """With her numbers the solution is right, with any seed; it is wrong for those of others and for ordinary ones."""
    exercise, *_ = exercise_of(lesson, number)
    (name, own), *_ = own_parameters(exercise).items()
    assert len({*own.values}) == len(own.values) >= 40
    some = (
        own.values[:: len(own.values) // 2] if name != "experiment_seed" else own.values[:1]
    )  # which trains for half a minute
    for place, value in enumerate(some):
        answer = solved(lesson, number, {name: value})
        for seed in (0, 77_777, 2**31):
            assert passes(exercise, answer, seed, {name: value})
        next_value = own.values[own.values.index(value) + (1 if place == 0 else -1)]
        for wrong in ({name: next_value}, ordinary_numbers(exercise)):
            assert not wrong or not passes(exercise, answer, 5, wrong)
    assert passes(exercise, solved(lesson, number, {}), 5, ordinary_numbers(exercise))


@pytest.mark.parametrize(("lesson", "number"), OWN)
def test_a_copied_answer_is_told_kindly(lesson: str, number: int) -> None:
    """The check names the number for which it is right, and the student's own."""
    exercise, *_ = exercise_of(lesson, number)
    (name, own), *_ = own_parameters(exercise).items()
    theirs, hers = own.values[3], own.values[-2]
    answer = solved(lesson, number, {name: theirs})
    with pytest.raises(WrongAnswer) as refused:
        check(exercise, answer, seed=9, **{name: hers})
    assert f"right for {name} = {theirs}, and yours is {name} = {hers}" in str(refused.value)
    assert str(hers) in told(exercise, {name: hers})


def an_exercise(answer: Any, seed: int) -> str:
    """Nothing is declared."""
    return "Right."


def test_an_exercise_that_declares_nothing() -> None:
    """It has no numbers, and nothing to tell."""
    assert list(inspect.signature(an_exercise).parameters) == ["answer", "seed"]
    assert (draw_numbers(an_exercise, b"key"), told(an_exercise, {}), ordinary_numbers(an_exercise)) == ({}, "", {})
    assert numbers_of_others(an_exercise, 1, 0, {}) == {}


def test_crossings_that_are_stored() -> None:
    """They are what is computed; for the others the test above compares them with solutions."""
    assert [*CROSSINGS] == [*next(iter(own_parameters(exercise_of("08_stochasticity", 1)[0]).values())).values]
    low, high = CROSSINGS[0.5] - 0.001, CROSSINGS[0.5] + 0.001
    assert crossing(low, high, max_hits=5, epsilon=0.5) == pytest.approx(CROSSINGS[0.5], abs=6e-6)


def test_numbers_depend_on_the_key() -> None:
    """The same for the same key, and many different ones for many keys."""
    exercise, *_ = exercise_of("01_exploration", 1)
    drawn = [draw_numbers(exercise, bytes([key]))["height"] for key in range(200)]
    assert drawn == [draw_numbers(exercise, bytes([key]))["height"] for key in range(200)]
    assert len({*drawn}) > 70

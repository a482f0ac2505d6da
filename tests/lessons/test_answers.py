"""Checks of exercises, on right and wrong answers: every file in `lessons/answers` is found by its name."""

from collections import Counter
from functools import cache
from pathlib import Path

import build
import pytest

from edugym.training.train import train
from tests.lessons.answers import FOLDER, Answer, Exercise, read_answers, read_exercises, verdict

FILES = sorted(FOLDER.glob("*.py"))
ANSWERS = [answer for path in FILES for answer in read_answers(path)[1]]
FEWEST_WRONG, FEWEST_RIGHT = 12, 6


@pytest.fixture(autouse=True)
def training_comes_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """The setup of answers may leave training out; afterwards it is there again."""
    monkeypatch.setattr("edugym.training.repeat.train", train)


@cache
def exercises_of(lesson: str) -> tuple[tuple[str, str], list[Exercise]]:
    """What runs before every answer, and the exercises of a lesson."""
    imports, exercises = read_exercises(build.ROOT / "lessons" / f"{lesson}.py")
    return (imports, read_answers(FOLDER / f"{lesson}.py")[0]), exercises


@pytest.mark.parametrize("answer", ANSWERS, ids=lambda answer: f"{answer.lesson}-{answer.exercise}-{answer.name}")
def test_an_answer(answer: Answer) -> None:
    """A right one passes; a wrong one is refused in one sentence that says which mistake it is."""
    before, exercises = exercises_of(answer.lesson)
    said = verdict(answer, exercises[answer.exercise - 1], before)
    assert (said == "") == answer.right, said or "the check accepts it"
    for words in answer.says:
        assert words in said
    assert "\n" not in said
    assert len(said) < 700


@pytest.mark.parametrize("path", sorted((build.ROOT / "lessons").glob("[0-9][0-9]_*.py")), ids=lambda path: path.stem)
def test_every_exercise_has_answers(path: Path) -> None:
    """Twelve wrong and six right ones or more for each exercise of each lesson, and no two alike."""
    _, exercises = exercises_of(path.stem)
    answers = [answer for answer in ANSWERS if answer.lesson == path.stem]
    counts = Counter((answer.exercise, answer.right) for answer in answers)
    for number, exercise in enumerate(exercises, start=1):
        assert exercise.check, f"exercise {number} is checked by no call of `check`"
        assert counts[number, False] >= FEWEST_WRONG
        assert counts[number, True] >= FEWEST_RIGHT
    assert len({(answer.exercise, answer.code) for answer in answers}) == len(answers)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_solutions_pass_and_placeholders_are_not_solved_yet(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The lesson's own solution of an exercise is right, and counts; its empty cell is told that it is empty."""
    counted: list[tuple[str, int]] = []
    monkeypatch.setattr("edugym.grading.verdict.record_passed", lambda *passed: counted.append(passed))
    before, exercises = exercises_of(path.stem)
    for number, exercise in enumerate(exercises, start=1):
        solved = Answer(path.stem, number, True, "solution", (), exercise.solution)
        empty = Answer(path.stem, number, False, "placeholder", (), exercise.placeholder)
        counted.clear()
        assert verdict(solved, exercise, before) == ""
        assert {*counted} == {(path.stem.partition("_")[2], number)}
        assert "Not solved yet" in verdict(empty, exercise, before) or "began" in verdict(empty, exercise, before)

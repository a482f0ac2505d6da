"""Every check draws its cases from the seed, so that an answer cannot know them by heart."""

from typing import Any

import build
import numpy as np
import pytest

from tests.course.lessons.answers import LONG_CHECKS, Answer, Exercise, read_answers, read_exercises, verdict

WITHOUT_A_GENERATOR = {
    *("06_signal-3", "09_model_based-1", "12_objectives-3", "13_several_agents-1", "13_several_agents-2"),
}
"""One puts all cases that matter in another order, and the others compute numbers from the seed."""
DRAWN = {
    f"{path.stem}-{number}": (exercise, before)
    for path in build.lesson_sources().values()
    for before in [(read_exercises(path)[0], read_answers(path.stem)[0])]
    for number, exercise in enumerate(read_exercises(path)[1], start=1)
    if "seed=1" in exercise.check and f"{path.stem}-{number}" not in WITHOUT_A_GENERATOR
}
"""Every exercise whose answer is a function or a class, and what runs before it."""
NAMES = [pytest.param(name, marks=[pytest.mark.slow] * (name in LONG_CHECKS)) for name in DRAWN]


@pytest.mark.parametrize("name", NAMES)
def test_solutions_are_right_with_other_seeds(name: str) -> None:
    """Cases in which all mistakes differ are found with each of them."""
    exercise, before = DRAWN[name]
    [line] = [line for line in exercise.check.splitlines() if "seed=1" in line]
    for seed in range(2, 8):
        check = line.replace("seed=1", f"seed={seed}")
        solved = Answer("", 0, True, name, (), exercise.solution)
        assert verdict(solved, Exercise(exercise.placeholder, exercise.solution, check), before) == ""


@pytest.mark.parametrize("name", NAMES)
def test_another_seed_makes_other_cases(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first numbers that the check draws are others."""
    (exercise, before), default_rng = DRAWN[name], np.random.default_rng
    drawn: dict[bool, set[float]] = {}
    for line in exercise.check.splitlines():
        first = drawn.setdefault("seed=1" in line, set())

        def noted(*seed: Any, first: set[float] = first) -> np.random.Generator:
            first |= {default_rng(*seed).random()} if seed else set()  # a check may also draw without one
            return default_rng(*seed)

        monkeypatch.setattr(np.random, "default_rng", noted)
        solved = Answer("", 0, True, name, (), exercise.solution)
        assert verdict(solved, Exercise(exercise.placeholder, exercise.solution, line), before) == ""
    assert drawn[False] != drawn[True]

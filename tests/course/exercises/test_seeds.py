"""Every check draws its cases from the seed, so that an answer cannot know them by heart."""

from collections.abc import Callable, Iterator
from functools import wraps
from types import FunctionType
from typing import Any

import build
import pytest

from edugym.training.train import train
from tests.course.lessons.answers import Exercise, read_answers, read_exercises

FIXED = {
    "01_exploration-3": {"act", "greedy"},
    "04_dimensionality-3": {"row_for"},
    "05_memory-2": {"row"},
    "10_own_problem-3": {"initial", "reward", "terminal", "observation"},
}
"""What is called with the same numbers for every seed: these cover all that matters."""
SHUFFLED = "06_signal-3"
"""All cases that matter, in another order for each seed."""
OF_TABLES = {"hand_back", "target_of", "update", "plan", "sweep"}
"""What is called with nothing new: its cases are the tables of the agent."""


def drawn() -> Iterator[tuple[str, int, str, Exercise]]:
    """Every exercise whose answer is a function or a class: what runs before it, and the exercise."""
    for path in build.lesson_sources().values():
        imports, exercises = read_exercises(path)
        before = f"{imports}\n{read_answers(path.stem)[0]}"
        for number, exercise in enumerate(exercises, start=1):
            if "seed=1" in exercise.check:
                yield path.stem, number, before, exercise


@pytest.fixture(autouse=True)
def training_comes_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """The setup of answers may leave training out; afterwards it is there again."""
    monkeypatch.setattr("edugym.experiments.repeat.train", train)


def is_of_a_case(value: Any) -> bool:
    """Agents, generators and functions are not."""
    return not (callable(value) or hasattr(type(value), "learn") or hasattr(type(value), "random"))


def noting(function: Callable[..., Any], calls: set[str]) -> Callable[..., Any]:
    """The function, which notes what it is called with, but for the agent and the generator."""

    @wraps(function)
    def noted(*given: Any, **told: Any) -> Any:
        if function.__name__ in OF_TABLES:
            calls.add(repr(given))
        else:
            everything = [*given, *(told[name] for name in sorted(told))]
            calls.add(repr([one for one in everything if is_of_a_case(one)]))
        return function(*given, **told)

    return noted


def calls_of(before: str, exercise: Exercise, seed: int) -> dict[str, set[str]]:
    """What the check calls the functions and methods of the solution with."""
    names: dict[str, Any] = {"__name__": "__main__"}
    exec(before, names)
    imported = dict(names)
    exec(exercise.solution, names)
    calls: dict[str, set[str]] = {}
    for name, made in list(names.items()):
        if made is imported.get(name):
            continue
        if isinstance(made, FunctionType):
            names[name] = noting(made, calls.setdefault(name, set()))
        elif isinstance(made, type):
            for method, function in list(vars(made).items()):
                if isinstance(function, FunctionType) and method[0] != "_":
                    setattr(made, method, noting(function, calls.setdefault(method, set())))
    line = next(line for line in exercise.check.splitlines() if ("seed=1" in line) == (seed == 1))
    exec(line, names)
    return {name: those for name, those in calls.items() if those}


DRAWN = {f"{lesson}-{number}": (before, exercise) for lesson, number, before, exercise in drawn()}
DRAWN.pop(SHUFFLED)


@pytest.mark.parametrize("name", DRAWN)
def test_another_seed_makes_other_cases(name: str) -> None:
    """Of every function and method that the check calls."""
    one, other = (calls_of(*DRAWN[name], seed) for seed in (0, 1))
    assert one
    assert {called for called in one if one[called] == other[called]} == FIXED.get(name, set())

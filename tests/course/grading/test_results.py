"""What `repeat` returned, against what was asked for; lessons 1 and 9 have more wrong answers."""

from collections.abc import Callable
from functools import partial
from typing import Any

import gymnasium
import pytest

from edugym import QLearning, repeat
from edugym.experiments.results.tables import Results
from edugym_course.grading import WrongAnswer
from edugym_course.grading.results import check_results

WALL: dict[str, Any] = {"height": 3, "layout_seed": 0}
Methods = dict[str, Callable[[Any], Any]]
METHODS: Methods = {
    "slow": partial(QLearning.create, learning_rate=0.1),
    "fast": partial(QLearning.create, learning_rate=0.9),
}


def results(methods: Methods, task: Any = "Boulder", **how: Any) -> Results:
    """An experiment of ten steps."""
    how = {"repetitions": 2, "evaluate_every": 10, "jobs": 1, **how}
    return repeat(task, methods, 10, parameters=WALL if isinstance(task, str) else None, **how)


def checked(answer: Any) -> Any:
    """Check an experiment of ten steps with two repetitions."""
    asked = {"n_steps": 10, "repetitions": 2}
    wall = gymnasium.make("edugym/Boulder-v0", **WALL)
    return check_results("mine", answer, asked=asked, methods=METHODS, environment=wall)


def test_experiments() -> None:
    """What differs is named; the right results come back, also with one method more, but not if a run is missing."""
    other: Methods = {**METHODS, "fast": partial(QLearning.create, learning_rate=0.8)}
    same: Methods = {**METHODS, "again": METHODS["slow"]}
    for answer, says in (
        (results(METHODS, repetitions=3), "mine should be an experiment with repetitions 2, but it has repetitions 3"),
        (
            results(METHODS, gymnasium.make("edugym/Boulder-v0", height=2)),
            "mine should be an experiment with height 3, but it has height 2",
        ),
        (results(other), "mine should have for 'fast' the learning_rate 0.9, but it has 0.8"),
        (results(same), "mine should have different methods, but 'slow' and 'again' are the same agent"),
        (results({"slow": METHODS["slow"]}), "mine should have the method 'fast', but has only slow: keep the labels"),
        (checked, r"mine should be what `repeat\(...\)` returns, but is of the type function: call it"),
        ([results(METHODS)], r"mine should be .+ of the type list: one call takes all methods, in one dictionary"),
    ):
        with pytest.raises(WrongAnswer, match=f"^{says}$"):
            checked(answer)
    answer = results({**METHODS, "own": partial(QLearning.create, learning_rate=0.5)})
    assert checked(answer) is answer
    whole = results(METHODS, gymnasium.make("edugym/Boulder-v0", height=3, layout_seed=0))
    assert checked(whole) is whole
    table = whole.table[(whole.table["method"] != "fast") | (whole.table["repetition"] == 0)]
    says = "^mine is not complete: the experiment was stopped, so run its cell again$"
    with pytest.raises(WrongAnswer, match=says):
        checked(Results(table, whole.agents))

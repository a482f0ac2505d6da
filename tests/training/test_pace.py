"""How many steps training takes in one call."""

import time
from typing import Any

import numpy as np
import pytest

from edugym.checks.mdps import CHECKED_STEPS
from edugym.training import trainers
from tests.training.tasks import Stairs, StudentsQLearning


def test_calls_grow_until_they_take_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twice as many after less than half of the time, fewer after more than all of it, and never none."""
    now = [0.0]
    monkeypatch.setattr(trainers, "CALL_SECONDS", 0.25)
    monkeypatch.setattr(time, "perf_counter", lambda: now[0])
    pace, taken = trainers.Chunk(), list[int]()
    for at_most, seconds in (
        (1_000, 0.0625), (1_000, 0.0625), (70, 0.0), (1_000, 0.125), (1_000, 0.25), (1_000, 1.0), (1_000, 100.0),
        (1_000, 0.0), (1_000, 0.0),
    ):  # fmt: skip
        with pace.steps(at_most) as n_steps:
            now[0] += seconds
        taken.append(n_steps)
    assert taken == [50, 100, 70, 200, 200, 200, 50, 1, 2]


@pytest.mark.parametrize(("max_steps", "rehearsed"), [(7, 7), (10**9, CHECKED_STEPS)])
def test_no_long_episode_is_rehearsed(max_steps: int, rehearsed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Before evaluation is machine code the interpreter plays one episode, which could take hours."""
    limits = list[int]()

    def executable(loop: Any, arguments: Any, **how: Any) -> Any:
        limits.append(arguments[2])
        return loop

    trainer: Any = trainers.trainer(Stairs(), StudentsQLearning(np.zeros((4, 2))), 0, max_steps, 10_000)
    monkeypatch.setattr(trainers, "executable", executable)
    trainer._compile_playing()
    assert limits == [rehearsed]

"""Whole numbers have 64 bits wherever Python runs: NumPy's default has 32 on some machines, as in a web browser."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import edugym
from edugym.adapters.registration import in_course_order
from edugym.compiled.code import arrays_in
from edugym.training.trainers import trainer


def narrow(make: Callable[..., Any]) -> Callable[..., Any]:
    """NumPy's function as it is where whole numbers have 32 bits unless something else is asked for."""

    def made(value: Any, *args: Any, **how: Any) -> Any:
        result = make(value, *args, **how)
        asked = args or "dtype" in how or hasattr(value, "dtype")
        return result if asked or result.dtype != np.int64 else result.astype(np.int32)

    return made


def separate_frames() -> Any:
    """A corridor of which the agent sees two sights, each as a number of its own."""
    return edugym.SeparateFrames.create(edugym.make_mdp("MemoryCorridor"), 2)


def discretised() -> Any:
    """Trashbot for a table."""
    return edugym.Discretised.create(edugym.DiscreteActions.create(edugym.make_mdp("Trashbot"), 3), 4)


TASKS = [entry.name for entry in in_course_order() if entry.name != "Trashbot"]


@pytest.mark.parametrize("task", [*TASKS, separate_frames, discretised])
@pytest.mark.parametrize("kind", [edugym.QLearning, edugym.DQN])
def test_no_array_has_fewer_than_64_bits(kind: Any, task: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """What training works on, for a table and for vectors, where the default has 32 bits."""
    for name in ("array", "asarray"):
        monkeypatch.setattr(np, name, narrow(getattr(np, name)))
    assert np.array([1]).dtype == np.int32
    given = {"observation_type": "vectorised"} if task == "Catch" else {}
    mdp = task() if callable(task) else edugym.make_mdp(task, **given)
    playing: Any = trainer(mdp, kind.create(mdp), 0, None, 0)
    arrays = list(arrays_in(playing._plain_arguments))
    assert arrays
    assert [array.dtype for array in arrays if array.dtype == np.int32] == []

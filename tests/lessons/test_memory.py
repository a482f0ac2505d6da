"""Partial observability in MemoryCorridor: the claims hold with other seeds than those the lesson shows."""

import numpy as np
import pytest

from edugym.envs.memory_corridor import MemoryCorridor
from edugym.lessons.memory import (
    action_law,
    dense_table,
    is_enough,
    learn,
    name,
    perfect_play,
    remember,
    smallest_window,
    window_law,
)


@pytest.mark.parametrize("length", [1, 2, 3, 4, 5])
def test_smallest_window(length: int) -> None:
    """Frames alone need L(L-1)/2 + 1, and with the actions L or 2L - 3; one less is not enough."""
    assert smallest_window(length) == window_law(length)
    assert smallest_window(length, actions=True) == action_law(length)
    if length > 1:
        assert not is_enough(window_law(length) - 1, length)
        assert not is_enough(action_law(length) - 1, length, actions=True)


def test_perfect_play_is_that_of_the_task() -> None:
    """The task shows the same observations, and pays for the same doors."""
    task, rng = MemoryCorridor.create(), np.random.default_rng(0)
    state = task.initial(rng)
    doors = tuple(task.right_door(state.seed, place) for place in range(4))
    for observation, door in perfect_play(doors):
        assert task.observation(state, rng) == observation
        state = task.transition(state, door, rng)
        assert not task.terminal(state)
    assert state.length == 5


def test_notes() -> None:
    """A player with the right memory opens a thousand right doors, in every episode."""
    assert remember(repetitions=3).final("notes").tolist() == [1_000.0] * 3


def test_dense_table() -> None:
    """A table over single frames has 4 rows of 3 numbers of 8 bytes; one over 25 has 27 petabytes."""
    assert dense_table(1) == 96
    assert round(dense_table(25) / 1e15) == 27


def test_a_window_that_is_enough_is_learned() -> None:
    """Two frames with the action between get through corridor 2, which one frame does not."""
    short, long = (learn(k, actions=True, n_steps=50_000, repetitions=3).final(name(k)).mean() for k in (1, 2))
    assert long > 3.0 > short

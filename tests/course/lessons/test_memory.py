"""Partial observability in MemoryCorridor: the claims hold with other seeds than those the lesson shows."""

from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym.envs.memory_corridor import MemoryCorridor
from edugym_course.lessons.memory import figures, lake, players, windows


@pytest.mark.parametrize("length", [1, 2, 3, 4, 5])
def test_smallest_window(length: int) -> None:
    """Frames alone need L(L-1)/2 + 1, and with the actions L or 2L - 3; one less is not enough."""
    assert windows.smallest_window(length) == windows.window_law(length)
    assert windows.smallest_window(length, actions=True) == windows.action_law(length)
    if length > 1:
        assert not windows.is_enough(windows.window_law(length) - 1, length)
        assert not windows.is_enough(windows.action_law(length) - 1, length, actions=True)


def test_perfect_play_is_that_of_the_task() -> None:
    """The task shows the same observations, and pays for the same doors."""
    task, rng = MemoryCorridor.create(), np.random.default_rng(0)
    state = task.initial(rng)
    doors = tuple(task.right_door(state.seed, place) for place in range(4))
    for observation, door in windows.perfect_play(doors):
        assert task.observation(state, rng) == observation
        state = task.transition(state, door, rng)
        assert not task.terminal(state)
    assert state.length == 5


def test_notes() -> None:
    """A player with the right memory opens a thousand right doors, in every episode."""
    assert players.remember(repetitions=3).final("notes").tolist() == [1_000.0] * 3


def test_dense_table() -> None:
    """A table over single frames has 4 rows of 3 numbers of 8 bytes; one over 25 has 27 petabytes."""
    assert windows.dense_table(1) == 96
    assert round(windows.dense_table(25) / 1e15) == 27


@pytest.mark.parametrize(("k", "actions"), [(1, False), (4, False), (7, False), (2, True), (5, True), (7, True)])
def test_best_play(k: int, actions: bool) -> None:
    """It never errs as far as the law goes, and goes on a little further."""
    best, sure = windows.best_play(k, actions), windows.never_errs(k, actions)
    assert best.through[:sure] == (1.0,) * sure
    assert best.through[sure] < 1.0
    assert sure * (sure + 1) / 2 < best.value < (sure + 2) * (sure + 3) / 2
    assert [*best.through] == sorted(best.through, reverse=True)


def test_best_play_of_the_smallest_window() -> None:
    """With one observation unmarked doors are guessed: corridor L is passed with probability 3 to the power 1 - L."""
    through = np.cumprod([3.0 ** (1 - length) for length in range(1, 10)])
    guessed = windows.best_play(1)
    # One door can be opened at every unmarked place only, so that the guesses of an episode are not independent.
    assert guessed.through[0] == 1.0
    assert guessed.through[1] == pytest.approx(through[1])
    assert guessed.value > 1.0 + 2 / 3


@pytest.mark.slow
def test_learning_comes_close_to_the_best_play() -> None:
    """Q-learning with other seeds than the lesson's."""
    for k, actions in ((3, False), (3, True)):
        learned = players.late(
            players.learn(k, actions, n_steps=50_000, repetitions=10, seed=3), players.name(k)
        ).mean()
        assert learned == pytest.approx(windows.best_play(k, actions).value, abs=0.4)


def test_twins() -> None:
    """They look the same in the window, and their right doors differ; where the window is enough there are none."""
    pair = windows.twins(4, 4, actions=True)
    assert pair is not None
    seen_by, right = [], []
    for doors, step in pair:
        play = [*windows.perfect_play(doors)]
        seen_by.append((play[step - 3 : step + 1], [door for _, door in play[step - 3 : step]]))
        right.append(play[step][1])
    assert [seen for seen, _ in seen_by[0][0]] == [seen for seen, _ in seen_by[1][0]]
    assert seen_by[0][1] == seen_by[1][1]
    assert right[0] != right[1]
    assert windows.twins(5, 4, actions=True) is None
    with pytest.raises(ValueError, match="enough"):
        figures.twin_figure(5, 4, actions=True)


def test_eyes_shut_on_the_lake() -> None:
    """The row of a window grows by its digits: nothing is seen, four actions."""
    ice = lake.blind_lake(3, actions=True)
    assert ice.reset(seed=0)[0] == 0
    rows = [ice.step(action)[0] for action in (1, 1, 2)]
    assert rows == [1, 1 * 4 + 1, 1 * 4 + 2]
    assert ice.observation_space.n == 16
    assert lake.blind_lake(6, actions=False).observation_space.n == 1


def test_a_window_on_a_lake_that_is_seen() -> None:
    """Two cells, or two cells and the step between them: three digits, of 16 cells and 4 actions."""
    ice = gymnasium.make("FrozenLake-v1", is_slippery=False)
    right, down = 2, 1
    seen_by: tuple[tuple[Any, list[int]], ...] = (
        (lake.Window(ice, 2), [0 * 16 + 1, 1 * 16 + 2, 2 * 16 + 6]),
        (
            lake.Window(ice, 2, actions=True),
            [(0 * 4 + right) * 16 + 1, (1 * 4 + right) * 16 + 2, (2 * 4 + down) * 16 + 6],
        ),
    )
    for window, rows in seen_by:
        assert window.reset(seed=0)[0] == 0
        assert [window.step(action)[0] for action in (right, right, down)] == rows
        assert rows[-1] < window.observation_space.n


@pytest.mark.parametrize(("step", "back"), [(1, 1), (3, 3), (4, 2), (6, 6), (7, 5), (8, 3)])
def test_the_arrow_points_to_where_the_door_was_marked(step: int, back: int) -> None:
    """Door p is marked last in corridor p + 1, whose steps come after those of all shorter corridors."""
    (ax,) = figures.walk_figure((2, 0, 1, 1), step).draw().axes
    assert f"marked {back} steps ago" in {text.get_text() for text in ax.texts}

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


def test_numbers_in_the_text() -> None:
    """Notes open a thousand right doors; a table over 25 frames has 27 petabytes; a window of one guesses."""
    assert players.remember(repetitions=3).final("notes").tolist() == [1_000.0] * 3
    assert windows.dense_table(1) == 96
    assert round(windows.dense_table(25) / 1e15) == 27
    guessed = windows.best_play(1)
    assert guessed.through[0] == 1.0
    assert guessed.through[1] == pytest.approx(1 / 3)
    assert guessed.value > 1.0 + 2 / 3


@pytest.mark.parametrize(("k", "actions"), [(1, False), (4, False), (7, False), (2, True), (5, True), (7, True)])
def test_best_play(k: int, actions: bool) -> None:
    """It never errs as far as the law goes, and goes on a little further."""
    best, sure = windows.best_play(k, actions), windows.never_errs(k, actions)
    assert best.through[:sure] == (1.0,) * sure
    assert best.through[sure] < 1.0
    assert sure * (sure + 1) / 2 < best.value < (sure + 2) * (sure + 3) / 2
    assert [*best.through] == sorted(best.through, reverse=True)


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


def test_windows_on_the_lake() -> None:
    """The row of a window grows by its digits: 4 actions where nothing is seen, of 16 cells and 4 actions else."""
    blind = lake.blind_lake(3, actions=True)
    assert blind.reset(seed=0)[0] == 0
    assert [blind.step(action)[0] for action in (1, 1, 2)] == [1, 1 * 4 + 1, 1 * 4 + 2]
    assert blind.observation_space.n == 16
    assert lake.blind_lake(6, actions=False).observation_space.n == 1
    ice = gymnasium.make("FrozenLake-v1", is_slippery=False)
    right, down = 2, 1
    seen, cells, actions = lake.Window(ice, 2), [0, 1, 2, 6], [right, right, down]
    assert [seen.reset(seed=0)[0], *[seen.step(action)[0] for action in actions]] == [0, 1, 1 * 16 + 2, 2 * 16 + 6]
    window: Any = lake.Window(ice, 2, actions=True)
    rows = [(cell * 4 + action) * 16 + then for cell, action, then in zip(cells, actions, cells[1:], strict=False)]
    assert [window.reset(seed=0)[0], *[window.step(action)[0] for action in actions]] == [0, *rows]
    assert rows[-1] < window.observation_space.n


@pytest.mark.parametrize(("step", "back"), [(1, 1), (3, 3), (4, 2), (6, 6), (7, 5), (8, 3)])
def test_the_arrow_points_to_where_the_door_was_marked(step: int, back: int) -> None:
    """Door p is marked last in corridor p + 1, whose steps come after those of all shorter corridors."""
    (ax,) = figures.walk_figure((2, 0, 1, 1), step).draw().axes
    assert f"marked {back} steps ago" in {text.get_text() for text in ax.texts}

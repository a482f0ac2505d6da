"""Partial observability in MemoryCorridor: the claims hold with other seeds than those the lesson shows."""

from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym.envs.memory_corridor import MemoryCorridor
from edugym_course.lessons.memory.figures import race, twin_figure, walk_figure
from edugym_course.lessons.memory.lake import Window, blind_lake
from edugym_course.lessons.memory.players import late, learn, name, remember
from edugym_course.lessons.memory.windows import (
    action_law,
    best_play,
    dense_table,
    is_enough,
    never_errs,
    perfect_play,
    smallest_window,
    twins,
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


@pytest.mark.parametrize(("k", "actions"), [(1, False), (4, False), (7, False), (2, True), (5, True), (7, True)])
def test_best_play(k: int, actions: bool) -> None:
    """It never errs as far as the law goes, and goes on a little further."""
    best, sure = best_play(k, actions), never_errs(k, actions)
    assert best.through[:sure] == (1.0,) * sure
    assert best.through[sure] < 1.0
    assert sure * (sure + 1) / 2 < best.value < (sure + 2) * (sure + 3) / 2
    assert [*best.through] == sorted(best.through, reverse=True)


def test_best_play_of_the_smallest_window() -> None:
    """With one observation unmarked doors are guessed: corridor L is passed with probability 3 to the power 1 - L."""
    through = np.cumprod([3.0 ** (1 - length) for length in range(1, 10)])
    guessed = best_play(1)
    # One door can be opened at every unmarked place only, so that the guesses of an episode are not independent.
    assert guessed.through[0] == 1.0
    assert guessed.through[1] == pytest.approx(through[1])
    assert guessed.value > 1.0 + 2 / 3


def test_learning_comes_close_to_the_best_play() -> None:
    """Q-learning with other seeds than the lesson's."""
    for k, actions in ((3, False), (3, True)):
        learned = late(learn(k, actions, n_steps=50_000, repetitions=10, seed=3), name(k)).mean()
        assert learned == pytest.approx(best_play(k, actions).value, abs=0.4)


def test_twins() -> None:
    """They look the same in the window, and their right doors differ; where the window is enough there are none."""
    pair = twins(4, 4, actions=True)
    assert pair is not None
    windows, right = [], []
    for doors, step in pair:
        play = [*perfect_play(doors)]
        windows.append((play[step - 3 : step + 1], [door for _, door in play[step - 3 : step]]))
        right.append(play[step][1])
    assert [seen for seen, _ in windows[0][0]] == [seen for seen, _ in windows[1][0]]
    assert windows[0][1] == windows[1][1]
    assert right[0] != right[1]
    assert twins(5, 4, actions=True) is None
    with pytest.raises(ValueError, match="enough"):
        twin_figure(5, 4, actions=True)


def test_race_says_what_it_shows() -> None:
    """A notebook has no k, and the lesson's own windows have 4."""
    mine = race({"mine": MemoryCorridor.create()}, n_steps=500, repetitions=2)
    assert mine.rows[0][0].title == "yours, and windows of 4"


def test_eyes_shut_on_the_lake() -> None:
    """The row of a window grows by its digits: nothing is seen, four actions."""
    lake = blind_lake(3, actions=True)
    assert lake.reset(seed=0)[0] == 0
    rows = [lake.step(action)[0] for action in (1, 1, 2)]
    assert rows == [1, 1 * 4 + 1, 1 * 4 + 2]
    assert lake.observation_space.n == 16
    assert blind_lake(6, actions=False).observation_space.n == 1


def test_a_window_on_a_lake_that_is_seen() -> None:
    """Two cells, or two cells and the step between them: three digits, of 16 cells and 4 actions."""
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)
    right, down = 2, 1
    windows: tuple[tuple[Any, list[int]], ...] = (
        (Window(lake, 2), [0 * 16 + 1, 1 * 16 + 2, 2 * 16 + 6]),
        (Window(lake, 2, actions=True), [(0 * 4 + right) * 16 + 1, (1 * 4 + right) * 16 + 2, (2 * 4 + down) * 16 + 6]),
    )
    for window, rows in windows:
        assert window.reset(seed=0)[0] == 0
        assert [window.step(action)[0] for action in (right, right, down)] == rows
        assert rows[-1] < window.observation_space.n


@pytest.mark.parametrize(("step", "back"), [(1, 1), (3, 3), (4, 2), (6, 6), (7, 5), (8, 3)])
def test_the_arrow_points_to_where_the_door_was_marked(step: int, back: int) -> None:
    """Door p is marked last in corridor p + 1, whose steps come after those of all shorter corridors."""
    (ax,) = walk_figure((2, 0, 1, 1), step).draw().axes
    assert f"marked {back} steps ago" in {text.get_text() for text in ax.texts}

"""Stacks of observations: which row is which history, how large the table is, and what memory is worth."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import Discretised, FrameStack, MDPEnv, QLearning, SeparateFrames, make_mdp, stack_size, table_size
from edugym.rendering.ansi import to_text
from tests.compiled.cells import cell
from tests.mdp.watch import episode
from tests.training.slips import named

CORRIDOR = make_mdp("MemoryCorridor")
Digits: Any = cell("""
class Digits(NamedTuple):
    digits: tuple
    n_observations: int = 10
    n_actions: int = 4
    def initial(self, rng): return 0
    def transition(self, state, action, rng): return state + 1
    def reward(self, state, action, next_state, rng): return float(action)
    def terminal(self, state): return state == len(self.digits) - 1
    def observation(self, state, rng): return self.digits[state]
    observation_space = property(lambda self: spaces.Discrete(self.n_observations))
    action_space = property(lambda self: spaces.Discrete(self.n_actions))
""")["Digits"]
"""Shows the digits of a number one after the other, whatever the agent does."""


def test_the_row_is_the_history_read_as_digits() -> None:
    """Ten observations and ten actions are decimal digits; the first is repeated at the start, after action 0."""
    task = Digits((7, 1, 8, 2, 9), 10, 10)
    for k, actions, expected in (
        (1, False, [7, 1, 8, 2, 9]),
        (3, False, [777, 771, 718, 182, 829]),
        (1, True, [7, 1, 8, 2, 9]),
        (2, True, [707, 731, 158, 862, 249]),
        (3, True, [70707, 70731, 73158, 15862, 86249]),
    ):
        assert episode(FrameStack.create(task, k, actions), [3, 5, 6, 4]) == expected


HISTORIES = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 2)), min_size=6, max_size=12)


@given(HISTORIES, st.integers(1, 5), st.booleans())
@settings(max_examples=30)
def test_a_row_tells_the_last_observations_and_actions(history: list[tuple[int, int]], k: int, actions: bool) -> None:
    """Read backwards, digit by digit, it gives the history again; separate frames are these digits."""
    seen, done = zip(*history, strict=True)
    task = FrameStack.create(Digits(seen, 4, 3), k, actions)
    separate = SeparateFrames.create(Digits(seen, 4, 3), k, actions)
    rows, frames = episode(task, list(done[:-1])), episode(separate, list(done[:-1]))
    for n, (row, numbers) in enumerate(zip(rows, frames, strict=True)):
        assert task.observation_space.contains(row)
        assert separate.observation_space.contains(numbers)
        expected = [seen[max(n - k + 1, 0)]]
        for when in range(n - k + 2, n + 1):
            expected += [done[when - 1] if when > 0 else 0] if actions else []
            expected += [seen[max(when, 0)]]
        assert numbers.tolist() == expected
        for number, size in zip(reversed(expected), reversed(separate.sizes.tolist()), strict=True):
            row, digit = divmod(row, size)
            assert digit == number
        assert row == 0


def test_sizes_are_computed_not_built() -> None:
    """25 frames of MemoryCorridor are 27 petabytes: the size is known, and making the table is refused in words."""
    task = FrameStack.create(CORRIDOR, 25)
    assert table_size(task) == (4**25, 3)
    assert task.observation_space == spaces.Discrete(4**25)
    assert stack_size(4, 25) == 4**25
    assert stack_size(4, 3, n_actions=3) == 4**3 * 3**2
    assert stack_size(4, 10_000) == 4**10_000
    assert SeparateFrames.create(CORRIDOR, 2, actions=True).observation_space == spaces.MultiDiscrete([4, 3, 4])
    named("Q 27 petabytes 1,125,899,906,842,624 3", lambda: QLearning.create(task))


@pytest.mark.parametrize(
    ("n", "m", "most"), [(4, 1, 31), (4, 3, 18), (2**31, 1, 2), (2**32, 1, 1), (2**63 - 1, 1, 1), (2**62, 2, 1)]
)
def test_the_longest_stack_that_fits(n: int, m: int, most: int) -> None:
    """It has fewer than 2^63 rows, which are right; one more frame is refused."""
    task = Digits((3,) * 40, n, m)
    FrameStack.create(task, most, m > 1)
    named(f"k {most} {most + 1} {n}", lambda: FrameStack.create(task, most + 1, m > 1))
    if n == 4:
        assert episode(FrameStack.create(task, most), [0] * 39)[-1] == 4**most - 1


UNNUMBERED: Any = Discretised.create(make_mdp("Trashbot"), 2)
REFUSED: list[tuple[Any, Any, Any, str]] = [
    (CORRIDOR, 2, 1, "actions True False 1"),
    (CORRIDOR, 0, False, "k 1 0"),
    (CORRIDOR, 2.0, False, "k whole 2.0"),
    (UNNUMBERED, 2, True, "actions False Box"),
    (make_mdp("Catch"), 2, False, "whole Box"),
    (3, 2, False, "mdp 3"),
]


def test_what_is_refused() -> None:
    """The parameter is named, its value, and what is allowed."""
    for mdp, k, actions, names in REFUSED:
        named(names, lambda: FrameStack.create(mdp, k, actions))  # noqa: B023
    assert FrameStack.create(UNNUMBERED, 1, actions=True).n_actions == 1


def test_one_observation_can_be_stacked_without_end() -> None:
    """Who sees nothing has one row, however long the window is; actions in it count."""
    blind = Digits((0,) * 5, 1, 2)
    assert episode(FrameStack.create(blind, 10**5), [0, 1, 1, 0]) == [0] * 5
    assert episode(FrameStack.create(blind, 3, actions=True), [0, 1, 1, 0]) == [0, 0, 1, 3, 2]


def test_observations_of_several_numbers() -> None:
    """The positions of Catch are one digit in base 250."""
    task: Any = FrameStack.create(make_mdp("Catch", observation_type="vectorised"), 2)
    assert table_size(task) == (250**2, 3)
    state = task.initial(np.random.default_rng(0))
    first, again = divmod(state.row, 250)
    assert first == again
    after = task.transition(state, 1, np.random.default_rng(0))
    assert after.row == first * 250 + (state.inner.ball_x * 10 + 1) * 5 + 2


def test_picture_and_info_are_those_of_the_task() -> None:
    """Through the wrapper's states."""
    task: Any = FrameStack.create(CORRIDOR, 3, actions=True)
    env = MDPEnv(task, render_mode="ansi")
    _, info = env.reset(seed=1)
    assert info == CORRIDOR.info(env.state.inner)
    assert env.render() == to_text(CORRIDOR.scene(env.state.inner))

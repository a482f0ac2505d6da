"""Stacks of observations: which row is which history, how large the table is, and what memory is worth."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import Discretised, FrameStack, MDPEnv, QLearning, make_mdp, stack_size, table_size, train
from edugym.mdp.frame_stack import longest_stack
from edugym.rendering.ansi import to_text
from tests.mdp.watch import watched

CORRIDOR = make_mdp("MemoryCorridor")


class Digits(NamedTuple):
    """Shows the digits of a number one after the other, whatever the agent does."""

    digits: tuple[int, ...]
    n_observations: int = 10
    n_actions: int = 4

    def initial(self, rng: Any) -> int:
        """The first digit."""
        return 0

    def transition(self, state: int, action: int, rng: Any) -> int:
        """The next one."""
        return state + 1

    def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
        """The action."""
        return float(action)

    def terminal(self, state: int) -> bool:
        """After the last digit."""
        return state == len(self.digits) - 1

    def observation(self, state: int, rng: Any) -> int:
        """The digit."""
        return self.digits[state]

    @property
    def observation_space(self) -> spaces.Discrete:
        """A digit."""
        return spaces.Discrete(self.n_observations)

    @property
    def action_space(self) -> spaces.Discrete:
        """Four."""
        return spaces.Discrete(self.n_actions)


def rows(task: Any, actions: list[int]) -> list[int]:
    """The rows shown in an episode."""
    env = MDPEnv(task)
    return [env.reset(seed=0)[0], *(env.step(action)[0] for action in actions)]


def test_the_row_is_the_history_read_as_digits() -> None:
    """Ten observations are decimal digits; the first is repeated at the start."""
    task = Digits((7, 1, 8, 2, 9))
    assert rows(FrameStack.create(task, 1), [0, 1, 2, 3]) == [7, 1, 8, 2, 9]
    assert rows(FrameStack.create(task, 3), [0, 1, 2, 3]) == [777, 771, 718, 182, 829]
    assert rows(FrameStack.create(task, 1, actions=True), [0, 1, 2, 3]) == [7, 1, 8, 2, 9]
    assert isinstance(FrameStack.create(task, 1).n_recent, int)


def test_actions_are_digits_between_the_observations() -> None:
    """Of ten observations and ten actions, all rows are decimal: observation, action, observation."""
    task = Digits((7, 1, 8, 2, 9), 10, 10)
    assert rows(FrameStack.create(task, 2, actions=True), [3, 5, 6, 4]) == [707, 731, 158, 862, 249]
    assert rows(FrameStack.create(task, 3, actions=True), [3, 5, 6, 4]) == [70707, 70731, 73158, 15862, 86249]


@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 2)), min_size=6, max_size=12), st.integers(1, 5))
@settings(max_examples=30, deadline=None)
def test_a_row_tells_the_last_observations_and_actions(history: list[tuple[int, int]], k: int) -> None:
    """Read backwards, digit by digit, it gives the history again, and no row is outside the space."""
    observations, actions = zip(*history, strict=True)
    task = FrameStack.create(Digits(observations, 4, 3), k, actions=True)
    for n, row in enumerate(rows(task, list(actions[:-1]))):
        assert task.observation_space.contains(row)
        for back in range(k):
            row, seen = divmod(row, 4)
            assert seen == observations[max(n - back, 0)]
            if back < k - 1:
                row, done = divmod(row, 3)
                assert done == (actions[n - back - 1] if n > back else 0)
        assert row == 0


def test_sizes_are_computed_not_built() -> None:
    """25 frames of MemoryCorridor are 27 petabytes: the size is known, and making the table is refused in words."""
    task = FrameStack.create(CORRIDOR, 25)
    assert table_size(task) == (4**25, 3)
    assert task.observation_space == spaces.Discrete(4**25)
    assert stack_size(4, 25) == 4**25
    assert stack_size(4, 3, n_actions=3) == 4**3 * 3**2
    assert stack_size(4, 10_000) == 4**10_000
    assert longest_stack(4) == 31
    assert longest_stack(4, 3) == 18
    assert longest_stack(1) is None
    with pytest.raises(ValueError, match=r"Q would be a table of 27 petabytes \(1,125,899,906,842,624 by 3 numbers\)"):
        QLearning.create(task)


def test_the_longest_stack_that_fits() -> None:
    """31 frames of four observations take 62 bits, and their rows are right; one more is refused."""
    task: Any = FrameStack.create(Digits((3,) * 40, 4, 3), 31)
    assert rows(task, [0] * 39)[-1] == 4**31 - 1
    refused: tuple[tuple[Any, Any, str], ...] = (
        (32, False, r"k must be at most 31, but is 32: for 4 observations a longer window has 2\^63 rows or more"),
        (19, True, "k must be at most 18, but is 19: for 4 observations and 3 actions"),
        (2, 1, "actions must be True or False, but is 1"),
        (0, False, "k must be a whole number, 1 or more|k must be 1 or more"),
        (2.0, False, "k must be a whole number"),
    )
    for k, actions, message in refused:
        with pytest.raises(ValueError, match=message):
            FrameStack.create(CORRIDOR, k, actions)
    unnumbered: Any = Discretised.create(make_mdp("Trashbot"), 2)
    with pytest.raises(ValueError, match="actions must be False, since the action space is not Discrete but Box"):
        FrameStack.create(unnumbered, 2, actions=True)
    assert FrameStack.create(unnumbered, 1, actions=True).n_actions == 1
    with pytest.raises(ValueError, match=r"mdp must be an MDP, .* but is 3"):
        FrameStack.create(3, 2)
    wrong: Any = 1
    with pytest.raises(ValueError, match="actions must be True or False, but is 1"):
        FrameStack.create(CORRIDOR, 2, wrong)
    with pytest.raises(ValueError, match="a table needs observations that are whole numbers"):
        FrameStack.create(make_mdp("Catch"), 2)


def test_the_longest_stack_of_many_observations() -> None:
    """One, where there are fewer than 2^63; of more there is not even that."""
    assert [longest_stack(n) for n in (2**31, 2**32, 2**63 - 1, 2**63)] == [2, 1, 1, 0]


def test_one_observation_can_be_stacked_without_end() -> None:
    """Who sees nothing has one row, however long the window is; actions in it count."""
    blind = Digits((0,) * 5, 1, 2)
    assert rows(FrameStack.create(blind, 10**6), [0, 1, 1, 0]) == [0] * 5
    assert rows(FrameStack.create(blind, 3, actions=True), [0, 1, 1, 0]) == [0, 0, 1, 3, 2]


def test_observations_of_several_numbers() -> None:
    """The positions of Catch are one digit in base 250."""
    task: Any = FrameStack.create(make_mdp("Catch", observation_type="vectorised"), 2)
    assert table_size(task) == (250**2, 3)
    state = task.initial(np.random.default_rng(0))
    first = state.row // 250
    assert state.row == first * 250 + first
    after = task.transition(state, 1, np.random.default_rng(0))
    assert after.row == first * 250 + (state.inner.ball_x * 10 + 1) * 5 + 2


def test_machine_code_does_the_same() -> None:
    """With actions, on random walks."""
    task = FrameStack.create(CORRIDOR, 20)
    assert np.array_equal(watched(task, machine_code=True), watched(task))
    task = FrameStack.create(CORRIDOR, 5, actions=True)
    assert np.array_equal(watched(task, machine_code=True), watched(task))


def test_picture_and_info_are_those_of_the_task() -> None:
    """Through the wrapper's states."""
    task: Any = FrameStack.create(CORRIDOR, 3, actions=True)
    env = MDPEnv(task, render_mode="ansi")
    _, info = env.reset(seed=1)
    assert info == CORRIDOR.info(env.state.inner)
    assert env.render() == to_text(CORRIDOR.scene(env.state.inner))


def test_memory_pays() -> None:
    """Lesson 5, row by row: a window of k observations alone, and more with the actions in it.

    Perfect play through the corridor of length L returns L(L+1)/2 and needs L(L-1)/2 + 1 observations: 1, 2, 4 of them
    are good for 1, 3 and 6, and a little luck. (One that guesses the second door gets 2.7.)
    """
    reached = {}
    for k, actions in ((1, False), (2, False), (4, False), (2, True), (4, True)):
        task = FrameStack.create(CORRIDOR, k, actions)
        run = train(
            task,
            QLearning.create(task, discount=0.8),
            1_000_000,
            seed=1,
            evaluate_every=1_000_000,
            evaluation_episodes=500,
        )
        reached[k, actions] = run.returns[-1]
    assert 2.4 < reached[1, False] < 3.2
    assert 3.4 < reached[2, False] < 4.1
    assert 6.2 < reached[4, False] < 7.5
    assert reached[2, True] > reached[2, False] + 0.5
    assert reached[4, True] > reached[4, False] + 1.5

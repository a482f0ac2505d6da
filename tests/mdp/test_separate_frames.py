"""A window of memory as separate numbers: they are those of the history, and a network learns from them."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym import DQN, EpsilonGreedy, FrameStack, MDPEnv, SeparateFrames, make_mdp, train
from edugym.mdp.tabular import tabular_mdp
from tests.mdp.test_frame_stack import Digits, rows
from tests.mdp.watch import watched

CORRIDOR = make_mdp("MemoryCorridor")


def shown(task: Any, actions: list[int]) -> list[list[int]]:
    """The numbers shown in an episode."""
    env = MDPEnv(task)
    return [env.reset(seed=0)[0].tolist(), *(env.step(action)[0].tolist() for action in actions)]


def test_observations_stand_in_order() -> None:
    """The oldest first; at the start the first one is repeated."""
    task = SeparateFrames.create(Digits((7, 1, 8, 2, 9)), 3)
    assert shown(task, [0, 1, 2]) == [[7, 7, 7], [7, 7, 1], [7, 1, 8], [1, 8, 2]]


def test_actions_stand_between() -> None:
    """Each after the observation in which it was chosen; 0 before the start."""
    task = SeparateFrames.create(Digits((7, 1, 8, 2, 9)), 2, actions=True)
    assert shown(task, [3, 1, 2]) == [[7, 0, 7], [7, 3, 1], [1, 1, 8], [8, 2, 2]]
    assert task.observation_space == spaces.MultiDiscrete([10, 4, 10])


@pytest.mark.parametrize("actions", [False, True])
@pytest.mark.parametrize("k", [1, 2, 5])
def test_the_numbers_are_the_digits_of_the_row(k: int, actions: bool) -> None:
    """In another number system for each place."""
    digits, chosen = tuple(np.random.default_rng(k).integers(0, 10, 20).tolist()), [3, 1, 0, 2, 2, 1, 3, 0] * 2
    separate = SeparateFrames.create(Digits(digits), k, actions)
    stacked = rows(FrameStack.create(Digits(digits), k, actions), chosen)
    for row, numbers in zip(stacked, shown(separate, chosen), strict=True):
        read = 0
        for number, size in zip(numbers, separate.sizes.tolist(), strict=True):
            read = read * size + number
        assert read == row


def test_machine_code_does_the_same() -> None:
    """On random walks, where a table puts the numbers together again."""
    separate: Any = SeparateFrames.create(CORRIDOR, 7, actions=True)
    task = tabular_mdp(separate)
    np.testing.assert_array_equal(watched(task, machine_code=True), watched(task))


def test_a_network_needs_the_window() -> None:
    """With two frames and the action between, DQN gets through corridor 2; with one frame it does not."""

    def returned(k: int) -> float:
        task = SeparateFrames.create(CORRIDOR, k, actions=True)
        agent = DQN.create(task, discount=0.8, exploration=EpsilonGreedy(0.1))
        return float(train(task, agent, 20_000, evaluate_every=20_000, evaluation_episodes=50, seed=1).returns[-1])

    assert returned(2) > 3.0 > returned(1)

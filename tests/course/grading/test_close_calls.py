"""The world in which small differences in γ and in the first values change which action looks best."""

from typing import Any

import numpy as np
import pytest

from edugym_course.grading import WrongAnswer
from edugym_course.grading.close_calls import (
    AROUND,
    BANDITS,
    CORRIDOR,
    END,
    LEAVE,
    LESS,
    SMALL,
    TOLL,
    CloseCalls,
    require_close_calls,
)
from edugym_course.grading.curves import program_of
from edugym_course.lessons.loop.methods import EPSILON
from edugym_course.lessons.loop.project import CLOSE_MISTAKES, RULE, agent


@pytest.mark.parametrize(
    ("discount", "leaves"), [(0.983, [False, False]), (0.99, [False, True]), (0.995, [True, True]), (1.0, [True, True])]
)
def test_when_leaving_is_better(discount: float, leaves: list[bool]) -> None:
    """With γ = 0.99 in the second corridor alone; γ decides, since the way to the end is long."""
    assert [cost > END * discount ** (CORRIDOR - 1) for cost in LEAVE] == leaves


def test_the_world() -> None:
    """Its episodes are those of a bandit, of a corridor that is left or walked to its end, and of a toll."""
    world, rng, found = CloseCalls(0), np.random.default_rng(0), set()
    state, rewards = world.reset(seed=0)[0], list[float]()
    seen = {state}
    for _ in range(3_000):
        action = int(rng.integers(2))
        state, reward, terminated, truncated, _ = world.step(action)
        assert not truncated
        rewards.append(reward if reward in (*LEAVE, TOLL, AROUND, 0.0) else reward + LESS * action)
        seen.add(state)
        if terminated:
            found.add((len(rewards), round(sum(rewards), 3)))
            state, rewards = world.reset()[0], []
    walked = {(length, END) for length in range(1, CORRIDOR + 1)}
    tolls = {(1, AROUND), (2, TOLL)}
    assert found == {(1, SMALL), (1, -SMALL), *((1, cost) for cost in LEAVE)} | walked | tolls
    assert seen == {*range(BANDITS + 2 * CORRIDOR + 2)}


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1, 20))])
def test_right_numbers(seed: int) -> None:
    """They are not refused."""
    require_close_calls(program_of(agent), seed, RULE.right, CLOSE_MISTAKES, EPSILON)


@pytest.mark.parametrize("sentence", CLOSE_MISTAKES)
@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (1, 2))])
def test_close_mistakes(sentence: str, seed: int) -> None:
    """Each is told as this one."""
    with pytest.raises(WrongAnswer) as told:
        require_close_calls(program_of(CLOSE_MISTAKES[sentence].make), seed, RULE.right, CLOSE_MISTAKES, EPSILON)
    assert f" fit a usual mistake: {sentence}" in str(told.value)


def test_values_that_are_drawn() -> None:
    """They are no usual mistake, so what to compare is said."""

    def drawn(shape: tuple[int, int]) -> Any:
        learner = agent(shape)
        learner.Q[...] = np.random.default_rng(0).random(shape)
        return learner

    with pytest.raises(WrongAnswer, match="the first values all the same"):
        require_close_calls(program_of(drawn), 0, RULE.right, CLOSE_MISTAKES, EPSILON)

"""The exercises of lesson 0: what is right passes with any seed, and no mistake looks like it."""

from typing import Any

import numpy as np
import pytest

from edugym_course.grading import WrongAnswer
from edugym_course.lessons.loop import exercises


def discounted_return(rewards: list[float], discount: float) -> float:
    """The solution of exercise 1."""
    return sum(discount**k * reward for k, reward in enumerate(rewards))


def choose(values: Any, epsilon: float, rng: np.random.Generator) -> Any:
    """The solution of exercise 2."""
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


@pytest.mark.parametrize("seed", range(20))
def test_right_answers_pass_with_any_seed(seed: int) -> None:
    """Those of exercises 1 and 2."""
    assert exercises.exercise_1(discounted_return, seed)
    assert exercises.exercise_2(choose, seed)


@pytest.mark.parametrize("seed", range(20))
def test_the_mistake_is_the_one_that_fits_all_cases(seed: int) -> None:
    """Though in the first case it may look like another one."""
    with pytest.raises(WrongAnswer, match="the last reward is left out"):
        exercises.exercise_1(lambda rewards, discount: discounted_return(rewards[:-1], discount), seed)
    with pytest.raises(WrongAnswer, match="all later rewards are discounted by the same γ"):
        exercises.exercise_1(lambda rewards, discount: rewards[0] + discount * sum(rewards[1:]), seed)


def test_by_hand() -> None:
    """4 + 2/4 + 8/16 = 5; of two equal actions of four, each has 0.3 + 0.1 at ε = 0.4."""
    mistakes = exercises._return_mistakes([4.0, 2.0, 8.0], 0.25)
    assert 5.0 not in mistakes.values()
    assert exercises._probabilities(np.array([1.0, 3.0, 3.0, 0.0]), 0.4) == pytest.approx([0.1, 0.4, 0.4, 0.1])

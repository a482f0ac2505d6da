"""Answers that are a number: how far it may be from the right one, and what is said of one that is close."""

from collections.abc import Callable
from typing import Any

import pytest

from edugym_course.grading import WrongAnswer
from edugym_course.lessons.exploration import exercises as exploration
from edugym_course.lessons.loop import exercises as loop
from edugym_course.lessons.on_off_policy import exercises as on_off_policy
from edugym_course.lessons.on_off_policy.exact import switch
from edugym_course.lessons.own_problem import exercises as own_problem
from edugym_course.lessons.signal import exercises as signal
from edugym_course.lessons.signal.words import bits
from edugym_course.lessons.stochasticity import exercises as stochasticity
from edugym_course.lessons.stochasticity.exact import crossing

Exercise = Callable[[Any, int], str]
EPSILON = 2 * (1 - 0.5 ** (1 / 100))
LEVEL = crossing(0.02, 0.025, max_hits=5)
NEARLY = "; you are close, "


def off(function: Callable[..., float], error: float) -> Callable[..., float]:
    """A right function with an error."""
    return lambda *arguments: function(*arguments) + error


def some_return(rewards: list[float], discount: float) -> float:
    """The discounted return."""
    return sum(discount**k * reward for k, reward in enumerate(rewards))


def exact_switch(model: Any) -> float:
    """The ε at which the best run changes."""
    return switch(model, tolerance=1e-7)


TOLERANCES: list[Any] = [
    (loop.exercise_1, lambda error: off(some_return, error), 1e-9),
    (exploration.exercise_1, lambda error: EPSILON + error, 1e-6),
    (on_off_policy.exercise_1, lambda error: -36.97983 + error, 0.0055),  # a search in steps of 0.01
    (on_off_policy.exercise_1, lambda error: -36.9 + error, 1e-6),  # what was asked for
    pytest.param(on_off_policy.exercise_2, lambda error: off(exact_switch, error), 0.0011, marks=pytest.mark.slow),
    (signal.exercise_2, lambda error: off(bits, error), 1e-6),
    (stochasticity.exercise_1, lambda error: LEVEL + error, 0.00006),
    (own_problem.exercise_1, lambda error: 59 / 9 + error, 0.005),
]
"""A right answer with an error, and how large this may be."""
REFUSED = [
    (exploration.exercise_1, EPSILON * 1.069, "smaller, by a little: give six digits or more"),
    (exploration.exercise_1, EPSILON * 1.071, "so ε must be smaller"),
    (exploration.exercise_1, EPSILON * 0.931, "larger, by a little: give six digits or more"),
    (exploration.exercise_1, EPSILON * 0.929, "so ε must be larger"),
    (on_off_policy.exercise_1, -36.985 - 0.099, "that is too low, by a little: take the next higher tenth"),
    (on_off_policy.exercise_1, -36.985 - 0.101, "steps should be best" + NEARLY + "look at every tenth"),
    (on_off_policy.exercise_1, -36.985 - 0.999, "steps should be best" + NEARLY + "look at every tenth"),
    (on_off_policy.exercise_1, -36.985 - 1.001, "steps should be best"),
    (
        on_off_policy.exercise_1,
        -36.95,
        "takes 4 steps, and so it does for lower numbers: with more digits than one, take",
    ),
    (
        on_off_policy.exercise_1,
        -36.91,
        "takes 4 steps, and so it does for lower numbers: with more digits than one, take",
    ),
    (on_off_policy.exercise_1, -36.985 + 0.101, "it is higher than it need be" + NEARLY + "look at every tenth"),
    (on_off_policy.exercise_1, -36.985 + 1.001, "it is higher than it need be"),
    (on_off_policy.exercise_2, off(exact_switch, 0.0123), "that is close: does the search begin at 0"),
    (on_off_policy.exercise_2, off(exact_switch, 0.0127), "print the number of steps of the best run for some ε"),
    (signal.exercise_1, 24, "fewer words are enough"),
    (stochasticity.exercise_1, LEVEL + 0.00099, "it is too high" + NEARLY + "look in steps of 0.0001"),
    (stochasticity.exercise_1, LEVEL + 0.00101, "it is too high"),
    (stochasticity.exercise_1, LEVEL - 0.00007, "worth more there" + NEARLY + "look in steps of 0.0001"),
    (stochasticity.exercise_1, LEVEL - 0.00101, "it is too low, as the drive is worth more there"),
    (own_problem.exercise_1, 59 / 9 + 0.059, "higher than it need be" + NEARLY + "but is it rounded"),
    (own_problem.exercise_1, 59 / 9 + 0.061, "it is higher than it need be"),
    (own_problem.exercise_1, 59 / 9 - 0.0051, "too low for a ring" + NEARLY + "but is it rounded"),
    (own_problem.exercise_1, 59 / 9 - 0.061, "it is too low for a ring"),
    # What would happen with the number is told, but for one that is none.
    (signal.exercise_1, 1, "1 word carries 0.022 bit at τ = 0.1: "),
    (signal.exercise_1, 101, "words = 101 is not from 1 to 100: "),
    (exploration.exercise_1, 0, "with ε = 0, 100.00% of the climbs reach the top: "),
    (exploration.exercise_1, 1.1, "ε = 1.1 is no probability: "),
    (on_off_policy.exercise_1, 1, "negative_reward = 1: "),
    (on_off_policy.exercise_1, 0, "with negative_reward = 0 the best run at ε = 0.1 stalls at once: "),
    (on_off_policy.exercise_1, -1_000_000, "with negative_reward = -1000000 the best run at ε = 0.1 takes 5 steps: "),
    (on_off_policy.exercise_1, -1_000_001, "negative_reward = -1000001 is below -1 000 000: "),
    (own_problem.exercise_1, -1, "late = -1: "),
    (
        own_problem.exercise_1,
        0,
        "with late = 0 it is best to stay quiet at 8:20",
    ),
    (
        own_problem.exercise_1,
        8,
        "fast asleep, for a ring is worth -4.7 there and silence -6: it is higher",
    ),
    (stochasticity.exercise_1, 0, "level = 0 is not a level, "),
    (stochasticity.exercise_1, 1, "at level = 1 the drive is worth -0.9985 and the chip -0.9498: "),
    (stochasticity.exercise_1, 1.1, "level = 1.1 is not a level, "),
]


@pytest.mark.parametrize(("exercise", "answer", "tolerance"), TOLERANCES)
def test_how_large_an_error_may_be(exercise: Exercise, answer: Callable[[float], Any], tolerance: float) -> None:
    """A little less than the tolerance is right, and a little more is not."""
    for sign in (-1, 1):
        assert exercise(answer(0.98 * sign * tolerance), 0)
        with pytest.raises(WrongAnswer):
            exercise(answer(1.02 * sign * tolerance), 0)


@pytest.mark.parametrize(("exercise", "answer", "says"), REFUSED)
def test_not_close_enough(exercise: Exercise, answer: Any, says: str) -> None:
    """It is told on which side it is, and that it is close only where it is."""
    with pytest.raises(WrongAnswer) as caught:
        exercise(answer, 0)
    assert says in str(caught.value)
    assert ("close" in str(caught.value) or "by a little" in str(caught.value)) == ("close" in says or "little" in says)

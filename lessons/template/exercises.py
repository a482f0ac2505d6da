"""The exercises of the template: the best return, and the target of Q-learning."""

from collections.abc import Callable
from typing import Any

import numpy as np

from edugym_course.grading.agents import require_function
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import compare
from edugym_course.lessons.template.experiments import OPTIMUM

Case = tuple[float, list[float], float, bool]
RULES: dict[str, Callable[[float, list[float], float, bool], float]] = {
    "a terminal state has no future: leave its value out when `terminated`": lambda r, v, g, end: r + g * max(v),
    "the value of the next state is not discounted": lambda r, v, g, end: r if end else r + max(v),
    "the mean over the actions stands where the maximum should": lambda r, v, g, end: (
        r if end else r + g * float(np.mean(v))
    ),
    "the reward is missing": lambda r, v, g, end: 0.0 if end else g * max(v),
}
"""What the usual mistakes give, by the sentence that tells of each."""


def exercise_1(answer: Any, seed: int) -> str:
    """Check a number that is read from a figure. It is the same for every seed."""
    mistakes = {
        "that is what the road costs before the last step, which pays 1": OPTIMUM - 1.0,
        "the sign is wrong": -OPTIMUM,
    }
    compare("best_return", answer, OPTIMUM, mistakes, says=lambda found: f"best_return is not {found:g}")
    return "Right: three steps cost 1 each, and the last one pays 1."


def exercise_2(answer: Any, seed: int) -> str:
    """Check a function on cases that are drawn from the seed."""
    require_function("target", answer, "reward, values, discount and terminated")
    rng = np.random.default_rng(seed)
    for terminated in (False, True, False, True):
        values = rng.choice(range(1, 9), 3, replace=False).astype(float).tolist()
        case: Case = (float(rng.integers(1, 9)), values, float(rng.choice([0.25, 0.5])), terminated)
        reward, values, discount, _ = case
        call = f"target({reward}, {values}, {discount}, {terminated})"
        with student_code(call):
            found = answer(reward, [*values], discount, terminated)
        expected = reward if terminated else reward + discount * max(values)
        compare(call, found, expected, {why: rule(*case) for why, rule in RULES.items() if rule(*case) != expected})
    return "Right: what comes after the end of an episode counts nothing."

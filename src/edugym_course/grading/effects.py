"""How much each number counts in what an answer makes of them, where no usual mistake explains it.

Each number is changed by a little, and it is seen how much the result changes, in the answer and by the rule. So this
finds a wrong row, a term that is missing and a wrong factor in any equation, without a name for the mistake.
"""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from edugym_course.grading.errors import WrongAnswer

A_LITTLE, CLEARLY = 2.0**-8, 1e-3
MOST = 3
"""So many numbers are told."""

Result = Callable[[dict[str, Any], float], float]
"""What comes out in one entry, given the tables before and the reward."""


def otherwise_counted(tables: Mapping[str, Any], reward: float, rule: Result, answer: Result) -> str:
    """Return which numbers count otherwise than they should, "" if that cannot be told.

    Args:
        tables: the tables before; those of whole numbers are left as they are.
        reward: the reward.
        rule: the right result.
        answer: that of the answer.
    """
    try:
        start = answer(_copied(tables), reward)
        right = rule(_copied(tables), reward)
        inputs: list[tuple[str, dict[str, Any], float]] = [("the reward", _copied(tables), reward + A_LITTLE)]
        for name, table in tables.items():
            for entry in np.ndindex(table.shape) if table.dtype.kind == "f" else ():
                changed = _copied(tables)
                changed[name][entry] += A_LITTLE
                inputs.append((f"{name}[{', '.join(map(str, entry))}]", changed, reward))
        told = []
        for name, changed, new_reward in inputs:
            yours, should = (
                (result(_copied(changed), new_reward) - old) / A_LITTLE
                for result, old in ((answer, start), (rule, right))
            )
            if abs(yours - should) > CLEARLY * max(1.0, abs(should)):
                told.append(f"{name} counts {times(yours)}, and should count {times(should)}")
    except WrongAnswer:
        return ""
    if not told:
        return ""
    more = "" if len(told) <= MOST else f" (and {len(told) - MOST} more count otherwise than they should)"
    return f"in your code {'; '.join(told[:MOST])}{more}"


def _copied(tables: Mapping[str, Any]) -> dict[str, Any]:
    return {name: table.copy() for name, table in tables.items()}


def times(factor: float) -> str:
    """Return how often a number counts, in words."""
    return "once" if round(factor, 4) == 1 else f"{round(factor, 4) + 0.0:g} times"

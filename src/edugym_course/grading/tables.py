"""Arrays that an answer gives, and the mistakes that explain them."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import mistake_in_cases
from edugym_course.grading.values import all_same, given


def table_of(call: str, value: Any, shape: tuple[int, ...], *, finite: bool = True) -> Reals:
    """Return what an answer gives as an array of numbers of a shape.

    Raises:
        WrongAnswer: it is something else.
    """
    given(call, value)
    try:
        table = np.asarray(value, float)
    except (TypeError, ValueError):
        raise WrongAnswer(f"{call} should give an array of numbers of shape {shape}, but gives {value!r}") from None
    if table.shape != shape:
        hint = ": is it the whole table that you return?" if len(shape) > 1 else ""
        raise WrongAnswer(f"{call} should give an array of shape {shape}, but gives one of shape {table.shape}{hint}")
    if finite and not np.isfinite(table).all():
        raise WrongAnswer(f"{call} should give finite numbers, but gives {table.tolist()}: is something divided by 0?")
    return table


def compare_tables(
    cases: Sequence[Any],
    found: Sequence[Reals],
    calls: Sequence[str],
    mistakes: Mapping[str, Mapping[str, Any]],
    rule: Callable[..., Reals],
) -> None:
    """Check several arrays. The first wrong one is told, with the mistake that explains all of them, or most.

    Raises:
        WrongAnswer: one is not right.
    """
    right = [rule(case) for case in cases]
    wrong = [not all_same(one, mine) for one, mine in zip(right, found, strict=True)]
    if not any(wrong):
        return

    def explained(change: Mapping[str, Any]) -> list[bool]:
        return [all_same(rule(case, **change), mine) for case, mine in zip(cases, found, strict=True)]

    why = mistake_in_cases(mistakes, explained, wrong)
    first = wrong.index(True)
    told, came = (np.round(table[first], 4).tolist() for table in (right, found))
    raise WrongAnswer(f"{calls[first]} should give {told}, but gives {came}: {why}")

"""Arrays that an answer gives, and the mistakes that explain them."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import (
    UNUSUAL,
    how_they_differ,
    mistake_in_cases,
    mistake_that_fits,
    told_wrong,
    with_what_differs,
)
from edugym_course.grading.values import CLOSE, all_near, all_same, differing, given, rounded_alike

ROUNDED = (
    "is it rounded, or stored in an array of whole numbers? An array of floats, as of np.zeros(...), keeps what is"
    " behind the decimal point"
)


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


MOST_ENTRIES = 3
"""So many entries that differ are named."""


def entries_that_differ(right: Reals, found: Reals, n_wrong: int, n_cases: int) -> str:
    """Return which entries of an array differ, or how all of them do, and in how many cases the answer is right."""
    entries = differing(right, found).tolist()
    told = how_they_differ(found.ravel().tolist(), right.ravel().tolist()).replace(" cases", " entries")
    if len(entries) <= MOST_ENTRIES and len(entries) < right.size:
        told = "; ".join(
            f"entry [{', '.join(map(str, at))}] should be {right[tuple(at)]:.4g}, and is {found[tuple(at)]:.4g}"
            for at in entries
        )
    others = f"it is right in {n_cases - n_wrong} of {n_cases} cases; here " if n_wrong < n_cases else ""
    return f"{others}{told}" if told else ""


def _told_apart(right: Reals, found: Reals) -> tuple[Any, Any]:
    """Return two arrays as lists, with four decimal places or as many as tell them apart."""
    for places in range(4, 17):
        one, other = (np.round(table, places) for table in (right, found))
        if not np.array_equal(one, other):
            break
    return one.tolist(), other.tolist()


def compare_tables(
    cases: Sequence[Any],
    found: Sequence[Reals],
    calls: Sequence[str],
    mistakes: Mapping[str, Mapping[str, Any]],
    rule: Callable[..., Reals],
    verb: str = "give",
    otherwise: Callable[[Sequence[bool]], str] = lambda wrong: UNUSUAL,
) -> None:
    """Check several arrays. The first wrong one is told, with the mistake that explains all of them, or most.

    Args:
        cases: what the answer was given.
        found: its arrays, by case.
        calls: what gave them, for the sentence.
        mistakes: what changes the rule into a mistake, by the sentence that tells of it.
        rule: the right array for a case, and with other arguments that of a mistake.
        verb: what the calls do.
        otherwise: what to say if no mistake fits, given which cases are wrong.

    Raises:
        WrongAnswer: one is not right.
    """
    right = [rule(case) for case in cases]
    wrong = [not all_same(one, mine) for one, mine in zip(right, found, strict=True)]
    if not any(wrong):
        return

    def explained(change: Mapping[str, Any]) -> list[bool]:
        return [all_same(rule(case, **change), mine) for case, mine in zip(cases, found, strict=True)]

    first = wrong.index(True)
    numbers = [np.concatenate([table.ravel() for table in tables]).tolist() for tables in (found, right)]
    rounded = rounded_alike(*numbers)
    if rounded or all_near(*numbers):
        why = mistake_that_fits(mistakes, lambda change: all(explained(change)), ROUNDED if rounded else CLOSE)
    else:
        where = entries_that_differ(right[first], found[first], sum(wrong), len(cases))
        why = mistake_in_cases(mistakes, explained, wrong, with_what_differs(otherwise(wrong), where))
    told, came = _told_apart(right[first], found[first])
    raise WrongAnswer(told_wrong(f"{calls[first]} should {verb} {told}, but {verb}s {came}", why))

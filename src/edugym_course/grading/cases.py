"""Made-up cases that tell a right answer and every usual mistake apart."""

from collections.abc import Callable, Collection, Iterable
from typing import Any, TypeVar

import numpy as np

Case = TypeVar("Case")
MOST_DRAWS = 1_000
LEARNING_RATES = (0.125, 0.25)
DISCOUNTS = (0.625, 0.7)
"""α and γ of made-up cases. No two of α, 2α, 1 − α, γ, 1 − γ and 1 are equal, so that none can stand for another."""
STARTS = (0, 1, 10, 100, 1_000)
"""From what (or from its negative) a search for the largest value is often started, where all values may be lower."""
FAR_BELOW = 2_000.0
"""What is taken off some made-up values, so that each of `STARTS` shows."""


def telling_draw(
    seed: int,
    make: Callable[[np.random.Generator], Iterable[Case]],
    rules: Collection[Callable[[Case], Any]],
) -> np.random.Generator:
    """Return a generator from which cases are drawn in which no two rules look alike.

    Cases by chance may hide a mistake: "the value of action 0" is right wherever action 0 is the best.

    Args:
        seed: the number from which the cases are drawn, 0 or more.
        make: draws the cases.
        rules: the right rule and the mistakes; each gives a number or an array for a case.

    Returns:
        A generator with which `make` draws cases so that any two rules differ in one of them or more.

    Raises:
        ValueError: two rules are the same.
    """
    ordered = [*rules]
    for draw in range(MOST_DRAWS):
        cases = [*make(np.random.default_rng([seed, draw]))]
        alike = _first_alike(ordered, cases)
        if not alike:
            return np.random.default_rng([seed, draw])
        # What looked alike once often does again, so these two come first in the next draw, and most need not be asked.
        ordered = [*alike, *(rule for rule in ordered if rule not in alike)]
    raise ValueError(f"rules must differ in some cases, but two of them never differed in {MOST_DRAWS} draws")


def from_a_start(row: Any, start: int) -> float:
    """Return the largest value, as found from a start at -`start` on."""
    return max(-float(start), float(np.max(row)))


def starts(sentence: Callable[[str], str], setting: Callable[[int], Any]) -> dict[str, Any]:
    """Return the mistakes of `STARTS` by the sentences that tell of them.

    Args:
        sentence: what is said of a start, given as a text.
        setting: what makes the mistake with a start.
    """
    return {sentence(f"−{start}" if start else "0"): setting(start) for start in STARTS}


def _first_alike(rules: Iterable[Callable[[Case], Any]], cases: Collection[Case]) -> list[Callable[[Case], Any]]:
    """Return two rules that give the same for all cases; none if any two differ."""
    found: dict[tuple[float, ...], Callable[[Case], Any]] = {}
    for rule in rules:
        if (earlier := found.setdefault(tuple(_rounded(rule, cases)), rule)) is not rule:
            return [earlier, rule]
    return []


def _rounded(rule: Callable[[Case], Any], cases: Iterable[Case]) -> list[float]:
    """Return all that a rule gives, without what rounding adds."""
    numbers: list[float] = np.concatenate([np.ravel(rule(case)) for case in cases]).astype(float).round(6).tolist()
    return numbers

"""Compares a student's number with the right one, and with those that the usual mistakes would give."""

import math
from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np

from edugym_course.grading.errors import Unsolved, WrongAnswer

TOLERANCE = 1e-9
"""How far two numbers may differ, relative to the larger one, that are the same but for rounding."""
CARET = "`^` is no power in Python, that is `**`"
"""The hint for a number that comes out if `^` is written for `**`."""
ROUNDED = "is it rounded? Give the number as it is, without round(), int() or //"
CLOSE = (
    "that is close, but not exact: is a search or a sum stopped too early, or a number in it rounded? There is room for"
    " nine digits"
)
"""The hint for numbers that are all within `NEARBY` of the right ones, and no rounding of them to a few digits."""
NEARBY = 1e-4
UNUSUAL_NUMBER = "that is none of the usual mistakes, so work it out once more by hand"


def given(what: str, value: Any) -> None:
    """Refuse a value that is missing: the placeholder of an exercise, or None.

    Raises:
        Unsolved: the value is the placeholder `...`, or None.
        WrongAnswer: the value is None, and it is what a function returned.
    """
    if value is ...:
        raise Unsolved(f"Not solved yet: {what} is still `...`; put your answer there.")
    if value is None:
        if "(" in what:
            raise WrongAnswer(f"{what} gives None: is a `return` missing? Or is none reached?")
        raise Unsolved(f"Not solved yet: {what} is None; give it a value.")


def number(what: str, value: Any) -> float:
    """Return a finite number as a float, of whatever kind it is: of NumPy, an array without axes, a fraction.

    Args:
        what: what the value is, for the sentence: "epsilon", "V(3)".
        value: the student's value.

    Raises:
        WrongAnswer: it is no finite number.
    """
    given(what, value)
    if isinstance(value, bool | np.bool_):
        raise WrongAnswer(f"{what} should be a number, but is the truth value {value}")
    if isinstance(value, str):
        raise WrongAnswer(f"{what} should be a number, but is the text {value!r}: leave the quotes out")
    if isinstance(value, tuple | list | dict | set) or getattr(value, "ndim", False):
        kind, of_them = type(value).__name__, "take an entry of it"
        if hasattr(value, "shape"):
            kind, of_them = f"{kind} of shape {value.shape}", f"{of_them}, or is it their sum that is needed?"
        raise WrongAnswer(f"{what} should be one number, but is a {kind}: {of_them}")
    if callable(value):
        raise WrongAnswer(f"{what} should be a number, but is a function: call it, with parentheses")
    if hasattr(value, "item") and not isinstance(value, np.generic):
        value = value.item()  # an array without axes, of NumPy or torch
    if isinstance(value, complex | np.complexfloating):
        raise WrongAnswer(f"{what} should be a real number, but is {value}: is it the root of a negative number?")
    if not isinstance(value, int | float | np.number | Fraction | Decimal):
        raise WrongAnswer(f"{what} should be a number, but is of the type {type(value).__name__}")
    try:
        found = float(value)
    except OverflowError:
        found = math.inf
    if not math.isfinite(found):
        raise WrongAnswer(f"{what} should be a finite number, but is {found}: is something divided by zero?")
    return found


def compare(
    what: str,
    value: Any,
    expected: float,
    mistakes: Mapping[str, float],
    *,
    tolerance: float | None = None,
    says: Callable[[float], str] | None = None,
    otherwise: str = UNUSUAL_NUMBER,
) -> float:
    """Check a number.

    Args:
        what: what the value is, for the sentence.
        value: the student's value.
        expected: the right one, worked out by hand.
        mistakes: by the sentence that tells of it, what each mistake would give. They must differ from `expected`.
        tolerance: how far the number may be from the right one; by default only as far as rounding takes it.
        says: what the sentence says of the number instead of the right one, which would give the answer away.
        otherwise: what to say of any other number.

    Returns:
        The number.

    Raises:
        WrongAnswer: it is another number.
    """
    found = number(what, value)
    if abs(found - expected) <= (allowance(expected) if tolerance is None else tolerance):
        return found
    near = {sentence: abs(found - wrong) for sentence, wrong in mistakes.items() if _looks_like(found, wrong, expected)}
    if tolerance is None and says is None and _rounded(found, expected):
        otherwise = ROUNDED
    why = min(near, key=lambda sentence: near[sentence]) if near else otherwise
    told = says(found) if says else f"{what} should be {digits(expected, found)}, but is {digits(found, expected)}"
    raise WrongAnswer(f"{told}: {why}")


A_FEW = 1_000
"""Who is off by so little has counted wrong; rounding a number with 18 digits takes more."""


def exact(call: str, value: Any, expected: int) -> None:
    """Check a number that is too large for floats and for NumPy's whole numbers.

    Args:
        call: what gave the value, for the sentence.
        value: the student's value, right where numbers are small.
        expected: the right one.

    Raises:
        WrongAnswer: it is another number, or rounded.
    """
    off = value - expected if isinstance(value, int) else 0
    if 0 < abs(off) < A_FEW:
        raise WrongAnswer(f"{call} should be a number that is {'smaller' if off > 0 else 'larger'} by {abs(off)}")
    if value != expected or isinstance(value, float | np.number):
        raise WrongAnswer(
            f"{call} should be a whole number with {len(str(expected))} digits, and floats and numbers of NumPy have"
            " no room for it: keep to Python's whole numbers, with `**` and `//`, without `/`, `2.0` or `math.pow`"
        )


def same(found: float, expected: float) -> bool:
    """Whether two numbers are the same but for rounding; no number is the same as infinity."""
    return abs(found - expected) <= allowance(expected) < math.inf


def differing(expected: Any, found: Any) -> Any:
    """Return the indices of the entries in which two arrays differ by more than rounding."""
    return np.argwhere(~np.isclose(expected, found, rtol=TOLERANCE, atol=TOLERANCE, equal_nan=True))


def all_same(expected: Any, found: Any) -> bool:
    """Whether two arrays are the same but for rounding."""
    return not len(differing(expected, found))


def allowance(expected: float) -> float:
    """Return how far rounding may take a number."""
    return TOLERANCE * max(1.0, abs(expected))


def _looks_like(found: float, wrong: float, expected: float) -> bool:
    """Whether a number is what a mistake gives, perhaps rounded by the student to a few digits."""
    close = 2e-3 * abs(wrong) + 1e-12
    return abs(found - wrong) <= close and abs(found - wrong) < abs(found - expected)


def all_near(found: Sequence[float], expected: Sequence[float]) -> bool:
    """Whether numbers are all close to the right ones."""
    return all(
        abs(one - right) <= NEARBY * max(1.0, abs(right)) < math.inf for one, right in zip(found, expected, strict=True)
    )


def rounded_alike(found: Sequence[float], expected: Sequence[float]) -> bool:
    """Whether numbers are the right ones, all rounded alike: to whole numbers towards 0, or to a few decimal places.

    What should be infinite does not count: no whole number is.
    """
    pairs = [pair for pair in zip(found, expected, strict=True) if math.isfinite(pair[1])]
    roundings: list[Callable[[float], float]] = [math.trunc, *(partial(round, ndigits=places) for places in range(5))]
    return any(not same(*pair) for pair in pairs) and any(
        all(same(one, rounding(right)) for one, right in pairs) for rounding in roundings
    )


def _rounded(found: float, expected: float) -> bool:
    """Whether a number is the right one, rounded to a few digits after the decimal point."""
    rounded = [math.trunc(expected), *(round(expected, places) for places in range(4))]
    return abs(found - expected) < 0.03 * abs(expected) and any(same(found, one) for one in rounded)


def unlike(found: Any, expected: Any) -> bool:
    """Whether two lists differ; one may have arrays in it, which cannot be compared as a whole."""
    try:
        return bool(found != expected)
    except ValueError:
        return True


def require_unchanged(call: str, name: str, mine: Any, before: Any) -> None:
    """Refuse an answer that has changed the list or the array that it was given.

    Args:
        call: the call, for the sentence.
        name: the name of the list or array.
        mine: what the answer was given, as it is now.
        before: the same as it was.

    Raises:
        WrongAnswer: they differ.
    """
    if not np.array_equal(mine, before) if isinstance(mine, np.ndarray) else unlike(mine, before):
        kind = "array" if isinstance(mine, np.ndarray) else "list"
        raise WrongAnswer(f"{call} changes its {kind} `{name}`; make a new one, for the caller still needs the old one")


def digits(value: float, other: float) -> str:
    """Return a number with as many digits as tell it from another; a whole one with all of its digits."""
    if float(value).is_integer() and abs(value) < 1e15:
        return f"{value + 0.0:.0f}"  # -0.0 is 0
    if same(value, other):
        return f"{value:.4g}"
    return next(
        (text for places in range(4, 17) if (text := f"{value:.{places}g}") != f"{other:.{places}g}"), repr(value)
    )


def in_brackets(values: Any) -> str:
    """Return numbers as a list, with four digits each."""
    return "[" + ", ".join(f"{value:.4g}" for value in values) + "]"

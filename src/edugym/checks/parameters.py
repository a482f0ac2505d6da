"""Checks of parameters: each returns the value, or raises a `ValueError` that names it, and what is allowed."""

import inspect
import math
import os
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

MOST_STEPS = 2**62
"""A number that machine code can hold, and count on from."""
MOST_ENTRIES = 2**28
"""The most rows that a table may be asked to have: two gigabytes of numbers."""
LONGEST, LONGEST_NUMBER = 200, 40
"""The most letters of a value, and the most digits of a whole number, that a message shows."""


Kind = TypeVar("Kind")


def a_number(name: str, value: Any) -> float:
    """Refuse a `value` that is not a finite number."""
    number: float = _number(name, value, "finite")
    if not math.isfinite(number):
        raise ValueError(f"{name} must be a finite number, but is {in_short(value)}")
    return number


def at_least(name: str, value: Any, low: float) -> float:
    """Refuse a `value` that is not a number of `low` or more."""
    number: float = _number(name, value, f"{low} or more")
    if not number >= low:
        raise ValueError(f"{name} must be {low} or more, but is {in_short(value)}")
    return number


def between(name: str, value: Any, low: float, high: float) -> float:
    """Refuse a `value` that is not a number from `low` to `high`, ends included."""
    number: float = _number(name, value, f"from {low} to {high}")
    if not low <= number <= high:
        raise ValueError(f"{name} must be from {low} to {high}, but is {in_short(value)}")
    return number


def above(name: str, value: Any, low: float, high: float | None = None) -> float:
    """Refuse a `value` that is not a number greater than `low` (and, if given, of `high` or less)."""
    allowed = f"greater than {low}" if high is None else f"greater than {low} and at most {high}"
    number: float = _number(name, value, allowed)
    if not number > low or (high is not None and number > high):
        raise ValueError(f"{name} must be {allowed}, but is {in_short(value)}")
    return number


def whole_number(name: str, value: Any, low: int, high: int | None = None) -> int:
    """Refuse a `value` that is not a whole number of `low` or more (and, if given, of `high` or less).

    Returns:
        The value as an `int`: a small type of NumPy's would overflow silently in what is computed from it.
    """
    allowed = f"{low} or more" if high is None else f"from {low} to {high}"
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer):
        raise ValueError(f"{name} must be a whole number, {allowed}, but is {in_short(value)}")
    if value < low or (high is not None and value > high):
        raise ValueError(f"{name} must be {allowed}, but is {in_short(value)}")
    return int(value)


def number_of_steps(name: str, value: Any) -> int:
    """Refuse a `value` that is not a whole number of 1 or more, or that no machine can count to; as `whole_number`."""
    steps = whole_number(name, value, 1)
    if steps > MOST_STEPS:
        raise ValueError(f"{name} must be at most {MOST_STEPS}, but is {in_short(value)}")
    return steps


def one_of(name: str, value: Any, allowed: Sequence[Any]) -> Any:
    """Refuse a `value` that is not one of those `allowed`."""
    if isinstance(value, np.ndarray) or value not in allowed:  # `in` is ambiguous for an array
        raise ValueError(f"{name} must be one of {', '.join(map(repr, allowed))}, but is {in_short(value)}")
    return value


def true_or_false(name: str, value: Any) -> bool:
    """Refuse a `value` that is neither True nor False."""
    if not isinstance(value, bool | np.bool_):
        raise ValueError(f"{name} must be True or False, but is {in_short(value)}")
    return bool(value)


def flags(name: str, values: Any, n: int, of_what: str) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    """Refuse `values` that are not True or False for each of n things, whose name is `of_what`."""
    given = np.asarray(values) if isinstance(values, list | tuple | np.ndarray) else np.asarray(None)
    if given.shape != (n,) or given.dtype.kind not in "biufO" or not np.isin(given, (0, 1)).all():
        raise ValueError(f"{name} must be True or False for each of {n} {of_what}, but is {in_short(values)}")
    return given.astype(bool)


def a_text(name: str, value: Any) -> str:
    """Refuse a `value` that is not a text."""
    if not isinstance(value, str):
        raise ValueError(f"{name} must be a text, but is {in_short(value)}")
    return value


def a_path(name: str, value: Any) -> Path:
    """Refuse a `value` that is not the path of a file."""
    if not isinstance(value, str | os.PathLike) or not os.fspath(value):
        raise ValueError(f"{name} must be a path, such as 'file', but is {in_short(value)}")
    return Path(value)


def a_dictionary(name: str, value: Any) -> dict[str, Any]:
    """Refuse a `value` that is not a dictionary from names to values; None stands for an empty one."""
    if value is None:
        return {}
    if not isinstance(value, Mapping) or not all(isinstance(key, str) for key in value):
        raise ValueError(f"{name} must be a dictionary from names to values, but is {in_short(value)}")
    return dict(value)


def several(name: str, values: Any, kind: type[Kind], allowed: str) -> list[Kind]:
    """Refuse what is not several values of one kind, as a list, a tuple or another collection that is no text.

    Args:
        name: the parameter's name.
        values: what was given.
        kind: the class of each value.
        allowed: what they must be, in words.
    """
    given = [*values] if isinstance(values, Iterable) and not isinstance(values, str | type) else None
    if given is None or not all(isinstance(one, kind) for one in given):
        raise ValueError(f"{name} must be {allowed}, but is {in_short(values)}")
    return given


def an_array(
    name: str, values: Any, shape: Sequence[int | str] | None = None
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Refuse `values` that are not an array of real numbers, or a list that stands for one; NaN and infinity are fine.

    Args:
        name: the parameter's name.
        values: what was given.
        shape: the length of each axis; where any will do, what it is called, such as "n_states". None for any shape
            of one axis or more.
    """
    try:
        array = np.asarray(values)
        array = np.array(values, float) if array.dtype.kind == "O" else array  # of huge numbers, or with None for NaN
        wanted = array.shape if shape is None else tuple(shape)
        fits = 0 < array.ndim == len(wanted) and all(
            isinstance(n, str) or n == m for n, m in zip(wanted, array.shape, strict=True)
        )
    except (ValueError, TypeError, OverflowError):  # of lists of different lengths, of objects, of huge numbers
        fits = False
    if not fits or array.dtype.kind not in "biuf":
        axes = "" if shape is None else f" of shape ({', '.join(map(str, shape))}{',' if len(shape) == 1 else ''})"
        given = f", of shape {values.shape}" if isinstance(values, np.ndarray) else ""
        raise ValueError(f"{name} must be an array of numbers{axes}, but is {in_short(values)}{given}")
    return np.asarray(array, np.float64)


def coerced(value: Any) -> Any:
    """Copy a NamedTuple, and turn the numbers in its `float` fields into Python floats.

    NumPy integers in `int` fields become Python ints. NamedTuples in its fields are treated in the same way. A value
    that is no NamedTuple is returned as it is.

    The copy holds the same arrays as the original. The numbers are converted for two reasons. Numba would otherwise
    compile the same agent twice, for `learning_rate=1` (an int) and for `learning_rate=0.1` (a float). And small NumPy
    integers, such as an int8, would overflow.
    """
    if not (isinstance(value, tuple) and hasattr(value, "_fields")):
        return value
    kinds: dict[str, Any] = {}
    for base in reversed(type(value).__mro__):
        kinds |= inspect.get_annotations(base)
    fields = {}
    for name, field in zip(value._fields, value, strict=True):
        kind = getattr(kinds.get(name), "__forward_arg__", kinds.get(name))  # an annotation written as a string
        kind = getattr(kind, "__origin__", kind)  # Annotated[float, ...] becomes float
        if kind in (float, "float") and isinstance(field, int | np.number):
            fields[name] = as_float(field)
        elif kind in (int, "int") and isinstance(field, np.integer):
            fields[name] = int(field)
        else:
            fields[name] = coerced(field)
    return type(value)(**fields)


def as_float(value: Any) -> Any:
    """A number as a `float`; a whole number beyond all floats as it is, for a check to refuse it."""
    return value if isinstance(value, int) and abs(value) > sys.float_info.max else float(value)


def in_short(value: Any) -> str:
    """A value for a message: on one line, cut where it is long; for a very large whole number, its number of digits."""
    if isinstance(value, int) and abs(value) >= 10**LONGEST_NUMBER:
        return f"a whole number of about {math.floor(math.log10(abs(value))) + 1} digits"
    text = " ".join(repr(value).split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def _number(name: str, value: Any, allowed: str) -> Any:
    """The value, if it is a real number that can be computed with."""
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | float | np.integer | np.floating):
        raise ValueError(f"{name} must be a number, {allowed}, but is {in_short(value)}")
    if isinstance(value, int) and abs(value) > sys.float_info.max:  # it could not be computed with
        raise ValueError(f"{name} must be {allowed}, but is {in_short(value)}")
    return value.item() if isinstance(value, np.generic) else value  # small types of NumPy's overflow

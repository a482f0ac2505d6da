"""Parameters are refused with a message that names them, their value and what is allowed."""

import math
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym.checks import parameters as check
from edugym.checks.parameters import at_least, coerced, in_short, number_of_steps, one_of, whole_number

NO_NUMBERS = ["2", None, True, np.True_, [2], 2j]
LARGEST = int(sys.float_info.max)
CASES: list[tuple[Callable[..., object], tuple[Any, ...], list[Any], list[Any], str]] = [
    (check.a_number, (), [0, -1e300, np.float32(-2), LARGEST], [math.inf, -math.inf, np.float32(math.inf)], "finite"),
    (at_least, (1,), [1, 1.0, math.inf, np.int8(5), LARGEST], [0.999, -math.inf, LARGEST + 1, 2**20_000], "1 or more"),
    (check.between, (0, 1), [0, 1, 0.5, np.float64(1)], [-1e-9, 1.001, math.inf], "from 0 to 1"),
    (check.above, (0,), [1e-300, math.inf], [0, 0.0, -1, 2**20_000], "greater than 0"),
    (check.above, (0, 2), [1e-300, 2], [0, -1, 2.1, math.inf], "greater than 0 and at most 2"),
    (number_of_steps, (), [1, 2**62, np.int8(5)], [0, -1, 1.0], "1 or more"),
    (number_of_steps, (), [], [2**62 + 1, 10**400], "at most 4611686018427387904"),
    (whole_number, (2,), [2, 10**30, np.int64(2)], [1, -5, 2.0, np.float64(3)], "2 or more"),
    (whole_number, (2, 4), [2, 3, 4], [1, 5, 3.0], "from 2 to 4"),
]


@pytest.mark.parametrize(("require", "bounds", "good", "bad", "allowed"), CASES)
def test_checks(require: Callable[..., object], bounds: Any, good: list[Any], bad: list[Any], allowed: str) -> None:
    """What is allowed passes silently, ends included as the message says; everything else is a ValueError."""
    for value in good:
        require("speed", value, *bounds)
    for value in [*bad, math.nan, *(NO_NUMBERS if good else ())]:
        with pytest.raises(ValueError, match=r"^speed must be ") as caught:
            require("speed", value, *bounds)
        assert str(caught.value).endswith(f", but is {in_short(value)}")
        assert allowed in str(caught.value) or value is math.nan
    if good:
        with pytest.raises(ValueError, match=rf"number, {allowed}, but is 'x'$"):
            require("speed", "x", *bounds)


def test_one_of() -> None:
    """The allowed are named."""
    for value in ("a", None):
        one_of("kind", value, ["a", None])
    for wrong in ("b", 0, "", False, math.nan):
        with pytest.raises(ValueError, match=rf"^kind must be one of 'a', None, but is {wrong!r}$"):
            one_of("kind", wrong, ["a", None])


def test_whole_numbers_come_back_as_pythons() -> None:
    """A small type of NumPy's would overflow in what is computed from it."""
    for value in (whole_number("x", np.int8(100), 1), number_of_steps("x", np.int8(100))):
        assert (type(value), value) == (int, 100)


class Inner(NamedTuple):
    """Declares its fields' types."""

    rate: float
    steps: int


class Derived(Inner):
    """Has the fields of another class."""

    __slots__ = ()


class Outer(NamedTuple):
    """Holds others."""

    inner: Inner
    other: Any
    size: "int"
    share: "float" = 1


@pytest.mark.parametrize("kind", [Inner, Derived])
def test_fields_have_the_declared_types(kind: Any) -> None:
    """A whole number for a real field becomes a float, NumPy's numbers become Python's, at every level."""
    size: Any = np.int32(4)
    value = coerced(Outer(kind(1, np.int64(2)), kind(np.float32(0.5), 3), size))
    assert type(value) is Outer
    assert repr([*value.inner, *value.other, value.size, value.share]) == "[1.0, 2, 0.5, 3, 4, 1.0]"
    assert [type(value.inner), type(value.other)] == [kind, kind]


def test_what_is_not_coerced() -> None:
    """Other values, tables above all, are passed on as they are."""
    table = np.zeros(3, np.float32)
    assert coerced(Outer(Inner(0.5, 1), table, 1)).other is table
    for value in (table, 3, "text", None, (1, 2)):
        assert coerced(value) is value
    odd: Any
    for odd in (2.75, np.float64(2.75), "2", None, table):  # for a field of whole numbers: nothing is cut off
        assert coerced(Inner(0.5, odd)).steps is odd
    for odd in ("0.5", None, table):
        assert coerced(Inner(odd, 1)).rate is odd


def test_values_in_short() -> None:
    """On one line of 200 characters at most, and long numbers by the number of their digits."""
    assert in_short(2**128) == str(2**128)
    assert in_short(10**40) == "a whole number of about 41 digits"
    assert in_short(-(10**400)) == "a whole number of about 401 digits"
    assert in_short("a" * 198) == repr("a" * 198)
    assert in_short("a" * 199) == "'" + "a" * 196 + "..."
    assert in_short(np.eye(2)) == "array([[1., 0.], [0., 1.]])"

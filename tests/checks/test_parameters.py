"""Parameters are refused with a message that names them, their value and what is allowed."""

import math
import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym.adapters.registration import make_mdp
from edugym.checks.interfaces import step_limit
from edugym.checks.parameters import (
    a_number,
    above,
    at_least,
    between,
    coerced,
    in_short,
    number_of_steps,
    one_of,
    whole_number,
)

NO_NUMBERS = ["2", None, True, np.True_, [2], 2j, math.nan]

CASES: list[tuple[Callable[..., object], tuple[Any, ...], list[Any], list[Any], str]] = [
    (
        a_number,
        (),
        [0, -1e300, np.float32(-2), np.float16(0), int(sys.float_info.max)],
        [math.inf, -math.inf, np.float32(math.inf), *NO_NUMBERS],
        "finite",
    ),
    (
        at_least,
        (1,),
        [1, 1.0, 7, math.inf, np.float32(1), np.int8(5)],
        [0.999, -1, -math.inf, *NO_NUMBERS],
        "1 or more",
    ),
    (between, (0, 1), [0, 1, 0.5, np.float64(1)], [-1e-9, 1.001, math.inf, *NO_NUMBERS], "from 0 to 1"),
    (above, (0,), [1e-300, 5, math.inf], [0, 0.0, -1, *NO_NUMBERS], "greater than 0"),
    (above, (0, 2), [1e-300, 2], [0, -1, 2.1, math.inf, *NO_NUMBERS], "greater than 0 and at most 2"),
    (number_of_steps, (), [1, 2**62, np.int8(5)], [0, -1, 1.0, *NO_NUMBERS], "1 or more"),
    (number_of_steps, (), [], [2**62 + 1, 10**400], "at most 4611686018427387904"),
    (
        whole_number,
        (2,),
        [2, 10**30, np.int64(2), np.uint8(9)],
        [1, -5, 2.0, 2.5, np.float64(3), *NO_NUMBERS],
        "2 or more",
    ),
    (whole_number, (2, 4), [2, 3, 4], [1, 5, 3.0, *NO_NUMBERS], "from 2 to 4"),
    (one_of, (["a", None],), ["a", None], ["b", 0, "", False, math.nan], "one of 'a', None"),
]


@pytest.mark.parametrize(
    ("check", "bounds", "good", "bad", "says"), CASES, ids=lambda part: getattr(part, "__name__", "")
)
def test_checks(check: Callable[..., object], bounds: Any, good: list[Any], bad: list[Any], says: str) -> None:
    """What is allowed passes silently, ends included as the message says; everything else is a ValueError."""
    for value in good:
        check("speed", value, *bounds)
    for value in bad:
        with pytest.raises(ValueError, match=r"^speed must be ") as caught:
            check("speed", value, *bounds)
        assert says in str(caught.value)
        assert str(caught.value).endswith(f", but is {in_short(value)}")


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
    numbers = [*value.inner, *value.other, value.size, value.share]
    assert numbers == [1.0, 2, 0.5, 3, 4, 1.0]
    assert [type(number) for number in numbers] == [float, int, float, int, int, float]
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


def test_step_limits() -> None:
    """The limit is the task's `max_steps`; without one there is none."""
    assert step_limit(make_mdp("Boulder", max_steps=np.int64(7))) == 7
    assert step_limit(make_mdp("Golf")) is None


def test_the_largest_whole_number_that_is_a_real_one() -> None:
    """It can be computed with; the next one cannot."""
    largest = int(sys.float_info.max)
    at_least("x", largest, 0)
    with pytest.raises(ValueError, match="x must be 0 or more"):
        at_least("x", largest + 1, 0)


@pytest.mark.parametrize(
    ("check", "allowed"),
    [
        (lambda value: a_number("x", value), "a number, finite"),
        (lambda value: at_least("x", value, 2), "a number, 2 or more"),
        (lambda value: between("x", value, 2, 3), "a number, from 2 to 3"),
        (lambda value: above("x", value, 2), "a number, greater than 2"),
        (lambda value: above("x", value, 2, 3), "a number, greater than 2 and at most 3"),
        (lambda value: whole_number("x", value, 2), "a whole number, 2 or more"),
        (lambda value: whole_number("x", value, 2, 3), "a whole number, from 2 to 3"),
        (lambda value: number_of_steps("x", value), "a whole number, 1 or more"),
    ],
)
def test_what_is_no_number_is_told_what_is_allowed(check: Callable[[Any], object], allowed: str) -> None:
    """In the same sentence."""
    for value in ("3", True, None):
        with pytest.raises(ValueError, match=rf"^x must be {allowed}, but is {value!r}$"):
            check(value)


def test_whole_numbers_come_back_as_pythons() -> None:
    """A small type of NumPy's would overflow in what is computed from it."""
    for value in (whole_number("x", np.int8(100), 1), number_of_steps("x", np.int8(100))):
        assert (type(value), value) == (int, 100)


def test_very_long_numbers_are_told_by_their_size() -> None:
    """Nobody reads hundreds of digits, and Python refuses to write out some thousand."""
    assert in_short(2**128) == str(2**128)
    assert in_short(10**40) == "a whole number of about 41 digits"
    assert in_short(-(10**400)) == "a whole number of about 401 digits"
    for check in (at_least, above):
        with pytest.raises(ValueError, match=r"^x must be .*, but is a whole number of about 6021 digits$"):
            check("x", 2**20_000, 0)


def test_what_is_long_is_cut() -> None:
    """One line of 200 characters at most."""
    assert in_short("a" * 198) == repr("a" * 198)
    assert in_short("a" * 199) == "'" + "a" * 196 + "..."
    assert in_short(np.eye(2)) == "array([[1., 0.], [0., 1.]])"
    with pytest.raises(ValueError, match=r"^x must be a whole number, 1 or more, but is array\(\[ 0, .*\.\.\.$"):
        whole_number("x", np.arange(999), 1)

"""Numbers of every kind, and the mistakes that they come from."""

import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from edugym_course.grading import Unsolved, WrongAnswer
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.values import compare, digits, number, unlike


@pytest.mark.parametrize(
    "value", [2, 2.0, np.int8(2), np.float16(2), np.array(2.0), np.array(2), Fraction(4, 2), Decimal("2"), np.uint64(2)]
)
def test_numbers_of_every_kind(value: Any) -> None:
    """They are taken as floats."""
    found = number("x", value)
    assert type(found) is float
    assert found == 2.0


@pytest.mark.parametrize(
    ("value", "says"),
    [
        (True, "truth value"),
        (np.True_, "truth value"),
        ("2", "leave the quotes out"),
        ((2,), "tuple: take an entry"),
        ([2], "list: take an entry"),
        (np.array([2.0]), r"ndarray of shape \(1,\): take an entry"),
        (lambda: 2, "call it"),
        (2j, r"^x should be a real number, but is 2j: is it the root of a negative number\?$"),
        (math.nan, "finite"),
        (-math.inf, "finite"),
        (10**400, "finite"),
        (object(), "^x should be a number, but is of the type object$"),
    ],
)
def test_what_is_no_number(value: Any, says: str) -> None:
    """Each has its sentence."""
    with pytest.raises(WrongAnswer, match=says):
        number("x", value)


def test_lists_with_arrays_in_them() -> None:
    """They are other lists than those of numbers, and comparing them raises nothing."""
    assert unlike([1, np.zeros(2)], [1, np.ones(2)])
    assert unlike([1, 2], [1, 3])
    assert not unlike([(1, 2)], [(1, 2)])


def test_what_was_not_given() -> None:
    """A placeholder is not solved yet; None from a function means that it returned nothing."""
    for value in (..., None):
        with pytest.raises(Unsolved, match="Not solved yet: x"):
            number("x", value)
    with pytest.raises(WrongAnswer, match=r"^f\(3\) gives None: is a `return` missing\? Or is none reached\?$"):
        number("f(3)", None)


def test_a_mistake_is_recognised() -> None:
    """The nearest one, also rounded; the right number is told unless the author says something else."""
    mistakes = {"the sign is wrong": -0.5, "it is doubled": 1.0, "nearly doubled": 1.001}
    assert compare("x", np.float32(0.5), 0.5, mistakes) == 0.5
    for value, says in ((-0.5, "the sign is wrong"), (1.0002, "it is doubled"), (1.0011, "nearly doubled")):
        with pytest.raises(WrongAnswer, match=rf"^x should be 0.5, but is {value:.4g}: {says}$"):
            compare("x", value, 0.5, mistakes)
    with pytest.raises(WrongAnswer, match=r"^x should be 0.5, but is 0.7: that is none of the usual mistakes"):
        compare("x", 0.7, 0.5, mistakes)
    with pytest.raises(WrongAnswer, match=r"^half of it: the sign is wrong$"):
        compare("x", -0.5, 0.5, mistakes, says=lambda found: "half of it")
    assert compare("x", 0.51, 0.5, {}, tolerance=0.02) == 0.51
    with pytest.raises(WrongAnswer, match=r"should be 0\.5, but is 0\.50000001"):
        compare("x", 0.50000001, 0.5, {})


@pytest.mark.parametrize(
    ("value", "doubled"), [(1.0019, True), (1.0021, False), (0.9981, True), (0.9979, False), (1.00001, True)]
)
def test_how_far_a_mistake_may_be_rounded(value: float, doubled: bool) -> None:
    """By two thousandths of it; what is nearer to the right number is no mistake at all."""
    with pytest.raises(WrongAnswer, match="it is doubled$" if doubled else "none of the usual mistakes"):
        compare("x", value, 0.5, {"it is doubled": 1.0})
    with pytest.raises(WrongAnswer, match=r"^(?!.*it is nearly right)"):
        compare("x", value, value - 1e-6, {"it is nearly right": value + 1e-5})
    with pytest.raises(WrongAnswer, match="none of the usual mistakes"):
        compare("x", 1.03125, 1.03125 - 2**-10, {"it is as far away": 1.03125 + 2**-10})


@pytest.mark.parametrize(
    ("found", "right", "rounded"),
    [(5.1, 5.125, True), (5, 5.125, True), (40, 40.9, True), (41, 40.9, True), (5.2, 5.125, False), (0, 0.3, False)],
)
def test_the_right_number_rounded(found: float, right: float, rounded: bool) -> None:
    """It is asked for where it is near; a mistake that fits is told first, and a tolerance leaves it out."""
    why = "is it rounded?" if rounded else "none of the usual mistakes"
    with pytest.raises(WrongAnswer, match=re.escape(why)):
        compare("x", found, right, {})
    with pytest.raises(WrongAnswer, match=r"it is another$"):
        compare("x", found, right, {"it is another": found})
    with pytest.raises(WrongAnswer, match="none of the usual mistakes"):
        compare("x", found, right, {}, tolerance=1e-6)


def test_as_many_digits_as_tell_two_numbers_apart() -> None:
    """Four, or more."""
    assert digits(1 / 3, 0.5) == "0.3333"
    assert digits(0.1234567, 0.1234566) == "0.1234567"
    assert digits(2.0, 3.0) == "2"
    assert digits(78_125.0, 9_765_625.0) == "78125"
    assert digits(-0.0, 1.0) == "0"
    assert (digits(999_999_999_999_999.0, 1.0), digits(1e300, 1.0)) == ("999999999999999", "1e+300")
    assert digits(-0.8999999999999999, -0.9) == "-0.9"


def two_numbers(rng: np.random.Generator) -> list[float]:
    """Two numbers of which each is 0 or 1."""
    return [float(number) for number in rng.integers(2, size=2)]


@pytest.mark.parametrize("seed", range(20))
def test_cases_tell_rules_apart(seed: int) -> None:
    """Twice a number is the number itself where both are 0: such a draw is left out."""
    rules = [lambda x: x, lambda x: 2 * x, lambda x: [x * x + 1]]
    assert any(two_numbers(telling_draw(seed, two_numbers, rules)))


def test_how_cases_are_drawn() -> None:
    """Rules that are the same but for rounding are refused; a seed gives the same cases, and another one others."""
    with pytest.raises(ValueError, match="two of them never differed"):
        telling_draw(0, two_numbers, [lambda x: x, lambda x: 1 * x])
    with pytest.raises(ValueError, match="two of them never differed"):
        telling_draw(0, two_numbers, [lambda x: x, lambda x: x + 1e-12])
    telling_draw(0, two_numbers, [lambda x: x, lambda x: x + 1e-4])
    drawn = {seed: telling_draw(seed, two_numbers, [abs]).random(3).tolist() for seed in (0, 1)}
    assert drawn[0] == telling_draw(0, two_numbers, [abs]).random(3).tolist()
    assert drawn[0] != drawn[1]

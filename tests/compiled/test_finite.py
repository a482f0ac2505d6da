"""Machine code asks of an action of real numbers, and of the index of a row, what the interpreter asks."""

from typing import Any

import numpy as np
import pytest
from numba import njit

from edugym.compiled import finite
from edugym.mdp.membership import is_finite_of_shape, wholeness

assert {is_finite_of_shape, wholeness} == finite.IMPLEMENTED


def asked_for_shape(value: Any, shape: Any) -> bool:
    """Ask whether a value is finite and of a shape."""
    return is_finite_of_shape(value, shape)


def asked_for_wholeness(value: Any) -> int:
    """Ask how whole a value is."""
    return wholeness(value)


in_machine_code, wholeness_in_machine_code = njit(asked_for_shape), njit(asked_for_wholeness)


@pytest.mark.parametrize("number", [0.5, np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("shape", [(1,), (2,)], ids=str)
def test_numbers_and_tuples(shape: tuple[int, ...], number: float) -> None:
    """At any place in a tuple, among real and whole numbers."""
    for value in (number, (number,), (0.0, number), (number, 0), (number, 0.0, 1)):
        assert in_machine_code(value, shape) == is_finite_of_shape(value, shape), value


@pytest.mark.parametrize("number", [0.5, np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("asked", [(1,), (2,), (1, 1), (1, 2)], ids=str)
def test_arrays(asked: tuple[int, ...], number: float) -> None:
    """At any place in an array; `asked` has as many axes as the array, since others do not come so far."""
    for size in (1, 2, 3):
        for place in range(size):
            value = np.zeros((1, size) if len(asked) == 2 else size)
            value.flat[place] = number
            assert in_machine_code(value, asked) == is_finite_of_shape(value, asked), value


def test_wholeness() -> None:
    """By the type: 2.0 is not whole, nor is True."""
    for value, expected in (
        (2, 2),
        (np.int64(2), 2),
        (np.uint8(2), 2),
        (True, 1),
        (np.True_, 1),
        (2.0, 0),
        (np.zeros(2), 0),
    ):
        assert wholeness_in_machine_code(value) == wholeness(value) == expected, value

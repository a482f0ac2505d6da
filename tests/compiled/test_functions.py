"""Every function of `math` that machine code may call, at the ends of where it is defined."""

import inspect
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from edugym.compiled.compiler import compiled
from edugym.compiled.subset import MATH
from tests.compiled.cells import cell

SOURCE = "class Functions(NamedTuple):\n    x: float\n    def value(self, which):\n"
CALLED = sorted(name for name in MATH if inspect.isbuiltin(getattr(math, name)))
TWO = ("atan2", "copysign", "hypot")
ENDS = [0.0, 5e-324, 0.5, 1.0, 2.0, 709.0, 709.8, 710.5, 711.0, 9.3e17, 9.3e18, 2.0**63, 1.7976931348623157e308]
POINTS = [*ENDS, *(-x for x in ENDS), *np.nextafter([1.0, 1.0, -1.0, -1.0, -(2.0**63)], [0, 2, 0, -2, -1e30]).tolist()]


def value(kind: Any, which: int, out: Any) -> None:
    """Write the value of one of them."""
    out[0] = kind.value(which)


def found(loop: Callable[..., None], kind: Any, which: int) -> float | None:
    """The value, or None where there is an error."""
    out = np.zeros(1)
    try:
        loop(kind, which, out)
    except (ValueError, OverflowError):
        return None
    return float(out[0])


@pytest.fixture(scope="module")
def functions() -> tuple[Any, Callable[..., None]]:
    """A class that calls all of them, and its machine code."""
    calls = (f"math.{name}(self.x{', 2.0' if name in TWO else ''}) * 1.0" for name in CALLED)
    lines = [f"        if which == {i}: return {call}\n" for i, call in enumerate(calls)]
    kind = cell(SOURCE + "".join(lines) + "        return 0.0\n")["Functions"]
    return kind, compiled(value, kind(0.5), 0, np.zeros(1))


@pytest.mark.parametrize("name", CALLED)
def test_every_function_of_math(name: str, functions: tuple[Any, Callable[..., None]]) -> None:
    """An error where Python has one, and else its value; the last digit of some functions is not Python's."""
    kind, fast = functions
    which = CALLED.index(name)
    for x in [*POINTS, math.inf, -math.inf, math.nan]:
        expected, got = found(value, kind(x), which), found(fast, kind(x), which)
        if name in ("floor", "ceil", "trunc") and not -(2**63) <= x < 2**63:
            assert got is None  # Python has whole numbers of any size
        else:
            assert (got is None) == (expected is None), x
            assert expected is None or got == pytest.approx(expected, rel=1e-15, abs=0.0, nan_ok=True), x

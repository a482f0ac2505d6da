"""What docs/machine-code.md says about last digits; every function of `math`, at the ends of where it is defined."""

import inspect
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from edugym.compiled import arithmetic
from edugym.compiled.compiler import compiled
from edugym.compiled.execution import executable
from edugym.compiled.snapshot import difference
from edugym.compiled.subset import MATH
from tests.compiled.cells import cell

SAME = (
    "math.exp(x)", "math.log(x * x + 0.1)", "math.sin(x)", "math.tanh(x)", "math.sqrt(x * x)",
    "x**2", "x**-1", "2.0**x", "(x * x) ** 0.5", "x**3", "(x * x) ** 0.3", "0.99**i",
    "x % 0.7", "x // 0.7", "1.0 / (x + 20.0)", "self.total(i)",
    "rng.normal(0.0, 1.0)", "rng.random()", "rng.exponential(2.0)",
)  # fmt: skip
CLOSE = ("np.exp(x)", "np.log(x * x + 0.1)", "np.tanh(x)", "math.hypot(x, 2.0)", "np.sum(self.x[:i])", "np.std(self.x)")
TABLE = """
class Table(NamedTuple):
    x: np.ndarray
    same: np.ndarray
    close: np.ndarray
    def total(self, n):
        s = 0.0
        for k in range(n):
            s += self.x[k]
        return s
    def fill(self, i, rng):
        x = self.x[i]
"""


def fill(n: int, table: Any, rng: np.random.Generator) -> None:
    """Fill n rows."""
    for i in range(n):
        table.fill(i, rng)


def is_hard(x: float) -> bool:
    """Whether a power differs in its last digit from the product, fraction or root that a compiler might make of it."""
    return x**2 != x * x or x**-1 != 1 / x or (x * x) ** 0.5 != math.sqrt(x * x) or 2.0**x != math.exp2(x)


def test_which_digits_may_differ() -> None:
    """Those of some functions of NumPy, by very little; no others."""
    kinds = {"same": SAME, "close": CLOSE}
    lines = [f"        self.{name}[i, {k}] = {what}\n" for name in kinds for k, what in enumerate(kinds[name])]
    kind = cell(TABLE + "".join(lines))["Table"]
    x = 3 * np.random.default_rng(1).normal(size=9_000)
    x = x[[i < 1_900 or is_hard(v) for i, v in enumerate(x.tolist())]]
    n = len(x)
    tables = [kind(x, np.zeros((n, len(SAME))), np.zeros((n, len(CLOSE)))) for _ in range(2)]
    run = executable(fill, (tables[0], np.random.default_rng(0)))
    assert run is not fill
    run(n, tables[0], np.random.default_rng(0))
    fill(n, tables[1], np.random.default_rng(0))
    for k, what in enumerate(SAME):
        assert (tables[0].same[:, k] == tables[1].same[:, k]).all(), what
    for k, what in enumerate(CLOSE):
        assert difference(tables[0].close[:, k], tables[1].close[:, k], what) is None


FUNCTIONS = "class Functions(NamedTuple):\n    x: float\n    def value(self, which):\n"
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
    kind = cell(FUNCTIONS + "".join(lines) + "        return 0.0\n")["Functions"]
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


@pytest.mark.parametrize("values", [[], [0.0], [2.0, 0.0], [0.0, 3.0, -1.5], [2.0, -1.5, 7.0], [1.0, math.nan]])
def test_what_stands_for_a_function_of_many(values: list[float]) -> None:
    """Interpreted it comes to the same."""
    functions: list[Callable[..., Any]] = [any, all, *([np.median] if values else [])]
    for function in functions:
        assert repr(float(arithmetic.REPLACED[function](values))) == repr(float(function(values)))

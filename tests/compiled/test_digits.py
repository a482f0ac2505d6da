"""What docs/machine-code.md says about last digits."""

import math
from typing import Any

import numpy as np

from edugym.compiled.execution import executable
from edugym.compiled.snapshot import difference
from tests.compiled.cells import cell

SAME = (
    "math.exp(x)",
    "math.log(x * x + 0.1)",
    "math.sin(x)",
    "math.tanh(x)",
    "math.sqrt(x * x)",
    "x**2",
    "x**-1",
    "2.0**x",
    "(x * x) ** 0.5",
    "x**3",
    "(x * x) ** 0.3",
    "0.99**i",
    "x % 0.7",
    "x // 0.7",
    "1.0 / (x + 20.0)",
    "self.total(i)",
    "rng.normal(0.0, 1.0)",
    "rng.random()",
    "rng.exponential(2.0)",
)
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
    lines = [
        f"        self.{name}[i, {k}] = {what}\n"
        for name, kinds in (("same", SAME), ("close", CLOSE))
        for k, what in enumerate(kinds)
    ]
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

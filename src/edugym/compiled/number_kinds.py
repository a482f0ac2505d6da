"""What Numba's types and functions do with mixed numbers: whole in one branch, real in another.

`edugym.compiled.mixed_numbers` explains them and follows them through a program.
"""

import math
import operator
from collections.abc import Iterator
from typing import Any

import numpy as np
from numba.core import types

from edugym.compiled.subset import MATH, words

COMPARED = (operator.lt, operator.le, operator.gt, operator.ge, operator.eq, operator.ne, operator.contains)
SAME_OF_WHOLE: set[Any] = {
    *(getattr(math, name) for name in MATH if callable(getattr(math, name))),
    *(getattr(np, name) for name in words("arctan2 cos exp expm1 hypot isfinite isinf isnan log log10 log1p log2 sin")),
    *(getattr(np, name) for name in words("sqrt tan tanh sinh cosh arcsin arccos arctan float64")),
    float, int, bool, round, len, range,
}  # fmt: skip
"""Functions that give the same result for a whole number and for the real number that equals it."""
PASSED_ON: set[Any] = {max, min, abs, sorted, list, enumerate, zip, reversed, iter, tuple}
"""Functions that may return one of their arguments, or a collection of them."""
PASSED_ON_NAMES = words("np.max np.min max min np.clip abs sum int round floor ceil trunc")
"""The names of such functions among the replacements in `edugym.compiled.arithmetic`."""


def method_name(key: Any) -> str:
    """The name of a method, from the key under which Numba has it."""
    return str(key[1] if isinstance(key, tuple) else key).rpartition(".")[2]


def is_in(key: Any, table: set[Any]) -> bool:
    """Whether a set has an element; an element that cannot be hashed is in none."""
    try:
        return key in table
    except TypeError:  # it has no hash
        return False


def passes_on(called: Any, key: Any) -> bool:
    """Whether a function may return one of its arguments, which may be a mixed number."""
    if isinstance(called, types.NamedTupleClass) or is_in(key, PASSED_ON):
        return True
    choice = isinstance(called, types.BoundFunction) and isinstance(called.this, types.NumPyRandomGeneratorType)
    return getattr(key, "__name__", "") in PASSED_ON_NAMES or choice


def as_number(kind: Any) -> Any:
    """The type of the numbers with which machine code computes for flags, for an IntEnum, and for what may be None."""
    kind = types.unliteral(kind)
    kind = types.unliteral(kind.type) if isinstance(kind, types.Optional) else kind
    return types.int64 if isinstance(kind, types.Boolean | types.IntEnumMember) else kind


def holds_real(kind: Any) -> bool:
    """Whether a type is a real number or contains one. Arrays do not count: their numbers are real in Python too."""
    kind = types.unliteral(kind)
    if isinstance(kind, types.Array):
        return False
    if isinstance(kind, types.BaseTuple):
        return any(map(holds_real, kind))
    if isinstance(kind, types.Optional):
        return holds_real(kind.type)
    if isinstance(kind, types.BoundFunction):
        return holds_real(kind.this)
    if isinstance(kind, types.Pair):
        return holds_real(kind.first_type)
    if isinstance(kind, types.IteratorType):
        return holds_real(kind.yield_type)
    return isinstance(kind, types.Float) or (isinstance(kind, types.List) and holds_real(kind.dtype))


def is_real(kind: Any) -> bool:
    """Whether a type is a real number or an array of such."""
    return isinstance(kind, types.Float) or (isinstance(kind, types.Array) and isinstance(kind.dtype, types.Float))


def holds_list(kind: Any) -> bool:
    """Whether a type is a list, or a tuple that contains one."""
    return isinstance(kind, types.List) or (isinstance(kind, types.BaseTuple) and any(map(holds_list, kind)))


def is_whole_array(kind: Any) -> bool:
    """Whether a type is an array of whole numbers."""
    return isinstance(kind, types.Array) and isinstance(kind.dtype, types.Integer)


def pairs_of_types(one: Any, other: Any) -> Iterator[tuple[Any, Any]]:
    """The types of the numbers at the same places in two tuples."""
    for part, other_part in zip(one, other, strict=False):
        if isinstance(part, types.BaseTuple) and isinstance(other_part, types.BaseTuple):
            yield from pairs_of_types(part, other_part)
        else:
            yield part, other_part

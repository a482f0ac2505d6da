"""Functions of Python, `math` and `np` for students' machine code: they give what Python gives, or raise an error.

`REPLACED`, `CALLED` and `EXTREMES` are ordinary functions that replace `math.exp` and the like by name
(`edugym.compiled.untyped_checks`). Operators are replaced by those in `edugym.compiled.operations`.
"""

import builtins
import math
import operator
from collections.abc import Callable
from typing import Any

import numpy as np
from numba import extending
from numba.core import types

from edugym.compiled.number_kinds import as_number
from edugym.compiled.operations import ADD, CHECKED, INT, MIXED, REAL, SUBTRACT

Function = Callable[..., Any]
TINY, BELOW_ONE, LARGEST = 5e-324, math.nextafter(1.0, 0.0), 1.7976931348623157e308
_add, _subtract = ADD.function, SUBTRACT.function
arange: Any = np.arange  # its declaration knows fewer calls than it takes


def _in_domain(function: Function, lowest: float, highest: float) -> Function:
    """A function of `math` that is defined from `lowest` to `highest`."""

    def checked(x: Any) -> Any:
        if x < lowest or x > highest:
            raise ValueError("math domain error")
        return function(x)

    return checked


def _finite(function: Function) -> Function:
    """A function of `math` whose value may be too large."""

    def checked(x: Any) -> Any:
        y = function(x)
        if math.isinf(y) and not math.isinf(x):
            raise OverflowError("math range error")
        return y

    return checked


def _copysign(x: Any, y: Any) -> Any:
    """`math.copysign`, which alone shows the sign of NaN: processors and compilers do not agree on it."""
    if y != y:
        raise ValueError("NaN has no sign")
    return math.copysign(x, y)


def _to_whole(function: Function) -> Function:
    """A function that makes whole numbers of real ones, and leaves whole ones as they are, however large."""

    def checked(x: Any) -> Any:
        if not -9223372036854775808.0 <= x < 9223372036854775808.0:
            raise OverflowError("too large for a whole number")
        return function(x)

    def to_whole(x: Any) -> Any:
        raise NotImplementedError

    to_whole.__name__ = function.__name__  # by which messages call it
    extending.overload(to_whole, strict=False)(lambda x: (lambda x: int(x)) if as_number(x) == INT else checked)
    return lambda x: to_whole(x)


def _float(x: Any) -> Any:
    return float(x * 1.0)  # Numba has no float(True)


def _any(values: Any) -> Any:
    found = False
    for value in values:
        found = found or bool(value)
    return found


def _all(values: Any) -> Any:
    found = True
    for value in values:
        found = found and bool(value)
    return found


def _median(values: Any) -> Any:
    """`np.median`. It is NaN if one of the values is, but Numba's notices NaN in some places only."""
    for value in np.asarray(values).flat:
        if np.isnan(value):
            return np.nan
    return np.median(_made_real(values))


def _made_real(values: Any) -> Any:
    """Whole numbers as real ones, as NumPy adds the two in the middle: Numba adds them first, beyond 64 bits too."""
    return values


def _choose_made_real(values: Any) -> Function:
    whole = getattr(values, "dtype", None) == INT
    return (lambda values: np.asarray(values) * 1.0) if whole else (lambda values: values)


def _extreme(name: str, better: Function, of_others: Function) -> Function:
    """`np.max`, `np.min`, or the method of an array: Numba's own counts references, and so makes every step slower.

    They raise an error where there is 0.0 and -0.0: which of them NumPy finds depends on the processor.
    """

    def of_line(a: Any) -> Any:
        if a.size == 0:
            raise ValueError("zero-size array")
        found = a[0]
        for k in range(a.size):  # quicker than the values themselves
            if a[k] != a[k]:  # NaN
                return a[k]
            if better(a[k], found):
                found = a[k]
        if found == 0.0:
            for k in range(a.size):
                if a[k] == 0.0 and math.copysign(1.0, a[k]) != math.copysign(1.0, found):
                    raise ValueError("which of 0.0 and -0.0 is largest or smallest depends on the processor: add 0.0")
        return found

    def of_table(a: Any) -> Any:
        return of_line(a.ravel())

    extending.register_jitable(of_line)

    def either(a: Any) -> Any:
        raise NotImplementedError

    def choose(a: Any) -> Function:
        if not (isinstance(a, types.Array) and isinstance(a.dtype, types.Number)):
            return of_others
        return of_line if a.ndim == 1 else of_table

    either.__name__ = name  # by which messages call it
    extending.overload(either, strict=False)(choose)
    return lambda a: either(a)


def _clip(a: Any, a_min: Any, a_max: Any) -> Any:
    raise NotImplementedError


def _choose_clip(a: Any, a_min: Any, a_max: Any) -> Any:
    kinds = {types.unliteral(kind) for kind in (a, a_min, a_max)}
    number = float if types.float64 in kinds else int

    def clip(a: Any, a_min: Any, a_max: Any) -> Any:
        x, low, high = number(a), number(a_min), number(a_max)
        for one in (x, low, high):
            if one != one:  # NaN
                return one
        return min(max(x, low), high)

    return clip if kinds <= {types.int64, types.float64} else None


def _flatnonzero(a: Any) -> Any:
    raise NotImplementedError


def _choose_flatnonzero(a: Any) -> Any:
    """`np.flatnonzero` of an array, without the arrays that Numba makes on its way."""

    def flatnonzero(a: Any) -> Any:
        found, n = np.empty(a.size, np.int64), 0
        for i, value in enumerate(a.flat):
            if value:
                found[n] = i
                n += 1
        return found[:n]

    return flatnonzero if isinstance(a, types.Array) else lambda a: np.flatnonzero(a)


def _arange(start: Any, stop: Any, step: Any, dtype: Any) -> Any:
    raise NotImplementedError


def _choose_arange(start: Any, stop: Any, step: Any, dtype: Any) -> Any:
    """`np.arange`: NumPy takes the step from the first two numbers, in which last digits may be lost.

    1.4 - 0.4 is less than 1, and so is the step from 0.4 on.
    """

    def of_real_step(start: Any, stop: Any, step: Any, dtype: Any) -> Any:
        made = arange(start, stop, step, dtype)
        first, step = start * 1.0, (start + step) - start
        for i in range(2, made.size):
            made[i] = first + i * step
        return made

    no_stop, no_step = (isinstance(one, types.NoneType | types.Omitted) for one in (stop, step))
    if no_stop and not no_step:
        return lambda start, stop, step, dtype: _arange(0, start, step, dtype)
    if no_stop or REAL not in (types.unliteral(start), types.unliteral(step)):
        return lambda start, stop, step, dtype: arange(start, stop, step, dtype)
    if getattr(dtype, "dtype", REAL) != REAL:  # NumPy rounds or cuts the first two, and goes on from them
        return None
    return (lambda start, stop, step, dtype: _arange(start, stop, 1, dtype)) if no_step else of_real_step


extending.overload(_made_real, strict=False)(_choose_made_real)
extending.overload(_arange, strict=False)(_choose_arange)
_arange.__name__ = "np.arange"  # by which messages call it
extending.overload(_clip, strict=False)(_choose_clip)
extending.overload(_flatnonzero, strict=False)(_choose_flatnonzero)
_clip.__name__, _flatnonzero.__name__ = "np.clip", "np.flatnonzero"  # by which messages call them


REPLACED: dict[Any, Function] = {
    **{function: _in_domain(function, -LARGEST, LARGEST) for function in (math.sin, math.cos, math.tan)},
    **{function: _in_domain(function, TINY, math.inf) for function in (math.log, math.log2, math.log10)},
    **{function: _in_domain(function, -1.0, 1.0) for function in (math.acos, math.asin)},
    math.sqrt: _in_domain(math.sqrt, 0.0, math.inf),
    math.log1p: _in_domain(math.log1p, -BELOW_ONE, math.inf),
    math.atanh: _in_domain(math.atanh, -BELOW_ONE, BELOW_ONE),
    math.acosh: _in_domain(math.acosh, 1.0, math.inf),
    math.copysign: _copysign,
    **{function: _finite(function) for function in (math.exp, math.expm1, math.cosh, math.sinh)},
    **{function: _to_whole(function) for function in (math.floor, math.ceil, math.trunc)},
    builtins.any: _any,
    builtins.all: _all,
    np.median: _median,
    np.clip: lambda a, a_min, a_max: _clip(a, a_min, a_max),
    np.flatnonzero: lambda a: _flatnonzero(a),
    np.arange: lambda start, stop=None, step=None, dtype=None: _arange(start, stop, step, dtype),
    **{function: _extreme("np.max", operator.gt, lambda a: np.max(a)) for function in (np.max, np.amax)},
    **{function: _extreme("np.min", operator.lt, lambda a: np.min(a)) for function in (np.min, np.amin)},
}
"""Replacements of functions of `math` and `np`, and of two of Python's own that Numba does not have."""
CALLED: dict[Any, Function] = {
    builtins.int: _to_whole(int),
    builtins.round: _to_whole(round),
    builtins.float: _float,
    builtins.sum: lambda values, start=0: _sum(values, start),
    builtins.abs: lambda x: _abs(x),
    builtins.divmod: lambda x, y: _divmod(x, y),
}
"""Replacements of builtins where they are called (`int` may also be the type of an array)."""
EXTREMES: dict[str, Function] = {
    "max": _extreme("max", operator.gt, lambda a: a.max()),
    "min": _extreme("min", operator.lt, lambda a: a.min()),
}
"""Replacements of methods of arrays where they are called without arguments."""


def _sum(values: Any, start: Any) -> Any:
    raise NotImplementedError


def _choose_sum(values: Any, start: Any) -> Any:
    """`sum`: of whole numbers with a check, of real ones from the start as a real number."""
    begin = types.unliteral(getattr(start, "value", start) if isinstance(start, types.Omitted) else start)
    of_whole = begin in (INT, 0)

    def whole(values: Any, start: Any) -> Any:
        total = start
        for value in values:
            total = _add(total, int(value))
        return total

    def real(values: Any, start: Any) -> Any:
        total, empty = start * 1.0, True
        for value in values:
            total, empty = total + value, False
        if empty and of_whole:
            raise ValueError("the sum of no real numbers is a whole one")
        return total

    kind = getattr(getattr(values, "iterator_type", None), "yield_type", None)
    if kind in (INT, types.boolean) and of_whole:
        return whole
    return real if kind in (INT, REAL, types.boolean) and begin in (INT, 0, REAL) else None


def sum_of_mixed(values: Any, start: Any) -> Any:
    """`sum` of numbers that may all be whole in Python (`edugym.compiled.mixed_numbers`)."""
    raise NotImplementedError


def _choose_sum_of_mixed(values: Any, start: Any) -> Any:
    add = MIXED[operator.add].function

    def in_turn(values: Any, start: Any) -> Any:
        total, empty = start * 1.0, True
        for value in values:
            total, empty = add(total, value), False
        if empty:
            raise ValueError("the sum of no real numbers is a whole one")
        return total

    return in_turn


def _abs(x: Any) -> Any:
    raise NotImplementedError


def _choose_abs(x: Any) -> Any:
    whole = types.unliteral(x) == INT
    return (lambda x: x if x >= 0 else _subtract(0, x)) if whole else (lambda x: abs(x))


def _divmod(x: Any, y: Any) -> Any:
    raise NotImplementedError


def _choose_divmod(x: Any, y: Any) -> Any:
    def whole(x: Any, y: Any) -> Any:
        return quotient(x, y), remainder(x, y)

    quotient = CHECKED[operator.floordiv, INT, INT].function
    remainder = CHECKED[operator.mod, INT, INT].function
    if types.unliteral(x) == types.unliteral(y) == INT:
        return whole
    return lambda x, y: divmod(x, y)


extending.overload(_sum, strict=False)(_choose_sum)
extending.overload(sum_of_mixed, strict=False)(_choose_sum_of_mixed)
extending.overload(_abs, strict=False)(_choose_abs)
extending.overload(_divmod, strict=False)(_choose_divmod)
_sum.__name__, sum_of_mixed.__name__ = "sum", "sum"  # by which messages call them
_abs.__name__, _divmod.__name__ = "abs", "divmod"

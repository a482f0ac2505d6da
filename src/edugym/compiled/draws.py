"""Checked random draws for students' machine code: they give what NumPy gives, or raise an error.

Numba checks no parameters, returns a single whole number as an array, and has no `rng.choice`. After an error the
interpreter repeats the call of the loop, as in `edugym.compiled.arithmetic`.
"""

import math
from typing import Any

import numpy as np
from numba import extending
from numba.core import types
from numba.np.random import random_methods as methods

from edugym.compiled.arithmetic import LARGEST, Function

LAST_OF_32_BITS, LAST_OF_64_BITS = 2**32 - 1, 2**64 - 1
MEAN_OF_EQUAL_DRAWS, TRIALS_OF_EQUAL_DRAWS = 10.0, 30
TOLERANCE = 1e-8
"""How far from 1 a sum of probabilities may be. NumPy allows a little more, and adds with more digits."""


def _may_scale(scale: Any) -> Any:
    """Whether NumPy takes a number as a scale: it is not negative, and not -0.0 either."""
    raise NotImplementedError


def _choose_may_scale(scale: Any) -> Any:
    """Chooses the implementation: an array is left to the draw, whose message names it."""
    if isinstance(scale, types.Array):
        return lambda scale: True
    return lambda scale: scale > 0 or (scale == 0 and math.copysign(1.0, scale) > 0.0) or scale != scale


def _normal(rng: Any, loc: Any = 0.0, scale: Any = 1.0, size: Any = None) -> Any:
    """`rng.normal(loc, scale, size)`."""
    if not _may_scale(scale):
        raise ValueError("scale < 0")
    return rng.normal(loc, scale, size)


def _exponential(rng: Any, scale: Any = 1.0, size: Any = None) -> Any:
    """`rng.exponential(scale, size)`."""
    if not _may_scale(scale):
        raise ValueError("scale < 0")
    return rng.exponential(scale, size)


def _uniform(rng: Any, low: Any = 0.0, high: Any = 1.0, size: Any = None) -> Any:
    """`rng.uniform(low, high, size)`."""
    if not (high - low <= LARGEST and _may_scale(high - low)):
        raise ValueError("high - low < 0")
    return rng.uniform(low, high, size)


def _poisson(rng: Any, lam: Any = 1.0) -> Any:
    """`rng.poisson(lam)`; for larger means Numba's draws are not always NumPy's."""
    if not 0.0 <= lam < MEAN_OF_EQUAL_DRAWS:
        raise ValueError("lam < 0, or large")
    return rng.poisson(lam)


def _binomial(rng: Any, n: Any, p: Any) -> Any:
    """`rng.binomial(n, p)`; for more trials Numba's draws need not be NumPy's."""
    if not (0 <= n | 0 <= TRIALS_OF_EQUAL_DRAWS and 0.0 <= p <= 1.0):  # only whole numbers have |
        raise ValueError("p < 0, p > 1 or n < 0, or n is large")
    return rng.binomial(n, p)


def _is_none(kind: Any) -> bool:
    """Whether the type of a parameter says that it is None, or was left out."""
    return kind is None or isinstance(kind, types.NoneType | types.Omitted)


def _integers_of_kind(rng: Any, low: Any, high: Any, size: Any, dtype: Any, endpoint: Any) -> Any:
    """In machine code, what `_choose_integers` returns."""
    raise NotImplementedError


def _choose_integers(rng: Any, low: Any, high: Any, size: Any, dtype: Any, endpoint: Any) -> Any:
    """Chooses the implementation for these types while Numba compiles; None if `rng.integers` takes no such types."""
    if not _is_none(dtype) and getattr(dtype, "dtype", None) != types.int64:
        return None
    if _is_none(size) and _is_none(high):
        return lambda rng, low, high, size, dtype, endpoint: _bounded_integer(rng, 0, low, endpoint)
    if _is_none(size):
        return lambda rng, low, high, size, dtype, endpoint: _bounded_integer(rng, low, high, endpoint)
    if _is_none(high):
        return lambda rng, low, high, size, dtype, endpoint: rng.integers(0, low, size, np.int64, endpoint)
    return lambda rng, low, high, size, dtype, endpoint: rng.integers(low, high, size, np.int64, endpoint)


def _integers(rng: Any, low: Any, high: Any = None, size: Any = None, dtype: Any = None, endpoint: Any = False) -> Any:
    """`rng.integers(high)` or `rng.integers(low, high)`; Numba knows only the second, and its one draw is an array."""
    return _integers_of_kind(rng, low, high, size, dtype, endpoint)


def _bounded_integer(rng: Any, low: Any, high: Any, endpoint: Any) -> Any:
    """A whole number from `low` to `high`, drawn as NumPy draws it."""
    limits, bits = range(low | 0, high | 0), rng.bit_generator  # only whole numbers have |
    low, high = limits.start, limits.stop
    if low > high or (low == high and not endpoint):
        raise ValueError("low >= high")
    last = np.uint64(high) - np.uint64(low) - np.uint64(not endpoint)
    if last == 0:
        return low
    if last < LAST_OF_32_BITS:
        drawn = np.uint64(methods.buffered_bounded_lemire_uint32(bits, np.uint32(last)))
    elif last == LAST_OF_32_BITS:
        drawn = np.uint64(methods.next_uint32(bits))
    elif last == LAST_OF_64_BITS:
        drawn = np.uint64(methods.next_uint64(bits))
    else:
        drawn = np.uint64(methods.bounded_lemire_uint64(bits, last))
    return np.int64(np.uint64(low) + drawn)  # a sum of signed numbers may not overflow on its way


def _weighted_index(rng: Any, n: Any, p: Any) -> Any:
    """A number from 0 to n - 1, each with its probability."""
    if len(p) != n:
        raise ValueError("a and p must have the same size")
    total = 0.0
    for probability in p:
        if not probability >= 0.0:  # negative, or NaN
            raise ValueError("probabilities must not be negative")
        total += probability
    if not abs(total - 1.0) <= TOLERANCE:
        raise ValueError("probabilities must sum to 1")
    drawn, i, so_far = rng.random(), 0, p[0]
    while drawn >= so_far / total:
        i += 1
        so_far += p[i]
    return i


def _is_sequence(kind: Any) -> bool:
    """Whether a type is a list, a tuple or an array of one dimension, with numbers of one type."""
    row = isinstance(kind, types.List | types.UniTuple) or (isinstance(kind, types.Array) and kind.ndim == 1)
    return row and isinstance(kind.dtype, types.Number | types.Boolean)


def _choice(rng: Any, a: Any, size: Any = None, replace: Any = True, p: Any = None) -> Any:
    """`rng.choice(n)` or `rng.choice(values)`, with probabilities `p` or without, for one draw."""
    number = isinstance(a, types.Integer)
    fits = (number or _is_sequence(a)) and (_is_none(p) or _is_sequence(p))
    replaced = getattr(replace, "literal_value", getattr(replace, "value", replace))
    if not fits or not _is_none(size) or replaced is not True:
        return None
    if _is_none(p) and number:
        return lambda rng, a, size=None, replace=True, p=None: _bounded_integer(rng, 0, a, False)
    if _is_none(p):
        return lambda rng, a, size=None, replace=True, p=None: a[_bounded_integer(rng, 0, len(a), False)]
    if number:
        return lambda rng, a, size=None, replace=True, p=None: _weighted_index(rng, a, p)
    return lambda rng, a, size=None, replace=True, p=None: a[_weighted_index(rng, len(a), p)]


extending.overload(_may_scale, strict=False)(_choose_may_scale)
extending.register_jitable(_bounded_integer)
extending.register_jitable(_weighted_index)
extending.overload(_integers_of_kind, strict=False)(_choose_integers)
extending.overload_method(types.NumPyRandomGeneratorType, "choice", strict=False)(_choice)
_integers_of_kind.__name__, _choice.__name__ = "rng.integers", "rng.choice"  # by which messages call them

DRAWN: dict[str, Function] = {
    "normal": _normal,
    "exponential": _exponential,
    "uniform": _uniform,
    "poisson": _poisson,
    "binomial": _binomial,
    "integers": _integers,
}
"""Replacements of methods of `rng`, by name."""

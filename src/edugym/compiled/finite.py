"""Machine code that asks what an observation or an action is by its type (`edugym.mdp.membership`)."""

import math
from collections.abc import Callable
from typing import Any

from numba import extending
from numba.core import types

from edugym.mdp.membership import is_finite_of_shape, wholeness


def _choose(value: Any, shape: Any) -> Callable[..., Any] | None:
    """Chooses the implementation for the type of an action, while compiling."""
    if isinstance(value, types.Array):
        return _of_array
    if isinstance(value, types.Number):
        return _of_number
    if isinstance(value, types.BaseTuple) and all(isinstance(part, types.Number) for part in value):
        finite = " and ".join(f"isfinite(value[{i}])" for i in range(len(value))) or "True"
        known: dict[str, Any] = {"isfinite": math.isfinite}
        size = len(value)
        exec(f"def of_tuple(value, shape):\n    return len(shape) == 1 and shape[0] == {size} and {finite}", known)
        of_tuple: Callable[..., Any] = known["of_tuple"]
        return of_tuple
    return None


def _of_array(value: Any, shape: Any) -> Any:
    size = 1
    for one in shape:
        size *= one
    if value.size != size or (size != 1 and value.shape != shape):
        return False
    finite = True
    for number in value.flat:
        finite = finite and math.isfinite(number)
    return finite


def _of_number(value: Any, shape: Any) -> Any:
    size = 1
    for one in shape:
        size *= one
    return size == 1 and math.isfinite(value)


def _choose_wholeness(value: Any) -> Callable[..., Any]:
    """Answers for the type of a value, while compiling; True and False have a type of their own."""
    kind = value.type if isinstance(value, types.Optional) else value
    found = 1 if isinstance(kind, types.Boolean) else 2 if isinstance(kind, types.Integer) else 0
    return (lambda value: 0 if value is None else found) if kind is not value else lambda value: found


extending.overload(is_finite_of_shape, strict=False)(_choose)
extending.overload(wholeness, strict=False)(_choose_wholeness)
IMPLEMENTED = frozenset({is_finite_of_shape, wholeness})
"""Functions that machine code does not compile from their source."""

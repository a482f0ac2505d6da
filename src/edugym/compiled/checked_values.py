"""Checks of values where Numba's own lists, tuples and arrays answer otherwise than Python's.

`values_to_check` says which values an operation needs checked; `typed_checks` puts a call of the function in front of
it. In machine code such a function raises an error, and the interpreter repeats the call.
"""

import math
import operator
from collections.abc import Iterator
from typing import Any

import numpy as np
from numba import extending
from numba.core import ir_utils, types

from edugym.compiled.arithmetic import Function
from edugym.compiled.number_kinds import COMPARED, holds_real, is_real, method_name
from edugym.compiled.operations import CHECK_EXACT, CHECK_NUMBER, INT, REAL

LEAST = -(2**63)


def values_to_check(func_ir: Any, expr: Any, kinds: Any) -> Iterator[tuple[Any, Any]]:
    """What has to be checked before tuples or lists are compared, sorted or searched, or whole arrays are divided."""
    collection, function = types.BaseTuple | types.List, expr.fn if expr.op == "binop" else None
    if function in COMPARED and any(isinstance(kinds[one.name], collection) for one in (expr.lhs, expr.rhs)):
        if any(holds_real(kinds[one.name]) for one in (expr.lhs, expr.rhs)):
            yield from ((require_plain, one) for one in (expr.lhs, expr.rhs))
    elif expr.op == "call":
        called = kinds[expr.func.name]
        if getattr(called, "typing_key", None) in (sorted, np.sort):
            yield from ((require_order, one) for one in expr.args[:1])
        elif isinstance(called, types.BoundFunction) and isinstance(called.this, types.List):
            name = method_name(called.typing_key)
            if name == "sort":
                yield require_order, ir_utils.get_definition(func_ir, expr.func).value
            elif name == "extend" and holds_real(called.this):
                yield require_exact, expr.args[0]
            elif name in ("count", "index", "remove") and holds_real(called.this):
                yield from ((require_plain, one) for one in expr.args[:1])
    elif expr.op in ("binop", "inplace_binop") and any(map(holds_real, lists(expr, kinds))):
        yield from ((require_exact, one) for one in (expr.lhs, expr.rhs) if isinstance(kinds[one.name], types.List))
    elif expr.op in ("binop", "inplace_binop") and _may_divide_by_minus_one(expr, kinds):
        yield require_no_least, expr.lhs


def lists(expr: Any, kinds: Any) -> list[Any]:
    """The types of those operands that are lists."""
    return [kinds[one.name] for one in (expr.lhs, expr.rhs) if isinstance(kinds[one.name], types.List)]


def _may_divide_by_minus_one(expr: Any, kinds: Any) -> bool:
    """Whether an operation divides whole numbers, some of them in an array, by what may be -1."""
    function = expr.fn if expr.op == "binop" else expr.immutable_fn
    both, divisor = [types.unliteral(kinds[one.name]) for one in (expr.lhs, expr.rhs)], kinds[expr.rhs.name]
    if function is not operator.floordiv or not any(isinstance(kind, types.Array) for kind in both):
        return False
    known = isinstance(divisor, types.IntegerLiteral) and divisor.literal_value != -1
    return not known and not any(map(is_real, both))


def require_plain(value: Any) -> None:
    """Raises an error for NaN, which Python finds by its identity, and for whole numbers that are no real ones."""
    raise NotImplementedError


def _choose_plain(value: Any) -> Function:
    kind = types.unliteral(value)
    if kind in (INT, REAL):
        check = (CHECK_EXACT if kind == INT else CHECK_NUMBER).function

        def of_number(value: Any) -> None:
            check(value)

        return of_number
    if isinstance(kind, types.List):

        def of_list(value: Any) -> None:
            for one in value:
                require_plain(one)

        return of_list
    known: dict[str, Any] = {"require_plain": require_plain}
    parts = range(len(kind) if isinstance(kind, types.BaseTuple) else 0)
    exec("def of_parts(value):\n    pass\n" + "".join(f"    require_plain(value[{i}])\n" for i in parts), known)
    of_parts: Function = known["of_parts"]
    return of_parts


def require_order(values: Any) -> None:
    """Raises an error where the order of real numbers hangs on how they are sorted: that of NaN, of 0.0 and -0.0."""
    raise NotImplementedError


def _choose_order(values: Any) -> Function:
    def of_reals(values: Any) -> None:
        plus = minus = False
        for one in values:
            if one != one:
                raise ValueError("NaN has no place in an order")
            plus = plus or (one == 0.0 and math.copysign(1.0, one) > 0.0)
            minus = minus or (one == 0.0 and math.copysign(1.0, one) < 0.0)
        if plus and minus:
            raise ValueError("0.0 and -0.0 have no order")

    def of_table(values: Any) -> None:
        require_order(values.ravel())

    if isinstance(values, types.Array) and values.ndim != 1:
        return of_table
    return of_reals if getattr(values, "dtype", None) == REAL else lambda values: None


def require_exact(values: Any) -> None:
    """Raises an error for whole numbers that are no real ones, where they are put in a list of real ones."""
    raise NotImplementedError


def _choose_exact(values: Any) -> Function:
    check = CHECK_EXACT.function

    def of_wholes(values: Any) -> None:
        for value in values:
            check(value)

    kind = getattr(getattr(values, "iterator_type", None), "yield_type", None)
    if kind == INT:
        return of_wholes
    return (lambda values: require_plain(values)) if isinstance(values, types.Tuple) else lambda values: None


def require_no_least(values: Any) -> None:
    """Raises an error for the least whole number of 64 bits: divided by -1 it is 0 in Numba's arrays alone."""
    raise NotImplementedError


def _choose_no_least(values: Any) -> Function:
    def of_number(values: Any) -> None:
        if values == LEAST:
            raise OverflowError("more than 64 bits")

    def of_array(values: Any) -> None:
        for value in values.flat:
            if value == LEAST:
                raise OverflowError("more than 64 bits")

    if not isinstance(values, types.Array):
        return of_number
    return of_array if values.dtype == INT else lambda values: None


extending.overload(require_exact, strict=False)(_choose_exact)
extending.overload(require_no_least, strict=False)(_choose_no_least)
extending.overload(require_plain, strict=False)(_choose_plain)
extending.overload(require_order, strict=False)(_choose_order)

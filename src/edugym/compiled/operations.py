"""Checked operators for students' machine code: they give what Python gives, or raise an error.

An error is raised where Python raises one, and where Python goes on with larger numbers than 64 bits hold. The
interpreter then repeats the call (`edugym.compiled.execution`).

`CHECKED` are operations on whole numbers, powers, and comparisons of whole with real numbers; they replace operators
once types are known (`edugym.compiled.typed_checks`). Whole numbers are compared with real ones only up to 2^53, below
which each is a real number exactly. `MIXED` are those on numbers that are whole in one place and real in another
(`edugym.compiled.mixed_numbers`).
"""

import ctypes
import ctypes.util
import math
import operator
from collections.abc import Callable
from typing import Any, NamedTuple

from llvmlite import binding
from llvmlite import ir as llvm
from numba import extending
from numba.core import cgutils, registry, types

Function = Callable[..., Any]
LARGEST_EXACT = 2**53  # up to here every whole number is a real number of 64 bits


class Operation(NamedTuple):
    """An operation that replaces an operator.

    Attributes:
        function: the name by which Numba knows it.
        kinds: the types that it takes.
        result: the type that it gives.
    """

    function: Function
    kinds: tuple[Any, ...]
    result: Any


def signature_of(operation: Operation) -> Any:
    """The signature with which machine code calls an operation in the place of an operator."""
    context = registry.cpu_target.typing_context
    return context.resolve_value_type(operation.function).get_call_type(context, operation.kinds, {})


def _operation(kinds: tuple[Any, ...], result: Any, implementation: Function) -> Operation:
    """A new operation that machine code can call: `implementation(context, builder, signature, values)` writes it."""

    def operation(*operands: Any) -> Any:
        raise NotImplementedError

    def typer(context: Any) -> Function:
        if len(kinds) == 1:
            return lambda x: result if types.unliteral(x) == kinds[0] else None
        return lambda x, y: result if (types.unliteral(x), types.unliteral(y)) == kinds else None

    extending.type_callable(operation)(typer)
    extending.lower_builtin(operation, *kinds)(implementation)
    return Operation(operation, kinds, result)


def _whole_operation(name: str) -> Operation:
    """Addition, subtraction or multiplication that raises an error where the result has more than 64 bits."""

    def implementation(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        both = getattr(builder, name)(*values)
        with builder.if_then(builder.extract_value(both, 1), likely=False):
            context.call_conv.return_user_exc(builder, OverflowError, ("more than 64 bits",))
        return builder.extract_value(both, 0)

    return _operation((types.int64, types.int64), types.int64, implementation)


def _operation_in_python(function: Function, kinds: tuple[Any, ...], result: Any) -> Operation:
    """An operation written in Python."""

    def implementation(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        return context.compile_internal(builder, function, signature, values)

    return _operation(kinds, result, implementation)


def _whole_power(base: int, exponent: int) -> int:
    if exponent < 0:
        raise ValueError("a whole number to a negative power is a fraction")
    if base == 0 or base == 1:
        return base if exponent > 0 else 1
    if base == -1:
        return 1 - 2 * (exponent & 1)
    limit = 9223372036854775807 // abs(base)
    power = 1
    for _ in range(exponent):
        if power > limit or power < -limit:
            raise OverflowError("more than 64 bits")
        power *= base
    return power


def _declare_libm_pow() -> Function:
    """C's `pow`, which Python calls too; the compiler would make `x * x` and the like of its own."""

    def libm_pow(base: Any, exponent: Any) -> Any:
        raise NotImplementedError

    def implementation(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        kind = llvm.FunctionType(llvm.DoubleType(), [llvm.DoubleType()] * 2)
        name = "edugym_pow" if found else "pow"
        return builder.call(cgutils.get_or_insert_function(builder.module, kind, name), values)

    try:
        library: Any = ctypes.CDLL(ctypes.util.find_library("m"))
        found = ctypes.cast(library.pow, ctypes.c_void_p).value
    except (OSError, AttributeError):  # another system keeps it elsewhere
        found = None
    if found:
        binding.add_symbol("edugym_pow", found)
    extending.type_callable(libm_pow)(lambda context: lambda x, y: types.float64)
    extending.lower_builtin(libm_pow, types.float64, types.float64)(implementation)
    return libm_pow


_libm_pow = _declare_libm_pow()


def _power(base: Any, exponent: Any) -> Any:
    if base == 0.0 and exponent < 0.0:
        raise ZeroDivisionError("zero to a negative power")
    if base < 0.0 and exponent != math.floor(exponent) and not math.isinf(exponent):
        raise ValueError("a power that is a complex number")
    power = _libm_pow(base, exponent)
    if math.isinf(power) and not math.isinf(base) and not math.isinf(exponent):
        raise OverflowError("a power that is too large")
    return power


def _quotient(x: int, y: int) -> float:
    if max(abs(x), abs(y)) > LARGEST_EXACT:
        raise OverflowError("whole numbers too large for an exact division")
    return x / y


def _whole_quotient(x: int, y: int) -> int:
    if y == -1:
        opposite: int = _subtract(0, x)
        return opposite
    return x // y


def _remainder(x: int, y: int) -> int:
    return 0 if y == -1 else x % y  # the processor cannot divide the least number by -1


def _left_shift(x: int, y: int) -> int:
    if y < 0 or y > 62 or (x << y) >> y != x:
        raise OverflowError("more than 64 bits")
    return x << y


def _right_shift(x: int, y: int) -> int:
    if y < 0:
        raise ValueError("negative shift count")
    return x >> min(y, 63)


def _comparison(compare: Function, *, whole_first: bool) -> Operation:
    """A comparison of a whole and a real number."""

    def compared(x: Any, y: Any) -> Any:
        whole = x if whole_first else y
        if whole > LARGEST_EXACT or whole < -LARGEST_EXACT:
            raise OverflowError("a whole number too large to be compared with a real one")
        return compare(float(x), float(y))

    kinds = (types.int64, types.float64) if whole_first else (types.float64, types.int64)
    return _operation_in_python(compared, kinds, types.boolean)


def _exact(x: int) -> float:
    if x > LARGEST_EXACT or x < -LARGEST_EXACT:
        raise OverflowError("a whole number too large for a real one")
    return float(x)


def _number(x: float) -> float:
    if math.isnan(x):
        raise ValueError("Python finds the same NaN in a list, though NaN equals nothing")
    return x


def _mixed(operation: Function) -> Operation:
    """An operation on two real numbers that may be whole in Python.

    It raises an error where that would make a difference: from 2^53 on, and where zero gets a sign.
    """

    def compute(x: Any, y: Any) -> Any:
        return _require_same(operation(x, y))

    return _operation_in_python(compute, (REAL, REAL), REAL)


def _require_same(result: float) -> float:
    if abs(result) >= LARGEST_EXACT and not math.isinf(result):  # 2^53 may be 2^53 + 1, rounded
        raise OverflowError("a number, whole in one place and real in another, beyond 2^53")
    if result == 0.0 and math.copysign(1.0, result) < 0.0:
        raise ValueError("-0.0 made of numbers that are whole in one place and real in another: write 0.0 for 0")
    return result


def _negative(x: float) -> float:
    return _require_same(-x)


INT, REAL = types.int64, types.float64
extending.register_jitable(_require_same)
ADD, SUBTRACT = _whole_operation("sadd_with_overflow"), _whole_operation("ssub_with_overflow")
_add, _subtract = ADD.function, SUBTRACT.function
CHECK_EXACT = _operation_in_python(_exact, (INT,), REAL)
"""Raises an error for a whole number that is no real number exactly."""
CHECK_NUMBER = _operation_in_python(_number, (REAL,), REAL)
"""Raises an error for NaN."""
NEGATIVE = _operation_in_python(lambda x: _subtract(0, x), (INT,), INT)
"""Minus a whole number."""
POWER = _operation_in_python(_power, (REAL, REAL), REAL)
CHECKED: dict[tuple[Any, Any, Any], Operation] = {
    (operator.add, INT, INT): ADD,
    (operator.sub, INT, INT): SUBTRACT,
    (operator.mul, INT, INT): _whole_operation("smul_with_overflow"),
    (operator.pow, INT, INT): _operation_in_python(_whole_power, (INT, INT), INT),
    (operator.truediv, INT, INT): _operation_in_python(_quotient, (INT, INT), REAL),
    (operator.floordiv, INT, INT): _operation_in_python(_whole_quotient, (INT, INT), INT),
    (operator.mod, INT, INT): _operation_in_python(_remainder, (INT, INT), INT),
    (operator.lshift, INT, INT): _operation_in_python(_left_shift, (INT, INT), INT),
    (operator.rshift, INT, INT): _operation_in_python(_right_shift, (INT, INT), INT),
    **{(operator.pow, *kinds): POWER for kinds in ((REAL, REAL), (REAL, INT), (INT, REAL))},
    **{
        (compare, *((INT, REAL) if first else (REAL, INT))): _comparison(compare, whole_first=first)
        for compare in (operator.lt, operator.le, operator.gt, operator.ge, operator.eq, operator.ne)
        for first in (True, False)
    },
}
"""Replacements of operators, by the operator and the types of its operands."""
MIXED: dict[Any, Operation] = {
    operator.add: _mixed(extending.register_jitable(lambda x, y: x + y)),
    operator.sub: _mixed(extending.register_jitable(lambda x, y: x - y)),
    operator.mul: _mixed(extending.register_jitable(lambda x, y: x * y)),
    operator.floordiv: _mixed(extending.register_jitable(lambda x, y: x // y)),
    operator.mod: _mixed(extending.register_jitable(lambda x, y: x % y)),
    operator.pow: _mixed(POWER.function),
}
"""Replacements of operators whose operands may both be whole numbers in Python."""
MIXED_NEGATIVE = _operation_in_python(_negative, (REAL,), REAL)
"""Minus such a number."""

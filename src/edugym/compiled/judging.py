"""What Numba does besides, when types are known, with code that is not the package's own: judge it.

This is a pass in Numba's pipeline (`edugym.compiled.pipelines`). Every value must be of a type, and every operation of
a kind, that machine code treats as Python does. Operators of whole numbers are replaced by checked ones.
"""

import importlib
import operator
from typing import Any

import numpy as np

from edugym.compiled.arithmetic import CHECKED
from edugym.compiled.passes import refuse, statements
from edugym.compiled.subset import words

ir: Any = importlib.import_module("numba.core.ir")
types: Any = importlib.import_module("numba.core.types")
typing: Any = importlib.import_module("numba.core.typing")
ir_utils: Any = importlib.import_module("numba.core.ir_utils")

ARRAY = words(
    "T all any argmax argmin copy cumsum dot fill flatten max mean min ndim prod ravel reshape shape size std"
)
ARRAY |= words("sum var")
DRAWS = words(
    "binomial choice exponential integers normal permutation poisson random shuffle standard_exponential "
    "standard_normal uniform"
)
MEMBERS = ((types.Array, ARRAY, "an array's"), (types.NumPyRandomGeneratorType, DRAWS, "rng's"))
"""What may be asked of arrays and generators."""
FITTING = (
    types.Array | types.BoundFunction | types.Callable | types.DType | types.EllipsisType | types.EnumClass
    | types.EnumMember | types.ExceptionClass | types.ExceptionInstance | types.IteratorType | types.Module
    | types.NoneType | types.NumberClass | types.NumPyRandomGeneratorType | types.RangeType | types.SliceType
    | types.UnicodeType | types.Omitted | types.Phantom
)  # fmt: skip
"""Types that will do; those of numbers and of what holds other values are looked at closer."""
FILLING = (np.array, np.full, np.full_like)
"""Functions that put what they are given into an array of the type that is asked for."""
BOOLEANS: set[Any] = {
    operator.add,
    operator.sub,
    operator.mul,
    operator.truediv,
    operator.floordiv,
    operator.mod,
    operator.pow,
}
BOOLEANS |= {operator.lshift, operator.rshift, operator.invert, operator.neg, operator.pos}
"""Operations with which Python's and NumPy's booleans do different things."""


def after_typing(state: Any) -> bool:
    """Refuse types and operations, and replace operators."""
    kinds = state.typemap
    for block, statement in statements(state.func_ir):
        if isinstance(statement, ir.Assign):
            _judge_type(kinds[statement.target.name], statement.loc)
            _judge_flag(statement.value, kinds, kinds[statement.target.name], statement.loc)
            if isinstance(statement.value, ir.Expr):
                _judge(statement.value, kinds, state.calltypes, statement)
        elif isinstance(statement, ir.Return):
            _judge_flag(statement.value, kinds, state.return_type, statement.loc)
        elif isinstance(statement, ir.SetItem | ir.StaticSetItem):
            if isinstance(statement, ir.SetItem):  # another one has a constant for an index
                _judge_index(kinds[statement.index.name], statement.loc)
            target, value = kinds[statement.target.name], kinds[statement.value.name]
            if isinstance(target, types.Array):
                _judge_stored(target, value, statement.loc)
            if isinstance(value, types.Array) and _puts_back(state.func_ir, statement):
                block.body.remove(statement)  # for which memory and reference counts would be needed
    return True


def _puts_back(func_ir: Any, statement: Any) -> bool:
    """Whether it is the second half of `E[:] *= 0.9`: it puts a part of an array, changed in place, where it is."""

    def definition(variable: Any) -> Any:
        return ir_utils.guard(ir_utils.get_definition, func_ir, variable)

    def place(item: Any) -> tuple[Any, Any]:
        taken = isinstance(item, ir.Expr)
        known = item.op == "static_getitem" if taken else isinstance(item, ir.StaticSetItem)
        return definition(item.value if taken else item.target), definition(item.index_var if known else item.index)

    changed = definition(statement.value)
    if not (isinstance(changed, ir.Expr) and changed.op == "inplace_binop"):
        return False
    part = definition(changed.lhs)
    if not (isinstance(part, ir.Expr) and part.op in ("getitem", "static_getitem")):
        return False
    return all(one is not None and one is other for one, other in zip(place(part), place(statement), strict=True))


def _judge_type(kind: Any, loc: Any) -> None:
    kind = types.unliteral(kind)
    if isinstance(kind, types.Optional):
        return _judge_type(kind.type, loc)
    if isinstance(kind, types.RecursiveCall):
        return refuse("it calls itself", loc)
    if isinstance(kind, types.Pair):
        return _judge_type(kind.first_type, loc)
    if isinstance(kind, types.BaseTuple):
        for part in kind:
            _judge_type(part, loc)
        return None
    if isinstance(kind, types.Number | types.Boolean):
        if kind not in (types.int64, types.intp, types.float64, types.boolean):
            refuse(f"it computes with numbers of type {kind}", loc)
        return None
    if isinstance(kind, types.Array):
        if not isinstance(kind.dtype, types.Number | types.Boolean):
            refuse(f"it has an array of {kind.dtype}", loc)
        return None
    if isinstance(kind, types.List):
        if not isinstance(kind.dtype, types.Number | types.Boolean):
            refuse("it makes a list of other things than numbers", loc)
        return _judge_type(kind.dtype, loc)
    if isinstance(kind, types.Poison | types.LiteralList):
        refuse("it makes a list of other things than numbers", loc)
    if isinstance(kind, types.NumpyFlatType) or not isinstance(kind, FITTING):
        refuse("it uses .flat" if isinstance(kind, types.NumpyFlatType) else f"it makes a value of type {kind}", loc)
    return None


def _judge_flag(value: Any, kinds: Any, target: Any, loc: Any) -> None:
    """Refuse to make a number of a boolean that Python leaves as it is, since `Q[True]` is not `Q[1]`."""
    joins = value.op if isinstance(value, ir.Expr) else ""
    sources = value.incoming_values if joins == "phi" else [value.value] if joins == "cast" else [value]
    flags = [isinstance(types.unliteral(kinds[one.name]), types.Boolean) for one in sources if isinstance(one, ir.Var)]
    if any(flags) and isinstance(types.unliteral(target), types.Number):
        refuse("one name stands for True or False and for numbers", loc)


def _narrow(kind: Any) -> bool:
    """Whether it is an array of other numbers than those of 64 bits: to be filled and passed on, but not computed with.

    (Numba and NumPy do not agree on what such numbers become when they meet others.)
    """
    return isinstance(kind, types.Array) and kind.dtype not in (types.int64, types.float64, types.boolean)


def _judge_stored(target: Any, value: Any, loc: Any) -> None:
    """Look at what is put into an array."""
    if _real(value) and not _real(target):
        refuse("it puts a real number in an array of whole numbers", loc)
    if _narrow(target) and not _real(target) and getattr(value, "dtype", None) != target.dtype:
        known = value.literal_value if isinstance(value, types.IntegerLiteral) else -1
        if not 0 <= known < 128:  # which fits in all of them; of others some raise an error and some do not
            refuse(f"it puts a number that may not fit in an array of {target.dtype}", loc)


def _real(kind: Any) -> bool:
    return isinstance(kind, types.Float) or (isinstance(kind, types.Array) and isinstance(kind.dtype, types.Float))


def _judge_index(kind: Any, loc: Any) -> None:
    for part in kind if isinstance(kind, types.BaseTuple) else [kind]:
        if isinstance(part, types.Array | types.List):
            refuse("it picks by an array, or list, of indices or booleans", loc)


def _judge(expr: Any, kinds: Any, calltypes: Any, statement: Any) -> None:
    """Look at one operation, and replace its operator where there is something to check."""
    loc, result = statement.loc, kinds[statement.target.name]
    if isinstance(result, types.UnicodeType) and expr.op not in ("getattr", "static_getitem", "getitem", "cast", "phi"):
        refuse("it makes text", loc)
    _judge_narrow(expr, kinds, loc)
    if expr.op == "getitem":
        _judge_index(kinds[expr.index.name], loc)
    elif expr.op == "getattr":
        for kind, members, whose in MEMBERS:
            if isinstance(kinds[expr.value.name], kind) and expr.attr not in members:
                refuse(f"it uses {whose} {expr.attr}", loc)
    elif expr.op == "call":
        function = kinds[expr.func.name]
        to_whole = isinstance(function, types.NumberClass) and isinstance(function.dtype, types.Integer)
        if to_whole and any(_real(kinds[part.name]) for part in expr.args):
            refuse("it makes a real number a whole one: use int()", loc)
        _judge_filled(expr, function, result, kinds, loc)
    elif expr.op == "unary":
        if expr.fn in BOOLEANS and isinstance(types.unliteral(kinds[expr.value.name]), types.Boolean):
            refuse("it computes with True and False as if they were numbers", loc)
    elif expr.op in ("binop", "inplace_binop"):
        _judge_operator(expr, kinds, calltypes, loc)


def _judge_filled(expr: Any, function: Any, result: Any, kinds: Any, loc: Any) -> None:
    """Refuse to fill an array of whole numbers with real ones: NaN and large ones are errors in Python."""
    filled = result if getattr(function, "typing_key", None) in FILLING else None
    if isinstance(function, types.BoundFunction) and function.typing_key == (types.Array, "fill"):
        filled = function.this
    given = [kinds[variable.name] for variable in (*expr.args, *(variable for _, variable in expr.kws))]
    if isinstance(getattr(filled, "dtype", None), types.Integer) and any(map(_holds_reals, given)):
        refuse("it puts a real number in an array of whole numbers", loc)


def _holds_reals(kind: Any) -> bool:
    if isinstance(kind, types.BaseTuple):
        return any(map(_holds_reals, kind))
    return isinstance(getattr(kind, "dtype", kind), types.Float)


def _judge_narrow(expr: Any, kinds: Any, loc: Any) -> None:
    """Refuse to compute with arrays of other numbers than those of 64 bits."""
    if expr.op in ("getattr", "getitem", "static_getitem", "build_tuple", "cast", "phi"):
        return  # single numbers are refused by their type
    called = kinds[expr.func.name] if expr.op == "call" else None
    own = isinstance(called, types.Dispatcher) or isinstance(getattr(called, "this", None), types.BaseTuple)
    if own or getattr(called, "typing_key", None) is len:
        return  # a function or method of the author's, or one that asks for no number
    for variable in expr.list_vars():
        kind = kinds[variable.name]
        if _narrow(kind) or _narrow(getattr(kind, "this", None)):
            refuse(f"it computes with numbers of type {getattr(kind, 'this', kind).dtype}", loc)


def _judge_operator(expr: Any, kinds: Any, calltypes: Any, loc: Any) -> None:
    function = expr.fn if expr.op == "binop" else expr.immutable_fn
    both = [types.unliteral(kinds[side.name]) for side in (expr.lhs, expr.rhs)]
    plain = [kind.dtype if isinstance(kind, types.Array) else kind for kind in both]
    if function in BOOLEANS and all(isinstance(kind, types.Boolean) for kind in plain):
        refuse("it computes with True and False as if they were numbers", loc)
    if function in (operator.is_, operator.is_not) and not any(isinstance(kind, types.NoneType) for kind in both):
        refuse("it compares with 'is'", loc)
    if isinstance(both[0], types.Array) and expr.op == "inplace_binop":
        if isinstance(both[1], types.Array | types.BaseTuple | types.List):
            refuse("it changes an array in place by another array: write a loop", loc)
        if not isinstance(plain[0], types.Float) and (_real(both[1]) or function in (operator.truediv, operator.pow)):
            refuse("it changes an array of whole numbers in place by real ones", loc)
    operation = CHECKED.get((function, *both))
    if operation:
        if expr.op == "binop":
            expr.fn = operation.function
        else:
            expr.immutable_fn = operation.function
        del calltypes[expr]
        calltypes[expr] = typing.signature(operation.result, *operation.kinds)

"""A compiler pass over students' code after Numba has inferred types: it refuses what Python would do otherwise.

Every value must be of a type, and every operation of a kind, that machine code treats as Python does. Operators of
whole numbers are replaced by checked ones (`edugym.compiled.arithmetic`).
"""

import operator
from typing import Any

import numpy as np
from numba.core import ir, ir_utils, types

from edugym.compiled.arithmetic import CALLED
from edugym.compiled.checked_values import lists, values_to_check
from edugym.compiled.insertions import insert_call
from edugym.compiled.mixed_numbers import follow_mixed
from edugym.compiled.number_kinds import as_number, is_real, method_name
from edugym.compiled.operations import CHECKED, NEGATIVE, signature_of
from edugym.compiled.subset import MATH, NUMPY, words
from edugym.compiled.untyped_checks import FROZEN, refuse, statements

ARRAY = words(
    "T all any argmax argmin copy cumsum dot fill flatten max mean min ndim prod ravel reshape shape size std sum var"
)
DRAWS = words(
    "binomial choice exponential integers normal permutation poisson random shuffle standard_exponential "
    "standard_normal uniform"
)
MEMBERS = ((types.Array, ARRAY, "an array's"), (types.NumPyRandomGeneratorType, DRAWS, "rng's"))
"""The members of arrays and generators that may be used."""
ALLOWED = (
    types.Array | types.BoundFunction | types.Callable | types.DType | types.EllipsisType | types.EnumClass
    | types.EnumMember | types.ExceptionClass | types.ExceptionInstance | types.IteratorType | types.Module
    | types.NoneType | types.NumberClass | types.NumPyRandomGeneratorType | types.RangeType | types.SliceType
    | types.UnicodeType | types.Omitted | types.Phantom | types.misc.UndefVar
)  # fmt: skip
"""Allowed types, besides numbers and what holds other values, which are looked at closer."""
FILLING = (np.array, np.full, np.full_like)
"""Functions that put what they are given into an array of the type that is asked for."""
_MOST_GIVEN: dict[Any, int] = {np.dot: 2, np.outer: 2, (types.Array, "dot"): 1}
"""How many arrays functions take besides one for the result, which Numba fills though it overlaps, or is frozen."""
READING = ARRAY - {"fill"}
"""The members of arrays that write nothing."""
NOT_WITH_BOOLEANS: set[Any] = {
    operator.add, operator.sub, operator.mul, operator.truediv, operator.floordiv, operator.mod, operator.pow,
    operator.lshift, operator.rshift, operator.invert, operator.neg, operator.pos,
}  # fmt: skip
"""Operations in which Python's and NumPy's booleans do different things."""


def check_typed(state: Any) -> bool:
    """Refuses types and operations, and replaces operators: the pass."""
    kinds = state.typemap
    for _, statement in statements(state.func_ir):
        if isinstance(statement, ir.Assign):
            _check_bounds(statement.value, kinds, statement.loc)
            _check_type(kinds[statement.target.name], statement.loc)
    follow_mixed(state)
    for block, statement in statements(state.func_ir):
        if isinstance(statement, ir.Assign):
            _check_boolean(statement.value, kinds, kinds[statement.target.name], statement.loc)
            if isinstance(statement.value, ir.Expr):
                for check, variable in values_to_check(state.func_ir, statement.value, kinds):
                    insert_call(state, block, statement, check, variable)
                _check_expression(statement.value, kinds, state.calltypes, statement)
        elif isinstance(statement, ir.Return):
            _check_boolean(statement.value, kinds, state.return_type, statement.loc)
        elif isinstance(statement, ir.SetItem | ir.StaticSetItem):
            if isinstance(statement, ir.SetItem):  # the other has a constant for an index
                _check_index(kinds[statement.index.name], statement.loc)
            target, value = kinds[statement.target.name], kinds[statement.value.name]
            if isinstance(target, types.List):
                _check_put_in_list(state.func_ir, statement, kinds)
            if isinstance(target, types.Array):
                _check_stored(target, value, statement.loc)
            if isinstance(value, types.Array) and _stores_itself(state.func_ir, statement):
                block.body.remove(statement)  # it would need memory and reference counts
    return True


def _check_put_in_list(func_ir: Any, statement: Any, kinds: Any) -> None:
    """Refuses flags among numbers and numbers among flags, and a list in a part of what may be the same list."""
    target, value = kinds[statement.target.name], types.unliteral(kinds[statement.value.name])
    _require_no_flags([statement.value], target.dtype, kinds, statement.loc)
    if _is_boolean(target.dtype) and isinstance(value, types.Number):
        refuse("it mixes True or False with numbers", statement.loc)
    if isinstance(value, types.List) and not _is_new_list(func_ir, statement.value, kinds):
        found = "it puts a list in a part of a list, which may be the same one"
        refuse(f"{found}: put a copy there, as in row[1:] = other[:]", statement.loc)


def _is_new_list(func_ir: Any, variable: Any, kinds: Any) -> bool:
    """Whether a list was just made, so that it has no other name."""
    made = variable
    while isinstance(made, ir.Var):
        if not made.is_temp:
            return False
        defined = func_ir._definitions[made.name]
        made = defined[0] if len(defined) == 1 else None
    op = getattr(made, "op", "")
    if op == "call":
        return getattr(kinds[made.func.name], "typing_key", None) in (list, sorted)
    if op in ("getitem", "static_getitem"):
        return isinstance(kinds[made.value.name], types.List)
    return op in ("build_list", "binop")


def _stores_itself(func_ir: Any, statement: Any) -> bool:
    """Whether a part of an array, changed in place, is stored where it is: the second half of `E[:] *= 0.9`."""

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


def _check_type(kind: Any, loc: Any) -> None:
    """Refuses numbers of other than 64 bits, collections of other things than numbers, and unknown types."""
    kind = types.unliteral(kind)
    if isinstance(kind, types.Optional):
        _check_type(kind.type, loc)
    elif isinstance(kind, types.RecursiveCall):
        refuse("it calls itself", loc)
    elif isinstance(kind, types.Pair):
        _check_type(kind.first_type, loc)
    elif isinstance(kind, types.BaseTuple):
        for part in kind:
            _check_type(part, loc)
    elif isinstance(kind, types.Number | types.Boolean):
        if kind not in (types.int64, types.intp, types.float64, types.boolean):
            refuse(f"it computes with numbers of type {kind}", loc)
    elif isinstance(kind, types.Array):
        if not isinstance(kind.dtype, types.Number | types.Boolean):
            refuse(f"it has an array of {kind.dtype}", loc)
    elif isinstance(kind, types.List | types.Poison | types.LiteralList):
        if not isinstance(kind, types.List) or not isinstance(kind.dtype, types.Number | types.Boolean):
            refuse("it makes a list of other things than numbers", loc)
        _check_type(kind.dtype, loc)
    elif isinstance(kind, types.Set):
        refuse("it makes a set", loc)
    elif isinstance(kind, types.NumpyFlatType):
        refuse("it uses .flat", loc)
    elif not isinstance(kind, ALLOWED):
        refuse(f"it makes a value of type {kind}", loc)


def _check_bounds(value: Any, kinds: Any, loc: Any) -> None:
    """Refuses flags and real numbers as bounds of a range or a slice: NumPy's flags are an error there."""
    function = kinds[value.func.name] if isinstance(value, ir.Expr) and value.op == "call" else None
    if getattr(function, "typing_key", None) in (range, slice):
        given = [types.unliteral(kinds[one.name]) for one in value.args]
        if any(isinstance(kind, types.Boolean | types.Float) for kind in given):
            refuse("it gives True or False, or a real number, where a whole one belongs: use int()", loc)


def _check_boolean(value: Any, kinds: Any, target: Any, loc: Any) -> None:
    """Refuses to make a number of a boolean that Python leaves as it is, since `Q[True]` is not `Q[1]`."""
    joins = value.op if isinstance(value, ir.Expr) else ""
    sources = value.incoming_values if joins == "phi" else [value.value] if joins == "cast" else [value]
    booleans = [_is_boolean(kinds[one.name]) for one in sources if isinstance(one, ir.Var)]
    if any(booleans) and isinstance(types.unliteral(target), types.Number):
        refuse("one name stands for True or False and for numbers", loc)


def _is_boolean(kind: Any) -> bool:
    return isinstance(types.unliteral(kind), types.Boolean)


def _is_narrow(kind: Any) -> bool:
    """Whether it is an array of other numbers than those of 64 bits: to be filled and passed on, but not computed with.

    (Numba and NumPy do not agree on what such numbers become when they meet others.)
    """
    return isinstance(kind, types.Array) and kind.dtype not in (types.int64, types.float64, types.boolean)


def _check_stored(target: Any, value: Any, loc: Any) -> None:
    """Refuses to put a number into an array that may not hold it."""
    if is_real(value) and not is_real(target):
        refuse("it puts a real number in an array of whole numbers", loc)
    if _is_narrow(target) and not is_real(target) and getattr(value, "dtype", None) != target.dtype:
        known = value.literal_value if isinstance(value, types.IntegerLiteral) else -1
        if not 0 <= known < 128:  # which fits in all of them; of others some raise an error and some do not
            refuse(f"it puts a number that may not fit in an array of {target.dtype}", loc)


def _check_index(kind: Any, loc: Any) -> None:
    for part in kind if isinstance(kind, types.BaseTuple) else [kind]:
        if isinstance(part, types.Array | types.List):
            refuse("it picks by an array, or list, of indices or booleans", loc)


def _check_expression(expr: Any, kinds: Any, calltypes: Any, statement: Any) -> None:
    """Checks one operation, and replaces its operator where there is something to check."""
    loc, result = statement.loc, kinds[statement.target.name]
    if isinstance(result, types.UnicodeType) and expr.op not in ("getattr", "static_getitem", "getitem", "cast", "phi"):
        refuse("it makes text", loc)
    _check_narrow(expr, kinds, loc)
    for variable in expr.list_vars():
        kind, called = kinds[variable.name], expr.op == "call" and variable.name == expr.func.name
        if isinstance(kind, types.BoundFunction) and not called and not isinstance(kind.this, types.BaseTuple):
            refuse(f"it hands on the method {method_name(kind.typing_key)}: call it where it is", loc)
    if expr.op == "getitem":
        _check_index(kinds[expr.index.name], loc)
    elif expr.op == "getattr":
        _check_module(kinds[expr.value.name], expr.attr, loc)
        for kind, members, whose in MEMBERS:
            if isinstance(kinds[expr.value.name], kind) and expr.attr not in members:
                refuse(f"it uses {whose} {expr.attr}", loc)
    elif expr.op == "call":
        function = kinds[expr.func.name]
        to_whole = isinstance(function, types.NumberClass) and isinstance(function.dtype, types.Integer)
        if to_whole and any(is_real(kinds[part.name]) for part in expr.args):
            refuse("it makes a real number a whole one: use int()", loc)
        _check_filled(expr, function, result, kinds, loc)
        _check_call(expr, function, result, kinds, calltypes, loc)
    elif expr.op == "build_list":
        _require_no_flags(expr.items, result.dtype, kinds, loc)
    elif expr.op == "unary":
        kind = types.unliteral(kinds[expr.value.name])
        if expr.fn in NOT_WITH_BOOLEANS and _is_boolean(kind):
            refuse("it computes with True and False as if they were numbers", loc)
        if expr.fn is operator.neg and as_number(kind) == types.int64:
            expr.fn = NEGATIVE.function
            del calltypes[expr]
            calltypes[expr] = signature_of(NEGATIVE)
    elif expr.op in ("binop", "inplace_binop"):
        _check_operator(expr, result, kinds, calltypes, loc)


def _check_call(expr: Any, function: Any, result: Any, kinds: Any, calltypes: Any, loc: Any) -> None:
    """Refuses calls that would cut real numbers, take flags for numbers, or write to what machine code has frozen."""
    given = [*expr.args, *(variable for _, variable in expr.kws)]
    signature = calltypes.get(expr)
    if signature is not None and not expr.kws and len(signature.args) == len(expr.args):
        for variable, taken in zip(expr.args, signature.args, strict=True):
            if is_real(kinds[variable.name]) and isinstance(taken, types.Integer):
                refuse("it gives a real number where a whole one belongs: use int()", loc)
    key = getattr(function, "typing_key", None)
    if len(given) > _MOST_GIVEN.get(key, getattr(key, "nin", len(given))):
        refuse("it gives an array for the result, as out: assign the result, as in a[:] = np.add(b, c)", loc)
    if isinstance(key, np.ufunc) and _is_narrow(result):
        refuse("it gives True and False where numbers belong: write 1.0 * flags", loc)
    if (key is sorted or key == (types.List, "sort")) and any(name == "key" for name, _ in expr.kws):
        refuse("it sorts by a key, where Numba mixes up equal ones: write a loop", loc)
    if key in (max, min) and len(given) == 1 and isinstance(kinds[given[0].name], types.Number | types.Boolean):
        refuse(f"it calls {key.__name__} of one number", loc)
    python = function.dispatcher.py_func if isinstance(function, types.Dispatcher) else None
    if python is CALLED[round] and any(_is_boolean(kinds[one.name]) for one in given):
        refuse("it computes with True and False as if they were numbers", loc)
    if key in (max, min):
        _require_no_flags(expr.args, result, kinds, loc)
    method = getattr(function, "this", None) if isinstance(function, types.BoundFunction) else None
    if isinstance(method, types.List) and method_name(key) in ("append", "insert"):
        _require_no_flags(expr.args[-1:], method.dtype, kinds, loc)
    if isinstance(method, types.Array) and not method.mutable and method_name(key) not in READING:
        refuse(FROZEN, loc)
    shuffles = isinstance(method, types.NumPyRandomGeneratorType) and method_name(key) == "shuffle"
    if shuffles and any(isinstance(kinds[one.name], types.Array) and not kinds[one.name].mutable for one in given):
        refuse(FROZEN, loc)
    if isinstance(method, types.Array) and method_name(key) == "ravel" and method.layout != "C":
        refuse("it calls ravel of a part of an array, which may be a copy or not: use flatten, or a loop", loc)
    if isinstance(method, types.Array) and method_name(key) in ("mean", "std", "var") and not is_real(method):
        refuse("it takes the mean of whole numbers: make them real, as in (1.0 * N).mean()", loc)
    if key in (np.mean, np.std, np.var) and any(_has_whole(kinds[one.name]) for one in given[:1]):
        refuse("it takes the mean of whole numbers: make them real, as in np.mean(1.0 * N)", loc)


def _has_whole(kind: Any) -> bool:
    return isinstance(kind, types.Array) and not is_real(kind)


def _require_no_flags(variables: Any, into: Any, kinds: Any, loc: Any) -> None:
    """Refuses flags where numbers are."""
    if isinstance(into, types.Number) and any(_is_boolean(kinds[one.name]) for one in variables):
        refuse("it mixes True or False with numbers", loc)


def _check_filled(expr: Any, function: Any, result: Any, kinds: Any, loc: Any) -> None:
    """Refuses to fill an array of whole numbers with real ones, or one of few bits: what is too large is an error."""
    filled = result if getattr(function, "typing_key", None) in FILLING else None
    if isinstance(function, types.BoundFunction) and function.typing_key == (types.Array, "fill"):
        filled = function.this
    given = [kinds[variable.name] for variable in (*expr.args, *(variable for _, variable in expr.kws))]
    if isinstance(getattr(filled, "dtype", None), types.Integer) and any(map(_holds_reals, given)):
        refuse("it puts a real number in an array of whole numbers", loc)
    if _is_narrow(filled) and not is_real(filled):
        place = 0 if function.typing_key is np.array else 1
        named = [variable for name, variable in expr.kws if name in ("object", "fill_value")]
        _check_stored(filled, kinds[[*expr.args[place : place + 1], *named][0].name], loc)


def _holds_reals(kind: Any) -> bool:
    if isinstance(kind, types.BaseTuple):
        return any(map(_holds_reals, kind))
    return isinstance(getattr(kind, "dtype", kind), types.Float)


def _check_narrow(expr: Any, kinds: Any, loc: Any) -> None:
    """Refuses to compute with arrays of other numbers than those of 64 bits."""
    if expr.op in ("getattr", "getitem", "static_getitem", "build_tuple", "cast", "phi"):
        return  # single numbers are refused by their type
    called = kinds[expr.func.name] if expr.op == "call" else None
    own = isinstance(called, types.Dispatcher) or isinstance(getattr(called, "this", None), types.BaseTuple)
    if own or getattr(called, "typing_key", None) is len:
        return  # a function or method of the author's, or one that asks for no number
    for variable in expr.list_vars():
        kind = kinds[variable.name]
        if _is_narrow(kind) or _is_narrow(getattr(kind, "this", None)):
            refuse(f"it computes with numbers of type {getattr(kind, 'this', kind).dtype}", loc)


def _check_operator(expr: Any, result: Any, kinds: Any, calltypes: Any, loc: Any) -> None:
    """Refuses operators that do something else in Python, and replaces those that need a check."""
    function = expr.fn if expr.op == "binop" else expr.immutable_fn
    both = [types.unliteral(kinds[side.name]) for side in (expr.lhs, expr.rhs)]
    plain = [kind.dtype if isinstance(kind, types.Array) else kind for kind in both]
    if function in NOT_WITH_BOOLEANS and all(map(_is_boolean, plain)):
        refuse("it computes with True and False as if they were numbers", loc)
    if function in (operator.is_, operator.is_not) and not any(isinstance(kind, types.NoneType) for kind in both):
        refuse("it compares with 'is'", loc)
    _check_whole_arrays(function, expr.rhs, both, plain, kinds, loc)
    if len(both_lists := lists(expr, kinds)) == 2 and function is operator.add:
        first, second = (kind.dtype for kind in both_lists)
        if _is_boolean(first) != _is_boolean(second):
            refuse("it mixes True or False with numbers", loc)
        if expr.op == "inplace_binop" and isinstance(second, types.Float) and not isinstance(first, types.Float):
            refuse("it puts a real number in a list of whole ones: write 0.0 for 0, and so on", loc)
    if isinstance(both[0], types.Array) and expr.op == "inplace_binop":
        if not both[0].mutable:
            refuse(FROZEN, loc)
        if isinstance(both[1], types.Array | types.BaseTuple | types.List):
            refuse("it changes an array in place by another array: write a loop", loc)
        if not isinstance(plain[0], types.Float) and (is_real(both[1]) or function in (operator.truediv, operator.pow)):
            refuse("it changes an array of whole numbers in place by real ones", loc)
    operation = CHECKED.get((function, *map(as_number, both)))
    if operation:
        if types.unliteral(result) != operation.result:
            refuse("it computes with what may be True, False or None as if it were a number", loc)
        if expr.op == "binop":
            expr.fn = operation.function
        else:
            expr.immutable_fn = operation.function
        del calltypes[expr]
        calltypes[expr] = signature_of(operation)


def _check_whole_arrays(function: Any, exponent: Any, both: Any, plain: Any, kinds: Any, loc: Any) -> None:
    """Refuses powers and shifts of arrays of whole numbers: some are errors of NumPy's, some it answers with 0."""
    if not any(isinstance(kind, types.Array) for kind in both) or any(map(is_real, plain)):
        return
    known = kinds[exponent.name]
    if function is operator.pow and any(map(_is_boolean, plain)):
        refuse("it computes with True and False as if they were numbers", loc)  # NumPy's squares have 8 bits
    if function is operator.pow and not (isinstance(known, types.IntegerLiteral) and known.literal_value >= 0):
        refuse("it raises an array of whole numbers to a power that may be negative: make it real, 1.0 * N", loc)
    if function in (operator.lshift, operator.rshift):
        refuse("it shifts the bits of an array", loc)


def _check_module(kind: Any, name: str, loc: Any) -> None:
    """Refuses what is taken from a module that has another name in the code, and draws from `np.random`."""
    if isinstance(kind, types.Module):
        allowed = {"numpy": NUMPY, "math": MATH}.get(kind.pymod.__name__)
        if name == "random" or "random" in kind.pymod.__name__.split("."):
            refuse("it draws from np.random, which no seed of a run reaches: draw from rng", loc)
        if allowed is not None and name not in allowed:
            refuse(f"it uses {kind.pymod.__name__}.{name}", loc)

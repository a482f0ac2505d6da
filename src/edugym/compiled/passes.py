"""What Numba does besides with code that is not the package's own: judge it, and put checked arithmetic into it.

These are passes in Numba's pipeline (`edugym.compiled.pipelines`). Before types are known: every variable must have a
value wherever it is used, and functions of `math` and the like are replaced. Afterwards: every value must be of a type,
and every operation of a kind, that machine code treats as Python does, and operators of whole numbers are replaced. See
`edugym.compiled.subset` and `edugym.compiled.arithmetic`.
"""

import importlib
import math
import operator
from collections.abc import Iterator
from enum import Enum
from types import ModuleType
from typing import Any

import numpy as np

from edugym.compiled.arithmetic import CALLED, CHECKED, DRAWN, EXTREMES, REPLACED
from edugym.compiled.subset import place, words
from edugym.compiled.turns import count_turns

ir: Any = importlib.import_module("numba.core.ir")
types: Any = importlib.import_module("numba.core.types")
typing: Any = importlib.import_module("numba.core.typing")
analysis: Any = importlib.import_module("numba.core.analysis")
ir_utils: Any = importlib.import_module("numba.core.ir_utils")


class Refused(Exception):
    """Something is not in the subset that may be compiled: `str(error)` says what, and where."""


ARRAY = words(
    "T all any argmax argmin copy cumsum dot fill flatten max mean min ndim prod ravel reshape shape size std"
)
ARRAY |= words("sum var")
DRAWS = words("exponential integers normal permutation random shuffle standard_exponential standard_normal uniform")
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
NEVER_NONE = words("initial transition reward terminal observation act greedy")
"""Methods of MDPs and agents that have to return something."""
OF_64_BITS: dict[Any, Any] = {int: np.int64, float: np.float64, bool: np.bool_}
"""What Numba calls the types of arrays that are named by types of Python."""
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


def _refuse(found: str, loc: Any) -> None:
    raise Refused(f"{found} ({place(loc.filename, loc.line)})")


def _statements(func_ir: Any) -> Iterator[tuple[Any, Any]]:
    for block in func_ir.blocks.values():
        for statement in list(block.body):
            yield block, statement


def before_typing(state: Any) -> bool:
    """Refuse variables without a value, and replace functions."""
    _all_assigned(state.func_ir)
    if state.func_ir.func_id.func_name in NEVER_NONE:
        _stop_at_none(state.func_ir)
    for block, statement in _statements(state.func_ir):
        value = getattr(statement, "value", None)
        if isinstance(statement, ir.Assign) and isinstance(value, ir.Expr):
            if value.op == "make_function":
                _refuse("it has a function, or a lambda, inside a function", statement.loc)
            library = _global(state.func_ir, value.value) if value.op == "getattr" else None
            if library is math or library is np:
                _stand_in(statement, getattr(library, value.attr, None))
            elif value.op == "call":
                _write_out(state.func_ir, block, statement)
                _replace_called(state.func_ir, block, statement)
        elif isinstance(value, ir.Global | ir.FreeVar):
            _stand_in(statement, value.value)
    count_turns(state.func_ir, foreign=True)
    return True


def _stop_at_none(func_ir: Any) -> None:
    """Raise an error where nothing is returned: the interpreter then says so, and all other ways return one type."""
    last = [(block, block.terminator) for block in func_ir.blocks.values()]
    returns = [(block, end) for block, end in last if isinstance(end, ir.Return)]
    nothing = [(block, end) for block, end in returns if _returns_none(func_ir, end.value)]
    for block, end in nothing if len(nothing) < len(returns) else []:
        block.body[-1] = ir.StaticRaise(ValueError, ("nothing is returned",), end.loc)


def _returns_none(func_ir: Any, variable: Any) -> bool:
    cast = ir_utils.guard(ir_utils.get_definition, func_ir, variable)
    value = ir_utils.guard(ir_utils.get_definition, func_ir, cast.value) if getattr(cast, "op", "") == "cast" else cast
    return isinstance(value, ir.Const) and value.value is None


def own_before_typing(state: Any) -> bool:
    """Let every `while` be stopped."""
    count_turns(state.func_ir, foreign=False)
    return True


def _global(func_ir: Any, variable: Any) -> Any:
    definition = ir_utils.guard(ir_utils.get_definition, func_ir, variable)
    if isinstance(definition, ir.Expr) and definition.op == "getattr":
        owner = _global(func_ir, definition.value)
        return getattr(owner, definition.attr, None) if isinstance(owner, ModuleType) else None
    return definition.value if isinstance(definition, ir.Global | ir.FreeVar) else None


def _stand_in(statement: Any, value: Any) -> None:
    if not isinstance(value, ModuleType | list | dict | set) and (function := _entry(REPLACED, value)):
        statement.value = ir.Global(function.__name__, function, statement.loc)


def _entry(table: dict[Any, Any], value: Any) -> Any:
    try:
        return table.get(value)
    except TypeError:  # it has no hash
        return None


def _write_out(func_ir: Any, block: Any, statement: Any) -> None:
    """Write the arguments of a call as Numba knows them: types of arrays, the start of `enumerate`, and defaults."""
    call = statement.value
    for given in (*call.args, *(variable for _, variable in call.kws)):
        kind = ir_utils.guard(ir_utils.get_definition, func_ir, given)
        if isinstance(kind, ir.Global) and (named := _entry(OF_64_BITS, kind.value)):
            kind.value = named
    called = _global(func_ir, call.func)
    if called is enumerate:
        call.args, call.kws = [*call.args, *(variable for _, variable in call.kws)], ()
    elif isinstance(called, type) and issubclass(called, tuple) and hasattr(called, "_field_defaults"):
        _give_defaults(func_ir, block, statement, called)


def _replace_called(func_ir: Any, block: Any, statement: Any) -> None:
    """Let a call of `int`, or of a method such as `rng.normal`, be a call of what stands for it."""
    call = statement.value
    definition = ir_utils.guard(ir_utils.get_definition, func_ir, call.func)
    if isinstance(definition, ir.Expr) and definition.op == "getattr":
        if isinstance(_global(func_ir, definition.value), ModuleType):
            return  # a function of a module, which may have any name
        table = DRAWN if call.args or call.kws else {**DRAWN, **EXTREMES}
        if definition.attr not in table:
            return
        function, before = table[definition.attr], [definition.value]
    elif isinstance(definition, ir.Global | ir.FreeVar) and (function := _entry(CALLED, definition.value)):
        before = []
        if definition.value is round and len(call.args) + len(call.kws) > 1:
            _refuse("it rounds to decimals", statement.loc)
        given = ir_utils.guard(ir_utils.get_definition, func_ir, call.args[0]) if call.args else None
        if not call.args or (isinstance(given, ir.Const) and isinstance(given.value, str)):
            return  # int(), float("inf")
    else:
        return
    call.func, call.args = _constant(func_ir, block, statement, function), [*before, *call.args]


def _constant(func_ir: Any, block: Any, statement: Any, value: Any) -> Any:
    """A variable that holds the value, assigned before the statement."""
    variable = ir.Var(block.scope, ir_utils.mk_unique_var("$checked"), statement.loc)
    assign = ir.Assign(ir.Global(variable.name, value, statement.loc), variable, statement.loc)
    block.body.insert(block.body.index(statement), assign)
    func_ir._definitions[variable.name].append(assign.value)
    return variable


def _give_defaults(func_ir: Any, block: Any, statement: Any, kind: Any) -> None:
    """Let a NamedTuple be made of all its fields: Numba would make a shorter one where defaults are left out."""
    call = statement.value
    if call.vararg is None:
        given = {*kind._fields[: len(call.args)], *(name for name, _ in call.kws)}
        missing = {name: value for name, value in kind._field_defaults.items() if name not in given}
        for name, value in missing.items():
            fits = -(2**63) <= value < 2**63 if isinstance(value, int) else isinstance(value, float | str | Enum | None)
            if not fits:
                _refuse(f"it makes a {kind.__name__} without {name}", statement.loc)
        more = [(name, _constant(func_ir, block, statement, value)) for name, value in missing.items()]
        call.kws = [*call.kws, *more]


def _all_assigned(func_ir: Any) -> None:
    """Refuse a variable that has no value on some way to where it is used."""
    blocks = func_ir.blocks
    graph = analysis.compute_cfg_from_blocks(blocks)
    everything = {s.target.name for _, s in _statements(func_ir) if isinstance(s, ir.Assign)}
    after: dict[Any, set[str]] = {}

    def before(label: Any) -> set[str]:
        incoming = [after.get(source, everything) for source, _ in graph.predecessors(label)]
        return set.intersection(*incoming) if incoming and label != graph.entry_point() else set()

    changed = True
    while changed:
        changed = False
        for label in graph.topo_order():
            assigned = before(label) | {s.target.name for s in blocks[label].body if isinstance(s, ir.Assign)}
            if after.get(label) != assigned:
                after[label], changed = assigned, True
    for label in graph.topo_order():
        assigned = set(before(label))
        for statement in blocks[label].body:
            if not isinstance(statement, ir.Del):
                used = statement.value if isinstance(statement, ir.Assign) else statement
                variables = (
                    [used] if isinstance(used, ir.Var) else used.list_vars() if hasattr(used, "list_vars") else []
                )
                for variable in variables:
                    if variable.name in everything and variable.name not in assigned and not variable.is_temp:
                        _refuse(f"the variable {variable.unversioned_name} may have no value", statement.loc)
            if isinstance(statement, ir.Assign):
                assigned.add(statement.target.name)


def after_typing(state: Any) -> bool:
    """Refuse types and operations, and replace operators."""
    kinds = state.typemap
    for block, statement in _statements(state.func_ir):
        if isinstance(statement, ir.Assign):
            _judge_type(kinds[statement.target.name], statement.loc)
            _judge_flag(statement.value, kinds, kinds[statement.target.name], statement.loc)
            if isinstance(statement.value, ir.Expr):
                _judge(statement.value, kinds, state.calltypes, statement)
        elif isinstance(statement, ir.Return):
            _judge_flag(statement.value, kinds, state.return_type, statement.loc)
        elif isinstance(statement, ir.SetItem | ir.StaticSetItem):
            index = getattr(statement, "index_var", None) or statement.index
            _judge_index(kinds[index.name] if isinstance(index, ir.Var) else None, statement.loc)
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
        return _refuse("it calls itself", loc)
    if isinstance(kind, types.Pair):
        return _judge_type(kind.first_type, loc)
    if isinstance(kind, types.BaseTuple):
        for part in kind:
            _judge_type(part, loc)
        return None
    if isinstance(kind, types.Number | types.Boolean):
        if kind not in (types.int64, types.intp, types.float64, types.boolean):
            _refuse(f"it computes with numbers of type {kind}", loc)
        return None
    if isinstance(kind, types.Array):
        if not isinstance(kind.dtype, types.Number | types.Boolean) or isinstance(kind.dtype, types.Complex):
            _refuse(f"it has an array of {kind.dtype}", loc)
        return None
    if isinstance(kind, types.List):
        if not isinstance(kind.dtype, types.Number | types.Boolean):
            _refuse("it makes a list of other things than numbers", loc)
        return _judge_type(kind.dtype, loc)
    if isinstance(kind, types.Poison | types.LiteralList):
        _refuse("it makes a list of other things than numbers", loc)
    if isinstance(kind, types.NumpyFlatType) or not isinstance(kind, FITTING):
        _refuse("it uses .flat" if isinstance(kind, types.NumpyFlatType) else f"it makes a value of type {kind}", loc)
    return None


def _judge_flag(value: Any, kinds: Any, target: Any, loc: Any) -> None:
    """Refuse to make a number of a boolean that Python leaves as it is, since `Q[True]` is not `Q[1]`."""
    joins = value.op if isinstance(value, ir.Expr) else ""
    sources = value.incoming_values if joins == "phi" else [value.value] if joins == "cast" else [value]
    flags = [isinstance(types.unliteral(kinds[one.name]), types.Boolean) for one in sources if isinstance(one, ir.Var)]
    if any(flags) and isinstance(types.unliteral(target), types.Number):
        _refuse("one name stands for True or False and for numbers", loc)


def _narrow(kind: Any) -> bool:
    """Whether it is an array of other numbers than those of 64 bits: to be filled and passed on, but not computed with.

    (Numba and NumPy do not agree on what such numbers become when they meet others.)
    """
    return isinstance(kind, types.Array) and kind.dtype not in (types.int64, types.float64, types.boolean)


def _judge_stored(target: Any, value: Any, loc: Any) -> None:
    """Look at what is put into an array."""
    if _real(value) and not _real(target):
        _refuse("it puts a real number in an array of whole numbers", loc)
    if _narrow(target) and not _real(target) and getattr(value, "dtype", None) != target.dtype:
        known = value.literal_value if isinstance(value, types.IntegerLiteral) else -1
        if not 0 <= known < 128:  # which fits in all of them; of others some raise an error and some do not
            _refuse(f"it puts a number that may not fit in an array of {target.dtype}", loc)


def _real(kind: Any) -> bool:
    return isinstance(kind, types.Float) or (isinstance(kind, types.Array) and isinstance(kind.dtype, types.Float))


def _judge_index(kind: Any, loc: Any) -> None:
    for part in kind if isinstance(kind, types.BaseTuple) else [kind]:
        if isinstance(part, types.Array | types.List):
            _refuse("it picks by an array, or list, of indices or booleans", loc)


def _judge(expr: Any, kinds: Any, calltypes: Any, statement: Any) -> None:
    """Look at one operation, and replace its operator where there is something to check."""
    loc, result = statement.loc, kinds[statement.target.name]
    if isinstance(result, types.UnicodeType) and expr.op not in ("getattr", "static_getitem", "getitem", "cast", "phi"):
        _refuse("it makes text", loc)
    _judge_narrow(expr, kinds, loc)
    if expr.op in ("getitem", "static_getitem"):
        _judge_index(kinds[expr.index.name] if expr.op == "getitem" else None, loc)
    elif expr.op == "getattr":
        for kind, members, whose in MEMBERS:
            if isinstance(kinds[expr.value.name], kind) and expr.attr not in members:
                _refuse(f"it uses {whose} {expr.attr}", loc)
    elif expr.op == "call":
        function = kinds[expr.func.name]
        to_whole = isinstance(function, types.NumberClass) and isinstance(function.dtype, types.Integer)
        if to_whole and any(_real(kinds[part.name]) for part in expr.args):
            _refuse("it makes a real number a whole one: use int()", loc)
        _judge_filled(expr, function, result, kinds, loc)
    elif expr.op == "unary":
        if expr.fn in BOOLEANS and isinstance(types.unliteral(kinds[expr.value.name]), types.Boolean):
            _refuse("it computes with True and False as if they were numbers", loc)
    elif expr.op in ("binop", "inplace_binop"):
        _judge_operator(expr, kinds, calltypes, loc)


def _judge_filled(expr: Any, function: Any, result: Any, kinds: Any, loc: Any) -> None:
    """Refuse to fill an array of whole numbers with real ones: NaN and large ones are errors in Python."""
    filled = result if getattr(function, "typing_key", None) in FILLING else None
    if isinstance(function, types.BoundFunction) and function.typing_key == (types.Array, "fill"):
        filled = function.this
    given = [kinds[variable.name] for variable in (*expr.args, *(variable for _, variable in expr.kws))]
    if isinstance(getattr(filled, "dtype", None), types.Integer) and any(map(_holds_reals, given)):
        _refuse("it puts a real number in an array of whole numbers", loc)


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
            _refuse(f"it computes with numbers of type {getattr(kind, 'this', kind).dtype}", loc)


def _judge_operator(expr: Any, kinds: Any, calltypes: Any, loc: Any) -> None:
    function = expr.fn if expr.op == "binop" else expr.immutable_fn
    both = [types.unliteral(kinds[side.name]) for side in (expr.lhs, expr.rhs)]
    plain = [kind.dtype if isinstance(kind, types.Array) else kind for kind in both]
    if function in BOOLEANS and all(isinstance(kind, types.Boolean) for kind in plain):
        _refuse("it computes with True and False as if they were numbers", loc)
    if function in (operator.is_, operator.is_not) and not any(isinstance(kind, types.NoneType) for kind in both):
        _refuse("it compares with 'is'", loc)
    if isinstance(both[0], types.Array) and expr.op == "inplace_binop":
        if isinstance(both[1], types.Array | types.BaseTuple | types.List):
            _refuse("it changes an array in place by another array: write a loop", loc)
        if not isinstance(plain[0], types.Float) and (_real(both[1]) or function in (operator.truediv, operator.pow)):
            _refuse("it changes an array of whole numbers in place by real ones", loc)
    operation = CHECKED.get((function, *both))
    if operation:
        if expr.op == "binop":
            expr.fn = operation.function
        else:
            expr.immutable_fn = operation.function
        del calltypes[expr]
        calltypes[expr] = typing.signature(operation.result, *operation.kinds)

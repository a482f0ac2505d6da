"""Puts statements into the code that Numba has typed: the checks that machine code makes while it runs."""

from typing import Any

from numba.core import ir, ir_utils, types

from edugym.compiled.operations import signature_of


def insert_call(state: Any, block: Any, before: Any, function: Any, variable: Any) -> None:
    """Adds a call of a function that raises an error where a value is not what it must be."""
    called = insert_name(state, block, before, function)
    call = ir.Expr.call(called, [variable], (), before.loc)
    kind = state.typemap[called.name]
    state.calltypes[call] = kind.get_call_type(state.typingctx, (state.typemap[variable.name],), {})
    _insert(state, block, before, call, types.none)


def insert_name(state: Any, block: Any, before: Any, function: Any) -> Any:
    """Adds a variable that holds a function, so that it can be called, and returns it."""
    named = ir.Global(function.__name__, function, before.loc)
    return _insert(state, block, before, named, state.typingctx.resolve_value_type(function))


def insert_operation(state: Any, block: Any, before: Any, operation: Any, variable: Any) -> None:
    """Adds a checked operation of one number, before a statement or, with None, at the end of the block."""
    expr = ir.Expr.unary(operation.function, variable, (before or block).loc)
    state.calltypes[expr] = signature_of(operation)
    _insert(state, block, before, expr, operation.result)


def _insert(state: Any, block: Any, before: Any, value: Any, kind: Any) -> Any:
    """Assigns a value to a new variable of a type, and returns the variable."""
    target = ir.Var(block.scope, ir_utils.mk_unique_var("$check"), value.loc)
    place = len(block.body) - 1 if before is None else block.body.index(before)
    block.body.insert(place, ir.Assign(value, target, value.loc))
    state.typemap[target.name] = kind
    state.func_ir._definitions[target.name].append(value)
    return target

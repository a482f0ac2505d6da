"""A compiler pass over students' code before types are known: refuses or replaces what Numba would do otherwise.

Every variable must have a value wherever it is used. Functions of `math`, `np` and `rng` are replaced by those of
`edugym.compiled.arithmetic` and `edugym.compiled.draws`, and arguments are written in the form that Numba supports.
Once types are known, `edugym.compiled.typed_checks` goes on.
"""

import inspect
import math
import operator
from collections.abc import Iterator
from enum import Enum
from types import BuiltinFunctionType, FunctionType, ModuleType
from typing import Any

import numpy as np
from numba.core import analysis, ir, ir_utils

from edugym.compiled.arithmetic import CALLED, EXTREMES, REPLACED
from edugym.compiled.byte_code import place
from edugym.compiled.code import LIBRARIES
from edugym.compiled.draws import DRAWN
from edugym.compiled.interrupt_polling import insert_polling
from edugym.compiled.subset import words
from edugym.system.packages import package_of


class Refused(Exception):
    """Code is not in the subset that may be compiled: `str(error)` says what, and where.

    Attributes:
        method: the method of a student's class where the place is; None where the message names the place.
    """

    method: str | None = None


FROZEN = "it writes to an array that is no field, or that may only be read: pass it, or a copy of it, as a field"
NEVER_NONE = words("initial transition reward terminal observation act greedy")
"""Methods of MDPs and agents that have to return something."""
NUMPY_TYPE: dict[Any, Any] = {int: np.int64, float: np.float64, bool: np.bool_}
"""The types of arrays that Python's types stand for, as in `np.zeros(3, int)`."""


def refuse(found: str, loc: Any) -> None:
    """Raises `Refused`, with the place of the line."""
    raise Refused(f"{found} ({place(loc.filename, loc.line)})")


def statements(func_ir: Any) -> Iterator[tuple[Any, Any]]:
    """All statements of a function, each with its block, whose body may be changed while iterating."""
    for block in func_ir.blocks.values():
        for statement in list(block.body):
            yield block, statement


def check_untyped(state: Any) -> bool:
    """Refuses variables without a value, replaces functions, and adds polling: the pass for students' code."""
    _require_values(state.func_ir)
    if state.func_ir.func_id.func_name in NEVER_NONE:
        _raise_instead_of_none(state.func_ir)
    for block, statement in statements(state.func_ir):
        value = getattr(statement, "value", None)
        if isinstance(statement, ir.Assign) and isinstance(value, ir.Expr):
            _require_called(state.func_ir, value, statement.loc)
            if value.op == "inplace_binop" and _may_be_frozen(state.func_ir, value.lhs):
                refuse(FROZEN, statement.loc)  # Numba stumbles over it
            if value.op == "make_function":
                refuse("it has a function, or a lambda, inside a function", statement.loc)
            library = _global(state.func_ir, value.value) if value.op == "getattr" else None
            if library is math or library is np:
                _replace_function(statement, getattr(library, value.attr, None))
            elif value.op == "call" and _global(state.func_ir, value.func) is pow and len(value.args) == 2:
                statement.value = ir.Expr.binop(operator.pow, *value.args, value.loc)  # a keyword is refused by Numba
            elif value.op == "call":
                _require_arguments(_global(state.func_ir, value.func), value, statement.loc)
                _rewrite_arguments(state.func_ir, block, statement)
                _replace_call(state.func_ir, block, statement)
        elif isinstance(value, ir.Global | ir.FreeVar):
            _replace_function(statement, value.value)
    insert_polling(state.func_ir, foreign=True)
    return True


def finish_own(state: Any) -> bool:
    """Adds polling to every `while`, and lets `rng.integers` draw no array: the pass for the package's own code.

    What makes an array needs reference counts, with which all of a loop is several times slower.
    """
    for block, statement in statements(state.func_ir):
        call = getattr(statement, "value", None)
        if isinstance(call, ir.Expr) and call.op == "call":
            method = _definition(state.func_ir, call.func)
            if isinstance(method, ir.Expr) and method.op == "getattr" and method.attr == "integers":
                _call_instead(state.func_ir, block, statement, DRAWN["integers"], method.value)
    insert_polling(state.func_ir, foreign=False)
    return True


def _require_values(func_ir: Any) -> None:
    """Refuses a variable that has no value on some way to where it is used."""
    blocks = func_ir.blocks
    graph = analysis.compute_cfg_from_blocks(blocks)
    everything = {s.target.name for _, s in statements(func_ir) if isinstance(s, ir.Assign)}
    after: dict[Any, set[str]] = {}  # the variables that have a value at the end of a block

    def before(label: Any) -> set[str]:
        incoming = [after.get(source, everything) for source, _ in graph.predecessors(label)]
        return set.intersection(*incoming) if incoming and label != graph.entry_point() else set()

    changed = True
    while changed:
        changed = False
        for label in graph.topo_order():
            assigned = set(before(label))
            for statement in blocks[label].body:
                _follow_values(statement, assigned, everything)
            if after.get(label) != assigned:
                after[label], changed = assigned, True
    for label in graph.topo_order():
        assigned = set(before(label))
        for statement in blocks[label].body:
            for variable in _variables_used(statement):
                if variable.name in everything and variable.name not in assigned and not variable.is_temp:
                    refuse(f"the variable {variable.unversioned_name} may have no value", statement.loc)
            _follow_values(statement, assigned, everything)


def _follow_values(statement: Any, assigned: set[str], everything: set[str]) -> None:
    """Follows which variables have a value: changes the set of them as a statement does.

    Since Python 3.12 a list comprehension runs in the function that it stands in. It sets its variable aside, which may
    have no value yet, and puts it back at the end.
    """
    if isinstance(statement, ir.Assign):
        value = statement.value
        of_none = isinstance(value, ir.Var) and value.is_temp and value.name in everything - assigned
        if of_none or getattr(value, "op", "") == "undef":
            assigned.discard(statement.target.name)
        else:
            assigned.add(statement.target.name)


def _variables_used(statement: Any) -> list[Any]:
    used = statement.value if isinstance(statement, ir.Assign) else statement
    if isinstance(used, ir.Var):
        return [used]
    return used.list_vars() if hasattr(used, "list_vars") and not isinstance(used, ir.Del) else []


def _raise_instead_of_none(func_ir: Any) -> None:
    """Makes a branch without `return` raise, so that the others have a single type; the replay explains it."""
    last = [(block, block.terminator) for block in func_ir.blocks.values()]
    returns = [(block, end) for block, end in last if isinstance(end, ir.Return)]
    nothing = [(block, end) for block, end in returns if _returns_none(func_ir, end.value)]
    for block, end in nothing if len(nothing) < len(returns) else []:
        block.body[-1] = ir.StaticRaise(ValueError, ("nothing is returned",), end.loc)


def _returns_none(func_ir: Any, variable: Any) -> bool:
    cast = _definition(func_ir, variable)
    value = _definition(func_ir, cast.value) if getattr(cast, "op", "") == "cast" else cast
    return isinstance(value, ir.Const) and value.value is None


def _definition(func_ir: Any, variable: Any) -> Any:
    """What is assigned to a variable, or None if it is assigned more than once."""
    return ir_utils.guard(ir_utils.get_definition, func_ir, variable)


def _global(func_ir: Any, variable: Any) -> Any:
    """The value of a global name, or of what a module has, if the variable stands for one."""
    definition = _definition(func_ir, variable)
    if isinstance(definition, ir.Expr) and definition.op == "getattr":
        owner = _global(func_ir, definition.value)
        return getattr(owner, definition.attr, None) if isinstance(owner, ModuleType) else None
    return definition.value if isinstance(definition, ir.Global | ir.FreeVar) else None


def _may_be_frozen(func_ir: Any, variable: Any) -> bool:
    """Whether a variable may stand for an array that has a global name, or for a part of it."""
    seen, open_names = set[str](), [variable.name]
    while open_names:
        name = open_names.pop()
        for definition in () if name in seen else func_ir._definitions[name]:
            if isinstance(definition, ir.Global | ir.FreeVar) and isinstance(definition.value, np.ndarray):
                return True
            if isinstance(definition, ir.Var):
                open_names.append(definition.name)
            elif isinstance(definition, ir.Expr) and definition.op in ("getitem", "static_getitem"):
                open_names.append(definition.value.name)
        seen.add(name)
    return False


def _replace_function(statement: Any, value: Any) -> None:
    """Puts a checked function in the place of one of `math` or `np`."""
    if function := _entry(REPLACED, value):
        statement.value = ir.Global(function.__name__, function, statement.loc)


def _entry(table: dict[Any, Any], value: Any) -> Any:
    try:
        return table.get(value)
    except TypeError:  # it has no hash
        return None


def _require_called(func_ir: Any, expr: Any, loc: Any) -> None:
    """Refuses to hand on what is replaced where it is called, such as `abs`; the type of an array is no function."""
    called = expr.op == "call" and _global(func_ir, expr.func)
    of_own = isinstance(called, FunctionType) and package_of(called) not in LIBRARIES
    for variable in expr.list_vars():
        value = _global(func_ir, variable) if expr.op != "call" or variable.name != expr.func.name else None
        is_type = expr.op == "call" and not of_own and _entry(NUMPY_TYPE, value)
        if value is not None and not is_type and (value is pow or _entry(CALLED, value)):
            refuse(f"it hands on the function {value.__name__}: call it by its name", loc)


def _require_arguments(called: Any, call: Any, loc: Any) -> None:
    """Refuses what Python's own functions do not take: what stands for them in machine code may take it."""
    known = isinstance(called, BuiltinFunctionType) or _entry(REPLACED, called) or _entry(CALLED, called)
    if not known or call.vararg is not None:
        return
    try:
        inspect.signature(called).bind(*call.args, **dict(call.kws))
    except TypeError:
        refuse(f"it calls {called.__name__} with other arguments than it takes", loc)
    except ValueError:  # it does not tell
        if called.__module__ == "math" and call.kws:
            refuse(f"it calls {called.__name__} with other arguments than it takes", loc)


def _rewrite_arguments(func_ir: Any, block: Any, statement: Any) -> None:
    """Writes arguments in the form that Numba supports: types of arrays, the start of `enumerate`, and defaults."""
    call = statement.value
    for given in (*call.args, *(variable for _, variable in call.kws)):
        kind = _definition(func_ir, given)
        if isinstance(kind, ir.Global) and (named := _entry(NUMPY_TYPE, kind.value)):
            kind.value = named
    called = _global(func_ir, call.func)
    if called is range and call.vararg is not None:
        refuse("it calls range with a star: write its ends", statement.loc)
    elif called is range and len(call.args) > 1:
        # The differences are not used: they are errors where they leave 64 bits, as the length of the range would.
        start, stop, *step = call.args
        for first, last in [(stop, start), (start, stop)][: 1 + len(step)]:
            _assigned(func_ir, block, statement, ir.Expr.binop(operator.sub, first, last, statement.loc))
    elif called is enumerate:
        call.args, call.kws = [*call.args, *(variable for _, variable in call.kws)], ()
    elif called is zip and call.kws:
        refuse("it calls zip with strict", statement.loc)
    elif isinstance(called, type) and issubclass(called, tuple) and hasattr(called, "_field_defaults"):
        _add_defaults(func_ir, block, statement, called)


def _add_defaults(func_ir: Any, block: Any, statement: Any, kind: Any) -> None:
    """Passes every field of a NamedTuple explicitly: Numba would drop those left to their defaults."""
    call = statement.value
    if call.vararg is None:
        given = {*kind._fields[: len(call.args)], *(name for name, _ in call.kws)}
        missing = {name: value for name, value in kind._field_defaults.items() if name not in given}
        for name, value in missing.items():
            fits = -(2**63) <= value < 2**63 if isinstance(value, int) else isinstance(value, float | str | Enum | None)
            if not fits:
                refuse(f"it makes a {kind.__name__} without {name}", statement.loc)
        more = [(name, _assigned(func_ir, block, statement, value)) for name, value in missing.items()]
        call.kws = [*call.kws, *more]


def _replace_call(func_ir: Any, block: Any, statement: Any) -> None:
    """Replaces a call of `int`, or of a method such as `rng.normal`, by a call of the checked function."""
    call = statement.value
    definition = _definition(func_ir, call.func)
    function, owner = None, None
    if isinstance(definition, ir.Expr) and definition.op == "getattr":
        function, owner = _checked_method(func_ir, definition, call), definition.value
    elif isinstance(definition, ir.Global | ir.FreeVar):
        function = _checked_builtin(func_ir, definition.value, statement)
    if function is not None:
        _call_instead(func_ir, block, statement, function, owner)


def _call_instead(func_ir: Any, block: Any, statement: Any, function: Any, owner: Any) -> None:
    """Calls another function in a statement; that of a method gets the owner first."""
    call = statement.value
    owners = [] if owner is None else [owner]
    call.func, call.args = _assigned(func_ir, block, statement, function), [*owners, *call.args]


def _checked_method(func_ir: Any, method: Any, call: Any) -> Any:
    """The function that replaces a method; None if the method stays."""
    if isinstance(_global(func_ir, method.value), ModuleType):
        return None  # a function of a module, which may have any name
    table = DRAWN if call.args or call.kws else {**DRAWN, **EXTREMES}
    return table.get(method.attr)


def _checked_builtin(func_ir: Any, called: Any, statement: Any) -> Any:
    """The function that replaces a built-in one such as `int`; None if that stays."""
    call, function = statement.value, _entry(CALLED, called)
    if function is None:
        return None
    if called is round and len(call.args) + len(call.kws) > 1:
        refuse("it rounds to decimals", statement.loc)
    given = _definition(func_ir, call.args[0]) if call.args else None
    is_text = isinstance(given, ir.Const) and isinstance(given.value, str)
    return function if call.args and not is_text else None  # int() and float("inf") stay


def _assigned(func_ir: Any, block: Any, statement: Any, value: Any) -> Any:
    """A new variable to which the value, or that of an expression, is assigned before the statement."""
    variable = ir.Var(block.scope, ir_utils.mk_unique_var("$checked"), statement.loc)
    given = value if isinstance(value, ir.Expr) else ir.Global(variable.name, value, statement.loc)
    assign = ir.Assign(given, variable, statement.loc)
    block.body.insert(block.body.index(statement), assign)
    func_ir._definitions[variable.name].append(assign.value)
    return variable

"""Writes calls in JavaScript: of Python's functions and a student's own; `libraries` writes those of other modules.

A call gives what Python gives, or it ends in doubt and the interpreter repeats it.
"""

import ast
import math
import sys
from collections.abc import Callable
from inspect import Parameter, getattr_static, signature
from types import FunctionType
from typing import Any

import numpy as np

from edugym.compiled.javascript.base import Base
from edugym.compiled.javascript.iterations import Iterations
from edugym.compiled.javascript.kinds import (
    ARRAYS,
    BOOL,
    FLOAT,
    INT,
    MIXED,
    NEVER,
    NUMBERS,
    RNG,
    Array,
    Code,
    List,
    Static,
    Tuple,
    described,
)
from edugym.compiled.javascript.libraries import AS_NUMPY, Given, Named, draw, of_array, of_math, of_numpy
from edugym.compiled.javascript.operations import Operations
from edugym.mdp.membership import wholeness

NUMPY_FUNCTIONS: frozenset[Any] = frozenset(value for value in vars(np).values() if isinstance(value, FunctionType))
"""The functions of NumPy that are written in Python."""


OF_ALL = (list, tuple, sum, max, min, any, all, sorted, len)
"""Functions of one list, tuple, array or range."""


def call(writer: Iterations, node: ast.Call) -> Code:
    """Writes a call.

    Raises:
        Untranslatable: the call has no translation that does the same for sure.
    """
    if any(isinstance(one, ast.Starred) for one in node.args) or any(one.arg is None for one in node.keywords):
        raise writer.refused(node, "it calls a function with *")
    function, owner = node.func, None
    if isinstance(function, ast.Attribute):
        owner = writer.visit(function.value)
        if not isinstance(owner.kind, Static):
            given = [writer.visit(one) for one in node.args]
            return _method(writer, node, owner, function.attr, given, _named(writer, node))
    called = writer.visit(function).kind
    if not isinstance(called, Static):
        raise writer.refused(node, f"it calls {described(called)}")
    if isinstance(called.value, type) and issubclass(called.value, Exception):
        return Code("null", NEVER)
    first = node.args[0].value if node.args and isinstance(node.args[0], ast.Constant) else None
    if called.value is float and isinstance(first, str):
        return writer.constant(node, float(first), "float")
    if called.value in OF_ALL and len(node.args) == 1 and not node.keywords:
        return _of_all(writer, node, called.value)
    given, named = [writer.visit(one) for one in node.args], _named(writer, node)
    return _function(writer, node, called.value, given, named)


def _named(writer: Base, node: ast.Call) -> Named:
    return {str(one.arg): writer.visit(one.value) for one in node.keywords}


def _function(writer: Operations, node: ast.Call, called: Any, given: Given, named: Named) -> Code:
    if isinstance(called, FunctionType) and called not in NUMPY_FUNCTIONS and called is not wholeness:
        return own_function(writer, node, called, given, named)
    if isinstance(called, type) and issubclass(called, tuple) and hasattr(called, "_fields"):
        return _new(writer, node, called, given, named)
    name = ast.unparse(node.func)
    table = BUILTINS.get(called) if _hashable(called) else None
    if table is not None and not named and len(given) in GIVEN.get(called, (len(given),)):
        made = table(writer, node, given)
        if made is not None:
            return made
    in_math = next((key for key in vars(math) if vars(math)[key] is called), None)
    in_numpy = next((key for key in vars(np) if vars(np)[key] is called), None)
    if in_math is not None and not named:
        return of_math(writer, node, in_math, given)
    if in_numpy is not None:
        made = of_numpy(writer, node, AS_NUMPY.get(in_numpy, in_numpy), given, named)
        if made is not None:
            return made
    elsewhere = table or in_math or in_numpy or called in (*OF_ALL, range, enumerate, zip)
    raise writer.refused(node, f"it uses {name}{' like this' if elsewhere else ''}")


def _hashable(value: Any) -> bool:
    try:
        hash(value)
    except TypeError:
        return False
    return True


# A student's own functions, methods and classes


def own_function(writer: Base, node: ast.AST, called: FunctionType, given: Given, named: Named) -> Code:
    """Writes a call of a plain function."""
    parameters = signature(called).parameters
    if any(one.kind in (Parameter.VAR_POSITIONAL, Parameter.VAR_KEYWORD) for one in parameters.values()):
        raise writer.refused(node, f"it calls {called.__name__}, which takes *")
    begin, order = "", [name for name in parameters if name in named]
    if order != list(named):  # all is evaluated in the order of the call, before the call
        held = {name: Code(writer.fresh(), code.kind) for name, code in [*enumerate(given), *named.items()]}
        begin = "".join(f"{held[name].text}={code.text}," for name, code in [*enumerate(given), *named.items()])
        given, named = [held[k] for k in range(len(given))], {name: held[name] for name in named}
    try:
        bound = signature(called).bind(*given, **named).arguments
    except TypeError as error:
        raise writer.refused(node, f"it calls {called.__name__} otherwise than it is defined: {error}") from error
    codes = {
        name: bound[name] if name in bound else writer.constant(node, parameter.default, name)
        for name, parameter in parameters.items()
    }
    kinds = {name: code.kind for name, code in codes.items()}
    never = Code("(()=>doubt('never reached'))", NEVER)
    function = never if NEVER in kinds.values() else writer.known.function(called, kinds)
    if function is None:
        raise writer.refused(node, f"it calls itself: {called.__name__}")
    made = f"{function.text}({','.join(code.text for code in codes.values())})"
    return Code(f"({begin}{made})" if begin else made, function.kind)


def _new(writer: Base, node: ast.AST, kind: Any, given: Given, named: Named) -> Code:
    """Writes a new NamedTuple."""
    fields, defaults = kind._fields, kind._field_defaults
    if len(given) > len(fields) or not set(named) <= set(fields[len(given) :]):
        raise writer.refused(node, f"it makes a {kind.__name__} with other fields than it has")
    parts = dict(zip(fields, given, strict=False)) | named
    for name in fields:
        if name not in parts and name not in defaults:
            raise writer.refused(node, f"it makes a {kind.__name__} without {name}")
    codes = [parts[name] if name in parts else writer.constant(node, defaults[name], name) for name in fields]
    if [name for name in fields if name in named] == list(named):
        return writer.tuple_of(kind, codes)
    raise writer.refused(node, f"it makes a {kind.__name__} with its fields in another order")


def _method(writer: Operations, node: ast.Call, owner: Code, name: str, given: Given, named: Named) -> Code:
    kind = owner.kind
    if isinstance(kind, Tuple) and kind.type is not None:
        found = getattr_static(kind.type, name, None)
        if isinstance(found, staticmethod) and isinstance(found.__func__, FunctionType):
            return own_function(writer, node, found.__func__, given, named)
        if isinstance(found, FunctionType):
            return own_function(writer, node, found, [owner, *given], named)
    elif kind == RNG:
        return draw(writer, node, owner.text, name, given, named)
    elif isinstance(kind, Array):
        made = of_array(writer, node, owner, name, given, named)
        if made is not None:
            return made
    elif isinstance(kind, List) and not named:
        return _of_list(writer, node, owner, kind, name, given)
    elif kind == NEVER:
        return owner
    raise writer.refused(node, f"it calls .{name} of {described(kind)}")


def _of_list(writer: Base, node: ast.Call, owner: Code, kind: List, name: str, given: Given) -> Code:
    if name == "append" and len(given) == 1:
        writer.widen(node, kind, given[0].kind)
        return Code(f"{owner.text}.push({given[0].text})", "none")
    if name == "pop" and not given:
        return Code(f"popped({owner.text})", writer.known.part(kind))
    raise writer.refused(node, f"it calls .{name} of a list")


# Functions of Python


def _to_int(writer: Base, node: ast.AST, given: Given) -> Code | None:
    (x,) = given or [Code("0", INT)]
    if x.kind == INT or x.kind == BOOL:
        return Code(f"(+{x.text})", INT)
    return Code(f"truncated({x.text})", INT) if x.kind in NUMBERS else None


def _to_float(writer: Base, node: ast.AST, given: Given) -> Code | None:
    (x,) = given or [Code("0", INT)]
    return Code(f"(+{x.text})", FLOAT) if x.kind in NUMBERS or x.kind == BOOL else None


def _round(writer: Base, node: ast.AST, given: Given) -> Code | None:
    if len(given) != 1:
        raise writer.refused(node, "it rounds to decimals")
    x = given[0]
    return x if x.kind == INT else Code(f"rounded({x.text})", INT) if x.kind in (FLOAT, MIXED) else None


def _abs(writer: Base, node: ast.AST, given: Given) -> Code | None:
    (x,) = given
    if isinstance(x.kind, Array) and x.kind.of != BOOL:
        return Code(f"mapped({ARRAYS[x.kind.of]},Math.abs,{x.text})", Array(x.kind.of, x.kind.ndim))
    return Code(f"Math.abs({x.text})", x.kind) if x.kind in NUMBERS else None


def _divmod(writer: Operations, node: ast.AST, given: Given) -> Code | None:
    held = [Code(writer.fresh(), one.kind) for one in given]
    begin = ",".join(f"{name.text}={one.text}" for name, one in zip(held, given, strict=True))
    made = writer.tuple_of(None, [writer.operation(node, sign, *held) for sign in (ast.FloorDiv, ast.Mod)])
    return Code(f"({begin},{made.text})", made.kind)


def _extreme(name: str) -> Callable[[Operations, ast.AST, Given], Code | None]:
    def extreme(writer: Operations, node: ast.AST, given: Given) -> Code | None:
        if len(given) < 2 or not all(one.kind in NUMBERS or one.kind == NEVER for one in given):
            return None
        result = given[0]
        for one in given[1:]:
            result = Code(f"{name}({result.text},{one.text})", writer.joined(node, result.kind, one.kind))
        return result

    return extreme


def _power(writer: Operations, node: ast.AST, given: Given) -> Code | None:
    return writer.operation(node, ast.Pow, *given) if len(given) == 2 else None


def _flag(writer: Base, node: ast.AST, given: Given) -> Code | None:
    return Code(writer.truth(node, given[0]), BOOL) if given else Code("false", BOOL)


def _wholeness(writer: Base, node: ast.AST, given: Given) -> Code | None:
    (x,) = given
    if x.kind == MIXED:
        raise writer.refused(node, "the observation may be a whole number or a real one: use int()")
    return Code(f"({x.text},{2 if x.kind == INT else 1 if x.kind == BOOL else 0})", INT)


BUILTINS: dict[Any, Callable[[Operations, ast.AST, Given], Code | None]] = {
    int: _to_int,
    np.int64: _to_int,
    float: _to_float,
    np.float64: _to_float,
    round: _round,
    abs: _abs,
    np.abs: _abs,
    divmod: _divmod,
    max: _extreme("larger"),
    min: _extreme("smaller"),
    pow: _power,
    bool: _flag,
    wholeness: _wholeness,
}
"""What writes calls of functions whose arguments are single values; it gives None if there is no translation."""


GIVEN: dict[Any, tuple[int, ...]] = {
    **dict.fromkeys((int, np.int64, float, np.float64, bool), (0, 1)),
    **dict.fromkeys((abs, np.abs, wholeness), (1,)),
    divmod: (2,),
}
"""How many arguments some of them take; the others see for themselves."""


def _of_all(writer: Iterations, node: ast.Call, called: Any) -> Code:
    """Writes a call of a function of one list, tuple, array or range."""
    name, argument = called.__name__, node.args[0]
    if called is len:
        value = writer.visit(argument)
        if isinstance(value.kind, Array) and value.kind.name:
            return Code(f"{value.kind.name}_n0", INT)
        if isinstance(value.kind, Array | List):
            return Code(f"{value.text}.length", INT)
        if isinstance(value.kind, Tuple):
            return Code(f"({value.text},{len(value.kind.parts)})", INT)
        if isinstance(value.kind, Static) and isinstance(value.kind.value, str):
            return Code(str(len(value.kind.value)), INT)
        raise writer.refused(node, f"it asks for the length of {described(value.kind)}")
    if isinstance(argument, ast.GeneratorExp):
        raise writer.refused(node, "a for in a call needs [ ], as in sum([...])")
    through = writer.iteration(argument)
    kind = through.value.kind
    loop = f"for(;{through.more};{through.advance})"
    gathered = f"(()=>{{const list=[];{through.begin}{loop}list.push({through.value.text});return list}})()"
    if called is list:
        site = writer.list_at(node)
        writer.widen(node, site, kind)
        return Code(gathered, site)
    if called in (any, all):
        test = writer.truth(node, through.value)
        sign, found = ("", "true") if called is any else ("!", "false")
        other = "false" if called is any else "true"
        return Code(f"(()=>{{{through.begin}{loop}if({sign}{test})return {found};return {other}}})()", BOOL)
    if kind == NEVER:
        return Code(gathered, NEVER)
    if kind not in NUMBERS and not (called is sum and kind == BOOL):
        raise writer.refused(node, f"it calls {name} of what holds {described(kind)}")
    if called is sorted:
        site = writer.list_at(node)
        writer.widen(node, site, kind)
        return Code(f"ordered({gathered})", site)
    if called is sum:
        if kind == BOOL:
            return Code(f"countOf({gathered})", INT)
        if kind == INT:
            return Code(f"sumOfWholes({gathered})", INT)
        keeps = sys.version_info >= (3, 12) and not isinstance(writer.visit(argument).kind, Array)
        checked = ",mixed" if kind == MIXED and not keeps else ""
        total = f"{'sumInDoubt' if keeps else 'sumInTurn'}({gathered}{checked})"
        return Code(f"mixed({total})", MIXED) if kind == MIXED else Code(total, FLOAT)
    if called in (max, min):
        return Code(f"listExtreme({gathered},{'greater' if called is max else 'less'})", kind)
    raise writer.refused(node, f"it uses {name}() like this")

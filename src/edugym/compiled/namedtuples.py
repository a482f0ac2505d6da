"""Methods, properties and constants of NamedTuples, which Numba does not know by itself.

`teach` makes Numba look them up in the class of *any* NamedTuple, so that a class from a notebook cell compiles as the
package's own do, together with the plain functions that its methods call.
"""

import importlib
import importlib.util
import inspect
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from enum import Enum
from functools import cache
from types import FunctionType
from typing import Any

import numpy as np

from edugym.compiled.code import NAMEDTUPLE_MEMBERS, is_foreign

# The build in progress, of which there is one at a time: Numba's options, the plain functions that may be compiled with
# it, and those that were so far.
_options: dict[str, Any] = {}
_helpers: set[FunctionType] = set()
_parts: dict[FunctionType, Any] = {}

CONSTANTS = (bool, int, float, str, tuple, Enum, np.ndarray, np.int64, np.bool_)
"""The classes of what a NamedTuple may have as a constant."""


@contextmanager
def building(options: dict[str, Any], functions: set[FunctionType]) -> Iterator[None]:
    """Allows these functions to be compiled along, with these options, wherever a method or function calls them."""
    _options.update(options)
    _helpers.update(functions)
    try:
        yield
    finally:
        _options.clear()
        _helpers.clear()
        _parts.clear()  # the globals that it read may have changed by the next build


def member_of(kind: Any, name: str) -> Any:
    """The method, property or constant `name` of a NamedTuple class, or None (fields are Numba's own business)."""
    if name in kind.fields or name in NAMEDTUPLE_MEMBERS:
        return None
    return inspect.getattr_static(kind.instance_class, name, None)


def skip_check_of_scipy() -> None:
    """Loads Numba's arrays without its check that SciPy has linear algebra.

    The check imports scipy.linalg, which takes a sixth of the time to the first result. Code that needs linear algebra
    still imports it when it is compiled.
    """
    if importlib.util.find_spec("scipy") is None:
        return
    with suppress(AttributeError, ImportError):  # another Numba, which sees to that in another way
        linalg: Any = importlib.import_module("numba.np.linalg")
        check = linalg.ensure_blas
        try:
            linalg.ensure_blas = lambda: None
            arraymath: Any = importlib.import_module("numba.np.arraymath")
            arraymath.ensure_blas = check
        finally:
            linalg.ensure_blas = check


def teach(numba: Any, pipelines: Any) -> None:
    """Makes Numba look up members of NamedTuples in their classes, and compile them by the pipelines given."""
    registry: Any = importlib.import_module("numba.core.registry")
    pipelines.share_function_passes(registry.cpu_target.target_context.codegen())
    types, typeof, extending = numba.types, numba.typeof, numba.extending
    imputils: Any = importlib.import_module("numba.core.imputils")
    templates: Any = importlib.import_module("numba.core.typing.templates")
    tuples: Any = importlib.import_module("numba.cpython.tupleobj")
    purpose: Any = importlib.import_module("numba.core.typing.typeof").Purpose

    def part(function: FunctionType) -> Any:
        """The type of a method or helper, compiled with the options of the build in progress."""
        if function not in _parts:
            pipeline = pipelines.CheckedPart if is_foreign(function) else pipelines.Part
            _parts[function] = numba.njit(pipeline_class=pipeline, forceinline=True, **_options)(function)
        return types.Dispatcher(_parts[function])

    def call(context: Any, builder: Any, function: FunctionType, kinds: Any, values: Any) -> Any:
        """The machine code of a call."""
        callee = part(function)
        implementation = context.get_function(callee, callee.get_call_type(context.typing_context, kinds, {}))
        context.add_linking_libs(getattr(implementation, "libs", ()))
        return implementation(builder, values)

    @cache
    def lower_method(name: str) -> None:
        """Defines how a method of this name is called, of any NamedTuple."""

        def method(context: Any, builder: Any, signature: Any, values: Any) -> Any:
            if len(values) < len(signature.args):  # Numba leaves out a self without fields
                values = [context.make_tuple(builder, signature.args[0], ()), *values]
            return call(context, builder, member_of(signature.args[0], name), signature.args, values)

        key = (types.BaseNamedTuple, name)
        extending.lower_builtin(key, types.BaseNamedTuple, types.VarArg(types.Any))(method)

    def resolve(template: Any, kind: Any, name: str) -> Any:
        """The type of a member, or None where there is none."""
        member = member_of(kind, name)
        if isinstance(member, FunctionType):
            lower_method(name)

            def generic(method: Any, kinds: Any, keywords: Any) -> Any:
                now = member_of(kind, name)  # Numba may remember this template for a method that was replaced since
                return part(now).get_call_type(method.context, (kind, *kinds), keywords).as_method()

            members = {"key": (types.BaseNamedTuple, name), "generic": generic}
            return types.BoundFunction(type("Method", (templates.AbstractTemplate,), members), kind)
        if isinstance(member, property):
            return part(function_of(member)).get_call_type(template.context, (kind,), {}).return_type
        return constant(member) if isinstance(member, CONSTANTS) else None

    def constant(member: Any) -> Any:
        """The type of a constant."""
        return typeof(member, purpose.constant)

    def function_of(member: property) -> Any:
        return member.fget

    def read(context: Any, builder: Any, kind: Any, value: Any, name: str) -> Any:
        """The machine code that reads a field, a property or a constant."""
        member = member_of(kind, name)
        if member is None:
            return tuples.namedtuple_getattr(context, builder, kind, value, name)
        if isinstance(member, property):
            return call(context, builder, function_of(member), (kind,), (value,))
        return context.get_constant_generic(builder, constant(member), member)

    def helper(function: FunctionType, context: Any) -> Any:
        """A plain function that a method calls compiles along (Numba alone asks for a decorator on it)."""
        return part(function) if function in _helpers and context.purpose is purpose.constant else None

    known = extending.typeof_impl.dispatch(np.ndarray)

    def array(value: Any, context: Any) -> Any:
        """The type of an array: one that is no argument is a copy in machine code, and nothing may be written to it."""
        kind = known(value, context)
        is_copy = isinstance(kind, types.Array) and context.purpose is purpose.constant
        return kind.copy(readonly=True) if is_copy else kind

    extending.typeof_impl.register(np.ndarray)(array)
    for kind_of_tuple in (types.NamedTuple, types.NamedUniTuple):
        members = {"key": kind_of_tuple, "generic_resolve": resolve}
        templates.infer_getattr(type("Members", (templates.AttributeTemplate,), members))
        imputils.lower_getattr_generic(kind_of_tuple)(read)
    extending.typeof_impl.register(FunctionType)(helper)

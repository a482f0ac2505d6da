"""What may be compiled of code that is not the package's own: the subset in which machine code does as Python does.

*Values* (fields, states, arguments, global constants): numbers of 64 bits, bool, str and None, tuples and NamedTuples
of these, arrays of int64, float64 and bool, and generators passed as `rng`.

*Names*: the builtins, the functions of `math` and `np` below, helper functions, NamedTuple classes and modules of the
author's own.

*Statements*: no try, no with, no yield, no global variable that is assigned. What operations may do with which types is
judged while compiling, where types are known (`edugym.compiled.judging`). Everything else runs interpreted.
"""

import dis
import inspect
import math
import re
from collections.abc import Iterator
from enum import Enum
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from edugym.compiled.code import LIBRARIES, Code, arrays_in, inside, is_foreign
from edugym.system.packages import is_ours, package_of


def words(text: str) -> frozenset[str]:
    """The words of a text, as a set."""
    return frozenset(text.split())


DTYPES = frozenset({"int64", "float64", "bool"})
BUILTINS = words(
    "abs all any bool divmod enumerate float int len list max min pow range round sorted sum tuple zip "
    "ArithmeticError AssertionError Exception IndexError KeyError NotImplementedError OverflowError RuntimeError "
    "TypeError ValueError ZeroDivisionError True False None"
)
MATH = words(
    "acos acosh asin asinh atan atan2 atanh ceil copysign cos cosh degrees e exp expm1 fabs floor hypot inf isfinite "
    "isinf isnan log log10 log1p log2 nan pi radians sin sinh sqrt tan tanh tau trunc"
)
NUMPY = words(
    "abs absolute all amax amin any arange arccos arcsin arctan arctan2 argmax argmin argwhere array array_equal bool "
    "bool_ ceil clip concatenate copy cos cosh count_nonzero cumprod cumsum diff divide dot e empty empty_like exp "
    "expm1 eye flatnonzero float64 floor full full_like hypot identity inf int64 intp isfinite isinf isnan linspace "
    "log log10 log1p log2 max maximum mean median min minimum multiply nan ndarray newaxis nonzero ones ones_like "
    "outer pi prod searchsorted sign sin sinh sort sqrt square std subtract sum tan tanh trunc var where zeros "
    "zeros_like add float32 uint8 int8 int16 int32"
)
"""Functions that give what NumPy gives, but for the last digits of sums, means, powers and exp."""
HARMLESS = words(
    "__abstractmethods__ __annotate__ __annotate_func__ __annotations__ __annotations_cache__ __class_getitem__ "
    "__classdictcell__ __copy__ __deepcopy__ __dict__ __doc__ __firstlineno__ __format__ __getnewargs__ __getstate__ "
    "__init_subclass__ __match_args__ __module__ __orig_bases__ __parameters__ __qualname__ __reduce__ __reduce_ex__ "
    "__replace__ __repr__ __setstate__ __sizeof__ __slots__ __static_attributes__ __str__ __type_params__ "
    "__weakref__"
)
"""Special names of a class that no operation of machine code would look up."""
DRAWS_WITH_CHECKS = words("binomial exponential integers normal poisson uniform")
"""Draws whose parameters are checked; see `edugym.compiled.draws`."""
CARRIED = ("a state", "an observation", "an action")
"""What is between two steps of a loop, which may have other numbers in place of the action."""
OTHERWISE = {
    "print": "it prints",
    "isinstance": "it asks for the type of a value",
    "type": "it asks for the type of a value",
    "str": "it makes text",
    "repr": "it makes text",
    "set": "it makes a set",
    "dict": "it makes a dict",
    "super": "it uses super()",
}
"""How to say that one of Python's own functions is used; by default "it uses NAME"."""


def refusal(code: Code, arguments: tuple[Any, ...], names: tuple[str, ...]) -> str | None:
    """Why this is not to be compiled, in a few words that name the line where there is one; None if it may be.

    Args:
        code: what would be compiled.
        arguments: what a loop is called with.
        names: of the loop's parameters.
    """
    foreign, parts = code.foreign, list[tuple[Any, str]]()
    for argument, name in zip(arguments, names, strict=True):
        known = name == "carry" and isinstance(argument, tuple)  # a student knows the names of its first parts
        if not isinstance(argument, np.random.Generator):
            parts += zip(argument, CARRIED, strict=False) if known else [(argument, f"the argument {name}")]
    found = next(filter(None, (_of_values(one, of, all_kinds=not foreign, owner=None) for one, of in parts)), None)
    if found or not foreign:
        return found
    fields = arrays_in(*(argument for argument, name in zip(arguments, names, strict=True) if name != "carry"))
    judged = [_of_shared(code, list(fields)), *map(_of_class, filter(is_foreign, code.classes)), *_of_members(code)]
    judged += [_of_function(function) for function in code.functions if is_foreign(function)]
    return next(filter(None, judged), None)


def _of_values(value: Any, name: str, *, all_kinds: bool, owner: type | None) -> str | None:
    """What is wrong with a value, or with one in it.

    Args:
        value: any.
        name: what it is called in a message.
        all_kinds: whether arrays of all types will do: where all code is the package's own.
        owner: the class of which it is a field.
    """
    if isinstance(value, tuple):
        kind = type(value)
        fields = getattr(value, "_fields", None)
        if getattr(value, "__dict__", None):
            return f"a value of {kind.__name__} has an attribute besides its fields: {next(iter(vars(value)))}"
        for k, part in enumerate(tuple.__iter__(value)):
            part_name = (
                f"{re.sub('^an? ', '', name)}[{k}]" if fields is None else f"the field {fields[k]} of {kind.__name__}"
            )
            if found := _of_values(part, part_name, all_kinds=all_kinds, owner=kind if fields else owner):
                return found
        return None
    adapters = owner is not None and owner.__module__.startswith(("edugym.adapters", "edugym.compiled"))
    if isinstance(value, np.ndarray):
        if type(value) is not np.ndarray:
            return f"{name} is a {type(value).__name__}: use an ordinary array"
        if value.dtype.hasobject:
            return f"{name} is an array of objects"
        if all_kinds or value.dtype.name in DTYPES or (adapters and value.ndim):
            return None
        return f"{name} is an array of {value.dtype.name}; of arrays it takes those of float64, int64 and bool"
    if isinstance(value, np.random.Generator):
        return f"{name} is a random generator: take it as rng" if is_foreign(owner) else None
    if adapters and package_of(type(value)) == "numba":
        return None
    return _of_constant(value, name)


def _of_constant(value: Any, name: str) -> str | None:
    """What is wrong with a value that is no tuple, array or generator."""
    if isinstance(value, bool | float | str | Enum | np.bool_ | None) and not isinstance(value, np.str_):
        return None
    if isinstance(value, int | np.int64):
        return None if -(2**63) <= value < 2**63 else f"{name} is {value}, beyond the whole numbers of 64 bits"
    if isinstance(value, list | set | dict | frozenset):
        return f"{name} is a {type(value).__name__}: use an array or a tuple"
    if isinstance(value, np.generic):
        return f"{name} is a number of type {type(value).__name__}"
    if callable(value):
        return f"{name} is a function or class"
    return f"{name} is a value of {type(value).__name__}, which is no NamedTuple"


def _of_class(kind: type) -> str | None:
    """What operations would do with its values that machine code would not."""
    for base in kind.__mro__:
        if package_of(base) in LIBRARIES or not is_foreign(base):
            continue
        for name, member in vars(base).items():
            if name in getattr(kind, "_fields", ()) and type(member).__name__ != "_tuplegetter":
                return f"{base.__name__} replaces the field {name} by something else"
            function = getattr(member, "__func__", member)
            special = name.startswith("__") and name not in HARMLESS and callable(function)
            own = getattr(function, "__globals__", {}).get("__name__", "").startswith("namedtuple_")
            ours = is_ours(function)  # as what the decorator `wrapper` adds
            if special and not ours and not own:
                return f"{base.__name__} defines {name}, which machine code would not call"
            if name in DRAWS_WITH_CHECKS:
                return f"{base.__name__} has a member named {name}, as rng has"
    return None


def _of_shared(code: Code, fields: list[Any]) -> str | None:
    """What is wrong with an array that is both a constant, which machine code reads once, and a field that changes."""
    for of, name, value in code.named():
        if any(np.shares_memory(one, field) for one in arrays_in(value) for field in fields):
            found = f"the array {name} is a field as well: use only the field"
            return _at(found, of.__code__, None) if isinstance(of, FunctionType) else found
    return None


def _of_members(code: Code) -> Iterator[str | None]:
    """What is wrong with constants of classes that are used."""
    for (kind, name), member in code.members.items():
        constant = not isinstance(member, FunctionType | property | classmethod | staticmethod | type)
        if is_foreign(kind) and constant and type(member).__name__ != "_tuplegetter":
            yield _of_values(member, f"{kind.__name__}.{name}", all_kinds=False, owner=None)


def _of_function(function: FunctionType) -> str | None:
    """What is wrong with the names and statements of a function, and in which line."""
    if function.__code__.co_flags & inspect.CO_VARKEYWORDS:
        return _at(f"{function.__name__} takes **: name its parameters", function.__code__, None)
    if function.__code__.co_kwonlyargcount:
        return _at(f"{function.__name__} has parameters after *: leave the * out", function.__code__, None)
    for value in function.__defaults__ or ():
        if found := _of_values(value, f"a default of {function.__name__}", all_kinds=False, owner=None):
            return _at(found, function.__code__, function.__code__.co_firstlineno)
        if isinstance(value, np.ndarray):
            return _at(f"a default of {function.__name__} is an array", function.__code__, None)
    return _of_code(function.__code__, function)


def _of_code(code: CodeType, function: FunctionType) -> str | None:
    line: int | None = code.co_firstlineno
    value: Any = _UNKNOWN  # what the instruction before has taken from a global name
    path = ""
    for instruction in dis.get_instructions(code):
        line = getattr(instruction.positions, "lineno", None) or line
        name, found = instruction.argval, None
        if instruction.opname in GLOBAL or (instruction.opname in OUTER and name in function.__code__.co_freevars):
            path, value = name, _looked_up(function, name)
            found = _of_name(value, path)
        elif instruction.opname in ("LOAD_ATTR", "LOAD_METHOD"):
            path = f"{path}.{name}"
            found, value = _of_attribute(value, name, path)
        elif instruction.opname in ("STORE_ATTR", "DELETE_ATTR"):
            found = f"it assigns the attribute {name}"
        elif instruction.opname == "STORE_DEREF" and name in function.__code__.co_freevars:
            found = f"it assigns {name}, a variable of the function around it"
        elif instruction.opname in STATEMENTS:
            generates = instruction.opname == "YIELD_VALUE" and code.co_name == "<genexpr>"
            found = "a for in a call needs [ ], as in sum([...])" if generates else STATEMENTS[instruction.opname]
        elif instruction.opname not in ("PRECALL", "CACHE", "NOP", "PUSH_NULL"):
            value = _UNKNOWN
        if found:
            return _at(found, code, line)
    inner = (_of_code(constant, function) for constant in code.co_consts if isinstance(constant, CodeType))
    return next(filter(None, inner), None)


class _Unknown:
    """What is known when code runs only."""


_UNKNOWN = _Unknown()
GLOBAL = ("LOAD_GLOBAL", "LOAD_NAME")
OUTER = ("LOAD_DEREF", "LOAD_CLASSDEREF", "LOAD_FROM_DICT_OR_DEREF")
STATEMENTS = {
    "STORE_GLOBAL": "it assigns a global variable",
    "DELETE_GLOBAL": "it deletes a global variable",
    "PUSH_EXC_INFO": "it has a try or with",
    "YIELD_VALUE": "it has a yield",
    "IMPORT_NAME": "it imports",
    "BUILD_SET": "it makes a set",
    "BUILD_MAP": "it makes a dict",
    "BUILD_CONST_KEY_MAP": "it makes a dict",
    "FORMAT_VALUE": "it makes text",
    "FORMAT_SIMPLE": "it makes text",
    "BUILD_STRING": "it makes text",
    "LOAD_BUILD_CLASS": "it makes a class",
}
"""Instructions of Python that machine code does otherwise, or not at all."""


def _looked_up(function: FunctionType, name: str) -> Any:
    if name in function.__code__.co_freevars:
        cell = (function.__closure__ or ())[function.__code__.co_freevars.index(name)]
        return inside(cell, _UNKNOWN)
    if name in function.__globals__:
        return function.__globals__[name]
    builtins: Any = function.__globals__.get("__builtins__", {})
    # a misspelt name is an error of the program, which its first steps will show
    return builtins.get(name, _UNKNOWN) if isinstance(builtins, dict) else getattr(builtins, name, _UNKNOWN)


def _of_name(value: Any, name: str) -> str | None:
    """What is wrong with what a global name stands for."""
    if value is _UNKNOWN or isinstance(value, FunctionType):
        return None
    if isinstance(value, ModuleType):
        own = package_of(value) not in LIBRARIES and value.__name__ not in {"random", "time", "os"}
        return None if own or value in (math, np) else _of_module(value.__name__)
    if _known_function(value):
        return None
    if isinstance(value, type):
        plain = (
            f"it uses {name}" if package_of(value) in LIBRARIES else f"it uses the class {name}, which is no NamedTuple"
        )
        return None if _is_own_class(value) else OTHERWISE.get(name, plain)
    if package_of(type(value)) == "numba" and hasattr(value, "py_func"):
        return None
    module = getattr(value, "__module__", None) or ""
    if callable(value):
        if module.startswith(("numpy.random", "random")) or "random" in type(getattr(value, "__self__", 0)).__module__:
            return _of_module("random")
        return OTHERWISE.get(name, f"it uses {name}")
    return _of_values(value, f"the global {name}", all_kinds=False, owner=None)


def _is_own_class(value: type) -> bool:
    return issubclass(value, Enum) or (issubclass(value, tuple) and hasattr(value, "_fields"))


def _of_module(name: str) -> str:
    if "random" in name.split("."):
        return f"it draws from {name}, which no seed of a run reaches: draw from rng"
    return f"it uses the module {name}"


def _of_attribute(value: Any, name: str, path: str) -> tuple[str | None, Any]:
    """What is wrong with an attribute of what a global name stands for, and its value if that is known."""
    if value is np:
        if name == "random":
            return _of_module("np.random"), _UNKNOWN
        return (None if name in NUMPY else f"it uses {path}"), _UNKNOWN
    if isinstance(value, ModuleType) and hasattr(value, name):
        inner = getattr(value, name)
        return _of_name(inner, path), inner
    return None, _UNKNOWN


def _known_function(value: Any) -> bool:
    """Whether it is one of the functions, or classes, above."""
    try:
        return value in _FUNCTIONS
    except TypeError:  # it has no hash
        return False


_BUILTIN: dict[str, Any] = __builtins__ if isinstance(__builtins__, dict) else vars(__builtins__)
_FUNCTIONS = frozenset(
    value
    for value in (
        *(_BUILTIN[name] for name in BUILTINS),
        *(getattr(math, name) for name in MATH),
        *(getattr(np, name) for name in NUMPY),
    )
    if callable(value)
)


def _at(found: str, code: CodeType, line: int | None) -> str:
    """The same with the place: of a cell its line, of a module the file as well."""
    return f"{found} ({place(code.co_filename, line or code.co_firstlineno)})"


def place(file: str, line: int) -> str:
    """A line, in words that mean something to its author: a notebook's cells have files with names of digits alone."""
    name = file.replace("\\", "/").rpartition("/")[2]
    stem = name.partition(".")[0]
    return f"line {line}" if stem.isdigit() or name.startswith("<ipython") else f"{name}, line {line}"

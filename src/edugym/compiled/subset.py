"""The subset of Python in which machine code does as Python does: what may be compiled of students' code.

*Values* (fields, states, arguments, global constants): numbers of 64 bits, bool, str and None, tuples and NamedTuples
of these, arrays of int64, float64 and bool, and generators passed as `rng`.

*Names*: the builtins, the functions of `math` and `np` below, helper functions, NamedTuple classes and modules of the
author's own.

*Statements*: no try, no with, no yield, no global variable that is assigned. The types of operations are checked while
compiling, where types are known (`edugym.compiled.typed_checks`). Everything else runs interpreted.

The functions here return a problem in a few words, or None.
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

from edugym.compiled.byte_code import inside, place
from edugym.compiled.code import LIBRARIES, MOST_FROZEN, Code, arrays_in, is_foreign
from edugym.system.packages import is_ours, package_of


def words(text: str) -> frozenset[str]:
    """The words of a text, as a set."""
    return frozenset(text.split())


MOST_PARTS = 300
"""The longest tuples that may be constants of machine code."""
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
"""Functions of NumPy's that give the same as machine code, but for the last digits of sums, means, powers and exp."""
HARMLESS_SPECIAL_NAMES = words(
    "__abstractmethods__ __annotate__ __annotate_func__ __annotations__ __annotations_cache__ __class_getitem__ "
    "__classdictcell__ __copy__ __deepcopy__ __dict__ __doc__ __firstlineno__ __format__ __getnewargs__ __getstate__ "
    "__init_subclass__ __match_args__ __module__ __orig_bases__ __parameters__ __qualname__ __reduce__ __reduce_ex__ "
    "__replace__ __repr__ __setstate__ __sizeof__ __slots__ __static_attributes__ __str__ __type_params__ "
    "__weakref__"
)
"""Special names that a class may define, since no operation looks them up."""
DRAWS_WITH_CHECKS = words("binomial exponential integers normal poisson uniform")
"""Draws whose parameters are checked; see `edugym.compiled.draws`."""
CARRIED = ("a state", "an observation", "an action")
"""The parts of `carry`, which a loop carries from step to step; there may be other numbers in place of the action."""
MESSAGES = {
    "print": "it prints",
    "isinstance": "it asks for the type of a value",
    "type": "it asks for the type of a value",
    "str": "it makes text",
    "repr": "it makes text",
    "set": "it makes a set",
    "dict": "it makes a dict",
    "super": "it uses super()",
}
"""What is said of the use of Python's own functions; by default "it uses NAME"."""


def refusal(code: Code, arguments: tuple[Any, ...], names: tuple[str, ...]) -> str | None:
    """Why this may not be compiled, in a few words that name the line where there is one; None if it may.

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
    found = next(filter(None, (_value_problem(one, of, all_kinds=not foreign, owner=None) for one, of in parts)), None)
    if found or not foreign:
        return found
    fields = arrays_in(*(argument for argument, name in zip(arguments, names, strict=True) if name != "carry"))
    problems = [
        _shared_array_problem(code, list(fields)),
        *map(_frozen_problem, code.named()),
        *map(_class_problem, filter(is_foreign, code.classes)),
        *_constant_problems(code),
        *map(_function_problem, filter(is_foreign, code.functions)),
    ]
    return next(filter(None, problems), None)


def _value_problem(value: Any, name: str, *, all_kinds: bool, owner: type | None) -> str | None:
    """The problem with a value, or with a part of it.

    Args:
        value: any.
        name: what it is called in a message.
        all_kinds: whether arrays of all types are allowed, as they are where all code is the package's own.
        owner: the class of which it is a field.
    """
    if isinstance(value, tuple):
        kind = type(value)
        fields = getattr(value, "_fields", None)
        if kind is not tuple and fields is None:
            return f"{name} is a value of {kind.__name__}, which is no NamedTuple"
        if getattr(value, "__dict__", None):
            return f"a value of {kind.__name__} has an attribute besides its fields: {next(iter(vars(value)))}"
        for k, part in enumerate(tuple.__iter__(value)):
            part_name = (
                f"{re.sub('^an? ', '', name)}[{k}]" if fields is None else f"the field {fields[k]} of {kind.__name__}"
            )
            if found := _value_problem(part, part_name, all_kinds=all_kinds, owner=kind if fields else owner):
                return found
        return None
    adapters = owner is not None and owner.__module__.startswith(("edugym.adapters", "edugym.compiled"))
    if isinstance(value, np.ndarray):
        if type(value) is not np.ndarray:
            return f"{name} is a {type(value).__name__}: use an ordinary array"
        if value.dtype.hasobject:
            return f"{name} is an array of objects"
        if not value.dtype.isnative:
            return f"{name} is an array with its bytes in another order: use a copy of it, as by .astype(float)"
        if all_kinds or value.dtype.name in DTYPES or (adapters and value.ndim):
            return None
        return f"{name} is an array of {value.dtype.name}; of arrays it takes those of float64, int64 and bool"
    if isinstance(value, np.random.Generator):
        return f"{name} is a random generator: take it as rng" if is_foreign(owner) else None
    if adapters and package_of(type(value)) == "numba":
        return None
    return _number_problem(value, name)


def _number_problem(value: Any, name: str) -> str | None:
    """The problem with a value that is no tuple, array or generator."""
    if isinstance(value, Enum):
        return _class_problem(type(value))
    if type(value) in (bool, float, str, np.float64, np.bool_, type(None)):
        return None
    if type(value) in (int, np.int64):
        return None if -(2**63) <= value < 2**63 else f"{name} is {value}, beyond the whole numbers of 64 bits"
    if isinstance(value, list | set | dict | frozenset):
        return f"{name} is a {type(value).__name__}: use an array or a tuple"
    if isinstance(value, np.generic):
        return f"{name} is a number of type {type(value).__name__}"
    if callable(value):
        return f"{name} is a function or class"
    return f"{name} is a value of {type(value).__name__}, which is no NamedTuple"


def _class_problem(kind: type) -> str | None:
    """The member by which values of a class do something else than those of a plain NamedTuple, or a plain enum."""
    for base in kind.__mro__:
        if package_of(base) in LIBRARIES or not is_foreign(base):
            continue
        for name, member in vars(base).items():
            if name in getattr(kind, "_fields", ()) and type(member).__name__ != "_tuplegetter":
                return f"{base.__name__} replaces the field {name} by something else"
            function = getattr(member, "__func__", member)
            special = name.startswith("__") and name not in HARMLESS_SPECIAL_NAMES and callable(function)
            home = getattr(function, "__globals__", {}).get("__name__", "")
            own = home.startswith("namedtuple_")
            if issubclass(kind, Enum):  # what is made by these is a constant
                own = home in ("", "enum") or name in ("__init__", "__new__")
            ours = is_ours(function)  # as what the decorator `wrapper` adds
            if special and not ours and not own:
                return f"{base.__name__} defines {name}, which machine code would not call"
            if name in DRAWS_WITH_CHECKS and not issubclass(kind, Enum):
                return f"{base.__name__} has a member named {name}, as rng has"
    return None


def _shared_array_problem(code: Code, fields: list[Any]) -> str | None:
    """An array that is both a constant, which machine code reads once, and a field, which changes."""
    for of, name, value in code.named():
        if any(np.shares_memory(one, field) for one in arrays_in(value) for field in fields):
            found = f"the array {name} is a field as well: use only the field"
            return _with_place(found, of.__code__, None) if isinstance(of, FunctionType) else found
    return None


def _frozen_problem(named: tuple[FunctionType | type, str, Any]) -> str | None:
    """A large array or tuple that is no field: machine code would hold a copy, which takes minutes to compile."""
    of, name, value = named
    size, parts = sum(array.nbytes for array in arrays_in(value)), _number_of_parts(value)
    if not is_foreign(of) or (size <= MOST_FROZEN and parts <= MOST_PARTS):
        return None
    large = f"is an array of {size / 1e6:.1f} MB" if size > MOST_FROZEN else f"is a tuple of {parts} numbers"
    found = f"{name} {large}, of which machine code would hold a copy: pass an array of them as a field"
    return _with_place(found, of.__code__, None) if isinstance(of, FunctionType) else found


def _number_of_parts(value: Any) -> int:
    return sum(map(_number_of_parts, tuple.__iter__(value))) if isinstance(value, tuple) else 1


def _constant_problems(code: Code) -> Iterator[str | None]:
    """The problems with the constants of classes that are used."""
    for (kind, name), member in code.members.items():
        constant = not isinstance(member, FunctionType | property | classmethod | staticmethod | type)
        if is_foreign(kind) and constant and type(member).__name__ != "_tuplegetter":
            yield _value_problem(member, f"{kind.__name__}.{name}", all_kinds=False, owner=None)


def _function_problem(function: FunctionType) -> str | None:
    """The problem with the names and statements of a function, and its line."""
    if function.__code__.co_flags & inspect.CO_VARKEYWORDS:
        return _with_place(f"{function.__name__} takes **: name its parameters", function.__code__, None)
    if function.__code__.co_kwonlyargcount:
        return _with_place(f"{function.__name__} has parameters after *: leave the * out", function.__code__, None)
    for value in function.__defaults__ or ():
        if found := _value_problem(value, f"a default of {function.__name__}", all_kinds=False, owner=None):
            return _with_place(found, function.__code__, function.__code__.co_firstlineno)
        if next(arrays_in(value), None) is not None:
            return _with_place(f"a default of {function.__name__} is an array", function.__code__, None)
    return _code_problem(function.__code__, function)


def _code_problem(code: CodeType, function: FunctionType) -> str | None:
    line: int | None = code.co_firstlineno
    value: Any = UNKNOWN  # what the instruction before has loaded by a global name
    path = ""
    byte_code = dis.Bytecode(code)
    entries = vars(byte_code).get("exception_entries", ())  # mypy knows no such attribute
    guarded = {entry.target: entry.start for entry in entries}  # what `try` or `with` stands around
    lines: dict[int, int | None] = {}
    for instruction in byte_code:
        line = getattr(instruction.positions, "lineno", None) or lines.get(guarded.get(instruction.offset, -1), line)
        lines[instruction.offset] = line
        name, found = instruction.argval, None
        is_outer = name in function.__code__.co_freevars
        if instruction.opname in GLOBAL_LOADS or (is_outer and instruction.opname in OUTER_LOADS):
            path, value = name, _value_of_name(function, name)
            found = _name_problem(value, path)
        elif instruction.opname in ("LOAD_ATTR", "LOAD_METHOD"):
            path = f"{path}.{name}"
            found, value = _attribute_problem(value, name, path)
        elif instruction.opname in ("STORE_ATTR", "DELETE_ATTR"):
            found = f"it assigns the attribute {name}"
        elif is_outer and instruction.opname == "STORE_DEREF":
            found = f"it assigns {name}, a variable of the function around it"
        elif instruction.opname in INSTRUCTIONS:
            generates = instruction.opname == "YIELD_VALUE" and code.co_name == "<genexpr>"
            found = "a for in a call needs [ ], as in sum([...])" if generates else INSTRUCTIONS[instruction.opname]
        elif instruction.opname not in ("PRECALL", "CACHE", "NOP", "PUSH_NULL"):
            value = UNKNOWN
        if found:
            return _with_place(found, code, line)
    inner = (_code_problem(constant, function) for constant in code.co_consts if isinstance(constant, CodeType))
    return next(filter(None, inner), None)


class Unknown:
    """A value that is known only when code runs."""


UNKNOWN, MISSING = Unknown(), Unknown()
GLOBAL_LOADS = ("LOAD_GLOBAL", "LOAD_NAME")
OUTER_LOADS = ("LOAD_DEREF", "LOAD_CLASSDEREF", "LOAD_FROM_DICT_OR_DEREF")
INSTRUCTIONS = {
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
"""Instructions that machine code executes otherwise, or not at all."""


def _value_of_name(function: FunctionType, name: str) -> Any:
    if name in function.__code__.co_freevars:
        cell = (function.__closure__ or ())[function.__code__.co_freevars.index(name)]
        return inside(cell, UNKNOWN)
    if name in function.__globals__:
        return function.__globals__[name]
    builtins: Any = function.__globals__.get("__builtins__", {})
    return builtins.get(name, MISSING) if isinstance(builtins, dict) else getattr(builtins, name, MISSING)


def _name_problem(value: Any, name: str) -> str | None:
    """The problem with the value of a global name."""
    if value is UNKNOWN or isinstance(value, FunctionType):
        return None
    if value is MISSING:
        return f"there is no {name}"
    if isinstance(value, ModuleType):
        own = package_of(value) not in LIBRARIES and value.__name__ not in {"random", "time", "os"}
        return None if own or value in (math, np) else _module_problem(value.__name__)
    if _is_allowed_function(value):
        return None
    if isinstance(value, type):
        plain = (
            f"it uses {name}" if package_of(value) in LIBRARIES else f"it uses the class {name}, which is no NamedTuple"
        )
        if _is_allowed_class(value):
            return _class_problem(value) if issubclass(value, Enum) else None
        return MESSAGES.get(name, plain)
    if package_of(type(value)) == "numba" and hasattr(value, "py_func"):
        fast = value.targetoptions.get("fastmath")
        return f"{name} has fastmath, which changes last digits with what is around it: leave it out" if fast else None
    module = getattr(value, "__module__", None) or ""
    if callable(value):
        if module.startswith(("numpy.random", "random")) or "random" in type(getattr(value, "__self__", 0)).__module__:
            return _module_problem("random")
        library = {"numpy": "np.", "math": "math."}.get(module, "")  # of what `import *` has brought
        return MESSAGES.get(name, f"it uses {library}{value.__name__ if library else name}")
    return _value_problem(value, f"the global {name}", all_kinds=False, owner=None)


def _is_allowed_class(value: type) -> bool:
    return issubclass(value, Enum) or (issubclass(value, tuple) and hasattr(value, "_fields"))


def _module_problem(name: str) -> str:
    if "random" in name.split("."):
        return f"it draws from {name}, which no seed of a run reaches: draw from rng"
    return f"it uses the module {name}"


def _attribute_problem(value: Any, name: str, path: str) -> tuple[str | None, Any]:
    """The problem with an attribute of the value of a global name, and the attribute's value if that is known."""
    if value is np:
        if name == "random":
            return _module_problem("np.random"), UNKNOWN
        return (None if name in NUMPY else f"it uses {path}"), UNKNOWN
    if isinstance(value, ModuleType) and hasattr(value, name):
        inner = getattr(value, name)
        return _name_problem(inner, path), inner
    return None, UNKNOWN


def _is_allowed_function(value: Any) -> bool:
    """Whether it is one of the functions, or classes, listed above."""
    try:
        return value in FUNCTIONS
    except TypeError:  # it has no hash
        return False


_BUILTIN: dict[str, Any] = __builtins__ if isinstance(__builtins__, dict) else vars(__builtins__)
FUNCTIONS = frozenset(
    value
    for value in (
        *(_BUILTIN[name] for name in BUILTINS),
        *(getattr(math, name) for name in MATH),
        *(getattr(np, name) for name in NUMPY),
    )
    if callable(value)
)


def _with_place(found: str, code: CodeType, line: int | None) -> str:
    """The problem with its place: of a cell the line, of a module the file as well."""
    return f"{found} ({place(code.co_filename, line or code.co_firstlineno)})"

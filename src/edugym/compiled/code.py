"""The code that a loop can reach, and its fingerprint: machine code is never run for code that has changed."""

import hashlib
import re
import sys
from collections.abc import Callable, Iterator
from enum import Enum
from functools import cache, cached_property
from pathlib import Path
from types import CellType, CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from edugym.compiled.byte_code import global_names, in_order, inside, place
from edugym.system.packages import is_ours, package_of

LIBRARIES = frozenset(
    {"builtins", "math", "numba", "numpy", "typing", "collections", "gymnasium", "operator", "sys", "enum"}
)
"""Packages whose code does not change while a program runs."""
MOST_FROZEN = 250_000
"""The largest arrays, in bytes, that may be constants of a student's machine code."""
NAMEDTUPLE_MEMBERS = frozenset({"_make", "_replace", "_asdict", "_fields", "_field_defaults"})
"""Members that every NamedTuple has."""
_ABSENT = object()
_known: dict[tuple[Any, ...], "Code"] = {}


def code_of(loop: Callable[..., Any], values: tuple[Any, ...]) -> "Code":
    """The `Code` that `loop(*values)` can reach.

    Collecting it takes some milliseconds, and an experiment has thousands of runs. So the package's own code is
    remembered, and collected again once anything in it has changed.
    """
    key = (loop, *classes_of(values))
    known = _known.get(key)
    if known is not None and known.is_unchanged():
        return known
    code = Code(loop, values)
    if code.is_watchable:
        _known[key] = code
    else:
        _known.pop(key, None)
    return code


class Code:
    """The code that a loop over some values can reach: its classes, its functions, and their fingerprint.

    A member of a class is reached if code that is reached uses its name: `create` or `scene`, which no loop names, are
    neither hashed nor checked.

    Attributes:
        classes: every NamedTuple class met: those of the values, and those that functions name.
        functions: every plain function met: the loop, methods, properties and helpers.
        members: the reached members of classes: (class, name) -> method, property or constant.
        globals: the global names that functions use: (function, name) -> value.
        cells: the variables of outer functions: (inner function, variable, value).
        attributes: what functions may take from modules: (function, module, name, value).
        fingerprint: a hash of all this code and of the global constants that it reads.
        is_watchable: whether `is_unchanged` can tell that something has changed. It cannot for code that is not the
            package's own, or reaches an array or the like, whose contents change while no name changes its meaning.
    """

    def __init__(self, loop: Callable[..., Any], values: tuple[Any, ...]) -> None:
        """Collects all that `loop(*values)` can reach."""
        self.classes: dict[type, None] = {}
        self.functions: dict[FunctionType, None] = {}
        self.members: dict[tuple[type, str], Any] = {}
        self.globals: dict[tuple[FunctionType, str], Any] = {}
        self.cells: list[tuple[FunctionType, CellType, Any]] = []
        self.attributes: list[tuple[FunctionType, ModuleType, str, Any]] = []
        self._names: dict[str, None] = {}
        self._owners: dict[type, None] = {}  # the classes whose members count
        self._looked_up: dict[tuple[int, str], tuple[dict[str, Any], str, Any]] = {}  # in globals and modules
        self._has_mutable = False  # whether it reaches a value that can change in place
        self._seen: dict[int, int] = {}
        self._kept: list[Any] = []  # ids stay unique while the objects live
        self._hash = hashlib.sha256()
        self._add(_hash_of_compiler())
        self._visit(loop)
        for kind in classes_of(values):
            self._visit(kind)
        while missing := self._unvisited_members():
            for kind, name in missing:
                self._visit_member(kind, name)
        self.fingerprint = self._hash.hexdigest()[:24]
        self.is_watchable = not self._has_mutable and not self.foreign
        self._array_bytes = [
            (name, array, array.tobytes())
            for of, name, value in self.named()
            if is_foreign(of)
            for array in arrays_in(value)
            if array.nbytes <= MOST_FROZEN
        ]
        self._shapes = [(kind, kind.__mro__, getattr(kind, "_fields", None)) for kind in self._owners]
        self._member_names = [(base, set(vars(base))) for base in self._bases()]
        self._function_parts = [(one, one.__code__, one.__defaults__, one.__kwdefaults__) for one in self.functions]

    @property
    def foreign(self) -> bool:
        """Whether any of it is not the package's own, but a student's."""
        return any(is_foreign(thing) for thing in (*self.classes, *self.functions))

    @property
    def foreign_files(self) -> set[str]:
        """The files, or cells, of those of its functions that are not the package's own."""
        return {function.__code__.co_filename for function in self.functions if is_foreign(function)}

    @property
    def importable(self) -> bool:
        """Whether another process finds the same classes by name, so that it can use what this one leaves on disk."""
        return all(
            getattr(sys.modules.get(kind.__module__), kind.__qualname__, None) is kind and kind.__module__ != "__main__"
            for kind in self.classes
        )

    def names(self) -> str:
        """The classes that are not the package's own, or else all of them, for a message."""
        own = [kind.__name__ for kind in self.classes if is_foreign(kind)]
        return ", ".join(own or [kind.__name__ for kind in self.classes])

    def known_names(self) -> str:
        """The tasks and agents in it, whose classes a student has met; the student's own alone, if there are any."""
        met = [
            kind
            for kind in self.classes
            if is_foreign(kind) or (kind.__module__.startswith(("edugym.envs.", "edugym.agents.")))
            if hasattr(kind, "transition") or hasattr(kind, "learn")
        ]
        own = [kind.__name__ for kind in met if is_foreign(kind)]
        return " and ".join(own or [kind.__name__ for kind in met]) or self.names()

    def place_of(self, method: str) -> str:
        """The place of a student's method, in brackets, for a message; nothing if there is none of this name."""
        found = next((one for one in self.functions if is_foreign(one) and one.__name__ == method), None)
        return "" if found is None else f" ({place(found.__code__.co_filename, found.__code__.co_firstlineno)})"

    def first_change(self) -> str | None:
        """The name of a method, global or array in a student's code that is not what it was, if there is one."""
        for name, array, before in self._array_bytes:
            if array.tobytes() != before:
                return name
        for (kind, name), member in self._watched_members:
            if vars(kind).get(name) is not member:
                return f"{kind.__name__}.{name}"
        for globals_, name, value in self._watched_globals:
            if globals_.get(name) is not value:
                return name
        for function, module, name, value in self.attributes:
            if is_foreign(function) and vars(module).get(name) is not value:
                return f"{module.__name__}.{name}"
        for function, code in self._watched_code:
            if function.__code__ is not code:
                return function.__qualname__
        changed = next((cell for cell, value in self._watched_cells if inside(cell) is not value), None)
        return None if changed is None else "a variable of a function around it"

    def is_unchanged(self) -> bool:
        """Whether the code, if it is watchable, is still what was collected."""
        return (
            all(kind.__mro__ is mro and getattr(kind, "_fields", None) is fields for kind, mro, fields in self._shapes)
            and all(vars(base).keys() == names for base, names in self._member_names)
            and all(vars(kind).get(name) is member for (kind, name), member in self.members.items())
            and all(
                one.__code__ is code and one.__defaults__ is defaults and one.__kwdefaults__ is named
                for one, code, defaults, named in self._function_parts
            )
            and all(space.get(name, _ABSENT) is value for space, name, value in self._looked_up.values())
            and all(inside(cell) is value for _, cell, value in self.cells)
        )

    @cached_property
    def arrays(self) -> tuple[np.ndarray[Any, Any], ...]:
        """The arrays that code reaches by a name, and not as an argument."""
        return tuple(arrays_in(*(value for *_, value in self.named())))

    def named(self) -> Iterator[tuple[FunctionType | type, str, Any]]:
        """The values that code reaches by a name, each with the function or class and the name."""
        yield from ((function, name, value) for (function, name), value in self.globals.items())
        yield from ((kind, name, value) for (kind, name), value in self.members.items())
        for function, cell, value in self.cells:
            place = next(
                k for k, one in enumerate(function.__closure__ or ()) if one is cell
            )  # == would compare arrays
            yield function, function.__code__.co_freevars[place], value
        yield from ((function, f"{module.__name__}.{name}", value) for function, module, name, value in self.attributes)

    @cached_property
    def _watched_members(self) -> list[tuple[tuple[type, str], Any]]:
        return [(key, member) for key, member in self.members.items() if is_foreign(key[0])]

    @cached_property
    def _watched_globals(self) -> list[tuple[dict[str, Any], str, Any]]:
        return [(f.__globals__, name, value) for (f, name), value in self.globals.items() if is_foreign(f)]

    @cached_property
    def _watched_code(self) -> list[tuple[FunctionType, CodeType]]:
        return [(function, function.__code__) for function in self.functions if is_foreign(function)]

    @cached_property
    def _watched_cells(self) -> list[tuple[CellType, Any]]:
        return [(cell, value) for function, cell, value in self.cells if is_foreign(function)]

    def _unvisited_members(self) -> list[tuple[type, str]]:
        """Members whose names are reached by now, in the same order in every process."""
        names = sorted(self._names)
        return [
            (base, name)
            for base in self._bases()
            for name in names
            if name in vars(base) and (base, name) not in self.members and name not in NAMEDTUPLE_MEMBERS
        ]

    def _bases(self) -> Iterator[type]:
        """The classes in which members are looked up, in order, some more than once."""
        return (base for kind in self._owners for base in kind.__mro__ if package_of(base) not in LIBRARIES)

    def _visit_member(self, kind: type, name: str) -> None:
        if (kind, name) in self.members:
            return
        member = self.members[kind, name] = vars(kind)[name]
        self._add(kind.__qualname__, name)
        function = member.fget if isinstance(member, property) else member
        if isinstance(function, classmethod | staticmethod):
            function = function.__func__
        if isinstance(function, FunctionType):
            self._visit_function(function)
        elif type(function).__name__ != "_tuplegetter":  # a field
            self._visit(function)

    def _visit(self, thing: Any) -> None:
        if isinstance(thing, bool | int | float | complex | str | bytes | slice | Enum | np.generic | np.dtype | None):
            self._add(type(thing), thing)
            return
        known = self._seen.setdefault(id(thing), len(self._seen))
        self._add(known)  # which of the things met before it is, if it is one of them
        if known < len(self._kept):
            return
        self._kept.append(thing)
        self._add(package_of(thing), getattr(thing, "__qualname__", None), getattr(thing, "__name__", None))
        if isinstance(thing, FunctionType):
            if package_of(thing) not in LIBRARIES:
                self._visit_function(thing)
        elif isinstance(thing, type):
            self._visit_class(thing)
        elif isinstance(thing, np.ndarray):
            self._has_mutable = True
            self._add(thing.dtype, thing.shape)
            self._hash.update(thing.tobytes())
        elif isinstance(thing, tuple):
            self._add(len(thing))
            self._visit(type(thing))
            for part in thing:
                self._visit(part)
        elif package_of(type(thing)) == "numba":
            self._visit_numba_object(thing)

    def _visit_numba_object(self, thing: Any) -> None:
        """Visits what @njit, @vectorize, @guvectorize or @cfunc has made, or a type of Numba's."""
        self._has_mutable = True
        self._add(type(thing).__qualname__)
        inner = getattr(thing, "gufunc_builder", thing)
        found = [getattr(inner, name, None) for name in ("py_func", "__wrapped__", "_pyfunc")]
        functions = [function for function in found if isinstance(function, FunctionType)]
        if functions:
            self._visit(functions[0])
        else:
            self._add(re.sub(r"0x[0-9a-f]+", "", str(thing)))

    def _visit_class(self, kind: type) -> None:
        if package_of(kind) in LIBRARIES:
            return
        self._add(kind.__qualname__, getattr(kind, "_fields", ()))
        if issubclass(kind, tuple) and hasattr(kind, "_fields"):
            self.classes[kind] = None
            for name, default in getattr(kind, "_field_defaults", {}).items():
                if isinstance(default, bool | int | float | str | Enum | None):  # others are refused where one is used
                    self._add(name, type(default), default)
        self._owners[kind] = None
        if issubclass(kind, Enum):
            self._add(*(base.__qualname__ for base in kind.__mro__))  # an IntEnum equals numbers, an Enum does not
            for member in kind:
                self._visit(member)

    def _visit_function(self, function: FunctionType) -> None:
        if function in self.functions:
            return
        self.functions[function] = None
        self._add(function.__qualname__)
        self._visit(function.__defaults__)
        for name, value in sorted((function.__kwdefaults__ or {}).items()):
            self._has_mutable = True
            self._add(name)
            self._visit(value)
        names = self._hash_bytecode(function.__code__)
        self._names.update(dict.fromkeys(names))
        loaded = global_names(function.__code__)
        self._remember(function.__globals__, loaded)
        for name in sorted(loaded & function.__globals__.keys()):
            self._add(name)
            self.globals[function, name] = function.__globals__[name]
            self._visit_global(function, function.__globals__[name], names)
        for cell in function.__closure__ or ():
            self.cells.append((function, cell, inside(cell)))
            self._visit(inside(cell))

    def _visit_global(self, function: FunctionType, value: Any, names: set[str]) -> None:
        """Visits the value of a global name; of a module, what the code may take from it by the names it uses."""
        if not isinstance(value, ModuleType):
            self._visit(value)
            return
        self._add(value.__name__)
        if package_of(value) not in LIBRARIES:
            self._remember(vars(value), names)
            for name in sorted(names & vars(value).keys()):
                self._add(name)
                self.attributes.append((function, value, name, vars(value)[name]))
                self._visit_global(function, vars(value)[name], names - {name})

    def _remember(self, space: dict[str, Any], names: set[str]) -> None:
        """Remembers what names stand for, including those that stand for nothing yet."""
        for name in names:
            self._looked_up[id(space), name] = (space, name, space.get(name, _ABSENT))

    def _hash_bytecode(self, code: CodeType) -> set[str]:
        """Hashes the byte code and returns the names it uses, those of inner functions and comprehensions included."""
        names = set(code.co_names)
        self._add(code.co_code, code.co_names, code.co_varnames, code.co_freevars)
        for constant in code.co_consts:
            if isinstance(constant, CodeType):
                names |= self._hash_bytecode(constant)
            else:
                self._add(type(constant), in_order(constant))
        return names

    def _add(self, *things: Any) -> None:
        self._hash.update(repr(things).encode())


def arrays_in(*values: Any) -> Iterator[np.ndarray[Any, Any]]:
    """The arrays among the values, and in tuples among them."""
    for value in values:
        if isinstance(value, np.ndarray):
            yield value
        elif isinstance(value, tuple):
            yield from arrays_in(*tuple.__iter__(value))


def is_foreign(thing: Any) -> bool:
    """Whether a class, function or module is not the package's own."""
    return not is_ours(thing)


def classes_of(value: Any) -> Iterator[type]:
    """The NamedTuple classes of a value and of everything in it."""
    if isinstance(value, tuple):
        if hasattr(value, "_fields"):
            yield type(value)
        for part in tuple.__iter__(value):  # whatever the class makes of `for`
            yield from classes_of(part)


@cache
def _hash_of_compiler() -> str:
    """A hash of this package, which decides how code is compiled: other versions of it do not share a disk cache."""
    return hashlib.sha256(
        b"".join(file.read_bytes() for file in sorted(Path(__file__).parent.glob("*.py")))
    ).hexdigest()

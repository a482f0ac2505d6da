"""What code a loop can reach, and its fingerprint, so that machine code is never run for code that has changed."""

import hashlib
import sys
from collections.abc import Callable, Iterator
from enum import Enum
from functools import cache
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

LIBRARIES = frozenset({"builtins", "math", "numba", "numpy", "typing", "collections", "gymnasium", "operator", "sys"})
"""Packages whose code does not change under the feet of a session."""
NAMEDTUPLE_OWN = frozenset({"_make", "_replace", "_asdict", "_fields", "_field_defaults"})
"""What every NamedTuple has."""


class Code:
    """The code that a loop over some values can reach: its classes, its helper functions, and their fingerprint.

    Attributes:
        classes: every NamedTuple class met, those of the values and those that methods name.
        functions: every plain function met: the loop, methods, properties and helpers.
        fingerprint: a hash of all this code and of the global constants it reads.
    """

    def __init__(self, loop: Callable[..., Any], values: tuple[Any, ...]) -> None:
        """Walk through all that `loop(*values)` can reach."""
        self.classes: dict[type, None] = {}
        self.functions: dict[FunctionType, None] = {}
        self._seen: dict[int, int] = {}
        self._kept: list[Any] = []  # ids stay unique while the objects live
        self._hash = hashlib.sha256()
        self._add(_compilers_own_code())
        self._visit(loop)
        for kind in classes_of(values):
            self._visit(kind)
        self.fingerprint = self._hash.hexdigest()[:24]

    @property
    def foreign(self) -> bool:
        """Whether any of it is not the package's own, but a student's."""
        return any(package(thing) != "edugym" for thing in (*self.classes, *self.functions))

    @property
    def foreign_files(self) -> set[str]:
        """The files, or cells, of those of its functions that are not the package's own."""
        return {function.__code__.co_filename for function in self.functions if package(function) != "edugym"}

    @property
    def importable(self) -> bool:
        """Whether another process finds the same classes by name, so that it can use what this one leaves on disk."""
        return all(
            getattr(sys.modules.get(kind.__module__), kind.__qualname__, None) is kind and kind.__module__ != "__main__"
            for kind in self.classes
        )

    def names(self) -> str:
        """The classes that are not the package's own, or else all of them, for a message."""
        own = [kind.__name__ for kind in self.classes if package(kind) != "edugym"]
        return ", ".join(own or [kind.__name__ for kind in self.classes])

    def _visit(self, thing: Any) -> None:
        if isinstance(thing, bool | int | float | complex | str | bytes | slice | Enum | np.generic | None):
            self._add(type(thing), thing)
            return
        known = self._seen.setdefault(id(thing), len(self._seen))
        self._add(known)  # which of the things met before it is, if it is one of them
        if known < len(self._kept):
            return
        self._kept.append(thing)
        self._add(package(thing), getattr(thing, "__qualname__", None), getattr(thing, "__name__", None))
        if isinstance(thing, FunctionType):
            if package(thing) not in LIBRARIES:
                self._function(thing)
        elif isinstance(thing, type):
            self._class(thing)
        elif isinstance(thing, np.ndarray):
            self._add(thing.dtype, thing.shape, thing.tobytes())
        elif isinstance(thing, tuple | frozenset | dict):
            self._add(len(thing))
            self._visit(type(thing))
            for part in thing.items() if isinstance(thing, dict) else thing:
                self._visit(part)
        elif hasattr(thing, "py_func"):  # already decorated with Numba's own @njit
            self._visit(thing.py_func)

    def _class(self, kind: type) -> None:
        if package(kind) in LIBRARIES:
            return
        self._add(kind.__qualname__, getattr(kind, "_fields", ()))
        if issubclass(kind, tuple) and hasattr(kind, "_fields"):
            self.classes[kind] = None
        for base in kind.__mro__:
            if package(base) in LIBRARIES:
                continue
            for name, member in sorted(vars(base).items(), key=lambda item: item[0]):
                if name in NAMEDTUPLE_OWN or (name.startswith("__") and name.endswith("__")):
                    continue
                self._add(name)
                function = member.fget if isinstance(member, property) else member
                if isinstance(function, FunctionType):
                    self._function(function)
                elif not isinstance(function, classmethod | staticmethod):
                    self._visit(function)

    def _function(self, function: FunctionType) -> None:
        self.functions[function] = None
        self._add(function.__qualname__)
        self._visit(function.__defaults__)
        self._visit(function.__kwdefaults__)
        names = self._code(function.__code__)
        for name in sorted(names & function.__globals__.keys()):
            self._add(name)
            self._reached(function.__globals__[name], names)
        for cell in function.__closure__ or ():
            self._visit(cell.cell_contents)

    def _reached(self, value: Any, names: set[str]) -> None:
        """What a global name stands for; of a module, what the code may take from it by one of the names it uses."""
        if not isinstance(value, ModuleType):
            self._visit(value)
            return
        self._add(value.__name__)
        if package(value) not in LIBRARIES:
            for name in sorted(names & vars(value).keys()):
                self._add(name)
                self._reached(vars(value)[name], names - {name})

    def _code(self, code: CodeType) -> set[str]:
        """Hash the byte code and give the names it uses, those of inner functions and comprehensions included."""
        names = set(code.co_names)
        self._add(code.co_code, code.co_names, code.co_varnames, code.co_freevars)
        for constant in code.co_consts:
            if isinstance(constant, CodeType):
                names |= self._code(constant)
            else:
                self._add(type(constant), constant)
        return names

    def _add(self, *things: Any) -> None:
        self._hash.update(repr(things).encode())


def package(thing: Any) -> str:
    """The package in which a class, function or module is defined."""
    name = thing.__name__ if isinstance(thing, ModuleType) else getattr(thing, "__module__", None)
    return (name or "").partition(".")[0]


def classes_of(value: Any) -> Iterator[type]:
    """The NamedTuple classes of a value and of everything in it."""
    if isinstance(value, tuple):
        if hasattr(value, "_fields"):
            yield type(value)
        for part in value:
            yield from classes_of(part)


@cache
def _compilers_own_code() -> str:
    """A hash of the files that decide how code is compiled: what an older version of them left on disk is not used."""
    here = Path(__file__)
    return hashlib.sha256(
        b"".join(here.with_name(name).read_bytes() for name in ("code.py", "compiler.py"))
    ).hexdigest()

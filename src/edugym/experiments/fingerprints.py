"""Fingerprints of what determines a run: values, and all code that they reach.

`repeat` reuses a stored run only if its fingerprint shows that nothing that determines it has changed.
"""

import ast
import dis
import functools
import hashlib
import importlib.util
import inspect
import platform
import struct
import sys
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from types import BuiltinFunctionType, CodeType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

from edugym.system.packages import OURS, is_installed, own_folders


def fingerprint(*values: Any) -> str:
    """A hash that two processes agree on exactly if their values and the code of these are the same.

    Code of libraries counts by its version, that of this package by all of its files, and every other function or class
    by its byte code, its constants and whatever it reaches in turn.

    Raises:
        Exception: a value cannot be taken apart, such as an open file (what is raised depends on its class).
    """
    hasher = _Hasher()
    hasher.add(platform.machine(), versions(), _own_code())
    for value in values:
        hasher.visit(value)
    return hasher.hash.hexdigest()[:32]


def versions(*more: str) -> str:
    """The versions of what the numbers depend on: these packages, and `more` of those that are installed."""
    packages = ("edugym", "numpy", "numba", "gymnasium", *more)
    found = [f"{package} {version_of(package)}" for package in packages if version_of(package)]
    return ", ".join([f"python {platform.python_version()}", *found])


DEEP = ("torch", "stable-baselines3", "sb3-contrib")


def deep_versions() -> str:
    """The versions of what the numbers of deep agents depend on."""
    return versions(*DEEP)


class _Hasher:
    """Hashes values and all that they reach, each object once."""

    def __init__(self) -> None:
        self.hash = hashlib.sha256()
        self._seen: dict[int, int] = {}
        self._kept: list[Any] = []  # while an object lives, no other one has its id

    def add(self, *things: Any) -> None:
        """Hash values that are distinguished by their `repr`."""
        self.hash.update(repr(things).encode())

    def visit(self, thing: Any) -> None:
        """Hash a value of any kind."""
        if type(thing) is float:
            self.add("float", struct.pack("<d", thing))
        elif thing is None or type(thing) in _PLAIN:
            self.add(type(thing).__name__, thing)
        elif isinstance(thing, np.generic) and not thing.dtype.hasobject:
            self._array(thing)
        elif id(thing) in self._seen:
            self.add("again", self._seen[id(thing)])
        else:
            self._seen[id(thing)] = len(self._seen)
            self._kept.append(thing)
            self._visit_object(thing)

    def _visit_object(self, thing: Any) -> None:
        self.add(type(thing).__module__, type(thing).__qualname__)
        if type(thing) is np.ndarray and not thing.dtype.hasobject:
            self._array(thing)
        elif isinstance(thing, ModuleType | BuiltinFunctionType) or is_library(thing):
            self.add(_name(thing), version_of(_package(thing)))
            if isinstance(thing, FunctionType) and _package(thing) in OURS:
                self._closure(thing)  # functions that one factory made have the same name
        elif isinstance(thing, FunctionType):
            self._function(thing)
        elif isinstance(thing, type):
            self._class(thing)
        elif isinstance(thing, MethodType):
            self._visit_all(thing.__func__, thing.__self__)
        elif isinstance(thing, functools.partial):
            self._visit_all(thing.func, thing.args, thing.keywords)
        elif isinstance(thing, property):
            self._visit_all(thing.fget)
        elif isinstance(thing, functools.cached_property):
            self._visit_all(thing.func)
        elif inspect.isfunction(inner := getattr(thing, "__wrapped__", getattr(thing, "py_func", None))):
            self._visit_all(inner)  # cached, or decorated with Numba's own @njit
        elif isinstance(thing, classmethod | staticmethod):
            self._visit_all(thing.__func__)
        elif isinstance(thing, tuple | list):
            self._visit_all(type(thing), len(thing), *thing, getattr(thing, "__dict__", None))
        elif isinstance(thing, Mapping):
            names = ("default_factory",) if is_library(type(thing)) else ("__dict__", "default_factory")
            attributes = (getattr(thing, name, None) for name in names)
            self._visit_all(type(thing), len(thing), *(part for item in thing.items() for part in item), *attributes)
        elif isinstance(thing, set | frozenset):
            self.add(sorted(fingerprint(part) for part in thing))
        else:
            parts: Any = thing.__reduce_ex__(4)
            self._visit_all(type(thing), *parts[1:3])
            for contents in parts[3:5]:  # those of a list, and of a dictionary
                self._visit_all(*(contents or ()))

    def _array(self, array: Any) -> None:
        self.add("array", array.dtype.str, array.shape, np.ascontiguousarray(array).tobytes())

    def _visit_all(self, *things: Any) -> None:
        for thing in things:
            self.visit(thing)

    def _class(self, kind: type) -> None:
        self.add(kind.__qualname__)
        self._visit_all(*kind.__bases__)
        for name, member in sorted(vars(kind).items()):
            if name not in _OF_EVERY_CLASS:
                self.add(name)
                self.visit(member)

    def _function(self, function: FunctionType) -> None:
        self.add(function.__qualname__)
        self._visit_all(function.__defaults__, function.__kwdefaults__)
        names = self._code(function.__code__)
        self._visit_all({name: value for name, value in vars(function).items() if name in names})
        for top in sorted(_imported(function.__code__, function.__globals__.get("__package__") or "")):
            self._module_of(top, set())
        for name in sorted(names & function.__globals__.keys()):
            self.add(name)
            self._visit_global(function.__globals__[name], names)
        self._closure(function)

    def _closure(self, function: FunctionType) -> None:
        for cell in function.__closure__ or ():
            with suppress(ValueError):  # not set yet
                self.visit(cell.cell_contents)

    def _visit_global(self, value: Any, names: set[str]) -> None:
        """Hash what a global name stands for; of a module, what the code may take from it."""
        self.visit(value)
        if isinstance(value, ModuleType) and not is_library(value):
            for name in sorted(names & vars(value).keys()):
                self.add(name)
                self._visit_global(vars(value)[name], names - {name})

    def _module_of(self, top: str, seen: set[str]) -> None:
        """Hash the files of a module or package that is not imported yet, and of those that it imports in turn."""
        if top in seen or top in {"", "__main__", *OURS}:
            return
        seen.add(top)
        places = _files_of(top)
        if _are_installed(places):
            self.add(top, version_of(top))
            return
        for place in places:
            for file in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
                contents = file.read_bytes()
                self.add(top, file.name, contents)
                with suppress(SyntaxError, ValueError):  # shows when it is called; or an extension module, not text
                    for inner in sorted(_top_level_imports(ast.parse(contents))):
                        self._module_of(inner, seen)

    def _code(self, code: CodeType) -> set[str]:
        """Hash the byte code, and return the names it uses, those of inner functions included."""
        names = set(code.co_names)
        self.add(code.co_code, code.co_names, code.co_varnames, code.co_freevars)
        for constant in code.co_consts:
            if isinstance(constant, CodeType):
                names |= self._code(constant)
            else:
                self.visit(constant)
        return names


def _imported(code: CodeType, package: str) -> set[str]:
    """The names of what a function imports when it is called, without what follows the first dot."""
    # Two instructions before IMPORT_NAME stands the level: above 0 it is a relative import.
    lines = [line for line in dis.get_instructions(code) if line.opname != "EXTENDED_ARG"]
    found = {
        (package if lines[k - 2].argval else line.argval).partition(".")[0]
        for k, line in enumerate(lines)
        if line.opname == "IMPORT_NAME"
    }
    return found.union(*(_imported(part, package) for part in code.co_consts if isinstance(part, CodeType)))


def _top_level_imports(tree: ast.AST) -> set[str]:
    """The names of what a file imports, without what follows the first dot.

    Relative imports are skipped: the whole folder is hashed.
    """
    names: list[str] = []
    for part in ast.walk(tree):
        if isinstance(part, ast.Import):
            names += [one.name for one in part.names]
        elif isinstance(part, ast.ImportFrom) and not part.level:
            names.append(part.module or "")
    return {name.partition(".")[0] for name in names}


def _files_of(top: str) -> list[Path]:
    """The file of a module, or the folders of a package; none of what is built into Python or missing."""
    try:
        spec = importlib.util.find_spec(top)
    except (ImportError, ValueError):
        return []
    if spec and spec.submodule_search_locations:
        return [*map(Path, spec.submodule_search_locations)]
    return [Path(spec.origin)] if spec and spec.origin and spec.has_location else []


_PLAIN = frozenset({bool, int, complex, str, bytes})
_OF_EVERY_CLASS = frozenset(
    {"__module__", "__dict__", "__weakref__", "__doc__", "__qualname__", "__firstlineno__", "__static_attributes__"}
    | {"__abstractmethods__", "_abc_impl", "__slotnames__", "__annotations__", "__parameters__", "__orig_bases__"}
    # Where Python 3.14 keeps annotations until somebody asks for them.
    | {"__annotate__", "__annotate_func__", "__annotations_cache__", "__classdictcell__", "__conditional_annotations__"}
)


def is_library(thing: Any) -> bool:
    """Whether a class, function or module belongs to this package, to Python or to an installed one."""
    if not isinstance(thing, ModuleType | FunctionType | type):
        return False
    top = _package(thing)
    return top in {"builtins", *OURS} or _is_installed(top)


@cache
def _is_installed(package: str) -> bool:
    if package == "__main__":
        return False
    module = sys.modules.get(package)
    if module is None:
        return False
    file = getattr(module, "__file__", None)
    places = [file] if file else [*getattr(module, "__path__", ())]  # a folder without __init__.py has no file
    return _are_installed([*map(Path, places)])


def _are_installed(places: list[Path]) -> bool:
    """Whether all places are in the folders of installed modules; what is built into Python has none."""
    return all(map(is_installed, places))


def _package(thing: Any) -> str:
    return _name(thing).partition(".")[0]


def _name(thing: Any) -> str:
    if isinstance(thing, ModuleType):
        return thing.__name__
    return f"{getattr(thing, '__module__', None) or 'builtins'}.{getattr(thing, '__qualname__', '')}"


@cache
def version_of(package: str) -> str:
    """The version of an installed package; "" where it has none."""
    try:
        return version(package)
    except PackageNotFoundError:  # numba where there is no compiler, or a module of Python's own
        return ""


@cache
def _own_code() -> str:
    """A hash of all of EduGym's own files."""
    digest = hashlib.sha256()
    for folder in own_folders():
        for path in sorted(folder.rglob("*.py")):
            digest.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()

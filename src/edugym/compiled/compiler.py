"""From plain Python to machine code: the one file that knows Numba (and `edugym.compiled.generators`, for it).

An MDP, an agent and a loop over them are plain Python. `compiled(loop, *arguments)` makes one machine-code function of
them all. Numba compiles functions of NamedTuples but does not know their methods; `_teach_numba` adds that, once: a
method, property or constant of *any* NamedTuple class is looked up in the class itself, so a class from a notebook cell
works as the package's own do, and plain helper functions compile along.

The machine code belongs to the *code* it was made from (`edugym.compiled.code`): redefine a class under its old name,
edit a method in place or change a global number, and the next call compiles anew. The same fingerprint names the folder
of the disk cache.
"""

import importlib
import inspect
import os
import re
import shutil
import threading
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

import numpy as np

from edugym.compiled.code import NAMEDTUPLE_OWN, Code
from edugym.interrupts import interruptibly

Function = Callable[..., Any]

_built: dict[tuple[Any, ...], Any] = {}
_lock = threading.RLock()
_loaded: list[Any] = []  # Numba, once it knows NamedTuple methods
# Of the build in progress, of which there is one at a time: Numba's options, the plain functions that may be compiled
# along, and those that were so far.
_options: dict[str, bool] = {}
_helpers: set[FunctionType] = set()
_parts: dict[FunctionType, Any] = {}


class CompilationError(Exception):
    """Something in the loop cannot be compiled: `str(error)` says what and, if known, where."""


class NoCompiler(CompilationError):
    """Nothing can be compiled here: Numba is not installed, or was switched off."""


def compiled(loop: Function, *arguments: Any, code: Code | None = None) -> Function:
    """The machine code of `loop` for arguments like these: same results, bit for bit, without the interpreter.

    Args:
        loop: a plain function; positional arguments only.
        *arguments: what it will be called with, or values of the same types.
        code: what the loop can reach, where the caller has walked through it already.

    Returns:
        A function with the behaviour of `loop`; array indices are checked (a table made for another environment is an
        `IndexError`, no crash).

    Raises:
        CompilationError: something in it cannot be compiled.
        NoCompiler: there is no compiler here.
    """
    numba = _numba()
    code = code or Code(loop, arguments)
    streams = [k for k, argument in enumerate(arguments) if isinstance(argument, np.random.Generator)]
    try:
        signature = tuple(map(numba.typeof, _located(arguments, streams)))
    except Exception as error:  # Numba has no one class for all that can be wrong
        raise CompilationError(_reason(error, code)) from error
    machine_code = _made(numba, loop, signature, code)
    namesake = False  # whether Numba's fast path, which compares names, takes a class for another one of the same name

    def run(*given: Any) -> Any:
        nonlocal namesake
        arguments = _located(given, streams)
        if not namesake:
            try:
                return machine_code(*arguments)
            except TypeError as error:
                if "No matching definition" not in str(error):
                    raise
        if tuple(map(numba.typeof, arguments)) == signature:
            namesake = True
            return machine_code.overloads[signature].entry_point(*arguments)
        return compiled(loop, *given)(*given)  # types have changed on the way: an int became a float

    return run


def _located(arguments: tuple[Any, ...], streams: list[int]) -> tuple[Any, ...]:
    """The arguments, with the random generators in the places `streams` as machine code takes them."""
    located, values = _locate(), list(arguments)
    for k in streams:
        values[k] = located(values[k])
    return tuple(values)


@cache
def _locate() -> Callable[[Any], Any]:
    """What finds the addresses of a random generator, or gives it back as it is where Numba is not as expected."""
    try:
        located: Callable[[Any], Any] = importlib.import_module("edugym.compiled.generators").located
    except (ImportError, AttributeError):
        return lambda rng: rng
    return located


def cache_directory() -> Path:
    """Where machine code is kept between runs: $EDUGYM_CACHE_DIR, or `edugym` in the user's cache directory."""
    chosen = os.environ.get("EDUGYM_CACHE_DIR")
    return Path(chosen) if chosen else Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "edugym"


def is_built(loop: Function, code: Code) -> bool:
    """Whether this process holds machine code of the loop over this code."""
    made_of = (loop, code.fingerprint, *code.classes)
    return any(key[: len(made_of)] == made_of for key in _built)


def is_on_disk(code: Code) -> bool:
    """Whether an earlier run has left machine code of it."""
    return any(folder.exists() for folder in _folders(code))


def _folders(code: Code) -> tuple[Path, Path]:
    """Where builds without and with reference counts are kept."""
    name = f"{code.fingerprint}-{_numba().__version__}"
    return cache_directory() / f"{name}-lean", cache_directory() / name


def _made(numba: Any, loop: Function, signature: tuple[Any, ...], code: Code) -> Any:
    """The build, made when it is first asked for; what cannot be built is not tried again."""
    key = (loop, code.fingerprint, *code.classes, signature)
    if key not in _built:
        interruptibly(_make, key, numba, loop, signature, code)
    if isinstance(_built[key], CompilationError):
        raise CompilationError(str(_built[key]))
    return _built[key]


def _make(key: tuple[Any, ...], numba: Any, loop: Function, signature: tuple[Any, ...], code: Code) -> None:
    """Build it, unless another thread just did; one build at a time."""
    with _lock:
        if key not in _built:
            try:
                _built[key] = _build(numba, loop, signature, code)
            except Exception as error:
                _built[key] = CompilationError(_reason(error, code))


def _build(numba: Any, loop: Function, signature: tuple[Any, ...], code: Code) -> Any:
    """Compile: if possible without reference counts, else with them.

    Where nothing allocates, reference counts do nothing but cost: without them the loop is faster, and checks of array
    indices are nearly free (Q-learning on Boulder 8 ns a step; with counts 6 unchecked, 70 checked).
    """
    lean, counting = _folders(code)
    if not counting.exists() and all(_countless(kind) for kind in signature):
        try:
            made = _compile(numba, loop, signature, lean, code, {"_nrt": False, "boundscheck": True})
            if _counts_nothing(made.overloads[signature], lean):
                return made
        except Exception:  # something allocates: what is wrong besides will show in the build that may
            pass
        shutil.rmtree(lean, ignore_errors=True)
    return _compile(numba, loop, signature, counting, code, {"boundscheck": True})


def _compile(
    numba: Any, loop: Function, signature: tuple[Any, ...], folder: Path, code: Code, options: dict[str, bool]
) -> Any:
    """One build by a dispatcher of its own, since Numba's fast path tells classes apart by their names alone."""
    keep = code.importable and Path(loop.__code__.co_filename).is_file() and _writable(folder)
    users_own = numba.config.CACHE_DIR
    try:
        numba.config.CACHE_DIR = str(folder) if keep else users_own
        made = numba.njit(cache=keep, nogil=True, **options)(loop)
    finally:
        numba.config.CACHE_DIR = users_own
    _options.update(options)
    _helpers.update(code.functions)
    try:
        with warnings.catch_warnings():  # what Numba finds remarkable says nothing to a student
            warnings.simplefilter("ignore", importlib.import_module("numba.core.errors").NumbaWarning)
            made.compile(signature)
    finally:
        _options.clear()
        _helpers.clear()
        _parts.clear()  # the globals that it read may have changed by the next build
    made.disable_compile()  # left to itself it would compile for other types without these options
    return made


def _countless(kind: Any) -> bool:
    """Whether a value of this type is safe in a build without reference counts: numbers, arrays, and tuples of them."""
    types = _numba().types
    if isinstance(kind, types.BaseTuple):
        return all(_countless(part) for part in kind)
    generator = types.NumPyRandomGeneratorType
    return isinstance(kind, types.Number | types.Boolean | types.NoneType | types.Array | generator)


def _counts_nothing(build: Any, folder: Path) -> bool:
    """Whether no reference counting crept in after all: it would leak, as would an array that is returned.

    What has passed is marked on the disk, so that what is found there unmarked is not trusted.
    """
    types, passed = _numba().types, folder / "passed"

    def only_numbers(kind: Any) -> bool:
        return all(map(only_numbers, kind)) if isinstance(kind, types.BaseTuple) else not isinstance(kind, types.Array)

    if not (_countless(build.signature.return_type) and only_numbers(build.signature.return_type)):
        return False
    if build.metadata is None:  # from the disk
        return passed.exists()
    if re.search(r"call [^\n]*@NRT_(?!meminfo_new_from_pyobject)", build.library.get_llvm_str()):
        return False
    if folder.exists():
        passed.touch()
    return True


def _writable(folder: Path) -> bool:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    return os.access(folder, os.W_OK)


def _reason(error: Exception, code: Code) -> str:
    """The line of Numba's message that says what is wrong, and the last line of the student's code that it names."""
    text = re.sub(r"\x1b\[[0-9;]*m", "", str(error))
    says = [line.strip() for line in text.splitlines() if line.strip()]
    frame = ("Failed in", "No implementation", ">>>", "There ", "- ", "Overload", "With arg", "Rejected", "During")
    first = next((line for line in says if not line.startswith(frame)), type(error).__name__)
    own = {Path(file).name for file in code.foreign_files}
    places = [place for place in re.findall(r'File "([^"]+)", line (\d+)', text) if Path(place[0]).name in own]
    return f"{first} ({places[-1][0]}, line {places[-1][1]})" if places else first


@cache
def _numba() -> Any:
    """Numba, with its knowledge of NamedTuple methods; imported when it is first needed."""
    return interruptibly(_load_numba)


def _load_numba() -> Any:
    with _lock:
        if _loaded:  # by a thread that nobody waited for any more
            return _loaded[0]
        try:
            numba = importlib.import_module("numba")
        except ImportError as error:
            raise NoCompiler("Numba is not installed") from error
        if numba.config.DISABLE_JIT:
            raise NoCompiler("Numba is switched off by NUMBA_DISABLE_JIT")
        _teach_numba(numba)
        _loaded.append(numba)
        return numba


def _member(kind: Any, name: str) -> Any:
    """The method, property or constant `name` of a NamedTuple class, or None (fields are Numba's own business)."""
    if name in kind.fields or name in NAMEDTUPLE_OWN:
        return None
    return inspect.getattr_static(kind.instance_class, name, None)


def _teach_numba(numba: Any) -> None:
    """Look up what Numba does not know of a NamedTuple, its methods, properties and constants, in its class."""
    types, typeof, extending = numba.types, numba.typeof, numba.extending
    imputils: Any = importlib.import_module("numba.core.imputils")
    templates: Any = importlib.import_module("numba.core.typing.templates")
    tuples: Any = importlib.import_module("numba.cpython.tupleobj")
    purpose: Any = importlib.import_module("numba.core.typing.typeof").Purpose

    def part(function: FunctionType) -> Any:
        """The type of a method or helper, compiled with the options of the build in progress."""
        if function not in _parts:
            _parts[function] = numba.njit(**_options)(function)
        return types.Dispatcher(_parts[function])

    def call(context: Any, builder: Any, function: FunctionType, kinds: Any, values: Any) -> Any:
        """The machine code of a call."""
        callee = part(function)
        implementation = context.get_function(callee, callee.get_call_type(context.typing_context, kinds, {}))
        context.add_linking_libs(getattr(implementation, "libs", ()))
        return implementation(builder, values)

    @cache
    def lower_method(name: str) -> None:
        """How any NamedTuple's method of this name is called."""

        def method(context: Any, builder: Any, signature: Any, values: Any) -> Any:
            if len(values) < len(signature.args):  # Numba leaves out a self without fields
                values = [context.make_tuple(builder, signature.args[0], ()), *values]
            return call(context, builder, _member(signature.args[0], name), signature.args, values)

        key = (types.BaseNamedTuple, name)
        extending.lower_builtin(key, types.BaseNamedTuple, types.VarArg(types.Any))(method)

    def resolve(template: Any, kind: Any, name: str) -> Any:
        """The type of a member, or None where there is none."""
        member = _member(kind, name)
        if isinstance(member, FunctionType):
            lower_method(name)

            def generic(method: Any, kinds: Any, keywords: Any) -> Any:
                return part(member).get_call_type(method.context, (kind, *kinds), keywords).as_method()

            members = {"key": (types.BaseNamedTuple, name), "generic": generic}
            return types.BoundFunction(type("Method", (templates.AbstractTemplate,), members), kind)
        if isinstance(member, property):
            return part(function_of(member)).get_call_type(template.context, (kind,), {}).return_type
        return typeof(member) if isinstance(member, bool | int | float | str | tuple) else None

    def function_of(member: property) -> Any:
        return member.fget

    def read(context: Any, builder: Any, kind: Any, value: Any, name: str) -> Any:
        """The machine code that reads a field, a property or a constant."""
        member = _member(kind, name)
        if member is None:
            return tuples.namedtuple_getattr(context, builder, kind, value, name)
        if isinstance(member, property):
            return call(context, builder, function_of(member), (kind,), (value,))
        return context.get_constant_generic(builder, typeof(member), member)

    def helper(function: FunctionType, context: Any) -> Any:
        """A plain function that a method calls compiles along (Numba alone asks for a decorator on it)."""
        return part(function) if function in _helpers and context.purpose is purpose.constant else None

    for kind_of_tuple in (types.NamedTuple, types.NamedUniTuple):
        members = {"key": kind_of_tuple, "generic_resolve": resolve}
        templates.infer_getattr(type("Members", (templates.AttributeTemplate,), members))
        imputils.lower_getattr_generic(kind_of_tuple)(read)
    extending.typeof_impl.register(FunctionType)(helper)

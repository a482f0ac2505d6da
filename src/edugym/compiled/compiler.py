"""Compiles plain Python to machine code.

An MDP, an agent and a loop over them are plain Python. `compiled(loop, *arguments)` makes one machine-code function of
them all, with `edugym.compiled.namedtuples` and `edugym.compiled.compiler_pipelines`.

The machine code belongs to the *code* it was made from (`edugym.compiled.code`): redefine a class under its old name,
edit a method in place or change a global number, and the next call compiles anew. The same fingerprint names the folder
of the disk cache.
"""

import importlib
import logging
import math
import re
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from edugym.compiled.code import Code, code_of, is_foreign
from edugym.compiled.disk import SEAL, cache_directory, is_whole, new_folder, publish, remove, seal
from edugym.compiled.error_messages import reason
from edugym.compiled.numba_setup import CompilationError, numba_ready, processor, refused_error, replacements
from edugym.system.interrupts import Stopped
from edugym.system.other_threads import HAS_CLOCKS, call_within

Function = Callable[..., Any]


class _Key(NamedTuple):
    """The key of a build: the loop, all code that it reaches, the types of the arguments, and the classes."""

    loop: Function
    fingerprint: str
    signature: tuple[Any, ...]
    classes: tuple[type, ...]


_built: dict[_Key, Any] = {}
_build_seconds = [1.5]  # that the last build took which was not on the disk; at first an estimate
KEPT = 3
"""The number of builds of a loop that are kept for classes of the same names."""
MOST_SECONDS = 20.0
"""When compiling a student's code has taken so much processor time, it is given up."""
_too_long: list[tuple[Code, set[Any]]] = []  # what was given up, with students' classes: more takes no less
_lock = threading.RLock()
logger = logging.getLogger("edugym")
LEAN = {"_nrt": False, "boundscheck": True}
WITH_COUNTS = {"boundscheck": True}


def compiled(loop: Function, *arguments: Any, code: Code | None = None) -> Function:
    """Machine code of `loop` for arguments like these, with the same results, bit for bit.

    Args:
        loop: a plain function; positional arguments only.
        *arguments: what it will be called with, or values of the same types.
        code: the code that the loop can reach, if the caller knows it.

    Returns:
        A function with the behaviour of `loop`; array indices are checked (a table made for another environment is an
        `IndexError`, no crash).

    Raises:
        CompilationError: something in it cannot be compiled.
        NoCompiler: there is no compiler here.
    """
    numba = numba_ready()
    code = code or code_of(loop, arguments)
    streams = [k for k, argument in enumerate(arguments) if isinstance(argument, np.random.Generator)]
    try:
        signature = tuple(map(numba.typeof, _with_located(arguments, streams)))
    except Exception as error:  # Numba has no one class for all that can be wrong
        raise CompilationError(_reason(error, code)) from error
    machine_code = _find_or_build(numba, loop, signature, code)
    kinds = _kinds(arguments)
    namesake = False  # whether Numba's fast path confuses a class with another of the same name

    def run(*given: Any) -> Any:
        nonlocal namesake
        arguments = _with_located(given, streams)
        if not namesake and _kinds(given) == kinds:
            try:
                return machine_code(*arguments)
            except TypeError as error:
                if "No matching definition" not in str(error):
                    raise
                namesake = True
        if tuple(map(numba.typeof, arguments)) != signature:
            return compiled(loop, *given)(*given)  # types have changed on the way: an int became a float
        return next(iter(machine_code.overloads.values())).entry_point(*arguments)

    return run


def _kinds(value: Any) -> Any:
    """The classes of all parts of a value: Numba may take a float for an int, and cut it, without a word."""
    if isinstance(value, tuple):
        return type(value), *map(_kinds, tuple.__iter__(value))
    return type(value)


def _with_located(arguments: tuple[Any, ...], streams: list[int]) -> tuple[Any, ...]:
    """The arguments, with the random generators in the places `streams` passed by their addresses."""
    located, values = _locator(), list(arguments)
    for k in streams:
        values[k] = located(values[k])
    return tuple(values)


@cache
def _locator() -> Callable[[Any], Any]:
    """The function that finds the addresses of a generator; where Numba is not as expected it returns its argument."""
    try:
        located: Callable[[Any], Any] = importlib.import_module("edugym.compiled.random_generators").located
    except (ImportError, AttributeError):
        return lambda rng: rng
    return located


def is_built(loop: Function, code: Code) -> bool:
    """Whether this process holds machine code of the loop over this code."""
    return any(key.loop is loop and key.fingerprint == code.fingerprint for key in list(_built))


def is_on_disk(code: Code) -> bool:
    """Whether an earlier run has left machine code of it; answered without loading Numba."""
    return any(cache_directory().glob(f"{code.fingerprint}-*"))


def seconds_to_build() -> float:
    """Estimates how long the next build takes: as long as the last one. Before the first, Numba is loaded."""
    return _build_seconds[-1]


def _folders(code: Code) -> tuple[Path, Path]:
    """Where builds without and with reference counts are kept."""
    name = f"{code.fingerprint}-{numba_ready().__version__}-{processor()}"
    return cache_directory() / f"{name}-lean", cache_directory() / name


def _find_or_build(numba: Any, loop: Function, signature: tuple[Any, ...], code: Code) -> Any:
    """The build, made when it is first needed; a build that has failed is not tried again.

    When the cell of a class is run again unchanged, nothing is built: the same code has the same fingerprint, and
    machine code that returns no value of the class serves both classes.
    """
    if _find(loop, signature, code) is None:
        seconds = MOST_SECONDS if code.foreign else math.inf
        own = {kind for kind in code.classes if is_foreign(kind)} | set(map(str, _types_of_students(signature)))
        known = any(classes <= own and one.first_change() is None for one, classes in _too_long)
        try:
            if known and not is_on_disk(code):
                raise TimeoutError
            call_within(seconds, _build_once, numba, loop, signature, code)
        except TimeoutError:
            if own and HAS_CLOCKS and not known:
                _too_long.append((code, own))
            made = CompilationError(f"compiling takes longer than {seconds:.0f} s: make its methods shorter")
            _built[_Key(loop, code.fingerprint, signature, tuple(code.classes))] = made
    made = _find(loop, signature, code)
    if isinstance(made, CompilationError):
        raise CompilationError(str(made))
    return made


def _types_of_students(kinds: Iterable[Any]) -> Iterator[Any]:
    """The types of students' NamedTuples, which tell the lengths of their tuples, in some types and within them."""
    for kind in kinds:
        if isinstance(kind, numba_ready().types.BaseTuple):
            if hasattr(kind, "instance_class") and is_foreign(kind.instance_class):
                yield kind
            yield from _types_of_students(kind)


def _find(loop: Function, signature: tuple[Any, ...], code: Code) -> Any:
    """The build for these types and this code, or the error of building it; None if there is neither."""
    classes = tuple(code.classes)
    for key, made in list(_built.items()):
        same = key.loop is loop and key.fingerprint == code.fingerprint and _alike(key.signature, signature)
        if same and (key.classes == classes or isinstance(made, CompilationError) or not _returns_class(made)):
            return made
    return None


def _build_once(late: threading.Event, numba: Any, loop: Function, signature: tuple[Any, ...], code: Code) -> None:
    """Builds it, unless another thread just did; one build at a time.

    Of classes that have changed only the latest builds are kept, since each takes 2 MB.

    Raises:
        TimeoutError: `late` was set, and it stopped before its next pass.
    """
    with _lock:
        if _find(loop, signature, code) is not None:
            return
        try:
            with importlib.import_module("edugym.compiled.compiler_pipelines").stopping_when(late):
                made = _build(numba, loop, signature, code)
        except Stopped:
            raise TimeoutError from None
        except Exception as error:
            made = CompilationError(_reason(error, code))
        _built[_Key(loop, code.fingerprint, signature, tuple(code.classes))] = made
        older = [other for other in list(_built) if other.loop is loop and _alike(other.signature, signature)][:-KEPT]
        for other in older:
            del _built[other]


def _alike(one: tuple[Any, ...], other: tuple[Any, ...]) -> bool:
    """Whether types are the same, or differ only in NamedTuple classes of the same names and fields."""
    types = numba_ready().types

    def same(kind: Any, other_kind: Any) -> bool:
        if kind is other_kind or kind == other_kind:
            return True
        if not (isinstance(kind, types.BaseNamedTuple) and isinstance(other_kind, types.BaseNamedTuple)):
            return False
        first, second = kind.instance_class, other_kind.instance_class
        return (
            first.__qualname__ == second.__qualname__ and first._fields == second._fields and _alike(kind, other_kind)
        )

    return len(one) == len(other) and all(map(same, one, other))


def _returns_class(made: Any) -> bool:
    """Whether machine code returns a value of a NamedTuple class, which would be the class it was made for."""
    types = numba_ready().types

    def has_class(kind: Any) -> bool:
        if isinstance(kind, types.BaseNamedTuple):
            return True
        return isinstance(kind, types.BaseTuple) and any(map(has_class, kind))

    return any(has_class(given.return_type) for given in made.nopython_signatures)


def _build(numba: Any, loop: Function, signature: tuple[Any, ...], code: Code) -> Any:
    """The build from the disk, or a new one."""
    lean, counting = _folders(code)
    keep = code.importable and Path(loop.__code__.co_filename).is_file()
    for folder, options in ((lean, LEAN), (counting, WITH_COUNTS)) if keep else ():
        if is_whole(folder):  # a build with counts was kept because the lean one failed
            try:
                return _compile(numba, loop, signature, folder, code, options)
            except Exception:  # made by a Numba that differs in something
                remove(folder)
    began = time.perf_counter()
    made = _build_anew(numba, loop, signature, code, *((lean, counting) if keep else (None, None)))
    _build_seconds[:] = [time.perf_counter() - began]
    return made


def _build_anew(
    numba: Any, loop: Function, signature: tuple[Any, ...], code: Code, lean: Path | None, counting: Path | None
) -> Any:
    """Compiles without reference counts if possible, else with them.

    Where nothing allocates, reference counts are useless. Without them the loop is faster, and checks of array indices
    are nearly free (Q-learning on Boulder 8 ns a step; with counts 6 unchecked, 70 checked).
    """
    if all(_needs_no_counts(kind) for kind in signature):
        try:
            return _build_and_keep(numba, loop, signature, lean, code, LEAN)
        except Exception as error:  # something allocates; any other mistake shows in the next build as well
            if isinstance(error, refused_error()):
                raise
            logger.debug("no build of %s without reference counts: %s", code.names(), _reason(error, code))
    return _build_and_keep(numba, loop, signature, counting, code, WITH_COUNTS)


def _build_and_keep(
    numba: Any, loop: Function, signature: tuple[Any, ...], folder: Path | None, code: Code, options: dict[str, bool]
) -> Any:
    """A new build, which is kept in the folder if that can be written."""
    unfinished = new_folder(folder) if folder else None
    try:
        made = _compile(numba, loop, signature, unfinished, code, options)
        if options is LEAN:
            _check_no_counts(made.overloads[signature])
    except BaseException as error:
        if unfinished:
            remove(unfinished)
        if isinstance(error, OSError) and unfinished:  # the disk is full
            return _build_and_keep(numba, loop, signature, None, code, options)
        raise
    if unfinished and folder:
        publish(unfinished, folder)
    return made


def _compile(
    numba: Any, loop: Function, signature: tuple[Any, ...], folder: Path | None, code: Code, options: dict[str, bool]
) -> Any:
    """Compiles with a dispatcher of its own, since Numba's fast path tells classes apart by their names alone."""
    users_own = numba.config.CACHE_DIR
    try:
        numba.config.CACHE_DIR = str(folder) if folder else users_own
        pipelines = importlib.import_module("edugym.compiled.compiler_pipelines")
        caching = {"cache": folder is not None, "nogil": True, "no_cfunc_wrapper": True}
        made = numba.njit(pipeline_class=pipelines.Loop, **caching, **options)(loop)
    finally:
        numba.config.CACHE_DIR = users_own
    functions = {*code.functions, *replacements()}
    pipelines.compile_until_known(made, signature, options, functions, code.foreign)
    if folder and (folder / SEAL).exists() and not sum(made.stats.cache_hits.values()):
        seal(folder)  # Numba thought that what was there is older than the source, and has written it again
    made.disable_compile()  # left to itself it would compile for other types without these options
    return made


def _needs_no_counts(kind: Any) -> bool:
    """Whether a value of this type is safe in a build without reference counts: numbers, arrays, and tuples of them."""
    types = numba_ready().types
    if isinstance(kind, types.BaseTuple):
        return all(_needs_no_counts(part) for part in kind)
    generator = types.NumPyRandomGeneratorType
    return isinstance(kind, types.Number | types.Boolean | types.NoneType | types.Array | generator)


def _check_no_counts(build: Any) -> None:
    """Makes sure that a lean build counts no references after all, and returns no array: both would leak.

    Raises:
        CompilationError: it does.
    """
    types = numba_ready().types

    def only_numbers(kind: Any) -> bool:
        return all(map(only_numbers, kind)) if isinstance(kind, types.BaseTuple) else not isinstance(kind, types.Array)

    result = build.signature.return_type
    if not (_needs_no_counts(result) and only_numbers(result)):
        raise CompilationError(f"it gives back a value of type {result}")
    if found := re.search(r"call [^\n]*@(NRT_(?!meminfo_new_from_pyobject)\w*)", build.library.get_llvm_str()):
        raise CompilationError(f"it allocates ({found[1]})")


def _reason(error: Exception, code: Code) -> str:
    """Why it cannot be compiled, in a few words."""
    if not isinstance(error, CompilationError | refused_error()):
        return reason(error, code)
    method = getattr(error, "method", None)
    return f"{error}{code.place_of(method)}" if method else str(error)

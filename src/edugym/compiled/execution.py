"""Runs a loop as machine code where that pays and is possible, and interpreted elsewhere, with the same results.

A student meets ordinary Python. Code that is not the package's own is compiled only if it is in a stated subset
(`edugym.compiled.subset`). The subset allows changes only to the arguments, and the rehearsal checks that for arrays:
a few hundred steps are run on copies of the arguments, first by the interpreter and then by machine code, and both must
give the same. A mistake in the first steps shows in the rehearsal, as an ordinary traceback at its line. A later
mistake stops machine code. The interpreter then repeats that call from its start, and stops at the very line.

The rehearsal also measures the interpreter's pace. New student code is compiled only if interpreting the remaining run
would take longer than compiling.

In a web browser, where a page has set an engine, JavaScript (`edugym.compiled.javascript`) takes the place of machine
code, with the same rehearsal and the same replay.
"""

import inspect
import math
import sys
import time
import warnings
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from enum import Enum
from typing import Any

from edugym.compiled.code import LIBRARIES, Code, code_of, is_foreign
from edugym.compiled.compiler import compiled, is_built, is_on_disk, seconds_to_build
from edugym.compiled.javascript import program as javascript
from edugym.compiled.javascript.kinds import Untranslatable
from edugym.compiled.numba_setup import CompilationError, NoCompiler, may_compile, numba_ready
from edugym.compiled.snapshot import Snapshot, copied, difference
from edugym.compiled.subset import refusal
from edugym.system import waiting
from edugym.system.interrupts import Stopped, deferring_signals
from edugym.system.packages import OURS

Loop = Callable[..., Any]

COMPILE_FROM = 5_000
"""Shorter runs (about 15 ms) are interpreted, unless machine code exists."""
REHEARSED = 200
"""The steps of a rehearsal."""
PACE_MEASUREMENTS = 2
"""How often the interpreter's pace is measured before it is called slow: another program may have been in its way."""
REHEARSALS_PER_RUN = 25
"""A run is not rehearsed unless it is at least this many times as long as the rehearsal."""
MOST_SURPRISES = 3
"""After this many calls in which machine code fails and the interpreter does not, machine code is given up."""
COPY_EVERY = 10.0
"""Large arrays are copied again when calls since the last copy have taken this many times as long as that copy."""
_warned: set[Any] = set()  # what was said: a text, or the classes of which it was said
_interpreted: dict[tuple[Loop, str], float] = {}  # seconds of runs that were not compiled, by loop and fingerprint


class _MistakeInRehearsal(Exception):
    """The steps that the interpreter rehearses end in an error of the student's code."""


def executable(
    loop: Loop,
    arguments: tuple[Any, ...],
    *,
    expected: float = math.inf,
    rehearsed: int = REHEARSED,
    replayed: bool = True,
    replay: Loop | None = None,
) -> Loop:
    """Returns the fastest safe way to call `loop(n, *arguments)`.

    Args:
        loop: a plain function whose first argument says how many steps (or episodes, or copies) it does.
        arguments: what follows the first argument, or values of the same types.
        expected: the expected number of steps, all calls together; without it, enough to be worth compiling.
        rehearsed: how many are rehearsed by the interpreter, on copies, before code that is not the package's is
            compiled.
        replayed: whether the interpreter repeats a call that fails in such code, to stop at the very line, or to go on
            where only machine code could not. If False, the caller must replay failed calls and watch for changed
            code, as `edugym.adapters.runner.Runner` does.
        replay: does what the loop does, interpreted, and explains errors better; by default the loop itself.

    Returns:
        A function with the arguments of `loop`: machine code, or where that does not pay or is not possible, `loop`
        itself.
    """
    code = code_of(loop, arguments)
    foreign, is_ready = code.foreign, is_built(loop, code)
    if not is_ready and expected < (REHEARSALS_PER_RUN * rehearsed if foreign else COMPILE_FROM):
        return loop
    if javascript.engine is None and not may_compile():
        return loop
    try:
        names = tuple(inspect.signature(loop).parameters)[1:]
        if reason := refusal(code, arguments, names):
            raise CompilationError(reason)
        if javascript.engine is not None:
            made = _rehearsed_javascript(loop, arguments, code, min(rehearsed, REHEARSED), replay or loop)
            return _with_replay(made, loop, code, replay or loop)
        if not foreign:
            numba_ready()
            with _announced(loop, code):
                return compiled(loop, rehearsed, *arguments, code=code)
        rehearsed = min(rehearsed, REHEARSED)
        interpreted = _rehearse(replay or loop, rehearsed, arguments, code)
        if not (is_ready or is_on_disk(code) or _pays(loop, arguments, code, expected, rehearsed)):
            return loop
        machine_code = _rehearsed_machine_code(loop, arguments, code, rehearsed, interpreted)
        return _with_replay(machine_code, loop, code, replay or loop) if replayed else machine_code
    except NoCompiler:
        return loop
    except _MistakeInRehearsal:  # the run comes to it at a step of its own, since evaluations lie between
        return _with_replay(loop, loop, code, replay or loop) if replayed else loop
    except CompilationError as error:
        _warn_once(code, arguments, str(error))
    return loop


def _rehearse(loop: Loop, n: int, arguments: tuple[Any, ...], code: Code) -> tuple[Any, Any]:
    """Runs the loop interpreted on copies of its arguments, and returns its result and the copies.

    Raises:
        CompilationError: it changes an array that is not among the arguments.
        _MistakeInRehearsal: Python itself has an error in these steps.
    """
    copies, constants = copied(arguments), code.arrays
    constants_before, snapshot = copied(constants), Snapshot()
    snapshot.take(constants)
    try:
        result = loop(n, *copies)
    except Exception as error:
        raise _MistakeInRehearsal from error
    finally:  # after an error, too, the arrays get back what they held; they are compared before that
        changed = difference(constants, constants_before, "an array", close=0.0)
        snapshot.put_back()
    if changed:
        raise CompilationError("it changes an array that is not its own: pass it as a field")
    return result, copies


def _pays(loop: Loop, arguments: tuple[Any, ...], code: Code, expected: float, n: int) -> bool:
    """Whether the interpreter would take longer than the compiler for so many steps, at its pace in `n` of them.

    Earlier runs that were interpreted count as well: when the same code is run again and again, compiling pays.
    """
    if math.isinf(expected):
        return True
    key = (loop, code.fingerprint)
    total = math.inf
    for _ in range(PACE_MEASUREMENTS):
        copies = copied(arguments)
        began = time.perf_counter()
        try:
            loop(n, *copies)
        except Exception:  # a guard is stricter than the rehearsal's checks, as of np.array(1) for an action
            return True
        seconds = expected * (time.perf_counter() - began) / n
        total = min(total, _interpreted.get(key, 0.0) + seconds)
        if total <= seconds_to_build():
            _interpreted[key] = total
            return False
    return True


def _rehearsed_machine_code(loop: Loop, arguments: tuple[Any, ...], code: Code, n: int, interpreted: Any) -> Loop:
    """Returns machine code that did in `n` steps, on copies, what the interpreter did.

    Raises:
        CompilationError: it cannot be compiled, or it does something else.
    """
    numba_ready()
    with _announced(loop, code):
        machine_code = compiled(loop, n, *arguments, code=code)
    copies = copied(arguments)
    try:
        with deferring_signals():
            result = machine_code(n, *copies)
    except Exception as error:
        raise CompilationError(_machine_code_failed(error)) from error
    if found := difference(interpreted, (result, copies), "the result"):
        raise CompilationError(f"machine code comes to something else than Python in the first steps ({found})")
    return machine_code


def _rehearsed_javascript(loop: Loop, arguments: tuple[Any, ...], code: Code, n: int, replay: Loop) -> Loop:
    """Returns JavaScript that did in `n` steps, on copies, what the interpreter did, to the last digit.

    Raises:
        CompilationError: it cannot be translated, or it does something else.
        _MistakeInRehearsal: Python itself has an error in these steps.
    """
    assert javascript.engine is not None
    interpreted, copies = _rehearse(replay, n, arguments, code), copied(arguments)
    try:
        made = javascript.translated(loop, arguments, javascript.engine)
        result = made(n, *copies)
    except Untranslatable as error:
        raise CompilationError(str(error)) from error
    except javascript.Doubt as error:
        raise CompilationError(_machine_code_failed(error)) from error
    if found := difference(interpreted, (result, copies), "the result", close=0.0):
        raise CompilationError(f"JavaScript comes to something else than Python in the first steps ({found})")
    return made


def _machine_code_failed(error: Exception) -> str:
    """Describes an error of machine code where Python has none."""
    if isinstance(error, javascript.Doubt):
        return f"JavaScript stops where Python goes on ({error})"
    if isinstance(error, OverflowError) and str(error) == "more than 64 bits":
        return "it computes a whole number of more than 64 bits, as a product of large ones: keep them smaller by %"
    said = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    return f"machine code stops where Python goes on ({said})"


def _with_replay(machine_code: Loop, loop: Loop, code: Code, replay: Loop) -> Loop:
    """Returns a function that calls machine code of a student's code, and lets the interpreter step in for it.

    Where machine code fails, the interpreter repeats the call from the same start. It stops at the very line, or goes
    on where Python does. Once code has changed, or a value outside that it reads, every call is interpreted, since such
    a value may change at every step; an error is then explained in the same way.

    To be repeated, a call needs a copy of its arguments: small arrays are copied before every call, large ones only as
    often as that costs a tenth of the time. If the large ones were not copied, the replay starts from their
    half-changed contents. It can only explain the error, so an error is raised in any case.
    """
    before = Snapshot()
    surprises = 0
    copying = calling = 0.0  # seconds: the last time that everything was copied, and all calls since

    def run(*arguments: Any) -> Any:
        nonlocal machine_code, surprises, copying, calling
        if machine_code is not loop and (changed := code.first_change()):
            machine_code = loop
            _warn_once(code, arguments, f"{changed} changes during the run: what changes should be a field")
        given_up = machine_code is loop
        began = time.perf_counter()
        before.take(arguments, large=calling >= COPY_EVERY * copying)
        taken = time.perf_counter()
        if before.is_whole:
            copying, calling = taken - began, 0.0
        try:
            with deferring_signals(machine_code=False) if given_up else nullcontext():
                result = machine_code(*arguments)
        except Stopped:
            if not given_up:
                before.put_back()  # as if the call had not begun
            raise
        except Exception as error:
            failure = error
        else:
            calling += time.perf_counter() - taken
            return result
        before.put_back()
        with deferring_signals(machine_code=False):
            result = replay(*arguments)  # where this is an error for Python as well, it is raised here, and alone
        if not before.is_whole:  # the replay began with half-changed tables, so its result is wrong
            if given_up:
                raise failure
            raise RuntimeError(
                f"{_machine_code_failed(failure)}, and the tables are too large to be kept"
                " for such a case: set the environment variable NUMBA_DISABLE_JIT=1, and run it again"
            )
        surprises += 1
        if surprises == MOST_SURPRISES and not given_up:
            machine_code = loop
            _warn_once(code, arguments, _machine_code_failed(failure))
        return result

    return run


@contextmanager
def _announced(loop: Loop, code: Code) -> Iterator[None]:
    """Tells a person who waits what is being compiled."""
    if is_built(loop, code) or is_on_disk(code):
        yield
        return
    text = f"edugym: compiling {code.known_names()} (once, a second or two) ..."
    waiting.show(text)
    try:
        yield
    finally:
        waiting.clear(text)


def _warn_once(code: Code, arguments: tuple[Any, ...], reason: str) -> None:
    """Warns, once for the same classes, that they run interpreted; a class that is defined again is another."""
    plain = next(_plain_objects(arguments), None)
    names = code.names() if plain is None else type(plain).__name__
    reason = reason if plain is None else "it is no NamedTuple"
    classes = {kind for kind in code.classes if is_foreign(kind)} if plain is None else {type(plain)}
    key: Any = frozenset(map(weakref.ref, classes)) if classes else f"cannot: {reason}"
    if key not in _warned:
        _warned.add(key)
        message = f"{names} cannot be compiled and runs interpreted, some hundred times slower: {reason}"
        warnings.warn(message, stacklevel=_callers_level())


def _callers_level() -> int:
    """The `stacklevel` of the user's line that has called `_warn_once` by way of the package."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] in {*OURS, "joblib"}:
        level, frame = level + 1, frame.f_back
    return level


def _plain_objects(value: Any) -> Iterator[Any]:
    """The objects of ordinary classes in a value, which cannot be compiled."""
    if isinstance(value, tuple):
        for part in tuple.__iter__(value):
            yield from _plain_objects(part)
    elif not isinstance(value, Enum) and type(value).__module__.partition(".")[0] not in LIBRARIES:
        yield value

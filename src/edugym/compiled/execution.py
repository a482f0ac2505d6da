"""Running a loop: as machine code where that pays and is possible, else interpreted, with the same results.

What a student meets is ordinary Python. Code that is not the package's own is compiled only if it is in a stated subset
(`edugym.compiled.subset`). Such code changes nothing but its arguments, so a few hundred steps can be rehearsed on
copies, interpreted and then by machine code: both must come to the same. A mistake shows in the rehearsal, as an
ordinary traceback at its line; a later one stops machine code, and the call is played again interpreted from where it
began: being the same, it stops at the very line.
"""

import inspect
import os
import sys
import time
import warnings
import weakref
from collections.abc import Callable, Iterator
from enum import Enum
from typing import Any

from edugym.compiled.code import LIBRARIES, Code, code_of, is_foreign
from edugym.compiled.compiler import CompilationError, NoCompiler, check_compiler, compiled, is_built, is_on_disk
from edugym.compiled.copies import Snapshot, copied, difference
from edugym.compiled.subset import refusal
from edugym.system.interrupts import Stopped, deferring_signals
from edugym.system.packages import OURS

Loop = Callable[..., Any]

COMPILE_FROM = 5_000  # steps; fewer take the interpreter some 15 ms, and compiling takes a second or more
REHEARSED = 200  # steps
MOST_SURPRISES = 3  # calls in which machine code fails and the interpreter does not, before machine code is given up
COPYING = 10.0  # large arrays are copied before a call once calls have taken this many times as long as the copying
_warned: set[Any] = set()  # what was said: a text, or the classes of which it was said


def executable(
    loop: Loop,
    arguments: tuple[Any, ...],
    *,
    expected: int = COMPILE_FROM,
    rehearsed: int = REHEARSED,
    replayed: bool = True,
    replay: Loop | None = None,
) -> Loop:
    """The fastest safe way to call `loop(n, *arguments)`.

    Args:
        loop: a plain function whose first argument says how many steps (or episodes, or copies) it does.
        arguments: what follows the first argument, or values of the same types.
        expected: how many steps it will be asked for in all; fewer than `COMPILE_FROM` are not worth compiling.
        rehearsed: how many are rehearsed by the interpreter, on copies, before code that is not the package's is
            compiled.
        replayed: whether a call that fails in such code is played again by the interpreter, which stops at the very
            line, or goes on where only machine code could not. Without it the caller sees to that, and to changed code.
        replay: does what the loop does, interpreted, and says better what is wrong; by default the loop itself.

    Returns:
        A function with the arguments of `loop`: machine code, or where that does not pay or is not possible, `loop`
        itself.
    """
    code = code_of(loop, arguments)
    if expected < COMPILE_FROM and not is_built(loop, code):
        return loop
    try:
        check_compiler()
        names = tuple(inspect.signature(loop).parameters)[1:]
        if reason := refusal(code, arguments, names):
            raise CompilationError(reason)
        return _machine_code(loop, arguments, code, rehearsed, replay or loop if replayed else None)
    except NoCompiler:
        return loop
    except CompilationError as error:
        _warn_once(code, arguments, str(error))
    return loop


def _machine_code(loop: Loop, arguments: tuple[Any, ...], code: Code, rehearsed: int, replay: Loop | None) -> Loop:
    """Machine code of the loop; that of foreign code has shown on copies that it does what the interpreter does.

    Raises:
        CompilationError: there is none, or it does not.
    """
    if not code.foreign:
        _announce(code)
        return compiled(loop, rehearsed, *arguments, code=code)
    rehearsed = min(rehearsed, REHEARSED)
    rehearsal, constants = copied(arguments), code.arrays
    as_before, before = copied(constants), Snapshot()
    before.take(constants)
    try:
        result = (replay or loop)(rehearsed, *rehearsal)  # a mistake in it ends here, at its line
    finally:
        changed = difference(constants, as_before, "an array", close=0.0)
        before.put_back()
    if changed:
        raise CompilationError("it changes an array that is not its own: pass it as a field")
    _announce(code)
    fast = compiled(loop, rehearsed, *arguments, code=code)
    shadow = copied(arguments)
    try:
        with deferring_signals():
            shadowed = fast(rehearsed, *shadow)
    except Exception as error:
        raise CompilationError(_surprise(error)) from error
    found = difference((result, rehearsal), (shadowed, shadow), "the result")
    if found:
        raise CompilationError(f"machine code comes to something else than Python in the first steps ({found})")
    return fast if replay is None else _guarded(fast, loop, code, replay)


def _surprise(error: Exception) -> str:
    """What is said of an error of machine code where Python has none."""
    if isinstance(error, OverflowError) and str(error) == "more than 64 bits":
        return "it computes a whole number of more than 64 bits, as a product of large ones: keep them smaller by %"
    said = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    return f"machine code stops where Python goes on ({said})"


def _guarded(fast: Loop, loop: Loop, code: Code, replay: Loop) -> Loop:
    """Machine code of foreign code, with the interpreter at its side.

    Where machine code fails, the call is played again by the interpreter from the same start, to stop at the very line,
    or to go on where Python does. Once code has changed, or a value outside that it reads, the interpreter goes on
    alone: such a value may change at every step.

    For that the arguments are copied before a call: large arrays only as often as that costs a tenth of the time. A
    call that fails without a copy of them is played again on what it has left of them, and always ends in an error.
    """
    before = Snapshot()
    surprises = 0
    cost = spent = 0.0  # seconds: what copying everything took the last time, and what calls took since

    def run(*arguments: Any) -> Any:
        nonlocal fast, surprises, cost, spent
        if fast is not loop and (changed := code.first_change()):
            fast = loop
            _warn_once(code, arguments, f"{changed} changes during the run: what changes should be a field")
        if fast is loop:
            with deferring_signals(machine_code=False):
                return loop(*arguments)
        began = time.perf_counter()
        before.take(arguments, large=spent >= COPYING * cost)
        taken = time.perf_counter()
        if before.is_whole:
            cost, spent = taken - began, 0.0
        try:
            result = fast(*arguments)
        except Stopped:
            before.put_back()  # as if the call had not begun
            raise
        except Exception as error:
            failure = error
        else:
            spent += time.perf_counter() - taken
            return result
        before.put_back()
        with deferring_signals(machine_code=False):
            result = replay(*arguments)  # where this is an error for Python as well, it is raised here, and alone
        if not before.is_whole:  # it has begun with other tables, and its result is not that of Python
            raise RuntimeError(
                f"{_surprise(failure)}, and the tables are too large to be kept"
                " for such a case: set the environment variable NUMBA_DISABLE_JIT=1, and run it again"
            )
        surprises += 1
        if surprises == MOST_SURPRISES:
            fast = loop
            _warn_once(code, arguments, _surprise(failure))
        return result

    return run


def _announce(code: Code) -> None:
    """Say once that something new is being compiled, to a person who waits for it."""
    ipython = sys.modules.get("IPython")
    in_notebook = ipython is not None and type(ipython.get_ipython()).__name__ == "ZMQInteractiveShell"
    names = code.names()
    watched = in_notebook or sys.stderr.isatty()
    if names in _warned or is_on_disk(code) or os.environ.get("EDUGYM_QUIET") or not watched:
        return
    _warned.add(names)
    out = sys.stdout if in_notebook else sys.stderr  # a notebook shows the latter as if something were wrong
    print(f"edugym: compiling {names} (once, a second or two) ...", file=out)


def _warn_once(code: Code, arguments: tuple[Any, ...], reason: str) -> None:
    """Say once for the same classes what keeps them from being compiled; a class that is defined again is another."""
    plain = next(_plain_objects(arguments), None)
    names = code.names() if plain is None else type(plain).__name__
    reason = reason if plain is None else "it is no NamedTuple"
    classes = {kind for kind in code.classes if is_foreign(kind)} if plain is None else {type(plain)}
    what: Any = frozenset(map(weakref.ref, classes)) if classes else f"cannot: {reason}"
    if what not in _warned:
        _warned.add(what)
        message = f"{names} cannot be compiled and runs interpreted, some hundred times slower: {reason}"
        warnings.warn(message, stacklevel=_callers_level())


def _callers_level() -> int:
    """The `stacklevel` of the user's line that has called `_warn_once` by way of the package."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] in {*OURS, "joblib"}:
        level, frame = level + 1, frame.f_back
    return level


def _plain_objects(value: Any) -> Iterator[Any]:
    """What is in a value that machine code knows nothing of: objects of ordinary classes."""
    if isinstance(value, tuple):
        for part in tuple.__iter__(value):
            yield from _plain_objects(part)
    elif not isinstance(value, Enum) and type(value).__module__.partition(".")[0] not in LIBRARIES:
        yield value

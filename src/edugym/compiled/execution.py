"""Running a loop: as machine code where that pays and is possible, else interpreted, with the same results.

What a student meets is ordinary Python. A mistake in a class of their own shows as an ordinary traceback at its line,
because a few hundred steps are rehearsed interpreted before anything is compiled, and because a chunk in which machine
code fails is played again interpreted from where it began: being the same bit for bit, it stops at the very line.
"""

import copy
import os
import sys
import warnings
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from edugym.compiled.code import LIBRARIES, Code
from edugym.compiled.compiler import CompilationError, NoCompiler, compiled, is_built, is_on_disk

Loop = Callable[..., Any]

COMPILE_FROM = 5_000  # steps; fewer take the interpreter some 15 ms, and compiling takes a second or more
REHEARSED = 200  # steps
_warned: set[str] = set()


def executable(
    loop: Loop,
    arguments: tuple[Any, ...],
    *,
    expected: int = COMPILE_FROM,
    rehearsed: int = REHEARSED,
    replayed: bool = True,
) -> Loop:
    """The fastest safe way to call `loop(n, *arguments)`.

    Args:
        loop: a plain function whose first argument says how many steps (or episodes, or copies) it does.
        arguments: what follows the first argument, or values of the same types.
        expected: how many steps it will be asked for in all; fewer than `COMPILE_FROM` are not worth compiling.
        rehearsed: how many are rehearsed by the interpreter, on copies, before code that is not the package's is
            compiled.
        replayed: whether a call that fails in such code is played again by the interpreter, to stop at the very line.

    Returns:
        A function with the arguments of `loop`: machine code, or where that does not pay or is not possible, `loop`
        itself.
    """
    code = Code(loop, arguments)
    if expected < COMPILE_FROM and not is_built(loop, code):
        return loop
    if code.foreign:
        loop(rehearsed, *copy.deepcopy(arguments))
    try:
        _announce(code)
        fast = compiled(loop, rehearsed, *arguments, code=code)
    except NoCompiler:
        return loop
    except CompilationError as error:
        _warn_once(code, arguments, error)
        return loop
    return _replaying(fast, loop) if code.foreign and replayed else fast


def _replaying(fast: Loop, loop: Loop) -> Loop:
    """Machine code that, where it fails, is played again by the interpreter from the same start."""

    def run(*arguments: Any) -> Any:
        before = copy.deepcopy(arguments)
        try:
            return fast(*arguments)
        except Exception:
            for now, then in zip(arguments, before, strict=True):
                _restore(now, then)
            return loop(*arguments)

    return run


def _restore(now: Any, then: Any) -> None:
    """Put tables and random streams back in place to what they were."""
    if isinstance(now, np.ndarray):
        now[...] = then
    elif isinstance(now, np.random.Generator):
        now.bit_generator.state = then.bit_generator.state
    elif isinstance(now, tuple):
        for part_now, part_then in zip(now, then, strict=True):
            _restore(part_now, part_then)


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


def _warn_once(code: Code, arguments: tuple[Any, ...], error: CompilationError) -> None:
    """Say once for the same classes what keeps them from being compiled."""
    plain = next(_plain_objects(arguments), None)
    names = code.names() if plain is None else type(plain).__name__
    reason = error if plain is None else "it is no NamedTuple"
    if f"cannot: {names}" not in _warned:
        _warned.add(f"cannot: {names}")
        message = f"{names} cannot be compiled and runs interpreted, some hundred times slower: {reason}"
        warnings.warn(message, stacklevel=4)


def _plain_objects(value: Any) -> Iterator[Any]:
    """What is in a value that machine code knows nothing of: objects of ordinary classes."""
    if isinstance(value, tuple):
        for part in value:
            yield from _plain_objects(part)
    elif type(value).__module__.partition(".")[0] not in LIBRARIES:
        yield value

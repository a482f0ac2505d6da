"""Running a loop: as machine code where that pays and is possible, else interpreted, with the same results.

What a student meets is ordinary Python. A mistake in a class of their own shows as an ordinary traceback at its line,
because a few hundred steps are rehearsed interpreted before anything is compiled, and because a chunk in which machine
code fails is played again interpreted from where it began: being the same bit for bit, it stops at the very line.
"""

import copy
import os
import sys
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np

from edugym.mdp.code import Code
from edugym.mdp.compiler import CompilationError, NoCompiler, compiled, is_built, is_on_disk

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
        _warn_once(code, error)
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
    names = code.names()
    if names in _warned or is_on_disk(code) or os.environ.get("EDUGYM_QUIET") or not sys.stderr.isatty():
        return
    _warned.add(names)
    print(f"edugym: compiling {names} (once, a second or two) ...", file=sys.stderr)


def _warn_once(code: Code, error: CompilationError) -> None:
    message = f"{code.names()} cannot be compiled and runs interpreted, some hundred times slower: {error}"
    if message not in _warned:
        _warned.add(message)
        warnings.warn(message, stacklevel=4)

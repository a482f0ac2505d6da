"""Ctrl-C while machine code runs."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def interrupts(deferred: bool) -> Iterator[Callable[[], None]]:
    """Let Ctrl-C wait for a moment at which it is safe.

    When machine code hands back a state, Python makes the tuple, and raises `KeyboardInterrupt` at that very moment if
    Ctrl-C came on the way. Numba does not expect an error there, and the process would crash.

    Args:
        deferred: without it nothing waits: Ctrl-C comes as ever.

    Yields:
        A function that lets come what has waited: `KeyboardInterrupt`, or whatever Ctrl-C does otherwise.
    """
    handler = signal.getsignal(signal.SIGINT)
    waiting: list[tuple[Any, ...]] = []

    def let_come() -> None:
        while callable(handler) and waiting:
            handler(*waiting.pop())

    if not (deferred and callable(handler) and threading.current_thread() is threading.main_thread()):
        yield let_come
        return
    signal.signal(signal.SIGINT, lambda *arguments: waiting.append(arguments))
    try:
        yield let_come
    finally:
        signal.signal(signal.SIGINT, handler)
    let_come()

"""Ctrl-C while machine code runs."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def interrupts(deferred: bool) -> Iterator[Callable[[], None]]:
    """Put Ctrl-C off to a moment at which it is safe.

    When machine code returns a state, Python makes the tuple, and raises `KeyboardInterrupt` at that very moment if
    Ctrl-C was pressed meanwhile. Numba does not expect an error there, and the process would crash.

    Args:
        deferred: False to put nothing off.

    Yields:
        A function that delivers a pending Ctrl-C: it raises `KeyboardInterrupt`, or does what Ctrl-C does otherwise.
    """
    handler = signal.getsignal(signal.SIGINT)
    pending: list[tuple[Any, ...]] = []

    def deliver() -> None:
        while callable(handler) and pending:
            handler(*pending.pop())

    if not (deferred and callable(handler) and threading.current_thread() is threading.main_thread()):
        yield deliver
        return
    signal.signal(signal.SIGINT, lambda *arguments: pending.append(arguments))
    try:
        yield deliver
    finally:
        signal.signal(signal.SIGINT, handler)
    deliver()

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
        A function that raises `KeyboardInterrupt` if Ctrl-C has come.
    """
    came: list[Any] = []

    def check() -> None:
        if came:
            raise KeyboardInterrupt

    usual = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if not (deferred and usual and threading.current_thread() is threading.main_thread()):
        yield check
        return
    signal.signal(signal.SIGINT, lambda *arguments: came.append(arguments))
    try:
        yield check
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)

"""Waits for a function in another thread, so that Ctrl-C or a limit of time ends the wait."""

import math
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Concatenate, ParamSpec, TypeVar

from edugym.system.interrupts import Stopped, current_guard

P = ParamSpec("P")
T = TypeVar("T")

HAS_THREADS = sys.platform != "emscripten"
"""A browser's Python has none."""
HAS_CLOCKS = hasattr(time, "pthread_getcpuclockid")
"""Whether the system tells the processor time of a single thread."""
MOST_SECONDS_TO_END = 10.0
"""How long a function that is late is waited for."""


def call_interruptibly(function: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
    """Call a function in another thread, and wait for it; a signal or a flag to stop ends the wait.

    The function itself goes on in its thread to its end, which the process waits for before it ends.

    Raises:
        Stopped: this thread is to stop.
    """

    def call(late: threading.Event) -> T:
        return function(*args, **kwargs)

    call.__name__ = getattr(function, "__name__", "work")
    return call_within(math.inf, call)


def _clock_of_this_thread() -> Callable[[], float]:
    """The processor time of this thread from now on, for others to read; else that of the process."""
    if HAS_CLOCKS:
        clock = time.pthread_getcpuclockid(threading.get_ident())
        began = time.clock_gettime(clock)
        return lambda: time.clock_gettime(clock) - began
    began = time.process_time()
    return lambda: time.process_time() - began


def call_within(
    seconds: float, function: Callable[Concatenate[threading.Event, P], T], *args: P.args, **kwargs: P.kwargs
) -> T:
    """The same with a limit, in seconds of processor time, after which the function is told to end.

    Only the time of its own thread counts, where the system can tell it: other threads may run or compile meanwhile.
    Without threads the function is called here, and neither ends the wait.

    Args:
        seconds: the limit.
        function: its first argument is an event that is set when the limit is over. The function should look at it
            from time to time, and raise `TimeoutError`: raised from here it could hit anything. If it returns a
            result soon, that counts.
        *args: its other arguments.
        **kwargs: and its keyword arguments.

    Raises:
        Stopped: this thread is to stop.
        TimeoutError: it has taken longer.
    """
    late = threading.Event()
    if not HAS_THREADS:
        return function(late, *args, **kwargs)
    done = threading.Event()
    returned: list[T] = []
    raised: list[BaseException] = []
    clocks: list[Callable[[], float]] = []
    taken, most_to_end = 0.0, math.inf

    def call() -> None:
        try:
            clocks.append(_clock_of_this_thread())
            returned.append(function(late, *args, **kwargs))
        except BaseException as error:
            raised.append(error)
        finally:
            done.set()

    name = f"edugym-{getattr(function, '__name__', 'work')}"
    threading.Thread(target=call, name=name).start()
    guard = current_guard()
    while not done.wait(0.02):  # on Windows waiting cannot be interrupted, so it is never for long
        if guard is not None and guard.should_stop():
            raise Stopped
        with suppress(OSError):  # it has just ended
            taken = clocks[0]() if clocks else taken
        if taken > seconds and not late.is_set():
            late.set()
            most_to_end = time.monotonic() + MOST_SECONDS_TO_END  # until then it may silence warnings, as Numba does
        if time.monotonic() > most_to_end:
            raise TimeoutError
    if raised:
        raise raised.pop()
    return returned.pop()

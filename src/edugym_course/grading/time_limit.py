"""An end for a student's code that has none, such as a `while` loop whose condition stays true.

The limit is one of processor time: code that sleeps or waits is not caught.
"""

import _thread
import math
import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from edugym.system.other_threads import HAS_THREADS
from edugym_course.grading.errors import TooSlow

LIMIT = 30.0
"""The seconds of processor time that one call of a student's code may take."""
INTERVAL = 0.2
"""The seconds between two checks of the time."""


@dataclass
class _TimedCode:
    """Code of a student's, while it runs.

    Attributes:
        limit: the seconds of processor time that it may take.
        deadline: the processor time at which it is interrupted. The watch sets it at its first check: most code has
            ended by then, and asking for the processor time may be slow.
        interrupted: whether it was.
        over: whether it has ended.
    """

    limit: float
    deadline: float = math.inf
    interrupted: bool = False
    over: bool = False


class _Watch:
    """A thread that interrupts the main thread at a deadline. It ends when nothing is left to watch."""

    def __init__(self) -> None:
        """Watch nothing yet."""
        self._lock = threading.Lock()
        self._timed: list[_TimedCode] = []
        self._is_running = False

    def add(self, code: _TimedCode) -> None:
        """Watch code until it is over."""
        with self._lock:
            self._timed.append(code)
            if not self._is_running:
                self._is_running = True
                threading.Thread(target=self._run, name="edugym-time-limit", daemon=True).start()

    def end(self, code: _TimedCode) -> None:
        """Stop watching code; after that it is not interrupted."""
        with self._lock:
            code.over = True

    def interrupt(self, *_: Any) -> None:
        """Handle the signal of an interrupt as Python does, but only if code is late."""
        if any(one.interrupted and not one.over for one in self._timed):
            raise KeyboardInterrupt

    def _run(self) -> None:
        while True:
            time.sleep(INTERVAL)
            with self._lock:
                self._timed = [one for one in self._timed if not one.over]
                if not self._timed:
                    self._is_running = False
                    return
                now = time.process_time()
                late = [one for one in self._timed if now > one.deadline]
                for one in self._timed:
                    one.deadline = min(one.deadline, now + one.limit)
                for one in late:
                    one.interrupted = True
                if late:  # repeat at every check: a bare `except:` may swallow the interrupt
                    _thread.interrupt_main()


_watch = _Watch()


@contextmanager
def time_limit(what: str, limit: float = LIMIT) -> Iterator[None]:
    """Run a student's code, and end it when it takes too long.

    It does nothing in other threads than the main one, and in a browser, whose Python has no threads.

    Args:
        what: what is running, for the sentence: "act(3)".
        limit: the seconds of processor time that it may take.

    Raises:
        TooSlow: it took longer.
    """
    if not HAS_THREADS or threading.current_thread() is not threading.main_thread():
        yield
        return
    code = _TimedCode(limit)
    ignored = signal.getsignal(signal.SIGINT) is signal.SIG_IGN  # as in what a shell script runs in the background
    if ignored:
        signal.signal(signal.SIGINT, _watch.interrupt)
    try:
        _watch.add(code)
        try:
            yield
        finally:
            _watch.end(code)
    except KeyboardInterrupt:
        code.over = True  # the interrupt may have come in `end`
        if not code.interrupted:
            raise
    finally:
        if ignored:
            signal.signal(signal.SIGINT, signal.SIG_IGN)
    if code.interrupted:
        raise TooSlow(f"{what} has not ended after {limit:g} seconds: is there a `while` whose condition stays true?")

"""An end for a student's code that has none, such as a `while` loop that waits for ever."""

import _thread
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from edugym_course.grading.errors import WrongAnswer

LIMIT = 30.0
"""The seconds of processor time that one call of a student's code may take."""
INTERVAL = 0.2
"""The seconds between two looks at the time."""


@dataclass
class _Stretch:
    """A stretch of a student's code.

    Attributes:
        deadline: the processor time at which it is interrupted.
        interrupted: whether it was.
        over: whether it has ended.
    """

    deadline: float
    interrupted: bool = False
    over: bool = False


class _Watch:
    """A thread that interrupts the main thread at a deadline. It ends when nothing is left to watch."""

    def __init__(self) -> None:
        """Watch nothing yet."""
        self._lock = threading.Lock()
        self._stretches: list[_Stretch] = []
        self._is_running = False

    def add(self, stretch: _Stretch) -> None:
        """Watch a stretch until it is over."""
        with self._lock:
            self._stretches.append(stretch)
            if not self._is_running:
                self._is_running = True
                threading.Thread(target=self._run, name="edugym-time-limit", daemon=True).start()

    def end(self, stretch: _Stretch) -> None:
        """Stop watching a stretch; after that it is not interrupted."""
        with self._lock:
            stretch.over = True

    def _run(self) -> None:
        while True:
            time.sleep(INTERVAL)
            with self._lock:
                self._stretches = [one for one in self._stretches if not one.over]
                if not self._stretches:
                    self._is_running = False
                    return
                late = [one for one in self._stretches if time.process_time() > one.deadline]
                for one in late:
                    one.interrupted = True
                if late:  # again at every look, for code that catches every error goes on
                    _thread.interrupt_main()


_watch = _Watch()


@contextmanager
def time_limit(what: str, limit: float = LIMIT) -> Iterator[None]:
    """Run a student's code, and end it when it takes too long. Only the main thread can be interrupted.

    Args:
        what: what is running, for the sentence: "act(3)".
        limit: the seconds of processor time that it may take.

    Raises:
        WrongAnswer: it took longer.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    stretch = _Stretch(time.process_time() + limit)
    try:
        _watch.add(stretch)
        try:
            yield
        finally:
            _watch.end(stretch)
    except KeyboardInterrupt:
        stretch.over = True  # the interrupt may have come in `end`
        if not stretch.interrupted:
            raise
    if stretch.interrupted:
        raise WrongAnswer(
            f"{what} has not ended after {limit:g} seconds: is there a `while` whose condition stays true?"
        )

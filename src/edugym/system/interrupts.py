"""Ctrl-C, the stop button of a notebook, and every other signal that Python code handles, while long work runs.

Long work runs inside `with SignalGuard() as guard`, which guards it: a signal is answered within a fifth of a second.

* In plain Python its handler runs at once, as without a guard. Python ignores errors in `__del__` and in weakref
  callbacks; a `KeyboardInterrupt` that is lost there is sent again 0.01 s later.
* While machine code runs (`guard.defer`), signals are deferred until the loop calls `guard.should_stop`, between two
  calls. Numba expects no error where machine code returns a tuple: a handler that raised there would crash the process.
* A long loop of machine code asks from time to time (`asked_to_stop`), and ends by raising `Stopped`.
* While runs are under way in other threads and processes (`guard.on_ctrl_c`), Ctrl-C sets a flag on which they stop and
  return what is done. After `PATIENCE` seconds, or with a second Ctrl-C, the wait ends. Threads still in Python get
  `Stopped` raised in them; threads in machine code poll and stop themselves.

What cannot be interrupted at all, such as LLVM or the import of a library, runs in a thread: see `other_threads`.
"""

import _thread
import ctypes
import os
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cached_property
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")

INTERRUPTED = 130
"""The exit status of a command that Ctrl-C ended, as shells expect it."""
PATIENCE = 0.15
"""The seconds in which runs may stop by themselves and return what is done, after the order to stop."""

AGAIN = 0.01
"""The seconds after which a `KeyboardInterrupt` that was swallowed is sent again."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C, or the stop button of a notebook, ended the work; the message says how much is done."""

    def __init__(self, message: str, collect: Callable[[], Any]) -> None:
        """Keep the message, and a function that collects what is done."""
        super().__init__(message)
        self._collect = collect

    @cached_property
    def partial(self) -> Any:
        """What is done: a `Run` with `complete=False`, or `Results` without the runs that had not begun."""
        return self._collect()

    def _render_traceback_(self) -> list[str]:
        """What a notebook shows in place of a traceback."""
        return [f"Interrupted: {self}"]


class Stopped(KeyboardInterrupt):
    """Raised where work is to stop: while `call_interruptibly` waits, or in a long loop of machine code."""


class StopFlag:
    """A flag to stop, for runs in this process and in others on this machine, which see a file appear."""

    def __init__(self, event: threading.Event, folder: str) -> None:
        """Take an event that sets the flag as well, and a folder that other processes see."""
        self._event: threading.Event | None = event
        self._file = Path(folder) / "stop"
        self._is_set = False
        self.process = os.getpid()

    def set(self) -> None:
        """Tell every run to stop."""
        self._is_set = True  # first, so that no new run is handed out when one has seen the file
        self._file.touch()

    def is_set(self) -> bool:
        """Whether to stop."""
        if self._event is None:
            return self._file.exists()
        if self._event.is_set() and not self._is_set:
            self.set()
        return self._is_set

    def __getstate__(self) -> dict[str, Any]:
        """What another process gets: the name of the file."""
        return {**self.__dict__, "_event": None}


class SignalGuard:
    """Guards work against signals, which are answered as this module says while its block runs.

    Guards may be nested. Python handles signals in the main thread alone; in others a guard only passes on that work is
    to stop.

    Attributes:
        stop_ordered: whether Ctrl-C has told runs to stop.
        loop: the line of the student's loop that was under way in machine code when it was stopped; else 0.
    """

    def __init__(self, stop: Any = None) -> None:
        """Take an event, or a flag, that also ends the work when it is set; or None."""
        self.stop_ordered = False
        self.loop = 0
        self._stop = stop
        self._around = current_guard()
        self._deferring = False
        self._machine_code = False
        self._handlers: dict[int, Callable[[int, Any], Any]] = {}
        self._pending: list[tuple[int, Any]] = []
        self._raised: KeyboardInterrupt | None = None
        self._error: BaseException | None = None  # what a handler raised while machine code ran
        self._tell_runs_to_stop: Callable[[], None] | None = None
        self._lock = threading.Lock()

    def __enter__(self) -> "SignalGuard":
        """Take the place of every signal handler that is a Python function."""
        _current.guard = self
        if threading.current_thread() is threading.main_thread():
            self._deferring = True  # until all are in place
            for number in _SIGNALS:
                handler = signal.getsignal(number)
                if callable(handler):
                    self._handlers[number] = handler
                    signal.signal(number, self._arrive)
            self._hook = sys.unraisablehook
            sys.unraisablehook = self._swallowed
            self._deferring = False
            try:
                self._deliver()
            except BaseException as error:  # Python does not call `__exit__` when `__enter__` raises
                self.__exit__(type(error), error, None)
                raise
        elif self._stop is not None:
            _in_threads[self] = threading.get_ident()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: Any) -> None:
        """Put the handlers back, and call those that still wait."""
        _current.guard = self._around
        if self._stop is not None and not self._handlers:
            with _ending:
                ended = _in_threads.pop(self, None) is None
            if ended:  # another thread took this guard off the list: a `Stopped` is on its way
                _receive_stopped()
        self._deferring = True
        if self._handlers:
            sys.unraisablehook = self._hook
        for number, handler in sorted(self._handlers.items(), key=lambda item: item[0] == signal.SIGINT):
            signal.signal(number, handler)  # that of Ctrl-C last: from then on it raises an error, as ever
        if kind is not None:
            self._raised = None
        self._deliver()
        if self._error is not None:
            raise self._error from None

    def defer(self, machine_code: bool) -> None:
        """Say whether machine code is to run. While it does, signals are deferred until `should_stop` is asked."""
        self._machine_code = machine_code
        self._deferring = machine_code

    def should_stop(self) -> bool:
        """Whether to stop, after the handlers of all deferred signals have run.

        Raises:
            KeyboardInterrupt: after Ctrl-C. Other signals raise what their handlers raise.
        """
        self._deliver()
        return self._stop is not None and bool(self._stop.is_set())

    @contextmanager
    def on_ctrl_c(self, stop: Callable[[], None]) -> Iterator[None]:
        """Let the next Ctrl-C call `stop`, and raise an error only if the block goes on for `PATIENCE` seconds."""
        self._tell_runs_to_stop = stop
        try:
            yield
        finally:
            with self._lock:
                self._tell_runs_to_stop = None

    def _arrive(self, number: int, frame: Any) -> None:
        if self._deferring:
            self._pending.append((number, frame))
        else:
            self._handle(number, frame)

    def _deliver(self) -> None:
        while self._pending:
            self._handle(*self._pending.pop(0))
        if self._raised is not None:
            error, self._raised = self._raised, None
            raise error

    def _handle(self, number: int, frame: Any) -> None:
        # A signal may come anywhere, also where a lock is held or another one is handled: nothing here takes a lock.
        if number == signal.SIGINT and self._tell_runs_to_stop is not None and not self.stop_ordered:
            self.stop_ordered = True
            self._tell_runs_to_stop()
            later(PATIENCE, self._insist)
            return
        try:
            self._handlers[number](number, frame)
        except KeyboardInterrupt as error:
            self._raised = error  # in case it gets lost
            raise

    def _insist(self) -> None:
        """Press Ctrl-C again if the block of `on_ctrl_c` goes on, and end the threads that do."""
        with self._lock:
            if self._tell_runs_to_stop is not None:
                _press_ctrl_c()
        with _ending:
            for guard in list(_in_threads):  # others may begin meanwhile
                if guard._stop.is_set() and not guard._machine_code:
                    raise_in_thread(_in_threads.pop(guard))

    def _swallowed(self, unraisable: Any) -> None:
        """Press Ctrl-C again where Python ignored it."""
        if issubclass(unraisable.exc_type, KeyboardInterrupt):
            later(AGAIN, self._raise_again)
        else:
            self._hook(unraisable)

    def _raise_again(self) -> None:
        if self._raised is not None:
            _press_ctrl_c()


_SIGNALS = tuple(signal.valid_signals())  # to ask for them takes as long as the rest of a guard
_current = threading.local()
_in_threads: dict[SignalGuard, int] = {}  # the guards of other threads than the main one, and the numbers of these
_ending = threading.Lock()


def current_guard() -> SignalGuard | None:
    """The innermost guard of this thread."""
    return getattr(_current, "guard", None)


def raise_in_thread(ident: int) -> None:
    """Raise `Stopped` in a thread as soon as it is in Python."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(ident), ctypes.py_object(Stopped))


def _receive_stopped() -> None:
    """Wait for a `Stopped` that may not have been raised in this thread yet, so that it ends nothing else.

    Python can withdraw the error, but would then look for it for ever: all code would be slower, and traced code hangs.
    """
    with suppress(Stopped):
        raise_in_thread(threading.get_ident())  # in place of a pending one, if there is one: the loop always ends
        while True:
            time.sleep(0)


def _press_ctrl_c() -> None:
    """Send SIGINT to the main thread. A real signal, where there is one, also ends a wait for a lock."""
    main = threading.main_thread().ident
    if hasattr(signal, "pthread_kill") and main is not None:
        signal.pthread_kill(main, signal.SIGINT)
    else:
        _thread.interrupt_main()


def later(seconds: float, call: Callable[[], None]) -> None:
    """Call a function in a thread after some seconds. `Thread.start` would wait for locks, which no handler may do."""

    def wait() -> None:
        time.sleep(seconds)
        call()

    _thread.start_new_thread(wait, ())


@contextmanager
def deferring_signals(machine_code: bool = True) -> Iterator[None]:
    """Defer signals while machine code runs in this block, if its thread is guarded.

    They are deferred until the guard is asked or ends: machine code cannot raise the error of a handler.

    Args:
        machine_code: whether the block runs machine code. If not, its signals are answered at once, as in plain Python.
    """
    guard = current_guard()
    if guard is None:
        yield
        return
    before = guard._machine_code
    guard.defer(machine_code)
    try:
        if not machine_code:
            guard.should_stop()  # answers the signals that came before the block
        yield
    finally:
        guard.defer(before)


def asked_to_stop(line: int) -> bool:
    """Whether machine code, which calls this, is to raise `Stopped`. The guard then raises a handler's error.

    Args:
        line: of the student's loop that calls it; 0 for a loop of the package.
    """
    guard = current_guard()
    if guard is None:
        return False
    try:
        stops = guard.should_stop()
    except BaseException as error:  # it cannot pass through machine code
        stops, guard._error = True, error
    if stops:
        guard.loop = line
    return stops


@contextmanager
def stop_flag(event: threading.Event) -> Iterator[StopFlag]:
    """A flag to stop that other processes see, and that is also set when the event is."""
    with tempfile.TemporaryDirectory(prefix="edugym-", ignore_cleanup_errors=True) as folder:
        yield StopFlag(event, folder)

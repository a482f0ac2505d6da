"""Ctrl-C and other signals: what they leave of a run, and how they wait while machine code runs."""

import contextlib
import os
import pickle
import signal
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from edugym.system import interrupts, other_threads
from edugym.system.interrupts import PATIENCE, Interrupted, SignalGuard, Stopped, asked_to_stop, deferring_signals


@pytest.fixture
def came() -> Iterator[list[int]]:
    """Where Ctrl-C leaves its number in the next test, instead of raising `KeyboardInterrupt`."""
    numbers: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, frame: numbers.append(number))
    yield numbers
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def interrupting() -> None:
    """Ctrl-C interrupts, also where the tests run in the background, which ignores it."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def ctrl_c() -> None:
    """Press it."""
    os.kill(os.getpid(), signal.SIGINT)


def test_signals_wait_while_machine_code_runs(came: list[int]) -> None:
    """And come in their order when the work is asked; in plain Python inside it, and afterwards, they come at once."""
    handlers = signal.getsignal(signal.SIGINT), sys.unraisablehook
    before = signal.signal(signal.SIGTERM, lambda number, frame: came.append(number))
    sent = [signal.SIGTERM, signal.SIGINT, signal.SIGINT, signal.SIGTERM]
    try:
        with SignalGuard() as guard:
            with deferring_signals():
                assert not guard.should_stop()
                for number in sent:
                    signal.raise_signal(number)
                assert came == []
                with deferring_signals(machine_code=False):
                    assert came == sent
                    ctrl_c()
                    assert len(came) == 5
                ctrl_c()
                assert len(came) == 5
            guard.should_stop()
            assert len(came) == 6
            ctrl_c()
            assert len(came) == 7
        with deferring_signals():
            ctrl_c()
            assert len(came) == 8
    finally:
        signal.signal(signal.SIGTERM, before)
    assert (signal.getsignal(signal.SIGINT), sys.unraisablehook) == handlers


def test_it_comes_at_the_end_at_the_latest(came: list[int]) -> None:
    """It is not lost, even if the work fails; the error on the way tells more than a Ctrl-C that was swallowed."""

    def fail(waits: bool) -> None:
        with SignalGuard() as guard:
            guard.defer(machine_code=waits)
            with contextlib.suppress(KeyboardInterrupt):
                ctrl_c()
            raise OSError("on the way")

    for kind in (signal.default_int_handler, signal.getsignal(signal.SIGINT)):
        signal.signal(signal.SIGINT, kind)
        with pytest.raises(OSError, match="on the way"):
            fail(waits=kind is not signal.default_int_handler)
    assert came == [signal.SIGINT]


def test_a_work_in_a_work(came: list[int]) -> None:
    """The inner one has no order of its own; after its end the outer one is asked, and its handler is in place."""
    stop = threading.Event()
    stop.set()
    with SignalGuard(stop) as outer:
        with SignalGuard():
            assert not asked_to_stop(3)
        assert asked_to_stop(4)
        assert outer.loop == 4
        assert signal.getsignal(signal.SIGINT) == outer._arrive
    assert not asked_to_stop(5)


def test_what_a_handler_raises_waits_for_the_end_of_the_loop() -> None:
    """Machine code hears that it is to stop; the error comes when the work ends. It orders no run to stop."""

    def expire(number: int, frame: Any) -> None:
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, expire)
    ordered: list[bool] = []
    with contextlib.suppress(TimeoutError), SignalGuard() as guard:
        guard.defer(machine_code=True)
        signal.raise_signal(signal.SIGALRM)
        assert asked_to_stop(7)
        ordered.append(False)
    assert (guard.loop, ordered.pop()) == (7, False)
    with pytest.raises(TimeoutError), SignalGuard() as guard, guard.on_ctrl_c(lambda: ordered.append(True)):
        signal.raise_signal(signal.SIGALRM)
    assert (ordered, guard.stop_ordered) == ([], False)
    signal.signal(signal.SIGALRM, before)


def test_other_errors_that_python_ignores_are_told_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """By the hook that was there."""
    told: list[Any] = []
    monkeypatch.setattr(sys, "unraisablehook", lambda unraisable: told.append(unraisable.exc_type))
    with SignalGuard():
        type("Failing", (), {"__del__": lambda self: 1 / 0})()
    assert told == [ZeroDivisionError]


@pytest.mark.parametrize("ignored", ["by Python", "by a student", "at the end"])
@pytest.mark.usefixtures("interrupting")
def test_what_is_swallowed_is_raised_again(ignored: str) -> None:
    """No Ctrl-C is lost: neither in `__del__`, nor in an `except` that is too wide, just before the end or earlier."""

    class Careless:
        def __del__(self) -> None:
            ctrl_c()

    def work() -> None:
        with SignalGuard() as guard:
            if ignored == "by Python":
                Careless()
                threading.Event().wait(10)
                raise AssertionError
            with contextlib.suppress(BaseException):
                ctrl_c()
            if ignored == "by a student":
                guard.should_stop()
                raise AssertionError

    with pytest.raises(KeyboardInterrupt):
        work()


@pytest.mark.usefixtures("interrupting")
def test_an_order_first_and_then_an_interrupt() -> None:
    """What does not follow the order is interrupted without a second Ctrl-C."""
    ordered: list[bool] = []

    def work(seconds: float) -> SignalGuard:
        with SignalGuard() as guard, guard.on_ctrl_c(lambda: ordered.append(True)):
            ctrl_c()
            threading.Event().wait(seconds)
        return guard

    assert work(0).stop_ordered
    assert ordered == [True]
    assert not threading.Event().wait(2 * PATIENCE)  # and nobody insists once they have stopped
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        work(10)
    assert time.monotonic() - begun >= PATIENCE


@pytest.mark.usefixtures("interrupting")
def test_what_cannot_be_interrupted_is_waited_for_interruptibly() -> None:
    """Results and errors come through, and Ctrl-C or an order to stop ends the waiting."""
    assert other_threads.call_interruptibly(divmod, 7, 2) == (3, 1)
    assert (
        other_threads.call_interruptibly(threading.current_thread).name == "edugym-current_thread"
    )  # as a debugger shows it
    with pytest.raises(ZeroDivisionError):
        other_threads.call_interruptibly(divmod, 7, 0)
    with SignalGuard():
        assert not other_threads.call_interruptibly(threading.Event().wait, 0.05)
    go_on, stop = threading.Event(), threading.Event()

    def work() -> None:
        with SignalGuard(stop):
            other_threads.call_interruptibly(go_on.wait)

    timer = threading.Timer(0.05, ctrl_c)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
        stop.set()
        with pytest.raises(Stopped):
            work()
    finally:
        go_on.set()
        timer.join()


@pytest.mark.skipif(not other_threads.HAS_CLOCKS, reason="this system has no clock for a thread")
def test_a_limit_counts_the_time_of_its_own_thread() -> None:
    """What waits while others work is not late; what works itself is, and is told so."""
    over = threading.Event()

    def work(until: threading.Event) -> None:
        while not until.is_set():
            pass
        if until is not over:
            raise TimeoutError

    worker = threading.Thread(target=work, args=(over,))
    worker.start()
    try:
        assert not other_threads.call_within(0.1, lambda late: late.wait(0.5))
        with pytest.raises(TimeoutError):
            other_threads.call_within(0.1, work)
    finally:
        over.set()
        worker.join()


def test_a_function_that_goes_on_after_its_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its result counts if it comes soon; else nobody waits, nor after an order to stop."""
    go_on, stop = threading.Event(), threading.Event()

    def work(late: threading.Event, goes_on: threading.Event) -> bool:
        while not late.is_set():
            pass
        stop.set()
        return goes_on.wait(60)

    go_on.set()
    assert other_threads.call_within(0.0, work, go_on)
    go_on.clear()
    stop.clear()
    try:
        with pytest.raises(Stopped), SignalGuard(stop):
            other_threads.call_within(0.0, work, go_on)
        monkeypatch.setattr(other_threads, "MOST_SECONDS_TO_END", 0.1)
        with pytest.raises(TimeoutError):
            other_threads.call_within(0.0, work, go_on)
    finally:
        go_on.set()
    for thread in threading.enumerate():
        if thread.name == "edugym-work":
            thread.join(60)
            assert not thread.is_alive()


def test_a_notebook_shows_one_line() -> None:
    """In place of a traceback; what is done is collected when somebody asks."""
    numbers = iter((5, 6))
    interrupted = Interrupted("after 3 of 7 steps", lambda: next(numbers))
    assert interrupted._render_traceback_() == ["Interrupted: after 3 of 7 steps"]
    assert (interrupted.partial, interrupted.partial, next(numbers)) == (5, 5, 6)


def test_a_thread_that_does_not_stop_is_ended() -> None:
    """If it is to stop and runs Python: machine code asks itself, and another one goes on. Nothing is left of any."""
    orders = {name: threading.Event() for name in ("python", "machine code", "free")}
    end, ended = threading.Event(), dict[str, str]()

    def run(name: str) -> None:
        try:
            with SignalGuard(orders[name]) as guard:
                guard.defer(name == "machine code")
                if name != "free":
                    orders[name].set()
                while not end.is_set():
                    time.sleep(0.001)
                with deferring_signals(False), deferring_signals():
                    pass
                ended[name] = "asked" if guard.should_stop() else "went on"
        except Stopped:
            ended[name] = "stopped"

    threads = {name: threading.Thread(target=run, args=(name,), daemon=True) for name in orders}
    for thread in threads.values():
        thread.start()
    while not (orders["python"].is_set() and orders["machine code"].is_set() and len(interrupts._in_threads) == 3):
        time.sleep(0.001)
    SignalGuard()._insist()
    threads["python"].join(10)
    end.set()
    for thread in threads.values():
        thread.join(10)
    assert ended == {"python": "stopped", "machine code": "asked", "free": "went on"}
    assert interrupts._in_threads == {}


@pytest.mark.parametrize("by_event", [False, True])
def test_the_order_to_stop(by_event: bool) -> None:
    """Given by itself or by the event, and seen in other processes, which get a copy; its folder does not stay."""
    event = threading.Event()
    with interrupts.stop_flag(event) as stop:
        copy: interrupts.StopFlag = pickle.loads(pickle.dumps(stop))
        folder = Path(stop._file).parent
        assert (stop.is_set(), copy.is_set(), copy.process) == (False, False, os.getpid())
        (event if by_event else stop).set()
        assert (stop.is_set(), copy.is_set(), event.is_set()) == (True, True, by_event)
    assert not folder.exists()
    assert stop.is_set()  # as a run asks that goes on while nobody waits for it

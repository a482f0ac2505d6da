"""Signals where works and blocks of machine code stand in each other, and the order to stop in other threads."""

import contextlib
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from edugym.system import interrupts
from edugym.system.interrupts import Stop, Stopped, Work, asked_to_stop, held, ordered_by


@pytest.fixture
def came() -> Iterator[list[int]]:
    """Where Ctrl-C leaves its number in the next test."""
    numbers: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, frame: numbers.append(number))
    yield numbers
    signal.signal(signal.SIGINT, before)


def test_a_block_of_python_in_machine_code(came: list[int]) -> None:
    """What waits comes when it begins, what comes in it waits for nothing, and after it signals wait again."""
    with Work() as work:
        work.hold(machine_code=True)
        signal.raise_signal(signal.SIGINT)
        assert len(came) == 0
        with held(machine_code=False):
            assert len(came) == 1
            signal.raise_signal(signal.SIGINT)
            assert len(came) == 2
        signal.raise_signal(signal.SIGINT)
        assert len(came) == 2
        with held():
            signal.raise_signal(signal.SIGINT)
        work.hold(machine_code=False)
        assert len(came) == 2
        work.stopped()
        assert len(came) == 4


@pytest.mark.parametrize("entering", [True, False])
def test_ctrl_c_while_handlers_take_turns(entering: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """It waits until all are in place; where it ends the work before its block, all is as it was, too."""
    put, work, pressed = signal.signal, Work(), list[int]()

    def press(number: int, handler: Any) -> Any:
        if not entering and handler != work._arrive:
            signal.raise_signal(signal.SIGINT)
            pressed.append(number)
        before = put(number, handler)
        if entering and number == signal.SIGINT and handler == work._arrive:
            signal.raise_signal(signal.SIGINT)
        return before

    numbers = signal.SIGINT, signal.SIGALRM
    alarm = put(signal.SIGALRM, lambda number, frame: None)
    before = [signal.getsignal(number) for number in numbers], sys.unraisablehook
    monkeypatch.setattr(signal, "signal", press)
    try:
        with pytest.raises(KeyboardInterrupt), work:
            assert not entering
        after = [signal.getsignal(number) for number in numbers], sys.unraisablehook
    finally:
        for number, handler in zip(numbers, before[0], strict=True):
            put(number, handler)
        put(signal.SIGALRM, alarm)
    assert after == before
    assert getattr(interrupts._current, "work", None) is None


class Late(Exception):
    """What a handler of a student's own raises."""


def test_what_a_handler_raises_waits_for_the_end_of_the_loop() -> None:
    """Machine code hears that it is to stop; the error comes when the work ends."""

    def expire(number: int, frame: Any) -> None:
        raise Late

    reached: list[int] = []

    def work() -> None:
        with Work() as work:
            work.hold(machine_code=True)
            signal.raise_signal(signal.SIGALRM)
            assert asked_to_stop(7)
            reached.append(work.loop)

    before = signal.signal(signal.SIGALRM, expire)
    try:
        with pytest.raises(Late):
            work()
    finally:
        signal.signal(signal.SIGALRM, before)
    assert reached == [7]


@pytest.mark.usefixtures("came")
def test_the_work_around_goes_on() -> None:
    """After the one inside it has ended, that one is asked, and its handlers are in place."""
    stop = threading.Event()
    stop.set()
    before = signal.getsignal(signal.SIGINT), sys.unraisablehook
    with Work(stop) as outer:
        with Work():
            assert not asked_to_stop(3)
        assert asked_to_stop(4)
        assert outer.loop == 4
        assert signal.getsignal(signal.SIGINT) == outer._arrive
    assert not asked_to_stop(5)
    assert (signal.getsignal(signal.SIGINT), sys.unraisablehook) == before


def test_other_errors_that_python_ignores_are_told_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """By the hook that was there."""

    class Failing:
        def __del__(self) -> None:
            raise Late

    told: list[Any] = []
    monkeypatch.setattr(sys, "unraisablehook", lambda unraisable: told.append(unraisable.exc_type))
    with Work():
        Failing()
        assert told == [Late]
    Failing()
    assert told == [Late, Late]


def test_a_thread_that_does_not_stop_is_ended() -> None:
    """If it was ordered to; another goes on, and nothing is left of either."""
    orders = {"ordered": threading.Event(), "free": threading.Event()}
    orders["ordered"].set()
    end, ended = threading.Event(), dict[str, str]()

    def run(name: str) -> None:
        try:
            with Work(orders[name]):
                while not end.is_set():
                    time.sleep(0.001)
            ended[name] = "end"
        except Stopped:
            ended[name] = "stopped"

    threads = [threading.Thread(target=run, args=(name,), daemon=True) for name in orders]
    for thread in threads:
        thread.start()
    while len(interrupts._in_threads) < 2:
        time.sleep(0.001)
    Work()._insist()
    threads[0].join(10)
    assert ended == {"ordered": "stopped"}
    end.set()
    threads[1].join(10)
    assert ended == {"ordered": "stopped", "free": "end"}
    assert interrupts._in_threads == {}


def test_a_thread_in_machine_code_asks_itself() -> None:
    """So it is not ended by force, which its callbacks would report as an error."""
    order, end = threading.Event(), threading.Event()
    order.set()
    ended = list[str]()

    def run() -> None:
        with Work(order) as work:
            work.hold(True)
            end.wait(10)
            with held(False), held():
                pass
            ended.append("stopped" if work.stopped() else "went on")

    thread = threading.Thread(target=run)
    thread.start()
    while not any(work._machine_code for work in interrupts._in_threads):
        time.sleep(0.001)
    Work()._insist()
    end.set()
    thread.join(10)
    assert ended == ["stopped"]


@pytest.mark.parametrize(
    ("main", "ordered", "ended", "waits"),
    [(False, True, True, 1), (False, True, False, 0), (True, True, False, 0), (False, False, False, 0)],
)
def test_who_waits_for_the_error_that_ends_it(
    main: bool, ordered: bool, ended: bool, waits: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A thread that another has ended, so that the error ends nothing else; no other one."""
    waited = list[bool]()
    monkeypatch.setattr(interrupts, "_receive_stopped", lambda: waited.append(True))

    def run() -> None:
        with Work(threading.Event() if ordered else None):
            if ended:
                interrupts._in_threads.clear()

    if main:
        run()
    else:
        thread = threading.Thread(target=run)
        thread.start()
        thread.join()
    assert len(waited) == waits


TRACED = """
import sys, threading
def tracer(frame, event, argument):
    return tracer if "edugym" in frame.f_code.co_filename else None
sys.settrace(tracer)
threading.settrace(tracer)
from edugym import QLearning, repeat
print(repeat("Boulder", {"Q": QLearning.create}, 200, repetitions=4, jobs=2).complete)
"""


def test_runs_in_threads_under_a_debugger() -> None:
    """Debuggers and coverage trace the code: what a run leaves behind in Python must not stop the next one."""
    ran = subprocess.run([sys.executable, "-c", TRACED], capture_output=True, text=True, timeout=60, check=False)
    assert (ran.stdout, ran.stderr) == ("True\n", "")


@pytest.mark.parametrize("by_event", [False, True])
def test_the_order_to_stop(by_event: bool) -> None:
    """Given by itself or by the event, and seen in other processes, which get a copy; its folder does not stay."""
    event = threading.Event()
    with ordered_by(event) as stop:
        copy: Stop = pickle.loads(pickle.dumps(stop))
        folder = Path(stop._file).parent
        assert (stop.is_set(), copy.is_set(), copy.process) == (False, False, os.getpid())
        (event if by_event else stop).set()
        assert (stop.is_set(), copy.is_set(), event.is_set()) == (True, True, by_event)
    assert not folder.exists()
    assert stop.is_set()  # as a run asks that goes on while nobody waits for it


def test_a_folder_that_cannot_be_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It stays, as it does where a process on Windows still looks into it, and is no error."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with ordered_by(threading.Event()) as stop:
        folder = stop._file.parent
        folder.rmdir()
        folder.write_text("")
    assert list(tmp_path.iterdir()) == [folder]


@pytest.fixture
def pressed(monkeypatch: pytest.MonkeyPatch) -> tuple[list[bool], list[Callable[[], None]]]:
    """Where Ctrl-C is noted instead of being pressed once more, and what would have been done later."""
    presses: list[bool] = []
    later: list[Callable[[], None]] = []
    monkeypatch.setattr(interrupts, "_press_ctrl_c", lambda: presses.append(True))
    monkeypatch.setattr(interrupts, "_later", lambda seconds, press: later.append(press))
    return presses, later


@pytest.mark.usefixtures("came")
def test_nobody_insists_once_the_runs_have_stopped(pressed: tuple[list[bool], list[Callable[[], None]]]) -> None:
    """Before, somebody does."""
    presses, later = pressed
    with Work() as work:
        with work.ordering(lambda: None):
            signal.raise_signal(signal.SIGINT)
            later[0]()
            assert len(presses) == 1
        later[0]()
    assert len(presses) == 1


def test_another_signal_orders_nothing(came: list[int]) -> None:
    """Its handler runs, while runs are under way."""
    ordered: list[bool] = []
    before = signal.signal(signal.SIGALRM, lambda number, frame: came.append(number))
    try:
        with Work() as work, work.ordering(lambda: ordered.append(True)):
            signal.raise_signal(signal.SIGALRM)
            assert came == [signal.SIGALRM]
    finally:
        signal.signal(signal.SIGALRM, before)
    assert ordered == []
    assert not work.ordered


def test_what_came_through_is_not_raised_again(pressed: tuple[list[bool], list[Callable[[], None]]]) -> None:
    """Python ignored it, but the work was asked before it was raised once more."""
    presses, later = pressed

    class Careless:
        def __del__(self) -> None:
            signal.raise_signal(signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with Work() as work:
            Careless()
            with pytest.raises(KeyboardInterrupt):
                work.stopped()
            later[0]()
    finally:
        signal.signal(signal.SIGINT, before)
    assert presses == []


def test_an_error_on_the_way_is_told_first() -> None:
    """It tells more than the Ctrl-C that something had swallowed before."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)

    def work() -> None:
        with Work():
            with contextlib.suppress(KeyboardInterrupt):
                signal.raise_signal(signal.SIGINT)
            raise OSError("on the way")

    try:
        with pytest.raises(OSError, match="on the way"):
            work()
    finally:
        signal.signal(signal.SIGINT, before)


def test_where_no_signal_can_be_sent_to_a_thread(came: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    """As on Windows."""
    monkeypatch.delattr(signal, "pthread_kill")
    interrupts._press_ctrl_c()
    assert came == [signal.SIGINT]


def test_later_is_not_at_once() -> None:
    """The runs have all the time they are given."""
    done, begun = threading.Event(), time.monotonic()
    interrupts._later(0.05, done.set)
    assert done.wait(10)
    assert time.monotonic() - begun >= 0.05


def test_the_error_that_waits_is_received() -> None:
    """So often as it may come, and whether one waits or not."""
    ended: list[bool] = []

    def run() -> None:
        for _ in range(100):
            interrupts._receive_stopped()
        ended.append(True)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    thread.join(10)
    assert ended == [True]

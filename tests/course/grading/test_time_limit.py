"""A student's code that never ends is ended, with one sentence."""

import signal
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import pytest

from edugym.system import other_threads
from edugym_course.grading import time_limit as limits
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.student_code import student_code
from edugym_course.grading.time_limit import time_limit


def waits_for_ever() -> None:
    """A loop whose condition stays true."""
    action = 3
    while action == 3:
        action = max(3, action)


def catches_everything() -> None:
    """A loop that an error does not end, until the third."""
    for _ in range(3):
        try:
            waits_for_ever()
        except BaseException:  # as a bare `except:` does
            continue


@pytest.mark.parametrize("ignored", [False, True])
@pytest.mark.parametrize("code", [waits_for_ever, catches_everything])
def test_code_that_never_ends_is_ended_with_a_sentence(code: Callable[[], None], ignored: bool) -> None:
    """Also within code that has no limit, and in what a shell runs in the background, which Ctrl-C does not reach."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN) if ignored else signal.getsignal(signal.SIGINT)
    try:
        with (
            pytest.raises(WrongAnswer, match=r"act\(3\) has not ended after 0.1 seconds: is there a `while`"),
            student_code("your code", limit=1_000),
            student_code("act(3)", limit=0.1),
        ):
            code()
        assert signal.getsignal(signal.SIGINT) == (signal.SIG_IGN if ignored else before)
        if ignored:
            with time_limit("act(3)"):
                signal.raise_signal(signal.SIGINT)
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_browser_has_no_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    """Code runs there without a limit, and so does what is called interruptibly elsewhere."""

    def no_thread(thread: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(threading.Thread, "start", no_thread)
    monkeypatch.setattr(other_threads, "HAS_THREADS", False)
    monkeypatch.setattr(limits, "HAS_THREADS", False)
    with time_limit("act(3)"):
        assert other_threads.call_within(1, threading.Event.is_set) is False
        assert other_threads.call_interruptibly(max, 2, 3) == 3


def test_the_limit_of_all_goes_on_where_the_limit_of_a_part_is_over() -> None:
    """Each stretch of code is watched until its own end."""

    @time_limit("your code", limit=0.2)
    def long() -> None:
        with time_limit("act(3)"):
            pass
        end = time.process_time() + 2
        while time.process_time() < end:
            pass

    with pytest.raises(WrongAnswer, match=r"your code has not ended after 0.2 seconds"):
        long()


def test_code_that_ends_in_time() -> None:
    """It is not interrupted, neither then nor later; no thread stays, and Ctrl-C is no wrong answer."""
    for _ in range(200):
        with time_limit("act(3)", limit=0.3):
            (watching,) = [thread for thread in threading.enumerate() if thread.name == "edugym-time-limit"]
            assert watching.daemon  # Python does not wait for it at its end
    end = time.process_time() + 0.8
    while time.process_time() < end:
        pass
    assert not any(thread.name == "edugym-time-limit" for thread in threading.enumerate())
    with pytest.raises(KeyboardInterrupt), time_limit("act(3)"):
        raise KeyboardInterrupt


def test_another_thread_has_no_limit() -> None:
    """Only the main thread can be interrupted."""

    def long() -> bool:
        with time_limit("act(3)", limit=0.0):
            time.sleep(0.5)
        return True

    with ThreadPoolExecutor(1) as other:
        assert other.submit(long).result()

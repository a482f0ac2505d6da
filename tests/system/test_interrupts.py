"""Ctrl-C and other signals: what they leave of a run, and how they wait while machine code runs."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from edugym.system.interrupts import Interrupted, Stopped, Work, asked_to_stop, held, interruptibly

SCRIPT = """
import os, signal, sys, threading
import gymnasium
from edugym import QLearning, train
from edugym.system.interrupts import Interrupted
from edugym.training import trainers

class Timeout(Exception):
    pass

def expire(number, frame):
    raise Timeout

how, env_id = sys.argv[1:]
signal.signal(signal.SIGINT, signal.default_int_handler)
environment = gymnasium.make(env_id)
agent = QLearning.create(environment, initial_value=1.0)
if how == "interpreted":
    trainers.executable = lambda loop, *arguments, **options: loop
train(environment, agent, 6_000)  # what has to be compiled is compiled
number = signal.SIGINT
if how == "alarm":
    number = signal.SIGALRM
    signal.signal(number, expire)
threading.Timer(0.5, lambda: os.kill(os.getpid(), number)).start()
try:
    train(environment, agent, 10**13, evaluate_every=20_000, stop=threading.Event())
except Interrupted as interrupted:
    run = interrupted.partial
    print(interrupted)
    print(run.complete, len(run.steps) == len(run.returns) == len(run.episodes), run.steps[0], run.agent.Q is agent.Q)
except Timeout:
    print("timeout")
print((agent.Q != 1.0).any())
"""


@pytest.mark.parametrize(
    ("how", "env_id"),
    [
        ("compiled", "edugym/Boulder-v0"),
        ("compiled", "edugym/Golf-v0"),
        ("compiled", "edugym/MemoryCorridor-v0"),
        ("alarm", "edugym/Golf-v0"),
        ("interpreted", "edugym/Boulder-v0"),
        ("gymnasium", "FrozenLake-v1"),
    ],
)
def test_a_signal_ends_a_run(how: str, env_id: str, tmp_path: Path) -> None:
    """What is done is kept, and the interpreter goes on; a handler of another signal raises its own error.

    States that are numbers, NamedTuples, and hold arrays: the latter two crash where the signal is not waited for.
    """
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    done = subprocess.run(
        [sys.executable, script, how, env_id], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.stderr == ""
    *said, learned = done.stdout.splitlines()
    if how == "alarm":
        assert said == ["timeout"]
    else:
        assert re.fullmatch(r"after \d+ of 10000000000000 steps; the agent keeps what it has learned", said[0])
        assert said[1] == "False True 0 True"
    assert learned == "True"


IMPORTS = """
import signal, sys

forgets = 0

def press(frame, event, argument):
    global forgets
    code = frame.f_code
    if event == "call" and code.co_name == "cb" and "importlib" in code.co_filename and "edugym.agents" in sys.modules:
        forgets += 1
        if forgets == int(sys.argv[1]):
            sys.setprofile(None)
            signal.raise_signal(signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)
sys.setprofile(press)
from edugym import DQN
print("all is imported after", forgets)
"""


@pytest.mark.parametrize("moment", [1, 2, 3])
def test_python_ignores_it_while_it_imports(moment: int) -> None:
    """Python ignores an error when it forgets the lock of an imported module: it is raised again."""
    ended = subprocess.run([sys.executable, "-c", IMPORTS, str(moment)], capture_output=True, text=True, check=False)
    assert ended.returncode != 0, ended.stdout
    assert ended.stderr.splitlines()[-1] == "KeyboardInterrupt"


@pytest.fixture
def came() -> Iterator[list[int]]:
    """Where Ctrl-C leaves its number in the next test, instead of raising `KeyboardInterrupt`."""
    numbers: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, frame: numbers.append(number))
    yield numbers
    signal.signal(signal.SIGINT, before)


def ctrl_c() -> None:
    """Press it."""
    os.kill(os.getpid(), signal.SIGINT)


def test_it_waits_while_machine_code_runs(came: list[int]) -> None:
    """Twice pressed, it comes twice; afterwards all is as before."""
    handler = signal.getsignal(signal.SIGINT)
    with Work() as work:
        work.hold(machine_code=True)
        assert not work.stopped()
        ctrl_c()
        ctrl_c()
        assert came == []
        work.stopped()
        assert came == [signal.SIGINT] * 2
    assert signal.getsignal(signal.SIGINT) is handler
    assert came == [signal.SIGINT] * 2


def test_signals_that_wait_come_in_their_order(came: list[int]) -> None:
    """The first one first, of whatever kind."""
    before = signal.signal(signal.SIGTERM, lambda number, frame: came.append(number))
    sent = [signal.SIGTERM, signal.SIGINT, signal.SIGINT, signal.SIGTERM, signal.SIGINT]
    try:
        with Work() as work:
            work.hold(machine_code=True)
            for number in sent:
                os.kill(os.getpid(), number)
            assert came == []
            work.stopped()
            assert came == sent
    finally:
        signal.signal(signal.SIGTERM, before)


def test_it_comes_at_the_end_at_the_latest(came: list[int]) -> None:
    """It is not lost, even if the work fails."""

    def fail() -> None:
        with Work() as work:
            work.hold(machine_code=True)
            ctrl_c()
            raise OSError("on the way")

    with pytest.raises(OSError, match="on the way"):
        fail()
    assert came == [signal.SIGINT]


def test_it_waits_for_a_block_of_machine_code(came: list[int]) -> None:
    """Inside a work it comes when the work looks; without one nothing waits."""
    with Work() as work:
        with held():
            ctrl_c()
        assert came == []
        work.stopped()
        assert came == [signal.SIGINT]
    with held():
        ctrl_c()
        assert came == [signal.SIGINT] * 2


def test_it_comes_at_once_in_python(came: list[int]) -> None:
    """As without a work."""
    with Work() as work:
        work.hold(machine_code=False)
        ctrl_c()
        assert came == [signal.SIGINT]


class Careless:
    """What presses Ctrl-C where Python ignores errors."""

    def __del__(self) -> None:
        """At its end."""
        ctrl_c()


def ignored_by_python(work: Work) -> None:
    """An error in `__del__`: what comes after it is interrupted."""
    Careless()
    threading.Event().wait(10)
    raise AssertionError


def ignored_by_a_student(work: Work) -> None:
    """An `except` that is too wide."""
    with contextlib.suppress(BaseException):
        ctrl_c()
    work.stopped()
    raise AssertionError


def ignored_at_the_end(work: Work) -> None:
    """The same, just before the work ends."""
    with contextlib.suppress(BaseException):
        ctrl_c()


@pytest.mark.parametrize("ignored", [ignored_by_python, ignored_by_a_student, ignored_at_the_end])
@pytest.mark.usefixtures("interrupting")
def test_what_is_swallowed_is_raised_again(ignored: Callable[[Work], None]) -> None:
    """No Ctrl-C is lost."""

    def work() -> None:
        with Work() as work:
            ignored(work)

    with pytest.raises(KeyboardInterrupt):
        work()


@pytest.fixture
def interrupting() -> None:
    """Ctrl-C interrupts, also where the tests run in the background, which ignores it."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.mark.usefixtures("interrupting")
def test_an_order_first_and_then_an_interrupt() -> None:
    """What does not follow the order is interrupted without a second Ctrl-C."""
    ordered: list[bool] = []

    def work(seconds: float) -> Work:
        with Work() as work, work.ordering(lambda: ordered.append(True)):
            ctrl_c()
            threading.Event().wait(seconds)
        return work

    assert work(0).ordered
    assert ordered == [True]
    with pytest.raises(KeyboardInterrupt):
        work(10)


def test_other_threads_have_nothing_to_do_with_it(came: list[int]) -> None:
    """Only the main thread may change what Ctrl-C does."""
    seen = []

    def work() -> None:
        with Work() as work:
            work.stopped()
            seen.append(signal.getsignal(signal.SIGINT))

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert seen == [signal.getsignal(signal.SIGINT)]


@pytest.mark.usefixtures("interrupting")
def test_what_cannot_be_interrupted_is_waited_for_interruptibly() -> None:
    """Results and errors come through, and Ctrl-C or an order to stop ends the waiting."""
    assert interruptibly(divmod, 7, 2) == (3, 1)
    assert interruptibly(threading.current_thread).name == "edugym-current_thread"  # as a debugger shows it
    with pytest.raises(ZeroDivisionError):
        interruptibly(divmod, 7, 0)
    assert not interruptibly(threading.Event().wait, 0.05)
    with Work():
        assert not interruptibly(threading.Event().wait, 0.05)
    go_on, stop = threading.Event(), threading.Event()

    def work() -> None:
        with Work(stop):
            interruptibly(go_on.wait)

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


def test_only_the_loop_that_was_stopped_is_named() -> None:
    """A loop that asked and went on to its end has nothing to do with a later Ctrl-C."""
    stop = threading.Event()
    with Work(stop) as work:
        assert not asked_to_stop(7)
        assert work.loop == 0
        stop.set()
        assert asked_to_stop(8)
        assert work.loop == 8
    assert not asked_to_stop(9)


def test_a_notebook_shows_one_line() -> None:
    """In place of a traceback; what is done is collected when somebody asks."""
    numbers = iter((5, 6))
    interrupted = Interrupted("after 3 of 7 steps", lambda: next(numbers))
    assert interrupted._render_traceback_() == ["Interrupted: after 3 of 7 steps"]
    assert (interrupted.partial, interrupted.partial, next(numbers)) == (5, 5, 6)

"""Ctrl-C: what it leaves of a run, and how it waits while machine code runs."""

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from edugym.training.interrupts import interrupts

SCRIPT = """
import os, signal, sys, threading, warnings
import gymnasium
from edugym import QLearning, train
from edugym.training import train as training

how, env_id = sys.argv[1:]
environment = gymnasium.make(env_id)
agent = QLearning.create(environment, initial_value=1.0)
stop = threading.Event() if how == "compiled, may stop" else None
if how == "interpreted":
    training.executable = lambda loop, *arguments, **options: loop
train(environment, agent, 6_000)  # what has to be compiled is compiled
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    run = train(environment, agent, 10**13, evaluate_every=20_000, stop=stop)
print([str(warning.message) for warning in caught])
print(run.complete, len(run.steps) == len(run.returns) == len(run.episodes), run.steps[0], run.agent.Q is agent.Q)
print((agent.Q != 1.0).any())
"""


@pytest.mark.parametrize(
    ("how", "env_id"),
    [
        ("compiled", "edugym/Boulder-v0"),
        ("compiled", "edugym/Golf-v0"),
        ("compiled", "edugym/MemoryCorridor-v0"),
        ("compiled, may stop", "edugym/Boulder-v0"),
        ("interpreted", "edugym/Boulder-v0"),
        ("gymnasium", "FrozenLake-v1"),
    ],
)
def test_ctrl_c_returns_what_is_done(how: str, env_id: str, tmp_path: Path) -> None:
    """The run so far, marked as incomplete, with a warning that says so; the interpreter goes on.

    States that are numbers, NamedTuples, and hold arrays: the latter two crash where the signal is not waited for.
    """
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    done = subprocess.run(
        [sys.executable, script, how, env_id], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.stderr == ""
    warned, partial, learned = done.stdout.splitlines()
    if how == "compiled, may stop":  # whoever can stop it knows that it may not be complete
        assert warned == "[]"
    else:
        assert warned.startswith("['interrupted after ")
        assert warned.endswith(" of 10000000000000 steps: this is what was done']")
    assert partial == "False True 0 True"
    assert learned == "True"


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


def test_it_waits_until_it_may_come(came: list[int]) -> None:
    """Twice pressed, it comes twice; afterwards all is as before."""
    handler = signal.getsignal(signal.SIGINT)
    with interrupts(deferred=True) as let_come:
        let_come()
        ctrl_c()
        ctrl_c()
        assert came == []
        let_come()
        assert came == [signal.SIGINT] * 2
    assert signal.getsignal(signal.SIGINT) is handler
    assert came == [signal.SIGINT] * 2


def test_it_comes_at_the_end_at_the_latest(came: list[int]) -> None:
    """It is not lost."""
    with interrupts(deferred=True):
        ctrl_c()
        assert came == []
    assert came == [signal.SIGINT]


def test_it_comes_at_once_where_nothing_is_to_wait(came: list[int]) -> None:
    """As without all this; an error on the way leaves things as they were, too."""
    handler = signal.getsignal(signal.SIGINT)
    with interrupts(deferred=False):
        ctrl_c()
        assert came == [signal.SIGINT]
    with pytest.raises(OSError, match="on the way"), interrupts(deferred=True):
        raise OSError("on the way")
    assert signal.getsignal(signal.SIGINT) is handler


def test_other_threads_have_nothing_to_do_with_it(came: list[int]) -> None:
    """Only the main thread may change what Ctrl-C does."""
    seen = []

    def work() -> None:
        with interrupts(deferred=True) as let_come:
            let_come()
            seen.append(signal.getsignal(signal.SIGINT))

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert seen == [signal.getsignal(signal.SIGINT)]

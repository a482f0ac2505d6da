"""Ctrl-C in the middle of repeated training: what is done comes back at once, whatever runs in parallel."""

import signal
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edugym import QLearning, repeat
from edugym.system.interrupts import Interrupted


def stopping(after: int, stop: Callable[[], None]) -> Callable[[Any], QLearning]:
    """A function that makes agents, and calls `stop` when it makes that of run `after`, where the first is 1."""
    made = -1  # the first is described in the results

    def make(environment: Any) -> QLearning:
        nonlocal made
        made += 1
        if made == after:
            stop()
        return QLearning.create(environment)

    return make


def interrupt() -> None:
    """Ctrl-C."""
    signal.raise_signal(signal.SIGINT)


@pytest.fixture(autouse=True)
def _ctrl_c_interrupts() -> None:
    """As in a terminal, also where the tests run in the background, which ignores Ctrl-C."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def test_what_is_done_comes_back(tmp_path: Path) -> None:
    """Two runs are complete, the third is in part, the fourth has not begun; and the same call goes on from there."""
    path = tmp_path / "results.csv"
    said = "2 of 4 runs are complete, 1 are unfinished; the same call goes on from there"
    with pytest.raises(Interrupted, match=said) as raised:
        repeat("Boulder", {"Q": stopping(3, interrupt)}, 200, repetitions=4, jobs=1, save_to=path)
    results = raised.value.partial
    complete = results.table.groupby("repetition")["complete"].first()
    assert complete.to_dict() == {0: True, 1: True, 2: False}
    assert results.table.query("repetition == 2")["step"].tolist() == [0]
    assert sorted(results.agents["Q"]) == [0, 1, 2]
    assert sorted(results.complete_agents("Q")) == [0, 1]
    assert not results.complete
    assert results.share("Q", at_least=0).n == 2
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    with pytest.raises(Interrupted, match="0 of 3 runs are complete, 1 are unfinished") as raised:
        repeat("Boulder", {"Q": stopping(1, interrupt)}, 200, repetitions=3, jobs=1)  # before the first step
    results = raised.value.partial
    assert (results.methods, results.complete, results.complete_agents("Q")) == (["Q"], False, {})
    assert results.share("Q", at_least=1).n == results.mean("Q").n == 0
    assert not path.exists()


def test_a_run_that_does_not_listen_is_left() -> None:
    """The order to stop does not reach it; the interrupt that follows does."""
    for jobs in (1, 2):
        go_on, described = threading.Event(), list[Any]()

        def stuck(environment: Any, go_on: threading.Event = go_on, described: list[Any] = described) -> QLearning:
            if described:  # the first one is described in the results; every run after it is stuck
                interrupt()
                go_on.wait(60)
            described.append(environment)
            return QLearning.create(environment)

        try:
            with pytest.raises(Interrupted, match="0 of 4 runs are complete"):
                repeat("Boulder", {"Q": stuck}, 200, repetitions=4, jobs=jobs)
        finally:
            go_on.set()


def test_an_event_stops_too() -> None:
    """From another thread, such as that of a button; and what comes after it is left out without a warning."""
    stop = threading.Event()
    with pytest.warns(UserWarning, match="stopped: 1 of 3 runs are complete") as caught:
        repeat("Boulder", {"Q": stopping(2, stop.set)}, 200, repetitions=3, jobs=1, stop=stop)
    assert [warning.filename for warning in caught] == [__file__]  # the line that has called `repeat`
    assert stop.is_set()
    assert repeat("Boulder", {"Q": QLearning.create}, 200, repetitions=3, stop=stop).table.empty

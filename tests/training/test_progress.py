"""How long a run still takes: said of long runs only, once for all runs of an experiment."""

import threading
from types import SimpleNamespace

import pytest

from edugym.system import waiting
from edugym.training import progress
from edugym.training.progress import progress_bar


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What is shown, and an empty text for each time that it is taken away."""
    lines: list[str] = []
    monkeypatch.setattr(waiting, "show", lines.append)
    monkeypatch.setattr(waiting, "clear", lambda text: lines.append(""))
    return lines


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    """The time, which passes when the test says so."""
    clock = SimpleNamespace(now=0.0)
    monkeypatch.setattr(progress, "time", SimpleNamespace(perf_counter=lambda: clock.now))
    return clock


@pytest.mark.parametrize(
    ("seconds", "told"),
    [
        ([0.1] * 100, ""),  # ten seconds are no long time
        ([0.5] * 100, "6% done, about 47 seconds to go"),
        ([2.0] * 100, "2% done, about 3 minutes to go"),
        ([3.0] + [0.01] * 99, ""),  # the compiler's time does not come again
        ([0.1, 5.0] + [0.01] * 98, ""),  # nor does it after some steps of the interpreter
    ],
)
def test_it_is_said_of_long_runs(seconds: list[float], told: str, said: list[str], clock: SimpleNamespace) -> None:
    """After some seconds, from the pace so far, and taken away at the end."""
    with progress_bar(100, "steps", shown=False) as bar:
        for gap in seconds:
            clock.now += gap
            bar.update(1)
    assert bool(said) == bool(told)
    if told:
        assert told in said[0]
        assert said[-1] == ""


def test_an_experiment_says_it_for_all_its_runs(said: list[str], clock: SimpleNamespace) -> None:
    """Of the whole, before the first run is over; its runs, in other threads too, say nothing themselves."""
    with progress_bar(40, "steps", shown=False) as bar:
        for _ in range(4):

            def run() -> None:
                with progress_bar(10, "steps", shown=False) as inner:
                    for _ in range(10):
                        clock.now += 1.0
                        inner.update(1)

            thread = threading.Thread(target=run)
            thread.start()
            thread.join()
            bar.update(10)
    shares = [line.split()[1] for line in said if line]
    assert shares[0] == "8%"  # 3 of 40
    assert shares == sorted(shares, key=lambda share: int(share[:-1]))
    assert int(shares[-1][:-1]) <= 100


def test_who_asks_for_a_bar_gets_nothing_else(said: list[str], clock: SimpleNamespace) -> None:
    """Also not from the runs within it."""
    with progress_bar(10, "steps", shown=True), progress_bar(10, "steps", shown=False) as inner:
        for _ in range(10):
            clock.now += 5.0
            inner.update(1)
    assert said == []

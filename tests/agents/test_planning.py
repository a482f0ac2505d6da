"""How much is planned between two steps, with a clock that is made up."""

import math
import time

import pytest

from edugym.agents.planning import Seconds, Updates, budget


@pytest.mark.parametrize(("now", "lasts"), [(7.0, True), (7.49, True), (7.5, False), (8.0, False)])
def test_seconds(now: float, lasts: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Half a second from when planning began, however much was done."""
    monkeypatch.setattr(time, "perf_counter", lambda: 7.0)
    planning = budget(3, 0.5)
    began = planning.start()
    monkeypatch.setattr(time, "perf_counter", lambda: now)
    assert planning == Seconds(0.5)
    assert planning.lasts(99, began) == lasts


def test_updates() -> None:
    """So many, whatever the time is."""
    assert [budget(3, None).lasts(done, 0.0) for done in (0, 2, 3)] == [True, True, False]
    assert not budget(0, None).lasts(0, 0.0)
    assert budget(math.inf, None) == Updates(math.inf)
    assert budget(math.inf, None).lasts(10**9, 0.0)

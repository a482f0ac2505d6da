"""Progress bars: of one run, and of a whole experiment."""

from pathlib import Path
from typing import Any
from unittest.mock import MagicMock

import pytest

from edugym import QLearning, train
from tests.experiments.experiments import small
from tests.training.tasks import Stairs


@pytest.fixture
def bars(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """All bars that are shown: mocks, with what they have `seen`, and which say whether they are `closed`."""
    made = list[Any]()

    def bar(**how: Any) -> MagicMock:
        one = MagicMock(how=how, seen=[0], closed=False)
        one.__enter__.return_value = one
        one.__exit__.side_effect = lambda *_: setattr(one, "closed", True)
        one.update.side_effect = lambda n: one.seen.append(one.seen[-1] + n)
        made.append(one)
        return one

    monkeypatch.setattr("tqdm.auto.tqdm", bar)
    return made


def test_progress_counts_every_step(bars: list[Any]) -> None:
    """And is closed at the end."""
    train(Stairs(), QLearning.create(Stairs()), 1_234, progress=True)
    (bar,) = bars
    assert (bar.seen[-1], bar.closed) == (1_234, True)
    assert bar.how == {"total": 1_234, "unit": "steps", "unit_scale": True, "smoothing": 0.1}  # at the speed of late


def test_progress_of_an_experiment(bars: list[Any], tmp_path: Path) -> None:
    """It moves when a run is done, begins with the runs that were done before, and is not shown unless asked for."""
    small(300, checkpoints=tmp_path, repetitions=1)
    assert bars == []
    small(300, checkpoints=tmp_path, progress=True)
    (bar,) = bars
    assert (bar.how["total"], bar.how["unit"], bar.closed) == (1_800, "steps", True)
    assert bar.seen == [0, 600, 900, 1_200, 1_500, 1_800]

"""Progress bars: of one run, and of a whole experiment."""

from pathlib import Path
from typing import Any

import pytest

from edugym import QLearning, train
from tests.experiments.experiments import small
from tests.training.tasks import Stairs


class Clicker:
    """A progress bar that can be read."""

    def __init__(self, total: int, unit: str, **how: Any) -> None:
        """At 0."""
        self.total, self.unit, self.how, self.seen, self.closed = total, unit, how, [0], False

    def update(self, n: int) -> None:
        """Go on."""
        self.seen.append(self.seen[-1] + n)

    def __enter__(self) -> "Clicker":
        """It is open."""
        return self

    def __exit__(self, *error: object) -> None:
        """No more of it."""
        self.closed = True


@pytest.fixture
def bars(monkeypatch: pytest.MonkeyPatch) -> list[Clicker]:
    """All bars that are shown."""
    made: list[Clicker] = []

    def bar(**how: Any) -> Clicker:
        made.append(Clicker(**how))
        return made[-1]

    monkeypatch.setattr("tqdm.auto.tqdm", bar)
    return made


def test_progress_counts_every_step(bars: list[Clicker]) -> None:
    """And is closed at the end."""
    train(Stairs(), QLearning.create(Stairs()), 1_234, progress=True)
    (bar,) = bars
    assert (bar.total, bar.seen[-1], bar.unit, bar.closed) == (1_234, 1_234, "steps", True)
    assert bar.how == {"unit_scale": True, "smoothing": 0.1}  # 1.23k steps, at the speed of late


def test_progress_of_an_experiment(bars: list[Clicker], tmp_path: Path) -> None:
    """It moves when a run is done, begins with the runs that were done before, and is not shown unless asked for."""
    small(300, checkpoints=tmp_path, repetitions=1)
    assert bars == []
    small(300, checkpoints=tmp_path, progress=True)
    (bar,) = bars
    assert (bar.total, bar.unit, bar.closed) == (1_800, "steps", True)
    assert bar.seen == [0, 600, 900, 1_200, 1_500, 1_800]

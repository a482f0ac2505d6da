"""Finished runs are kept: the same call goes on from them, and comes to the same results."""

import os
import signal
import subprocess
import sys
import threading
import time
import uuid
from contextlib import nullcontext, suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import joblib
import numpy as np
import pandas as pd
import pytest
from joblib.externals.loky.process_executor import TerminatedWorkerError

from edugym import EpsilonGreedy, QLearning, Results
from edugym.experiments import checkpoints
from edugym.experiments import repeat as repeating
from edugym.experiments.killed_workers import again_if_killed
from edugym.system.files import write_whole
from edugym.system.interrupts import SignalGuard
from edugym.training.run import Run
from edugym.training.train import train
from tests.experiments import experiments


@pytest.fixture
def trained(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The seeds of the runs that were computed, one after another."""
    seeds: list[int] = []

    def noted(*arguments: Any, **more: Any) -> Run:
        seeds.append(more["seed"])
        return train(*arguments, **more)

    monkeypatch.setattr(repeating, "train", noted)
    return seeds


def small(folder: Path | None, **changes: Any) -> Results:
    """Three runs on a low wall."""
    low: dict[str, Any] = {"n_steps": 300, "parameters": {"height": 4}, "checkpoints": folder}
    return experiments.small(**low | {"agents": {"Q": QLearning.create}} | changes)


def test_finished_runs_are_not_computed_again(tmp_path: Path, trained: list[int]) -> None:
    """They come back with their agents."""
    first = small(tmp_path)
    again = small(tmp_path)
    assert len(trained) == 3
    pd.testing.assert_frame_equal(first.table, again.table)
    for repetition, agent in first.agents["Q"].items():
        assert np.array_equal(agent.Q, again.agents["Q"][repetition].Q)
    assert small(tmp_path, repetitions=5, save_to=tmp_path.with_name("results.csv")).complete
    assert len(trained) == 5  # a longer experiment begins with the shorter one
    assert len(list(tmp_path.iterdir())) == 5  # a folder of one's own stays


def test_other_runs_are_not_mixed_in(tmp_path: Path, trained: list[int]) -> None:
    """Other settings, seeds or code make other runs."""
    changes: list[dict[str, Any]] = [
        *({"seed": 1}, {"n_steps": 301}, {"evaluate_every": 100}, {"evaluation_episodes": 2}, {"max_steps": 7}),
        {"parameters": {"height": 5}},
        {"agents": {"Q": lambda task: QLearning.create(task, learning_rate=0.2)}},
        {"agents": {"Q": QLearning.create((5, 2), exploration=EpsilonGreedy(0.2))}},
    ]
    for number, change in enumerate([{}, *changes], start=1):
        small(tmp_path, **change)
        assert len(trained) == 3 * number, change
    (tmp_path / "file").touch()
    with pytest.raises(NotADirectoryError, match="is not a folder"):  # before the first run
        small(tmp_path / "file")
    assert len(trained) == 27


def test_a_complete_experiment_removes_its_own_runs_only(tmp_path: Path, trained: list[int]) -> None:
    """What another experiment keeps at the same place stays there for its next call; what was half written goes."""
    folder = tmp_path / "results.csv.unfinished"
    small(folder)
    kept = sorted(folder.iterdir())
    (folder / "half.partial").touch()
    small(None, save_to=tmp_path / "results.csv", seed=1)
    assert sorted(folder.iterdir()) == kept
    small(None, save_to=tmp_path / "results.csv")
    assert len(trained) == 6
    assert not folder.exists()


def test_a_damaged_file_is_computed_again(tmp_path: Path, trained: list[int]) -> None:
    """Cut off, emptied, or with another number in a table."""
    whole = small(tmp_path)
    one, two, three = sorted(tmp_path.iterdir())
    one.write_bytes(one.read_bytes()[:-1])
    two.write_bytes(b"")
    changed = bytearray(three.read_bytes())
    changed[max(changed.find(agent.Q.tobytes()) for agent in whole.agents["Q"].values())] ^= 1
    three.write_bytes(changed)
    pd.testing.assert_frame_equal(small(tmp_path).table, whole.table)
    assert len(trained) == 6


@pytest.mark.parametrize("kind", ["local", "lock"])
def test_what_cannot_be_kept_is_said(kind: str, tmp_path: Path) -> None:
    """Once, and the results are complete all the same; where nothing was to be kept, there is nothing to say."""
    lock = threading.Lock()  # cannot be told from another one

    class Local(QLearning):  # no other process finds it
        __slots__ = ()

    def locked(task: Any) -> Any:
        with lock:
            return QLearning.create(task)

    make = locked if kind == "lock" else lambda task: Local(*QLearning.create(task))
    for folder, path in ((tmp_path / "runs", None), (None, tmp_path / "results.csv")):
        with pytest.warns(UserWarning, match="runs of 'Q' cannot be kept .*(lock|local)") as said:
            assert small(folder, agents={"Q": make}, save_to=path).complete
        assert len(said) == 1
    assert not any((tmp_path / "runs").glob("*"))
    assert not (tmp_path / "results.csv.unfinished").exists()
    assert small(None, agents={"Q": make}).complete


def test_a_full_disk_loses_no_finished_run(tmp_path: Path, trained: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    """The error says so, and the same call goes on when there is room; an older file stays until then."""
    path = tmp_path / "results.csv"
    small(None, save_to=path, seed=1)
    older = path.read_bytes()
    trained.clear()

    def write(file: Path, contents: bytes, *, synced: bool) -> Path:
        if len(trained) == 2:
            raise OSError("no space left")
        return write_whole(file, contents, synced=synced)

    monkeypatch.setattr(checkpoints, "write_whole", write)
    with pytest.raises(OSError, match="no space left"):
        small(None, save_to=path)
    assert path.read_bytes() == older
    assert len(trained) == 2
    assert len(list(Path(f"{path}.unfinished").iterdir())) == 1
    monkeypatch.undo()
    assert small(None, save_to=path).complete
    assert sorted(file.name for file in tmp_path.iterdir()) == ["results.csv", "results.csv.json"]


CHILD = """
import sys
from edugym import QLearning, repeat
repeat("Boulder", {"Q": QLearning.create}, 3_000, repetitions=80, jobs=2, save_to=sys.argv[1])
"""


@pytest.mark.slow
def test_kill_9_loses_no_finished_run(tmp_path: Path) -> None:
    """Killed again and again, the same call finishes with the same bytes."""

    def begin(path: Path) -> subprocess.Popen[bytes]:
        return subprocess.Popen([sys.executable, "-c", CHILD, str(path)])

    whole, killed = tmp_path / "whole.csv", tmp_path / "killed.csv"
    assert begin(whole).wait(timeout=120) == 0
    folder = Path(f"{killed}.unfinished")
    rng = np.random.default_rng(0)
    for kill in range(4):
        with begin(killed) as child:
            while child.poll() is None and len(list(folder.glob("*.run"))) < 15 * (kill + 1):
                time.sleep(0.005)
            time.sleep(rng.uniform(0, 0.05))
            os.kill(child.pid, signal.SIGKILL)
        assert not killed.exists()
    assert begin(killed).wait(timeout=120) == 0
    assert killed.read_bytes() == whole.read_bytes()
    assert Path(f"{killed}.json").read_bytes() == Path(f"{whole}.json").read_bytes()
    assert not folder.exists()


def test_ctrl_c_ends_what_a_killed_worker_has_left() -> None:
    """A worker that dies while runs are told to stop is not replaced."""
    guard, calls = SignalGuard(), []

    def killed() -> None:
        calls.append(1)
        guard.stop_ordered = True
        raise TerminatedWorkerError

    again_if_killed(killed, {}, guard)
    assert calls == [1]


class ActorDied(Exception):
    """Stands for Ray's error, where Ray is not installed."""


@pytest.mark.parametrize("error", [TerminatedWorkerError, ActorDied], ids=["joblib", "Ray"])
@pytest.mark.parametrize(("n_killed", "n_calls"), [(1, 2), (2, 3), (3, 3)])
def test_work_of_a_killed_worker_is_done_again(
    error: type[Exception], n_killed: int, n_calls: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three times at most, if no run ends meanwhile; then the error is raised."""
    monkeypatch.setitem(sys.modules, "ray.exceptions", SimpleNamespace(RayActorError=ActorDied))
    calls = []

    def work() -> None:
        calls.append(1)
        if len(calls) <= n_killed:
            raise error

    ends = pytest.raises(error) if n_killed == n_calls else nullcontext()
    with pytest.warns(RuntimeWarning, match="killed"), ends:
        again_if_killed(work, {}, SignalGuard())
    assert len(calls) == n_calls


@pytest.mark.slow
@pytest.mark.parametrize("always", [False, True], ids=["once", "again and again"])
def test_a_worker_that_is_killed_loses_no_run(tmp_path: Path, always: bool) -> None:
    """What is missing is done once more, to the same bytes; a run that kills its worker each time ends the call."""
    here, path = os.getpid(), tmp_path / "killed.csv"

    def deadly(wall: Any) -> QLearning:
        if os.getpid() != here:
            with suppress(FileExistsError):
                (tmp_path / str(uuid.uuid4() if always else "killed")).touch(exist_ok=False)
                os.kill(os.getpid(), signal.SIGKILL)
        return QLearning.create(wall)

    many: dict[str, Any] = {"agents": {"Q": deadly}, "repetitions": 12}
    with joblib.parallel_config(backend="loky", n_jobs=2):
        if always:
            with pytest.raises(TerminatedWorkerError), pytest.warns(RuntimeWarning, match="was killed"):
                small(None, jobs=None, **many)
            return
        with pytest.warns(RuntimeWarning, match="was killed"):
            assert small(None, jobs=None, save_to=path, **many).complete
    assert (tmp_path / "killed").exists()
    small(None, save_to=tmp_path / "whole.csv", **many)
    assert path.read_bytes() == (tmp_path / "whole.csv").read_bytes()

"""Deep agents trained several times: one table, the same for any number of processes, and nothing done twice."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("torch")

from edugym.deep import PPO, repeated
from edugym.deep.repeated import repeat_deep
from edugym.training.configuration import Planned
from edugym.training.train import Run


def pretend(n_steps: int, *, seed: int, more: float = 0.0) -> Run:
    """A run in which nothing is learned, three steps longer than asked for."""
    curve = np.array([0.0, seed % 7 + more])
    return Run(np.array([0, n_steps + 3]), curve, curve, np.array([0, 1]), object(), seed, 0.1, complete=True)


def test_the_table() -> None:
    """Every method has the same seeds; the last point is at the number of steps; settings and versions are in it."""
    results = repeat_deep({"one": pretend, "two": partial(pretend, more=0.5)}, 100, repetitions=3, jobs=1)
    assert results.methods == ["one", "two"]
    assert results.complete
    np.testing.assert_array_equal(results.final("two") - results.final("one"), [0.5, 0.5, 0.5])
    assert results.curves("one").index.tolist() == [0, 100]
    assert results.table["seed"].nunique() == 3
    assert '{"more": 0.5}' in results.table["settings"].iloc[-1]
    assert "torch" in results.table["versions"].iloc[0]


def test_saved_and_loaded(tmp_path: Path) -> None:
    """As any table of results."""
    results = repeat_deep({"one": pretend}, 100, repetitions=2, jobs=1)
    results.save(tmp_path / "deep.csv")
    assert results.load(tmp_path / "deep.csv").table.equals(results.table)


def test_finished_runs_are_not_done_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same call goes on where it was stopped; another setting is another experiment."""
    done: list[Planned] = []
    do = repeated._do

    def counted(trainer: repeated.Trainer, n_steps: int, planned: Planned) -> tuple[Planned, Run]:
        done.append(planned)
        return do(trainer, n_steps, planned)

    monkeypatch.setattr(repeated, "_do", counted)
    repeat_deep({"one": pretend}, 100, repetitions=2, jobs=1, checkpoints=tmp_path)
    assert len(done) == 2
    repeat_deep({"one": pretend}, 100, repetitions=3, jobs=1, checkpoints=tmp_path)
    assert len(done) == 3
    repeat_deep({"one": partial(pretend, more=1.0)}, 100, repetitions=1, jobs=1, checkpoints=tmp_path)
    assert len(done) == 4


@pytest.mark.slow
def test_processes_change_nothing() -> None:
    """Two runs of PPO on Catch, one after the other and side by side."""
    ppo = PPO.create("Catch", {"observation_type": "vectorised"}, num_envs=8, length=16)
    one, two = (
        repeat_deep({"PPO": partial(ppo.train, evaluation_episodes=10)}, 512, repetitions=2, jobs=jobs)
        for jobs in (1, 2)
    )
    assert one.table.equals(two.table)


def test_other_code_is_another_experiment(tmp_path: Path) -> None:
    """Functions of the same name, as when a cell is changed and run again."""

    def made(more: float) -> Callable[..., Run]:
        def own(n_steps: int, *, seed: int) -> Run:
            return pretend(n_steps, seed=seed, more=more)

        return own

    for more in (0.0, 1.0):
        results = repeat_deep({"own": made(more)}, 100, repetitions=1, jobs=1, checkpoints=tmp_path)
        assert results.final("own")[0] % 1 == more % 1
    assert results.final("own")[0] == results.table["seed"].iloc[0] % 7 + 1.0


def test_input() -> None:
    """Errors name the parameter."""
    cases: list[dict[str, Any]] = [{"trainers": {}}, {"n_steps": 0}, {"repetitions": 0}, {"jobs": 0}, {"seed": -1}]
    for wrong in cases:
        arguments: dict[str, Any] = {"trainers": {"one": pretend}, "n_steps": 10} | wrong
        with pytest.raises(ValueError, match=f"^{next(iter(wrong))} must"):
            repeat_deep(arguments.pop("trainers"), arguments.pop("n_steps"), **arguments)

"""Deep agents trained several times: one table, the same for any number of processes, and nothing done twice."""

from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("torch")

from edugym.deep import PPO, repeated
from edugym.deep.repeated import repeat_deep
from edugym.experiments.configuration import Planned, planned_runs
from edugym.experiments.fingerprints import versions
from edugym.experiments.results.rows import MEASURED
from edugym.training.run import Run
from tests.messages import named


def pretend(n_steps: int, *, seed: int, more: float = 0.0) -> Run:
    """A run in which nothing is learned, three steps longer than asked for."""
    curve = np.array([0.0, seed % 7 + more])
    return Run(np.array([0, n_steps + 3]), curve, curve, np.array([0, 1]), object(), seed, 0.1, complete=True)


def test_every_column() -> None:
    """What was measured, the arguments, and the settings of each method: of a function, a partial, and an agent."""
    agent = PPO.create("Catch", {"rows": 5}, clip=0.3)
    results = repeat_deep({"one": pretend, "two": partial(pretend, more=0.5)}, 100, repetitions=2, seed=9, jobs=1)
    table = results.table
    columns = ["n_steps", "repetitions", "runs", "experiment_seed", "settings", "versions"]
    assert list(table.columns) == [*MEASURED, *columns]
    assert table[columns[:4]].drop_duplicates().to_numpy().tolist() == [[100, 2, 4, 9]]
    assert table["settings"].unique().tolist() == ['"pretend"', '["pretend", {"more": 0.5}]']
    assert repeated._settings(agent.train) == ["train", agent._asdict()]
    packages = ("torch", "stable-baselines3", "sb3-contrib")
    assert table["versions"].unique().tolist() == [versions(*packages)]
    assert versions(*packages).endswith("".join(f", {name} {version(name)}" for name in packages))
    seeds = [planned.repetition.seed for planned in planned_runs(["one"], 2, 9)]
    assert sorted(table["repetition"].unique()) == [0, 1]
    assert table["seed"].tolist() == [seeds[0]] * 4 + [seeds[1]] * 4
    assert results.final("one").tolist() == [seed % 7 for seed in seeds]
    assert table["layout_seed"].isna().all()
    assert results.agents == {}


def rounds(n_steps: int, *, seed: int, complete: bool = True) -> Run:
    """A run with points after steps of its own, whatever it is asked for."""
    steps, returns = np.array([0, 60, 105, 108]), np.array([0.0, 1.0, 2.0, 3.0])
    training_returns, episodes = np.array([np.nan, 1.0, 5.0, 2.0]), np.array([0, 2, 1, 2])
    return Run(steps, returns, training_returns, episodes, object(), seed, 0.1, complete)


def test_steps_increase() -> None:
    """A point above the number of steps is not the last but one: it is part of the last, (1·5 + 2·2) / 3 = 3."""
    results = repeat_deep({"one": rounds}, 100, repetitions=1, jobs=1)
    assert results.curves("one").index.tolist() == [0, 60, 100]
    assert results.curves("one")[0].tolist() == [0, 1, 3]
    assert results.curves("one", "training_return")[0].tolist()[1:] == [1, 3]
    assert results.table["episodes"].tolist() == [0, 2, 3]
    assert results.average("one")[0] == pytest.approx((60 * 0.5 + 40 * 2) / 100)
    stopped = repeat_deep({"one": partial(rounds, complete=False)}, 10_000, repetitions=1, jobs=1)
    assert stopped.table["step"].tolist() == [0, 60, 105, 108]  # its last point is where it stopped


@pytest.mark.parametrize(
    ("episodes", "mean"),
    [([0, 1, 0, 2], (1 * 5 + 2 * 2) / 3), ([0, 0, 0, 0], np.nan), ([4, 0, 0, 1], 2.0)],
)
def test_points_without_an_episode(episodes: list[int], mean: float) -> None:
    """They do not count in the mean of the last point, which is none where no episode ended."""
    curve = np.array([0, 90, 102, 103]), np.arange(4.0), np.array([7.0, 5.0, np.nan, 2.0]), np.array(episodes)
    run = repeated._to(80, Run(*curve, None, 0, 0.1, complete=True))
    assert (run.steps.tolist(), run.returns.tolist()) == ([0, 80], [0.0, 3.0])
    assert run.episodes.tolist() == [episodes[0], sum(episodes[1:])]
    np.testing.assert_allclose(run.training_returns, [7.0, mean])


@pytest.mark.parametrize("n_steps", [98, 121])
def test_many_more_or_fewer_steps_are_refused(n_steps: int) -> None:
    """The sentence says how to choose their number; a tenth is no matter."""
    repeat_deep({"one": rounds}, 120, repetitions=1, jobs=1)
    with pytest.raises(ValueError, match=named("n_steps", n_steps, "'one'", 108)):
        repeat_deep({"one": rounds}, n_steps, repetitions=1, jobs=1)


def test_finished_runs_are_not_done_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same call goes on where it was stopped, here by an error; another setting is another experiment."""
    done: list[Planned] = []
    do = repeated._do

    def counted(trainer: repeated.Trainer, n_steps: int, planned: Planned) -> tuple[Planned, Run]:
        done.append(planned)
        if len(done) == 2:
            raise OSError("no room")
        return do(trainer, n_steps, planned)

    def repeat(repetitions: int, more: float = 0.0) -> int:
        how: dict[str, Any] = {"repetitions": repetitions, "jobs": 1, "checkpoints": tmp_path}
        repeat_deep({"one": partial(pretend, more=more)}, 100, **how)
        return len(done)

    monkeypatch.setattr(repeated, "_do", counted)
    with pytest.raises(OSError, match="no room"):
        repeat(2)
    assert len(list(tmp_path.glob("*.run"))) == 1
    assert [repeat(2), repeat(2), repeat(3), repeat(1, more=1.0)] == [3, 3, 4, 5]
    methods = repeat_deep({"new": pretend, "one": partial(pretend, more=1.0)}, 100, repetitions=1, checkpoints=tmp_path)
    assert list(methods.table["method"].unique()) == ["new", "one"]  # not in the order in which they were done


@pytest.mark.slow
def test_processes_change_nothing() -> None:
    """Two runs of PPO on Catch, one after the other and side by side."""
    ppo = PPO.create("Catch", {"observation_type": "vectorised"}, num_envs=8, length=16)
    one, two = (
        repeat_deep({"PPO": partial(ppo.train, evaluation_episodes=10)}, 512, repetitions=2, jobs=jobs)
        for jobs in (1, 2)
    )
    assert one.table.equals(two.table)


def test_input() -> None:
    """Errors name the parameter."""
    cases: list[dict[str, Any]] = [{"trainers": {}}, {"n_steps": 0}, {"repetitions": 0}, {"jobs": 0}, {"seed": -1}]
    for wrong in cases:
        arguments: dict[str, Any] = {"trainers": {"one": pretend}, "n_steps": 10} | wrong
        with pytest.raises(ValueError, match=named(next(iter(wrong)))):
            repeat_deep(arguments.pop("trainers"), arguments.pop("n_steps"), **arguments)

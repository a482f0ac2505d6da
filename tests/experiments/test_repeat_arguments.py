"""What `repeat` is told reaches every run, and is in its results."""

import threading
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from gymnasium.error import DependencyNotInstalled

from edugym import SARSA, QLearning, repeat, train
from edugym.envs.boulder import Boulder
from edugym.experiments.configuration import plain, planned_runs, task
from tests.training.tasks import Ring, SlipperyWalk

AGENTS: dict[str, Any] = {
    "Q": lambda task: QLearning.create(task, learning_rate=0.25),
    "SARSA": lambda task: SARSA.create(task, discount=0.5),
}


def test_every_run_is_that_of_train() -> None:
    """With the same arguments and the seed of its repetition: curve, returns, episodes and tables."""
    how: dict[str, Any] = {"max_steps": 4, "evaluate_every": 90, "evaluation_episodes": 3}
    results = repeat(SlipperyWalk(), AGENTS, 300, repetitions=2, seed=7, jobs=2, **how)
    seeds = results.table.groupby("repetition")["seed"].first()
    for method, make in AGENTS.items():
        for repetition in (0, 1):
            run = train(SlipperyWalk(), make(SlipperyWalk()), 300, seed=int(seeds[repetition]), **how)
            rows = results.table.query("method == @method and repetition == @repetition")
            assert rows["step"].tolist() == run.steps.tolist() == [0, 90, 180, 270, 300]
            assert rows["episodes"].tolist() == run.episodes.tolist()
            np.testing.assert_array_equal(rows["return"], run.returns)
            np.testing.assert_array_equal(rows["training_return"], run.training_returns)
            assert (results.agents[method][repetition].Q == run.agent.Q).all()
    asked = how | {"n_steps": 300, "repetitions": 2, "runs": 4, "experiment_seed": 7}
    assert results.table[[*asked]].drop_duplicates().to_dict("records") == [asked]
    settings = results.table.groupby("method")[["agent", "agent.learning_rate", "agent.discount"]].first()
    assert settings.to_numpy().tolist() == [["QLearning", 0.25, 0.99], ["SARSA", 0.1, 0.5]]


def test_the_runs_come_in_order() -> None:
    """Repetition by repetition, each with every method, in the order in which the methods are given."""
    results = repeat(Ring(), dict(reversed(AGENTS.items())), 10, repetitions=2, evaluate_every=10, jobs=1)
    rows = results.table[["repetition", "method", "step"]].to_numpy().tolist()
    assert rows == [[i, method, step] for i in (0, 1) for method in ("SARSA", "Q") for step in (0, 10)]


def test_an_experiment_that_is_stopped_before_it_begins() -> None:
    """Has no rows and no agents, and warns of nothing; its methods are known."""
    stop = threading.Event()
    stop.set()
    results = repeat(Ring(), AGENTS, 50, repetitions=2, jobs=1, stop=stop)
    assert results.methods == ["Q", "SARSA"]
    assert results.agents == {"Q": {}, "SARSA": {}}
    assert len(results.table) == 0
    assert not results.complete


def test_what_was_finished_before_it_was_stopped_is_not_loaded(tmp_path: Path) -> None:
    """Nor does it get lost."""
    arguments: dict[str, Any] = {"n_steps": 50, "repetitions": 1, "jobs": 1, "checkpoints": tmp_path}
    whole = repeat(Ring(), AGENTS, **arguments)
    stop = threading.Event()
    stop.set()
    assert len(repeat(Ring(), AGENTS, stop=stop, **arguments).table) == 0
    pd.testing.assert_frame_equal(repeat(Ring(), AGENTS, **arguments).table, whole.table)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"jobs": 1001}, "jobs must be a whole number from 1 to 1000, -1 or None, but is 1001"),
        ({"jobs": -2}, "jobs must be a whole number from 1 to 1000, -1 or None, but is -2"),
        (
            {"agents": {"Q": Ring}},
            r"must be an agent or a function that .* but is the class Ring: give Ring\(\.\.\.\)$",
        ),
        ({"agents": AGENTS | {"": Ring()}}, "the labels of agents must be texts that are not empty, but one is ''"),
    ],
)
def test_what_else_is_refused(changes: dict[str, Any], message: str) -> None:
    """In words that name what is wrong."""
    arguments: dict[str, Any] = {"environment": Ring(), "agents": AGENTS, "n_steps": 10, "repetitions": 1, "jobs": 1}
    with pytest.raises(ValueError, match=message):
        repeat(**arguments | changes)


@pytest.mark.parametrize("library", ["joblib", "pandas"])
def test_a_library_that_is_missing_is_said_first(library: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """With what brings it."""
    monkeypatch.setattr("edugym.system.extras.find_spec", lambda name: None if name == library else name)
    with pytest.raises(DependencyNotInstalled, match=rf'{library} is not .* "edugym\[experiments\]"'):
        repeat(Ring(), AGENTS, 0)


class Odd:
    """A value that no text can hold."""


@pytest.mark.parametrize(
    ("value", "written"),
    [
        (np.float64(0.5), 0.5),
        (np.int8(3), 3),
        (np.True_, True),
        ("left", "left"),
        ((1, 2.5), "[1, 2.5]"),
        ({"a": [None, True]}, '{"a": [null, true]}'),
        (Odd(), '"Odd"'),
        (np.arange(4).reshape(2, 2), "[[0, 1], [2, 3]]"),
        (np.arange(32), str([*range(32)])),
        (np.full((3, 11), 0.5), '{"shape": [3, 11], "filled_with": 0.5}'),
        (np.arange(33.0), '{"shape": [33], "sha256": "adea144801c3828f"}'),
    ],
    ids=lambda value: type(value).__name__,
)
def test_how_settings_are_written(value: Any, written: Any) -> None:
    """As numbers and texts; a long array by its shape, and what is in it in short."""
    found = plain(value)
    assert (type(found), found) == (type(written), written)


BOULDER = {"environment": "edugym/Boulder-v0", "environment.height": 10, "environment.n_grips": 2}


@pytest.mark.parametrize(
    ("environment", "parameters", "settings", "has_layout"),
    [
        ("Boulder", None, BOULDER, True),
        (
            "Boulder",
            {"height": 3, "max_steps": 7},
            BOULDER | {"environment.height": 3, "environment.max_steps": 7},
            True,
        ),
        ("Boulder", {"layout_seed": 4}, BOULDER | {"layout_seed": 4}, False),
        (
            "MemoryCorridor",
            {},
            {
                "environment": "edugym/MemoryCorridor-v0",
                "environment.num_doors": 3,
                "environment.max_steps": 1000,
            },
            False,
        ),
        (SlipperyWalk(), None, {"environment": "SlipperyWalk"}, False),
        (
            lambda layout_seed: Boulder.create(4, max_steps=9, layout_seed=layout_seed),
            None,
            {"environment": "Boulder", "environment.height": 4, "environment.n_grips": 2, "environment.max_steps": 9},
            True,
        ),
    ],
)
def test_how_a_task_is_described(
    environment: Any, parameters: dict[str, Any] | None, settings: dict[str, Any], has_layout: bool
) -> None:
    """By the parameters that all its layouts have in common; the layout only where it is fixed."""
    described = task(environment, parameters)
    assert (described.settings, described.has_layout) == (settings, has_layout)


def test_the_plan() -> None:
    """Repetition by repetition, each with its own two seeds, the same in every longer plan."""
    plan = planned_runs(["a", "b"], 3, 5)
    assert [(run.method, run.repetition.number) for run in plan] == [(m, k) for k in range(3) for m in ("a", "b")]
    seeds = {(run.repetition.seed, run.repetition.layout_seed) for run in plan}
    assert len({seed for pair in seeds for seed in pair}) == 6
    assert planned_runs(["b"], 2, 5) == [plan[1], plan[3]]
    assert planned_runs(["a"], 1, 6)[0].repetition.seed != plan[0].repetition.seed

"""What `repeat` is told reaches every run, and is in its results."""

import threading
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from edugym import SARSA, QLearning, repeat, train
from edugym.envs.boulder import Boulder
from edugym.experiments.configuration import planned_runs, task
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


def test_an_experiment_that_is_stopped_before_it_begins(tmp_path: Path) -> None:
    """Has no rows and no agents, and warns of nothing; its methods are known. What was finished is not lost."""
    arguments: dict[str, Any] = {"n_steps": 50, "repetitions": 1, "jobs": 1, "checkpoints": tmp_path}
    whole = repeat(Ring(), AGENTS, **arguments)
    stop = threading.Event()
    stop.set()
    for kept in (tmp_path, None):
        results = repeat(Ring(), AGENTS, stop=stop, **arguments | {"checkpoints": kept})
        assert (results.methods, results.agents) == (["Q", "SARSA"], {"Q": {}, "SARSA": {}})
        assert (len(results.table), results.complete) == (0, False)
    pd.testing.assert_frame_equal(repeat(Ring(), AGENTS, **arguments).table, whole.table)


@pytest.mark.parametrize(
    ("changes", "names"),
    [
        ({"environment": "Bolder"}, "environment .* Boulder, .*Bolder"),
        ({"environment": None}, "environment .* None$"),
        ({"environment": lambda: None}, r"environment .*layout_seed.* \(\)"),
        ({"environment": lambda layout_seed: None}, "environment that the function makes .* None$"),
        ({"environment": Ring}, r"environment .*class Ring: make one with Ring\(\.\.\.\)"),
        ({"environment": Boulder}, r"environment .*class Boulder: make one with Boulder\.create\(\.\.\.\)"),
        ({"parameters": {"height": 3}}, "parameters .*environment is Ring"),
        ({"parameters": [1]}, r"parameters .*\[1\]"),
        ({"environment": "Boulder", "parameters": {"heigth": 3}}, "heigth.*height, n_grips"),
        ({"environment": "Boulder", "parameters": {"height": 0}}, "height .* 0$"),
        ({"agents": {}}, "^agents .*empty"),
        ({"agents": QLearning}, "^agents .*QLearning"),
        ({"agents": {"Q": QLearning}}, r"agents\['Q'\] .* class QLearning: give QLearning\.create"),
        ({"agents": {"Q": Ring}}, r"agents\['Q'\] .* class Ring: give Ring\(\.\.\.\)$"),
        ({"agents": {"": QLearning.create}}, "labels .* ''"),
        ({"agents": {1: QLearning.create}}, "labels .* 1"),
        ({"agents": {"Q": lambda: None}}, r"agents\['Q'\] .*lambda environment"),
        ({"agents": {"Q": lambda environment, seed: None}}, r"agents\['Q'\] .*lambda environment"),
        ({"agents": {"Q": partial(QLearning.create, rate=0.5)}}, "QLearning .*'rate'; it has learning_rate"),
        ({"agents": {"Q": lambda environment: None}}, r"agents\['Q'\] .* None"),
        ({"agents": {"Q": 3}}, r"agents\['Q'\] .* 3$"),
        ({"n_steps": 0}, "n_steps .* 0$"),
        ({"repetitions": 0}, "repetitions .* 0$"),
        ({"seed": -1}, "seed .* -1$"),
        *(({"jobs": jobs}, f"jobs .*1 to 1000, -1 or None.* {jobs}$") for jobs in (1.0, True, 0, -2, 1001)),
        ({"save_to": 5}, "save_to .* 5$"),
        ({"checkpoints": ""}, "checkpoints .* ''$"),
        ({"stop": threading.Event}, "stop .*class Event"),
        ({"evaluate_every": 0}, "evaluate_every .* 0$"),
    ],
)
def test_wrong_arguments_are_named(changes: dict[str, Any], names: str) -> None:
    """Each message has the parameter, its value, and what is allowed."""
    arguments: dict[str, Any] = {"environment": Ring(), "agents": AGENTS, "n_steps": 10, "repetitions": 1, "jobs": 1}
    with pytest.raises(ValueError, match=names):
        repeat(**arguments | changes)


def test_the_plan() -> None:
    """Repetition by repetition, each with its own two seeds, the same in every longer plan."""
    plan = planned_runs(["a", "b"], 3, 5)
    assert [(run.method, run.repetition.number) for run in plan] == [(m, k) for k in range(3) for m in ("a", "b")]
    seeds = {(run.repetition.seed, run.repetition.layout_seed) for run in plan}
    assert len({seed for pair in seeds for seed in pair}) == 6
    assert planned_runs(["b"], 2, 5) == [plan[1], plan[3]]
    assert planned_runs(["a"], 1, 6)[0].repetition.seed != plan[0].repetition.seed


BOULDER = {"environment": "edugym/Boulder-v0", "environment.height": 10, "environment.n_grips": 2}
MADE = {"environment": "Boulder", "environment.height": 4, "environment.n_grips": 2, "environment.max_steps": 9}
HIGHER = BOULDER | {"environment.height": 3, "environment.max_steps": 7}
CORRIDOR = {"environment": "edugym/MemoryCorridor-v0", "environment.num_doors": 3, "environment.max_steps": 1000}


@pytest.mark.parametrize(
    ("environment", "parameters", "settings", "has_layout"),
    [
        ("Boulder", None, BOULDER, True),
        ("Boulder", {"height": 3, "max_steps": 7}, HIGHER, True),
        ("Boulder", {"layout_seed": 4}, BOULDER | {"layout_seed": 4}, False),
        ("MemoryCorridor", {}, CORRIDOR, False),
        (SlipperyWalk(), None, {"environment": "SlipperyWalk"}, False),
        (lambda layout_seed: Boulder.create(4, max_steps=9, layout_seed=layout_seed), None, MADE, True),
    ],
)
def test_how_a_task_is_described(environment: Any, parameters: Any, settings: Any, has_layout: bool) -> None:
    """By the parameters that all its layouts have in common; the layout only where it is fixed."""
    described = task(environment, parameters)
    assert (described.settings, described.has_layout) == (settings, has_layout)

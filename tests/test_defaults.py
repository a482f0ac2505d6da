"""What is taken where nothing is given: numbers that a lesson, a page or a student's comparison relies on."""

import inspect
import pkgutil
from typing import Any

import pytest

from tests.agents.cases import AGENTS

pytest.importorskip("torch")

DEFAULTS: dict[str, dict[str, Any]] = {
    "Brightness": {"low": 0.4, "high": 1.0},
    "CountBased": {"bonus": 1.0},
    "DQN": {
        "hidden": 64,
        "memory_size": 10_000,
        "batch_size": 32,
        "learning_rate": 0.001,
        "learn_every": 4,
        "learn_from": 1000,
        "copy_every": 250,
        "error_clip": 1.0,
    },
    "DynaQ": {"exploration_bonus": 0.0, "expected_updates": False},
    "EpsilonGreedy": {"epsilon": 0.1},
    "FrameStack": {"actions": False},
    "GaussianActorCritic": {"learning_rate": 0.01, "value_learning_rate": 0.2, "spread": 0.5},
    "GoExplore": {"longest": 1000, "explore_steps": 20},
    "Hashed": {"capacity": 100_000, "overflow": False},
    "HashedTable": {"overflow": False},
    "Identity": {"constant": 1.0},
    "NStepSARSA": {"longest": 10_000},
    "NoisyObservation": {"levels": 0, "sigma": 0.0},
    "PrioritisedSweeping": {"threshold": 0.001, "expected_updates": True},
    "REINFORCE": {"longest": 10_000},
    "RMax": {
        "planning_steps": 1000,
        "lowest_return": -100.0,
        "highest_return": 100.0,
        "known_after": 1,
        "threshold": 0.001,
    },
    "RiskSensitiveQLearning": {"risk": -1.0},
    "SeparateFrames": {"actions": False},
    "Softmax": {"temperature": 1.0},
    "TileCoding": {"tiles": 8, "tilings": 8},
    "UCB": {"c": 1.0},
    "check_mdp": {"n_steps": 200},
    "finite_horizon": {"discount": 1.0, "epsilon": 0.0},
    "finite_model": {"max_states": 50_000},
    "load": {"max_bytes": 2**30},
    "mean_interval": {"confidence": 0.95},
    "paired_difference": {"confidence": 0.95},
    "policy_evaluation": {"discount": 1.0, "tolerance": 1e-10, "max_sweeps": 100_000},
    "policy_iteration": {"discount": 1.0, "tolerance": 1e-10, "max_sweeps": 100_000, "max_iterations": 1000},
    "policy_of": {"greedy": False},
    "proportion_interval": {"confidence": 0.95},
    "record_visits": {"n_intervals": 100},
    "repeat": {"repetitions": 10, "seed": 0, "evaluation_episodes": 1, "jobs": -1, "progress": False},
    "stack_size": {"n_actions": 1},
    "train": {"evaluation_episodes": 1, "seed": 0, "progress": False},
    "value_iteration": {"discount": 1.0, "epsilon": 0.0, "tolerance": 1e-10, "max_sweeps": 100_000},
    "notebook.frames": {"seed": 0, "max_steps": 200, "frames_per_second": 4.0},
    "notebook.play": {"blind": False, "seed": 0},
    "playing.play": {"render": "ansi"},
    "playing.play_episode": {"seed": 0, "max_steps": 200},
    "playing.record": {"frames_per_second": 4.0},
    "playing.Game": {"seed": 0, "picture": "rgb_array"},
    "rendering.gif.to_gif": {"frames_per_second": 4.0},
    "plotting.Curves": {"column": "return", "share": False, "soft_label": "best ε-soft policy"},
    "plotting.Lines": {"log": False},
    "plotting.VisitMap": {"y_label": "state"},
    "deep.PPO": {
        "num_envs": 64,
        "length": 32,
        "epochs": 10,
        "minibatches": 4,
        "hidden": 64,
        "learning_rate": 0.002,
        "discount": 0.99,
        "trace_decay": 0.95,
        "clip": 0.2,
        "entropy_bonus": 0.0,
    },
    "deep.stable_baselines3_run": {"num_envs": 8, "evaluation_episodes": 100, "seed": 0},
    "deep.repeated.repeat_deep": {"repetitions": 10, "seed": 0, "jobs": -1},
}
"""By name, those that are numbers or texts. What all agents share is in another test."""


@pytest.mark.parametrize("name", DEFAULTS)
def test_defaults(name: str) -> None:
    """Of a function, or of what makes a value of a class; fields that have the same name have the same default."""
    subject: Any = pkgutil.resolve_name(f"edugym.{name}")
    made = getattr(subject, "_field_defaults", {})
    if name != "deep.PPO":  # whose settings are all fields
        parameters = inspect.signature(getattr(subject, "create", subject)).parameters
        made = {key: parameter.default for key, parameter in parameters.items()}
    assert {key: made[key] for key in DEFAULTS[name]} == DEFAULTS[name]
    assert all(type(made[key]) is type(value) for key, value in DEFAULTS[name].items())
    fields = getattr(subject, "_field_defaults", {})
    assert all(made.get(key, value) == value for key, value in fields.items())


@pytest.mark.parametrize("kind", dict.fromkeys(case.kind for case in AGENTS.values()))
def test_tables_begin_with_zeros(kind: Any) -> None:
    """Where nothing else is said."""
    parameter = inspect.signature(kind.create).parameters.get("initial_value")
    assert parameter is None or parameter.default == 0.0

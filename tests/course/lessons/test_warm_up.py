"""What the lab compiles in the background while a student reads: every kind of agent and task that a lesson trains."""

import sys
from typing import Any

import gymnasium
import pytest

from edugym.training.run import Run
from edugym.training.train import train
from edugym_course.lessons import load_experiments

TRAINED = {
    "loop": 2, "exploration": 0, "on_off_policy": 9, "depth": 1, "dimensionality": 11, "memory": 4, "signal": 4,
    "continuous_actions": 3, "stochasticity": 5, "model_based": 5, "own_problem": 8,
    "goals": 6, "objectives": 0,
}  # fmt: skip
"""By lesson, the number of different pairs of a task and an agent that is trained on it."""
COMPILE_LONG = {"dimensionality", "memory", "signal", "continuous_actions", "model_based", "goals", "objectives"}


def kind(value: Any) -> str:
    """The class of a value, and in brackets those inside it."""
    if isinstance(value, gymnasium.Env):
        return kind(getattr(value.unwrapped, "mdp", type(value.unwrapped).__name__))
    inside = [kind(part) for part in value if hasattr(part, "_fields")] if hasattr(value, "_fields") else []
    name = value if isinstance(value, str) else type(value).__name__
    return f"{name}({', '.join(inside)})" if inside else name


@pytest.mark.parametrize(
    "lesson", [pytest.param(lesson, marks=[pytest.mark.slow] * (lesson in COMPILE_LONG)) for lesson in TRAINED]
)
def test_what_a_lesson_warms_up(lesson: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """All that is trained in it once, for a few steps."""
    found: set[tuple[str, str]] = set()

    def noted(environment: Any, agent: Any, *more: Any, **how: Any) -> Run:
        found.add((kind(environment), kind(agent)))
        return train(environment, agent, *more, **how)

    experiments = load_experiments(lesson)
    for name, module in [*sys.modules.items()]:
        if name.startswith(("edugym.", "edugym_course.")) and vars(module).get("train") is train:
            monkeypatch.setattr(module, "train", noted)
    if hasattr(experiments, "warm_up"):
        experiments.warm_up()
    assert len(found) == TRAINED[lesson], found

"""What the lab compiles in the background while a student reads: every kind of agent and task that a lesson trains."""

import sys
from typing import Any

import gymnasium
import pytest

from edugym.lessons import lesson_names, load_experiments
from edugym.training.run import Run
from edugym.training.train import train

TRAINED: dict[str, set[str]] = {}
"""Agent and task, with what is inside them, by lesson."""


def kind(value: Any) -> str:
    """The class of a value, and in brackets those inside it."""
    if isinstance(value, gymnasium.Env):
        return kind(getattr(value.unwrapped, "mdp", type(value.unwrapped).__name__))
    inside = [kind(part) for part in value if hasattr(part, "_fields")] if hasattr(value, "_fields") else []
    name = value if isinstance(value, str) else type(value).__name__
    return f"{name}({', '.join(inside)})" if inside else name


@pytest.mark.parametrize("lesson", lesson_names())
def test_what_a_lesson_warms_up(lesson: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """All that is trained in it once, for a few steps."""
    found: set[str] = set()

    def noted(environment: Any, agent: Any, *more: Any, **how: Any) -> Run:
        found.add(f"{kind(agent)} in {kind(environment)}")
        return train(environment, agent, *more, **how)

    experiments = load_experiments(lesson)
    for name, module in [*sys.modules.items()]:
        if name.partition(".")[0] == "edugym" and vars(module).get("train") is train:
            monkeypatch.setattr(module, "train", noted)
    if hasattr(experiments, "warm_up"):
        experiments.warm_up()
    assert found == TRAINED.get(lesson, set())

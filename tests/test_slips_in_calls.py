"""Calls in which a student confuses two values, or leaves the range, are answered with one sentence."""

from collections.abc import Callable
from typing import Any

import pytest

import edugym
from edugym.experiments.figures import save_figure
from tests.compiled.cells import WALK, cell

walk = cell(WALK)["Walk"](5)
model = edugym.finite_model(walk)
agent = edugym.QLearning.create(walk)
CALLS: dict[str, tuple[Callable[[], Any], str]] = {
    "an agent for a policy": (
        lambda: edugym.policy_evaluation(model, agent),
        r"policy must be an array, but is an agent: policy_of\(agent, model\) gives",
    ),
    "a task for a model": (
        lambda: edugym.policy_of(agent, walk),
        r"model must be a FiniteModel, .* is Walk\(size=5\)$",
    ),
    "95 for 95 %": (lambda: edugym.mean_interval([1, 2], 95), "confidence must be from 0 to 1, but is 95"),
    "the same of a share": (lambda: edugym.proportion_interval(1, 2, 95), "confidence must be from 0 to 1, but is 95"),
    "a run for its agent": (
        lambda: edugym.train(walk, edugym.train(walk, agent, 9, max_steps=9), 9),
        r"^agent must be .*, but is a Run: give its agent, run\.agent$",
    ),
    "text for a figure": (
        lambda: save_figure("plot.png", "plot.png"),  # type: ignore[arg-type]
        r"figure must be a Matplotlib figure, as `draw\(\)` returns it, but is 'plot\.png'$",
    ),
    "the class first": (lambda: edugym.load(edugym.QLearning, "file"), "path must .* but is the class QLearning"),  # type: ignore[arg-type]
}


@pytest.mark.parametrize("name", CALLS)
def test_calls(name: str) -> None:
    """Each has a sentence."""
    call, says = CALLS[name]
    with pytest.raises(ValueError, match=says):
        call()


@pytest.mark.parametrize(("written", "meant"), [("Sarsa", "SARSA"), ("Qlearning", "QLearning"), ("mdpenv", "MDPEnv")])
def test_names_in_other_letters(written: str, meant: str) -> None:
    """The name that is meant is named."""
    with pytest.raises(AttributeError, match=f"no attribute '{written}': is '{meant}' meant"):
        getattr(edugym, written)

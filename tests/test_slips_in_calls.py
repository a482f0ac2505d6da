"""Calls in which a student confuses two values, or leaves the range, are answered with one sentence."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

import edugym
from edugym.experiments.figures import save_figure
from tests.compiled.cells import WALK, cell

walk = cell(WALK)["Walk"](5)
model = edugym.finite_model(walk)
agent = edugym.QLearning.create(walk)


half: Any = SimpleNamespace(probability=len, n_inputs=3, see=len, is_set=len)  # one of two methods that are needed
CALLS: dict[str, tuple[Callable[[], Any], str]] = {
    "an agent for a policy": (lambda: edugym.policy_evaluation(model, agent), r"policy .*policy_of\(agent, model\)"),
    "a task for a model": (lambda: edugym.policy_of(agent, walk), r"model .*FiniteModel.* Walk\(size=5\)$"),
    "95 for 95 %": (lambda: edugym.mean_interval([1, 2], 95), "confidence .*0 to 1.* 95"),
    "the same of a share": (lambda: edugym.proportion_interval(1, 2, 95), "confidence .*0 to 1.* 95"),
    "a run for its agent": (
        lambda: edugym.train(walk, edugym.train(walk, agent, 9, max_steps=9), 9), r"agent .*Run.*run\.agent$"
    ),
    "text for a figure": (lambda: save_figure("plot.png", "plot.png"), r"figure .*'plot\.png'$"),  # type: ignore[arg-type]
    "the class first": (lambda: edugym.load(edugym.QLearning, "file"), "path .*class QLearning"),  # type: ignore[arg-type]
    "half a strategy": (lambda: edugym.QLearning.create(walk, exploration=half), "exploration .*namespace"),
    "half of features": (lambda: edugym.SemiGradientSARSA.create(walk, features=half), "features .*namespace"),
    "half an event": (lambda: edugym.train(walk, agent, 9, stop=half), "stop .*namespace"),
}  # fmt: skip


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

"""Calls in which a student confuses two values, or leaves the range, are answered with one sentence."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import edugym
from edugym.experiments.figures import save_figure
from tests.compiled.cells import LEARNER, WALK, cell

walk = cell(WALK)["Walk"](5)
model = edugym.finite_model(walk)
agent = edugym.QLearning.create(walk)
students: Any = cell(LEARNER)["Learner"]


def learner(shape: tuple[int, int]) -> Any:
    """A student's agent."""
    return students(np.zeros(shape))


half: Any = SimpleNamespace(probability=len, n_inputs=3, see=len, is_set=len)  # one of two methods that are needed
CALLS: dict[str, tuple[Callable[[], Any], str]] = {
    "an agent for a policy": (lambda: edugym.policy_evaluation(model, agent), r"policy .*policy_of\(agent, model\)"),
    "a task for a model": (lambda: edugym.policy_of(agent, walk), r"model .*FiniteModel.* Walk\(size=5\)$"),
    "the agent of another task": (
        lambda: edugym.policy_of(edugym.QLearning.create((3, 2)), model), r"agent .*\(6, 2\).*\(3, 2\)"),
    "the model of another task": (
        lambda: edugym.policy_of(agent, edugym.finite_model(type(walk)(2))), r"agent .*\(3, 2\).*\(6, 2\)"),
    "a student's agent of another task": (lambda: edugym.policy_of(learner((3, 2)), model), "agent .*6 .*2 .*3"),
    "an endless evaluation": (
        lambda: edugym.train(walk, agent, 9, evaluation_episodes=10**12), "evaluation_episodes .*1000000, "),
    "an endless horizon": (lambda: edugym.finite_horizon(model, 10**9), "horizon .*10000000, .*1000000000$"),
    "more memory than there is": (
        lambda: edugym.record_visits(agent, (10**6, 2), 9, n_intervals=10**6), "visits .*1,000,000 .*n_intervals"),
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


@pytest.mark.filterwarnings("error")
def test_small_numbers_of_numpy() -> None:
    """They count as what they are, and nothing that is computed from them overflows."""
    small: Any = np.int8(100)
    assert len(edugym.finite_horizon(model, small)) == 101
    assert edugym.finite_model(walk, max_states=small).states == model.states
    assert edugym.REINFORCE.create(walk, longest=small).episode.states.shape == (101,)
    assert edugym.TileCoding.create((2, 2), tiles=small, tilings=small).n_features == 100 * 101**2
    assert edugym.proportion_interval(small, small) == edugym.proportion_interval(100, 100)
    runs = edugym.repeat(walk, {"Q": edugym.QLearning.create}, small, max_steps=9, repetitions=2, jobs=1)
    assert runs.last_step == 100


@pytest.mark.parametrize(("written", "meant"), [("Sarsa", "SARSA"), ("Qlearning", "QLearning"), ("mdpenv", "MDPEnv")])
def test_names_in_other_letters(written: str, meant: str) -> None:
    """The name that is meant is named."""
    with pytest.raises(AttributeError, match=f"no attribute '{written}': is '{meant}' meant"):
        getattr(edugym, written)

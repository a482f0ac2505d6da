"""Ctrl-C in a student's agent of which one method is machine code and another is not."""

import signal
from typing import Any

import numpy as np
import pytest

from edugym import Interrupted, make_mdp, train
from tests.compiled.cells import cell

PRESSING = """
def pressing(at):
    calls.append(at)
    if len(calls) == at:
        signal.raise_signal(signal.SIGINT)

class Agent(NamedTuple):
    Q: np.ndarray
    at: int
    def act(self, state, rng): return int(rng.random() * 2)
    def greedy(self, state, rng):
        return 0
    def learn(self, state, action, reward):
        self.Q[state, action] += 0.1 * (reward - self.Q[state, action])
"""
"""A method that presses Ctrl-C at one of its calls runs interpreted, since it changes a global list."""
LEARNER = PRESSING.replace("        self.Q[", "        pressing(self.at)\n        self.Q[", 1)
PLAYER = PRESSING.replace("        return 0\n", "        pressing(self.at)\n        return 0\n")


@pytest.mark.filterwarnings("ignore:.*interpreted")
@pytest.mark.parametrize("at", [3, 2_345])
@pytest.mark.parametrize("source", [LEARNER, PLAYER], ids=["learn", "greedy"])
def test_ctrl_c_ends_the_method_that_runs_interpreted(source: str, at: int) -> None:
    """It does so at once, not after the other steps of the call: among the first, checked steps, and after them."""
    notebook = cell(source)
    notebook |= {"signal": signal, "calls": []}
    agent: Any = notebook["Agent"](np.zeros((6, 2)), at)
    with pytest.raises(Interrupted) as interrupted:
        train(make_mdp("Boulder", height=5), agent, 100_000, evaluate_every=1_000)
    assert len(notebook["calls"]) == at
    assert not interrupted.value.partial.complete
    assert interrupted.value.partial.agent.Q is agent.Q

"""Observations and actions that are tuples or arrays of real numbers, of agents as students write them."""

from typing import Any

import numpy as np
import pytest

from edugym import make_mdp, train
from tests.compiled.cells import cell
from tests.training.tasks import interpret

SWINGER = """
class Swinger(NamedTuple):
    sums: np.ndarray
    tabular = False

    def act(self, state, rng):
        return 0.5 * rng.random() - 0.25 + 0.1 * state[2], 0.5 * rng.random() - 0.25

    def learn(self, state, action, reward, next_state):
        self.sums[0] += next_state[3] - state[2]
        self.sums[1] += action[0]
        self.sums[2] += action[1]
        self.sums[3] += reward
"""
"""It turns both joints at random, and sums up what it sees, does and gets."""
ARRAY = SWINGER.replace("return 0.5 *", "return np.array([0.5 *").replace("- 0.25\n\n", "- 0.25])\n\n")
ON_POLICY = ARRAY.replace("next_state):", "next_state, next_action):").replace("+= action[1]", "+= next_action[1]")


@pytest.mark.parametrize("source", [SWINGER, ON_POLICY], ids=["tuples", "arrays, on-policy"])
def test_compiled_is_interpreted(source: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tuples and arrays are one, and machine code does what the interpreter does."""
    one, other = (cell(source)["Swinger"](np.zeros(4)) for _ in range(2))
    train(make_mdp("Trashbot"), one, 6_000, seed=2, evaluate_every=3_000)
    interpret(monkeypatch)
    train(make_mdp("Trashbot"), other, 6_000, seed=2, evaluate_every=3_000)
    assert one.sums.tolist() == other.sums.tolist()
    assert one.sums.all()


PUSHER = SWINGER[: SWINGER.index("    def act")] + (
    "    def act(self, state, rng): return (0.5,)\n"
    "    def learn(self, action, reward): self.sums[0] += action[0] + (action == (0.5,))\n"
)


def test_a_gymnasium_environment_gets_arrays() -> None:
    """Of a tuple of numbers, where the environment asks for an array; the agent is told what it did."""
    agents: list[Any] = [cell(source)["Swinger"](np.zeros(4)) for source in (PUSHER, SWINGER)]
    assert train("Pendulum-v1", agents[0], 300).episodes.sum() == 1
    assert agents[0].sums[0] == 300 * 1.5
    train("edugym/Trashbot-v0", agents[1], 50)
    assert agents[1].sums[1:3].all()

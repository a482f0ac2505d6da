"""What an agent is asked and told: its `learn` by the names of its parameters, and which actions it may take."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import train
from tests.compiled.cells import cell
from tests.training.slips import named
from tests.training.tasks import Stairs, interpret

LAST = {"state": 2, "action": 1, "reward": 3.0, "next_state": 3, "next_action": 1}
LAST |= {"terminated": True, "truncated": False}
NOTING = """
class Noting:
    def act(self, state, rng): return int(state == 2)
    greedy = act
    def learn(self, {names}): self.noted = dict({given})
"""


@given(st.permutations(list(LAST)), st.integers(1, 7), st.sampled_from(["", "more=0.5", "**more", "*, more=0.5"]))
@settings(max_examples=60)
def test_any_names_in_any_order(names: list[str], size: int, more: str) -> None:
    """Whatever an agent asks for, it gets that, however it orders it; what has a default is left alone."""
    taken = names[:size]
    given = ", ".join(f"{name}={name}" for name in (*taken, *(["more"] if more else [])))
    agent = cell(NOTING.format(names=", ".join([*taken, *([more] if more else [])]), given=given))["Noting"]()
    train(Stairs(), agent, 3)
    if more:
        assert agent.noted.pop("more") == ({} if more == "**more" else 0.5)
    assert agent.noted == {name: LAST[name] for name in taken}


ACTING = """
class Staying:
    observation_space = spaces.Discrete(2)
    max_steps = 9
    done = None
    def initial(self, rng): return 0
    def transition(self, state, action, rng): self.done = action; return 0
    def reward(self, state, action, next_state, rng): return 0.0
    def terminal(self, state): return False
    def observation(self, state, rng): return 1

class Acting:
    steps, wrong_from = 0, 0
    def act(self, state, rng):
        self.steps += self.steps < self.wrong_from
        return self.right if self.steps < self.wrong_from else self.wrong
    def learn(self, reward): pass

class Greedy(Acting):
    greedy = Acting.act
    def act(self, state, rng): return self.right
"""
Staying, Acting, Greedy = (cell(ACTING)[name] for name in ("Staying", "Acting", "Greedy"))
NAN, INF = float("nan"), float("inf")
ONE, TWO = spaces.Box(-1.0, 1.0, (1,)), spaces.Box(-1.0, 1.0, (2,))
ACTIONS: list[tuple[spaces.Space[Any], list[Any], list[Any], str]] = [
    (
        spaces.Discrete(3),
        [0, 2, np.int8(1), np.array(2)],
        [3, -1, True, np.True_, 1.0, None, [1], np.array([1]), np.array(1.0), "1"],
        "0 to 2",
    ),
    (
        TWO,
        [(0.5, 0), [3.0, -9], np.array([1, 2])],  # an MDP may cut them off at the bounds itself
        [(NAN, 0), (INF, 0.0), (0.5,), 0.5, ("a", "b"), None, ((1, 2), (3,)), (True, False), np.zeros((2, 1))],
        str(TWO),
    ),
    (ONE, [0.5, (0.5,), np.array(1), np.array([[0.5]])], [(0.5, 0.5), (), NAN, "x"], str(ONE)),
    (spaces.MultiDiscrete([2, 3]), [(1, 2), [0, 0]], [(2, 0), (1,), 1], "MultiDiscrete([2 3])"),
]


@pytest.mark.parametrize("late", [0, 250])
@pytest.mark.parametrize(("space", "right", "wrong", "allowed"), ACTIONS, ids=lambda part: str(part)[:20])
def test_which_actions_pass(
    space: Any, right: list[Any], wrong: list[Any], allowed: str, late: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As they are, in the first steps and later, in training and in evaluation; others are named, with the allowed."""
    interpret(monkeypatch)
    task, acting, greedy = Staying(), Acting(), Greedy()
    task.action_space = space
    for agent in (acting, greedy):
        agent.wrong_from = late
        for agent.right in right:
            agent.wrong = agent.right
            train(task, agent, 2, evaluate_every=2)
            assert repr(task.done) == repr(agent.right)
        for agent.wrong in wrong:
            agent.steps = 0
            method = "greedy" if agent is greedy else "act"
            names = f"{method} {type(agent).__name__} {allowed} state"
            error = named(names, lambda: train(task, agent, 300, evaluate_every=9))  # noqa: B023
            assert ("missing" in str(error)) == (agent.wrong is None)


def test_an_action_of_32_bits_gets_64(monkeypatch: pytest.MonkeyPatch) -> None:
    """NumPy counts with 32 bits in a browser; what a state takes of an action is compiled only with 64."""
    interpret(monkeypatch)
    task, agent = Staying(), Acting()
    task.action_space, agent.wrong = spaces.Discrete(2), np.int32(1)
    train(task, agent, 2)
    assert repr(task.done) == repr(np.int64(1))

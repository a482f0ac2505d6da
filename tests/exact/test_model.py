"""The exact model of small tasks, against tables and formulae worked out by hand."""

import traceback
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym.exact.model import finite_model
from tests.compiled.cells import WALK, cell

MOVE, PAY = "return max(0, state + 2 * action - 1)", "return 1.0 if next_state == self.size else -0.25"
START, END = "return 0\n", "return state == self.size"


TABLE = """
class Table(NamedTuple):
    weights: np.ndarray
    rewards: np.ndarray
    way: str
    observation_space = property(lambda self: spaces.Discrete(len(self.weights) + 1))
    action_space = property(lambda self: spaces.Discrete(self.weights.shape[1]))
    def initial(self, rng): return int(rng.integers(len(self.weights)))
    def transition(self, state, action, rng):
        weights = self.weights[state, action]
        total = weights.sum()
        if self.way == "whole number":
            left = rng.integers(total)
        elif self.way == "rounded down":
            left = int(rng.random() * total)
        elif self.way == "uniform":
            left = rng.uniform(0, total)
        else:
            left = rng.random()
            weights, total = weights / total, 1.0
        bound = 0
        for next_state in range(len(weights) - 1):
            bound += weights[next_state]
            if left < bound:
                return next_state
        return len(weights) - 1
    def reward(self, state, action, next_state, rng):
        return float(self.rewards[state, action, next_state]) + rng.normal(0.0, 0.5) + rng.uniform(-1.0, 1.0)
    def terminal(self, state): return state == len(self.weights)
    def observation(self, state, rng): return state
"""
Table: Any = cell(TABLE)["Table"]
"""A task that is given by its tables, shape (S, A, S'), and draws the next state in one of several ways."""


@st.composite
def tables(draw: st.DrawFn) -> Any:
    """Tasks with up to four states, three actions, and an end."""
    n_states, n_actions = draw(st.integers(1, 4)), draw(st.integers(1, 3))
    rng = np.random.default_rng(draw(st.integers(0, 10**6)))
    weights = rng.integers(0, 5, (n_states, n_actions, n_states + 1))
    weights[:, :, draw(st.integers(0, n_states))] += 1  # nowhere to go is no task
    way = draw(st.sampled_from(["chain", "whole number", "rounded down", "uniform"]))
    return Table(weights, rng.integers(-8, 8, weights.shape) / 2, way)


@given(task=tables())
@settings(max_examples=60)
def test_tables_come_back(task: Any) -> None:
    """The model of a task that is made from tables is these tables."""
    model = finite_model(task)
    n = len(task.weights)
    reached = [state for state in range(n + 1) if state in model.rows]
    assert reached[:n] == list(range(n))
    rows = [model.rows[state] for state in reached]
    p = task.weights / task.weights.sum(axis=2, keepdims=True)
    np.testing.assert_allclose(model.p[np.ix_(rows[:n], range(p.shape[1]), rows)], p[:, :, reached], atol=1e-12)
    np.testing.assert_allclose(model.r[rows[:n]], (p * task.rewards).sum(axis=2), atol=1e-12)
    np.testing.assert_allclose(model.initial[rows[:n]], 1 / n, atol=1e-15)
    for state, action in np.ndindex(p.shape[:2]):
        outcomes = {outcome.next_state: outcome for outcome in model.outcomes(state, action)}
        assert set(outcomes) == set(np.flatnonzero(p[state, action]).tolist())
        for next_state, outcome in outcomes.items():
            assert outcome.probability == pytest.approx(p[state, action, next_state], abs=1e-12)
            assert outcome.reward == pytest.approx(task.rewards[state, action, next_state], abs=1e-12)
            assert outcome.terminated == (next_state == n)


@pytest.mark.parametrize(
    ("line", "wrong", "reason"),
    [
        (MOVE, "return state + rng.random()", "cannot hold a continuous random number"),
        (MOVE, "return (state, rng.uniform())", "but there is a continuous random number"),
        (MOVE, "return state + rng.normal()", "cannot follow rng.normal"),
        (MOVE, "return np.zeros(3)", "a state must be a number or a tuple of numbers, but there is array"),
        (MOVE, "return [state]", r"a state must be a number or a tuple of numbers, but there is \[0\]"),
        (MOVE, "state + 1", "transition returns None"),
        (MOVE, "return state + 1 + action * 1000", "it has more than 500 states"),
        (MOVE, "return tuple(rng.random() < 0.5 for _ in range(50))", "it has more than 500 states"),
        (MOVE, "while rng.random() < 0.5: pass\n        return 0", "more than 1000 random choices"),
        (MOVE, "return rng.choice(2, p=[0.7, 0.7])", "[Pp]robabilities do not sum to 1"),
        (MOVE, "return rng.choice(2, p=[1.5, -0.5])", "[Pp]robabilities are not non-negative"),
        (MOVE, "return rng.choice(2, p=[1.0])", "a and p must have same size"),
        (MOVE, "return rng.choice([])", "a cannot be empty"),
        (START, "0\n", "initial returns None: is its `return` missing"),
        (START, "return [0]\n", "a state must be a number or a tuple of numbers, but there is"),
        (START, "return self.size\n", "initial must return a state that is not terminal, but can return 4"),
        (START, "return rng.integers(self.size + 1)\n", "not terminal, but can return 4"),
        (PAY, "1.0", "finite number, but returns None for 0, 0, 0"),
        (PAY, "return math.nan", "reward must return a finite number, but returns nan for 0, 0, 0"),
        (PAY, "return max(0.0, rng.normal())", "can only add normal noise"),
        (END, "state", "must return True or False, but returns None for"),
        ("spaces.Discrete(2)", "spaces.Box(-1, 1, (2,))", "its action space is"),
        ("spaces.Discrete(2)", "spaces.MultiDiscrete([2, 2])", "its action space is"),
    ],
)
def test_tasks_without_a_model(line: str, wrong: str, reason: str) -> None:
    """Tasks that are not finite, and slips, say so by name, and why, with a short traceback."""
    assert line in WALK
    task = cell(WALK.replace(line, wrong, 1))["Walk"](4)
    with pytest.raises(ValueError, match=f"Walk has no finite model: .*{reason}") as caught:
        finite_model(task, max_states=500)
    assert len(frames(caught.value)) <= 3


def frames(error: BaseException) -> list[str]:
    """The lines of the one traceback that is shown."""
    assert error.__cause__ is None
    assert error.__context__ is None or error.__suppress_context__
    return [str(frame.line) for frame in traceback.extract_tb(error.__traceback__)]


@pytest.mark.parametrize(
    ("line", "kind"), [("math.sqrt(-1)", ValueError), ("rng.normal()", ValueError), ("stat", NameError)]
)
def test_where_a_slip_is(line: str, kind: type[Exception]) -> None:
    """The traceback is one, with one line of the package, and ends at the student's line."""
    with pytest.raises(kind) as caught:
        finite_model(cell(WALK.replace("max(0, ", f"max({line}, ", 1))["Walk"](4))
    shown = frames(caught.value)
    assert len(shown) <= 3
    assert line in shown[-1]


def test_where_it_gives_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """The number of states is a parameter; ways and the size of the tables have limits of their own."""
    walk = cell(WALK)["Walk"](40)
    assert len(finite_model(walk, max_states=41).states) == 41
    for limit, says in (
        (40, r"has more than 40 states \(max_states can be raised"),
        (0, "max_states .*from 1 to 100000000"),
    ):
        with pytest.raises(ValueError, match=says):
            finite_model(walk, max_states=limit)
    many = WALK.replace(MOVE, "return (rng.integers(30), rng.integers(2))[0] if action else state + 1")
    monkeypatch.setattr("edugym.exact.model.MAX_ENTRIES", 2459)
    with pytest.raises(ValueError, match="its tables would have 2460 entries, and 2459 is the limit"):
        finite_model(cell(many)["Walk"](40))
    monkeypatch.setattr("edugym.exact.model.MAX_ENTRIES", 2460)
    assert finite_model(cell(many)["Walk"](40)).successors.shape == (41, 2, 30)
    tossed = WALK.replace(MOVE, "return rng.integers(256) * 0 + state + 1")
    coins = cell(tossed)["Walk"](400)
    with pytest.raises(ValueError, match=r"its steps can go too many ways in all \(a larger max_states allows more\)"):
        finite_model(coins, max_states=500)
    monkeypatch.setattr("edugym.exact.model.MAX_WAYS", 255)
    with pytest.raises(ValueError, match="one step can go more than 255 ways"):
        finite_model(coins)

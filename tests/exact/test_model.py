"""The exact model of small tasks, against tables and formulae worked out by hand."""

import math
import traceback
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.exact.model import finite_model
from edugym.mdp.protocol import Integers, Random, Reals
from tests.compiled.cells import SLIPPERY, WALK, cell


class Table(NamedTuple):
    """A task that is given by its tables, and draws the next state in one of several ways.

    Attributes:
        weights: shape (S, A, S): p(s'|s, a) in parts of their sum.
        rewards: shape (S, A, S): r(s, a, s').
        way: how the next state is drawn.
    """

    weights: Integers
    rewards: Reals
    way: str

    @property
    def observation_space(self) -> spaces.Discrete:
        """The states, and an end."""
        return spaces.Discrete(len(self.weights) + 1)

    @property
    def action_space(self) -> spaces.Discrete:
        """The actions."""
        return spaces.Discrete(self.weights.shape[1])

    def initial(self, rng: Random) -> int:
        """Any state but the end."""
        return int(rng.integers(len(self.weights)))

    def transition(self, state: int, action: int, rng: Random) -> int:
        """By the weights; the last state is the end."""
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

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """By the table, with noise of mean 0."""
        reward: float = self.rewards[state, action, next_state] + rng.normal(0.0, 0.5) + rng.uniform(-1.0, 1.0)
        return reward

    def terminal(self, state: int) -> bool:
        """The last state."""
        return state == len(self.weights)

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state


@st.composite
def tables(draw: st.DrawFn) -> Table:
    """Tasks with up to four states, three actions, and an end."""
    n_states, n_actions = draw(st.integers(1, 4)), draw(st.integers(1, 3))
    rng = np.random.default_rng(draw(st.integers(0, 10**6)))
    weights = rng.integers(0, 5, (n_states, n_actions, n_states + 1))
    weights[:, :, draw(st.integers(0, n_states))] += 1  # nowhere to go is no task
    way = draw(st.sampled_from(["chain", "whole number", "rounded down", "uniform"]))
    return Table(weights, rng.integers(-8, 8, weights.shape) / 2, way)


@given(task=tables())
@settings(max_examples=60)
def test_tables_come_back(task: Table) -> None:
    """The model of a task that is made from tables is these tables."""
    model = finite_model(task)
    n = len(task.weights)
    order = [model.rows[state] for state in range(n + 1) if state in model.rows]
    assert len(order) >= n
    p = task.weights / task.weights.sum(axis=2, keepdims=True)
    expected = (p * task.rewards).sum(axis=2)
    reachable = range(n + 1) if len(order) == n + 1 else range(n)
    np.testing.assert_allclose(
        model.p[np.ix_(order[:n], range(p.shape[1]), order)], p[:, :, list(reachable)], atol=1e-12
    )
    np.testing.assert_allclose(model.r[order[:n]], expected, atol=1e-12)
    np.testing.assert_allclose(model.initial[order[:n]], 1 / n, atol=1e-15)
    for state in range(n):
        for action in range(p.shape[1]):
            outcomes = {outcome.next_state: outcome for outcome in model.outcomes(state, action)}
            assert set(outcomes) == set(np.flatnonzero(p[state, action]).tolist())
            for next_state, outcome in outcomes.items():
                assert outcome.probability == pytest.approx(p[state, action, next_state], abs=1e-12)
                assert outcome.reward == pytest.approx(task.rewards[state, action, next_state], abs=1e-12)
                assert outcome.terminated == (next_state == n)


def solved(model: Any, policy: int) -> Any:
    """The values of always the same action, from the linear equations V = r + p V."""
    p, r = model.p[:, policy], model.r[:, policy]
    going = ~model.terminal
    values = np.zeros(len(model.states))
    values[going] = np.linalg.solve(np.eye(going.sum()) - p[np.ix_(going, going)], r[going])
    return values


@pytest.mark.parametrize("size", [1, 2, 7])
@pytest.mark.parametrize("slip", [0.0, 0.1, 0.25, 0.5, 0.75])
def test_slippery_walk(size: int, slip: float) -> None:
    """A student's stochastic task: going right needs as many steps on average as the formula of the random walk says.

    With t_k the mean time from k to k + 1 (staying at 0 where a step back leads nowhere), t_0 = 1/p and
    t_k = 1/p + (q/p) t_(k-1).
    """
    task = cell(SLIPPERY)["SlipperyWalk"](size, slip)
    times = [1 / (1 - slip)]
    for _ in range(size - 1):
        times.append(1 / (1 - slip) + slip / (1 - slip) * times[-1])
    model = finite_model(task)
    assert len(model.states) == size + 1
    value = solved(model, policy=1)[model.row(0)]
    assert value == pytest.approx(1 - 0.25 * (sum(times) - 1), rel=1e-9)
    if slip not in (0.0, 0.5):
        p, q = 1 - slip, slip
        closed = (size - (q / p) * (1 - (q / p) ** size) / (1 - q / p)) / (p - q)
        assert sum(times) == pytest.approx(closed, rel=1e-9)


CHANGED = WALK.replace("return max(0, state + 2 * action - 1)", "{}")

NOT_FINITE = {
    "continuous": ("return state + rng.random()", "cannot hold a continuous random number"),
    "continuous in a tuple": ("return (state, rng.uniform())", "but there is a continuous random number"),
    "normal": ("return state + rng.normal()", "cannot follow rng.normal"),
    "array": ("return np.zeros(3)", "a state must be a number or a tuple of numbers, but there is array"),
    "text": ("return 'left'", "a state must be a number or a tuple of numbers, but there is 'left'"),
    "too many": ("return state + 1 + action * 1000", "it has more than 500 states"),
    "too many at once": ("return tuple(rng.random() < 0.5 for _ in range(50))", "it has more than 500 states"),
    "endless": ("while rng.random() < 0.5: pass\n        return 0", "more than 1000 random choices"),
}


@pytest.mark.parametrize(("transition", "reason"), NOT_FINITE.values(), ids=NOT_FINITE)
def test_what_is_not_finite(transition: str, reason: str) -> None:
    """Tasks without a finite model say so by name, and why."""
    task = cell(CHANGED.replace("{}", transition).replace("== self.size", "== -1"))["Walk"](4)
    with pytest.raises(ValueError, match=f"Walk has no finite model: .*{reason}"):
        finite_model(task, max_states=500)


@pytest.mark.parametrize("space", ["spaces.Box(-1, 1, (2,))", "spaces.MultiDiscrete([2, 2])", "spaces.MultiBinary(2)"])
def test_actions_without_a_model(space: str) -> None:
    """Only whole numbers as actions have a table."""
    task = cell(WALK.replace("spaces.Discrete(2)", space))["Walk"](4)
    with pytest.raises(ValueError, match="Walk has no finite model: its action space is"):
        finite_model(task)


def test_rewards_that_cannot_be_followed() -> None:
    """Noise that is not only added has no mean that could stand for it."""
    source = WALK.replace("return 1.0 if next_state == self.size else -0.25", "return max(0.0, rng.normal())")
    with pytest.raises(ValueError, match=r"Walk has no finite model: .* can only add normal noise"):
        finite_model(cell(source)["Walk"](4))


def test_where_it_gives_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """The number of states is a parameter; ways and the size of the tables have limits of their own."""
    walk = cell(WALK)["Walk"](40)
    assert len(finite_model(walk, max_states=41).states) == 41
    with pytest.raises(ValueError, match=r"it has more than 40 states \(max_states can be raised\)"):
        finite_model(walk, max_states=40)
    many = CHANGED.replace("{}", "return (rng.integers(30), rng.integers(30))[0] if action else state + 1")
    monkeypatch.setattr("edugym.exact.model.MAX_ENTRIES", 1000)
    with pytest.raises(ValueError, match="its tables would have 2460 entries, and 1000 is the limit"):
        finite_model(cell(many)["Walk"](40))
    monkeypatch.setattr("edugym.exact.model.MAX_ENTRIES", 10_000)
    assert finite_model(cell(many)["Walk"](40)).successors.shape == (41, 2, 30)
    coins = cell(CHANGED.replace("{}", "return sum(rng.random() < 0.5 for _ in range(8)) * 0 + state + 1"))["Walk"](400)
    with pytest.raises(ValueError, match=r"its steps can go too many ways in all \(a larger max_states allows more\)"):
        finite_model(coins, max_states=500)
    monkeypatch.setattr("edugym.exact.model.MAX_WAYS", 255)
    with pytest.raises(ValueError, match="one step can go more than 255 ways"):
        finite_model(coins)


@pytest.mark.parametrize("wrong", [-1, 0, 2.5, None, math.inf, True])
def test_bad_limits(wrong: Any) -> None:
    """How many states to look at is a whole number."""
    with pytest.raises(ValueError, match=r"max_states must be .*1 or more, but is"):
        finite_model(cell(WALK)["Walk"](4), max_states=wrong)


def test_what_is_no_task() -> None:
    """An environment, a class, a name: the message says what to pass."""
    wrong: Any
    for wrong in (MDPEnv(cell(WALK)["Walk"](4)), gymnasium.make("CliffWalking-v1")):
        with pytest.raises(ValueError, match=r"mdp must be an MDP, .* but is <.*env\.unwrapped\.mdp"):
            finite_model(wrong)
    wrong = cell(WALK)["Walk"]
    with pytest.raises(ValueError, match=r"mdp must be a value, but is the class Walk: make one with Walk\(\.\.\.\)"):
        finite_model(wrong)
    for wrong in ("Boulder", None, 3):
        with pytest.raises(ValueError, match=rf"mdp must be an MDP, .*but is .*{wrong!r}"):
            finite_model(wrong)
    wrong = cell(WALK.replace("def terminal", "def terminl"))["Walk"](4)
    with pytest.raises(ValueError, match=r"Walk must have a method terminal\(self, state\)"):
        finite_model(wrong)


SLIPS = {
    "transition without return": ("return max(0, state + 2 * action - 1)", "state + 1", "transition returns None"),
    "initial without return": ("return 0\n", "0\n", "initial returns None: is its `return` missing"),
    "a list": ("return max(0, state + 2 * action - 1)", "return [state]", r"but there is \[0\]"),
    "reward without return": (
        "return 1.0 if next_state",
        "1.0 if next_state",
        "finite number, but returns None for 0, 0, 0",
    ),
    "reward that is no number": (
        "-0.25",
        "math.nan",
        "reward must return a finite number, but returns nan for 0, 0, 0",
    ),
    "terminal without return": (
        "return state == self.size",
        "state",
        "must return True or False, but returns None for",
    ),
    "a choice of bad sum": ("max(0, ", "max(0, rng.choice(2, p=[0.7, 0.7]) * ", "[Pp]robabilities do not sum to 1"),
    "a negative choice": ("max(0, ", "max(0, rng.choice(2, p=[1.5, -0.5]) * ", "[Pp]robabilities are not non-negative"),
    "a choice of another length": ("max(0, ", "max(0, rng.choice(2, p=[1.0]) * ", "a and p must have same size"),
    "a choice of nothing": ("max(0, ", "max(0, rng.choice([]) * ", "a cannot be empty"),
}


@pytest.mark.parametrize(("line", "slip", "reason"), SLIPS.values(), ids=SLIPS)
def test_slips(line: str, slip: str, reason: str) -> None:
    """One sentence says which method is wrong, and how."""
    assert line in WALK
    with pytest.raises(ValueError, match=f"Walk has no finite model: .*{reason}") as caught:
        finite_model(cell(WALK.replace(line, slip, 1))["Walk"](4))
    assert len(frames(caught.value)) <= 3


def frames(error: BaseException) -> list[str]:
    """The lines of the one traceback that is shown."""
    assert error.__cause__ is None
    assert error.__context__ is None or error.__suppress_context__
    return [str(frame.line) for frame in traceback.extract_tb(error.__traceback__)]


def test_where_a_slip_is() -> None:
    """The traceback is one, with one line of the package, and ends at the student's line where there is one."""
    for line, kind in (("math.sqrt(-1)", ValueError), ("rng.normal()", ValueError), ("stat", NameError)):
        with pytest.raises(kind) as caught:
            finite_model(cell(WALK.replace("max(0, ", f"max({line}, ", 1))["Walk"](4))
        shown = frames(caught.value)
        assert len(shown) <= 3, shown
        assert line in shown[-1]
    with pytest.raises(ValueError, match="a state must be a number or a tuple of numbers, but there is") as caught:
        finite_model(cell(WALK.replace("return 0\n", "return [0]\n", 1))["Walk"](4))
    assert len(frames(caught.value)) == 2

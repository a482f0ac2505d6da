"""Slips that show after the first steps: machine code and the interpreter answer them with the same sentence."""

from typing import Any

import numpy as np
import pytest

from edugym import QLearning, train
from tests.compiled.cells import LEARNER, WALK, cell
from tests.training.slips import ACTS, ENVIRONMENT, MOVE, PAY, SEE, STEP, VALUE, answered, changed, looker, named, walk
from tests.training.tasks import interpret

pytestmark = pytest.mark.usefixtures("compiled_at_once")

COUNTED = f"self.count[0] += 1\n        {MOVE}"


def late(**returned: str) -> str:
    """Lines that return something else after 3 000 steps, each in a task with its own number."""
    return "".join(f"if self.late({k[1:]}):\n            return {value}\n        " for k, value in returned.items())


FIELDS = "size: int\n    wrong: int\n    count: np.ndarray\n    low: float = 0.0\n    high: float = 9.0\n\n"
COUNTING = WALK.replace(
    "size: int\n", f"{FIELDS}    def late(self, k): return self.wrong == k and self.count[0] > 3_000\n"
).replace(MOVE, COUNTED)
LATE_WALK = COUNTING.replace(PAY, late(_1="np.nan", _2="np.inf") + PAY).replace(SEE, late(_3="-1", _4="6") + SEE)
ENDS = "return state == self.size"
LATE_WALK = changed(LATE_WALK, ENDS, late(_10="None") + ENDS)
LATE_WALK = changed(LATE_WALK, "return 0\n", late(_11="self.size") + "return 0\n")
"""The walk with a slip, number `wrong`, that shows after 3 000 steps."""


def boxes(right: str, shape: str, **wrong: str) -> Any:
    """The same with vectors to see."""
    source = COUNTING.replace(SEE, f"{late(**wrong)}return {right}\n")
    return cell(source.replace("Discrete(self.size + 1)", f"Box(self.low, self.high, {shape})"))["Walk"]


NUMBERS = cell(changed(LATE_WALK, "state + 2 * action - 1", "min(self.size, state + 2 * action - 1)"))["Walk"]
"""The same, where a step from the end leads nowhere that its space does not have."""
BOXES = boxes(
    "np.array([0.1, 0.1])", "(2,)",
    _5="np.array([9.1, 1.0])", _6="np.array([1.0, -0.1])", _7="np.array([0.1, np.nan])",
)  # fmt: skip
LATE = {
    "NaN for a reward": (NUMBERS, 1, "reward Walk nan"),
    "an infinite reward": (NUMBERS, 2, "reward Walk inf"),
    "nothing for whether it ends": (NUMBERS, 10, "terminal Walk None"),
    "over at the start": (NUMBERS, 11, "initial Walk not terminal 5"),
    "below the space": (NUMBERS, 3, "observation Walk Discrete(6) -1"),
    "beyond the space": (NUMBERS, 4, "observation Walk Discrete(6) 6"),
    "above the box": (BOXES, 5, "observation Walk Box( 9.1"),
    "below the box": (BOXES, 6, "observation Walk Box( -0.1"),
    "NaN to see": (BOXES, 7, "observation Walk Box( nan"),
    "of a tuple": (boxes("(state, 1.0)", "(2,)", _8="(state, 9.5)"), 8, "observation Walk Box( 9.5"),
    "of many": (boxes("np.full(40, 1.0)", "(40,)", _9="np.full(40, 9.5)"), 9, "observation Walk Box( 9.5"),
}
either_way = pytest.mark.parametrize("machine_code", [True, False], ids=["machine code", "interpreted"])


@either_way
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(
            name, marks=[pytest.mark.slow] * (name in ("above the box", "below the box", "of a tuple", "of many"))
        )
        for name in LATE
    ],
)
def test_late_slips_in_an_mdp(name: str, machine_code: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is returned is named, and the state."""
    if not machine_code:
        interpret(monkeypatch)
    kind, wrong, names = LATE[name]
    agent: Any = QLearning.create((6, 2)) if kind is NUMBERS else LOOKER
    answered(names, lambda: train(kind(5, wrong, np.zeros(1, np.int64)), agent, 9_000, max_steps=99))


LOOKER = looker()


@pytest.mark.parametrize(
    ("low", "high"), [(0.1, 0.1), (-np.inf, np.inf), (0.0, np.inf), (0.0, float(np.finfo("f").max))]
)
def test_bounds_are_those_of_the_type_of_the_space(low: float, high: float) -> None:
    """0.1 is less than 0.1 in a space of float32, and is no slip; without bounds there is nothing to say either."""
    assert train(BOXES(5, 0, np.zeros(1, np.int64), low, high), LOOKER, 6_000, max_steps=9).complete


@pytest.mark.parametrize("late", [0, 1], ids=["training", "evaluation"])
def test_a_late_next_state_that_is_missing(late: int) -> None:
    """It is named before the reward, which computes with it, fails; in training and in evaluation."""
    lost = f"if self.late(8) and action == 1:\n            return None\n        {COUNTED}"
    source = changed(changed(LATE_WALK, COUNTED, lost), PAY, "return 0.5 * next_state")
    agent = QLearning(np.zeros((6, 2)), learning_rate=1e-300)
    agent.Q[:, late] = 1e300  # it goes right only as it is trained (and explores), or only as it is evaluated
    task = cell(source)["Walk"](5, 8, np.zeros(1, np.int64))
    answered("transition Walk None", lambda: train(task, agent, 9_000, max_steps=9, evaluate_every=90))


LATE_LEARNER = (
    LEARNER.replace("rate: float", "wrong: int\n    count: np.ndarray\n    rate: float")
    .replace(ACTS, f"def late(self): return self.wrong == 0 and self.count[0] > 2_000\n    {ACTS}")
    .replace(f"{ACTS}\n", f"{ACTS}\n        self.count[0] += 1\n        if self.count[0] > 2_000: return self.wrong\n")
    .replace(
        "    def learn", "    def greedy(self, state, rng):\n        return 2 if self.late() else 1\n    def learn"
    )
)
NONE = LATE_LEARNER.replace("return self.wrong", "return None")
ON_POLICY = LATE_LEARNER.replace("next_state, terminated)", "next_state, next_action, terminated)")
KINDS = {"Learner": cell(LATE_LEARNER)["Learner"], "None": cell(NONE)["Learner"], "SARSA": cell(ON_POLICY)["Learner"]}


@pytest.mark.parametrize(
    ("kind", "where", "wrong"),
    [
        ("Learner", "machine code", 2),
        ("Learner", "machine code", -1),  # which is not the last one
        pytest.param("None", "machine code", None, marks=pytest.mark.slow),
        *((kind, where, 2) for kind in ("Learner", "SARSA") for where in ("interpreted", "Gymnasium")),
        *(("None", where, None) for where in ("interpreted", "Gymnasium")),
    ],
)
def test_late_actions(kind: str, where: str, wrong: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """They are named, with the state."""
    if where != "machine code":
        interpret(monkeypatch)
    task = cell(ENVIRONMENT)["Line"]() if where == "Gymnasium" else walk()
    agent = KINDS[kind](np.zeros((6, 2)), 1 if wrong is None else wrong, np.zeros(1, np.int64))
    answered(f"act Learner 0 1 {wrong!r} state", lambda: train(task, agent, 9_000, max_steps=50))


@either_way
def test_late_actions_in_evaluation(machine_code: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """The method by which the agent is evaluated is named."""
    if not machine_code:
        interpret(monkeypatch)
    agent = KINDS["Learner"](np.zeros((6, 2)), 0, np.zeros(1, np.int64))
    named("greedy Learner 2 state", lambda: train(walk(), agent, 6_000, evaluate_every=300, evaluation_episodes=40))


BOARD = """
class Board(NamedTuple):
    wrong: bool
    count: np.ndarray
    observation_space = spaces.Box(0, 9, (2, 2), np.float64)
    action_space = spaces.Discrete(2)
    def initial(self, rng): return 0
    def transition(self, state, action, rng):
        self.count[0] += 1
        return state + action
    def reward(self, state, action, next_state, rng):
        return np.nan if self.wrong and self.count[0] > 3_000 else 1.0
    def terminal(self, state): return state == 9
    def observation(self, state, rng): return np.full((2, 2), float(state))
    def observe_into(self, state, rng, out): out[:] = float(state)

class Summing(NamedTuple):
    sums: np.ndarray
    most: float = 1e9
    tabular = False
    n_inputs = 4
    def act(self, state, rng): return 2 if self.sums[0] > self.most else int(rng.random() * 2)
    def learn(self, state, action, reward, next_state):
        self.sums[0] += state[0] + 3 * next_state[3]
"""


def test_a_board_that_is_written_in_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is guarded as others are, and machine code does what the interpreter does."""
    Board, Summing = map(cell(BOARD).__getitem__, ("Board", "Summing"))
    right, wrong = (Board(is_wrong, np.zeros(1)) for is_wrong in (False, True))
    named("reward Board nan", lambda: train(wrong, Summing(np.zeros(1)), 6_000, max_steps=9))
    named("act Summing 0 1 2", lambda: train(right, Summing(np.zeros(1), 9_000.0), 6_000, max_steps=9))
    one, other = agents = [Summing(np.zeros(1)) for _ in range(2)]
    for agent in agents:
        train(right, agent, 6_000, max_steps=9)
        interpret(monkeypatch)
    assert one.sums.tolist() == other.sums.tolist()


def test_a_late_reward_of_a_gymnasium_environment() -> None:
    """It is checked at every step, and so is how much comes, and whether it ends."""
    for late, names in (
        ("self.place, np.nan, False, False, {}", "reward nan"),
        ("self.place, 0.0, None, False, {}", "terminated None"),
        ("self.place, 0.0, False, 'no', {}", "truncated no"),
        ("(0, 0.0)", "(observation, (0, 0.0)"),
    ):
        wrong = (
            f"self.steps = vars(self).get('steps', 0) + 1\n        if self.steps > 3_000:\n            return {late}\n"
        )
        env = cell(changed(ENVIRONMENT, STEP, f"{wrong}        {STEP}"))["Line"]()
        answered(f"step Line {names}", lambda: train(env, QLearning.create((6, 2)), 4_000))  # noqa: B023


@pytest.mark.parametrize("n_steps", [300, 6_000])
def test_nothing_happens_twice(n_steps: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """A task that counts its steps in a global list, and an agent that counts what it learns."""
    interpret(monkeypatch)
    scope = cell(changed(LEARNER, VALUE, f"learned.append(state); {VALUE}"))
    cell(changed(WALK, MOVE, f"seen.append(state); {MOVE}"), scope)
    scope["seen"], scope["learned"] = [], []
    run = train(scope["Walk"](5), scope["Learner"](np.zeros((6, 2))), n_steps, evaluate_every=n_steps, max_steps=7)
    assert len(scope["learned"]) == n_steps
    evaluation_steps = sum(7 if total <= -7 / 4 else round((1 - total) * 4) + 1 for total in run.returns)
    assert len(scope["seen"]) == n_steps + evaluation_steps

"""Answers that are right but for one place: each check looks there, so that none of its cases can be left out."""

import inspect
from collections.abc import Callable
from contextlib import nullcontext
from functools import wraps
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import WrongAnswer
from edugym_course.grading.updates import Update
from tests.course.lessons.answers import solution

Wrong = Callable[..., Any]
"""What an answer gives in a wrong place: a function of the right answer, or method, and of its arguments."""


class Task(NamedTuple):
    """An exercise of a lesson, and what its answer is called."""

    lesson: str
    number: int
    name: str

    def check(self, answer: Any) -> str:
        """Check an answer."""
        exercises = import_module(f"edugym_course.lessons.{self.lesson.partition('_')[2]}.exercises")
        return str(getattr(exercises, f"exercise_{self.number}")(answer, 0))

    @property
    def right(self) -> Any:
        """What the lesson's solution defines."""
        return solution(*self)


RETURN = Task("00_loop", 1, "discounted_return")
CHOOSE = Task("00_loop", 2, "choose")
LOOP = Task("00_loop", 3, "MyAgent")
OPTIMIST = Task("01_exploration", 2, "optimist")
EXPLORER = Task("01_exploration", 3, "MyExplorer")
SWITCH = Task("02_on_off_policy", 2, "switch")
TWO_POLICIES = Task("02_on_off_policy", 3, "TwoPolicies")
RATIO = Task("03_depth", 2, "importance_ratio")
DEEP = Task("03_depth", 3, "MyAgent")
ENTRIES = Task("04_dimensionality", 1, "table_entries")
LINEAR = Task("04_dimensionality", 2, "MyAgent")
BITS = Task("06_signal", 2, "bits_in")
LISTENER = Task("06_signal", 3, "Listener")
PREFERENCES = Task("07_continuous_actions", 1, "preferences")
SCORES = Task("07_continuous_actions", 2, "my_scores")
REINFORCE = Task("07_continuous_actions", 3, "MyREINFORCE")
FRONTIER = Task("08_stochasticity", 2, "frontier")
TWO_WEIGHTS = Task("08_stochasticity", 3, "TwoWeights")
DYNA = Task("09_model_based", 2, "DynaPlus")
R_MAX = Task("09_model_based", 3, "MyRMax")
SHAPED = Task("10_own_problem", 2, "shaped_reward")
MORNING = Task("10_own_problem", 3, "UsedToIt")


def wrong_in(where: str, right: Callable[..., Any], wrong: Wrong) -> Callable[..., Any]:
    """Return a function that is right but where an expression of its arguments is true."""
    parameters = inspect.signature(right)

    @wraps(right)
    def answer(*arguments: Any, **named: Any) -> Any:
        if eval(where, {"np": np, "tie": tie, **parameters.bind(*arguments, **named).arguments}):
            return wrong(right, *arguments, **named)
        return right(*arguments, **named)

    return answer


def tie(values: Any) -> bool:
    """Whether two actions are the best."""
    return bool((values == values.max()).sum() == 2)


def another(right: Any, *arguments: Any) -> Any:
    """A wrong number, also where the right one is 0 or has hundreds of digits."""
    return 2 * right(*arguments) + 1


def smallest(right: Any, values: Any, *arguments: Any) -> int:
    """The action with the smallest value."""
    return int(values.argmin())


def first_more(right: Any, *arguments: Any) -> Any:
    """A pair whose first part is wrong."""
    first, second = right(*arguments)
    return first + 1, second


def second_more(right: Any, *arguments: Any) -> Any:
    """A pair whose second part is wrong."""
    first, second = right(*arguments)
    return first, second + 1


TIMES = "state[0] == 0; state[0] == 4; state[0] == 7; state[0] == 8"
SCORED = (
    "np.ndim(a); np.ndim(a) == 0 and sigma < 0.75; np.ndim(a) == 0 and sigma == 2; np.ndim(a) == 0 and 0.7 < sigma < 2"
)
PLACES: list[tuple[Task, Wrong, str]] = [
    (RETURN, another, "discount == 0; discount == 1; len(rewards) == 1; len(rewards) >= 4"),
    (CHOOSE, smallest, "epsilon == 1; len(values) == 3 and epsilon > 0; len(values) == 5"),
    (CHOOSE, smallest, "0 < epsilon < 1 and tie(values); 0 < epsilon < 1 and not tie(values)"),
    (CHOOSE, smallest, "epsilon == 0 and values.max() < 0 and tie(values); epsilon == 0 and not values.any()"),
    (CHOOSE, smallest, "epsilon == 0 and values.max() < 0 and not tie(values)"),
    (CHOOSE, smallest, "epsilon == 0 and values.max() > 0 and tie(values)"),
    (CHOOSE, smallest, "epsilon == 0 and values.argmax() == 0 and values[0] > 0"),
    (OPTIMIST, lambda right, wall: QLearning.create(wall), "wall.action_space.n == 2; wall.action_space.n == 3"),
    (
        SWITCH,
        another,
        "-200 <= model.rewards.min() <= -100; -90 <= model.rewards.min() <= -60; model.rewards.min() >= -59.5",
    ),
    (RATIO, another, "greedy == [True]; greedy == [False]; epsilon == 0; epsilon == 1; False in greedy[1:-1]"),
    (
        RATIO,
        another,
        "len(greedy) > 1 and not greedy[0]; len(greedy) > 1 and not greedy[-1]; len(greedy) > 3 and all(greedy)",
    ),
    (ENTRIES, another, "kind == 'vectorised'; kind == 'grid'; kind == 'rgb'"),
    (ENTRIES, another, "rows == columns; rows == 5 and columns == 2; columns == 4"),
    (BITS, another, "joint.shape == (2, 2); joint.shape == (2, 3); joint.shape == (3, 2); joint.shape == (4, 4)"),
    (BITS, another, "not joint[0, 0]; joint.shape == (2, 2) and {*(16 * joint.ravel())} != {6, 2, 1, 7}"),
    (PREFERENCES, another, "joints == 1; joints == 2; joints == 3; joints == 4"),
    (SCORES, first_more, SCORED),
    (SCORES, second_more, SCORED),
    (FRONTIER, lambda right, players: [*players], "len(players) == 9; len(players) == 10; len(players) == 11"),
    (SHAPED, another, "terminated; not terminated"),
]
"""Where each answer is wrong: expressions of its arguments, of which one is true at a time."""


LONG = {SWITCH, TWO_POLICIES, TWO_WEIGHTS, REINFORCE}
"""The tasks whose checks take a second or more."""


def rows(table: list[Any]) -> list[Any]:
    """Return a row for each place."""
    return [
        pytest.param(*row, where, id=f"{row[0].lesson}-{where}", marks=[pytest.mark.slow] * (row[0] in LONG))
        for *row, places in table
        for where in places.split("; ")
    ]


@pytest.mark.parametrize(("task", "wrong", "where"), rows(PLACES))
def test_a_function_that_is_wrong_in_one_place(task: Task, wrong: Wrong, where: str) -> None:
    """It is refused."""
    with pytest.raises(WrongAnswer):
        task.check(wrong_in(where, task.right, wrong))


def changed(task: Task, method: str, wrong: Wrong, where: str = "True") -> type:
    """Return the solution's class with a method that does something else in some places."""
    other = wrong_in(where, getattr(task.right, method), wrong)
    return type(task.name, (task.right,), {"__slots__": (), method: other})


def nothing(original: Any, *arguments: Any, **named: Any) -> None:
    """Do nothing."""


def one_more(original: Any, *arguments: Any) -> Any:
    """Return one more."""
    return original(*arguments) + 1


def the_next_need(original: Any, self: Any, *arguments: Any) -> int:
    """Choose the next action, and remember it."""
    self.last[0] = (original(self, *arguments) + 1) % 4
    return int(self.last[0])


def deeper(original: Any, self: Any, state: Any, *arguments: Any) -> Any:
    """Sleep more deeply than before."""
    return state[0], (state[1] + 1) % 3, state[2]


def forget(original: Any, self: Any, **now: Any) -> None:
    """Learn nothing from the episode, but begin the next one."""
    before = self.preferences.copy(), self.V.copy()
    original(self, **now)
    self.preferences[:], self.V[:] = before


STEPS = "terminated; state == next_state; reward == 0; self.Q[next_state].max() < 0"
STEPS += "; self.Q.shape[1] == 2; self.Q.shape[1] == 3"
IMAGINED = [
    "self.ends[s, a] == 1",
    "self.last[s, a] > 0 and self.rewards[s, a] == 0 and self.next_states[s, a] > 0",
    "self.last[s, a] > 0 and self.next_states[s, a] == 0",
    "self.rewards[s, a] != 0 and self.ends[s, a] == 0",
    "self.last[s, a] == 0 and self.last[s].any()",
    "not self.last[s].any()",
]
HEARD = [*(f"self.last[0] == {n - 1}" for n in range(5)), *(f"len(observation) == {n}" for n in (2, 4, 5, 6, 7))]
SLEEP = [f"(*state[1:], action) == {(depth, chimes, act)}" for depth, chimes, act in np.ndindex(3, 3, 3)]
METHODS: list[tuple[Task, str, Wrong, str]] = [
    *((task, "learn", nothing, STEPS) for task in (LOOP, EXPLORER, TWO_POLICIES, TWO_WEIGHTS)),
    *((task, "learn", nothing, "self.Q.shape[1] == 4") for task in (LOOP, TWO_POLICIES, TWO_WEIGHTS)),
    # Episodes of one step, of five steps, and those after a longer one.
    (DEEP, "hand_back", nothing, "self.length[0] == 1; self.length[0] == 5; self.rewards[int(self.length[0])]"),
    (DYNA, "imagine", one_more, "; ".join(IMAGINED)),
    (LISTENER, "act", the_next_need, "; ".join([*HEARD, "max(observation[1:]) > 3", "not any(observation[1:])"])),
    # Episodes of one step, of four, those that are cut off or end, and those that come back.
    (REINFORCE, "learn", forget, "self.length[0] == 0; self.length[0] == 3"),
    (REINFORCE, "learn", forget, "self.length[0] > 0 and truncated; self.length[0] > 0 and not truncated"),
    (REINFORCE, "learn", forget, "len({*self.states[: self.length[0]].tolist(), state}) <= self.length[0]"),
    (MORNING, "transition", deeper, "; ".join(SLEEP)),
    (MORNING, "reward", one_more, "state[0] == 0; state[0] == 4; state[0] == 7; next_state[0] == 8 and next_state[1]"),
    (MORNING, "reward", one_more, "action == 2; state[1:] == (2, 2)"),
    (MORNING, "terminal", lambda right, *now: not right(*now), TIMES),
    (MORNING, "observation", lambda right, self, state, rng: (state[0], 3, 3), TIMES),
]


@pytest.mark.parametrize(("task", "method", "wrong", "where"), rows(METHODS))
def test_a_method_that_is_wrong_in_one_place(
    task: Task, method: str, wrong: Wrong, where: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is refused; the usual mistakes are not looked up, which would take time."""
    monkeypatch.setattr(Update, "_diagnosis", lambda *arguments: "")
    with pytest.raises(WrongAnswer):
        task.check(changed(task, method, wrong, where))


LEARNED = [(task, "learn", "Q") for task in (LOOP, EXPLORER, TWO_POLICIES, TWO_WEIGHTS)]
LEARNED += [(LINEAR, "learn", "w"), (REINFORCE, "learn", "preferences"), (REINFORCE, "learn", "V")]
LEARNED += [(DEEP, "hand_back", "Q")]  # its `learn` also stores steps, and an error in between would break ties


@pytest.mark.parametrize(
    ("task", "method", "table"),
    [pytest.param(*row, marks=[pytest.mark.slow] * (row[0] in LONG)) for row in LEARNED],
)
@pytest.mark.parametrize(("error", "accepted"), [(1e-12, True), (1e-7, False)])
def test_how_far_tables_may_be(task: Task, method: str, table: str, error: float, accepted: bool) -> None:
    """As far as rounding takes them."""

    def off(original: Any, self: Any, *arguments: Any, **named: Any) -> None:
        original(self, *arguments, **named)
        getattr(self, table)[...] *= 1 + error

    with nullcontext() if accepted else pytest.raises(WrongAnswer):
        assert task.check(changed(task, method, off)).startswith("Right")


OTHER_TABLES: list[tuple[Task, str, str]] = [
    (LOOP, "learn", "Q"),
    (EXPLORER, "act learn", "Q visits tries"),
    (TWO_POLICIES, "learn", "Q"),
    (DEEP, "hand_back", "Q"),
    (LINEAR, "learn", "w"),
    (LISTENER, "act", "last"),
    (REINFORCE, "look update", "preferences V"),
    (TWO_WEIGHTS, "learn", "Q"),
    (DYNA, "imagine", "Q rewards next_states ends last clock seen n_seen"),
    (R_MAX, "learn sweep", "Q known rewards next_states ends"),
]


@pytest.mark.parametrize(
    ("task", "method", "table"),
    [
        pytest.param(task, method, table, id=f"{task.name}-{method}-{table}", marks=[pytest.mark.slow] * (task in LONG))
        for task, methods, tables in OTHER_TABLES
        for method in methods.split()
        for table in tables.split()
    ],
)
def test_no_table_changes_unnoticed(task: Task, method: str, table: str) -> None:
    """Each time it is called, the method adds 1 to one entry, and each time to another one."""
    calls = 0

    def spoil(original: Any, self: Any, *arguments: Any, **named: Any) -> Any:
        nonlocal calls
        returned, values = original(self, *arguments, **named), getattr(self, table)
        calls += 1
        values.flat[7 * calls % np.size(values)] += 1
        return returned

    with pytest.raises(WrongAnswer):
        task.check(changed(task, method, spoil))

"""Answers that are right but for one place: each check looks there, so that none of its cases can be left out."""

from collections.abc import Callable
from functools import cache, wraps
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import WrongAnswer
from edugym_course.grading.updates import Update
from edugym_course.lessons.continuous_actions import exercises as continuous_actions
from edugym_course.lessons.depth import exercises as depth
from edugym_course.lessons.dimensionality import exercises as dimensionality
from edugym_course.lessons.exploration import exercises as exploration
from edugym_course.lessons.loop import exercises as loop
from edugym_course.lessons.model_based import exercises as model_based
from edugym_course.lessons.on_off_policy import exercises as on_off_policy
from edugym_course.lessons.own_problem import exercises as own_problem
from edugym_course.lessons.signal import exercises as signal
from edugym_course.lessons.stochasticity import exercises as stochasticity
from tests.course.exercises.test_bounds import exact_switch
from tests.course.lessons.answers import solution

Exercise = Callable[[Any, int], str]
Where = Callable[..., Any]


class Task(NamedTuple):
    """An exercise, and what its answer is called."""

    check: Exercise
    lesson: str
    number: int
    name: str

    @property
    def right(self) -> Any:
        """What the lesson's solution defines."""
        return right_answer(self.lesson, self.number, self.name)


right_answer = cache(solution)
LOOP = Task(loop.exercise_3, "00_loop", 3, "MyAgent")
EXPLORER = Task(exploration.exercise_3, "01_exploration", 3, "MyExplorer")
TWO_POLICIES = Task(on_off_policy.exercise_3, "02_on_off_policy", 3, "TwoPolicies")
DEEP = Task(depth.exercise_3, "03_depth", 3, "MyAgent")
LINEAR = Task(dimensionality.exercise_2, "04_dimensionality", 2, "MyAgent")
LISTENER = Task(signal.exercise_3, "06_signal", 3, "Listener")
SCORES = Task(continuous_actions.exercise_2, "07_continuous_actions", 2, "my_scores")
REINFORCE = Task(continuous_actions.exercise_3, "07_continuous_actions", 3, "MyREINFORCE")
TWO_WEIGHTS = Task(stochasticity.exercise_3, "08_stochasticity", 3, "TwoWeights")
DYNA = Task(model_based.exercise_2, "09_model_based", 2, "DynaPlus")
R_MAX = Task(model_based.exercise_3, "09_model_based", 3, "MyRMax")
MORNING = Task(own_problem.exercise_3, "10_own_problem", 3, "UsedToIt")


def another(answer: Any, *arguments: Any) -> Any:
    """A wrong number, also where the right one is 0 or has hundreds of digits."""
    return 2 * answer(*arguments) + 1


def first_more(answer: Any, *arguments: Any) -> Any:
    """A pair whose first part is wrong."""
    first, second = answer(*arguments)
    return first + 1, second


def second_more(answer: Any, *arguments: Any) -> Any:
    """A pair whose second part is wrong."""
    first, second = answer(*arguments)
    return first, second + 1


def tie(values: Any) -> bool:
    """Whether two actions are the best."""
    return bool((values == values.max()).sum() == 2)


PLACES: list[tuple[Task, Callable[..., Any], list[Where]]] = [
    (
        Task(loop.exercise_1, "00_loop", 1, "discounted_return"),
        another,
        [
            lambda rewards, discount: discount == 0,
            lambda rewards, discount: discount == 1,
            lambda rewards, discount: len(rewards) == 1,
            lambda rewards, discount: len(rewards) >= 4,
        ],
    ),
    (
        Task(loop.exercise_2, "00_loop", 2, "choose"),
        lambda answer, values, epsilon, rng: int(values.argmin()),
        [
            lambda values, epsilon, rng: epsilon == 1,
            lambda values, epsilon, rng: epsilon == 0 and values.max() < 0 and not tie(values),
            lambda values, epsilon, rng: epsilon == 0 and values.max() < 0 and tie(values),
            lambda values, epsilon, rng: epsilon == 0 and values.max() > 0 and tie(values),
            lambda values, epsilon, rng: epsilon == 0 and values.argmax() == 0 and values[0] > 0,
            lambda values, epsilon, rng: epsilon == 0 and not values.any(),
            lambda values, epsilon, rng: 0 < epsilon < 1 and tie(values),
            lambda values, epsilon, rng: 0 < epsilon < 1 and not tie(values),
            lambda values, epsilon, rng: len(values) == 3 and epsilon > 0,
            lambda values, epsilon, rng: len(values) == 5,
        ],
    ),
    (
        Task(exploration.exercise_2, "01_exploration", 2, "optimist"),
        lambda answer, wall: QLearning.create(wall),
        [lambda wall: wall.action_space.n == 2, lambda wall: wall.action_space.n == 3],
    ),
    (
        Task(depth.exercise_2, "03_depth", 2, "importance_ratio"),
        another,
        [
            lambda greedy, epsilon, n: greedy == [True],
            lambda greedy, epsilon, n: greedy == [False],
            lambda greedy, epsilon, n: epsilon == 0,
            lambda greedy, epsilon, n: epsilon == 1,
            lambda greedy, epsilon, n: len(greedy) > 1 and not greedy[0],
            lambda greedy, epsilon, n: not greedy[-1] and len(greedy) > 1,
            lambda greedy, epsilon, n: False in greedy[1:-1],
            lambda greedy, epsilon, n: len(greedy) > 3 and all(greedy),
        ],
    ),
    (
        Task(dimensionality.exercise_1, "04_dimensionality", 1, "table_entries"),
        another,
        [
            *(lambda rows, columns, kind, seen=seen: kind == seen for seen in ("vectorised", "grid", "rgb")),
            lambda rows, columns, kind: rows == columns,
            lambda rows, columns, kind: rows == 5 and columns == 2,
            lambda rows, columns, kind: columns == 4,
        ],
    ),
    (
        Task(signal.exercise_2, "06_signal", 2, "bits_in"),
        another,
        [
            *(lambda joint, shape=shape: joint.shape == shape for shape in ((2, 2), (2, 3), (3, 2), (4, 4))),
            lambda joint: not joint[0, 0],
            lambda joint: joint.shape == (2, 2) and set(16 * joint.ravel()) != {6, 2, 1, 7},
        ],
    ),
    (
        Task(continuous_actions.exercise_1, "07_continuous_actions", 1, "preferences"),
        another,
        [lambda joints, bins, cells, m=m: joints == m for m in (1, 2, 3, 4)],
    ),
    *(
        (
            SCORES,
            wrong,
            [
                lambda a, mu, sigma: np.ndim(a) > 0,
                lambda a, mu, sigma: np.ndim(a) == 0 and sigma < 0.75,
                lambda a, mu, sigma: np.ndim(a) == 0 and sigma == 2,
                lambda a, mu, sigma: np.ndim(a) == 0 and 0.75 <= sigma < 2,
            ],
        )
        for wrong in (first_more, second_more)
    ),
    (
        Task(stochasticity.exercise_2, "08_stochasticity", 2, "frontier"),
        lambda answer, players: [*players],
        [lambda players, n=n: len(players) == n for n in (9, 10, 11)],
    ),
    (
        Task(own_problem.exercise_2, "10_own_problem", 2, "shaped_reward"),
        another,
        [lambda r, phi, s, s2, end, discount: end, lambda r, phi, s, s2, end, discount: not end],
    ),
]


@pytest.mark.parametrize(
    ("task", "wrong", "where"),
    [
        pytest.param(task, wrong, where, id=f"{task.lesson}-{task.number}-{number}")
        for task, wrong, wheres in PLACES
        for number, where in enumerate(wheres)
    ],
)
def test_a_function_that_is_wrong_in_one_place(task: Task, wrong: Callable[..., Any], where: Where) -> None:
    """It is refused."""

    def answer(*arguments: Any) -> Any:
        return wrong(task.right, *arguments) if where(*arguments) else task.right(*arguments)

    with pytest.raises(WrongAnswer):
        task.check(answer, 0)


@pytest.mark.parametrize(("low", "high"), [(-200.0, -100.0), (-90.0, -60.0), (-59.5, -40.0)])
def test_a_switch_that_is_wrong_on_one_road(low: float, high: float) -> None:
    """Where a fall costs as much as that."""
    with pytest.raises(WrongAnswer):
        on_off_policy.exercise_2(lambda m: exact_switch(m) + 0.01 * (low <= m.rewards.min() <= high), 0)


def changed(task: Task, method: str, where: Where, wrong: Callable[..., Any]) -> type:
    """Return the solution's class with a method that does something else in some places.

    Args:
        task: the exercise.
        method: the name of the method.
        where: tells from the arguments, `self` first, whether this is such a place.
        wrong: what the method does there: a function of the right method and the arguments.
    """
    right = task.right
    original = getattr(right, method)

    @wraps(original)
    def other(self: Any, *arguments: Any, **named: Any) -> Any:
        if where(self, *arguments, **named):
            return wrong(original, self, *arguments, **named)
        return original(self, *arguments, **named)

    return type(task.name, (right,), {"__slots__": (), method: other})


def nothing(original: Any, *arguments: Any, **named: Any) -> None:
    """Do nothing."""


def one_more(original: Any, *arguments: Any) -> Any:
    """Return one more."""
    return original(*arguments) + 1


def the_next_need(original: Any, self: Any, *arguments: Any) -> int:
    """Choose the next action, and remember it."""
    self.last[0] = (original(self, *arguments) + 1) % 4
    return int(self.last[0])


METHODS: list[tuple[Task, str, Callable[..., Any], list[Where]]] = [
    (
        DEEP,
        "hand_back",
        nothing,
        [  # episodes of one step, of five steps, and those after a longer one
            lambda self, length: self.length[0] == 1,
            lambda self, length: self.length[0] == 5,
            lambda self, length: self.rewards[int(self.length[0])] != 0,
        ],
    ),
    (
        DYNA,
        "imagine",
        one_more,
        [
            lambda self, s, a: self.ends[s, a] == 1,
            lambda self, s, a: self.last[s, a] > 0 and self.rewards[s, a] == 0 and self.next_states[s, a] > 0,
            lambda self, s, a: self.last[s, a] > 0 and self.next_states[s, a] == 0,
            lambda self, s, a: self.rewards[s, a] != 0 and self.ends[s, a] == 0,
            lambda self, s, a: self.last[s, a] == 0 and self.last[s].any(),
            lambda self, s, a: not self.last[s].any(),
        ],
    ),
    (
        LISTENER,
        "act",
        the_next_need,
        [
            *(lambda self, seen, rng, last=last: self.last[0] == last for last in (-1, 0, 1, 2, 3)),
            *(lambda self, seen, rng, n=n: len(seen) == n + 1 for n in (1, 3, 4, 5, 6)),
            lambda self, seen, rng: max(seen[1:]) > 3,
            lambda self, seen, rng: not any(seen[1:]),
        ],
    ),
    (
        MORNING,
        "transition",
        lambda original, *arguments: (arguments[1][0], (arguments[1][1] + 1) % 3, arguments[1][2]),
        [
            lambda self, state, action, rng, place=(depth, chimes, act): (*state[1:], action) == place
            for depth in range(3)
            for chimes in range(3)
            for act in range(3)
        ],
    ),
    (
        MORNING,
        "reward",
        one_more,
        [
            *(lambda self, state, *_, time=time: state[0] == time for time in (0, 4, 7)),
            lambda self, state, action, after, rng: after[0] == 8 and after[1] > 0,
            lambda self, state, action, after, rng: action == 2,
            lambda self, state, action, after, rng: state[1:] == (2, 2),
        ],
    ),
    (
        MORNING,
        "terminal",
        lambda original, *arguments: not original(*arguments),
        [lambda self, state, time=time: state[0] == time for time in (0, 4, 7, 8)],
    ),
    (
        MORNING,
        "observation",
        lambda original, self, state, rng: (state[0], 3, 3),
        [lambda self, state, rng, time=time: state[0] == time for time in (0, 4, 7, 8)],
    ),
]


@pytest.mark.parametrize(
    ("task", "method", "wrong", "where"),
    [
        pytest.param(task, method, wrong, where, id=f"{task.lesson}-{method}-{number}")
        for task, method, wrong, wheres in METHODS
        for number, where in enumerate(wheres)
    ],
)
def test_a_method_that_is_wrong_in_one_place(task: Task, method: str, wrong: Any, where: Where) -> None:
    """It is refused."""
    with pytest.raises(WrongAnswer):
        task.check(changed(task, method, where, wrong), 0)


STEPS: dict[str, Where] = {
    "the end": lambda Q, s, s2, reward, terminated, truncated: terminated,
    "cut off": lambda Q, s, s2, reward, terminated, truncated: truncated,
    "a step that stays": lambda Q, s, s2, reward, terminated, truncated: s == s2,
    "no reward": lambda Q, s, s2, reward, terminated, truncated: reward == 0,
    "only values below 0": lambda Q, s, s2, reward, terminated, truncated: Q[s2].max() < 0,
    **{
        f"{n} actions": lambda Q, s, s2, reward, terminated, truncated, n=n: Q.shape[1] == n for n in (2, 3, 4)
    },
}  # fmt: skip


@pytest.mark.parametrize(
    ("task", "kind"),
    [
        pytest.param(task, kind, id=f"{task.lesson}-{kind}")
        for task in (LOOP, EXPLORER, TWO_POLICIES, TWO_WEIGHTS)
        for kind in STEPS
        if (task, kind) != (EXPLORER, "4 actions")  # its walls have two or three grips
    ],
)
def test_an_agent_that_does_not_learn_from_some_steps(task: Task, kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is refused. The usual mistakes are looked up for one kind of steps, which takes time."""
    if (task, kind) != (LOOP, "a step that stays"):
        monkeypatch.setattr(Update, "_diagnosis", lambda *arguments: "")

    class Mine(task.right):  # type: ignore[misc, name-defined]
        """The solution, but for some steps."""

        __slots__ = ()

        def learn(
            self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool
        ) -> None:
            """Learn, or not."""
            if not STEPS[kind](self.Q, state, next_state, reward, terminated, truncated):
                super().learn(state, action, reward, next_state, terminated)

    with pytest.raises(WrongAnswer):
        task.check(Mine, 0)


@pytest.mark.parametrize(
    "where",
    [
        lambda states, cut_off: len(states) == 1,
        lambda states, cut_off: len(states) == 4,
        lambda states, cut_off: len(states) > 1 and cut_off,
        lambda states, cut_off: len(states) > 1 and not cut_off,
        lambda states, cut_off: len({*states}) < len(states),
    ],
)
def test_reinforce_that_does_not_learn_from_some_episodes(where: Where) -> None:
    """Those of one step or of four, those that are cut off or end, and those that come back."""

    def learn(original: Any, self: Any, **now: Any) -> None:
        before = self.preferences.copy(), self.V.copy()
        states = [*self.states[: self.length[0]].tolist(), now["state"]]
        original(self, **now)
        if where(states, now["truncated"]):
            self.preferences[:], self.V[:] = before

    with pytest.raises(WrongAnswer):
        continuous_actions.exercise_3(changed(REINFORCE, "learn", lambda *_, **__: True, learn), 0)


LEARNED = [(task, "Q") for task in (LOOP, EXPLORER, TWO_POLICIES, TWO_WEIGHTS, DEEP)]
LEARNED += [(LINEAR, "w"), (REINFORCE, "preferences"), (REINFORCE, "V")]


@pytest.mark.parametrize(("task", "table"), LEARNED)
@pytest.mark.parametrize(("error", "accepted"), [(1e-12, True), (1e-7, False)])
def test_how_far_tables_may_be(task: Task, table: str, error: float, accepted: bool) -> None:
    """As far as rounding takes them."""

    def off(original: Any, self: Any, *arguments: Any, **named: Any) -> None:
        original(self, *arguments, **named)
        getattr(self, table)[...] *= 1 + error

    answer = changed(task, "learn", lambda *_, **__: True, off)
    if accepted:
        assert task.check(answer, 0).startswith("Right")
    else:
        with pytest.raises(WrongAnswer):
            task.check(answer, 0)


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
        pytest.param(task, method, table, id=f"{task.name}-{method}-{table}")
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
        task.check(changed(task, method, lambda *_, **__: True, spoil), 0)

"""Classes that are right but for one place: each check looks there, so that none of its cases can be left out."""

from collections.abc import Callable
from functools import wraps
from typing import Any

import numpy as np
import pytest

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
from tests.course.exercises.test_places import Exercise, Where, right_answer

AGENTS: list[tuple[Exercise, tuple[str, int, str], list[int]]] = [
    (loop.exercise_3, ("00_loop", 3, "MyAgent"), [2, 3, 4]),
    (exploration.exercise_3, ("01_exploration", 3, "MyExplorer"), [2, 3]),
    (on_off_policy.exercise_3, ("02_on_off_policy", 3, "TwoPolicies"), [2, 3, 4]),
    (stochasticity.exercise_3, ("08_stochasticity", 3, "TwoWeights"), [2, 3, 4]),
]
STEPS: dict[str, Where] = {
    "the end": lambda Q, s, s2, reward, terminated, truncated: terminated,
    "cut off": lambda Q, s, s2, reward, terminated, truncated: truncated,
    "a step that stays": lambda Q, s, s2, reward, terminated, truncated: s == s2,
    "no reward": lambda Q, s, s2, reward, terminated, truncated: reward == 0,
    "only values below 0": lambda Q, s, s2, reward, terminated, truncated: Q[s2].max() < 0,
}
LOOKED_UP = "a step that stays"


def steps_of(actions: list[int]) -> dict[str, Where]:
    """The kinds of steps, and those with each number of actions."""
    return STEPS | {
        f"{n} actions": lambda Q, s, s2, reward, terminated, truncated, n=n: Q.shape[1] == n for n in actions
    }


@pytest.mark.parametrize(
    ("exercise", "place", "where", "looked_up"),
    [
        pytest.param(exercise, place, where, name == LOOKED_UP, id=f"{place[0]}-{name}")
        for exercise, place, actions in AGENTS
        for name, where in steps_of(actions).items()
    ],
)
def test_an_agent_that_does_not_learn_from_some_steps(
    exercise: Exercise, place: tuple[str, int, str], where: Where, looked_up: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is refused. The usual mistakes are looked up for one kind of steps, which takes time."""
    if not looked_up:
        monkeypatch.setattr(Update, "_why", lambda *arguments: "")

    class Mine(right_answer(*place)):  # type: ignore[misc]
        """The solution, but for some steps."""

        __slots__ = ()

        def learn(
            self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool
        ) -> None:
            """Learn, or not."""
            if not where(self.Q, state, next_state, reward, terminated, truncated):
                super().learn(state, action, reward, next_state, terminated)

    with pytest.raises(WrongAnswer):
        exercise(Mine, 0)


@pytest.mark.parametrize(
    "where",
    [
        lambda k, left: k == 0,
        lambda k, left: k == 4,
        lambda k, left: left,  # a second episode, shorter than the first
    ],
)
def test_a_deep_agent_that_does_not_learn_from_some_episodes(where: Where) -> None:
    """Those of one step, those of five, and those after another one."""

    class Mine(right_answer("03_depth", 3, "MyAgent")):  # type: ignore[misc]
        """The solution, but for some episodes."""

        __slots__ = ()

        def hand_back(self, *arguments: Any) -> None:
            """Learn, or not."""
            k = int(self.length[0]) - 1
            if not where(k, self.rewards[k + 1] != 0):
                super().hand_back(*arguments)

    with pytest.raises(WrongAnswer):
        depth.exercise_3(Mine, 0)


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

    class Mine(right_answer("07_continuous_actions", 3, "MyREINFORCE")):  # type: ignore[misc]
        """The solution, but for some episodes."""

        __slots__ = ()

        def learn(self, state: int, action: int, reward: float, terminated: bool, truncated: bool) -> None:
            """Learn, or not."""
            before = self.preferences.copy(), self.V.copy()
            states = [*self.states[: self.length[0]].tolist(), state]
            super().learn(state, action, reward, terminated, truncated)
            if where(states, truncated):
                self.preferences[:], self.V[:] = before

    with pytest.raises(WrongAnswer):
        continuous_actions.exercise_3(Mine, 0)


@pytest.mark.parametrize(
    "where",
    [
        lambda self, s, a: self.ends[s, a] == 1,
        lambda self, s, a: self.last[s, a] > 0 and self.rewards[s, a] == 0 and self.next_states[s, a] > 0,
        lambda self, s, a: self.last[s, a] > 0 and self.next_states[s, a] == 0,
        lambda self, s, a: self.rewards[s, a] != 0 and self.ends[s, a] == 0,
        lambda self, s, a: self.last[s, a] == 0 and self.last[s].any(),
        lambda self, s, a: not self.last[s].any(),
    ],
)
def test_a_wrong_image_of_some_pairs(where: Where) -> None:
    """Those that end an episode, look as if never tried, are ordinary, and were never tried."""

    class Mine(right_answer("09_model_based", 2, "DynaPlus")):  # type: ignore[misc]
        """The solution, but for some pairs."""

        __slots__ = ()

        def imagine(self, s: int, a: int) -> float:
            """The target, or one more."""
            return float(super().imagine(s, a) + where(self, s, a))

    with pytest.raises(WrongAnswer):
        model_based.exercise_2(Mine, 0)


TABLES: list[tuple[Exercise, tuple[str, int, str], str]] = [
    *((exercise, place, "Q") for exercise, place, _ in AGENTS),
    (depth.exercise_3, ("03_depth", 3, "MyAgent"), "Q"),
    (dimensionality.exercise_2, ("04_dimensionality", 2, "MyAgent"), "w"),
    *(
        (continuous_actions.exercise_3, ("07_continuous_actions", 3, "MyREINFORCE"), name)
        for name in ("preferences", "V")
    ),
]


@pytest.mark.parametrize(("exercise", "place", "table"), TABLES)
@pytest.mark.parametrize(("error", "accepted"), [(1e-12, True), (1e-7, False)])
def test_how_far_tables_may_be(
    exercise: Exercise, place: tuple[str, int, str], table: str, error: float, accepted: bool
) -> None:
    """As far as rounding takes them."""
    right = right_answer(*place)

    @wraps(right.learn)
    def learn(self: Any, *arguments: Any, **named: Any) -> None:
        right.learn(self, *arguments, **named)
        getattr(self, table)[...] *= 1 + error

    answer = type("Mine", (right,), {"learn": learn, "__slots__": ()})
    if accepted:
        assert exercise(answer, 0).startswith("Right")
    else:
        with pytest.raises(WrongAnswer):
            exercise(answer, 0)


@pytest.mark.parametrize(
    "where",
    [
        *(lambda words, last, act=act: last == act for act in (-1, 0, 1, 2, 3)),
        *(lambda words, last, n=n: len(words) == n for n in (1, 3, 4, 5, 6)),
        lambda words, last: max(words) > 3,
        lambda words, last: not any(words),
    ],
)
def test_a_listener_that_is_wrong_in_one_place(where: Where) -> None:
    """With one last action, one number of words, synonyms, or one word only."""

    class Mine(right_answer("06_signal", 3, "Listener")):  # type: ignore[misc]
        """The solution, but for some messages."""

        __slots__ = ()

        def act(self, observation: Any, rng: np.random.Generator) -> int:
            """The right need, or the next one."""
            last = int(self.last[0])
            action = int(super().act(observation, rng))
            if where(observation[1:].tolist(), last):
                action = self.last[0] = (action + 1) % 4
            return action

    with pytest.raises(WrongAnswer):
        signal.exercise_3(Mine, 0)


MORNING: list[tuple[str, Where, Callable[[Any], Any]]] = [
    *(
        (
            "transition",
            lambda state, action, rng, place=(depth, chimes, act): (*state[1:], action) == place,
            lambda state: (state[0], (state[1] + 1) % 3, state[2]),
        )
        for depth in range(3)
        for chimes in range(3)
        for act in range(3)
    ),
    *(
        (method, lambda state, *rest, time=time: state[0] == time, wrong)
        for time in (0, 4, 7)
        for method, wrong in (
            ("reward", lambda reward: reward + 1),
            ("terminal", lambda ends: not ends),
            ("observation", lambda seen: (seen[0], seen[1], 1)),
        )
    ),
    ("terminal", lambda state: state[0] == 8, lambda ends: not ends),
    ("observation", lambda state, rng: state[0] == 8, lambda seen: (8, 0, 0)),
    ("reward", lambda state, action, after, rng: after[0] == 8 and after[1] > 0, lambda reward: reward + 10),
    ("reward", lambda state, action, after, rng: action == 2, lambda reward: reward + 1),
    ("reward", lambda state, action, after, rng: state[1:] == (2, 2), lambda reward: reward + 1),
]


@pytest.mark.parametrize(("method", "where", "wrong"), MORNING)
def test_a_morning_that_is_wrong_in_one_place(method: str, where: Where, wrong: Callable[[Any], Any]) -> None:
    """In the next state of one depth, count and action; or in what should stay as it was."""
    right = right_answer("10_own_problem", 3, "UsedToIt")

    def changed(self: Any, *arguments: Any) -> Any:
        told = getattr(right, method)(self, *arguments)
        return wrong(told) if where(*arguments) else told

    with pytest.raises(WrongAnswer, match=f"{method}\\("):
        own_problem.exercise_3(type("UsedToIt", (right,), {method: changed, "__slots__": ()}), 0)

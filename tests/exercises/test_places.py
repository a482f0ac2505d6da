"""Answers that are right but for one place: each check looks there, so that none of its cases can be left out."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest

from edugym import QLearning
from edugym.exercises import (
    continuous_actions,
    depth,
    dimensionality,
    exploration,
    loop,
    model_based,
    on_off_policy,
    own_problem,
    signal,
    stochasticity,
)
from edugym.grading import WrongAnswer
from tests.exercises.test_bounds import exact_switch
from tests.lessons.answers import solution

Exercise = Callable[[Any, int], str]
Where = Callable[..., Any]

right_answer = cache(solution)
"""What the lesson's solution of an exercise defines."""


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


def lowest(answer: Any, values: Any, epsilon: float, rng: Any) -> int:
    """The first of the lowest actions."""
    return int(values.argmin())


def everybody(answer: Any, players: Any) -> list[str]:
    """All names, or the first one if all of them are right."""
    return [*players]


def hasty(answer: Any, wall: Any) -> QLearning:
    """An agent with the usual settings."""
    return QLearning.create(wall)


def tie(values: Any) -> bool:
    """Whether two actions are the best."""
    return bool((values == values.max()).sum() == 2)


PLACES: list[tuple[Exercise, tuple[str, int, str], Callable[..., Any], list[Where]]] = [
    (
        loop.exercise_1,
        ("00_loop", 1, "discounted_return"),
        another,
        [
            lambda rewards, discount: discount == 0,
            lambda rewards, discount: discount == 1,
            lambda rewards, discount: len(rewards) == 1,
            lambda rewards, discount: len(rewards) >= 4,
        ],
    ),
    (
        loop.exercise_2,
        ("00_loop", 2, "choose"),
        lowest,
        [
            lambda values, epsilon, rng: epsilon == 1,
            lambda values, epsilon, rng: epsilon == 0 and values.max() < 0 and not tie(values),
            lambda values, epsilon, rng: epsilon == 0 and values.max() < 0 and tie(values),
            lambda values, epsilon, rng: epsilon == 0 and values.max() > 0 and tie(values),
            lambda values, epsilon, rng: epsilon == 0 and values.max() > 0 and not tie(values),
            lambda values, epsilon, rng: epsilon == 0 and values.argmax() == 0 and values[0] > 0,
            lambda values, epsilon, rng: epsilon == 0 and not values.any(),
            lambda values, epsilon, rng: 0 < epsilon < 1 and tie(values),
            lambda values, epsilon, rng: 0 < epsilon < 1 and not tie(values),
            lambda values, epsilon, rng: len(values) == 3 and epsilon > 0,
            lambda values, epsilon, rng: len(values) == 5,
        ],
    ),
    (
        exploration.exercise_2,
        ("01_exploration", 2, "optimist"),
        hasty,
        [lambda wall: wall.action_space.n == 2, lambda wall: wall.action_space.n == 3],
    ),
    (
        depth.exercise_2,
        ("03_depth", 2, "importance_ratio"),
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
        dimensionality.exercise_1,
        ("04_dimensionality", 1, "table_entries"),
        another,
        [
            *(lambda rows, columns, kind, seen=seen: kind == seen for seen in ("vectorised", "grid", "rgb")),
            lambda rows, columns, kind: rows == columns,
            lambda rows, columns, kind: rows == 5 and columns == 2,
            lambda rows, columns, kind: columns == 4,
        ],
    ),
    (
        signal.exercise_2,
        ("06_signal", 2, "bits_in"),
        another,
        [
            *(lambda joint, shape=shape: joint.shape == shape for shape in ((2, 2), (2, 3), (3, 2), (4, 4))),
            lambda joint: not joint[0, 0],
            lambda joint: joint.shape == (2, 2) and set(16 * joint.ravel()) != {6, 2, 1, 7},
            lambda joint: joint.shape == (2, 2) and set(16 * joint.ravel()) == {6, 2, 1, 7},
        ],
    ),
    (
        continuous_actions.exercise_1,
        ("07_continuous_actions", 1, "preferences"),
        another,
        [lambda joints, bins, cells, m=m: joints == m for m in (1, 2, 3, 4)],
    ),
    *(
        (
            continuous_actions.exercise_2,
            ("07_continuous_actions", 2, "my_scores"),
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
        stochasticity.exercise_2,
        ("08_stochasticity", 2, "frontier"),
        everybody,
        [lambda players, n=n: len(players) == n for n in (9, 10, 11)],
    ),
    (
        own_problem.exercise_2,
        ("10_own_problem", 2, "shaped_reward"),
        another,
        [lambda r, phi, s, s2, end, discount: end, lambda r, phi, s, s2, end, discount: not end],
    ),
]


@pytest.mark.parametrize(
    ("exercise", "place", "wrong", "where"),
    [
        pytest.param(exercise, place, wrong, where, id=f"{place[0]}-{place[1]}-{number}")
        for exercise, place, wrong, wheres in PLACES
        for number, where in enumerate(wheres)
    ],
)
@pytest.mark.parametrize("seed", [0, 1])
def test_a_function_that_is_wrong_in_one_place(
    exercise: Exercise, place: tuple[str, int, str], wrong: Callable[..., Any], where: Where, seed: int
) -> None:
    """It is refused."""
    right = right_answer(*place)

    def answer(*arguments: Any) -> Any:
        return wrong(right, *arguments) if where(*arguments) else right(*arguments)

    with pytest.raises(WrongAnswer):
        exercise(answer, seed)


@pytest.mark.parametrize(("low", "high"), [(-200.0, -100.0), (-90.0, -60.0), (-59.5, -40.0)])
def test_a_switch_that_is_wrong_on_one_road(low: float, high: float) -> None:
    """Where a fall costs as much as that."""
    with pytest.raises(WrongAnswer):
        on_off_policy.exercise_2(lambda m: exact_switch(m) + 0.01 * (low <= m.rewards.min() <= high), 0)


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


def steps_of(actions: list[int]) -> dict[str, Where]:
    """The kinds of steps, and those with each number of actions."""
    return STEPS | {
        f"{n} actions": lambda Q, s, s2, reward, terminated, truncated, n=n: Q.shape[1] == n for n in actions
    }


@pytest.mark.parametrize(
    ("exercise", "place", "where"),
    [
        pytest.param(exercise, place, where, id=f"{place[0]}-{name}")
        for exercise, place, actions in AGENTS
        for name, where in steps_of(actions).items()
    ],
)
def test_an_agent_that_does_not_learn_from_some_steps(
    exercise: Exercise, place: tuple[str, int, str], where: Where
) -> None:
    """It is refused."""

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

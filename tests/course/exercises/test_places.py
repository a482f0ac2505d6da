"""Functions that are right but for one place: each check looks there, so that none of its cases can be left out."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import WrongAnswer
from edugym_course.lessons.continuous_actions import exercises as continuous_actions
from edugym_course.lessons.depth import exercises as depth
from edugym_course.lessons.dimensionality import exercises as dimensionality
from edugym_course.lessons.exploration import exercises as exploration
from edugym_course.lessons.loop import exercises as loop
from edugym_course.lessons.on_off_policy import exercises as on_off_policy
from edugym_course.lessons.own_problem import exercises as own_problem
from edugym_course.lessons.signal import exercises as signal
from edugym_course.lessons.stochasticity import exercises as stochasticity
from tests.course.exercises.test_bounds import exact_switch
from tests.course.lessons.answers import solution

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
def test_a_function_that_is_wrong_in_one_place(
    exercise: Exercise, place: tuple[str, int, str], wrong: Callable[..., Any], where: Where
) -> None:
    """It is refused."""
    right = right_answer(*place)

    def answer(*arguments: Any) -> Any:
        return wrong(right, *arguments) if where(*arguments) else right(*arguments)

    with pytest.raises(WrongAnswer):
        exercise(answer, 0)


@pytest.mark.parametrize(("low", "high"), [(-200.0, -100.0), (-90.0, -60.0), (-59.5, -40.0)])
def test_a_switch_that_is_wrong_on_one_road(low: float, high: float) -> None:
    """Where a fall costs as much as that."""
    with pytest.raises(WrongAnswer):
        on_off_policy.exercise_2(lambda m: exact_switch(m) + 0.01 * (low <= m.rewards.min() <= high), 0)

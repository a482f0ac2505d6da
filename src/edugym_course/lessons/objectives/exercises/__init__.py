"""The exercises of lesson 12: which points are good, which action is closest, and how a price is learned."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Annotated, Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.choices import action_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all, mistake_in_cases, mistake_that_fits, told_wrong
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given, in_brackets, number, require_unchanged
from edugym_course.lessons.objectives.exercises.choices import (
    CLOSEST_MISTAKES,
    NO_USUAL_CHOICE,
    PRICE_MISTAKES,
    Choice,
    choices,
    chosen,
    right_choice,
    right_price,
)
from edugym_course.lessons.objectives.exercises.points import (
    NO_USUAL_POINTS,
    ONCE,
    POINT_MISTAKES,
    Point,
    Points,
    made_up_points,
    numbers_of,
    point_rules,
    right_points,
)

Least = Annotated[
    float,
    Own(
        tuple(k / 2 for k in range(31, 91)),
        "Small treasures are not worth a dive: in your version no point with a value below {least} is returned.",
    ),
]


def exercise_1(answer: Any, seed: int, least: Least = 0.0) -> str:
    """Check which points are Pareto-optimal, where a point may need a lowest value."""
    require_function("pareto_optimal", answer, "points")
    rng = telling_draw(seed, made_up_points, [partial(numbers_of, right_points), *point_rules()])
    cases = [[(20.0, -3.0), (10.0, -5.0), (30.0, -9.0)], *made_up_points(rng)]
    if least:
        cases.append([(least - 0.25, -1.0), (least, -2.0), (least + 0.25, -3.0)])
    found = [_points(answer, points) for points in cases]

    def left(rule: Callable[[Points], list[Point]]) -> list[list[Point]]:
        return [[point for point in rule(points) if point[0] >= least] for points in cases]

    right_ones = left(right_points)
    wrong = [mine != right for right, mine in zip(right_ones, found, strict=True)]
    if any(wrong):
        i = wrong.index(True)
        right, mine = right_ones[i], found[i]

        def explained(rule: Callable[[Points], list[Point]]) -> list[bool]:
            return [kept == one for kept, one in zip(left(rule), found, strict=True)]

        if all(sorted(right) == sorted(one) for right, one in zip(right_ones, found, strict=True)):
            why = "the points are right, and their order is not: keep that of the list"
        else:
            same = all({*right} == {*one} for right, one in zip(right_ones, found, strict=True))
            why = mistake_in_cases(POINT_MISTAKES, explained, wrong, ONCE if same else NO_USUAL_POINTS)
        raise WrongAnswer(told_wrong(f"pareto_optimal({cases[i]}) should be {right}, but is {mine}", why))
    return "Right: no other point is better than these. Weights play no part in it."


def _points(answer: Any, points: list[Point]) -> list[Point]:
    """Return what a student's function gives, as a list of points.

    Raises:
        WrongAnswer: it is something else.
    """
    call = f"pareto_optimal({points})"
    mine = [(value, time) for value, time in points]  # equal points are two objects, which `is` would tell apart
    with student_code(call):
        found = answer(mine)
    given(call, found)
    require_unchanged(call, "points", mine, points)
    if isinstance(found, str) or not isinstance(found, Iterable):
        raise WrongAnswer(f"{call} should be a list of points, but is {found!r}")
    if isinstance(found, Iterator):
        raise WrongAnswer(f"{call} gives a {type(found).__name__}, which can be gone through once: make a list of it")
    found = [*found]
    if found and all(isinstance(one, bool | np.bool_) for one in found):
        raise WrongAnswer(f"{call} gives a list of True and False; return the points themselves")
    if found and all(isinstance(one, int | np.integer) for one in found):
        raise WrongAnswer(f"{call} gives whole numbers, the places of points; return the points themselves")
    for one in found:
        if not isinstance(one, tuple | list | np.ndarray) or len(one) != 2:
            raise WrongAnswer(f"{call} should be a list of points (value, time), but one of them is {one!r}")
    what = f"each part of a point of {call}"
    return [(number(what, value), number(what, time)) for value, time in found]


Margin = Annotated[
    float,
    Own(
        tuple(k / 2 for k in range(2, 62)),
        "Your utopian point lies farther out: in your version `utopian + {margin}` stands in the place of `utopian`.",
    ),
]


def _between_two(margin: float) -> list[Choice]:
    """Make up states in which the second action is the closer one up to a margin a little below or above this one."""
    made = list[Choice]()
    for most in (margin - 0.03125, margin + 0.03125):  # less than what rounding to a tenth takes off
        Q = np.array([[[-most - 2.0, -0.5], [0.0, -1.0]]])
        made.append((Q, 0, np.array([1.0, 2.0]), np.zeros(2)))
    return made


def exercise_2(answer: Any, seed: int, margin: Margin = 0.0) -> str:
    """Check the action that is closest to a point, which may lie farther out."""
    require_function("closest_action", answer, "Q, state, weights and utopian")
    rules = [partial(chosen, rule) for rule in (right_choice, *CLOSEST_MISTAKES.values())]
    cases, found, calls = [*choices(telling_draw(seed, choices, rules)), *_between_two(margin)], [], []
    for Q, state, weights, z in cases:
        call = (
            f"closest_action(Q, {state}, {in_brackets(weights)}, {in_brackets(z)}), where Q[{state}] ="
            f" [{', '.join(map(in_brackets, Q[state]))}],"
        )
        arrays = {"Q": Q.copy(), "weights": weights.copy(), "utopian": z.copy()}
        with student_code(call):
            action = answer(arrays["Q"], state, arrays["weights"], arrays["utopian"])
        given(f"closest_action(Q, {state}, ...)", action)
        for (name, mine), before in zip(arrays.items(), (Q, weights, z), strict=True):
            require_unchanged(f"closest_action(Q, {state}, ...)", name, mine, before)
        if (
            isinstance(action, float | np.floating)
            and abs(action - right_choice(Q, state, weights, z + margin).min()) < 1e-9
        ):
            raise WrongAnswer(f"{call} gives {action:.4g}, the smallest distance; its action is wanted, so the place")
        calls.append(call)
        found.append(action_of(call, action, Q.shape[1]))
    cases = [(Q, state, weights, z + margin) for Q, state, weights, z in cases]
    expected = [int(right_choice(*case).argmin()) for case in cases]
    wrong = [one != action for one, action in zip(expected, found, strict=True)]
    if any(wrong):

        def everywhere(rule: Callable[[Reals, int, Reals, Reals], Reals]) -> bool:
            return all(chosen(rule, case) == action for case, action in zip(cases, found, strict=True))

        i = wrong.index(True)
        why = mistake_that_fits(CLOSEST_MISTAKES, everywhere, NO_USUAL_CHOICE)  # of four actions two agree by chance
        raise WrongAnswer(told_wrong(f"{calls[i]} should give action {expected[i]}, but gives {found[i]}", why))
    return "Right: the objective in which an action is worst decides. So no amount of time makes up for a poor value."


Delay = Annotated[
    int,
    Own(
        tuple(range(1, 51)),
        "Your diver needs time to dress: in your version a dive takes `steps` + {delay} steps.",
    ),
]


def exercise_3(answer: Any, seed: int, delay: Delay = 0) -> str:
    """Check how the price changes after a dive, which may take more steps than it is told."""
    require_function("new_price", answer, "price, steps, limit and rate")
    shift = seed % 5
    cases = []
    for price, steps, limit, rate in (
        (2.0, 9 + shift, 5, 0.25),
        (4.0, 3, 7 + shift, 0.03125),
        (0.5, 1, 9 + shift, 0.25),
        (0.0, 15, 11 - shift, 0.5),
        (3.0, 6 + shift, 6 + shift, 0.25),
        (40.0, 16 + shift, 8, 0.5),
    ):
        call = f"new_price({price}, {steps}, {limit}, {rate})"
        with student_code(call):
            found = answer(price, steps, limit, rate)
        taken = steps + delay
        wrong = {why: rule(price, taken, limit, rate) for why, rule in PRICE_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right_price(price, taken, limit, rate), wrong))
    compare_all(cases)
    return "Right: dual ascent. The price rises after dives that take too long, and falls after the others."

"""The exercises of lesson 17: what the largest mean promises, the update of double Q-learning, and a maxmin target."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Annotated, Any

import numpy as np

from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables
from edugym_course.grading.values import number
from edugym_course.lessons.maximisation_bias.exercises.promises import PROMISE_MISTAKES, casinos, promised, sum_by_hand
from edugym_course.lessons.maximisation_bias.exercises.targets import (
    AIM_MISTAKES,
    DOUBLE_MISTAKES,
    Learning,
    aimed,
    aims,
    doubled,
    learnings,
    target_by_hand,
    update_by_hand,
)

Chance = Annotated[
    float,
    Own(
        tuple(k / 100 for k in (*range(15, 48), *range(53, 86))),
        "In your version a machine wins with the probability {chance}, not 1/2.",
    ),
]
Cost = Annotated[float, step_cost()]
NEAR = 0.06
"""How far those of a simulation may be from the right numbers, as a share of what a win pays more than a loss."""
DRAWN = "that is near in all cases, and exact in none: draw nothing, and add up the n + 1 terms of the sum"


def exercise_1(answer: Any, seed: int, chance: Chance = 0.5) -> str:
    """Check what the largest of several means is on average."""
    require_function("largest_promise", answer, "n_machines, n_tries, win and lose")
    right = partial(promised, chance=chance)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in PROMISE_MISTAKES.values())]
    cases = []
    machines = casinos(telling_draw(seed, casinos, rules))
    for case in machines:
        call = f"largest_promise({case.k}, {case.n}, {case.win:g}, {case.lose:g})"
        with student_code(call):
            found = answer(*case)
        mistakes = {why: right(case, **change) for why, change in PROMISE_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    near = all(
        abs(one.found - one.expected) < NEAR * (case.win - case.lose) for one, case in zip(cases, machines, strict=True)
    )
    compare_all(cases, lambda wrong: DRAWN if near else sum_by_hand(machines[[*wrong].index(True)], chance))
    return "Right: a sum of a few terms, and no dice are thrown."


def exercise_2(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the update of double Q-learning."""
    require_function("double_update", answer, f"{', '.join(Learning._fields[:-1])} and {Learning._fields[-1]}")
    right = partial(doubled, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in DOUBLE_MISTAKES.values())]
    cases = learnings(telling_draw(seed, learnings, rules))
    found, calls = [], []
    for case in cases:
        Q1, Q2, *others = case
        call = f"double_update({Q1.tolist()}, {Q2.tolist()}, {', '.join(map(str, others))})"
        mine = Q1.copy(), Q2.copy()
        with student_code(call):
            answer(*mine, *others)
        found.append(np.stack(mine))
        calls.append(f"{call}{told_less(cost)}")
    if all(np.array_equal(mine, case[:2]) for case, mine in zip(cases, found, strict=True)):
        raise WrongAnswer(
            f"{calls[0]} leaves the tables as they were before: change an entry in place, as in"
            " Q1[state, action] += ..., and return nothing"
        )
    compare_tables(cases, found, calls, DOUBLE_MISTAKES, right, "leave", partial(_one_half, cases, cost))
    return "Right: who chooses the action does not say what it is worth."


def _one_half(cases: Sequence[Learning], cost: float, wrong: Sequence[bool]) -> str:
    """Say that only one of the two tables learns as it should, if that is so; else what comes out by hand.

    It is so if the wrong cases are all those of one table, or all of these that end, or all that go on: fewer may be of
    one table by chance.
    """
    kinds = {(case.first, case.terminated) for case, is_wrong in zip(cases, wrong, strict=True) if is_wrong}
    whole = all(
        is_wrong == ((case.first, case.terminated) in kinds) for case, is_wrong in zip(cases, wrong, strict=True)
    )
    for first, right, other in ((True, "False", "True"), (False, "True", "False")):
        if whole and {of for of, _ in kinds} == {first}:
            return (
                f"it is right where `first` is {right}, and wrong where it is {other}: both halves are the same, but"
                " for the names of the tables"
            )
    return update_by_hand(cases[[*wrong].index(True)], cost)


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the target of maxmin Q-learning."""
    require_function("maxmin_target", answer, "tables, reward, next_state, terminated and discount")
    right = partial(aimed, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in AIM_MISTAKES.values())]
    cases = []
    made = aims(telling_draw(seed, aims, rules))
    for case in made:
        tables, *others = case
        call = f"maxmin_target({tables.tolist()}, {', '.join(map(str, others))})"
        mine = tables.copy()
        with student_code(call):
            found = answer(mine, *others)
        if not np.array_equal(mine, tables):
            raise WrongAnswer(f"{call} changes the tables that it is given: only return the target")
        mistakes = {why: right(case, **change) for why, change in AIM_MISTAKES.items()}
        cases.append(NumberCase(call + told_less(cost), number(call, found), right(case), mistakes))
    compare_all(cases, lambda wrong: target_by_hand(made[[*wrong].index(True)], cost))
    return "Right: pessimistic about each action, and then the best of them."

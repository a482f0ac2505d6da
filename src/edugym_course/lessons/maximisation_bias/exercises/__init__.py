"""The exercises of lesson 17: what the largest mean promises, the update of double Q-learning, and a maxmin target."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Annotated, Any

import numpy as np

from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import UNUSUAL, NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables
from edugym_course.grading.values import number
from edugym_course.lessons.maximisation_bias.exercises.promises import PROMISE_MISTAKES, casinos, promised
from edugym_course.lessons.maximisation_bias.exercises.targets import (
    AIM_MISTAKES,
    DOUBLE_MISTAKES,
    Learning,
    aimed,
    aims,
    doubled,
    learnings,
)

Chance = Annotated[
    float,
    Own(
        tuple(k / 100 for k in (*range(15, 48), *range(53, 86))),
        "In your version a machine wins with the probability {chance}, not 1/2.",
    ),
]
Cost = Annotated[float, step_cost()]


def exercise_1(answer: Any, seed: int, chance: Chance = 0.5) -> str:
    """Check what the largest of several means is on average."""
    require_function("largest_promise", answer, "n_machines, n_tries, win and lose")
    right = partial(promised, chance=chance)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in PROMISE_MISTAKES.values())]
    cases = []
    for case in casinos(telling_draw(seed, casinos, rules)):
        call = f"largest_promise({case.k}, {case.n}, {case.win:g}, {case.lose:g})"
        with student_code(call):
            found = answer(*case)
        mistakes = {why: right(case, **change) for why, change in PROMISE_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases)
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
    compare_tables(cases, found, calls, DOUBLE_MISTAKES, right, "leave", partial(_one_half, cases))
    return "Right: who chooses the action does not say what it is worth."


def _one_half(cases: Sequence[Learning], wrong: Sequence[bool]) -> str:
    """Say that only one of the two tables learns as it should, if that is so; else that no usual mistake is known."""
    for first, right, other in ((True, "False", "True"), (False, "True", "False")):
        if all(case.first == first for case, is_wrong in zip(cases, wrong, strict=True) if is_wrong):
            return (
                f"it is right where `first` is {right}, and wrong where it is {other}: both halves are the same, but"
                " for the names of the tables"
            )
    return UNUSUAL


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the target of maxmin Q-learning."""
    require_function("maxmin_target", answer, "tables, reward, next_state, terminated and discount")
    right = partial(aimed, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in AIM_MISTAKES.values())]
    cases = []
    for case in aims(telling_draw(seed, aims, rules)):
        tables, *others = case
        call = f"maxmin_target({tables.tolist()}, {', '.join(map(str, others))})"
        mine = tables.copy()
        with student_code(call):
            found = answer(mine, *others)
        if not np.array_equal(mine, tables):
            raise WrongAnswer(f"{call} changes the tables that it is given: only return the target")
        mistakes = {why: right(case, **change) for why, change in AIM_MISTAKES.items()}
        cases.append(NumberCase(call + told_less(cost), number(call, found), right(case), mistakes))
    compare_all(cases)
    return "Right: pessimistic about each action, and then the best of them."

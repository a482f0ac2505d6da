"""The exercises of lesson 17: what the largest mean promises, the update of double Q-learning, and a maxmin target."""

from collections.abc import Callable, Mapping
from functools import partial
from math import comb
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES, telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables
from edugym_course.grading.values import number

N_STATES, N_ACTIONS = 3, 3
Chance = Annotated[
    float,
    Own(
        tuple(k / 100 for k in (*range(15, 48), *range(53, 86))),
        "In your version a machine wins with the probability {chance}, not 1/2.",
    ),
]
Cost = Annotated[float, step_cost()]


class Machines(NamedTuple):
    """A casino for exercise 1: k machines, of which each was tried n times, and what a try may pay."""

    k: int
    n: int
    win: float
    lose: float


def promised(
    case: Machines,
    *,
    power: str = "k",
    over: str = "differences",
    first: int = 0,
    without: int = 0,
    per: str = "try",
    times: str = "one",
    chance: float = 0.5,
) -> float:
    """Return what the largest mean is on average; other arguments than the defaults are mistakes."""
    k, n, win, lose = case
    p = np.array([comb(n, wins) * chance**wins * (1 - chance) ** (n - wins) for wins in range(n + 1)])
    means = np.array([wins * win + (n - wins) * lose for wins in range(n + 1)]) / (n if per == "try" else 1)
    at_most = np.cumsum(p)
    at_most = 1 - (1 - at_most) ** k if power == "smallest" else at_most ** {"k": k, "one": 1, "n": n}[power]
    weights = {
        "differences": np.diff(at_most, prepend=0.0),
        "at most": at_most,
        "of one": p**k,
        "times k": k * p,
    }[over]
    kept = slice(first, n + 1 - without)
    return float(means[kept] @ weights[kept]) * (k if times == "k" else 1)


PROMISE_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "that is the mean of one machine; the largest of several is larger: F(x) to the power of the number of machines": {
        "power": "one"
    },
    "F is raised to the power of the number of tries; raise it to that of the machines": {"power": "n"},
    "that is what the *smallest* of the means is on average": {"power": "smallest"},
    "each value is weighed by F(x)^k, the probability that the largest mean is *at most* x; take off what it was for"
    " the value before": {"over": "at most"},
    "each value is weighed by p(x)^k, the probability that *all* machines have this mean": {"over": "of one"},
    "each value is weighed by k p(x), as if only one machine could be lucky at a time": {"over": "times k"},
    "the payoffs are added up; a mean is divided by the number of tries": {"per": "all"},
    "the value with n wins is left out: there are n + 1 values, from 0 wins to n": {"without": 1},
    "the value without a win is left out: there are n + 1 values, from 0 wins to n": {"first": 1},
    "the sum is multiplied by the number of machines; only one of them has the largest mean": {"times": "k"},
}


def _casinos(rng: np.random.Generator) -> list[Machines]:
    """Make up casinos: one with one try, one with one machine, and larger ones."""
    sizes = ((2, 1), (1, 3), (3, 2), (2, 4), (5, 3))
    return [Machines(k, n, float(rng.integers(1, 6)), -float(rng.integers(1, 6))) for k, n in sizes]


def exercise_1(answer: Any, seed: int, chance: Chance = 0.5) -> str:
    """Check what the largest of several means is on average."""
    require_function("largest_promise", answer, "n_machines, n_tries, win and lose")
    right = partial(promised, chance=chance)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in PROMISE_MISTAKES.values())]
    cases = []
    for case in _casinos(telling_draw(seed, _casinos, rules)):
        call = f"largest_promise({case.k}, {case.n}, {case.win:g}, {case.lose:g})"
        with student_code(call):
            found = answer(*case)
        mistakes = {why: right(case, **change) for why, change in PROMISE_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases)
    return "Right: a sum of a few terms, and no dice are thrown."


class Learning(NamedTuple):
    """A step for exercise 2, and the tables before it."""

    Q1: Reals
    Q2: Reals
    first: bool
    state: int
    action: int
    reward: float
    next_state: int
    terminated: bool
    learning_rate: float
    discount: float


def doubled(
    case: Learning,
    *,
    value: str = "the other",
    changed: str = "right",
    end: str = "right",
    gamma: str = "right",
    less: str = "own",
    step: str = "right",
    cost: float = 0.0,
) -> Reals:
    """Return both tables after the update, shape (2, S, A); other arguments than the defaults are mistakes."""
    tables = np.stack([case.Q1, case.Q2])
    chosen = {"right": not case.first, "first": False, "second": True, "other": case.first, "both": not case.first}
    entry = case.state, case.action
    for i in (0, 1) if changed == "both" else (int(chosen[changed]),):
        own, other = np.stack([case.Q1, case.Q2])[[i, 1 - i]]
        here, there = own[case.next_state], other[case.next_state]
        following = {
            "the other": there[here.argmax()],
            "own": here.max(),
            "the other's maximum": there.max(),
            "swapped": here[there.argmax()],
            "mean": (here + there).max() / 2,
            "smaller": np.minimum(here, there).max(),
        }[value]
        going_on = {"right": not case.terminated, "always": True, "never": False}[end]
        rate = case.discount if gamma == "right" else 1.0
        target = case.reward - cost + (rate * float(following) if going_on else 0.0)
        old = (own if less == "own" else other)[entry]
        tables[(i, *entry)] += {
            "right": case.learning_rate * (target - old),
            "whole": target - old,
            "only": case.learning_rate * target,
        }[step]
    return tables


DOUBLE_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the table that chooses the action also says what it is worth: that is Q-learning with two tables": {
        "value": "own"
    },
    "that is the largest value of the other table; the action is the best one of the table that learns": {
        "value": "the other's maximum"
    },
    "the roles are swapped: the table that learns chooses the action, and the other says what it is worth": {
        "value": "swapped"
    },
    "the tables are averaged before the maximum; one chooses, and the other says what that is worth": {"value": "mean"},
    "the smaller value of both counts: that is maxmin Q-learning": {"value": "smaller"},
    "both tables are changed; `first` says which one learns": {"changed": "both"},
    "Q1 is changed, whatever `first` says": {"changed": "first"},
    "Q2 is changed, whatever `first` says": {"changed": "second"},
    "the other table is changed: Q1 learns if `first` is True": {"changed": "other"},
    "what comes after the end is counted: where `terminated` is True the target is the reward alone": {"end": "always"},
    "what comes after a step is left out": {"end": "never"},
    "the discount is left out": {"gamma": "one"},
    "the old value is taken from the other table": {"less": "other"},
    "the learning rate is left out": {"step": "whole"},
    "− Q(S, A) is left out: the target takes the place of the error": {"step": "only"},
}


def _learnings(rng: np.random.Generator) -> list[Learning]:
    """Make up steps: for both tables, and one that ends."""
    made = []
    for first, terminated in ((True, False), (False, False), (True, True), (False, False), (True, False)):
        Q1, Q2 = (rng.permuted(np.arange(-4.0, 5.0)).reshape(N_STATES, N_ACTIONS) for _ in range(2))
        state, next_state = rng.choice(N_STATES, 2, replace=False).tolist()
        action, reward = int(rng.integers(N_ACTIONS)), float(rng.integers(-3, 6))
        rates = float(rng.choice(LEARNING_RATES)), float(rng.choice(DISCOUNTS))
        made.append(Learning(Q1, Q2, first, state, action, reward, next_state, terminated, *rates))
    return made


def exercise_2(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the update of double Q-learning."""
    require_function("double_update", answer, f"{', '.join(Learning._fields[:-1])} and {Learning._fields[-1]}")
    right = partial(doubled, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in DOUBLE_MISTAKES.values())]
    cases = _learnings(telling_draw(seed, _learnings, rules))
    found, calls = [], []
    for case in cases:
        Q1, Q2, *others = case
        call = f"double_update({Q1.tolist()}, {Q2.tolist()}, {', '.join(map(str, others))})"
        mine = Q1.copy(), Q2.copy()
        with student_code(call):
            answer(*mine, *others)
        found.append(np.stack(mine))
        calls.append(f"after {call} the tables{told_less(cost)}")
    if all(np.array_equal(mine, case[:2]) for case, mine in zip(cases, found, strict=True)):
        raise WrongAnswer(
            f"{calls[0]} are what they were before: change an entry in place, as in Q1[state, action] += ..., and"
            " return nothing"
        )
    compare_tables(cases, found, calls, DOUBLE_MISTAKES, right)
    return "Right: who chooses the action does not say what it is worth."


class Aim(NamedTuple):
    """The tables and the outcome of a step, for exercise 3."""

    tables: Reals
    reward: float
    next_state: int
    terminated: bool
    discount: float


def aimed(
    case: Aim,
    *,
    rule: str = "maxmin",
    end: str = "right",
    gamma: str = "right",
    cost: float = 0.0,
) -> float:
    """Return the target of maxmin Q-learning; other arguments than the defaults are mistakes."""
    row = case.tables[:, case.next_state]
    value = {
        "maxmin": row.min(axis=0).max(),
        "minmax": row.max(axis=1).min(),
        "mean": row.mean(axis=0).max(),
        "largest": row.max(),
        "smallest": row.min(),
        "maxmax": row.max(axis=0).min(),
        "other axis": row.min(axis=1).max(),
        "first": row[0].max(),
        "all": case.tables.min(axis=0).max(),
    }[rule]
    going_on = {"right": not case.terminated, "always": True, "never": False}[end]
    rate = case.discount if gamma == "right" else 1.0
    return case.reward - cost + (rate * float(value) if going_on else 0.0)


AIM_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the maximum of each table is taken first, and the smallest of these; first take the smallest value of each"
    " action": {"rule": "minmax"},
    "the tables are averaged; take the smallest value of each action": {"rule": "mean"},
    "that is the largest value of all tables; first take the smallest value of each action": {"rule": "largest"},
    "that is the smallest value of all; take the largest of the actions' smallest values": {"rule": "smallest"},
    "the largest value of each action is taken, and the smallest of these: it is the other way round": {
        "rule": "maxmax"
    },
    "the minimum goes over the actions of each table; it goes over the tables, for each action": {"rule": "other axis"},
    "only the first table counts": {"rule": "first"},
    "the maximum goes over all states; take the row of the next state": {"rule": "all"},
    "what comes after the end is counted: where `terminated` is True the target is the reward alone": {"end": "always"},
    "what comes after a step is left out": {"end": "never"},
    "the discount is left out": {"gamma": "one"},
}


def _aims(rng: np.random.Generator) -> list[Aim]:
    """Make up tables, two, three or four, and outcomes of which one ends."""
    return [
        Aim(
            rng.integers(-9, 10, (n, N_STATES, N_ACTIONS)).astype(float),
            float(rng.integers(-3, 6)),
            int(rng.integers(N_STATES)),
            terminated,
            float(rng.choice(DISCOUNTS)),
        )
        for n, terminated in ((2, False), (3, False), (3, True), (4, False), (2, False))
    ]


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the target of maxmin Q-learning."""
    require_function("maxmin_target", answer, "tables, reward, next_state, terminated and discount")
    right = partial(aimed, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in AIM_MISTAKES.values())]
    cases = []
    for case in _aims(telling_draw(seed, _aims, rules)):
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

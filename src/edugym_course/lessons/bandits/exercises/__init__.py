"""The exercises of lesson 0b: the regret of given pulls, upper confidence bounds, and the gradient bandit's update."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import pairwise
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import UNUSUAL, NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables, table_of
from edugym_course.grading.values import UNUSUAL_NUMBER, number, require_unchanged, same
from edugym_course.lessons.bandits.exercises.bounds import BOUND_MISTAKES, Known, bounds, made_up_arms
from edugym_course.lessons.bandits.exercises.gradient import GRADIENT_MISTAKES, made_up_pulls, preferred

Fee = Annotated[
    float,
    Own(
        tuple(k / 100 for k in range(3, 303, 5)),
        "In your version each pull of another arm than the one before costs {cost} besides.",
    ),
]
Before = Annotated[
    int,
    Own(
        tuple(range(5, 66)),
        "In your version {before} pulls were made before, which nobody noted: N does not have them, but t counts them.",
    ),
]
Cost = Annotated[float, step_cost()]


PAYS, GAP = 0.6, 0.2
"""The probability of the best arm of the lesson, and its gap; the exercise has others."""


class Played(NamedTuple):
    """A bandit for exercise 1, and the arms that were pulled."""

    p: list[float]
    arms: list[int]


def lost(
    case: Played,
    *,
    best: str = "all",
    each: str = "gap",
    over: str = "sum",
    first: int = 0,
    last: int = 0,
    cost: float = 0.0,
) -> float:
    """Return the regret of some pulls; other arguments than the defaults are mistakes."""
    p, arms = case
    pulled = [p[arm] for arm in arms[first : len(arms) - last]]
    top = {
        "all": max(p),
        "pulled": max(p[arm] for arm in arms),
        "mean": sum(p) / len(p),
        "one": 1.0,
        "worst": min(p),
        "arm 0": p[0],
        "lesson's": PAYS,
        "number": float(np.argmax(p)),
    }[best]
    gaps = {
        "gap": [top - mine for mine in pulled],
        "wrong": [float(mine < top) for mine in pulled],
        "lesson's": [GAP * (mine < top) for mine in pulled],
        "earned": pulled,
        "negative": [mine - top for mine in pulled],
        "squared": [(top - mine) ** 2 for mine in pulled],
        "best": [top for _ in pulled],
        "second": [(top - sorted(p)[-2]) * (mine < top) for mine in pulled],
        "random": [top - sum(p) / len(p) for _ in pulled],
    }[each]
    changes = sum(arm != before for before, arm in pairwise(arms))
    total = {
        "sum": sum(gaps),
        "mean": sum(gaps) / len(arms),
        "last": gaps[-1] if gaps else 0.0,
        "first": gaps[0] if gaps else 0.0,
        "kinds": sum(top - p[arm] for arm in set(arms)),
        "arms": sum(top - one for one in p),
    }[over]
    return total + cost * changes


REGRET_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "it is compared with the best arm that was *pulled*; the best of all may never have been": {"best": "pulled"},
    "it is compared with the mean of all arms; compare with the best one": {"best": "mean"},
    "it is compared with an arm that always pays; compare with the best one that there is": {"best": "one"},
    "it is compared with 0.6, which the best arm of the lesson pays; take the largest entry of p": {"best": "lesson's"},
    "each pull of a worse arm costs 0.2, as in the lesson; it costs the gap of its own arm": {"each": "lesson's"},
    "the *number* of the best arm is taken; take its probability": {"best": "number"},
    "that is the number of pulls of worse arms; each costs as much as its arm pays less": {"each": "wrong"},
    "that is what the pulls earn on average; the regret is what the best arm would have earned more": {
        "each": "earned"
    },
    "that is what the best arm would have earned on average; subtract what the pulls earn": {"each": "best"},
    "each pull of a worse arm costs as much as one of the second best; it costs the gap of its own arm": {
        "each": "second"
    },
    "that is the regret of as many random pulls; what counts is which arms were pulled": {"each": "random"},
    "it is compared with the worst arm; compare with the best one": {"best": "worst", "each": "negative"},
    "it is compared with arm 0; compare with the best one, whichever that is": {"best": "arm 0"},
    "the sign is wrong: a pull of a worse arm makes the regret larger": {"each": "negative"},
    "the differences are squared": {"each": "squared"},
    "that is the regret of a pull on average; add up the regret of all": {"over": "mean"},
    "that is the regret of the last pull; add up the regret of all": {"over": "last"},
    "that is the regret of the first pull: does the `return` stand inside the loop?": {"over": "first"},
    "that is the regret of one pull of each arm; what counts is which arms were pulled, and how often": {
        "over": "arms"
    },
    "each arm counts once; it counts as often as it was pulled": {"over": "kinds"},
    "the first pull is left out": {"first": 1},
    "the last pull is left out": {"last": 1},
}


def _played(rng: np.random.Generator) -> list[Played]:
    """Make up bandits; of one, the best arm is never pulled, and of one it is the only arm that is."""
    made = []
    for n_arms, n_pulls in ((3, 4), (4, 7), (5, 6), (2, 5)):
        p = (rng.choice(19, n_arms, replace=False) / 20 + 0.05).round(2).tolist()
        made.append(Played(p, rng.integers(n_arms, size=n_pulls).tolist()))
    worse = [arm for arm in range(5) if arm != int(np.argmax(made[2].p))]
    made[2] = made[2]._replace(arms=rng.choice(worse, 6).tolist())
    return [*made, Played([0.5, 0.25], [0, 0])]


DRAWN = "rewards were drawn with these probabilities; luck does not count, so subtract p of the arm that was pulled"


def _are_drawn(made: Sequence[Played], found: Sequence[float]) -> bool:
    """Whether numbers are what the best arms would have earned, less whole numbers of rewards."""
    rewards = [len(arms) * max(p) - one for (p, arms), one in zip(made, found, strict=True)]
    return all(same(one, round(one)) for one in rewards) and any(round(one) for one in rewards)


def exercise_1(answer: Any, seed: int, cost: Fee = 0.0) -> str:
    """Check the regret of given pulls."""
    require_function("total_regret", answer, "p and arms")
    right = partial(lost, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in REGRET_MISTAKES.values())]
    made, cases = _played(telling_draw(seed, _played, rules)), list[NumberCase]()
    for case in made:
        call = f"total_regret({case.p}, {case.arms})"
        with student_code(call):
            found = answer(p := list(case.p), arms := list(case.arms))
        require_unchanged(call, "p", p, case.p)
        require_unchanged(call, "arms", arms, case.arms)
        mistakes = {why: right(case, **change) for why, change in REGRET_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases, DRAWN if cost == 0 and _are_drawn(made, [case.found for case in cases]) else UNUSUAL_NUMBER)
    return "Right: no reward was needed. Luck is not in it."


NEVER = "the bound of an arm that was never pulled is np.inf itself, and no other number"


def exercise_2(answer: Any, seed: int, before: Before = 0) -> str:
    """Check upper confidence bounds."""
    require_function("upper_bounds", answer, "Q, N and c")
    right = partial(bounds, before=before)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in BOUND_MISTAKES.values())]
    cases = made_up_arms(telling_draw(seed, made_up_arms, rules))
    found, calls = [], []
    for case in cases:
        call = f"upper_bounds(np.array({case.Q.tolist()}), np.array({case.N.tolist()}), {case.c:g})"
        mine = case.Q.copy(), case.N.copy()
        with student_code(call):
            given = answer(*mine, case.c)
        if not (np.array_equal(mine[0], case.Q) and np.array_equal(mine[1], case.N)):
            raise WrongAnswer(f"{call} changes the arrays that it is given: only return the bounds")
        found.append(_numbers(call, given, case))
        calls.append(call)
    pulled = [case.N > 0 for case in cases]
    fits = [
        np.allclose(mine[one], right(case)[one], 1e-3) for case, mine, one in zip(cases, found, pulled, strict=True)
    ]
    compare_tables(cases, found, calls, BOUND_MISTAKES, right, otherwise=lambda wrong: NEVER if all(fits) else UNUSUAL)
    return "Right: the less is known of an arm, the more it may be worth."


def _numbers(call: str, given: Any, case: Known) -> Reals:
    """Return what an answer gives as an array of numbers, of which some may be infinite."""
    if given is not None and np.ndim(given) == 0:
        raise WrongAnswer(f"{call} gives a single value: return the bounds of all arms, and choose none of them")
    table = table_of(call, given, (len(case.Q),), finite=False)
    if np.isnan(table).any():
        raise WrongAnswer(
            f"{call} gives {table.tolist()}: nan comes from 0 divided by 0, or from the root of a negative number"
        )
    return table


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the update of the gradient bandit."""
    require_function("gradient_update", answer, "H, arm, reward, mean and learning_rate")
    right = partial(preferred, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in GRADIENT_MISTAKES.values())]
    cases = made_up_pulls(telling_draw(seed, made_up_pulls, rules))
    found, calls = [], []
    for case in cases:
        H, *others = case
        call = f"gradient_update(np.array({H.tolist()}), {', '.join(map(str, others))})"
        mine = H.copy()
        with student_code(call):
            answer(mine, *others)
        found.append(table_of(call, mine, H.shape))
        calls.append(f"after {call} H{told_less(cost)}")
    if all(np.array_equal(mine, case.H) for case, mine in zip(cases, found, strict=True)):
        raise WrongAnswer(
            f"{calls[0]} is what it was before: change the array in place, as in H += ..., and return nothing; H ="
            " H + ... makes a new array, which nobody sees"
        )
    compare_tables(cases, found, calls, GRADIENT_MISTAKES, right, "become")
    return "Right: what one arm gains in preference, the others lose together."

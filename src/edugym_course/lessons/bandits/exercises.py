"""The exercises of lesson 0b: the regret of given pulls, upper confidence bounds, and the gradient bandit's update."""

from collections.abc import Callable, Mapping
from functools import partial
from itertools import pairwise
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Integers, Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import LEARNING_RATES, telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.tables import compare_tables, table_of
from edugym_course.grading.values import number

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
        "number": float(np.argmax(p)),
    }[best]
    gaps = {
        "gap": [top - mine for mine in pulled],
        "wrong": [float(mine < top) for mine in pulled],
        "earned": pulled,
        "negative": [mine - top for mine in pulled],
        "squared": [(top - mine) ** 2 for mine in pulled],
    }[each]
    changes = sum(arm != before for before, arm in pairwise(arms))
    total = {
        "sum": sum(gaps),
        "mean": sum(gaps) / len(arms),
        "last": gaps[-1] if gaps else 0.0,
        "kinds": sum(top - p[arm] for arm in set(arms)),
    }[over]
    return total + cost * changes


REGRET_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "it is compared with the best arm that was *pulled*; the best of all may never have been": {"best": "pulled"},
    "it is compared with the mean of all arms; compare with the best one": {"best": "mean"},
    "it is compared with an arm that always pays; compare with the best one that there is": {"best": "one"},
    "the *number* of the best arm is taken; take its probability": {"best": "number"},
    "that is the number of pulls of worse arms; each costs as much as its arm pays less": {"each": "wrong"},
    "that is what the pulls earn on average; the regret is what the best arm would have earned more": {
        "each": "earned"
    },
    "the sign is wrong: a pull of a worse arm makes the regret larger": {"each": "negative"},
    "the differences are squared": {"each": "squared"},
    "that is the regret of a pull on average; add up the regret of all": {"over": "mean"},
    "that is the regret of the last pull; add up the regret of all": {"over": "last"},
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


def exercise_1(answer: Any, seed: int, cost: Fee = 0.0) -> str:
    """Check the regret of given pulls."""
    require_function("total_regret", answer, "p and arms")
    right = partial(lost, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in REGRET_MISTAKES.values())]
    cases = []
    for case in _played(telling_draw(seed, _played, rules)):
        call = f"total_regret({case.p}, {case.arms})"
        with student_code(call):
            found = answer(list(case.p), list(case.arms))
        mistakes = {why: right(case, **change) for why, change in REGRET_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), right(case), mistakes))
    compare_all(cases)
    return "Right: no reward was needed. Luck is not in it."


class Known(NamedTuple):
    """What is known of the arms, for exercise 2."""

    Q: Reals
    N: Integers
    c: float


@np.errstate(all="ignore")
def bounds(
    case: Known,
    *,
    root: str = "right",
    log: str = "natural",
    t: str = "right",
    mean: str = "right",
    c: str = "right",
    untried: str = "infinite",
    shared: str = "no",
    before: int = 0,
) -> Reals:
    """Return the upper bounds; other arguments than the defaults are mistakes, of which some give no number."""
    Q, N, factor = case
    steps = {"right": N.sum() + 1, "less": N.sum(), "arms": len(Q), "most": N.max() + 1}[t] + before
    pulls = np.where(N > 0, N, 1).astype(float)
    logarithm: Any = {
        "natural": np.log(steps),
        "ten": np.log10(steps),
        "two": np.log2(steps),
        "none": steps,
        "twice": 2 * np.log(steps),
        "of N": np.log(pulls),
    }[log]
    inside = logarithm / {"no": pulls, "t": steps, "N + 1": pulls + 1}[shared]
    bonus = {
        "right": np.sqrt(inside),
        "none": inside,
        "above": np.sqrt(logarithm) / pulls,
        "below": logarithm / np.sqrt(pulls),
    }[root]
    bonus = {"right": factor * bonus, "inside": np.sqrt(factor * inside), "none": bonus}[c]
    found = {"right": Q + bonus, "none": bonus, "minus": Q - bonus, "times": Q * bonus}[mean]
    never = {"infinite": np.inf, "zero": 0.0, "as one": found, "mean": Q, "low": -np.inf}[untried]
    table: Reals = np.where(N > 0, found, never)
    return table


BOUND_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the square root is missing": {"root": "none"},
    "the square root is taken of ln t only; N(a) stands below it too": {"root": "above"},
    "the square root is taken of N(a) only; ln t stands below it too": {"root": "below"},
    "the logarithm is that to base 10; ln is np.log": {"log": "ten"},
    "the logarithm is that to base 2; ln is np.log": {"log": "two"},
    "the logarithm is missing: t itself stands below the root": {"log": "none"},
    "that is the logarithm of N(a); take that of t, all pulls together": {"log": "of N"},
    "t is the number of pulls so far; the present one counts too": {"t": "less"},
    "t is the number of arms; it counts all pulls, and the present one": {"t": "arms"},
    "t counts the pulls of one arm only; it counts those of all": {"t": "most"},
    "ln t is divided by t; divide it by the pulls of the arm": {"shared": "t"},
    "ln t is doubled, as some books have it; here c alone says how large the bonus is": {"log": "twice"},
    "N(a) + 1 stands in place of N(a)": {"shared": "N + 1"},
    "c stands below the root; it is multiplied with the root": {"c": "inside"},
    "c is left out": {"c": "none"},
    "Q(a) is left out: that is the bonus alone": {"mean": "none"},
    "the bonus is subtracted: that is a *lower* bound": {"mean": "minus"},
    "the mean is multiplied by the bonus; add it": {"mean": "times"},
    "an arm that was never pulled gets 0; its bound is np.inf, so that it comes first": {"untried": "zero"},
    "an arm that was never pulled counts as if it were pulled once; its bound is np.inf": {"untried": "as one"},
    "an arm that was never pulled gets its mean; its bound is np.inf, so that it comes first": {"untried": "mean"},
    "an arm that was never pulled gets −np.inf, and so it comes last; its bound is np.inf": {"untried": "low"},
}


def _known(rng: np.random.Generator) -> list[Known]:
    """Make up means and numbers of pulls; in some cases an arm was never pulled."""
    made = []
    for n_arms, untried in ((3, 0), (4, 1), (2, 0), (5, 2), (3, 3)):
        N = rng.integers(1, 10, n_arms)
        N[rng.choice(n_arms, untried, replace=False)] = 0
        Q = np.where(N > 0, rng.integers(1, 9, n_arms) / 8, 0.5)
        made.append(Known(Q, N, float(rng.choice([0.5, 2.0, 3.0]))))
    return made


def exercise_2(answer: Any, seed: int, before: Before = 0) -> str:
    """Check upper confidence bounds."""
    require_function("upper_bounds", answer, "Q, N and c")
    right = partial(bounds, before=before)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in BOUND_MISTAKES.values())]
    cases = _known(telling_draw(seed, _known, rules))
    found, calls = [], []
    for case in cases:
        call = f"upper_bounds(np.array({case.Q.tolist()}), np.array({case.N.tolist()}), {case.c:g})"
        mine = case.Q.copy(), case.N.copy()
        with student_code(call), np.errstate(all="ignore"):
            given = answer(*mine, case.c)
        if not (np.array_equal(mine[0], case.Q) and np.array_equal(mine[1], case.N)):
            raise WrongAnswer(f"{call} changes the arrays that it is given: only return the bounds")
        found.append(_numbers(call, given, case))
        calls.append(call)
    compare_tables(cases, found, calls, BOUND_MISTAKES, right)
    return "Right: the less is known of an arm, the more it may be worth."


def _numbers(call: str, given: Any, case: Known) -> Reals:
    """Return what an answer gives as an array of numbers, of which some may be infinite."""
    table = table_of(call, given, (len(case.Q),), finite=False)
    if np.isnan(table).any():
        raise WrongAnswer(
            f"{call} gives {table.tolist()}: nan comes from 0 divided by 0, or from the root of a negative number"
        )
    return table


class Paid(NamedTuple):
    """A pull for exercise 3, and the preferences before it."""

    H: Reals
    arm: int
    reward: float
    mean: float
    learning_rate: float


def preferred(
    case: Paid,
    *,
    pi: str = "softmax",
    baseline: str = "mean",
    sign: float = 1.0,
    moved: str = "all",
    rate: str = "right",
    cost: float = 0.0,
) -> Reals:
    """Return the preferences after the update; other arguments than the defaults are mistakes."""
    H, arm, reward, mean, learning_rate = case
    if pi == "moving":
        after = H.copy()
        for one in range(len(H)):
            alone = case._replace(H=after)
            after[one] = preferred(alone, cost=cost)[one]
        return after
    shares = {
        "softmax": np.exp(H) / np.exp(H).sum(),
        "values": H / H.sum() if H.sum() else H,
        "unscaled": np.exp(H),
        "uniform": np.full(len(H), 1 / len(H)),
    }[pi]
    step = {"right": learning_rate, "none": 1.0}[rate] * {
        "mean": reward - cost - mean,
        "none": reward - cost,
        "added": reward - cost + mean,
        "greedy": reward - cost - float(H[arm]),
    }[baseline]
    chosen = np.eye(len(H))[arm]
    direction = {
        "all": chosen - shares,
        "chosen": chosen * (1 - shares),
        "others": (chosen - 1) * shares,
        "only indicator": chosen,
        "minus everywhere": chosen * shares * -1 - (1 - chosen) * shares,
        "plus everywhere": chosen * (1 - shares) + (1 - chosen) * shares,
        "own share": chosen * (1 - shares) - (1 - chosen) * shares[arm],
        "whole": chosen - (1 - chosen) * shares,
        "twice": chosen * (1 - shares) - shares,
    }[moved]
    moved_to: Reals = H + sign * step * direction
    return moved_to


GRADIENT_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "only the arm that was pulled moves; all others move the other way": {"moved": "chosen"},
    "the arm that was pulled does not move": {"moved": "others"},
    "π is left out: only the arm that was pulled moves, by a whole step": {"moved": "only indicator"},
    "1{a = A} is left out, which is 1 for the arm that was pulled": {"moved": "minus everywhere"},
    "the other arms move in the direction of the one that was pulled": {"moved": "plus everywhere"},
    "the arm that was pulled moves back again by π(A): its change is 1 − π(A) in all": {"moved": "twice"},
    "π is worked out again after each change; all changes follow from the preferences before": {"pi": "moving"},
    "all others move by the probability of the arm that was pulled; each moves by its own": {"moved": "own share"},
    "the arm that was pulled moves by a whole step; it moves by 1 − π(A)": {"moved": "whole"},
    "π is H divided by its sum; it is e to the power of H, divided by the sum of that": {"pi": "values"},
    "e to the power of H is not divided by its sum": {"pi": "unscaled"},
    "all arms count as equally probable; π follows from H": {"pi": "uniform"},
    "the mean reward is left out": {"baseline": "none"},
    "the mean reward is added; subtract it": {"baseline": "added"},
    "the preference of the arm stands in place of the mean reward": {"baseline": "greedy"},
    "the sign is wrong: after a good reward the arm gets rarer": {"sign": -1.0},
    "the learning rate is left out": {"rate": "none"},
}


def _paid(rng: np.random.Generator) -> list[Paid]:
    """Make up pulls: of rewards above the mean and below it."""
    made = []
    for n_arms in (2, 3, 4, 3):
        H = rng.choice(np.arange(-4, 5) / 2, n_arms, replace=False)
        reward, mean = rng.choice(np.arange(1.0, 8.0), 2, replace=False)
        made.append(
            Paid(H, int(rng.integers(n_arms)), float(reward), float(mean) + 0.5, float(rng.choice(LEARNING_RATES)))
        )
    return made


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the update of the gradient bandit."""
    require_function("gradient_update", answer, "H, arm, reward, mean and learning_rate")
    right = partial(preferred, cost=cost)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in GRADIENT_MISTAKES.values())]
    cases = _paid(telling_draw(seed, _paid, rules))
    found, calls = [], []
    for case in cases:
        H, *others = case
        call = f"gradient_update(np.array({H.tolist()}), {', '.join(map(str, others))})"
        mine = H.copy()
        with student_code(call):
            answer(mine, *others)
        found.append(table_of(call, mine, H.shape))
        calls.append(f"after {call} the preferences{told_less(cost)}")
    if all(np.array_equal(mine, case.H) for case, mine in zip(cases, found, strict=True)):
        raise WrongAnswer(
            f"{calls[0]} are what they were before: change the array in place, as in H -= ..., and return nothing; H ="
            " H - ... makes a new array, which nobody sees"
        )
    compare_tables(cases, found, calls, GRADIENT_MISTAKES, right)
    return "Right: what one arm gains in preference, the others lose together."

"""Exercise 1 of lesson 17: what the largest mean promises, and what the usual mistakes make of it."""

from collections.abc import Mapping
from math import comb
from typing import Any, NamedTuple

import numpy as np

from edugym_course.grading.values import in_brackets


class Machines(NamedTuple):
    """A casino for exercise 1: k machines, of which each was tried n times, and what a try may pay."""

    k: int
    n: int
    win: float
    lose: float


def promised(
    case: Machines,
    *,
    likely: str = "binomial",
    power: str = "k",
    over: str = "differences",
    kept: str = "all",
    pays: str = "mean",
    times: str = "one",
    exchanged: bool = False,
    chance: float = 0.5,
) -> float:
    """Return what the largest mean is on average; other arguments than the defaults are mistakes."""
    k, n, win, lose = case if not exchanged else Machines(case.n, case.k, case.win, case.lose)
    w, orders = np.arange(n + 1), np.array([comb(n, wins) for wins in range(n + 1)])
    p = {
        "binomial": orders * chance**w * (1 - chance) ** (n - w),
        "one order": chance**w * (1 - chance) ** (n - w),
        "orders": 1.0 * orders,
        "of k": orders * chance**w * (1 - chance) ** (k - 1.0 * w),
        "equally": np.full(n + 1, 1 / (n + 1)),
        "wins only": orders * chance**w,
        "of machines": np.array([comb(k, wins) * chance**wins * (1 - chance) ** (k - wins) for wins in range(n + 1)]),
    }[likely]
    means = {
        "mean": (w * win + (n - w) * lose) / n,
        "sum": w * win + (n - w) * lose,
        "of machines": (w * win + (n - w) * lose) / k,
        "minus": (w * win - (n - w) * lose) / n,
        "wins": w * win / n,
        "too many": (w * win + (n - w) * lose) / (n + 1),
        "lost share": w * win + (n - w) * lose / n,
        "nothing": np.ones(n + 1),
        "win": np.full(n + 1, win),
    }[pays]
    at_most = np.cumsum(p) - (p[0] if kept == "F from 1" else 0.0)
    one = at_most
    at_most = 1 - (1 - at_most) ** k if power == "smallest" else at_most ** {"k": k, "one": 1, "n": n}[power]
    weights = {
        "differences": np.diff(at_most, prepend=0.0),
        "half raised": at_most - np.append(0.0, one[:-1]),
        "not added up": np.diff(p**k, prepend=0.0),
        "late": np.diff(np.append(0.0, at_most[:-1]), prepend=0.0),
        "backwards": -np.diff(at_most, prepend=0.0),
        "wrapped": at_most - np.roll(at_most, 1),
        "density": k * p * at_most ** ((k - 1) / k),
        "at most": at_most,
        "of one": p**k,
        "times k": k * p,
    }[over]
    terms = {
        "all": slice(None),
        "no first": slice(1, None),
        "F from 1": slice(1, None),
        "no last": slice(-1),
        "first": slice(1),
        "last": slice(-1, None),
    }[kept]
    total = float(means[terms] @ weights[terms]) * {"one": 1, "k": k, "1/k": 1 / k}.get(times, 1)
    return total - float(p @ means) if times == "less the mean" else total


def sum_by_hand(case: Machines, chance: float) -> str:
    """Return what the sum of a case is made of, for the sentence."""
    w = np.arange(case.n + 1)
    at_most = np.cumsum(
        [comb(case.n, wins) * chance**wins * (1 - chance) ** (case.n - wins) for wins in range(case.n + 1)]
    )
    means, weights = (w * case.win + (case.n - w) * case.lose) / case.n, np.diff(at_most**case.k, prepend=0.0)
    return (
        f"the values x are {in_brackets(means)} here, F of them {in_brackets(at_most)}, and what F^{case.k} adds at"
        f" each {in_brackets(weights)}: compare these with yours"
    )


PROMISE_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "that is the mean of one machine; the largest of several is larger: F(x) to the power of the number of machines": {
        "power": "one"
    },
    "F is raised to the power of the number of tries; raise it to that of the machines": {"power": "n"},
    "that is what the *smallest* of the means is on average (or is x_w the mean with w losses?)": {"power": "smallest"},
    "each value is weighed by F(x)^k, the probability that the largest mean is *at most* x; take off what it was for"
    " the value before": {"over": "at most"},
    "each value is weighed by p(x)^k, the probability that *all* machines have this mean": {"over": "of one"},
    "each value is weighed by k p(x), as if only one machine could be lucky at a time": {"over": "times k"},
    "F(x)^k less F of the value before, which is not raised: take off its power too": {"over": "half raised"},
    "F(x) is the probability of *at most* x: add up the probabilities of all values so far": {"over": "not added up"},
    "the sign is wrong: F(x)^k less what it was for the value before, and not the other way round": {
        "over": "backwards"
    },
    "F before the first value is 0; in Python the index -1 is that of the *last* entry": {"over": "wrapped"},
    "k p F(x)^(k - 1) is right for a density; F grows in steps here, so take differences of F(x)^k": {
        "over": "density"
    },
    "the number of machines and that of tries are swapped": {"exchanged": True},
    "F is added up after the term; for x it must hold the probability of *at most* x": {"over": "late"},
    "the means are divided by n + 1; there are n tries": {"pays": "too many"},
    "parentheses are missing: the whole sum of payoffs is divided by n": {"pays": "lost share"},
    "the values x are left out; the weights alone add up to 1": {"pays": "nothing"},
    "that is the bias, the promise less the mean of one machine; the promise itself is asked": {
        "times": "less the mean"
    },
    "the sum is divided by the number of machines; it is what the largest mean is already": {"times": "1/k"},
    "the probability of no win is left out of F: begin with 0 wins": {"kept": "F from 1"},
    "0.5 is raised to the power of the number of machines; one order of n tries has the probability 0.5^n": {
        "likely": "of k"
    },
    "the payoffs are added up; a mean is divided by the number of tries": {"pays": "sum"},
    "the payoffs are divided by the number of machines; the mean of one machine is over its n tries": {
        "pays": "of machines"
    },
    "a loss is subtracted, but `lose` has its sign already": {"pays": "minus"},
    "what the lost tries pay is left out": {"pays": "wins"},
    "that is the larger payoff itself; it is the mean only if all tries of a machine are wins": {"pays": "win"},
    "comb(n, w) is left out: w wins come in so many orders": {"likely": "one order"},
    "comb(n, w) alone is no probability: multiply it by that of one order, 0.5^n": {"likely": "orders"},
    "the n + 1 values are not equally likely: w wins have the probability comb(n, w) 0.5^n": {"likely": "equally"},
    "one order of n tries has the probability 0.5^n, and not 0.5 to the power of its wins": {"likely": "wins only"},
    "the wins are counted among the machines; they are those of one machine, which has n tries": {
        "likely": "of machines"
    },
    "the value with n wins is left out: there are n + 1 values, from 0 wins to n": {"kept": "no last"},
    "the value without a win is left out: there are n + 1 values, from 0 wins to n": {"kept": "no first"},
    "only the first term counts, the value without a win: does `return` stand inside the loop?": {"kept": "first"},
    "only the last term counts, the value with n wins: is `=` written for `+=`?": {"kept": "last"},
    "the sum is multiplied by the number of machines; only one of them has the largest mean": {"times": "k"},
}


def casinos(rng: np.random.Generator) -> list[Machines]:
    """Make up casinos: one with one try, one with one machine, and larger ones."""
    sizes = ((2, 1), (1, 3), (3, 2), (2, 4), (5, 3))
    return [Machines(k, n, float(rng.integers(1, 6)), -float(rng.integers(1, 6))) for k, n in sizes]

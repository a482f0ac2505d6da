"""Exercise 2 of lesson 0b: upper confidence bounds, the usual mistakes, and what the arms are known for."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Integers, Reals


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
    counted: Mapping[str, Any] = {
        "right": N.sum() + 1,
        "less": N.sum(),
        "more": N.sum() + 2,
        "arms": len(Q),
        "arms + 1": len(Q) + 1,
        "most": N.max() + 1,
        "own": N + 1,
        "running": N.cumsum() + 1,
    }
    steps = counted[t] + before
    pulls = np.where(N > 0, N, 1).astype(float)
    logarithm: Any = {
        "natural": np.log(steps),
        "ten": np.log10(steps),
        "two": np.log2(steps),
        "none": steps,
        "twice": 2 * np.log(steps),
        "of N": np.log(pulls),
    }[log]
    inside = logarithm / {"no": pulls, "t": steps, "N + 1": N + 1}[shared]
    bonus = {
        "right": np.sqrt(inside),
        "none": inside,
        "above": np.sqrt(logarithm) / pulls,
        "below": logarithm / np.sqrt(pulls),
        "upside down": np.sqrt(1 / inside),
    }[root]
    bonus = {"right": factor * bonus, "inside": np.sqrt(factor * inside), "none": bonus}[c]
    found = {"right": Q + bonus, "none": bonus, "minus": Q - bonus, "times": Q * bonus, "scaled": factor * Q + bonus}[
        mean
    ]
    never = {"infinite": np.inf, "zero": 0.0, "as one": found, "mean": Q, "low": -np.inf}.get(untried, np.inf)
    known = N.all() if untried == "all" else N > 0
    table: Reals = np.where(known, found, never)
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
    "t is one more than the number of arms; it is one more than that of all pulls": {"t": "arms + 1"},
    "t is one too large: is 1 added twice?": {"t": "more"},
    "t counts the pulls of one arm only; it counts those of all": {"t": "most"},
    "each arm has a t of its own, with its own pulls; t counts those of all": {"t": "own"},
    "t grows from arm to arm; add up the pulls of all arms first": {"t": "running"},
    "ln t is divided by t; divide it by the pulls of the arm": {"shared": "t"},
    "ln t is doubled, as some books have it; here c alone says how large the bonus is": {"log": "twice"},
    "N(a) and t have changed places": {"log": "of N", "shared": "t"},
    "the fraction below the root is upside down": {"root": "upside down"},
    "N(a) + 1 stands in place of N(a)": {"shared": "N + 1"},
    "1 is added to every N(a), so that nothing is divided by 0; leave N(a) as it is, and give an arm that was never"
    " pulled the bound np.inf": {"shared": "N + 1", "untried": "as one"},
    "the mean is multiplied by c too; c belongs to the root alone": {"mean": "scaled"},
    "c stands below the root; it is multiplied with the root": {"c": "inside"},
    "c is left out": {"c": "none"},
    "Q(a) is left out: that is the bonus alone": {"mean": "none"},
    "the bonus is subtracted: that is a *lower* bound": {"mean": "minus"},
    "the mean is multiplied by the bonus; add it": {"mean": "times"},
    "an arm that was never pulled gets 0; its bound is np.inf, so that it comes first": {"untried": "zero"},
    "an arm that was never pulled counts as if it were pulled once; its bound is np.inf": {"untried": "as one"},
    "an arm that was never pulled gets its mean; its bound is np.inf, so that it comes first": {"untried": "mean"},
    "as long as one arm was never pulled, all bounds are np.inf; each other arm has a bound of its own": {
        "untried": "all"
    },
    "an arm that was never pulled gets −np.inf, and so it comes last; its bound is np.inf": {"untried": "low"},
}


def made_up_arms(rng: np.random.Generator) -> list[Known]:
    """Make up means and numbers of pulls; in some cases an arm was never pulled."""
    made = []
    for n_arms, untried in ((3, 0), (4, 1), (2, 0), (5, 2), (3, 3)):
        N = rng.integers(1, 10, n_arms)
        N[rng.choice(n_arms, untried, replace=False)] = 0
        Q = np.where(N > 0, rng.integers(1, 9, n_arms) / 8, 0.5)
        made.append(Known(Q, N, float(rng.choice([0.5, 2.0, 3.0]))))
    return made

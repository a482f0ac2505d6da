"""Exercises 2 and 3 of lesson 12: the closest action, the price of a step, and the usual mistakes in both."""

from collections.abc import Callable, Mapping

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.lessons.objectives.methods import LIMIT, PRICE_RATE

Choice = tuple[Reals, int, Reals, Reals]
"""A table Q of shape (states, actions, 2), a state, weights and the utopian point."""


def _distances(Q: Reals, s: int, w: Reals, z: Reals) -> Reals:
    return np.asarray(w * np.abs(z - Q[s]))


def _among(some: slice, distances: Reals) -> Reals:
    """Return the distances of some actions, and infinity for the others."""
    kept = np.full(len(distances), np.inf)
    kept[some] = distances[some]
    return kept


CLOSEST_MISTAKES: Mapping[str, Callable[[Reals, int, Reals, Reals], Reals]] = {
    "the action that is *farthest* is taken": lambda Q, s, w, z: -_distances(Q, s, w, z).max(axis=1),
    "the distances of the objectives are added up; only the largest counts": lambda Q, s, w, z: _distances(
        Q, s, w, z
    ).sum(axis=1),
    "the *smallest* distance of an action counts; it should be the largest of its objectives": (
        lambda Q, s, w, z: _distances(Q, s, w, z).min(axis=1)
    ),
    "the weights are left out": lambda Q, s, w, z: np.abs(z - Q[s]).max(axis=1),
    "the distances are divided by the weights, or each has the weight of the other objective": lambda Q, s, w, z: (
        np.abs(z - Q[s]) / w
    ).max(axis=1),
    "the absolute value is left out: a value beyond the utopian point is also at a distance": lambda Q, s, w, z: (
        w * (z - Q[s])
    ).max(axis=1),
    "the sign is wrong, and the absolute value is left out: that is Q − z": lambda Q, s, w, z: (w * (Q[s] - z)).max(
        axis=1
    ),
    "the values are weighted before they are taken from z; weigh the distances": lambda Q, s, w, z: np.abs(
        z - w * Q[s]
    ).max(axis=1),
    "z and Q are added; a distance is a difference": lambda Q, s, w, z: (w * np.abs(z + Q[s])).max(axis=1),
    "only z is weighted; weigh the distances": lambda Q, s, w, z: np.abs(w * z - Q[s]).max(axis=1),
    "the differences are added up, so that they cancel; take the absolute value of each, and the largest": (
        lambda Q, s, w, z: np.abs((w * (z - Q[s])).sum(axis=1))
    ),
    "squares are added up, each times its weight; only the largest distance counts": lambda Q, s, w, z: (
        w * (z - Q[s]) ** 2
    ).sum(axis=1),
    "the largest distance is taken over the actions, with axis=0; it is that of each action, with axis=1": (
        lambda Q, s, w, z: _distances(Q, s, w, z).max(axis=0)
    ),
    "that is always action 0: does each action have a distance of its own (axis=1)? Does a search begin at infinity,"
    " and does `return` stand below the loop?": lambda Q, s, w, z: np.zeros(1),
    "the squares of the distances are added up, as in the Euclidean distance; only the largest counts": (
        lambda Q, s, w, z: (_distances(Q, s, w, z) ** 2).sum(axis=1)
    ),
    "that is the highest weighted sum, in which z plays no part": lambda Q, s, w, z: -(w * Q[s]).sum(axis=1),
    "that is the action with the best value; d counts both objectives": lambda Q, s, w, z: -Q[s][:, 0],
    "that is the action with the best time; d counts both objectives": lambda Q, s, w, z: -Q[s][:, 1],
    "the distances of the objectives are multiplied; only the largest counts": lambda Q, s, w, z: _distances(
        Q, s, w, z
    ).prod(axis=1),
    "only the first objective counts": lambda Q, s, w, z: _distances(Q, s, w, z)[:, 0],
    "only the second objective counts": lambda Q, s, w, z: _distances(Q, s, w, z)[:, 1],
    "the utopian point is left out: the values themselves are compared": lambda Q, s, w, z: (w * np.abs(Q[s])).max(
        axis=1
    ),
    "the indices of Q have changed places: it looks up Q[:, state], and Q[state] has the actions": lambda Q, s, w, z: (
        _distances(Q.swapaxes(0, 1), s, w, z).max(axis=1)
    ),
    "the absolute value of Q is taken, and not that of the distance z − Q": lambda Q, s, w, z: (
        w * (z - np.abs(Q[s]))
    ).max(axis=1),
    "the difference is squared before it is weighted; take its absolute value": lambda Q, s, w, z: (
        w * (z - Q[s]) ** 2
    ).max(axis=1),
    "the absolute values of z and Q are taken before their difference; take that of the difference": (
        lambda Q, s, w, z: (w * np.abs(np.abs(z) - np.abs(Q[s]))).max(axis=1)
    ),
    "the state is left out: it looks up Q[0]": lambda Q, s, w, z: _distances(Q, 0, w, z).max(axis=1),
    "it looks up another state, Q[state - 1]": lambda Q, s, w, z: _distances(Q, s - 1, w, z).max(axis=1),
    "the distances are weighted after the largest is chosen; weigh each of them first": lambda Q, s, w, z: (
        np.abs(z - Q[s]).max(axis=1) * w[np.abs(z - Q[s]).argmax(axis=1)]
    ),
    "the absolute value of the largest difference is taken; take that of each difference first": lambda Q, s, w, z: (
        np.abs((w * (z - Q[s])).max(axis=1))
    ),
    "the best values in this state stand in the place of `utopian`": lambda Q, s, w, z: _distances(
        Q, s, w, Q[s].max(axis=0)
    ).max(axis=1),
    "the signs are mixed up: that is the largest of max w (Q − z)": lambda Q, s, w, z: -(w * (Q[s] - z)).max(axis=1),
    "what lies beyond the utopian point counts 0; it has a distance, too": lambda Q, s, w, z: (
        w * np.maximum(0.0, z - Q[s])
    ).max(axis=1),
    "the absolute values are subtracted; take that of the difference z − Q": lambda Q, s, w, z: (
        w * (np.abs(z) - np.abs(Q[s]))
    ).max(axis=1),
    "only the objective with the larger weight counts": lambda Q, s, w, z: _distances(Q, s, w, z)[:, w.argmax()],
    "the weights are always 1 and 12, as in the text; use those that are given": lambda Q, s, w, z: _distances(
        Q, s, np.array([1.0, 12.0]), z
    ).max(axis=1),
    "the utopian point is always that of the text, (90, −1); use the one that is given": lambda Q, s, w, z: _distances(
        Q, s, w, np.array([90.0, -1.0])
    ).max(axis=1),
    "the last action is left out: does the range of the loop end too early?": lambda Q, s, w, z: _among(
        slice(None, -1), _distances(Q, s, w, z).max(axis=1)
    ),
    "the first action is left out: does the range of the loop begin too late?": lambda Q, s, w, z: _among(
        slice(1, None), _distances(Q, s, w, z).max(axis=1)
    ),
    "only the first two actions are compared: there may be more of them than objectives": lambda Q, s, w, z: _among(
        slice(2), _distances(Q, s, w, z).max(axis=1)
    ),
    "that is always the last action: does the loop keep the smallest distance so far?": lambda Q, s, w, z: _among(
        slice(-1, None), np.zeros(len(Q[s]))
    ),
}
"""By what number, the lowest of which wins, each mistake compares the actions."""
NO_USUAL_CHOICE = "that is none of the usual mistakes, so work out d(s, a) of two actions by hand"


def choices(rng: np.random.Generator) -> list[Choice]:
    """Make up tables; no two numbers that any rule compares are equal."""
    made = []
    for k in range(24):
        Q = np.round(rng.uniform(-9, 9, (3, 4, 2)), 2)
        Q[..., 0] += 20.0
        if k % 6 == 0:  # all times are good, so that the value decides even if time has the larger weight
            Q[..., 1] = np.round(2.0 + Q[..., 1] / 9, 2)
        weights, z = np.round(rng.uniform(0.3, 3.0, 2), 2), np.array([25.0, 2.0]) + np.round(rng.uniform(-4, 1, 2), 2)
        if k % 6 == 3:  # time has so large a weight that it may decide even if the point lies far out
            weights = np.round(weights * [0.2, 2.0], 2)
        made.append((Q, int(rng.integers(1, 3)), weights, z))
    return made


def chosen(rule: Callable[[Reals, int, Reals, Reals], Reals], case: Choice) -> int:
    """Return the action that a rule takes."""
    return int(rule(*case).argmin())


def right_choice(Q: Reals, s: int, w: Reals, z: Reals) -> Reals:
    """Return the Chebyshev distance of each action from z."""
    return np.asarray(_distances(Q, s, w, z).max(axis=1))


PRICE_MISTAKES: Mapping[str, Callable[[float, float, float, float], float]] = {
    "the sign is wrong: a dive that takes too long makes time dearer": lambda p, n, most, r: max(
        0.0, p - r * (n - most)
    ),
    "the price may not fall below 0: then time would be worth something": lambda p, n, most, r: p + r * (n - most),
    "the rate multiplies the steps alone: put steps − limit in parentheses": lambda p, n, most, r: max(
        0.0, p + r * n - most
    ),
    "the rate stands before the old price; it belongs to the excess": lambda p, n, most, r: max(0.0, r * p + n - most),
    "the rate multiplies the old price, too, and that counts in full": lambda p, n, most, r: max(
        0.0, r * (p + n - most)
    ),
    "the excess is divided by the rate; multiply it": lambda p, n, most, r: max(0.0, p + (n - most) / r),
    "after a dive below the limit the price is 0; it should fall by the rate times what was left": (
        lambda p, n, most, r: 0.0 if n < most else p + r * (n - most)
    ),
    "after a dive within the limit the price is 0; it should fall by the rate times what was left": (
        lambda p, n, most, r: 0.0 if n <= most else p + r * (n - most)
    ),
    "the absolute value of the new price is taken; where it would fall below 0 it is 0": lambda p, n, most, r: abs(
        p + r * (n - most)
    ),
    "the excess is a step too large: a dive of exactly the limit is not too long": lambda p, n, most, r: max(
        0.0, p + r * (n - most + 1)
    ),
    "the excess is a step too small: a dive is too long from limit + 1 on": lambda p, n, most, r: max(
        0.0, p + r * (n - most - 1)
    ),
    "the limit is added; what counts is steps − limit": lambda p, n, most, r: max(0.0, p + r * (n + most)),
    "the price stays as it was; the step is added": lambda p, n, most, r: p,
    "the rate is missing": lambda p, n, most, r: max(0.0, p + (n - most)),
    "the old price is missing: the step is added to it": lambda p, n, most, r: max(0.0, r * (n - most)),
    "the limit is always 7, as in the text; use the `limit` that is given": lambda p, n, most, r: max(
        0.0, p + r * (n - LIMIT)
    ),
    "the rate is always 0.01, as in the text; use the `rate` that is given": lambda p, n, most, r: max(
        0.0, p + PRICE_RATE * (n - most)
    ),
    "the steps lower the price, and they should raise it": lambda p, n, most, r: max(0.0, p - r * (n + most)),
    "the limit is missing: what counts is how far the dive is above it": lambda p, n, most, r: max(0.0, p + r * n),
    "the price only rises; after a short dive it should fall": lambda p, n, most, r: p + r * max(0.0, n - most),
    "the price rises by the same step for each long dive, however long: multiply by the steps beyond the limit": (
        lambda p, n, most, r: max(0.0, p + r * float(np.sign(n - most)))
    ),
    "the price is multiplied; the step is added": lambda p, n, most, r: max(0.0, p * (1 + r * (n - most))),
    "a weighted mean of the old price and the excess: the old price counts in full": lambda p, n, most, r: max(
        0.0, (1 - r) * p + r * (n - most)
    ),
    "the price and the rate have changed places": lambda p, n, most, r: max(0.0, r + p * (n - most)),
    "the steps beyond the limit are squared; the rate times their number is added": lambda p, n, most, r: max(
        0.0, p + r * (n - most) * abs(n - most)
    ),
    "the price may fall to 0, and not only to the rate": lambda p, n, most, r: max(r, p + r * (n - most)),
    "the price only falls; after a long dive it should rise": lambda p, n, most, r: max(
        0.0, p + r * min(0.0, n - most)
    ),
    "that is the smaller one of 0 and the new price: write max": lambda p, n, most, r: min(0.0, p + r * (n - most)),
    "the excess is a share of the limit; it should be a number of steps": lambda p, n, most, r: max(
        0.0, p + r * (n - most) / most
    ),
    "the absolute value of the difference is taken; below the limit the price falls": lambda p, n, most, r: (
        p + r * abs(n - most)
    ),
}
"""The price after a dive, by mistake; the mistakes that come to the same stand once."""


def right_price(p: float, n: float, most: float, r: float) -> float:
    """Return the price after a dive, by dual ascent."""
    return max(0.0, p + r * (n - most))

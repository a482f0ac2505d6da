"""The exact optimum under a constraint: the best returns whose second objective stays above a limit."""

from typing import Any, NamedTuple

import numpy as np

from edugym.checks.parameters import a_number, an_array, in_short
from edugym.mdp.protocol import Reals


class ConstrainedOptimum(NamedTuple):
    """The best that can be had in the first objective, while the second is at least a limit.

    Attributes:
        best: the row of the best single point; None if none keeps the limit.
        shares: shape (n_points,): how often to take each point, if the limit need only be kept *on average*; at most
            two of them are above 0. All are 0 if no average keeps the limit.
        mean: shape (2,): the mean of the points with these shares; NaN if there are none.
    """

    best: int | None
    shares: Reals
    mean: Reals


def constrained_optimum(points: Any, limit: float) -> ConstrainedOptimum:
    """Maximise the first objective under the constraint that the second is at least `limit`.

        front = exact_front(mdp)
        constrained_optimum(front.returns, -7.0)    # at most seven steps

    With the returns of all policies without chance, such as `exact_front` gives, `best` is the best of them, and `mean`
    the best of *all* policies: what a policy with chance earns on average is a mean of what those without chance earn.
    (In terms of linear programming, the optimum under one constraint is a mean of at most two corners.)

    Args:
        points: shape (n_points, 2).
        limit: what the second objective is to be at least.

    Raises:
        ValueError: the points or the limit are no finite numbers.

    References: Altman (1999), Constrained Markov decision processes.
    """
    p = an_array("points", points, ("n_points", 2))
    low = a_number("limit", limit)
    if not np.isfinite(p).all():
        raise ValueError(f"points must be finite numbers, but is {in_short(points)}")
    keeps = np.flatnonzero(p[:, 1] >= low)
    shares = np.zeros(len(p))
    if not len(keeps):
        return ConstrainedOptimum(None, shares, np.full(2, np.nan))
    best = int(keeps[p[keeps, 0].argmax()])
    highest, i, j, share = p[best, 0], best, best, 0.0
    for above in keeps:
        for below in np.flatnonzero(p[:, 1] < low):
            part = (p[above, 1] - low) / (p[above, 1] - p[below, 1])  # so much of the point below keeps the limit
            value = (1 - part) * p[above, 0] + part * p[below, 0]
            if value > highest:
                highest, i, j, share = value, int(above), int(below), float(part)
    shares[i] += 1 - share
    shares[j] += share
    return ConstrainedOptimum(best, shares, shares @ p)

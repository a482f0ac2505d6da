"""Which of several points are good compromises, and which of those weighted sums can find."""

from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

from edugym.checks.parameters import an_array, in_short
from edugym.mdp.protocol import Reals

Booleans: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.bool_]]

BLOCK = 256
"""So many points at a time are compared with all others."""


def pareto_front(points: Any) -> Booleans:
    """Which points are Pareto-optimal: no other point is better in one objective and at least as good in all others.

        points[pareto_front(points)]

    Args:
        points: shape (n_points, n_objectives). More is better in each objective.

    Returns:
        Shape (n_points,): True for each Pareto-optimal point. Of equal points all are, or none.

    Raises:
        ValueError: `points` are not finite numbers of this shape.
    """
    p = _finite(points, "n_objectives")
    optimal = np.ones(len(p), np.bool_)
    for start in range(0, len(p), BLOCK):
        block = p[start : start + BLOCK, np.newaxis]  # shape (block, 1, n_objectives)
        dominates = np.all(p >= block, axis=2) & np.any(p > block, axis=2)  # shape (block, n_points)
        optimal[start : start + BLOCK] = ~np.any(dominates, axis=1)
    return optimal


def supported(points: Any) -> Booleans:
    """Which points of two objectives some weights prefer: a weighted sum can find these, and no others.

    These are the Pareto-optimal points p for which there are weights w, of 0 or more and not both 0, so that
    w₁ p₁ + w₂ p₂ is at least that of every other point. They lie on the convex hull of all points. The result is exact:
    it is computed with fractions.

    Args:
        points: shape (n_points, 2). More is better in each objective.

    Returns:
        Shape (n_points,): True for each of these points. A point on the line between two others counts too.

    Raises:
        ValueError: `points` are not finite numbers of this shape.

    References: Roijers et al. (2013), A survey of multi-objective sequential decision-making, for the convex hull;
    Andrew (1979), Another efficient algorithm for convex hulls in two dimensions.
    """
    p = _finite(points, 2)
    optimal = {(float(first), float(second)) for first, second in p[pareto_front(p)]}
    hull: list[tuple[float, float]] = []
    for point in sorted(optimal):  # from the best in the second objective to the best in the first
        while len(hull) >= 2 and _below(hull[-1], hull[-2], point):
            hull.pop()
        hull.append(point)
    found = set(hull)
    return np.array([(float(first), float(second)) in found for first, second in p], np.bool_)


def _below(point: tuple[float, float], left: tuple[float, float], right: tuple[float, float]) -> bool:
    """Whether a point lies below the line between two others, one on each side of it."""
    (x, y), (x_left, y_left), (x_right, y_right) = (tuple(map(Fraction, one)) for one in (point, left, right))
    return (y - y_left) * (x_right - x_left) < (y_right - y_left) * (x - x_left)


def _finite(points: Any, n_objectives: int | str) -> Reals:
    """The points as an array of finite numbers."""
    p = an_array("points", points, ("n_points", n_objectives))
    if not np.isfinite(p).all() or p.shape[1] == 0:
        raise ValueError(f"points must be finite numbers, one or more for each point, but is {in_short(points)}")
    return p

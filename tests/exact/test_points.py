"""Pareto fronts and supported points, against their definitions."""

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym.envs.diver import Diver
from edugym.objectives import pareto_front, supported
from tests.messages import named


def points_of(n_objectives: int) -> st.SearchStrategy[list[list[int]]]:
    """Points on a small grid, so that some are equal and many lie on one line."""
    return st.lists(st.lists(st.integers(-4, 4), min_size=n_objectives, max_size=n_objectives), min_size=1, max_size=12)


def dominates(p: list[int], q: list[int]) -> bool:
    """Whether p is better than q in one objective and at least as good in all."""
    return p != q and all(a >= b for a, b in zip(p, q, strict=True))


@given(st.integers(1, 3).flatmap(points_of))
def test_pareto_front(points: list[list[int]]) -> None:
    """A point is optimal if no other dominates it."""
    expected = [not any(dominates(q, p) for q in points) for p in points]
    assert pareto_front(points).tolist() == expected


@given(points_of(2))
def test_supported(points: list[list[int]]) -> None:
    """A point is supported if it is Pareto-optimal and has the largest sum for one of the weights that matter.

    As the weight of the first objective goes from 0 to 1, the best points change only where two of them tie. So it is
    enough to look at these weights and one between each two, for points with whole numbers in fractions.
    """
    ties = {Fraction(0), Fraction(1)}
    for a, b in points:
        for c, d in points:  # w a + (1 - w) b = w c + (1 - w) d
            if a - c != b - d:
                ties.add(min(max(Fraction(d - b, (a - c) - (b - d)), Fraction(0)), Fraction(1)))
    weights = sorted(ties)
    weights += [(low + high) / 2 for low, high in pairwise(weights)]
    best = set()
    for w in weights:
        sums = [w * a + (1 - w) * b for a, b in points]
        best |= {k for k, one in enumerate(sums) if one == max(sums)}
    optimal = pareto_front(points)
    assert supported(points).tolist() == [k in best and bool(optimal[k]) for k in range(len(points))]


@pytest.mark.parametrize(("concavity", "n"), [(0, 9), (0.0625, 9), (0.25, 8), (0.5, 6), (0.75, 4), (0.9375, 3), (1, 2)])
def test_diver_loses_treasures_with_its_strength(concavity: float, n: int) -> None:
    """Of the nine Pareto-optimal ones; a treasure on the line between two others counts."""
    points = [(value, -2.0 * k - 1) for k, value in enumerate(Diver.create(concavity).treasures)]
    assert pareto_front(points).all()
    assert supported(points).tolist() == [k == 0 or k >= 8 * concavity - 0.5 for k in range(9)]
    assert supported(points).sum() == n


@given(st.floats(0, 1), st.integers(0, 2**32))
def test_weights_find_supported_treasures_only(concavity: float, seed: int) -> None:
    """Of random weights, each prefers one of them."""
    points = np.array([(value, -2.0 * k - 1) for k, value in enumerate(Diver.create(concavity).treasures)])
    weights = np.random.default_rng(seed).dirichlet((1, 5), size=50)
    assert set((weights @ points.T).argmax(axis=1).tolist()) <= set(np.flatnonzero(supported(points)).tolist())


def test_many_points() -> None:
    """More than are compared at once; the exact result for numbers that floats round."""
    k = np.arange(1000.0)
    assert pareto_front(np.stack([k, -k], axis=1)).all()
    assert pareto_front(np.stack([k, k], axis=1)).sum() == 1
    assert supported([[0.1 * i, -0.3 * i * i] for i in range(50)]).all()


def test_no_points_and_one() -> None:
    """An empty array has an empty front."""
    assert pareto_front(np.empty((0, 2))).tolist() == supported(np.empty((0, 2))).tolist() == []
    assert pareto_front([[3]]).tolist() == supported([[3, 4], [3, 4]])[:1].tolist() == [True]


@pytest.mark.parametrize("function", [pareto_front, supported])
@pytest.mark.parametrize("points", [3, [], [1, 2], [[1, 2], [3]], [["a", "b"]], [[np.nan, 1]], [[np.inf, 1]], [[], []]])
def test_bad_points(function: Any, points: Any) -> None:
    """They are named."""
    with pytest.raises(ValueError, match="must be") as error:
        function(points)
    named(error, "points")


def test_supported_takes_two_objectives() -> None:
    """Of three there may be more than a line to look at."""
    with pytest.raises(ValueError, match=r"points .* shape \(n_points, 2\)"):
        supported([[1, 2, 3]])

"""Exercise 1 of lesson 12: which points are Pareto-optimal, and which the usual mistakes keep."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy as np

from edugym.exact.points import supported
from edugym.mdp.protocol import Reals

Point = tuple[float, float]
"""The value of a treasure, and its time: minus the steps."""
Points = Sequence[Point]


def _kept(points: Points, beats: Callable[[Point, Point], bool]) -> list[Point]:
    """Return the points that no other point beats."""
    return [p for i, p in enumerate(points) if not any(beats(q, p) for j, q in enumerate(points) if i != j)]


def _dominates(q: Point, p: Point) -> bool:
    return q[0] >= p[0] and q[1] >= p[1] and q != p


def right_points(points: Points) -> list[Point]:
    """Return the Pareto-optimal points."""
    return _kept(points, _dominates)


def _on_hull(points: Points) -> list[Point]:
    return [p for p, is_on in zip(points, supported(points), strict=True) if is_on]


def _highest(points: Points, of: Callable[[Point], float]) -> list[Point]:
    return [p for p in points if of(p) == max(map(of, points))]


def _after_earlier(points: Points) -> list[Point]:
    kept: list[Point] = []
    for p in points:
        kept += [] if any(_dominates(q, p) for q in kept) else [p]
    return kept


def _changed_on_the_way(points: Points) -> list[Point]:
    kept = [*points]
    for p in kept:
        if any(_dominates(q, p) for q in kept):
            kept.remove(p)
    return kept


def _appended_until_dominated(points: Points) -> list[Point]:
    kept: list[Point] = []
    for p in points:
        for q in points:
            if _dominates(q, p):
                break
            kept.append(p)
    return kept


def _without_the_first(points: Points) -> list[Point]:
    gone = [p for p in points if p not in right_points(points)][:1]
    return [p for p in points if p not in gone]


POINT_MISTAKES: Mapping[str, Callable[[Points], list[Point]]] = {
    "a point goes only if another one is better in *both*; it must go also if one is equal and the other better": (
        lambda points: _kept(points, lambda q, p: q[0] > p[0] and q[1] > p[1])
    ),
    "of two equal points one has gone: neither is better than the other, so both stay": lambda points: [
        *dict.fromkeys(right_points(points))
    ],
    "two equal points have thrown each other out: one of the two numbers must be *better*": lambda points: _kept(
        points, lambda q, p: q[0] >= p[0] and q[1] >= p[1]
    ),
    "a point is compared with itself, and throws itself out": lambda points: [],
    "a point goes as soon as another is better in *one* number; it must be at least as good in the other, too": (
        lambda points: _kept(points, lambda q, p: q[0] > p[0] or q[1] > p[1])
    ),
    "the steps are taken for a cost that should be low, but the second number is the time, minus the steps: more is"
    " better": lambda points: _kept(points, lambda q, p: q[0] >= p[0] and q[1] <= p[1] and q != p),
    "low values are kept, and high ones should be": lambda points: _kept(points, lambda q, p: _dominates(p, q)),
    "these are the points that go: keep the others": lambda points: [
        p for p in points if p not in right_points(points)
    ],
    "only the points with the highest sum are kept; that is one choice of weights": lambda points: _highest(
        points, lambda p: p[0] + p[1]
    ),
    "only the points with the highest value are kept; others take less time": lambda points: _highest(
        points, lambda p: p[0]
    ),
    "only the best ones in one objective are kept; between them lie compromises": lambda points: [
        p for p in points if p in _highest(points, lambda p: p[0]) + _highest(points, lambda p: p[1])
    ],
    "only the best one for each time is kept; another one may be better in both": lambda points: [
        p for p in points if p[0] == max(q[0] for q in points if q[1] == p[1])
    ],
    "only the best one for each value is kept; another one may be better in both": lambda points: [
        p for p in points if p[1] == max(q[1] for q in points if q[0] == p[0])
    ],
    "only the point with the most value for each step is kept; that is one more way to weigh": lambda points: _highest(
        points, lambda p: -p[0] / p[1]
    ),
    "of two points with the same time the one with the lower value stays; it must go": lambda points: _kept(
        points, lambda q, p: q[0] >= p[0] and q[1] > p[1]
    ),
    "of two points with the same value the one with more steps stays; it must go": lambda points: _kept(
        points, lambda q, p: q[0] > p[0] and q[1] >= p[1]
    ),
    "a point stays if it dominates another one; it stays if no other one dominates it": lambda points: [
        p for p in points if any(_dominates(p, q) for q in points)
    ],
    "no point has gone: is a point compared with others, and left out if one of them dominates it?": list,
    "a point goes if another has the higher value and the higher sum; the time must be at least as good, too": (
        lambda points: _kept(points, lambda q, p: q[0] > p[0] and sum(q) > sum(p))
    ),
    "a point goes only if *all* others dominate it; a single one is enough": lambda points: [
        p for p in points if not all(_dominates(q, p) for q in points if q != p)
    ],
    "only the first point that others dominate has gone: does `return` stand inside the loop?": _without_the_first,
    "only the first point is looked at: does `return` stand inside the loop?": lambda points: right_points(points)[
        : points[0] in right_points(points)
    ],
    "a point is appended once for each other one that does not dominate it; look at all of them first": lambda points: [
        p for p in points for q in points if not _dominates(q, p)
    ],
    "a point is appended in the inner loop, before all others were looked at; append it below that loop": (
        _appended_until_dominated
    ),
    "only the last comparison of each point counts: is what the earlier ones said overwritten in the loop?": (
        lambda points: [p for p in points if not _dominates(points[-1], p)]
    ),
    "only the first of the right points comes: are all of them kept, and all returned?": lambda points: right_points(
        points
    )[:1],
    "the last point is not looked at: does the range of the loop end too early?": lambda points: [
        p for p in points[:-1] if p in right_points(points)
    ],
    "the first point is not looked at: does the range of the loop begin too late?": lambda points: [
        p for p in points[1:] if p in right_points(points)
    ],
    "no point is compared with the last one: does the range of the inner loop end too early?": lambda points: [
        p for p in points if not any(_dominates(q, p) for q in points[:-1])
    ],
    "no point is compared with the first one: does the range of the inner loop begin too late?": lambda points: [
        p for p in points if not any(_dominates(q, p) for q in points[1:])
    ],
    "a point is compared with those before it only; compare each with all others": _after_earlier,
    "a point is compared with those after it only; compare each with all others": lambda points: [
        p for i, p in enumerate(points) if not any(_dominates(q, p) for q in points[i + 1 :])
    ],
    "a point is compared with a single other one; compare each with all others": lambda points: [
        p for p in points if not _dominates(next(q for q in points if q != p), p)
    ],
    "the list is changed while a loop goes through it, which skips points; make a new list": _changed_on_the_way,
    "only points that some *weights* prefer are kept; one in a dent is Pareto-optimal, too": _on_hull,
    "values are cut to whole numbers, so that two of them may seem equal; compare them as they are": lambda points: (
        _kept(points, lambda q, p: _dominates((int(q[0]), q[1]), (int(p[0]), p[1])))
    ),
    "points are compared with their neighbours only; compare each with all others": lambda points: [
        p
        for i, p in enumerate(points)
        if not any(_dominates(points[j], p) for j in (i - 1, i + 1) if 0 <= j < len(points))
    ],
}
"""Which points each mistake keeps."""
ONCE = "each point comes once, and not in the order of the list: keep the order, and points that are equal"
NO_USUAL_POINTS = "that is none of the usual mistakes, so compare two points by hand"


def made_up_points(rng: np.random.Generator) -> list[list[Point]]:
    """Make up lists of points: a dent, points that others are better than, equal ones, and ties in one number."""
    lists = []
    for _ in range(4):
        base, step = float(rng.integers(5, 15)) + 0.5, float(rng.integers(2, 5))
        front = [(base + 10 * k, -step * k * k - 1.0) for k in range(3)]
        dent = [(base + 34.0, -step * 4 - 31.0), (base + 34.25, -step * 4 - 35.0), (base + 60.0, -step * 4 - 66.0)]
        worse = [(front[1][0], front[1][1] - 1.0), (front[2][0] - 0.25, front[2][1]), (base + 5.0, -step * 4 - 9.0)]
        points = [*front, *dent, *worse, front[int(rng.integers(3))], (base - 3.0, -40.0)]
        lists.append([points[i] for i in rng.permutation(len(points))])
    top = float(rng.integers(20, 30))
    lists.append([(top - 7.0, -9.0), (top, -3.0), (top - 3.0, -5.0)])  # one is better than all others
    return lists


def numbers_of(rule: Callable[[Points], list[Point]], points: Points) -> Reals:
    """Return which points a rule keeps, as numbers that tell two rules apart."""
    kept = rule(points)
    numbers: Reals = np.array([len(kept), *((points.index(p) + 1) * 2.0**i for i, p in enumerate(kept))], float)
    return np.array([numbers.sum()])


def point_rules() -> list[Callable[[Points], Reals]]:
    """Return what each mistake keeps, as numbers."""
    return [partial(numbers_of, rule) for rule in POINT_MISTAKES.values()]

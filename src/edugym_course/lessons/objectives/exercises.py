"""The exercises of lesson 12: which points are good, which action is closest, and how a price is learned."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Annotated, Any

import numpy as np

from edugym.exact.points import supported
from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.choices import action_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all, mistake_in_cases
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given, in_brackets, number, unlike

Point = tuple[float, float]
"""The value of a treasure, and its time: minus the steps."""
Points = Sequence[Point]


def _kept(points: Points, beats: Callable[[Point, Point], bool]) -> list[Point]:
    """Return the points that no other point beats."""
    return [p for i, p in enumerate(points) if not any(beats(q, p) for j, q in enumerate(points) if i != j)]


def _dominates(q: Point, p: Point) -> bool:
    return q[0] >= p[0] and q[1] >= p[1] and q != p


def _right_points(points: Points) -> list[Point]:
    return _kept(points, _dominates)


def _on_hull(points: Points) -> list[Point]:
    return [p for p, is_on in zip(points, supported(points), strict=True) if is_on]


def _highest(points: Points, of: Callable[[Point], float]) -> list[Point]:
    return [p for p in points if of(p) == max(map(of, points))]


POINT_MISTAKES: Mapping[str, Callable[[Points], list[Point]]] = {
    "a point goes only if another one is better in *both*; it must go also if one is equal and the other better": (
        lambda points: _kept(points, lambda q, p: q[0] > p[0] and q[1] > p[1])
    ),
    "of two equal points one has gone: neither is better than the other, so both stay": lambda points: [
        *dict.fromkeys(_right_points(points))
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
        p for p in points if p not in _right_points(points)
    ],
    "only the points with the highest sum are kept; that is one choice of weights": lambda points: _highest(
        points, lambda p: p[0] + p[1]
    ),
    "only the points with the highest value are kept; others take less time": lambda points: _highest(
        points, lambda p: p[0]
    ),
    "only points that some *weights* prefer are kept; one in a dent is Pareto-optimal, too": _on_hull,
    "points are compared with their neighbours only; compare each with all others": lambda points: [
        p
        for i, p in enumerate(points)
        if not any(_dominates(points[j], p) for j in (i - 1, i + 1) if 0 <= j < len(points))
    ],
}
"""Which points each mistake keeps."""
NO_USUAL_POINTS = "that is none of the usual mistakes, so compare two points by hand"


def _made_up_points(rng: np.random.Generator) -> list[list[Point]]:
    """Make up lists of points: a dent, points that others are better than, equal ones, and ties in one number."""
    lists = []
    for _ in range(4):
        base, step = float(rng.integers(5, 15)), float(rng.integers(2, 5))
        front = [(base + 10 * k, -step * k * k - 1.0) for k in range(3)]
        dent = [(base + 34.0, -step * 4 - 31.0), (base + 35.0, -step * 4 - 35.0), (base + 60.0, -step * 4 - 66.0)]
        worse = [(front[1][0], front[1][1] - 1.0), (front[2][0] - 1.0, front[2][1]), (base + 5.0, -step * 4 - 9.0)]
        points = [*front, *dent, *worse, front[int(rng.integers(3))], (base - 3.0, -40.0)]
        lists.append([points[i] for i in rng.permutation(len(points))])
    top = float(rng.integers(20, 30))
    lists.append([(top - 7.0, -9.0), (top, -3.0), (top - 3.0, -5.0)])  # one is better than all others
    return lists


Least = Annotated[
    float,
    Own(
        tuple(k / 2 for k in range(31, 91)),
        "Small treasures are not worth a dive: in your version no point with a value below {least} is returned.",
    ),
]


def exercise_1(answer: Any, seed: int, least: Least = 0.0) -> str:
    """Check which points are Pareto-optimal, where a point may need a lowest value."""
    require_function("pareto_optimal", answer, "points")
    rng = telling_draw(seed, _made_up_points, [partial(_numbers_of, _right_points), *_point_rules()])
    cases = [[(20.0, -3.0), (10.0, -5.0), (30.0, -9.0)], *_made_up_points(rng)]
    if least:
        cases.append([(least - 0.25, -1.0), (least, -2.0), (least + 0.25, -3.0)])
    found = [_points(answer, points) for points in cases]

    def left(rule: Callable[[Points], list[Point]]) -> list[list[Point]]:
        return [[point for point in rule(points) if point[0] >= least] for points in cases]

    right_ones = left(_right_points)
    wrong = [mine != right for right, mine in zip(right_ones, found, strict=True)]
    if any(wrong):
        i = wrong.index(True)
        right, mine = right_ones[i], found[i]

        def explained(rule: Callable[[Points], list[Point]]) -> list[bool]:
            return [kept == one for kept, one in zip(left(rule), found, strict=True)]

        if all(sorted(right) == sorted(one) for right, one in zip(right_ones, found, strict=True)):
            why = "the points are right, and their order is not: keep that of the list"
        else:
            why = mistake_in_cases(POINT_MISTAKES, explained, wrong, NO_USUAL_POINTS)
        raise WrongAnswer(f"pareto_optimal({cases[i]}) should be {right}, but is {mine}: {why}")
    return "Right: no other point is better than these. Weights play no part in it."


def _numbers_of(rule: Callable[[Points], list[Point]], points: Points) -> Reals:
    """Return which points a rule keeps, as numbers that tell two rules apart."""
    kept = rule(points)
    numbers: Reals = np.array([len(kept), *((points.index(p) + 1) * 2.0**i for i, p in enumerate(kept))], float)
    return np.array([numbers.sum()])


def _point_rules() -> list[Callable[[Points], Reals]]:
    return [partial(_numbers_of, rule) for rule in POINT_MISTAKES.values()]


def _points(answer: Any, points: list[Point]) -> list[Point]:
    """Return what a student's function gives, as a list of points.

    Raises:
        WrongAnswer: it is something else.
    """
    call, mine = f"pareto_optimal({points})", [*points]
    with student_code(call):
        found = answer(mine)
    given(call, found)
    if unlike(mine, points):
        raise WrongAnswer(f"{call} changes its list `points`; make a new list")
    if isinstance(found, str) or not isinstance(found, Iterable):
        raise WrongAnswer(f"{call} should be a list of points, but is {found!r}")
    found = [*found]
    if found and all(isinstance(one, bool | np.bool_) for one in found):
        raise WrongAnswer(f"{call} gives a list of True and False; return the points themselves")
    if found and all(isinstance(one, int | np.integer) for one in found):
        raise WrongAnswer(f"{call} gives whole numbers, the places of points; return the points themselves")
    for one in found:
        if not isinstance(one, tuple | list | np.ndarray) or len(one) != 2:
            raise WrongAnswer(f"{call} should be a list of points (value, time), but one of them is {one!r}")
    what = f"each part of a point of {call}"
    return [(number(what, value), number(what, time)) for value, time in found]


Choice = tuple[Reals, int, Reals, Reals]
"""A table Q of shape (states, actions, 2), a state, weights and the utopian point."""


def _distances(Q: Reals, s: int, w: Reals, z: Reals) -> Reals:
    return np.asarray(w * np.abs(z - Q[s]))


CLOSEST_MISTAKES: Mapping[str, Callable[[Reals, int, Reals, Reals], Reals]] = {
    "the action that is *farthest* is taken": lambda Q, s, w, z: -_distances(Q, s, w, z).max(axis=1),
    "the distances of the objectives are added up; only the largest counts": lambda Q, s, w, z: _distances(
        Q, s, w, z
    ).sum(axis=1),
    "the *smallest* distance of an action counts; it should be the largest of its objectives": (
        lambda Q, s, w, z: _distances(Q, s, w, z).min(axis=1)
    ),
    "the weights are left out": lambda Q, s, w, z: np.abs(z - Q[s]).max(axis=1),
    "the distances are divided by the weights, and not multiplied": lambda Q, s, w, z: (np.abs(z - Q[s]) / w).max(
        axis=1
    ),
    "the size is left out: a value beyond the utopian point is also at a distance": lambda Q, s, w, z: (
        w * (z - Q[s])
    ).max(axis=1),
    "the sign is wrong, and the size is left out: that is Q − z": lambda Q, s, w, z: (w * (Q[s] - z)).max(axis=1),
    "the values are weighted before they are taken from z; weigh the distances": lambda Q, s, w, z: np.abs(
        z - w * Q[s]
    ).max(axis=1),
    "the squares of the distances are added up, as in the Euclidean distance; only the largest counts": (
        lambda Q, s, w, z: (_distances(Q, s, w, z) ** 2).sum(axis=1)
    ),
    "that is the highest weighted sum, in which z plays no part": lambda Q, s, w, z: -(w * Q[s]).sum(axis=1),
    "only the first objective counts": lambda Q, s, w, z: _distances(Q, s, w, z)[:, 0],
    "only the second objective counts": lambda Q, s, w, z: _distances(Q, s, w, z)[:, 1],
    "the utopian point is left out: the values themselves are compared": lambda Q, s, w, z: (w * np.abs(Q[s])).max(
        axis=1
    ),
    "the state is left out: it looks up Q[0]": lambda Q, s, w, z: _distances(Q, 0, w, z).max(axis=1),
}
"""By what number, the lowest of which wins, each mistake compares the actions."""
NO_USUAL_CHOICE = "that is none of the usual mistakes, so work out d(s, a) of two actions by hand"


def _choices(rng: np.random.Generator) -> list[Choice]:
    """Make up tables; no two numbers that any rule compares are equal."""
    made = []
    for _ in range(8):
        Q = np.round(rng.uniform(-9, 9, (3, 4, 2)), 2)
        Q[..., 0] += 20.0
        weights, z = np.round(rng.uniform(0.3, 3.0, 2), 2), np.array([25.0, 2.0]) + np.round(rng.uniform(-4, 1, 2), 2)
        made.append((Q, int(rng.integers(1, 3)), weights, z))
    return made


def _chosen(rule: Callable[[Reals, int, Reals, Reals], Reals], case: Choice) -> int:
    return int(rule(*case).argmin())


def _right_choice(Q: Reals, s: int, w: Reals, z: Reals) -> Reals:
    return np.asarray(_distances(Q, s, w, z).max(axis=1))


Margin = Annotated[
    float,
    Own(
        tuple(k / 2 for k in range(2, 62)),
        "Your utopian point lies farther out: in your version `utopian + {margin}` stands in the place of `utopian`.",
    ),
]


def _between_two(margin: float) -> list[Choice]:
    """Make up states in which the second action is the closer one up to a margin a little below or above this one."""
    made = list[Choice]()
    for most in (margin - 0.125, margin + 0.125):
        Q = np.array([[[-most - 2.0, 0.0], [0.0, -1.0]]])
        made.append((Q, 0, np.array([1.0, 2.0]), np.zeros(2)))
    return made


def exercise_2(answer: Any, seed: int, margin: Margin = 0.0) -> str:
    """Check the action that is closest to a point, which may lie farther out."""
    require_function("closest_action", answer, "Q, state, weights and utopian")
    rules = [partial(_chosen, rule) for rule in (_right_choice, *CLOSEST_MISTAKES.values())]
    cases, found, calls = [*_choices(telling_draw(seed, _choices, rules)), *_between_two(margin)], [], []
    for Q, state, weights, z in cases:
        call = (
            f"closest_action(Q, {state}, {in_brackets(weights)}, {in_brackets(z)}), where Q[{state}] ="
            f" [{', '.join(map(in_brackets, Q[state]))}],"
        )
        with student_code(call):
            action = answer(Q.copy(), state, weights.copy(), z.copy())
        given(f"closest_action(Q, {state}, ...)", action)
        if (
            isinstance(action, float | np.floating)
            and abs(action - _right_choice(Q, state, weights, z + margin).min()) < 1e-9
        ):
            raise WrongAnswer(f"{call} gives {action:.4g}, the smallest distance; its action is wanted, so the place")
        calls.append(call)
        found.append(action_of(call, action, Q.shape[1]))
    cases = [(Q, state, weights, z + margin) for Q, state, weights, z in cases]
    expected = [int(_right_choice(*case).argmin()) for case in cases]
    wrong = [one != action for one, action in zip(expected, found, strict=True)]
    if any(wrong):

        def explained(rule: Callable[[Reals, int, Reals, Reals], Reals]) -> list[bool]:
            return [_chosen(rule, case) == action for case, action in zip(cases, found, strict=True)]

        i = wrong.index(True)
        why = mistake_in_cases(CLOSEST_MISTAKES, explained, wrong, NO_USUAL_CHOICE)
        raise WrongAnswer(f"{calls[i]} should give action {expected[i]}, but gives {found[i]}: {why}")
    return "Right: the objective in which an action is worst decides. So no amount of time makes up for a poor value."


PRICE_MISTAKES: Mapping[str, Callable[[float, float, float, float], float]] = {
    "the sign is wrong: a dive that takes too long makes time dearer": lambda p, n, most, r: max(
        0.0, p - r * (n - most)
    ),
    "the price may not fall below 0: then time would be worth something": lambda p, n, most, r: p + r * (n - most),
    "the rate is missing": lambda p, n, most, r: max(0.0, p + (n - most)),
    "the old price is missing: the step is added to it": lambda p, n, most, r: max(0.0, r * (n - most)),
    "the limit is missing: what counts is how far the dive is above it": lambda p, n, most, r: max(0.0, p + r * n),
    "the price only rises; after a short dive it should fall": lambda p, n, most, r: p + r * max(0.0, n - most),
    "the price rises by the same step for each long dive, however long: multiply by the steps beyond the limit": (
        lambda p, n, most, r: max(0.0, p + r * float(np.sign(n - most)))
    ),
    "the price is multiplied; the step is added": lambda p, n, most, r: max(0.0, p * (1 + r * (n - most))),
    "a weighted mean of the old price and the excess: the old price counts in full": lambda p, n, most, r: max(
        0.0, (1 - r) * p + r * (n - most)
    ),
    "that is the smaller one of 0 and the new price: write max": lambda p, n, most, r: min(0.0, p + r * (n - most)),
    "the excess is a share of the limit; it should be a number of steps": lambda p, n, most, r: max(
        0.0, p + r * (n - most) / most
    ),
    "the size of the difference is taken; below the limit the price falls": lambda p, n, most, r: p + r * abs(n - most),
}
"""The price after a dive, by mistake; the mistakes that come to the same stand once."""


def _right_price(p: float, n: float, most: float, r: float) -> float:
    return max(0.0, p + r * (n - most))


Delay = Annotated[
    int,
    Own(
        tuple(range(1, 51)),
        "Your diver needs time to dress: in your version a dive takes {delay} steps more than `steps` says.",
    ),
]


def exercise_3(answer: Any, seed: int, delay: Delay = 0) -> str:
    """Check how the price changes after a dive, which may take more steps than it is told."""
    require_function("new_price", answer, "price, steps, limit and rate")
    shift = seed % 5
    cases = []
    for price, steps, limit, rate in (
        (2.0, 9 + shift, 5, 0.25),
        (4.0, 3, 7 + shift, 0.125),
        (0.5, 1, 9 + shift, 0.25),
        (0.0, 15, 11 - shift, 0.5),
        (3.0, 6 + shift, 6 + shift, 0.25),
    ):
        call = f"new_price({price}, {steps}, {limit}, {rate})"
        with student_code(call):
            found = answer(price, steps, limit, rate)
        taken = steps + delay
        wrong = {why: rule(price, taken, limit, rate) for why, rule in PRICE_MISTAKES.items()}
        cases.append(NumberCase(call, number(call, found), _right_price(price, taken, limit, rate), wrong))
    compare_all(cases)
    return "Right: dual ascent. The price rises until the dives keep the limit on average."

"""Several objectives (lesson 12): weighted sums, Chebyshev distances, sets of vectors, and a learned price, on Diver.

Weighted sums are learned by Q-learning, for 53 weights of time from 0.15 to 7.95; that of the value is 1. Chebyshev
distances have 18 weights of time from 0.15 to 60. Both learn for 20 000 steps from random dives, with learning rate 1
and discount 1: nothing depends on chance here but what is tried, so none fails for want of exploration. Pareto
Q-learning learns for 5 000 steps from random dives. The agent with a limit has the learning rate 0.01 for its price,
and learns for 50 000 steps; it explores by first values of 100 for the value and 0 for time. 10 repetitions, and five
times as many with a limit.
"""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, TypeVar

import numpy as np

from edugym.exact.points import supported
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, share_interval
from edugym.training.train_vectors import VectorRun
from edugym_course.lessons.objectives import figures
from edugym_course.lessons.objectives.methods import (
    LIMIT,
    N_TREASURES,
    chebyshev,
    closest,
    constrained,
    found_by_distance,
    found_by_sets,
    found_by_weights,
    front_of,
    lagrangian,
    late,
    planned_by_weights,
    settles,
    too_long,
    weighted,
)
from edugym_course.lessons.objectives.panels import Front
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

REPETITIONS = 10
CONCAVITIES = (0.0, 0.5, 1.0)
IN_A_DENT = ((1.0, LIMIT), (0.5, LIMIT), (1.0, 5))
"""Concavity and limit: the best dive within the limit is one that no weights prefer."""
BETWEEN = ((0.0, 6), (0.0, 4))
"""The same, but no dive takes exactly so many steps, and there is no dent."""
ON_THE_HULL = ((0.0, LIMIT), (0.5, 9), (1.0, 17))
"""The best dive within the limit takes exactly so many steps, and some weights prefer it."""
HIGH = 30.0
"""A first price at which no dive is worth its steps."""
FAST = 0.05
"""A rate of the price, five times that of the lesson."""
LEARNED = ((0.0, LIMIT), (0.25, LIMIT), (0.0, 5))
"""Concavity and limit, where it is measured what learning costs."""
MORE = 5
"""So many times as many runs with a limit: some of them do not settle."""
FIRST = 100
"""So many dives are the first ones."""

Found = TypeVar("Found")
ByConcavity = Mapping[float, list[list[int]]]
Task = tuple[float, int]
"""Concavity and limit."""
ByTask = Mapping[Task, list[VectorRun]]


class Measured(NamedTuple):
    """What was measured: for each concavity or task a list over seeds.

    Attributes:
        weights: the treasures found by weighted sums, for each price.
        whole: those found by Chebyshev distances of whole dives, for each weight of time.
        rest: the same with the rule of the paper, by the rest of the dive.
        sets: those found by Pareto Q-learning.
        limits: the runs with a limit.
        costs: by task, those with other first prices and rates, with known values and without, by their names.
    """

    weights: ByConcavity
    whole: ByConcavity
    rest: ByConcavity
    sets: ByConcavity
    limits: ByTask
    costs: Mapping[Task, Mapping[str, list[VectorRun]]]


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    first = 1_000 * how.shared["seed"]

    def over_seeds(function: Callable[..., Found], *settings: Any, times: int = 1, **more: Any) -> list[Found]:
        seeds = range(first, first + times * how.repetitions)
        return [function(*settings, seed=seed, **more) for seed in seeds if not how.shared["stop"].is_set()]

    return (
        Measured(
            {c: over_seeds(found_by_weights, c) for c in CONCAVITIES},
            {c: over_seeds(found_by_distance, c, whole_returns=True) for c in CONCAVITIES},
            {c: over_seeds(found_by_distance, c, whole_returns=False) for c in CONCAVITIES},
            {c: [sorted(found) for found in over_seeds(found_by_sets, c)] for c in CONCAVITIES},
            {task: over_seeds(lagrangian, *task, times=MORE) for task in (*IN_A_DENT, *BETWEEN, *ON_THE_HULL)},
            {
                task: {name: over_seeds(lagrangian, *task, **settings) for name, settings in BEGINNINGS.items()}
                for task in LEARNED
            },
        ),
    )


def judge(measured: Measured) -> Report:
    """Return claims and figures."""
    claims = [
        *weight_claims(measured.weights),
        *set_claims(measured.sets),
        *distance_claims(measured.whole, measured.rest),
        *limit_claims(measured.limits),
        *(claim for task, runs in measured.costs.items() for claim in learning_claims(task, runs)),
    ]
    return Report(claims, sheets(measured))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def n_supported(concavity: float) -> int:
    """Return how many treasures some weights prefer."""
    return int(supported(front_of(concavity)).sum())


def missed(concavity: float) -> str:
    """Return the claim on weighted sums."""
    n = n_supported(concavity)
    return f"At concavity {concavity:g} weighted sums find {n} of the nine treasures, and never another one"


def exactly_missed(concavity: float) -> str:
    """Return the same claim of exact planning."""
    n = n_supported(concavity)
    return f"At concavity {concavity:g} exact planning finds no more: {n} are best for some of the 53 weights"


def all_sets(concavity: float) -> str:
    """Return the claim on Pareto Q-learning."""
    return f"At concavity {concavity:g} Pareto Q-learning finds all nine in one run"


def near(concavity: float) -> str:
    """Return the claim on Chebyshev distances of whole dives."""
    return f"At concavity {concavity:g} distances of whole dives find the closest treasure for all 18 weights, all nine"


def kept(task: Task) -> str:
    """Return the claim where the best dive is on the hull."""
    return f"At concavity {task[0]:g} and a limit of {task[1]} steps, in most runs no dive takes too long in the end"


BEGINNINGS: Mapping[str, Mapping[str, Any]] = {
    "with a first price of 0": {},
    f"with a first price of {HIGH:g}": {"first_price": HIGH},
    f"with a first price of 0 and a rate of {FAST:g}": {"rate": FAST},
    f"with known values and a first price of {HIGH:g}": {"first_price": HIGH, "known": True},
    "with known values and a first price of 0": {"known": True},
    f"with known values, a first price of 0 and a rate of {FAST:g}": {"rate": FAST, "known": True},
}
"""How a training begins, by name. The rate of the price is 0.01 where none is said."""
FREE, DEAR, _, KNOWN_DEAR, KNOWN, KNOWN_FAST = BEGINNINGS


def counted(task: Task, name: str, condition: Above | Below) -> str:
    """Return the claim on how many dives take too long after such a beginning."""
    amount = "more" if isinstance(condition, Above) else "fewer"
    where = f"At concavity {task[0]:g} and a limit of {task[1]} steps"
    return f"{where}, {name}, {amount} than {condition.threshold:g} dives take too long"


def weight_claims(weights: ByConcavity) -> list[Claim]:
    """Return the claims on weighted sums, at the concavity of the lesson and two others."""
    claims = []
    for c, runs in weights.items():
        n = n_supported(c)
        wrong = [len(set(found) - planned_by_weights(c)) for found in runs]
        counted = [len(set(found)) + extra for found, extra in zip(runs, wrong, strict=True)]
        dent = c > 0
        claims += [
            Claim(
                missed(c),
                "different treasures",
                mean_interval(counted),
                Within(n - 0.1, n + 0.1),
                "for any weights, another treasure than one in the dent has the higher sum" if dent else "",
                (exactly_missed(c), missed(0.0), all_sets(c)) if dent else (),
            ),
            Claim(exactly_missed(c), "treasures, computed", exactly(len(planned_by_weights(c))), Within(n, n)),
        ]
    return claims


def set_claims(sets: ByConcavity) -> list[Claim]:
    """Return the claims on Pareto Q-learning."""
    return [
        Claim(
            all_sets(c),
            "points of the exact front that it found, less those that are none",
            mean_interval([len(set(found) - {N_TREASURES}) - (N_TREASURES in found) for found in runs]),
            Above(N_TREASURES - 0.1),
        )
        for c, runs in sets.items()
    ]


def distance_claims(whole: ByConcavity, rest: ByConcavity) -> list[Claim]:
    """Return the claims on Chebyshev distances, of whole dives and of the rest of the dive."""
    claims = []
    for c in whole:
        asked = np.array(closest(c))
        claims += [
            Claim(
                near(c),
                "share of the weights",
                mean_interval([float(np.mean(found == asked)) for found in map(np.array, whole[c])]),
                Above(0.99),
            ),
            Claim(
                f"At concavity {c:g} distances of the rest of the dive find it for fewer than half of the weights",
                "share of the weights",
                mean_interval([float(np.mean(found == asked)) for found in map(np.array, rest[c])]),
                Below(0.5),
                "in the middle of a dive the steps so far are forgotten, so going on looks cheaper than it is",
                (near(c),),
            ),
            Claim(
                f"At concavity {c:g} the rest of the dive leads to a deeper treasure more often than to a nearer one",
                "share of the weights with a deeper treasure, less that with a nearer one",
                mean_interval([float(np.mean(np.sign(found - asked))) for found in map(np.array, rest[c])]),
                Above(0.1),
            ),
        ]
    return claims


def limit_claims(limits: ByTask) -> list[Claim]:
    """Return the claims on the limit: where some price prefers a dive of exactly so many steps, and where none does."""
    claims = []
    for (c, limit), runs in limits.items():
        exact = constrained(c, limit)
        overruns = float(exact.shares[too_long(front_of(c), limit) > 0].sum())
        if (c, limit) in ON_THE_HULL:
            shares = share_interval([settles(run, limit) for run in runs])
            claims.append(Claim(kept((c, limit)), "share of the runs", shares, Above(0.6)))
            continue
        found = mean_interval([float(too_long(late(run), limit).mean()) for run in runs])
        claims += [
            Claim(
                f"At concavity {c:g} and a limit of {limit} steps {overruns:.3g} of the dives take too long in the end,"
                " as in the exact best average",
                "share of the dives, second half",
                found,
                Within(overruns - 0.06, overruns + 0.06),
                "no price prefers a dive of exactly so many steps, so the agent changes between two others",
                tuple(map(kept, ON_THE_HULL)),
            ),
            Claim(
                f"At concavity {c:g} and a limit of {limit} steps their mean value is that of the exact best average",
                "mean value, second half, less the exact one",
                mean_interval([float(late(run)[:, 0].mean()) - float(exact.mean[0]) for run in runs]),
                Within(-0.3, 0.3),
            ),
            Claim(
                f"At concavity {c:g} and a limit of {limit} steps their mean length is the limit",
                "mean steps, second half, less the limit",
                mean_interval([-float(late(run)[:, 1].mean()) - limit for run in runs]),
                Within(-0.1, 0.1),
            ),
        ]
    return claims


def learning_claims(task: Task, by_beginning: Mapping[str, list[VectorRun]]) -> list[Claim]:
    """Return the claims on what it costs to learn the price, in runs that settle.

    Either of two causes is enough: first values that are too high, or a low price that rises by small steps.
    """
    limit = task[1]
    dives = {
        name: [too_long(run.training_returns, limit) for run in runs if settles(run, limit)]
        for name, runs in by_beginning.items()
    }
    expected: dict[str, Above | Below] = dict.fromkeys(by_beginning, Above(40.0))
    expected |= {KNOWN_DEAR: Below(5.0), KNOWN_FAST: Below(20.0)}
    reasons = {
        DEAR: ("its first values, which are too high, lead the agent everywhere once", KNOWN_DEAR),
        KNOWN: ("the price rises by small steps", KNOWN_FAST),
    }
    claims = []
    for name, runs in dives.items():
        why, test = reasons.get(name, ("", ""))
        tested_by = (counted(task, test, expected[test]),) if test else ()
        mean = mean_interval([float(run.sum()) for run in runs])
        claims.append(
            Claim(counted(task, name, expected[name]), "dives that take too long", mean, expected[name], why, tested_by)
        )
    both = zip(dives[DEAR], dives[FREE], strict=False)
    claims.append(
        Claim(
            f"At concavity {task[0]:g} and a limit of {limit} steps, {DEAR} fewer than half as many of the first"
            f" {FIRST} dives take too long",
            f"dives that take too long, of the first {FIRST}: less half of those with a first price of 0",
            mean_interval([float(dear[:FIRST].sum() - 0.5 * free[:FIRST].sum()) for dear, free in both]),
            Below(-10.0),
        )
    )
    return claims


def sheets(measured: Measured) -> list[Sheet]:
    """Return the figures."""
    c, seed = 0.5, 0
    rules = {"the rest of the dive": measured.rest[c][seed], "the whole dive": measured.whole[c][seed]}
    fronts = {
        c: {"found by some weights": runs[seed], "Pareto Q-learning": measured.sets[c][seed]}
        for c, runs in measured.weights.items()
    }
    runs = {f"concavity {c:g}": measured.limits[c, LIMIT][seed] for c in CONCAVITIES}
    return [
        Sheet("fronts", [[Front(front_of(c), f"concavity {c:g}", found) for c, found in fronts.items()]]),
        figures.by_distance(c, rules),
        Sheet("limits", [[figures.shares_too_long(runs)]]),
    ]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    few = 5_000
    weighted(0.5, 2.0, n_steps=few)
    chebyshev(0.5, 2.0, whole_returns=True, n_steps=few)
    runs = {"first steps": lagrangian(0.5, n_steps=few)}
    figures.front(0.5, weights=(1.0, 2.0)).draw()
    figures.shares_too_long(runs).draw()

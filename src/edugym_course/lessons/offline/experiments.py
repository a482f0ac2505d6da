"""Offline learning (lesson 16): what the data of one policy say of another one, and what can be learned from them.

Nights of the morning of lesson 10 are collected by a clock that does what is best in a share of its steps, and else
presses a button at random. Importance sampling (ordinary, weighted, per decision) and doubly robust estimates judge the
best clock by 1000 nights of a clock with share 0.5; with a fitted Q for the latter. Fitted Q-iteration (as it is, first
values of 0), the same with the lowest return for unseen actions, and pessimistic Q-iteration (penalty 1) learn from 300
nights of a clock with share 0.97; 1000 nights of random buttons are the control. All returns are exact, at discount 1.
100 repetitions with other nights. Beside the lesson's morning there are one of 12 steps, Roadrunner (100 episodes at
discount 0.99, control of 300), and Boulder, where no return is below 0.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import mean_interval, paired_difference
from edugym.mdp.protocol import Reals
from edugym_course.lessons.offline.figures import SHARES, errors, promises
from edugym_course.lessons.offline.methods import (
    AS_IT_IS,
    BOULDER,
    ESTIMATORS,
    MORNING,
    N_NIGHTS,
    ORDINARY,
    PENALTY,
    PER_DECISION,
    PESSIMISTIC,
    REPETITIONS,
    ROADRUNNER,
    ROBUST,
    SHARE,
    UNSEEN_IS_WORST,
    WEIGHTED,
    Judged,
    Learned,
    Task,
    imitated,
    judged,
    learned,
    morning,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

LONGER = morning(length=12)
TASKS: Mapping[str, tuple[Task, int, int]] = {
    "the lesson's morning": (MORNING, N_NIGHTS, 1000),
    "a morning of 12 steps": (LONGER, N_NIGHTS, 3000),
    "Roadrunner": (ROADRUNNER, 100, 300),
}
"""By name: the task, how many episodes a good policy collects, and how many of random actions cover everything."""
NIGHTS = (300, 1000, 3000, 10_000)
MANY = 10_000
HEAVY = 10.0
DEARER = morning(ring=2.0, late=20.0)


class OfTask(NamedTuple):
    """What was learned in one task.

    Attributes:
        good: from the data of a good policy.
        random: from as many episodes of random actions.
        covered: from the many episodes of random actions that cover everything.
    """

    good: Learned
    random: Learned
    covered: Learned


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    shared = {name: how.shared[name] for name in ("repetitions", "seed", "stop")}
    few = {**shared, "repetitions": max(2, how.repetitions // 5)}  # runs of many nights are much alike
    found = {
        name: OfTask(
            learned(task, SHARE, n, **shared), learned(task, 0.0, n, **shared), learned(task, 0.0, many, **few)
        )
        for name, (task, n, many) in TASKS.items()
    }
    by_share = {share: learned(share=share, **few) for share in SHARES}
    by_nights = {float(n): judged(n_nights=n, **few) for n in NIGHTS}
    others = learned(n_nights=MANY, **few), learned(DEARER, **shared), learned(BOULDER, SHARE, 100, **few)
    heavy = learned(share=0.0, penalty=HEAVY, **shared)
    estimates = judged(**shared), judged(LONGER, methods=(ORDINARY,), **shared)
    return by_share, by_nights, found, (*others, heavy), estimates, imitated(share=0.0, **shared)


def judge(
    by_share: Mapping[float, Learned],
    by_nights: Mapping[float, Judged],
    found: Mapping[str, OfTask],
    others: tuple[Learned, Learned, Learned, Learned],
    estimates: tuple[Judged, Judged],
    imitation: Reals,
) -> Report:
    """Return claims and figures."""
    claims = [claim for name, by_data in found.items() for claim in claims_on(name, by_data)]
    claims += [*estimator_claims(*estimates), *other_claims(*others)]
    pessimist = found["the lesson's morning"].random.kept[PESSIMISTIC]
    claims.append(
        Claim(
            "From random nights, a pessimist keeps more than who imitates the most frequent action",
            "exact return of the pessimist's greedy policy less that of the imitator",
            paired_difference(pessimist, imitation),
            Above(10.0),
        )
    )
    return Report(claims, [promises(by_share), errors(by_nights)])


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""

TOO_MUCH = "promised return less the exact return of the greedy policy"


def overpromised(name: str) -> str:
    """Return the claim that fitted Q promises too much."""
    return f"On {name}, from the data of a good policy fitted Q promises more than its policy keeps"


def known(name: str) -> str:
    """Return the claim that this is due to actions without data."""
    return f"On {name}, with the lowest value for unseen actions the policy keeps more"


def claims_on(name: str, found: OfTask) -> list[Claim]:
    """Return the claims on one task."""
    good, random, covered = found
    kept = "exact return of the greedy policy"
    return [
        Claim(
            overpromised(name),
            TOO_MUCH,
            mean_interval(good.too_much(AS_IT_IS)),
            Above(2.0),
            "an action without data keeps its first value, 0, and the maximum takes it where that is more",
            (known(name),),
        ),
        Claim(
            known(name),
            f"{kept}, less that with first values of 0",
            paired_difference(good.kept[UNSEEN_IS_WORST], good.kept[AS_IT_IS]),
            Above(2.0),
        ),
        Claim(
            f"On {name}, as many episodes of random actions teach more than those of a good policy",
            f"{kept} after random actions, less that after a good policy",
            paired_difference(random.kept[AS_IT_IS], good.kept[AS_IT_IS]),
            Above(2.0),
        ),
        Claim(
            f"On {name}, what a pessimist promises is kept",
            TOO_MUCH,
            mean_interval(good.too_much(PESSIMISTIC)),
            Below(0.0),
        ),
        Claim(
            f"On {name}, a pessimist gathers more than the policy that collected the data",
            f"{kept} of the pessimist, less the mean return in the data",
            paired_difference(good.kept[PESSIMISTIC], good.gathered),
            Above(0.3),
        ),
        Claim(
            f"On {name}, where the data cover everything pessimism gains nothing",
            f"{kept} of the pessimist, less that of fitted Q as it is",
            paired_difference(covered.kept[PESSIMISTIC], covered.kept[AS_IT_IS]),
            Within(-0.1, 0.1),
            remark="The control: there is nothing that it could protect from.",
        ),
        Claim(
            f"On {name}, there it promises too little",
            TOO_MUCH,
            mean_interval(covered.too_much(PESSIMISTIC)),
            Below(-0.3),
        ),
    ]


def estimator_claims(base: Judged, longer: Judged) -> list[Claim]:
    """Return the claims on estimates of what the best clock is worth."""
    unbiased = [
        Claim(
            f"On average, {method} estimates are the exact return",
            "mean estimate less the exact return",
            mean_interval(base.values[method] - base.exact),
            Within(-1.0, 1.0),
        )
        for method in ESTIMATORS
    ]
    pairs = ((ORDINARY, PER_DECISION), (ORDINARY, WEIGHTED), (PER_DECISION, ROBUST))
    nearer = [
        Claim(
            f"Estimates that are {better} are nearer than those that are {worse}",
            "distance from the exact return, the former less the latter",
            paired_difference(base.errors(better), base.errors(worse)),
            Below(0.0),
        )
        for worse, better in pairs
    ]
    return [
        *unbiased,
        *nearer,
        Claim(
            "The mean night of the data says something else",
            "mean return in the data less the exact return of the other clock",
            mean_interval(base.gathered - base.exact),
            Below(-9.0),
        ),
        Claim(
            "Of 1000 nights some 40 count",
            "effective number of nights, where two thirds of the steps agree and a night has 8",
            mean_interval(base.effective),
            Within(35.0, 43.0),
        ),
        Claim(
            "Of 1000 nights of 12 steps some 8 count",
            "effective number of nights, where two thirds of the steps agree and a night has 12",
            mean_interval(longer.effective),
            Within(6.0, 10.0),
        ),
    ]


def other_claims(many: Learned, dearer: Learned, boulder: Learned, heavy: Learned) -> list[Claim]:
    """Return the claims on many nights, on a penalty that is too small or too large, and on a task where 0 is low."""
    return [
        Claim(
            f"With {MANY} nights of a good clock fitted Q is as good as the best clock",
            "exact return of the greedy policy less the best",
            mean_interval(many.kept[AS_IT_IS] - many.best),
            Above(-0.5),
        ),
        Claim(
            f"Where oversleeping costs 20, with a penalty of {PENALTY:g} a pessimist still promises too much",
            TOO_MUCH,
            mean_interval(dearer.too_much(PESSIMISTIC)),
            Above(0.2),
            remark="The penalty must fit the spread of what a step brings.",
        ),
        Claim(
            f"From random nights, a penalty of {HEAVY:g} costs what the policy keeps",
            "exact return of the pessimist's greedy policy less that of fitted Q as it is",
            paired_difference(heavy.kept[PESSIMISTIC], heavy.kept[AS_IT_IS]),
            Below(-1.5),
        ),
        Claim(
            "On Boulder, where no return is below 0, first values of 0 do no harm",
            TOO_MUCH,
            mean_interval(boulder.too_much(AS_IT_IS)),
            Within(-0.5, 0.5),
        ),
    ]

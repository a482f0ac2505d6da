"""What the learning rate does to the depths, and why: it is not the variance of the targets alone."""

import math
from collections.abc import Mapping
from typing import Any

from edugym.experiments.results.claims import Above, Below, Claim
from edugym.experiments.results.statistics import paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.depth.methods import MONTE_CARLO, ONE_STEP, SHORT, compare, kept, met_exam

SLOW, QUICK = 0.01, 0.3
"""Learning rates of which the first suits Monte Carlo, and the second one-step SARSA."""
RATES = (SLOW, 0.1, QUICK, 1.0)
LOW_START = -5.0
"""A start value with which untried actions look bad."""
QUICK_WITH_LOW_START = (
    f"With start values of {LOW_START:g} Monte Carlo learns faster with rate {QUICK:g} than with {SLOW:g}"
)
"""What shows that a small learning rate helps Monte Carlo by its exploration."""


def with_low_start(**how: Any) -> dict[float, Results]:
    """Train Monte Carlo with two learning rates where untried actions look bad; arguments as in `compare`."""
    return {
        rate: compare(depths=(math.inf,), learning_rate=rate, initial_value=LOW_START, n_steps=SHORT, **how)
        for rate in (SLOW, QUICK)
    }


def rate_claims(by_rate: Mapping[float, Results], low: Mapping[float, Results]) -> list[Claim]:
    """Return the claims on learning rates, for 500 episodes; the second results are those of low start values."""
    slow, quick, fastest = by_rate[SLOW], by_rate[QUICK], by_rate[1.0]

    def averages(results: Results, method: str) -> Reals:
        return results.average(method)

    return [
        Claim(
            "n = 1 learns faster with rate 0.3 than with 0.01",
            "return averaged over 500 episodes, rate 0.3 less 0.01",
            paired_difference(averages(quick, ONE_STEP), averages(slow, ONE_STEP)),
            Above(1.0),
            "its targets vary little, but must be handed back day by day",
        ),
        Claim(
            "Monte Carlo learns more slowly with rate 0.3 than with 0.01",
            "return averaged over 500 episodes, rate 0.3 less 0.01",
            paired_difference(averages(quick, MONTE_CARLO), averages(slow, MONTE_CARLO)),
            Below(-0.1),
            "a small rate leaves the values near those of untried actions for longer, so that more runs meet the exam",
            (QUICK_WITH_LOW_START,),
        ),
        Claim(
            QUICK_WITH_LOW_START,
            f"return averaged over 500 episodes, rate {QUICK:g} less {SLOW:g}",
            paired_difference(averages(low[QUICK], MONTE_CARLO), averages(low[SLOW], MONTE_CARLO)),
            Above(0.1),
        ),
        Claim(
            "Monte Carlo meets the exam in more runs with rate 0.01 than with 0.3",
            "share of runs that ever passed in 500 episodes, rate 0.01 less 0.3",
            paired_difference(met_exam(slow, MONTE_CARLO), met_exam(quick, MONTE_CARLO)),
            Above(0.0),
        ),
        *(
            Claim(
                f"Of the Monte Carlo runs that meet the exam nearly all pass in the end (rate {rate:g})",
                "share that passes after 500 episodes",
                share_interval(kept(by_rate[rate], MONTE_CARLO)),
                Above(0.8),
                remark="so the variance of its targets does not hold it back",
            )
            for rate in (SLOW, QUICK)
        ),
        Claim(
            "Each with a suitable rate, Monte Carlo (0.01) is ahead of n = 1 (0.3) over the first 500 episodes",
            "return averaged over 500 episodes, less that of n = 1",
            paired_difference(averages(slow, MONTE_CARLO), averages(quick, ONE_STEP)),
            Above(0.5),
        ),
        Claim(
            "Negative control: with rate 1, which keeps only the last target, Monte Carlo loses to n = 1",
            "return averaged over 500 episodes, less that of n = 1, both with rate 1",
            paired_difference(averages(fastest, MONTE_CARLO), averages(fastest, ONE_STEP)),
            Below(-0.5),
        ),
    ]

"""All depths at once: SARSA(λ) beside n-step SARSA."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from edugym.agents.sarsa_lambda import SARSALambda
from edugym.agents.strategies import EpsilonGreedy
from edugym.experiments.results.claims import Above, Claim, Within
from edugym.experiments.results.statistics import paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.depth.methods import (
    BY_DEPTH,
    LEARNING_RATE,
    MONTE_CARLO,
    ONE_STEP,
    SHORT,
    Maker,
    compare,
    counted,
    label,
)
from edugym_course.lessons.depth.targets import DISCOUNT, EPSILON

MIDDLE = 0.8
TRACE_DECAYS = (0.0, MIDDLE, 1.0)
RATES = (0.03, 0.1, 0.3)
NOISES = (0.2, 1.0)


def trace_label(trace_decay: float) -> str:
    """Return the label of SARSA(λ)."""
    return f"λ = {trace_decay:g}"


def weights(trace_decay: float, days: int) -> Reals:
    """Return the weights of the n-step targets, n = 1, 2, ..., in the λ-return of the first day."""
    n = np.arange(days)
    shares: Reals = np.where(n < days - 1, (1 - trace_decay) * trace_decay**n, trace_decay**n)
    return shares


def tracer(
    trace_decay: float, *, learning_rate: float = LEARNING_RATE, epsilon: float = EPSILON, discount: float = DISCOUNT
) -> Maker:
    """Return a function that makes a SARSA(λ) agent for an environment, with the settings of the lesson."""
    return partial(
        SARSALambda.create,
        trace_decay=trace_decay,
        learning_rate=learning_rate,
        discount=discount,
        exploration=EpsilonGreedy(epsilon),
    )


def through_rates(
    rates: Sequence[float] = RATES,
    *,
    trace_decays: Sequence[float] = TRACE_DECAYS,
    n_steps: int = SHORT,
    count_passes: bool = False,
    **how: Any,
) -> dict[float, Results]:
    """Train every n and every λ with several learning rates; other arguments as in `methods.compare`."""
    count = counted if count_passes else lambda make: make
    return {
        rate: compare(
            depths=BY_DEPTH,
            own={trace_label(decay): count(tracer(decay, learning_rate=rate)) for decay in trace_decays},
            learning_rate=rate,
            n_steps=n_steps,
            count_passes=count_passes,
            **how,
        )
        for rate in rates
    }


def over_rates(by_rate: Mapping[float, Results], method: str) -> Reals:
    """Return for each repetition the return of a method while it learns, averaged over the learning rates."""
    averages: Reals = np.mean([results.average(method) for results in by_rate.values()], axis=0)
    return averages


def trace_claims(by_sigma: Mapping[float, Mapping[float, Results]]) -> list[Claim]:
    """Return the claims on λ, from the results of `through_rates` by the noise of the rewards."""
    quiet, noisy = (by_sigma[sigma] for sigma in NOISES)
    middle = trace_label(MIDDLE)

    def gap(by_rate: Mapping[float, Results], method: str, other: str) -> Any:
        return paired_difference(over_rates(by_rate, method), over_rates(by_rate, other))

    measured = "return averaged over 500 episodes and three learning rates"
    return [
        Claim(
            "SARSA(λ) with λ = 0 is one-step SARSA",
            f"{measured}, less that of n = 1",
            gap(quiet, trace_label(0.0), ONE_STEP),
            Within(-1e-9, 1e-9),
        ),
        Claim(
            "SARSA(λ) with λ = 1 learns as Monte Carlo does",
            f"{measured}, less that of Monte Carlo",
            gap(quiet, trace_label(1.0), MONTE_CARLO),
            Within(-0.1, 0.1),
            remark="they differ where rounding breaks ties",
        ),
        *(
            Claim(
                f"Over three learning rates SARSA(λ) with λ = {MIDDLE:g} learns faster than {label(n)} (σ = 0.2)",
                f"{measured}, less that of {label(n)}",
                gap(quiet, middle, label(n)),
                Above(0.1),
            )
            for n in BY_DEPTH
        ),
        Claim(
            f"With σ = 1 λ = {MIDDLE:g} and Monte Carlo differ by less than 1",
            f"{measured}, less that of Monte Carlo",
            gap(noisy, middle, MONTE_CARLO),
            Within(-1.0, 1.0),
        ),
    ]

"""The depth of credit assignment (lesson 3): n-step SARSA from one step to Monte Carlo.

On Study, n-step SARSA with n = 1, 3, 5 and ∞ (Monte Carlo) trains for 4 000 episodes of ten days, with learning rate
0.1, ε = 0.1 and discount 1, at standard deviations σ of the reward noise of 0, 0.2 and 1 (at σ = 0 and 1 only n = 1
and ∞). 80 repetitions; each has its own layout (lecture days and action rewards), which is the same for every method
and every σ.

"Final" returns are the exact expected returns of the final greedy policies: the dynamics are deterministic, so a greedy
policy has one path. Learning curves show the mean of 3 greedy evaluation episodes. The optimum and the best ε-soft
policy come from the exact model, as means over the layouts.
"""

import math
from collections.abc import Mapping
from typing import Any

from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import Interval, mean_interval, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.depth.cutting import AFTER, WHEN_TAKEN, value_above_return
from edugym_course.lessons.depth.figures import bias_series, rate_series, through_rates, variance_sheet
from edugym_course.lessons.depth.methods import (
    DEPTHS,
    EARLY,
    MONTE_CARLO,
    ONE_STEP,
    PASSING,
    REPETITIONS,
    SIGMAS,
    best_returns,
    compare,
    expected_returns,
    kept,
    label,
    layouts,
    met_exam,
    passes,
)
from edugym_course.lessons.depth.rates import RATES, rate_claims, with_low_start
from edugym_course.lessons.depth.targets import DAYS, EPSILON, target_claims
from edugym_course.lessons.depth.traces import NOISES, trace_claims
from edugym_course.lessons.depth.traces import through_rates as traces_through_rates
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

EXTREMES = (1, math.inf)
"""The values of n where only one step and Monte Carlo are compared."""
WITH_TEN_ACTIONS = (1, math.inf, 5)
"""The values of n with ten actions."""
START_VALUES = ((0.0, 0.2), (-2.0, 0.2), (-5.0, 0.2), (0.0, 0.0), (-5.0, 0.0))
"""Start values, and standard deviations of the noise, with which n = 1 and Monte Carlo meet the exam or do not."""
LOW_STARTS = tuple(setting for setting in START_VALUES if setting[0] < 0)
CUTTING = ((2.0, 0.1), (2.0, 0.3), (1.0, 0.1), (0.2, 0.1))
"""Standard deviations of the noise and learning rates at which targets are cut; with the last the noise is small."""


def needs_untried(start: float, sigma: float, method: str) -> str:
    """Return the statement that a method meets the exam less often where untried actions look bad."""
    return f"With start values of {start:g} {method} meets the exam in fewer runs than with 0 (σ = {sigma:g})"


UNTRIED = tuple(needs_untried(start, sigma, ONE_STEP) for start, sigma in LOW_STARTS)
"""What shows that one-step SARSA needs untried actions that look good."""


def final_difference(results: Results, method: str, other: str) -> Interval:
    """Return the exact final return of a method less that of another, paired by repetition."""
    return paired_difference(expected_returns(results, method), expected_returns(results, other))


def early_difference(results: Results, method: str, other: str) -> Interval:
    """Return the evaluation return of a method less that of another after `EARLY` steps, paired by repetition."""
    return paired_difference(results.at(method, EARLY), results.at(other, EARLY))


def difference_where_both_pass(results: Results, method: str, other: str) -> Interval:
    """Return the exact final return of a method less that of another, where both pass the exam."""
    returns = [expected_returns(results, one) for one in (method, other)]
    both = (returns[0] > PASSING) & (returns[1] > PASSING)
    return paired_difference(returns[0][both], returns[1][both])


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    by_sigma = {
        sigma: compare(sigma=sigma, depths=DEPTHS if sigma == 0.2 else EXTREMES, **how(f"sigma_{sigma:g}"))
        for sigma in SIGMAS
    }
    ten_actions = compare(n_actions=10, depths=WITH_TEN_ACTIONS, count_passes=True, **how("ten_actions"))
    starts: dict[str, Any] = {"depths": EXTREMES, "count_passes": True}
    by_start = {
        (start, sigma): compare(initial_value=start, sigma=sigma, **starts, **how(f"start_{start:g}_sigma_{sigma:g}"))
        for start, sigma in START_VALUES
    }
    too_high = {setting: value_above_return(*setting, **how()) for setting in CUTTING}
    quiet, noisy = NOISES
    traced = {
        quiet: traces_through_rates(sigma=quiet, **how(repetitions=2 * how.repetitions)),
        noisy: traces_through_rates(sigma=noisy, **how()),
    }
    by_rate = through_rates(RATES, count_passes=True, **how())
    by_rate_low = with_low_start(**how())
    return by_sigma, ten_actions, by_start, by_rate, by_rate_low, too_high, traced


def judge(
    by_sigma: Mapping[float, Results],
    ten_actions: Results,
    by_start: Mapping[tuple[float, float], Results],
    by_rate: Mapping[float, Results],
    by_rate_low: Mapping[float, Results],
    too_high: Mapping[tuple[float, float], Mapping[str, Reals]],
    traced: Mapping[float, Mapping[float, Results]],
) -> Report:
    """Return claims and figures."""
    claims = [
        *early_claims(by_sigma),
        *late_claims(by_sigma),
        *action_claims(by_sigma[0.2], ten_actions),
        *meeting_claims(ten_actions),
        *start_claims(by_start),
        *rate_claims(by_rate, by_rate_low),
        *cutting_claims(too_high),
        *target_claims(),
        *trace_claims(traced),
    ]
    return Report(claims, figures(by_sigma, ten_actions, by_rate))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def warm_up() -> None:
    """Compile what the cells of the lesson need."""
    compare(repetitions=1, n_steps=100, jobs=1)


def early_claims(by_sigma: Mapping[float, Results]) -> list[Claim]:
    """Return the claims on the first episodes."""
    return [
        Claim(
            f"Early on {label(n)} is ahead of n = 1 (σ = {sigma:g})",
            f"return after {EARLY // DAYS} episodes less that of n = 1",
            early_difference(results, label(n), ONE_STEP),
            Above(0.5),
            "one-step updates carry the exam's reward back by one day an episode",
        )
        for sigma, results in by_sigma.items()
        for n in DEPTHS[1:]
        if sigma == 0.2 or n == math.inf
    ]


def late_claims(by_sigma: Mapping[float, Results]) -> list[Claim]:
    """Return the claims on the end of training, and on the noise of rewards."""
    return [
        *(
            Claim(
                f"Late n = 1 is ahead of Monte Carlo, on layouts where both pass the exam (σ = {sigma:g})",
                "final return of Monte Carlo less that of n = 1",
                difference_where_both_pass(results, MONTE_CARLO, ONE_STEP),
                Below(-0.05),
                "what is left to learn then is which free days are cheap",
            )
            for sigma, results in by_sigma.items()
        ),
        Claim(
            "Over all layouts Monte Carlo and n = 1 end within 2 of each other (σ = 0.2)",
            "final return of Monte Carlo less that of n = 1",
            final_difference(by_sigma[0.2], MONTE_CARLO, ONE_STEP),
            Within(-2.0, 2.0),
            remark="the few runs that never pass the exam, worth 10 each, hide the small difference",
        ),
        *(
            Claim(
                f"Noise can help: with σ = 1 {method} passes the exam on more layouts than without noise",
                "share of runs that pass, σ = 1 less σ = 0",
                paired_difference(passes(by_sigma[1.0], method), passes(by_sigma[0.0], method)),
                Above(0.01),
            )
            for method in (ONE_STEP, MONTE_CARLO)
        ),
        Claim(
            "With σ = 1 Monte Carlo ends at most 0.5 lower than without noise",
            "final return of Monte Carlo at σ = 1 less that at σ = 0",
            paired_difference(
                expected_returns(by_sigma[1.0], MONTE_CARLO), expected_returns(by_sigma[0.0], MONTE_CARLO)
            ),
            Above(-0.5),
            remark="the paper says that it suffers; but with noise fewer runs fail the exam",
        ),
    ]


def action_claims(five_actions: Results, ten_actions: Results) -> list[Claim]:
    """Return the claims on more actions without a use."""
    return [
        Claim(
            f"With ten actions {label(n)} ends far behind n = 1",
            "final return less that of n = 1",
            final_difference(ten_actions, label(n), ONE_STEP),
            Below(-1.5),
            "deep targets hand less of the value of untried actions back, so that more runs never meet the exam",
            UNTRIED,
        )
        for n in WITH_TEN_ACTIONS[1:]
    ] + [
        Claim(
            "Going from five to ten actions costs Monte Carlo more than n = 1",
            "loss of Monte Carlo less that of n = 1",
            paired_difference(
                expected_returns(five_actions, MONTE_CARLO) - expected_returns(ten_actions, MONTE_CARLO),
                expected_returns(five_actions, ONE_STEP) - expected_returns(ten_actions, ONE_STEP),
            ),
            Above(1.5),
        )
    ]


def meeting_claims(ten_actions: Results) -> list[Claim]:
    """Return the claims on who meets the exam at all, with ten actions."""
    met = {method: met_exam(ten_actions, method) for method in ten_actions.methods}
    return [
        *(
            Claim(
                f"With ten actions {label(n)} meets the exam in fewer runs than n = 1",
                "share of runs that ever passed in training, less that of n = 1",
                paired_difference(met[label(n)], met[ONE_STEP]),
                Below(-0.2),
                "untried actions are worth 0 and tried ones less; bootstrapping hands that on, and returns do not",
                UNTRIED,
            )
            for n in WITH_TEN_ACTIONS[1:]
        ),
        Claim(
            "With ten actions some Monte Carlo runs meet the exam",
            "share of runs that ever passed in training",
            share_interval(met[MONTE_CARLO]),
            Above(0.05),
            remark="these runs show whether Monte Carlo forgets what it has met",
        ),
        Claim(
            "With ten actions Monte Carlo runs that meet the exam still pass it in the end",
            "share of runs that pass in the end, less the share that ever passed",
            paired_difference(passes(ten_actions, MONTE_CARLO), met[MONTE_CARLO]),
            Within(-0.1, 0.1),
            remark="so its loss is one of exploration, not of credit",
        ),
    ]


def start_claims(by_start: Mapping[tuple[float, float], Results]) -> list[Claim]:
    """Return the claims on start values below 0, where untried actions look worst."""
    met = {(*at, method): met_exam(results, method) for at, results in by_start.items() for method in results.methods}
    keeps = {(*at, method): kept(results, method) for at, results in by_start.items() for method in results.methods}
    zero = [setting for setting in START_VALUES if setting[0] == 0]
    return [
        *(
            Claim(
                needs_untried(start, sigma, method),
                "share of runs that ever passed in training, less that with start values of 0",
                paired_difference(met[start, sigma, method], met[0.0, sigma, method]),
                Below(-0.1),
            )
            for start, sigma in LOW_STARTS
            for method in (ONE_STEP, MONTE_CARLO)
        ),
        *(
            Claim(
                f"With start values of {start:g} most n = 1 runs that have met the exam fail it (σ = {sigma:g})",
                "share that passes in the end",
                share_interval(keeps[start, sigma, ONE_STEP]),
                Below(0.5),
                "a pass is handed back by one day only, through values that start far too low",
                (*(keeps_it(MONTE_CARLO, *at) for at in LOW_STARTS), *(keeps_it(ONE_STEP, *at) for at in zero)),
            )
            for start, sigma in LOW_STARTS
        ),
        *(
            Claim(
                keeps_it(method, *at),
                "share that passes in the end",
                share_interval(keeps[(*at, method)]),
                Above(0.35 if at in LOW_STARTS else 0.6),
            )
            for method, settings in ((MONTE_CARLO, LOW_STARTS), (ONE_STEP, zero))
            for at in settings
        ),
    ]


def keeps_it(method: str, start: float, sigma: float) -> str:
    """Return the statement that many runs of a method that have met the exam pass it in the end."""
    return f"With start values of {start:g} many {method} runs that have met the exam pass it (σ = {sigma:g})"


def cutting_claims(too_high: Mapping[tuple[float, float], Mapping[str, Reals]]) -> list[Claim]:
    """Return the claims on the rule of exercise 3, which asks after the update whether an action is the best."""
    noisy, quiet = CUTTING[:-1], CUTTING[-1]
    return [
        *(
            Claim(
                f"Cut after the update, targets make values too high (σ = {sigma:g}, learning rate {rate:g})",
                "value of the start less the exact return of the greedy policy",
                mean_interval(too_high[sigma, rate][AFTER]),
                Above(0.2),
                "an unlucky return is replaced by the largest value, and a lucky one is handed on",
                tuple(asked_when_taken(*setting) for setting in noisy),
            )
            for sigma, rate in noisy
        ),
        *(
            Claim(
                asked_when_taken(sigma, rate),
                "the same, cut where the action was not the best when taken, less cut after the update",
                paired_difference(too_high[sigma, rate][WHEN_TAKEN], too_high[sigma, rate][AFTER]),
                Below(-0.2),
            )
            for sigma, rate in noisy
        ),
        Claim(
            "Negative control: cut after the update, targets hardly make values too high at σ = 0.2",
            "value of the start less the exact return of the greedy policy",
            mean_interval(too_high[quiet][AFTER]),
            Within(-0.15, 0.15),
        ),
    ]


def asked_when_taken(sigma: float, rate: float) -> str:
    """Return the statement that the value falls where luck cannot decide what is cut."""
    return (
        f"If it is asked when the action is taken, before luck can tell, values are less high (σ = {sigma:g}, learning"
        f" rate {rate:g})"
    )


def figures(by_sigma: Mapping[float, Results], ten_actions: Results, by_rate: Mapping[float, Results]) -> list[Sheet]:
    """Return the figures: learning curves, the learning rates, and the target by n."""
    tasks = layouts(by_sigma[0.2])
    optimum, soft = best_returns(tasks, 0.0, EPSILON)
    [ten] = best_returns(layouts(ten_actions), 0.0)
    greedy = [Curves(results, f"σ = {sigma:g}", optimum=optimum) for sigma, results in by_sigma.items()]
    exploring = [
        Curves(results, f"exploring, σ = {sigma:g}", column="training_return", soft_optimum=soft)
        for sigma, results in by_sigma.items()
    ]
    return [
        Sheet("depth", [greedy, exploring]),
        Sheet("ten_actions", [[Curves(ten_actions, "ten actions, σ = 0.2", optimum=ten)]]),
        Sheet("rates", [[rate_series(by_rate)]]),
        variance_sheet(),
        Sheet("bias", [[bias_series()]]),
    ]

"""Model-based learning (lesson 9): planning in Supermarket, with a model that is learned or given, right or wrong.

Every method trains for 10 000 steps with discount 0.99, learning rate 1 and ε-greedy exploration with ε = 0.1, except
for R-max, which needs neither rate nor ε. Dyna-Q and prioritised sweeping plan with 10 updates a step (Dyna-50 with
50), R-max with up to 1 000. 60 repetitions (100 of the remedies); the seeds are the same for every method.

The given model has wrong rewards where `noise` is above 0: each repetition has a layout of its own, which draws the
errors, the same for every method; 24 repetitions, and 100 layouts for plans that nobody learns from. With a given model
discount is 0.95.

In 12 other shops the walls, the entrance and the exit are the same, and the items are in other places, drawn at random;
20 repetitions in each. There returns are in percent of what the best plan returns.

"Final" is the return of the last greedy evaluation episode. A policy that never gets to the exit returns -300 or less.
The best way returns 95.

Time budgets (`step_timeout` and `planning_seconds`) are not compared here: how much an agent plans in a millisecond
differs from machine to machine.
"""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from edugym.agents.dyna_q import DynaQ
from edugym.agents.prioritised_sweeping import PrioritisedSweeping
from edugym.experiments.results.claims import Above, Below, Claim, Within, beginning
from edugym.experiments.results.statistics import (
    Interval,
    mean_interval,
    paired_difference,
    proportion_interval,
    share_interval,
)
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.model_based.figures import figures
from edugym_course.lessons.model_based.methods import (
    DECAYING,
    DYNA_10,
    DYNA_50,
    EARLY,
    EPSILON,
    GIVEN,
    LEARNED,
    MORE_RANDOM,
    N_STEPS,
    NOISES,
    OPTIMUM,
    PLANNING_DISCOUNT,
    POINTS,
    Q_LEARNING,
    R_MAX,
    REMEDIES,
    REPETITIONS,
    SLOW_DYNA,
    SWEEPING,
    WRONG,
    compare,
    make,
    targets_computed,
    with_right_model,
)
from edugym_course.lessons.model_based.plans import Plan, follow_plan, used_and_seen
from edugym_course.lessons.model_based.shops import SHOPS, Elsewhere, compare_shops
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

AT_WALLS = ((1.5, 0.95), (1.5, 0.9), (2.0, 0.9))
"""Noise and discount of plans without the errors at the walls."""
MUCH_PLANNING = "Dyna-200, α = 0.1"
TOO_MUCH = "With learning rate 0.1 and 200 imagined steps for each real one the wrong model wins more often"
"""The claim that it is the many real steps that save Dyna-10 with the small rate from a wrong model."""
KNOWS_MORE = f"In the other shops {DECAYING} gets to know more than {DYNA_10}, and ends higher"
"""The claim that exploration is what the planners lack, wherever the items are."""


def warm_up() -> None:
    """Compile what the cells of the lesson need."""
    targets_computed(compare({**LEARNED, **REMEDIES}, n_steps=POINTS, repetitions=1, jobs=1))
    compare(with_right_model(GIVEN), n_steps=POINTS, repetitions=1, jobs=1)


def early(results: Results, method: str) -> Reals:
    """Return the mean of the evaluations in the first steps of every run, shape (n_repetitions,)."""
    mean: Reals = results.curves(method).loc[:EARLY].to_numpy(float).mean(axis=0)
    return mean


def difference(one: Results, method: str, other: Results, compared: str) -> Interval:
    """Return the final return of a method less that of another one, paired by the repetitions that both have."""
    returns, others = one.final(method), other.final(compared)
    shared = min(len(returns), len(others))
    return paired_difference(returns[:shared], others[:shared])


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    learned = compare(LEARNED, **how("learned"))
    more = {"repetitions": 5 * how.repetitions // 3}  # final returns differ much from run to run
    remedied = compare({DYNA_10: LEARNED[DYNA_10], **REMEDIES}, **how("remedies", **more))
    fewer: dict[str, Any] = {"repetitions": max(2 * how.repetitions // 5, 2)}  # the effects of errors are large
    right = compare(with_right_model(GIVEN), **how("noise_0", **fewer))
    wrong = compare(GIVEN, noise=WRONG, **how(f"noise_{WRONG:g}", **fewer))
    dyna_200 = {MUCH_PLANNING: partial(make, DynaQ, given=True, planning_steps=200, learning_rate=0.1)}
    much = compare(dyna_200, noise=WRONG, **how("much_planning", **fewer))
    whole = {SWEEPING: partial(make, PrioritisedSweeping, given=True, planning_steps=math.inf)}
    at_once = compare(with_right_model(whole), n_steps=1, **how(**fewer))
    layouts = sorted(int(seed) for seed in remedied.table["layout_seed"].unique())  # as there are most of them
    plans = {noise: [follow_plan(noise, seed) for seed in layouts] for noise in NOISES}
    few: dict[str, Any] = {"repetitions": max(how.repetitions // 3, 2)}  # in each shop
    shops = compare_shops({**LEARNED, DECAYING: REMEDIES[DECAYING]}, **how(**few))
    return learned, remedied, right, wrong, much, at_once, plans, shops


def judge(
    learned: Results,
    remedied: Results,
    right: Results,
    wrong: Results,
    much: Results,
    at_once: Results,
    plans: Mapping[float, list[Plan]],
    elsewhere: Mapping[str, Elsewhere],
) -> Report:
    """Return claims and figures."""
    claims = [
        *speed_claims(learned),
        *end_claims(learned, remedied),
        *remedy_claims(learned, remedied),
        *shop_claims(elsewhere),
        *given_claims(right, at_once),
        *plan_claims(plans),
        *wall_claims(range(len(plans[WRONG]))),
        *noise_claims(right, wrong, much),
    ]
    return Report(claims, figures(learned, remedied, right, wrong, plans))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def speed_claims(learned: Results) -> list[Claim]:
    """Return the claims on the real steps that learning takes."""
    return [
        Claim(
            f"{beginning(method)} learns in fewer steps than Q-learning",
            f"greedy return, mean over the first {EARLY} steps, less that of Q-learning",
            paired_difference(early(learned, method), early(learned, Q_LEARNING)),
            Above(200.0),
            remark="one real step is followed by many updates from memory; Q-learning is Dyna without these updates",
        )
        for method in (DYNA_10, DYNA_50, SWEEPING)
    ]


def helps(method: str) -> str:
    """Return the claim that a remedy mends what Dyna-10 lacks."""
    return f"More exploration helps: {method} ends above {DYNA_10} with ε = {EPSILON:g}"


def end_claims(learned: Results, remedied: Results) -> list[Claim]:
    """Return the claims on where more planning ends."""
    seen = {method: best for method, (_, best) in used_and_seen(learned).items()}
    return [
        *(
            Claim(
                f"With the items in their usual places {method} ends below Q-learning, which does not plan",
                "final return less that of Q-learning",
                difference(learned, method, learned, Q_LEARNING),
                Below(-2.0),
                "its model has not seen the whole shop",
                (helps(DECAYING), KNOWS_MORE),
                "with the items in other places it may end above; the paper shows the quick start only",
            )
            for method in (DYNA_10, DYNA_50, SWEEPING)
        ),
        *(
            Claim(
                f"What {method} has seen allows a lower return than what Q-learning has seen",
                "return of the best plan by what was seen, less that of Q-learning",
                paired_difference(seen[method], seen[Q_LEARNING]),
                Below(-3.0),
                "an agent that plans well exploits early, and gets to know less unless it explores on purpose",
                (helps(DECAYING), KNOWS_MORE),
            )
            for method in (DYNA_10, DYNA_50, SWEEPING)
        ),
        *(
            Claim(
                f"{more} planning does not replace exploration: {method} ends below {DECAYING}",
                f"final return less that of {DECAYING}",
                difference(learned, method, remedied, DECAYING),
                Below(-1.0),
                "planning invents no knowledge",
                (uses_all(method),),
            )
            for more, method in (("Five times as much", DYNA_50), ("Better", SWEEPING))
        ),
    ]


def remedy_claims(learned: Results, remedied: Results) -> list[Claim]:
    """Return the claims on exploring more, and on planning to explore."""
    return [
        *(
            Claim(
                helps(method), "final return, difference", difference(remedied, method, remedied, DYNA_10), Above(1.0)
            )
            for method in (DECAYING, MORE_RANDOM)
        ),
        Claim(
            f"Planning to explore helps: R-max is at the optimum after {EARLY} steps",
            "share of runs with return 95",
            share_interval(learned.at(R_MAX, EARLY) >= OPTIMUM),
            Above(0.8),
            "it plans as if unknown actions were worth most, so it tries them",
        ),
        *(
            Claim(
                f"{beginning(method)} is not at the optimum after {EARLY} steps",
                "share of runs with return 95",
                share_interval(learned.at(method, EARLY) >= OPTIMUM),
                Below(0.5),
            )
            for method in (Q_LEARNING, DYNA_10, DYNA_50, SWEEPING)
        ),
    ]


def uses_all(method: str) -> str:
    """Return the claim that a planner makes the most of what it has seen."""
    return f"In the other shops too {method} makes the most of what it has seen"


def shop_claims(elsewhere: Mapping[str, Elsewhere]) -> list[Claim]:
    """Return the claims on shops with the items in other places: what is general, and what is not."""
    returns = {method: found.returns.mean(axis=1) for method, found in elsewhere.items()}
    seen = {method: found.seen.mean(axis=1) for method, found in elsewhere.items()}
    lead = returns[Q_LEARNING] - returns[DYNA_10]
    percent = "percent of what the best plan returns"
    return [
        Claim(
            "Whether Q-learning or Dyna-10 ends higher depends on where the items are",
            f"share of {len(SHOPS)} shops in which Q-learning does, by the means of the runs",
            share_interval(lead > 0.0),
            Within(0.2, 0.95),
        ),
        Claim(
            "On average over the shops neither Q-learning nor Dyna-10 is far ahead at the end",
            f"Q-learning less Dyna-10, {percent}",
            mean_interval(lead),
            Within(-20.0, 20.0),
        ),
        *(
            Claim(
                f"In nearly every other shop {method} gets to know less than Q-learning",
                "share of shops, by the means of the best plans by what was seen",
                share_interval(seen[method] < seen[Q_LEARNING]),
                Above(0.5),
                "an agent that plans well exploits early",
                (KNOWS_MORE,),
            )
            for method in (DYNA_10, DYNA_50, SWEEPING)
        ),
        *(
            Claim(
                uses_all(method),
                f"return of the best plan by what it has seen, less its own, {percent}",
                mean_interval(elsewhere[method].seen - elsewhere[method].returns),
                Within(-1.0, 1.0),
            )
            for method in (DYNA_10, DYNA_50, SWEEPING)
        ),
        Claim(
            "In the other shops Q-learning knows more than it uses",
            f"return of the best plan by what it has seen, less its own, {percent}",
            mean_interval(seen[Q_LEARNING] - returns[Q_LEARNING]),
            Above(3.0),
            "without planning it needs many visits to make a value of what it has seen",
            tuple(uses_all(method) for method in (DYNA_10, DYNA_50, SWEEPING)),
        ),
        Claim(
            KNOWS_MORE,
            f"the lesser gain of the two, mean of a shop, {percent}",
            mean_interval(np.minimum(seen[DECAYING] - seen[DYNA_10], returns[DECAYING] - returns[DYNA_10])),
            Above(3.0),
        ),
        Claim(
            "R-max is at the best plan in the other shops too",
            f"final return, {percent}",
            mean_interval(returns[R_MAX]),
            Above(99.0),
        ),
    ]


def given_claims(right: Results, at_once: Results) -> list[Claim]:
    """Return the claims on planning with the right model."""
    return [
        Claim(
            "With the right model given, planning until nothing changes finds the best way before the first step",
            "share of runs with return 95 after one step",
            at_once.share(SWEEPING, OPTIMUM),
            Above(0.8),
            remark="dynamic programming: nothing is left to explore",
        ),
        Claim(
            "Samples of a generative model are enough: Dyna-10 with the right model given ends with 95",
            "share of runs that end with 95",
            right.share(DYNA_10, OPTIMUM),
            Above(0.8),
            remark=f"it draws {N_STEPS * 10} samples in all; sweeping over the descriptive model is done at once",
        ),
    ]


def saved(noise: float, discount: float) -> str:
    """Return the claim that it is the errors at the walls that lose most plans."""
    return f"Without the errors at the walls most lost plans get to the exit (noise {noise:g}, discount {discount:g})"


def plan_claims(plans: Mapping[float, list[Plan]]) -> list[Claim]:
    """Return the claims on plans that are made with a wrong model."""
    lost = {noise: [plan for plan in made if not plan.ends] for noise, made in plans.items()}
    share = {noise: proportion_interval(len(lost[noise]), len(plans[noise])) for noise in NOISES}
    of_layouts = f"share of layouts, discount {PLANNING_DISCOUNT:g}"
    return [
        Claim("With noise 0.5 hardly a plan fails", of_layouts, share[0.5], Below(0.2)),
        Claim("With noise 1 a few plans never get to the exit", of_layouts, share[1.0], Within(0.01, 0.5)),
        Claim("With noise 1.5 most plans never get to the exit", of_layouts, share[1.5], Above(0.5)),
        Claim(
            "Most plans that never end walk into the same wall for ever",
            f"share of the plans that never end, noise {WRONG:g}",
            share_interval([plan.bumps for plan in lost[WRONG]]),
            Above(0.5),
            "with an error above 1 the wall seems to pay for each bump, so that bumping without end is worth most",
            tuple(saved(*setting) for setting in AT_WALLS),
        ),
    ]


def wall_claims(layouts: Sequence[int]) -> list[Claim]:
    """Return the claims on plans without the errors at the walls, in layouts with these seeds."""
    claims = []
    for noise, discount in AT_WALLS:
        fail = [seed for seed in layouts if not follow_plan(noise, seed, discount).ends]
        ends = [follow_plan(noise, seed, discount, errors_at_walls=False).ends for seed in fail]
        quantity = "share of the plans that never end with these errors"
        claims.append(Claim(saved(noise, discount), quantity, share_interval(ends), Above(0.5)))
    return claims


def noise_claims(right: Results, wrong: Results, much: Results) -> list[Claim]:
    """Return the claims on agents that learn with a wrong model."""
    slow_rate = f"With learning rate 0.1 Dyna-10 gets over noise {WRONG:g} in most runs: it loses less than 50"
    return [
        *(
            Claim(
                f"Noise {WRONG:g} in the given model ruins {method}",
                "final return less that without noise",
                difference(wrong, method, right, method),
                Below(-100.0),
                reason,
                tested_by,
            )
            for method, reason, tested_by in (
                (SWEEPING, "all that it learns comes from the model", ()),
                (DYNA_10, "with learning rate 1 each imagined reward overwrites what was lived", (slow_rate,)),
            )
        ),
        Claim(
            slow_rate,
            "share of runs",
            share_interval(wrong.final(SLOW_DYNA) - right.final(SLOW_DYNA) > -50.0),
            Above(0.7),
            "where it walks, real steps are more frequent than imagined ones, and they win",
            (TOO_MUCH,),
        ),
        Claim(
            TOO_MUCH,
            "final return, Dyna-200 less Dyna-10",
            difference(much, MUCH_PLANNING, wrong, SLOW_DYNA),
            Below(-50.0),
        ),
    ]

"""Discrete and continuous actions (lesson 7): how exactly, and how soon, a robot arm learns to place a box.

On Trashbot (defaults: 150 steps an episode, container 0.45 wide), 30 repetitions of 100 000 steps, discount 0.99:
REINFORCE with a baseline on a table (30 by 30 cells for the wrist, and whether the box is held; both learning rates
0.4), with 3, 5 and 9 bins for each joint; and a Gaussian actor-critic on tile coding (8 tilings of 20 by 20 tiles;
σ 0.5, learning rates 0.02 and 0.4, first values 1) with continuous actions. Each point is one greedy episode. Returns
are undiscounted. The best returns with bins come from an exact search; with continuous actions it is 5.

PPO with 3, 5 and 9 bins and with continuous actions, where nothing but the action space differs, has stored results of
ten seeds (`continuous_actions.ppo`). The gradient of a Gaussian policy is checked on one decision (`release`).
"""

from typing import Any

import numpy as np

from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import (
    exactly,
    mean_interval,
    paired_difference,
    proportion_interval,
    share_interval,
)
from edugym.experiments.results.tables import Results, joined
from edugym_course.lessons.continuous_actions.exact import best_return, deliveries
from edugym_course.lessons.continuous_actions.figures import curves, exact_figure, narrowing, peaks, ppo_figure
from edugym_course.lessons.continuous_actions.methods import (
    BINS,
    frozen_lake,
    learn_all,
    learn_bins,
    learn_continuous,
    name,
    steps_to,
)
from edugym_course.lessons.continuous_actions.ppo import ACTIONS, CONTINUOUS, STORED
from edugym_course.lessons.continuous_actions.release import climb, estimates, slopes, value
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

REPETITIONS = 30
WIDE_STARTS = ((0.0, 2.0), (0.25, 1.5), (0.5, 1.0))
"""μ and σ at first of Gaussian policies that see both containers."""
SMALL_RATES = (0.001, 0.003, 0.01)
"""Learning rates at which the noise of narrow policies decides."""
NARROW = 0.3
"""The width of a narrow container."""
GOAL = 3.5
"""The return that says that the box is delivered well: the speed of learning is the steps to it."""


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    wide = joined([*(learn_bins(n, **how(f"bins_{n}")) for n in BINS), learn_continuous(**how("continuous"))])
    narrow = joined(
        [
            *(learn_bins(n, width=NARROW, **how(f"narrow_{n}")) for n in BINS[:2]),
            learn_continuous(width=NARROW, **how()),
        ]
    )
    return wide, narrow


def judge(wide: Results, narrow: Results) -> Report:
    """Return claims and figures."""
    stored = STORED.load()
    claims = [
        *exact_claims(),
        *learning_claims(wide, narrow),
        *gradient_claims(),
        *peak_claims(),
        *ppo_claims(stored),
    ]
    sheets = [exact_figure(), Sheet("learning", [[curves(wide, "table and tiles")]]), ppo_figure(stored)]
    return Report(claims, sheets)


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def exact_claims() -> list[Claim]:
    """Return the claims on the best possible returns; they are computed by trying everything."""
    known = {2: 3.85, 3: 4.31, 4: 4.91, 5: 4.89, 7: 4.94, 9: 4.97}
    deviation = max(abs(best_return(n) - best) for n, best in known.items())
    return [
        Claim(
            "The best return with 2, 3, 4, 5, 7 and 9 bins is 3.85, 4.31, 4.91, 4.89, 4.94 and 4.97",
            "largest deviation",
            exactly(deviation),
            Within(0.0, 0.006),
            remark="more bins are mostly better, but 5 do not beat 4",
        ),
        Claim(
            "Into a container 0.3 wide 3 bins cannot bring the box at all, and 5 can",
            "best return with 5 bins, if that with 3 is 0",
            exactly(best_return(5, NARROW) if best_return(3, NARROW) == 0.0 else 0.0),
            Within(4.5, 4.65),
        ),
    ]


def learning_claims(wide: Results, narrow: Results) -> list[Claim]:
    """Return the claims on the fast agents."""
    three, five, nine = map(name, BINS)
    return [
        Claim(
            "Learning with 5 bins ends at a higher return than with 3",
            "greedy return, late, 5 bins less 3",
            paired_difference(wide.late(five), wide.late(three)),
            Above(0.1),
        ),
        Claim(
            "Most runs with continuous actions end above the best that 3 bins can do",
            "share of the runs whose greedy return, late, is above 4.31",
            share_interval(wide.late(CONTINUOUS) > best_return(BINS[0])),
            Above(0.5),
        ),
        Claim(
            "3 bins reach a return of 3.5 sooner than 5",
            "training steps, 3 bins less 5",
            paired_difference(steps_to(wide, three, GOAL), steps_to(wide, five, GOAL)),
            Below(-5_000.0),
            remark="on the same table, with the same agent",
        ),
        Claim(
            "5 bins reach a return of 3.5 sooner than 9",
            "training steps, 5 bins less 9",
            paired_difference(steps_to(wide, five, GOAL), steps_to(wide, nine, GOAL)),
            Below(-5_000.0),
        ),
        Claim(
            "Continuous actions reach a return of 3.5 sooner than 9 bins",
            "training steps, continuous less 9 bins",
            paired_difference(steps_to(wide, CONTINUOUS, GOAL), steps_to(wide, nine, GOAL)),
            Below(-5_000.0),
            remark="agent and features differ too",
        ),
        Claim(
            "With 3 bins and the narrow container the box is never delivered",
            "greedy return, late",
            mean_interval(narrow.late(three)),
            Below(0.5),
        ),
        Claim(
            "A narrower container makes 5 bins worse",
            "greedy return, late, narrow less wide",
            paired_difference(narrow.late(five), wide.late(five)),
            Below(-2.0),
        ),
        Claim(
            "A narrower container makes continuous actions worse",
            "greedy return, late, narrow less wide",
            paired_difference(narrow.late(CONTINUOUS), wide.late(CONTINUOUS)),
            Below(-2.0),
        ),
    ]


def gradient_claims() -> list[Claim]:
    """Return the claims on the gradient of a Gaussian policy, and on baselines."""
    exact = slopes(0.6, 0.5)
    found = estimates(0.6, 0.5, 200_000, baseline=1.0)
    without, with_baseline = (
        estimates(0.1, 0.1, 100_000, baseline=b)[0].reshape(10, -1).std(axis=1) for b in (0.0, value(0.1, 0.1))
    )
    ends = {on: climb(baseline=on).values[-200:].mean(axis=0) for on in (True, False)}
    outside = {(rate, on): outside_in_the_end(rate, baseline=on) for rate in (0.03, 0.1) for on in (True, False)}
    return [
        *(
            Claim(
                f"The mean of (R - b) times the score of {of} is the slope of J in {of}",
                "mean of the estimates less finite differences",
                mean_interval(by_actions - by_differences),
                Within(-0.05, 0.05),
            )
            for of, by_actions, by_differences in zip(("μ", "ln σ"), found, exact, strict=True)
        ),
        Claim(
            "The baseline J makes the estimate of a narrow policy near the middle ten times less noisy",
            "standard deviation of 10,000 estimates without a baseline, over that with it",
            mean_interval(without / with_baseline),
            Above(10.0),
        ),
        Claim(
            "With a baseline all policies end near the middle, without one they are thrown out (learning rate 0.01)",
            "mean reward in the end, with less without",
            paired_difference(ends[True], ends[False]),
            Above(3.0),
            "the scores grow as σ shrinks, and with them the noise that the baseline takes away",
            tuple(map(wide_stays, SMALL_RATES)),
        ),
        *(
            Claim(
                wide_stays(rate),
                "share of 100 policies that ever leave",
                share_interval(leaves(rate, baseline=False, smallest=0.2)),
                Below(0.05),
            )
            for rate in SMALL_RATES
        ),
        Claim(
            "With learning rate 0.03 most policies are outside in the end without a baseline",
            "share of 100 policies",
            share_interval(outside[0.03, False]),
            Above(0.7),
        ),
        Claim(
            "With learning rate 0.03 few policies are outside in the end with a baseline",
            "share of 100 policies",
            share_interval(outside[0.03, True]),
            Below(0.3),
        ),
        Claim(
            "With learning rate 0.1 a baseline does not keep the policies in the container",
            "share of 100 policies that are outside in the end with a baseline",
            share_interval(outside[0.1, True]),
            Above(0.7),
            remark="a baseline allows larger steps, and not any step",
        ),
    ]


def wide_stays(rate: float) -> str:
    """Return the claim that policies which stay wide need no baseline."""
    return f"Without a baseline policies whose σ stays at 0.2 or above stay in the container (learning rate {rate:g})"


def leaves(rate: float, **how: Any) -> Any:
    """Return for each of 100 policies whether its mean ever leaves the container, in as many updates as it needs."""
    return np.abs(climb(rate=rate, n_updates=round(20 / rate), **how).means).max(axis=0) > 1.0


def outside_in_the_end(rate: float, **how: Any) -> Any:
    """Return for each of 100 policies whether its mean is outside of the container after 2 000 updates."""
    return np.abs(climb(rate=rate, **how).means[-1]) > 1.0


def peak_claims() -> list[Claim]:
    """Return the claims on two containers."""
    _, found = peaks()
    starts = {start: peaks(*start)[1]["Gaussian"] for start in WIDE_STARTS}
    return [
        Claim(
            "A Gaussian policy that starts over the poor container stays there",
            "share of 100 runs that end at the rich one",
            proportion_interval(round(100 * found["Gaussian"]), 100),
            Below(0.05),
            "a narrow Gaussian sees only what is near",
            tuple(found_from(*start) for start in WIDE_STARTS),
            "continuous is not always better",
        ),
        *(
            Claim(
                found_from(*start),
                "share of 100 runs that end at the rich container",
                proportion_interval(round(100 * share), 100),
                Above(0.5),
            )
            for start, share in starts.items()
        ),
        Claim(
            "With 10 bins a policy that starts over the poor container finds the rich one",
            "share of 100 runs that end at the rich one",
            proportion_interval(round(100 * found["10 bins"]), 100),
            Above(0.9),
        ),
    ]


def found_from(mean: float, spread: float) -> str:
    """Return the claim that a Gaussian policy finds the rich container if it starts wide enough."""
    return f"Most Gaussian policies that start wide between the containers find the rich one (μ {mean:g}, σ {spread:g})"


def ppo_claims(stored: Results) -> list[Claim]:
    """Return the claims on PPO."""
    three, five, nine = map(name, BINS)
    drawn = {label: stored.late(label, column="training_return") for label in ACTIONS}
    speed = {label: steps_to(stored, label, 3.0, "training_return") for label in ACTIONS}
    told = "results of ten seeds, stored with the package"
    return [
        *(
            Claim(
                f"PPO reaches a return of 3 sooner with 3 bins than with {label}",
                f"training steps to a return of 3 with drawn actions, 3 bins less {label}",
                paired_difference(speed[three], speed[label]),
                Below(-40_000.0),
                remark=told,
            )
            for label in (five, nine)
        ),
        Claim(
            "With drawn actions PPO with 3 bins comes near the best return that 3 bins allow",
            "return, late",
            mean_interval(drawn[three]),
            Within(4.0, 4.31),
            remark=told,
        ),
        Claim(
            "Some runs of PPO deliver the box with drawn actions, and not with the likeliest ones",
            "share of all runs with a return above 3 drawn, late, and below 1 likeliest, at the end",
            share_interval(np.concatenate([(drawn[x] > 3.0) & (stored.final(x) < 1.0) for x in ACTIONS])),
            Above(0.05),
            remark=told,
        ),
    ]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    learn_all(n_steps=1_000, repetitions=1)
    deliveries(2)
    frozen_lake(50, repetitions=1)
    narrowing(n_updates=10).draw()

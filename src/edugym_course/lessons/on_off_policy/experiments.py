"""On- and off-policy learning (lesson 2): Q-learning, SARSA and expected SARSA at the edge of a cliff.

On Roadrunner, with its defaults (W = 10, R = -100) and discount 1, every method trains for 200 000 steps with ε-greedy
exploration: ε = 0.1 and learning rate 0.03; in the stop zone, ε = 0.2 and learning rate 0.1. 30 repetitions; the seeds
are the same for every method. "Greedy" is the return of the last evaluation episode. "Online" is the mean return of the
training episodes in the second half of training, explored as the method does. On an icy road the road makes the runner
slip, with probability 0.1. Reasons are tested on roads of length 11 and 14, too. On CliffWalking: 20 000 steps,
learning rate 0.1, at most 500 steps in an episode, and 10 repetitions.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.envs.roadrunner import Roadrunner
from edugym.exact.model import finite_model
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym_course.lessons.on_off_policy.exact import FAST, SAFE, best_soft_return, switch
from edugym_course.lessons.on_off_policy.figures import learning_curves, switch_lines
from edugym_course.lessons.on_off_policy.methods import (
    EPSILON,
    EXPECTED_SARSA,
    KINDS,
    LEARNING_RATE,
    N_STEPS,
    Q_LEARNING,
    REPETITIONS,
    SARSA_,
    compare,
    compare_on_cliff,
    compare_on_ice,
    greedy_run,
    let_epsilon_decay,
    online_lead,
    stopping_places,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

CLIFF_REPETITIONS = 10
"""Fewer than elsewhere, since an environment of Gymnasium does not run as machine code."""
ROADS = (10, 11, 14)
"""Lengths of roads on which the fast run is the best for ε = 0.01, and the safe one for ε = 0.1."""
GENTLE = 0.003
"""A learning rate with which a single fall takes no more than 0.3 off a value."""
TINY, TINY_STEPS = 0.001, 3_000_000
"""One with which it takes no more than 0.1 off, and steps in which values come to what they should be with it too."""
EDGE_WALK = -13.0
"""The return of the shortest walk on CliffWalking, which is along the edge."""


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    return (
        compare(**how("edge")),
        compare(epsilon=0.2, learning_rate=0.1, parameters={"stop_zone": 2}, **how("zone")),
        {
            "falls that cost 5": zone_of(epsilon=0.2, negative_reward=-5.0, **how()),
            "ε = 0.01": zone_of(epsilon=0.01, negative_reward=-100.0, **how()),
        },
        compare(parameters={"negative_reward": -10.0}, **how("mild")),
        {
            (size, rate): compare(epsilon=0.01, learning_rate=rate, n_steps=n_steps, parameters={"size": size}, **how())
            for size in ROADS
            for rate, n_steps in ((LEARNING_RATE, N_STEPS), (TINY, TINY_STEPS))
        },
        compare(learning_rate=0.5, **how()),
        let_epsilon_decay(**how()),
        compare_on_ice(**how("ice")),
        compare_on_cliff(**how("cliff", repetitions=min(CLIFF_REPETITIONS, how.repetitions))),
    )


def judge(
    edge: Results,
    zone: Results,
    no_danger: Mapping[str, Results],
    mild: Results,
    tiny: Mapping[tuple[int, float], Results],
    rough: Results,
    decayed: Results,
    ice: Results,
    cliff: Results,
) -> Report:
    """Return claims and figures."""
    claims = [
        *edge_claims(edge),
        *zone_claims(zone, no_danger),
        *rare_claims(tiny),
        *condition_claims(mild, rough, decayed),
        *other_cliff_claims(ice, cliff),
        switch_claim(),
    ]
    return Report(claims, figures(edge, zone))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def zone_of(negative_reward: float, **how: Any) -> Results:
    """Train on a road with a stop zone of 2 cells, gently; more arguments as in `compare`."""
    parameters = {"stop_zone": 2, "negative_reward": negative_reward}
    return compare(learning_rate=GENTLE, parameters=parameters, **how)


FAST_WITHOUT_SLIPS = "Greedy, Q-learning reaches the optimum"


def expected_is_level(size: int) -> str:
    """Return the claim that removes the drawing of the next action."""
    return f"With ε = 0.01 and W = {size} expected SARSA and Q-learning earn the same, up to 0.15"


def tiny_is_level(size: int) -> str:
    """Return the claim that makes single slips count for little."""
    return f"With ε = 0.01, W = {size} and learning rate {TINY:g} SARSA and Q-learning earn the same, up to 0.1"


CHEAP_FALLS = "Where falling costs only 10, expected SARSA earns as much online as Q-learning"


def edge_claims(edge: Results) -> list[Claim]:
    """Return the claims at the edge of the cliff, with `stop_zone` = 0."""
    return [
        Claim(
            FAST_WITHOUT_SLIPS,
            f"share of runs with return {FAST:g}",
            edge.share(Q_LEARNING, at_least=FAST),
            Above(0.5),
        ),
        *(
            Claim(
                f"Greedy, {method} takes a longer, safer run",
                f"share of runs with return {SAFE:g}",
                share_interval(edge.final(method) == SAFE),
                Above(0.5),
                "it has learned the values of a policy that slips",
                (FAST_WITHOUT_SLIPS, *map(expected_is_level, ROADS)),
            )
            for method in (SARSA_, EXPECTED_SARSA)
        ),
        *(
            Claim(
                f"While exploring, {method} earns more than Q-learning",
                f"online return of {method} less that of Q-learning",
                online_lead(edge, method),
                Above(1.0),
                "the shortest run is the one from which a slip falls off the cliff",
                (CHEAP_FALLS, *map(expected_is_level, ROADS)),
            )
            for method in (SARSA_, EXPECTED_SARSA)
        ),
    ]


def zone_claims(zone: Results, no_danger: Mapping[str, Results]) -> list[Claim]:
    """Return the claims on where the runner stops, with `stop_zone` = 2.

    Args:
        zone: the results of the lesson.
        no_danger: the results where a slip at the edge costs little, or is rare, by what makes it so.
    """
    at_the_edge = {what: f"With a stop zone of 2 cells and {what} SARSA stops at the edge" for what in no_danger}
    stops = {method: stopping_places(zone, method, stop_zone=2) for method in KINDS}
    return [
        Claim(
            "With a stop zone of 2 cells Q-learning stops at the edge",
            "cell where the greedy run ends",
            mean_interval(stops[Q_LEARNING]),
            Above(8.7),
        ),
        Claim(
            "With a stop zone of 2 cells SARSA stops before the edge",
            "cell where the greedy run ends, less that of Q-learning",
            paired_difference(stops[SARSA_], stops[Q_LEARNING]),
            Below(-0.2),
            "each cell short of the edge costs 1, and a slip at the edge costs 100",
            (*at_the_edge.values(),),
        ),
        *(
            Claim(
                at_the_edge[what],
                f"cell where the greedy run ends, learning rate {GENTLE:g}",
                mean_interval(stopping_places(results, SARSA_, stop_zone=2)),
                Above(8.7),
            )
            for what, results in no_danger.items()
        ),
    ]


def rare_claims(tiny: Mapping[tuple[int, float], Results]) -> list[Claim]:
    """Return the claims on rare slips, ε = 0.01, by the length of the road and the learning rate."""
    scared = (
        "the fast run is best now, but its target draws A': a single slip takes α times the cost of a fall off a value",
        (*map(tiny_is_level, ROADS), *map(expected_is_level, ROADS)),
    )
    usual = {size: tiny[size, LEARNING_RATE] for size in ROADS}
    return [
        Claim(
            "With ε = 0.01 most runs of SARSA end with the safe run, although the fast one is best",
            f"share of runs with return {SAFE:g}, ε = 0.01",
            share_interval(usual[ROADS[0]].final(SARSA_) == SAFE),
            Above(0.5),
            *scared,
        ),
        *(
            Claim(
                f"With ε = 0.01 and W = {size} the lead of SARSA is gone: it earns at least 0.4 less than Q-learning",
                "online return of SARSA less that of Q-learning, ε = 0.01",
                online_lead(results, SARSA_),
                Below(-0.4),
                *scared,
            )
            for size, results in usual.items()
        ),
        *(
            Claim(
                expected_is_level(size),
                "online return of expected SARSA less that of Q-learning, ε = 0.01",
                online_lead(results, EXPECTED_SARSA),
                Within(-0.15, 0.15),
            )
            for size, results in usual.items()
        ),
        *(
            Claim(
                tiny_is_level(size),
                f"online return of SARSA less that of Q-learning, ε = 0.01, α = {TINY:g}, {TINY_STEPS} steps",
                online_lead(tiny[size, TINY], SARSA_),
                Within(-0.1, 0.1),
            )
            for size in ROADS
        ),
    ]


def condition_claims(mild: Results, rough: Results, decayed: Results) -> list[Claim]:
    """Return the claims on when the difference vanishes, turns round, or cannot be seen."""
    rough_mean = "With learning rate 0.5 expected SARSA, which draws nothing, earns more than Q-learning"
    return [
        Claim(
            "Where falling costs only 10, SARSA earns at least 0.04 less online than Q-learning",
            "online return of SARSA less that of Q-learning, R = -10",
            online_lead(mild, SARSA_),
            Below(-0.04),
            "the fast run is best even with slips, and drawing A' makes its targets noisy",
            (CHEAP_FALLS,),
        ),
        Claim(
            CHEAP_FALLS,
            "online return of expected SARSA less that of Q-learning, R = -10",
            online_lead(mild, EXPECTED_SARSA),
            Within(-0.03, 0.03),
        ),
        Claim(
            "Negative control: with learning rate 0.5 SARSA earns at least 0.7 less than Q-learning",
            "online return of SARSA less that of Q-learning",
            online_lead(rough, SARSA_),
            Below(-0.7),
            "its values then follow the last few A' that it has drawn",
            (rough_mean,),
        ),
        Claim(
            rough_mean,
            "online return of expected SARSA less that of Q-learning, α = 0.5",
            online_lead(rough, EXPECTED_SARSA),
            Above(1.0),
        ),
        Claim(
            "Letting ε decay does not free SARSA from the safe run",
            f"share of runs with return {SAFE:g}",
            share_interval(decayed.final(SARSA_) == SAFE),
            Above(0.5),
        ),
        Claim(
            "Letting ε decay frees expected SARSA",
            f"share of runs with return {FAST:g}",
            decayed.share(EXPECTED_SARSA, at_least=FAST),
            Above(0.5),
            "its target follows ε at once, in every state that it still visits",
        ),
    ]


def other_cliff_claims(ice: Results, cliff: Results) -> list[Claim]:
    """Return the claims on the road with ice, and on the cliff walk of Gymnasium."""
    steps = np.array([len(greedy_run(agent)) - 1 for agent in ice.complete_agents(Q_LEARNING).values()])
    return [
        Claim(
            "On an icy road Q-learning too learns the safe run",
            "share of greedy runs with 5 steps, once the ice has melted",
            share_interval(steps == 5),
            Above(0.5),
            "it leaves out its own slips only; those of the road are part of the task",
            (FAST_WITHOUT_SLIPS,),
        ),
        Claim(
            "On CliffWalking Q-learning walks along the edge when it is greedy",
            f"share of runs with return {EDGE_WALK:g}",
            cliff.share(Q_LEARNING, at_least=EDGE_WALK),
            Above(0.5),
        ),
        *(
            Claim(
                f"On CliffWalking {method} does not walk along the edge when it is greedy",
                f"share of runs with a return below {EDGE_WALK:g}",
                share_interval(cliff.final(method) < EDGE_WALK),
                Above(0.5),
            )
            for method in (SARSA_, EXPECTED_SARSA)
        ),
        *(
            Claim(
                f"On CliffWalking {method} earns more than Q-learning while exploring",
                f"online return of {method} less that of Q-learning",
                online_lead(cliff, method),
                Above(10.0),
            )
            for method in (SARSA_, EXPECTED_SARSA)
        ),
    ]


def switch_claim() -> Claim:
    """Return the claim on the ε at which the best ε-soft run changes; it is exact, so its interval is a point."""
    epsilon = switch(finite_model(Roadrunner.create()))
    return Claim(
        "The best ε-soft run changes from the fast to the safe one between ε = 0.03 and 0.05",
        "ε on the exact model",
        exactly(epsilon),
        Within(0.03, 0.05),
    )


def figures(edge: Results, zone: Results) -> list[Sheet]:
    """Return the figures: greedy and online learning curves, and the exact returns against ε."""
    model = finite_model(Roadrunner.create())
    zone_model = finite_model(Roadrunner.create(stop_zone=2))
    online_curves = [
        Curves(
            results,
            title,
            column="training_return",
            optimum=best_soft_return(task, 0.0),
            soft_optimum=best_soft_return(task, epsilon),
        )
        for results, title, task, epsilon in (
            (edge, "while exploring", model, EPSILON),
            (zone, "while exploring, stop zone 2", zone_model, 0.2),
        )
    ]
    greedy_curves = [
        Curves(edge, "greedy", optimum=best_soft_return(model, 0.0), y_range=(-4.0, -1.5)),
        Curves(zone, "greedy, stop zone 2", optimum=best_soft_return(zone_model, 0.0), y_range=(-4.0, -1.5)),
    ]
    return [Sheet("on_off_policy", [greedy_curves, online_curves]), Sheet("switch", [[switch_lines(model)]])]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    results = compare(n_steps=40, repetitions=2)
    compare_on_cliff(n_steps=40, repetitions=2)
    let_epsilon_decay(n_steps=40, repetitions=2)
    learning_curves(results).draw()

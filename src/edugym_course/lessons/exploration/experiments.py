"""Exploration (lesson 1): the paper's figure on Boulder, and why it looks as it does.

Q-learning with three ways to explore climbs walls of height 10, 30 and 100 for 20 000 steps. Settings: discount 0.9;
learning rate 0.5; ε = 0.1 for ε-greedy and for the novelty reward, which is 1/√n(s') for entering s' for the n-th time;
20 random steps from each goal for Go-Explore; two grips at every height; episodes of at most 10 times the height; 30
repetitions, each with its own layout, which is the same for every method; one greedy evaluation episode for each point.
"Optimism" is greedy Q-learning with all values at 1 and learning rate 1.

A run *solves* the wall when its last greedy episode reaches the top. A method solves the wall when the share of runs
that solve it is above one half with 95 % confidence; it does not solve the wall when the share is below one half.
"""

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from edugym.agents.strategies import EpsilonGreedy
from edugym.experiments.figures import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import Interval, mean_interval, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym_course.lessons.exploration.climbs import (
    first_at_top,
    frontier,
    greedy_leads_to_frontier,
    no_slip,
    random_search_steps,
    return_to_frontier,
    watch_climbs,
    watch_random_search,
)
from edugym_course.lessons.exploration.figures import climb_shares, learning_curves, visit_maps
from edugym_course.lessons.exploration.fork import compare_on_fork, fork_claims, fork_maps
from edugym_course.lessons.exploration.methods import (
    EPSILON_GREEDY,
    GO_EXPLORE,
    HEIGHTS,
    METHODS,
    N_STEPS,
    NOVELTY,
    OPTIMISM,
    OPTIMIST,
    REPETITIONS,
    compare,
    paper_methods,
    visits_of,
)
from edugym_course.lessons.exploration.stalling import frontier_lines, stalling_claims, watch_frontier
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

RANDOM_SEARCH = ((2, 4), (2, 8), (3, 5))
"""Numbers of grips and heights of the walls on which a random climber is watched; higher walls take too long."""
SOLVED_BY = MappingProxyType({EPSILON_GREEDY: (10,), NOVELTY: (10, 30), GO_EXPLORE: (10, 30, 100)})
"""The heights that each method solves, according to the paper."""

WHY = MappingProxyType(
    {
        (EPSILON_GREEDY, 30): "without a reward all values are equal, so it searches at random: 2.1e9 steps on average",
        (EPSILON_GREEDY, 100): "random search would take 2.5e30 steps",
        (NOVELTY, 100): "the paper says that it found the top and could not learn the way; here it never gets near",
    }
)


def without_epsilon(height: int, **how: Any) -> Results:
    """Train with the novelty reward and ε = 0, to see what the random steps contribute; arguments as in `compare`."""
    greedy = partial(METHODS[NOVELTY], exploration=EpsilonGreedy(0.0))
    return compare(height, methods={NOVELTY: greedy}, **how)


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    highest = HEIGHTS[-1]
    by_height = {height: compare(height, **how(f"height_{height}")) for height in HEIGHTS}
    searches = {wall: watch_random_search(*wall, **how()) for wall in RANDOM_SEARCH}
    climbs = watch_climbs(highest, **how())
    optimism = {
        n_grips: compare(
            highest,
            methods={OPTIMISM: OPTIMIST, GO_EXPLORE: METHODS[GO_EXPLORE]},
            n_grips=n_grips,
            **how(f"grips_{n_grips}"),
        )
        for n_grips in (2, 3)
    }
    patient = compare(highest, methods={OPTIMISM: OPTIMIST}, n_grips=3, n_steps=2 * N_STEPS, **how("patient"))
    far_sighted = compare(HEIGHTS[0], methods={NOVELTY: paper_methods(discount=0.99)[NOVELTY]}, **how("far_sighted"))
    forks = compare_on_fork(methods={NOVELTY: METHODS[NOVELTY]}, **how("fork"))
    without = without_epsilon(highest, **how())
    return by_height, searches, climbs, without, far_sighted, watch_frontier(**how()), optimism, patient, forks


def judge(
    by_height: Mapping[int, Results],
    searches: Mapping[tuple[int, int], Interval],
    climbs: Interval,
    without: Results,
    far_sighted: Results,
    watched: Results,
    optimism: Mapping[int, Results],
    patient: Results,
    forks: Results,
) -> Report:
    """Return claims and figures."""
    claims = [
        *solving_claims(by_height),
        speed_claim(by_height[HEIGHTS[0]]),
        *(random_search_claim(*wall, steps) for wall, steps in searches.items()),
        *explaining_claims(by_height[HEIGHTS[-1]], climbs, without),
        *stalling_claims(watched),
        *far_sighted_claims(far_sighted),
        *optimism_claims(optimism, patient),
        *fork_claims(forks, by_height[HEIGHTS[-1]]),
    ]
    return Report(claims, figures(by_height, watched, forks))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def solving_claims(by_height: Mapping[int, Results]) -> list[Claim]:
    """Return the claims on which method solves which wall."""
    return [
        Claim(
            f"{method} {'solves' if height in solved else 'does not solve'} height {height}",
            "share of runs that end at the top",
            results.share(method, at_least=1.0),
            Above(0.5) if height in solved else Below(0.5),
            WHY.get((method, height), ""),
        )
        for height, results in by_height.items()
        for method, solved in SOLVED_BY.items()
    ]


def speed_claim(low: Results, steps: int = 2_000) -> Claim:
    """Return the claim on the speed on the low wall.

    Args:
        low: the results on walls of the smallest height.
        steps: the training steps after which the methods are compared.
    """
    novelty, random = (low.at(method, steps) for method in (NOVELTY, EPSILON_GREEDY))
    return Claim(
        f"After {steps} steps more runs of novelty than of ε-greedy solve height {HEIGHTS[0]}",
        f"share of runs: novelty {novelty.mean():.0%} less ε-greedy {random.mean():.0%}",
        paired_difference(novelty, random),
        Above(0.0),
    )


def explaining_claims(highest: Results, climbs: Interval, without: Results) -> list[Claim]:
    """Return the claims on why the novelty reward fails on the highest walls.

    Args:
        highest: the results on these walls.
        climbs: the share of climbs to the top of a climber who knows the wall.
        without: the results with ε = 0.
    """
    height = HEIGHTS[-1]
    return [
        Claim(
            f"Novelty's frontier on a wall of {height} is near 40 after {N_STEPS} steps",
            "highest state ever visited",
            mean_interval([frontier(visits) for visits in visits_of(highest, NOVELTY)]),
            Within(30, 50),
            "the higher the frontier, the fewer climbs get there",
        ),
        Claim(
            f"Knowing the wall, ε-greedy gets up {height} in 0.95^{height} = {no_slip(height):.1%} of climbs",
            "share of climbs",
            climbs,
            near(no_slip(height)),
            "derailment: a single random step to the wrong grip ends the climb",
        ),
        Claim(
            "Slips end novelty's climbs back to its frontier: 0.95^frontier of them get there, hardly fewer",
            "share of climbs that get back / 0.95^frontier",
            mean_interval([return_to_frontier(visits) for visits in visits_of(highest, NOVELTY)]),
            Within(0.8, 1.1),
            "the frontier of the first half of training, and the climbs of the second",
        ),
        Claim(
            "After training, novelty's greedy policy still leads to its frontier",
            "share of runs",
            share_interval(greedy_leads_to_frontier(highest, NOVELTY, height)),
            Above(0.5),
            "the paper names detachment, giving up one of several frontiers; a wall has only one and cannot show it",
        ),
        Claim(
            "At the frontier novelty relies on ε: without random steps it stays near the ground",
            "highest state ever visited, ε = 0",
            mean_interval([frontier(visits) for visits in visits_of(without, NOVELTY)]),
            Below(10),
            "an untried grip is worth 0, and a wrong one already more, since a fall earns bonuses too",
        ),
    ]


def far_sighted_claims(far_sighted: Results) -> list[Claim]:
    """Return the claims on the novelty reward with a discount of 0.99."""
    below_top = [run.agent.Q[HEIGHTS[0] - 1].max() for run in far_sighted.complete_agents(NOVELTY).values()]
    return [
        Claim(
            f"With discount 0.99 the novelty reward does not even solve height {HEIGHTS[0]}",
            "share of runs that end at the top",
            far_sighted.share(NOVELTY, at_least=1.0),
            Below(0.5),
            "the bonuses end at the top, and those of a long future add up to more than the reward",
        ),
        Claim(
            "With discount 0.99 staying on the wall promises more bonuses than the reward for the top, which is 1",
            "highest value of an action one step below the top",
            mean_interval(below_top),
            Above(1.0),
        ),
    ]


def optimism_claims(optimism: Mapping[int, Results], patient: Results) -> list[Claim]:
    """Return the claims on optimism beside Go-Explore on the highest walls.

    Args:
        optimism: the results with two and with three grips.
        patient: the results of optimism with three grips and twice the steps.
    """
    height = HEIGHTS[-1]
    two, three = optimism[2], optimism[3]
    first = {label: [first_at_top(visits, N_STEPS) for visits in visits_of(two, label)] for label in two.methods}
    return [
        Claim(
            f"Optimism solves height {height} as well, without returning first and without a bonus",
            "share of runs that end at the top",
            two.share(OPTIMISM, at_least=1.0),
            Above(0.5),
            "what it has not tried looks best, so that it tries every grip: it explores systematically",
        ),
        Claim(
            "Optimism first gets to the top sooner than Go-Explore",
            "training steps, optimism less Go-Explore",
            paired_difference(first[OPTIMISM], first[GO_EXPLORE]),
            Below(0.0),
        ),
        Claim(
            "Averaged over training, optimism returns less than Go-Explore",
            "return averaged over training, optimism less Go-Explore",
            two.difference(OPTIMISM, GO_EXPLORE, over="training"),
            Below(0.0),
            "optimistic values shrink by γ at each try, and until they are all below γ^99 the greedy policy wavers",
        ),
        Claim(
            f"With three grips optimism gets to the top of height {height} in {N_STEPS} steps",
            "share of runs that were at the top",
            share_interval([bool(visits[:, -1].any()) for visits in visits_of(three, OPTIMISM)]),
            Above(0.5),
        ),
        Claim(
            f"With three grips optimism does not solve height {height} in {N_STEPS} steps",
            "share of runs that end at the top",
            three.share(OPTIMISM, at_least=1.0),
            Below(0.5),
            "there are twice as many optimistic values of wrong grips as with two grips",
        ),
        Claim(
            f"With three grips Go-Explore solves height {height}",
            "share of runs that end at the top",
            three.share(GO_EXPLORE, at_least=1.0),
            Above(0.5),
        ),
        Claim(
            f"With three grips optimism solves height {height} in {2 * N_STEPS} steps",
            "share of runs that end at the top",
            patient.share(OPTIMISM, at_least=1.0),
            Above(0.5),
            "it is slower, not stuck",
        ),
    ]


def random_search_claim(n_grips: int, height: int, measured: Interval) -> Claim:
    """Return the claim that random search takes as long as theory predicts."""
    steps = random_search_steps(n_grips, height)
    return Claim(
        f"Random search needs (N^(H+1) - N)/(N - 1) = {steps} steps for N = {n_grips}, H = {height} (no step limit)",
        "steps a climb",
        measured,
        near(steps),
    )


def near(theory: float) -> Within:
    """Expect a value within a tenth of what theory predicts."""
    return Within(0.9 * theory, 1.1 * theory)


def figures(by_height: Mapping[int, Results], watched: Results, forks: Results) -> list[Sheet]:
    """Return the figures: learning curves, visits, climbs that get back up, grips at the frontier, two branches."""
    highest = by_height[HEIGHTS[-1]]
    return [
        learning_curves(by_height),
        Sheet("visits", [visit_maps(by_height[height], height) for height in HEIGHTS[1:]]),
        Sheet("climbs", [[climb_shares(highest, HEIGHTS[-1])]]),
        Sheet("frontier", [[frontier_lines(watched)]]),
        *(fork_maps(visits) for visits in visits_of(forks, NOVELTY)[:1]),
    ]

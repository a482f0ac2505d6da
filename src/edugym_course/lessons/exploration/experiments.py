"""Exploration (lesson 1): the paper's figure on Boulder, and why it looks as it does.

Q-learning with three ways to explore climbs walls of height 10, 30 and 100 for 20 000 steps. Settings: discount 0.9;
learning rate 0.5; ε = 0.1 for ε-greedy and for the novelty reward, which is 1/√n(s') for entering s' for the n-th time;
20 random steps from each goal for Go-Explore; two grips at every height; episodes of at most 10 times the height; 30
repetitions (90 where optimism returns more than Go-Explore), each with its own layout, which is the same for every
method; one greedy evaluation episode for each point. "Optimism" is greedy Q-learning with all values at 1 and learning
rate 1. Reasons are tested on walls of height 100, 60 and 30, too.

A run *solves* the wall when its last greedy episode reaches the top. A method solves the wall when the share of runs
that solve it is above one half with 95 % confidence; it does not solve the wall when the share is below one half.
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from edugym.experiments.figures import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import Interval, mean_interval, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym_course.lessons.exploration.climbs import (
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
    REPETITIONS,
    compare,
    paper_methods,
    visits_of,
)
from edugym_course.lessons.exploration.optimism import (
    LEAD_RUNS,
    LEAD_WALL,
    WALLS,
    compare_leaders,
    compare_optimists,
    optimism_claims,
)
from edugym_course.lessons.exploration.stalling import CAUSES, HOPE, frontier_lines, stalling_claims, watch_frontier
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

RANDOM_SEARCH = ((2, 4), (2, 8), (3, 5))
"""Numbers of grips and heights of the walls on which a random climber is watched; higher walls take too long."""
SOLVED_BY = MappingProxyType({EPSILON_GREEDY: (10,), NOVELTY: (10, 30), GO_EXPLORE: (10, 30, 100)})
"""The heights that each method solves, according to the paper."""

FAR_HEIGHTS = (10, 15)
"""Heights of the walls that are climbed with a discount of 0.99."""
CAUSE_HEIGHTS = (60, 30)
"""Heights of further walls on which reasons are tested."""
REMARKS = MappingProxyType(
    {
        (EPSILON_GREEDY, 30): "a random search for the top takes 2.1e9 steps on average",
        (EPSILON_GREEDY, 100): "a random search for the top takes 2.5e30 steps on average",
        (NOVELTY, 100): "the paper says that it found the top and could not learn the way; here it never gets near",
    }
)


def without_epsilon(height: int, initial_value: float = 0.0, **how: Any) -> Results:
    """Train with the novelty reward and ε = 0, to see what the random steps contribute; arguments as in `compare`."""
    greedy = paper_methods(epsilon=0.0, initial_value=initial_value)[NOVELTY]
    return compare(height, methods={NOVELTY: greedy}, **how)


def far_sighted(height: int, bonus: float, **how: Any) -> Results:
    """Train with the novelty reward and a discount of 0.99; arguments as in `compare`."""
    return compare(height, methods={NOVELTY: paper_methods(bonus=bonus, discount=0.99)[NOVELTY]}, **how)


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    highest = HEIGHTS[-1]
    by_height = {height: compare(height, **how(f"height_{height}")) for height in HEIGHTS}
    searches = {wall: watch_random_search(*wall, **how()) for wall in RANDOM_SEARCH}
    climbs = watch_climbs(highest, **how())
    optimism = {
        (height, n_grips): compare_optimists(height, n_grips, **how(f"optimism_{height}_{n_grips}"))
        for height, n_grips in WALLS
    }
    leaders = compare_leaders(LEAD_WALL, **how("leaders", repetitions=LEAD_RUNS * how.repetitions))
    far = {(height, bonus): far_sighted(height, bonus, **how()) for height in FAR_HEIGHTS for bonus in (1.0, 0.1)}
    forks = compare_on_fork(methods={NOVELTY: METHODS[NOVELTY]}, **how("fork"))
    greedy = {
        (height, value): without_epsilon(height, value, **how())
        for height in (highest, *CAUSE_HEIGHTS)
        for value in (0.0, HOPE)
    }
    watched = {highest: watch_frontier(methods={**METHODS, **CAUSES}, **how())}
    watched |= {height: watch_frontier(height, methods=CAUSES, **how()) for height in CAUSE_HEIGHTS}
    return by_height, searches, climbs, greedy, far, watched, optimism, leaders, forks


def judge(
    by_height: Mapping[int, Results],
    searches: Mapping[tuple[int, int], Interval],
    climbs: Interval,
    greedy: Mapping[tuple[int, float], Results],
    far: Mapping[tuple[int, float], Results],
    watched: Mapping[int, Results],
    optimism: Mapping[tuple[int, int], Results],
    leaders: Results,
    forks: Results,
) -> Report:
    """Return claims and figures."""
    claims = [
        *solving_claims(by_height),
        speed_claim(by_height[HEIGHTS[0]]),
        *(random_search_claim(*wall, steps) for wall, steps in searches.items()),
        *explaining_claims(by_height[HEIGHTS[-1]], climbs),
        *slip_claims(greedy),
        *stalling_claims(watched),
        *far_sighted_claims(far),
        *optimism_claims(optimism, leaders),
        *fork_claims(forks, by_height[HEIGHTS[-1]]),
    ]
    return Report(claims, figures(by_height, watched[HEIGHTS[-1]], forks))


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
            remark=REMARKS.get((method, height), ""),
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
        Above(0.2),
    )


def explaining_claims(highest: Results, climbs: Interval) -> list[Claim]:
    """Return the claims on why the novelty reward fails on the highest walls.

    Args:
        highest: the results on these walls.
        climbs: the share of climbs to the top of a climber who knows the wall.
    """
    height = HEIGHTS[-1]
    return [
        Claim(
            f"Novelty's frontier on a wall of {height} is near 40 after {N_STEPS} steps",
            "highest state ever visited",
            mean_interval([frontier(visits) for visits in visits_of(highest, NOVELTY)]),
            Within(30, 50),
            "the higher the frontier, the fewer climbs get there, and there it needs a slip to find the right grip",
            tuple(no_need_of_slips(height) for height in (height, *CAUSE_HEIGHTS)),
        ),
        Claim(
            f"Knowing the wall, ε-greedy gets up {height} in 0.95^{height} = {no_slip(height):.1%} of climbs",
            "share of climbs",
            climbs,
            near(no_slip(height)),
            remark="this is derailment: a single random step to the wrong grip ends the climb",
        ),
        Claim(
            "Slips end novelty's climbs back to its frontier: 0.95^frontier of them get there, hardly fewer",
            "share of climbs that get back / 0.95^frontier",
            mean_interval([return_to_frontier(visits) for visits in visits_of(highest, NOVELTY)]),
            Within(0.8, 1.1),
            remark="the frontier of the first half of training, and the climbs of the second",
        ),
        Claim(
            "After training, novelty's greedy policy still leads to its frontier",
            "share of runs",
            share_interval(greedy_leads_to_frontier(highest, NOVELTY, height)),
            Above(0.5),
            remark="the paper names detachment, giving up one of several frontiers; a wall has only one",
        ),
    ]


def no_need_of_slips(height: int) -> str:
    """Return the claim that the reason why it needs slips is a first value of 0."""
    return f"With values that start at {HOPE:g} novelty gets to the top without random steps: height {height}"


def slip_claims(greedy: Mapping[tuple[int, float], Results]) -> list[Claim]:
    """Return the claims on the novelty reward with ε = 0, by the height of the walls and the first value."""
    heights = sorted({height for height, _ in greedy}, reverse=True)
    return [
        *(
            Claim(
                f"At the frontier novelty relies on ε: without random steps it stays near the ground, height {height}",
                "highest state ever visited, ε = 0",
                mean_interval([frontier(visits) for visits in visits_of(greedy[height, 0.0], NOVELTY)]),
                Below(3),
                "an untried grip is worth 0, and a wrong one leads to the ground, which is worth more",
                tuple(map(no_need_of_slips, heights)),
            )
            for height in heights
        ),
        *(
            Claim(
                no_need_of_slips(height),
                "highest state ever visited / height, ε = 0",
                mean_interval([frontier(visits) / height for visits in visits_of(greedy[height, HOPE], NOVELTY)]),
                Above(0.95),
            )
            for height in heights
        ),
    ]


def small_bonus(height: int) -> str:
    """Return the claim that the reason is the size of the bonus."""
    return f"With discount 0.99 and a first bonus of 0.1 it solves height {height}"


def far_sighted_claims(far: Mapping[tuple[int, float], Results]) -> list[Claim]:
    """Return the claims on the novelty reward with a discount of 0.99, by the height and the first bonus."""
    claims = []
    for height in FAR_HEIGHTS:
        agents = far[height, 1.0].complete_agents(NOVELTY).values()
        claims += [
            Claim(
                f"With discount 0.99 the novelty reward does not even solve height {height}",
                "share of runs that end at the top",
                far[height, 1.0].share(NOVELTY, at_least=1.0),
                Below(0.2),
                "the bonuses end at the top, and those of a long future add up to more than the reward",
                tuple(map(small_bonus, FAR_HEIGHTS)),
            ),
            Claim(
                f"With discount 0.99 staying on a wall of {height} promises twice the reward for the top, which is 1",
                "highest value of an action one step below the top",
                mean_interval([agent.agent.Q[height - 1].max() for agent in agents]),
                Above(2.0),
            ),
            Claim(
                small_bonus(height),
                "share of runs that end at the top",
                far[height, 0.1].share(NOVELTY, at_least=1.0),
                Above(0.7),
            ),
        ]
    return claims


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

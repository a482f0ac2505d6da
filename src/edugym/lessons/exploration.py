"""Exploration (lesson 1): the paper's figure on Boulder, and why it looks as it does.

Q-learning with three ways to explore climbs walls of height 10, 30 and 100 for 20 000 steps. Settings: discount 0.9;
learning rate 0.5; ε = 0.1 for ε-greedy and for the novelty reward, which is 1/√n(s') for entering s' for the n-th time;
20 random steps from each goal for Go-Explore; two grips at every height; episodes of at most 10 times the height; 30
repetitions, each with its own layout, which is the same for every method; one greedy evaluation episode for each point.

A run *solves* the wall when its last greedy episode reaches the top. A method solves the wall when the share of runs
that solve it is above one half with 95 % confidence; it does not solve the wall when the share is below one half.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym.agents.count_based import CountBased
from edugym.agents.go_explore import GoExplore
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym.experiments import How, reporting
from edugym.mdp.protocol import Integers, Reals
from edugym.plotting import Curves, Lines, Sheet, VisitMap
from edugym.plotting.report import Report
from edugym.registration import make_mdp
from edugym.results.claims import Above, Below, Claim, Within
from edugym.results.statistics import Interval, mean_interval, proportion_interval, share_interval
from edugym.results.tables import Results
from edugym.training.repeat import repeat
from edugym.training.visits import record_visits

HEIGHTS = (10, 30, 100)
N_STEPS = 20_000
REPETITIONS = 30
DISCOUNT = 0.9
LEARNING_RATE = 0.5
EPSILON = 0.1
SLIP = EPSILON / 2
"""The probability that an ε-greedy climber takes the wrong one of two grips although it knows the right one."""

RANDOM_SEARCH = ((2, 4), (2, 8), (3, 5))
"""Numbers of grips and heights of the walls on which a random climber is watched; higher walls take too long."""

EPSILON_GREEDY, NOVELTY, GO_EXPLORE = "ε-greedy", "novelty reward", "Go-Explore"
METHODS: Mapping[str, Callable[..., Any]] = MappingProxyType(
    {
        EPSILON_GREEDY: partial(
            QLearning.create, learning_rate=LEARNING_RATE, discount=DISCOUNT, exploration=EpsilonGreedy(EPSILON)
        ),
        NOVELTY: partial(
            CountBased.create,
            bonus=1.0,
            learning_rate=LEARNING_RATE,
            discount=DISCOUNT,
            exploration=EpsilonGreedy(EPSILON),
        ),
        GO_EXPLORE: partial(GoExplore.create, learning_rate=LEARNING_RATE, discount=DISCOUNT, explore_steps=20),
    }
)
SOLVED_BY = MappingProxyType({EPSILON_GREEDY: (10,), NOVELTY: (10, 30), GO_EXPLORE: (10, 30, 100)})
"""The heights that each method solves, according to the paper."""

WHY = MappingProxyType(
    {
        (EPSILON_GREEDY, 30): "without a reward all values are equal, so it searches at random: 2.1e9 steps on average",
        (EPSILON_GREEDY, 100): "random search would take 2.5e30 steps",
        (NOVELTY, 100): "the paper says that it found the top and could not learn the way; here it never gets near",
    }
)


def compare(
    height: int,
    *,
    methods: Mapping[str, Callable[..., Any]] = METHODS,
    n_grips: int = 2,
    n_steps: int = N_STEPS,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    **how: Any,
) -> Results:
    """Train every method on walls of one height, and record the visits: one panel of the figure.

    Args:
        height: the height of the walls, 1 or more.
        methods: by label, functions that make an agent for an environment.
        n_grips: the number of grips at every height, 2 or more.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each method, each on a wall of its own.
        seed: the number from which all seeds are spawned.
        **how: more arguments of `edugym.training.repeat`, such as `jobs`, `progress` and `stop`.

    Returns:
        The results; `results.agents[method][repetition].visits` has the visits, shape (100, height + 1).
    """

    def recorded(make: Callable[..., Any], environment: Any) -> Any:
        return record_visits(make(environment), environment, n_steps)

    agents = {label: partial(recorded, make) for label, make in methods.items()}
    return repeat(
        "Boulder",
        agents,
        n_steps,
        repetitions=repetitions,
        seed=seed,
        parameters={"height": height, "n_grips": n_grips},
        **how,
    )


def random_search_steps(n_grips: int, height: int) -> int:
    """Return the expected steps of a random climber to the top, without a step limit: (N^(H+1) - N) / (N - 1)."""
    steps: int = (n_grips ** (height + 1) - n_grips) // (n_grips - 1)
    return steps


def watch_random_search(n_grips: int, height: int, *, climbs: int = 1_000, **how: Any) -> Interval:
    """Measure the steps of a random climber to the top, without a step limit.

    Args:
        n_grips: the number of grips at every height, 2 or more.
        height: the height of the wall, 1 or more.
        climbs: the approximate number of successful climbs in each repetition.
        **how: more arguments of `edugym.training.repeat`, such as `repetitions` and `seed`.

    Returns:
        The mean over repetitions, with its interval.
    """
    n_steps = climbs * random_search_steps(n_grips, height)
    wall = {"height": height, "n_grips": n_grips, "max_steps": n_steps}
    agents = {"random": partial(QLearning.create, discount=DISCOUNT, exploration=EpsilonGreedy(1.0))}
    results = repeat("Boulder", agents, n_steps, parameters=wall, evaluate_every=n_steps, **how)
    seen = results.table[results.table["complete"]].groupby("repetition")["episodes"].sum().to_numpy()
    return mean_interval(n_steps / seen)


def watch_climbs(height: int, *, n_steps: int = 500_000, **how: Any) -> Interval:
    """Measure how often a climber who knows the whole wall and keeps exploring gets to the top without a fall.

    Args:
        height: the height of the wall, 1 or more.
        n_steps: the steps of each repetition.
        **how: more arguments of `edugym.training.repeat`, such as `repetitions` and `seed`.

    Returns:
        The share of climbs, with its interval.
    """

    def knowing(environment: Any) -> Any:
        grips = environment.unwrapped.mdp.grips
        agent = QLearning.create(environment, exploration=EpsilonGreedy(EPSILON))._replace(learning_rate=0.0)
        agent.Q[np.arange(height), grips] = 1.0
        return record_visits(agent, environment, n_steps, n_intervals=1)

    wall = {"height": height, "max_steps": n_steps}
    results = repeat("Boulder", {"knows the wall": knowing}, n_steps, parameters=wall, evaluate_every=n_steps, **how)
    visits = sum((visits[0] for visits in visits_of(results, "knows the wall")), np.zeros(height + 1, np.int64))
    return proportion_interval(int(visits[height]), int(visits[0]))


def without_epsilon(height: int, **how: Any) -> Results:
    """Train with the novelty reward and ε = 0, to see what the random steps contribute; arguments as in `compare`."""
    greedy = partial(METHODS[NOVELTY], exploration=EpsilonGreedy(0.0))
    return compare(height, methods={NOVELTY: greedy}, **how)


def visits_of(results: Results, method: str) -> list[Integers]:
    """Return the visits of each complete run of a method, each of shape (n_intervals, height + 1)."""
    return [agent.visits for agent in results.complete_agents(method).values()]


def frontier(visits: Integers) -> int:
    """Return the highest state that was ever visited; visits have shape (n_intervals, height + 1)."""
    return int(np.flatnonzero(visits.sum(axis=0))[-1])


def no_slip(height: int) -> float:
    """Return the probability that an ε-greedy climber who knows the way gets this high without a wrong grip."""
    return (1 - SLIP) ** height


def share_of_climbs(visits: Integers) -> Reals:
    """Return the share of climbs that reached each height without a fall, shape (height + 1,).

    Every climb visits the ground once and each height at most once, so the number of visits of a height is the number
    of climbs that reached it.
    """
    total = visits.sum(axis=0)
    share: Reals = total / total[0]
    return share


def later(visits: Integers) -> Integers:
    """Return the visits in the second half of training."""
    return visits[len(visits) // 2 :]


def return_to_frontier(visits: Integers) -> float:
    """Return the share of climbs that get back to the frontier, divided by the share that never slips.

    The frontier is that of the first half of training, and the climbs are those of the second half.
    """
    height = frontier(visits[: len(visits) // 2])
    return float(share_of_climbs(later(visits))[height]) / no_slip(height)


def greedy_leads_to_frontier(results: Results, method: str, height: int) -> list[bool]:
    """Return for each complete run of a method whether its greedy policy leads to its frontier."""
    layouts = results.table.groupby("repetition")["layout_seed"].first()
    leads = []
    for repetition, agent in results.complete_agents(method).items():
        grips = make_mdp("Boulder", height=height, layout_seed=int(layouts[repetition])).grips
        rng = np.random.default_rng(0)  # for ties
        leads.append(all(agent.greedy(state, rng) == grips[state] for state in range(frontier(agent.visits))))
    return leads


def best_return(height: int, epsilon: float = 0.0, n_grips: int = 2) -> float:
    """Return the best expected return of an episode, by planning on the exact model; every layout has the same.

    Args:
        height: the height of the wall, 1 or more.
        epsilon: the probability of a random action in every state; 0 gives the optimum.
        n_grips: the number of grips at every height, 2 or more.
    """
    wall = make_mdp("Boulder", height=height, n_grips=n_grips)
    return value_iteration(finite_model(wall), epsilon=epsilon, horizon=wall.max_steps).start


def measure(how: How) -> tuple[Any, ...]:
    """Run the experiments."""
    by_height = {height: compare(height, **how(f"height_{height}")) for height in HEIGHTS}
    searches = {wall: watch_random_search(*wall, **how()) for wall in RANDOM_SEARCH}
    climbs = watch_climbs(HEIGHTS[-1], **how())
    return by_height, searches, climbs, without_epsilon(HEIGHTS[-1], **how())


def judge(
    by_height: Mapping[int, Results],
    searches: Mapping[tuple[int, int], Interval],
    climbs: Interval,
    without: Results,
) -> Report:
    """Return claims and figures."""
    claims = [
        *solving_claims(by_height),
        *(random_search_claim(*wall, steps) for wall, steps in searches.items()),
        *explaining_claims(by_height[HEIGHTS[-1]], climbs, without),
    ]
    return Report(claims, figures(by_height))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym.experiments.Reporter`)."""


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
            "it moves on ever more slowly, since fewer and fewer climbs get there",
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


def figures(by_height: Mapping[int, Results]) -> list[Sheet]:
    """Return the figures: the learning curves, the visits, and the share of climbs that get back up."""
    return [
        Sheet("exploration", [[curves(results, height) for height, results in by_height.items()]]),
        Sheet("visits", [visit_maps(by_height[height], height) for height in HEIGHTS[1:]]),
        Sheet("climbs", [[climb_shares(by_height[HEIGHTS[-1]], HEIGHTS[-1])]]),
    ]


def race(
    own: Mapping[str, Callable[..., Any]],
    heights: Sequence[int] = HEIGHTS,
    *,
    n_grips: int = 2,
    repetitions: int = REPETITIONS,
    **how: Any,
) -> Sheet:
    """Return the paper's figure with methods of the reader's own beside its three.

    Args:
        own: by label, functions that make an agent for a wall, which is the MDP itself: `wall.height` is there.
        heights: the heights of the walls, one panel for each.
        n_grips: the number of grips at every height, 2 or more.
        repetitions: the number of runs of each method, each on a wall of its own.
        **how: more arguments of `compare`.
    """

    def for_wall(make: Callable[..., Any], environment: Any) -> Any:
        return make(environment.unwrapped.mdp)

    for_walls: dict[str, Callable[..., Any]] = {label: partial(for_wall, make) for label, make in own.items()}
    methods = {**METHODS, **for_walls}
    compared = {
        height: compare(height, methods=methods, n_grips=n_grips, repetitions=repetitions, **how) for height in heights
    }
    return Sheet("race", [[curves(results, height, n_grips) for height, results in compared.items()]])


def curves(results: Results, height: int, n_grips: int = 2) -> Curves:
    """Return the learning curves of all methods on walls of one kind, with what is possible."""
    return Curves(
        results,
        f"height {height}" if n_grips == 2 else f"height {height}, {n_grips} grips",
        share=True,
        optimum=best_return(height, n_grips=n_grips),
        soft_optimum=best_return(height, EPSILON, n_grips),
        y_label="share of runs that reach the top",
    )


def visit_maps(results: Results, height: int) -> list[VisitMap]:
    """Return a map of visits for each method, a mean over its runs."""
    return [
        VisitMap(np.mean(visits, axis=0), N_STEPS, f"{method}, height {height}", "height")
        for method in METHODS
        if (visits := visits_of(results, method))
    ]


def climb_shares(results: Results, height: int) -> Lines:
    """Return the share of climbs that reach each height in the second half of training, beside 0.95^height."""
    return Lines(
        np.arange(height + 1.0),
        {
            method: np.mean([share_of_climbs(later(run)) for run in visits], axis=0)
            for method in METHODS
            if (visits := visits_of(results, method))
        },
        f"climbs on a wall of {height}, second half of training",
        "height",
        "share of climbs that get there",
        {"never slipping: 0.95^height": np.array([no_slip(h) for h in range(height + 1)])},
        log=True,
    )

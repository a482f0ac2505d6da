"""The exploration lesson: the paper's figure on Boulder, and why it looks as it does.

Three ways to explore, all on Q-learning, climb walls of height 10, 30 and 100 for 20 000 steps. Settings: discount 0.9,
learning rate 0.5; ε = 0.1 for ε-greedy and for the novelty reward, which is 1/√N(s') on the state entered; Go-Explore
explores 20 random steps from each goal; two grips at every height; episodes of 10 times the height; 30 repetitions,
each with a layout of its own, the same for every method; evaluation greedy, one episode a point.

A run *solves* the wall when its last greedy episode reaches the top. A method solves the wall when the share of runs
that do is above one half with 95 % confidence, and does not when it is below.
"""

import threading
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym.agents.count_based import CountBased
from edugym.agents.go_explore import GoExplore
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym.lessons.report import Curves, Figure, Lines, Report, VisitMap
from edugym.mdp.protocol import Integers, Reals
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
"""The probability that an ε-greedy climber takes the wrong one of two grips though it knows the right one."""

RANDOM_SEARCH = ((2, 4), (2, 8), (3, 5))
"""Numbers of grips and heights for which a random climber is watched; higher walls would take it for ever."""

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
"""The heights that each method solves, as the paper has it."""

WHY = MappingProxyType(
    {
        (EPSILON_GREEDY, 30): "without a reward all values are equal and it searches at random: 2.1e9 steps on average",
        (EPSILON_GREEDY, 100): "random search would take 2.5e30 steps",
        (NOVELTY, 100): "the paper says it found the top but could not learn the way; it does not get near the top",
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
    """Train every method on walls of one height, visits recorded: one panel of the figure.

    Args:
        height: of the wall, 1 or more.
        methods: by label, the functions that make an agent for an environment.
        n_grips: how many grips there are at every height, 2 or more.
        n_steps: the training steps of each run.
        repetitions: how many runs each method gets, each on a wall of its own.
        seed: from which all seeds are spawned.
        **how: `jobs`, `progress`, `stop` and others of `edugym.training.repeat`.

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
    """How many steps a random climber needs on average to the top: (N^(H+1) - N) / (N - 1)."""
    steps: int = (n_grips ** (height + 1) - n_grips) // (n_grips - 1)
    return steps


def watch_random_search(n_grips: int, height: int, *, climbs: int = 1_000, **how: Any) -> Interval:
    """How many steps a random climber is seen to need to the top.

    Args:
        n_grips: how many grips there are at every height, 2 or more.
        height: of the wall, 1 or more.
        climbs: about how many climbs each repetition watches.
        **how: `repetitions`, `seed` and others of `edugym.training.repeat`.

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
    """How often a climber who knows the whole wall gets to its top without falling, while it goes on exploring.

    Args:
        height: of the wall, 1 or more.
        n_steps: how many steps each repetition watches.
        **how: `repetitions`, `seed` and others of `edugym.training.repeat`.

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
    """The novelty reward with no exploring steps, to see what these are for; arguments as in `compare`."""
    still = partial(METHODS[NOVELTY], exploration=EpsilonGreedy(0.0))
    return compare(height, methods={NOVELTY: still}, **how)


def visits_of(results: Results, method: str) -> list[Integers]:
    """The visits of each complete run of a method, shape (n_intervals, height + 1)."""
    return [agent.visits for agent in results.complete_agents(method).values()]


def frontier(visits: Integers) -> int:
    """The highest state that was ever visited, from visits of shape (n_intervals, height + 1)."""
    return int(np.flatnonzero(visits.sum(axis=0))[-1])


def no_slip(height: int) -> float:
    """The probability that an exploring climber who knows the way gets this high without taking a wrong grip."""
    return (1 - SLIP) ** height


def share_of_climbs(visits: Integers) -> Reals:
    """The share of climbs that came to each height without a fall, shape (height + 1,).

    A climb begins with a visit of the ground and visits each height once at most, so that the visits say it.
    """
    total = visits.sum(axis=0)
    share: Reals = total / total[0]
    return share


def later(visits: Integers) -> Integers:
    """The visits in the second half of the training."""
    return visits[len(visits) // 2 :]


def return_to_frontier(visits: Integers) -> float:
    """The share of the later climbs that got to the earlier frontier, as a multiple of what never slipping gives."""
    height = frontier(visits[: len(visits) // 2])
    return float(share_of_climbs(later(visits))[height]) / no_slip(height)


def greedy_leads_to_frontier(results: Results, method: str, height: int) -> list[bool]:
    """Of each complete run of a method, whether its agent gets back to its frontier when it does not explore."""
    layouts = results.table.groupby("repetition")["layout_seed"].first()
    leads = []
    for repetition, agent in results.complete_agents(method).items():
        grips = make_mdp("Boulder", height=height, layout_seed=int(layouts[repetition])).grips
        rng = np.random.default_rng(0)  # for ties
        leads.append(all(agent.greedy(state, rng) == grips[state] for state in range(frontier(agent.visits))))
    return leads


def best_return(height: int, epsilon: float = 0.0, n_grips: int = 2) -> float:
    """The best expected return of an episode, by planning on the exact model; it is the same for every layout.

    Args:
        height: of the wall, 1 or more.
        epsilon: the probability of a random action in every state; 0 gives the optimum.
        n_grips: how many grips there are at every height, 2 or more.
    """
    wall = make_mdp("Boulder", height=height, n_grips=n_grips)
    return value_iteration(finite_model(wall), epsilon=epsilon, horizon=wall.max_steps).start


def report(
    *,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    jobs: int | None = -1,
    progress: bool = False,
    stop: threading.Event | None = None,
    folder: Path | None = None,
) -> Report:
    """The figure, why it looks so, and what is claimed of both.

    Args:
        repetitions: runs of each method.
        seed: from which all seeds are spawned.
        jobs: as in `edugym.training.repeat`, as the next two.
        progress: see there.
        stop: see there.
        folder: where the results are written.
    """
    how: dict[str, Any] = {"repetitions": repetitions, "seed": seed, "jobs": jobs, "progress": progress}
    how["stop"] = stop or threading.Event()  # one for all experiments
    by_height = {
        height: compare(height, save_to=folder and folder / f"height_{height}.csv", **how) for height in HEIGHTS
    }
    claims = [*solving_claims(by_height), *explaining_claims(by_height[HEIGHTS[-1]], how)]
    return Report(claims, figures(by_height))


def solving_claims(by_height: Mapping[int, Results]) -> list[Claim]:
    """Which method solves which wall."""
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


def explaining_claims(highest: Results, how: Mapping[str, Any]) -> list[Claim]:
    """Why: what random search takes, and what holds the novelty reward up on the highest wall (`highest`)."""
    height = HEIGHTS[-1]
    return [
        *(random_search_claim(*wall, how) for wall in RANDOM_SEARCH),
        Claim(
            f"Novelty's frontier on a wall of {height} is near 40 after {N_STEPS} steps",
            "highest state ever visited",
            mean_interval([frontier(visits) for visits in visits_of(highest, NOVELTY)]),
            Within(30, 50),
            "it moves on, ever more slowly: fewer and fewer climbs get there",
        ),
        Claim(
            f"Whoever knows the wall but explores gets up {height} in 0.95^{height} = {no_slip(height):.1%} of climbs",
            "share of climbs",
            watch_climbs(height, **how),
            near(no_slip(height)),
            "derailment: a single exploring step with the wrong grip ends the climb",
        ),
        Claim(
            "That is what ends novelty's climbs back to its frontier, and hardly anything else does",
            "share of climbs that get back / 0.95^frontier",
            mean_interval([return_to_frontier(visits) for visits in visits_of(highest, NOVELTY)]),
            Within(0.8, 1.1),
            "the frontier of the first half of training, and the climbs of the second",
        ),
        Claim(
            "It is not detachment: to the end, novelty's greedy policy leads to its frontier",
            "share of runs",
            share_interval(greedy_leads_to_frontier(highest, NOVELTY, height)),
            Above(0.5),
            "the paper names detachment; here the bonus has spread down to the ground before it fades at the frontier",
        ),
        Claim(
            "At the frontier novelty relies on ε: without exploring steps it stays near the ground",
            "highest state ever visited, ε = 0",
            mean_interval([frontier(visits) for visits in visits_of(without_epsilon(height, **how), NOVELTY)]),
            Below(10),
            "a grip never tried is worth 0, and a wrong one already more, since bonuses follow a fall as well",
        ),
    ]


def random_search_claim(n_grips: int, height: int, how: Mapping[str, Any]) -> Claim:
    """That random search takes as long as theory says."""
    steps = random_search_steps(n_grips, height)
    return Claim(
        f"Random search needs (N^(H+1) - N)/(N - 1) = {steps} steps for N = {n_grips}, H = {height}",
        "steps a climb",
        watch_random_search(n_grips, height, **how),
        near(steps),
    )


def near(theory: float) -> Within:
    """Within a tenth of what theory says."""
    return Within(0.9 * theory, 1.1 * theory)


def figures(by_height: Mapping[int, Results]) -> list[Figure]:
    """What is to be drawn: the paper's figure, the visits, and how often climbs get back up."""
    height = HEIGHTS[-1]
    visits = {(h, method): visits_of(results, method) for h, results in by_height.items() for method in METHODS}
    curves = [
        Curves(
            f"height {h}",
            results,
            optimum=best_return(h),
            soft_optimum=best_return(h, EPSILON),
            share=True,
            y_label="share of runs that reach the top",
        )
        for h, results in by_height.items()
    ]
    maps = [
        [
            VisitMap(f"{method}, height {h}", np.mean(visits[h, method], axis=0), N_STEPS, "height")
            for method in METHODS
            if visits[h, method]
        ]
        for h in HEIGHTS[1:]
    ]
    climbs = Lines(
        f"climbs on a wall of {height}, second half of training",
        np.arange(height + 1.0),
        {
            method: np.mean([share_of_climbs(later(one)) for one in visits[height, method]], axis=0)
            for method in METHODS
            if visits[height, method]
        },
        "height",
        "share of climbs that get there",
        {"never slipping: 0.95^height": np.array([no_slip(h) for h in range(height + 1)])},
    )
    return [Figure("exploration", [curves]), Figure("visits", maps), Figure("climbs", [[climbs]])]

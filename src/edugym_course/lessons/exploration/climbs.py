"""How far climbs get: a random climber, one who knows the way, and what the visits of a run say."""

import math
from functools import partial
from typing import Any

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.experiments.repeat import repeat
from edugym.experiments.results.statistics import Interval, mean_interval, proportion_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Reals
from edugym.training.visits import record_visits
from edugym_course.lessons.exploration.methods import DISCOUNT, EPSILON, SLIP, visits_of


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
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions` and `seed`.

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
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions` and `seed`.

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


def frontier(visits: Integers) -> int:
    """Return the highest state that was ever visited; visits have shape (n_intervals, height + 1)."""
    return int(np.flatnonzero(visits.sum(axis=0))[-1])


def first_at_top(visits: Integers, n_steps: int) -> float:
    """Return the training steps at which the interval with the first visit of the top begins; NaN if there is none.

    Args:
        visits: shape (n_intervals, height + 1): the visits of a run that got to the top.
        n_steps: the training steps of the run.
    """
    there = np.flatnonzero(visits[:, -1])
    return float(there[0]) * n_steps / len(visits) if len(there) else math.nan


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

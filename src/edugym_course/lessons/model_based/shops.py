"""Other shops: the same walls, entrance and exit, and the three items in other places."""

from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from edugym.envs.supermarket import FLOOR, Supermarket
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.model_based.methods import DISCOUNT, N_STEPS
from edugym_course.lessons.model_based.plans import best_by_what_was_seen, follow

SHOPS = range(12)


def shop(number: int) -> Supermarket:
    """Return the supermarket with its three items in places that are drawn at random, the same ones for a number."""
    usual = Supermarket.create()
    cells = np.where(usual.cells > 0, FLOOR, usual.cells)
    free = [cell for cell in np.flatnonzero(cells == FLOOR) if cell not in (usual.start, usual.exit)]
    cells.flat[np.random.default_rng(number).choice(free, 3, replace=False)] = (4, 2, 1)
    return usual._replace(cells=cells)


@cache
def model_of(number: int) -> FiniteModel:
    """Return the exact model of a shop."""
    return finite_model(shop(number))


@cache
def best_return(number: int) -> float:
    """Return what the best plan with the exact model of a shop returns."""
    model = model_of(number)
    return follow(value_iteration(model, DISCOUNT).Q.argmax(axis=1), model).total


class Elsewhere(NamedTuple):
    """What a method does in the other shops.

    Attributes:
        returns: shape (n_shops, n_runs): the final returns, in percent of what the best plan returns.
        seen: the same of the best plan by what each run has seen.
    """

    returns: Reals
    seen: Reals


def compare_shops(methods: Mapping[str, Any], **how: Any) -> dict[str, Elsewhere]:
    """Train methods in all shops, as `compare` does in the usual one, and return by method what it does there.

    The agents of one shop are judged before those of the next one learn: together they would take gigabytes. It returns
    nothing if it was stopped.
    """
    of_shops = []
    for number in SHOPS:
        results = repeat(shop(number), methods, N_STEPS, evaluate_every=N_STEPS, **how)
        if not results.complete:
            return {}
        of_shops.append(in_shop(results, number))
    return {
        method: Elsewhere(*(np.array(parts) for parts in zip(*(of_shop[method] for of_shop in of_shops), strict=True)))
        for method in methods
    }


def in_shop(results: Results, number: int) -> dict[str, tuple[Reals, Reals]]:
    """Return by method the final return of each run, and that of the best plan by what it has seen, in percent."""
    model, best = model_of(number), best_return(number)
    found = {}
    for method in results.methods:
        agents = results.complete_agents(method).values()
        seen = np.array([best_by_what_was_seen(agent, model=model) for agent in agents])
        found[method] = 100.0 * results.final(method) / best, 100.0 * seen / best
    return found

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


def compare_shops(methods: Mapping[str, Any], **how: Any) -> list[Results]:
    """Train methods in all shops, as `compare` does in the usual one, with one point of the curve: the last."""
    return [repeat(shop(number), methods, N_STEPS, evaluate_every=N_STEPS, **how) for number in SHOPS]


def in_other_shops(results: list[Results]) -> dict[str, Elsewhere]:
    """Return by method what it does in the other shops.

    Args:
        results: what `compare_shops` returned.
    """
    found = dict[str, Elsewhere]()
    for method in results[0].methods:
        returns, seen = [], []
        for number, of_shop in zip(SHOPS, results, strict=True):
            model, best = model_of(number), best_return(number)
            agents = of_shop.complete_agents(method).values()
            returns.append(of_shop.final(method) / best)
            seen.append([best_by_what_was_seen(agent, model=model) / best for agent in agents])
        found[method] = Elsewhere(100.0 * np.array(returns), 100.0 * np.array(seen))
    return found

"""Plans that are made with a model, and followed in the supermarket itself."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from edugym.envs.supermarket import Supermarket
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.exact.values import largest
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Reals
from edugym_course.lessons.model_based.methods import DISCOUNT, LOST, NOISES, PLANNING_DISCOUNT, exact_model

IMPOSSIBLE = -1e9
"""The value of an action that a plan may not use."""


class Plan(NamedTuple):
    """What became of a policy that was planned with a wrong model.

    Attributes:
        total: its return in the supermarket itself.
        bumps: whether it walks into the same wall for ever.
        path: the states that it goes through, up to the exit or to the first that comes twice.
    """

    total: float
    bumps: bool
    path: tuple[int, ...] = ()

    @property
    def ends(self) -> bool:
        """Whether it gets to the exit."""
        return self.total > LOST


def follow(chosen: Integers, model: FiniteModel | None = None) -> Plan:
    """Follow a policy in the supermarket.

    Args:
        chosen: the action in each state, by the rows of the exact model.
        model: the exact model; by default that of the usual shop.
    """
    model = model or exact_model()
    s, total, path, max_steps = int(model.initial.argmax()), 0.0, list[int](), Supermarket.create().max_steps
    while s not in path and not model.terminal[s]:
        path.append(s)
        total += float(model.rewards[s, chosen[s], 0])
        s = int(model.successors[s, chosen[s], 0])
    bumps = not model.terminal[s] and s == path[-1]
    places = tuple(int(model.states[row]) for row in [*path, s])
    return Plan(total if model.terminal[s] else -float(max_steps), bumps, places)


def follow_plan(
    noise: float, layout_seed: int, discount: float = PLANNING_DISCOUNT, *, errors_at_walls: bool = True
) -> Plan:
    """Plan by value iteration with a wrong model, and follow the plan in the supermarket itself.

    Args:
        noise: the standard deviation of the errors in the rewards of the model.
        layout_seed: the seed that draws them.
        discount: γ.
        errors_at_walls: whether the rewards of bumps into a wall have errors too, as all others have.
    """
    exact = exact_model()
    model = Supermarket.create(noise, layout_seed=layout_seed).distorted(exact)
    if not errors_at_walls:
        bumps = exact.successors == np.arange(len(exact.states))[:, np.newaxis, np.newaxis]
        model = model._replace(rewards=np.where(bumps, exact.rewards, model.rewards))
    return follow(value_iteration(model, discount, tolerance=1e-6).Q.argmax(axis=1))


def follow_plans(layouts: Sequence[int], discount: float = PLANNING_DISCOUNT) -> dict[float, list[Plan]]:
    """Plan with the wrong models of some layouts, at every noise of the lesson."""
    return {noise: [follow_plan(noise, seed, discount) for seed in layouts] for noise in NOISES}


def look_ahead(Q: Reals | None, depth: int, discount: float = DISCOUNT) -> float:
    """Return what an agent gets that looks some steps ahead in the exact model before each of its own.

    Args:
        Q: its action values, shape (n_states, n_actions), at the end of the look ahead; with None all are 0.
        depth: the number of steps, 0 or more; with 0 it takes the action with the highest value.
        discount: γ.
    """
    model = exact_model()
    values = np.zeros(model.successors.shape[:2]) if Q is None else Q[list(model.states)]
    for _ in range(depth):
        values = model.action_values(np.where(model.terminal, 0.0, values.max(axis=1)), discount)
    return follow(values.argmax(axis=1)).total


def tried(agent: Any) -> Any:
    """Return which actions a run has tried in which states: shape (n_states, n_actions), True or False.

    Agents with a model have counted them; those of the exercises have a table `known` or `last`. In the table of
    Q-learning a value that is still 0 was never updated.
    """
    if hasattr(agent, "model"):
        return agent.model.visits > 0
    for name in ("known", "last"):
        if hasattr(agent, name):
            return getattr(agent, name) > 0
    return agent.Q != 0.0


def best_by_what_was_seen(agent: Any, discount: float = DISCOUNT, model: FiniteModel | None = None) -> float:
    """Return the return of the best plan that uses nothing but the actions that a run has tried.

    The supermarket has no chance in it, so that one try tells all about an action. `model` is that of its shop, by
    default the usual one.
    """
    model = model or exact_model()
    known = tried(agent)[list(model.states)]
    V: Reals = np.zeros(len(model.states))
    for _ in range(len(V)):
        Q = np.where(known, model.action_values(V, discount), IMPOSSIBLE)
        V, before = np.where(model.terminal, 0.0, largest(Q)), V
        if np.array_equal(V, before):
            break
    return follow(Q.argmax(axis=1), model).total


def used_and_seen(results: Results) -> dict[str, tuple[Reals, Reals]]:
    """Return by method the final return of every run, and that of the best plan by what the run has seen."""
    return {
        method: (
            results.final(method),
            np.array([best_by_what_was_seen(agent) for agent in results.complete_agents(method).values()]),
        )
        for method in results.methods
    }


def items_found(results: Results, method: str) -> Reals:
    """Return the share of the runs of a method that have found items 1, 2 and 3, shape (3,)."""
    runs = [tried(agent).any(axis=1) for agent in results.complete_agents(method).values()]
    states = np.arange(800)
    shares: Reals = np.array([[run[states % 8 & item > 0].any() for item in (4, 2, 1)] for run in runs]).mean(axis=0)
    return shares

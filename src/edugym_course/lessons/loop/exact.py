"""What is exactly so in Supermarket: the values of its states, and what players earn, from its model."""

from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np

from edugym.agents.tables import ROUNDING
from edugym.envs.supermarket import Supermarket
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.exact.values import Values
from edugym.mdp.protocol import Integers, Reals
from edugym_course.lessons.loop.methods import MAX_STEPS


@cache
def model() -> FiniteModel:
    """Return the exact model."""
    return finite_model(Supermarket.create(max_steps=MAX_STEPS))


@cache
def optimal(discount: float) -> Values:
    """Return v* and q* for a discount."""
    return value_iteration(model(), discount)


def random_return() -> float:
    """Return what a player who acts at random earns, computed."""
    policy = np.full(model().successors.shape[:2], 0.25)
    return policy_evaluation(model(), policy, horizon=MAX_STEPS).start


def leaving_return() -> float:
    """Return what a player earns who acts at random but leaves wherever the exit is one step away, computed."""
    leaves = model().terminal[model().successors[:, :, 0]]  # nothing is random in Supermarket
    chosen = np.where(leaves.any(axis=1, keepdims=True), leaves, True)
    return policy_evaluation(model(), chosen / chosen.sum(axis=1, keepdims=True), horizon=MAX_STEPS).start


def myopic_return() -> float:
    """Return what a player earns who always takes the highest next reward (one of them at random), computed."""
    best = model().r >= model().r.max(axis=1, keepdims=True)
    return policy_evaluation(model(), best / best.sum(axis=1, keepdims=True), horizon=MAX_STEPS).start


def best_way(discount: float) -> list[int]:
    """Return the rows of the model along the best way for a discount; 500 steps if it does not get to the exit."""
    actions = optimal(discount).Q.argmax(axis=1)
    rows = [int(model().initial.argmax())]
    while not model().terminal[rows[-1]] and len(rows) <= MAX_STEPS:
        rows.append(int(model().successors[rows[-1], actions[rows[-1]], 0]))
    return rows


def rewards_along(rows: Sequence[int]) -> Reals:
    """Return the rewards on a way, shape (n_steps,)."""
    return np.array([model().rewards[s, (model().successors[s, :, 0] == n).argmax(), 0] for s, n in pairwise(rows)])


def discounted(rewards: Reals, discount: float) -> float:
    """Return G = R_1 + γ R_2 + γ² R_3 + ... (equation 3.8)."""
    return float((rewards * discount ** np.arange(len(rewards))).sum())


def items_on(rows: Sequence[int]) -> int:
    """Return how many items are collected on a way."""
    return int(model().states[rows[-1]] % 8).bit_count()


def misled() -> float:
    """Return the share of states with different next rewards in which the highest is not on the best way (γ = 1).

    Such a state is beside the exit, with an item still to collect.
    """
    Q, r = value_iteration(model()).Q, model().r
    differ: Integers = np.flatnonzero((r.max(axis=1) > r.min(axis=1)) & ~model().terminal)
    myopic = r[differ].argmax(axis=1)
    worse = Q[differ, myopic] < Q[differ].max(axis=1) - 1e-6
    return float(worse.mean())


def returns_along(rewards: Reals, discount: float) -> Reals:
    """Return G_t at each step of a way, computed backwards: G_t = R_{t+1} + γ G_{t+1} (equation 3.9)."""
    returns = np.zeros(len(rewards) + 1)
    for t in range(len(rewards) - 1, -1, -1):
        returns[t] = rewards[t] + discount * returns[t + 1]
    return returns[:-1]


def best_table(discount: float) -> Reals:
    """Return q*, shape (800, 4), by what the agent observes; NaN for states that cannot be reached."""
    table = np.full((800, 4), np.nan)
    table[list(model().states)] = optimal(discount).Q
    return table


def right_choices(Q: Any, discount: float, tried: bool | None = None) -> float:
    """Return the share of the states in which the greedy action of a table is a best one.

    Of actions with equal values in the table each counts with its probability. Terminal states do not count.

    Args:
        Q: the table, shape (800, 4), by what the agent observes.
        discount: γ.
        tried: whether only states count in which an action was tried, or only the others; None counts all.
    """
    right = optimal(discount).Q
    is_best = right >= right.max(axis=1, keepdims=True) - 1e-9
    learned = np.asarray(Q)[list(model().states)]
    chosen = np.isclose(learned, learned.max(axis=1, keepdims=True), rtol=ROUNDING, atol=0.0)  # as `greedy_action` does
    shares = (chosen * is_best).sum(axis=1) / chosen.sum(axis=1)
    counts = np.full(len(shares), True) if tried is None else learned.any(axis=1) == tried
    return float(shares[counts & ~model().terminal].mean())


def untried(Q: Any) -> float:
    """Return the share of the states, all but the terminal ones, in which a table has its first guesses, all 0."""
    touched = np.asarray(Q)[list(model().states)].any(axis=1)
    return float(1.0 - np.mean(touched, where=~model().terminal))

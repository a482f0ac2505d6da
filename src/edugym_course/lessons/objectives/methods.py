"""The agents of lesson 12 on Diver: weighted sums, Chebyshev distances, Pareto Q-learning, and a learned price."""

from typing import Any

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.agents.chebyshev_q_learning import ChebyshevQLearning
from edugym.agents.lagrangian_q_learning import LagrangianQLearning
from edugym.agents.pareto_q_learning import ParetoQLearning
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy, Greedy
from edugym.envs.diver import Diver
from edugym.exact.constrained import ConstrainedOptimum, constrained_optimum
from edugym.exact.front import exact_front
from edugym.mdp.protocol import Reals
from edugym.mdp.weighted import Weighted
from edugym.training.train_vectors import VectorRun, train_vectors

N_TREASURES = 9
N_STEPS = 20_000
PARETO_STEPS = 5_000
CONSTRAINED_STEPS = 50_000
AT_RANDOM = EpsilonGreedy(1.0)
"""All agents but the one with a limit learn from random dives, so that none fails for want of exploration."""
PRICES = tuple(float(price) for price in np.round(np.arange(0.15, 8.0, 0.15), 2))
"""Weights of time; that of the value is 1. Each treasure that weights prefer is preferred by some of these."""
TIME_WEIGHTS = (0.15, 0.3, 0.5, 0.9, 1.4, 1.9, 2.6, 3.2, 4.2, 5.4, 6.6, 8.0, 9.4, 12.0, 15.0, 22.0, 35.0, 60.0)
"""Weights of time for Chebyshev distances. At each concavity here, every treasure is the closest one for some."""
LIMIT = 7
"""The air lasts for so many steps."""
PRICE_RATE = 0.01
"""η: by how much the price changes for each step beyond the limit, or short of it."""
BEFORE = 500
"""Added to the seed of a training, this is that of the one before it."""


def diver(concavity: float) -> Diver:
    """Make the task."""
    mdp: Diver = make_mdp("Diver", concavity=concavity)
    return mdp


def front_of(concavity: float) -> Reals:
    """Return the exact Pareto front, shape (9, 2); row k is treasure k."""
    return exact_front(diver(concavity)).returns


def treasure_of(returns: Any) -> int:
    """Return which treasure a dive with these returns picks up; 9 for none."""
    value, time = returns
    return int((-time - 1) // 2) if value > 0 else N_TREASURES


def weighted(concavity: float, price: float, seed: int = 0, n_steps: int = N_STEPS) -> VectorRun:
    """Train Q-learning on the weighted sum: the value, less the price of each step."""
    mdp = Weighted.create(diver(concavity), (1.0, price))
    agent = QLearning.create(mdp, learning_rate=1.0, discount=1.0, exploration=AT_RANDOM)
    return train_vectors(mdp, agent, n_steps, seed=seed, evaluate_every=n_steps)


def found_by_weights(concavity: float, seed: int = 0, prices: tuple[float, ...] = PRICES) -> list[int]:
    """Return which treasure Q-learning picks up in the end, for each price."""
    return [treasure_of(weighted(concavity, price, seed).returns[-1]) for price in prices]


def planned_by_weights(concavity: float) -> set[int]:
    """Return which treasures are best for some of the prices, exactly."""
    front = front_of(concavity)
    return {int((front @ (1.0, price)).argmax()) for price in PRICES}


def chebyshev(
    concavity: float, time_weight: float, *, whole_returns: bool, seed: int = 0, n_steps: int = N_STEPS
) -> VectorRun:
    """Train Q-learning with Chebyshev distances; the weight of the value is 1."""
    mdp = diver(concavity)
    agent = ChebyshevQLearning.create(
        mdp,
        (1.0, time_weight),
        learning_rate=1.0,
        discount=1.0,
        exploration=AT_RANDOM,
        whole_returns=whole_returns,
    )
    return train_vectors(mdp, agent, n_steps, seed=seed, evaluate_every=n_steps)


def found_by_distance(concavity: float, *, whole_returns: bool, seed: int = 0) -> list[int]:
    """Return which treasure this picks up in the end, for each weight of time."""
    return [
        treasure_of(chebyshev(concavity, weight, whole_returns=whole_returns, seed=seed).returns[-1])
        for weight in TIME_WEIGHTS
    ]


def closest(concavity: float) -> list[int]:
    """Return which treasure is closest to the best value and the best time, for each weight of time, exactly."""
    front = front_of(concavity)
    missing = front.max(axis=0) - front
    return [int(np.maximum(missing[:, 0], weight * missing[:, 1]).argmin()) for weight in TIME_WEIGHTS]


def pareto(concavity: float, seed: int = 0, n_steps: int = PARETO_STEPS) -> ParetoQLearning:
    """Train Pareto Q-learning, and return it."""
    mdp = diver(concavity)
    agent = ParetoQLearning.create(mdp, discount=1.0, exploration=AT_RANDOM)
    train_vectors(mdp, agent, n_steps, seed=seed, evaluate_every=n_steps)
    return agent


def found_by_sets(concavity: float, seed: int = 0) -> set[int]:
    """Return which points of the exact front Pareto Q-learning finds; 9 stands for any others."""
    front = front_of(concavity)
    found = pareto(concavity, seed).front(0)
    distances = np.abs(found[:, np.newaxis] - front).sum(axis=2)
    return {int(row.argmin()) if row.min() < 1e-9 else N_TREASURES for row in distances}


def lagrangian(
    concavity: float,
    limit: int = LIMIT,
    seed: int = 0,
    first_price: float = 0.0,
    n_steps: int = CONSTRAINED_STEPS,
    rate: float = PRICE_RATE,
    *,
    known: bool = False,
    first_time: float = 0.0,
) -> VectorRun:
    """Train Q-learning with a learned price of time, so that a dive takes at most `limit` steps on average.

    It explores by first values that are too high, and in no other way; that for time is `first_time`. If the values are
    `known`, it has been trained before, and only the price begins anew.
    """
    mdp = diver(concavity)
    agent = LagrangianQLearning.create(
        mdp,
        [-float(limit)],
        initial_values=(100.0, first_time),
        initial_multiplier=first_price,
        multiplier_rate=rate,
        learning_rate=1.0,
        discount=1.0,
        exploration=Greedy(),
    )
    if known:
        train_vectors(mdp, agent, n_steps, seed=seed + BEFORE, evaluate_every=n_steps)
        agent.multipliers[1:] = first_price
    return train_vectors(mdp, agent, n_steps, seed=seed, evaluate_every=max(1, n_steps // 100))


def constrained(concavity: float, limit: int = LIMIT) -> ConstrainedOptimum:
    """Return the exact optimum under the limit."""
    return constrained_optimum(front_of(concavity), -float(limit))


def late(run: VectorRun) -> Reals:
    """Return the returns of the second half of the training dives."""
    return run.training_returns[len(run.training_returns) // 2 :]


def late_prices(run: VectorRun) -> Reals:
    """Return the price of time after each dive of the second half, by dual ascent from 0 at the first dive."""
    price, after = 0.0, []
    for time in run.training_returns[:, 1]:
        price = max(0.0, price + PRICE_RATE * (-time - LIMIT))
        after.append(price)
    return np.array(after[len(after) // 2 :])


def settles(run: VectorRun, limit: int = LIMIT) -> bool:
    """Return whether hardly any dive of the second half takes too long."""
    return float(too_long(late(run), limit).mean()) < 0.01


def too_long(returns: Reals, limit: int = LIMIT) -> Reals:
    """Return for each dive whether it took more steps than the limit."""
    return np.asarray(returns[:, 1] < -limit, float)

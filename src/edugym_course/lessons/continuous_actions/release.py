"""One decision of Trashbot by itself: where to let go of the box. Policies for it, and the gradient of their value.

An action a says where the box is let go: 0 is the middle of the container, and at -1 and 1 the box only just fits.
Rewards are those of Trashbot: 4 in the middle, 2 where the box only just fits, -2 on the wall.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals

Reward = Callable[[Reals], Reals]
Scores = Callable[[Any, Any, Any], tuple[Any, Any]]
GRID = np.linspace(-12.0, 12.0, 24_001)
"""The actions over which a value is summed up, as an integral."""
POOR, RICH = -1.0, 2.0
"""The middles of two containers: one that pays little, and one that pays as usual."""
SMALLEST, LARGEST = 0.02, math.e
"""σ never leaves these bounds."""
FARTHEST = 6.0
"""μ is never farther from 0."""


def reward(a: Reals) -> Reals:
    """Return what it pays to let go of the box at these distances from the middle."""
    return np.where(np.abs(a) <= 1.0, 4.0 - 2.0 * np.abs(a), -2.0)


def two_containers(a: Reals) -> Reals:
    """Return the same where there are two containers: one around -1 pays half as much as one around 2."""
    poor, rich = np.abs(a - POOR), np.abs(a - RICH)
    return np.where(rich <= 1.0, 4.0 - 2.0 * rich, np.where(poor <= 1.0, 2.0 - poor, -2.0))


def density(a: Reals, mean: float, spread: float) -> Reals:
    """Return the density of the normal distribution."""
    return np.exp(-((a - mean) ** 2) / (2.0 * spread**2)) / (spread * math.sqrt(2.0 * math.pi))


def value(mean: float, spread: float, pays: Reward = reward) -> float:
    """Return J: the expected reward of a Gaussian policy, as a sum over a fine grid of actions."""
    step = GRID[1] - GRID[0]
    return float((density(GRID, mean, spread) * pays(GRID)).sum() * step)


def slopes(mean: float, spread: float, pays: Reward = reward, h: float = 1e-4) -> tuple[float, float]:
    """Return how fast J grows with μ, and how fast it grows with ln σ, by finite differences."""
    wider, narrower = spread * math.exp(h), spread * math.exp(-h)
    of_mean = value(mean + h, spread, pays) - value(mean - h, spread, pays)
    of_log_spread = value(mean, wider, pays) - value(mean, narrower, pays)
    return of_mean / (2.0 * h), of_log_spread / (2.0 * h)


def scores(a: Any, mean: Any, spread: Any) -> tuple[Any, Any]:
    """Return how fast ln π(a) grows with μ, and how fast it grows with ln σ."""
    return (a - mean) / spread**2, (a - mean) ** 2 / spread**2 - 1.0


def estimates(
    mean: float, spread: float, n: int, *, baseline: float = 0.0, seed: int = 0, pays: Reward = reward
) -> Reals:
    """Return estimates of both slopes of J, each from one action: (R - b) times its scores, shape (2, n)."""
    actions = np.random.default_rng(seed).normal(mean, spread, n)
    both: Reals = np.array(scores(actions, mean, spread))
    return (pays(actions) - baseline) * both


class Climbed(NamedTuple):
    """How policies changed while they learned.

    Attributes:
        means: shape (n_updates + 1, n_runs): μ, or of bins the likeliest action.
        spreads: shape (n_updates + 1, n_runs): σ, or 0.
        values: shape (n_updates, n_runs): the rewards.
    """

    means: Reals
    spreads: Reals
    values: Reals


def climb(
    *,
    mean: float = -0.8,
    spread: float = 1.0,
    rate: float = 0.01,
    n_updates: int = 2_000,
    n_runs: int = 100,
    baseline: bool = True,
    smallest: float = SMALLEST,
    seed: int = 0,
    pays: Reward = reward,
    score: Scores = scores,
) -> Climbed:
    """Train Gaussian policies by REINFORCE: one action, one update of μ and of ln σ.

    Args:
        mean: μ at first.
        spread: σ at first.
        rate: α.
        n_updates: how many actions each policy takes.
        n_runs: how many policies learn, each by itself.
        baseline: whether the mean of all rewards so far is subtracted from each reward.
        smallest: the least σ, greater than 0.
        seed: of the actions.
        pays: the reward of an action.
        score: the scores of the Gaussian policy.
    """
    rng = np.random.default_rng(seed)
    mu, log_sigma, b = np.full(n_runs, mean), np.full(n_runs, math.log(spread)), np.zeros(n_runs)
    means, spreads, rewards = [mu], [np.exp(log_sigma)], []
    for t in range(n_updates):
        sigma = spreads[-1]
        actions = rng.normal(mu, sigma)
        paid = pays(actions)
        if baseline:
            b = b + (paid - b) / (t + 1)
        of_mean, of_log_spread = score(actions, mu, sigma)
        mu = np.clip(mu + rate * (paid - b) * of_mean, -FARTHEST, FARTHEST)
        moved = log_sigma + rate * (paid - b) * of_log_spread
        log_sigma = np.clip(moved, math.log(smallest), math.log(LARGEST))
        means.append(mu)
        spreads.append(np.exp(log_sigma))
        rewards.append(paid)
    return Climbed(np.array(means), np.array(spreads), np.array(rewards))


def climb_in_bins(
    n_bins: int = 13,
    *,
    rate: float = 0.05,
    n_updates: int = 2_000,
    n_runs: int = 100,
    seed: int = 0,
    pays: Reward = two_containers,
) -> Climbed:
    """Train softmax policies over actions in bins, from -3 to 3, by REINFORCE with the same baseline.

    Args:
        n_bins: how many actions there are; at first all are equally likely.
        rate: α.
        n_updates: how many actions each policy takes.
        n_runs: how many policies learn, each by itself.
        seed: of the actions.
        pays: the reward of an action.
    """
    rng = np.random.default_rng(seed)
    actions, theta, b = np.linspace(-3.0, 3.0, n_bins), np.zeros((n_runs, n_bins)), np.zeros(n_runs)
    means, rewards = [actions[theta.argmax(axis=1)]], []
    for t in range(n_updates):
        weights = np.exp(theta - theta.max(axis=1, keepdims=True))
        probabilities = weights / weights.sum(axis=1, keepdims=True)
        chosen = (probabilities.cumsum(axis=1) < rng.random((n_runs, 1))).sum(axis=1).clip(max=n_bins - 1)
        paid = pays(actions[chosen])
        b = b + (paid - b) / (t + 1)
        theta = theta + rate * (paid - b)[:, None] * (np.eye(n_bins)[chosen] - probabilities)
        means.append(actions[theta.argmax(axis=1)])
        rewards.append(paid)
    means_array = np.array(means)
    return Climbed(means_array, np.zeros_like(means_array), np.array(rewards))

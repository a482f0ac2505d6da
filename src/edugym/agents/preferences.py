"""Preferences instead of rewards: what a teacher prefers, and the rewards that explain it."""

from typing import Any

import numpy as np

from edugym.checks.parameters import a_number, above, an_array, between, flags, in_short
from edugym.mdp.protocol import Reals

SETTLED = 1e-9
"""Newton's method ends when no reward changes by more, in units of 1 or of the largest reward."""
MOST_ROUNDS = 100
"""Newton's method needs some ten, and more with a weak prior."""
LEAST_PRIOR = 1e-9
"""A weaker one is lost in rounding."""
ROUNDING = 1e-12
"""A likelihood that is lower by such a share may be as high."""
MOST_NUMBERS = 5_000
"""Of the table of rewards: Newton's method solves as many linear equations in each round."""


def preference(first_return: Any, second_return: Any, noise: float = 1.0) -> Any:
    """The probability that a teacher prefers the first of two pieces of behaviour, as Bradley and Terry (1952) have it.

        p = 1 / (1 + exp(-(G_1 - G_2) / τ))

    Args:
        first_return: G_1, what the first is worth to the teacher: a number, or an array of them.
        second_return: G_2, likewise.
        noise: τ, greater than 0, in units of reward. With a small one the teacher is hardly ever wrong; with a large
            one it tosses a coin.

    Raises:
        ValueError: the noise is not as above, or the returns are no numbers.
    """
    first, second = _returns("first_return", first_return), _returns("second_return", second_return)
    probability = _logistic((first - second) / above("noise", noise, 0, 1e300))
    return float(probability) if probability.ndim == 0 else probability


def fit_rewards(first: Any, second: Any, prefers_first: Any, *, prior: float = 0.1) -> Reals:
    """The rewards that explain best which of two pieces of behaviour a teacher preferred.

    A piece of behaviour is told by its visits: how often it took each action in each state. With rewards w its return
    is Σ visits · w, and the teacher prefers the first with probability p = 1 / (1 + exp(-(G_1 - G_2))). The rewards
    maximise

        Σ ln (p of what the teacher preferred) - (prior / 2) Σ w²

    which has one maximum; Newton's method finds it. The rewards are in units of the teacher's noise. Comparisons do not
    tell everything: a number that is added to the rewards of both pieces alike, step by step, changes no comparison,
    and what no comparison tells is 0.

    Args:
        first: shape (n, n_states, n_actions): the visits of the first piece of each comparison.
        second: the same shape: those of the second piece.
        prior: how strongly rewards are kept near 0; from one billionth to one million. 0.1 is a normal distribution
            with variance 10 for each of them.
        prefers_first: shape (n,): True where the teacher preferred the first.

    Returns:
        The rewards, shape (n_states, n_actions).

    Raises:
        ValueError: a parameter is not as above.

    References: Bradley and Terry (1952); Christiano et al. (2017), Deep reinforcement learning from human preferences,
    equation 1 (they fit a network, by gradient steps).
    """
    between("prior", prior, LEAST_PRIOR, 1e6)
    visits = an_array("first", first, ("n", "n_states", "n_actions"))
    others = an_array("second", second, visits.shape)
    preferred = flags("prefers_first", prefers_first, len(visits), "comparisons")
    if not np.isfinite(visits).all() or not np.isfinite(others).all():
        raise ValueError("first and second must hold finite numbers of visits, but one of them does not")
    n_states, n_actions = visits.shape[1:]
    if n_states * n_actions > MOST_NUMBERS:
        raise ValueError(f"first must have at most {MOST_NUMBERS} states times actions, but has {n_states * n_actions}")
    differences = (visits - others).reshape(len(visits), n_states * n_actions)
    signed = np.where(preferred[:, np.newaxis], differences, -differences)
    return most_likely(signed, prior).reshape(n_states, n_actions)


def most_likely(differences: Reals, prior: float) -> Reals:
    """The rewards that make the comparisons most likely, by Newton's method.

    Args:
        differences: shape (n, d): how often each of d pairs of a state and an action was taken by the piece that the
            teacher preferred, less how often by the other.
        prior: as in `fit_rewards`.

    Returns:
        The rewards, shape (d,).
    """
    rewards: Reals = np.zeros(differences.shape[1])
    likelihood = _log_likelihood(differences, rewards, prior)
    for _ in range(MOST_ROUNDS):
        surprise = np.exp(-np.logaddexp(0.0, differences @ rewards))  # 1 - p of what the teacher preferred
        gradient = differences.T @ surprise - prior * rewards
        curvature = (differences.T * (surprise * (1 - surprise))) @ differences + prior * np.eye(len(rewards))
        step = np.asarray(np.linalg.solve(curvature, gradient))
        # A whole step may go too far where the teacher never errs; then half of it, or a quarter, is tried.
        while (then := _log_likelihood(differences, rewards + step, prior)) < (1 + ROUNDING) * likelihood:
            step /= 2
        rewards, likelihood = rewards + step, then
        if np.abs(step).max() <= SETTLED * max(1.0, np.abs(rewards).max()):
            break
    return rewards


def _returns(name: str, given: Any) -> Reals:
    """A return as an array without axes, or several.

    Raises:
        ValueError: they are no finite numbers.
    """
    if not isinstance(given, list | tuple | np.ndarray) or np.ndim(given) == 0:
        return np.asarray(a_number(name, given), float)
    returns = an_array(name, given)
    if not returns.size or not np.isfinite(returns).all():
        raise ValueError(f"{name} must be a finite number, or an array of them, but is {in_short(given)}")
    return returns


def _logistic(x: Reals) -> Reals:
    """1 / (1 + exp(-x)), without overflow."""
    probability: Reals = 0.5 * (1.0 + np.tanh(0.5 * x))
    return probability


def _log_likelihood(differences: Reals, rewards: Reals, prior: float) -> float:
    """What the rewards maximise: ln p of what the teacher preferred, less the prior's part."""
    return float(-np.logaddexp(0.0, -(differences @ rewards)).sum() - 0.5 * prior * (rewards @ rewards))

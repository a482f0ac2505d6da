"""Maximisation bias, exactly: what the largest sample mean is on average, and what the arm that has it is worth."""

from typing import Any

import numpy as np

from edugym.checks.parameters import an_array, in_short, whole_number
from edugym.mdp.protocol import Reals

MOST_TRIES, MOST_TABLES = 10_000, 1_000
MOST_NUMBERS = 20_000_000
"""The largest table in a computation: more would take minutes, and gigabytes."""
ROUNDING = 1e-9
"""Sums of payoffs that differ by a smaller share than this count as equal: they are sums of the same payoffs in another
order."""


def expected_maximum(payoffs: Any, n_tries: int, probabilities: Any = None, n_tables: int = 1) -> float:
    """What the largest of several estimates is on average: E[max_a Q(a)], where Q(a) is a mean of n payoffs of arm a.

    No estimate is wrong on average, but their maximum is: it picks an arm that was lucky. The difference from the
    largest true mean is the maximisation bias. With N tables, each with n payoffs of its own of every arm, Q(a) is the
    smallest of their N means, as in maxmin Q-learning. Nothing is simulated: the sum goes over all values that Q can
    have.

        machines = edugym.make_mdp("Casino", n_machines=10).payoffs
        bias = edugym.expected_maximum(machines, 5) - -0.1

    Args:
        payoffs: shape (n_arms, n_payoffs): what each arm may pay; finite numbers.
        n_tries: n, from 1 to 10 000.
        probabilities: of these payoffs, of the same shape; each row sums to 1. By default all are equally likely.
        n_tables: N, from 1 to 1000.

    Returns:
        The mean of the maximum, in units of payoff.

    Raises:
        ValueError: a parameter is not as above, or the means can have too many values to go through.

    References: Thrun and Schwartz (1993); van Hasselt (2010), section 2; Lan et al. (2020), theorem 1.
    """
    values, chances = _estimates(payoffs, n_tries, probabilities, n_tables)
    at_most = np.prod(np.cumsum(chances, axis=1), axis=0)  # P(max Q <= v)
    return float(values @ np.diff(at_most, prepend=0.0))


def expected_choice(payoffs: Any, n_tries: int, probabilities: Any = None, n_tables: int = 1) -> float:
    """What the arm that looks best is truly worth on average: E[μ(A)] with A = argmax_a Q(a), ties drawn.

    This is also what a second table says of A on average, since its payoffs have nothing to do with the choice: the
    target of double Q-learning. It is never above the largest true mean, and it is below where arms differ and some
    other one may look best.

    Args:
        payoffs: as in `expected_maximum`, which also says what Q is.
        n_tries: likewise.
        probabilities: likewise.
        n_tables: likewise.

    Returns:
        The mean of μ(A), in units of payoff.

    Raises:
        ValueError: as for `expected_maximum`.

    Reference: van Hasselt (2010), lemma 1.
    """
    _, chances = _estimates(payoffs, n_tries, probabilities, n_tables)
    table, weights = _arms(payoffs, probabilities)
    below = np.cumsum(chances, axis=1) - chances
    # An arm with j equals wins with probability 1 / (1 + j). That is the integral over t from 0 to 1 of the product
    # over all others of P(below) + t P(equal), a polynomial, for which Gauss's rule is exact.
    nodes, node_weights = np.polynomial.legendre.leggauss(len(table) // 2 + 1)
    wins = np.zeros(len(table))
    for t, weight in zip((nodes + 1.0) / 2.0, node_weights / 2.0, strict=True):
        wins += weight * (chances * _of_all_others(below + t * chances)).sum(axis=1)
    return float(wins @ (table * weights).sum(axis=1))


def _arms(payoffs: Any, probabilities: Any) -> tuple[Reals, Reals]:
    """Payoffs and their probabilities, checked."""
    table = an_array("payoffs", payoffs, ("n_arms", "n_payoffs"))
    if not table.size or not np.isfinite(table).all():
        raise ValueError(f"payoffs must be finite numbers, at least one for each arm, but is {in_short(payoffs)}")
    if probabilities is None:
        return table, np.full(table.shape, 1.0 / table.shape[1])
    weights = an_array("probabilities", probabilities, table.shape)
    if not (weights >= 0.0).all() or not np.allclose(weights.sum(axis=1), 1.0, rtol=0, atol=1e-9):
        raise ValueError(f"probabilities must sum to 1 in each row, none below 0, but is {in_short(probabilities)}")
    return table, weights


def _estimates(payoffs: Any, n_tries: int, probabilities: Any, n_tables: int) -> tuple[Reals, Reals]:
    """The values that estimates can have, ascending, shape (V,), and the chances of each arm's, shape (n_arms, V)."""
    table, weights = _arms(payoffs, probabilities)
    n = whole_number("n_tries", n_tries, 1, MOST_TRIES)
    n_tables = whole_number("n_tables", n_tables, 1, MOST_TABLES)
    both = np.stack([table, weights], axis=1)
    kinds, kind_of_arm = np.unique(both, axis=0, return_inverse=True)  # arms that pay the same are worked out once
    means = [_mean(kind[0], kind[1], n) for kind in kinds]
    values, rows = _merged(np.concatenate([value for value, _ in means]), float(np.abs(table).max()))
    if len(table) * len(values) > MOST_NUMBERS:
        raise ValueError(f"n_tries must be less for so many arms and payoffs, but is {n}")
    parts = np.split(rows, np.cumsum([len(value) for value, _ in means])[:-1])
    chances = np.array([np.bincount(at, p, len(values)) for at, (_, p) in zip(parts, means, strict=True)])
    above = np.clip(1.0 - np.cumsum(chances, axis=1), 0.0, 1.0)
    at_most = 1.0 - above**n_tables  # P(the smallest of N means <= v)
    return values, np.diff(at_most, axis=1, prepend=0.0)[kind_of_arm.ravel()]


def _mean(payoffs: Reals, weights: Reals, n: int) -> tuple[Reals, Reals]:
    """The values that the mean of n payoffs can have, and their chances."""
    scale = float(np.abs(payoffs).max()) * n
    sums: Reals = np.zeros(1)
    chances: Any = np.ones(1)
    for _ in range(n):
        if len(sums) * len(payoffs) > MOST_NUMBERS // n:
            raise ValueError(f"n_tries must be less for so many payoffs, but is {n}")
        sums, rows = _merged(np.add.outer(sums, payoffs).ravel(), scale)
        chances = np.bincount(rows, np.multiply.outer(chances, weights).ravel(), len(sums))
    return sums / n, chances


def _merged(numbers: Reals, scale: float) -> tuple[Reals, Any]:
    """Numbers that differ, ascending, and for each of those given the place of its equal; equal but for rounding."""
    order = np.argsort(numbers, kind="stable")
    ascending = numbers[order]
    new = np.diff(ascending, prepend=-np.inf) > ROUNDING * scale
    rows = np.empty(len(numbers), np.int64)
    rows[order] = np.cumsum(new) - 1
    return ascending[new], rows


def _of_all_others(factors: Reals) -> Reals:
    """For each row the product of all other rows."""
    before, after = np.ones_like(factors), np.ones_like(factors)
    np.cumprod(factors[:-1], axis=0, out=before[1:])
    after[:-1] = np.cumprod(factors[:0:-1], axis=0)[::-1]
    product: Reals = before * after
    return product

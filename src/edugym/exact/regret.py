"""Regret in bandits: what the choices of an agent have cost on average, exactly, and how slowly that can grow.

References: Lai and Robbins (1985), Asymptotically efficient adaptive allocation rules; Lattimore and Szepesvári (2020),
Bandit algorithms, sections 4.4 and 16.1.
"""

import math
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from edugym.checks.parameters import an_array, in_short
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Integers, Reals

ROUNDING = 1e-12
"""An arm that is worse than the best by a smaller share is as good, but for rounding."""


def action_gaps(model: FiniteModel) -> Reals:
    """By how much each action pays less than the best one: max_b r(s, b) - r(s, a), shape (S, A).

    This is what an action costs on average in a bandit, where no action changes what comes after it.

    Args:
        model: the exact model of the bandit.

    Raises:
        ValueError: `model` is none, or is no bandit: what comes next depends on the action.
    """
    if not isinstance(model, FiniteModel):
        raise ValueError(f"model must be an exact model, as finite_model makes it, but is {in_short(model)}")
    if not np.allclose(model.p, model.p[:, :1], rtol=0, atol=1e-12):
        s = int((np.abs(model.p - model.p[:, :1]) > 1e-12).any(axis=(1, 2)).argmax())
        raise ValueError(
            f"model must be that of a bandit, where no action changes what comes next, but in state {model.states[s]!r}"
            " the next state depends on the action"
        )
    gaps: Reals = model.r.max(axis=1, keepdims=True) - model.r
    return gaps


def regret(model: FiniteModel, actions: Sequence[int] | Integers, states: Sequence[Any] | None = None) -> Reals:
    """The regret after each of T pulls of a bandit: the sum of the gaps of the actions so far, shape (T,).

    It is exact, given the actions: the luck of single rewards does not count.

    Args:
        model: the exact model of the bandit.
        actions: the T actions, in their order.
        states: the state before each of them; may be left out if the bandit has only one.

    Raises:
        ValueError: an argument is not as above, or the model is not that of a bandit.
    """
    gaps = action_gaps(model)
    chosen = np.asarray(actions)
    whole = chosen.ndim == 1 and (not len(chosen) or np.issubdtype(chosen.dtype, np.integer))
    if not whole or ((chosen < 0) | (chosen >= gaps.shape[1])).any():
        raise ValueError(
            f"actions must be a list of whole numbers from 0 to {gaps.shape[1] - 1}, but is {in_short(actions)}"
        )
    if states is None and len(gaps) > 1:
        raise ValueError(f"states must be a list of the state before each pull, since there are {len(gaps)} states")
    rows = [0] * len(chosen) if states is None else _rows(model, states, len(chosen))
    total: Reals = gaps[rows, chosen.astype(np.int64)].cumsum()
    return total


def _rows(model: FiniteModel, states: Any, n_pulls: int) -> list[int]:
    """The row of the state before each pull."""
    with suppress(ValueError, TypeError):
        rows = [model.row(state) for state in states]
        if len(rows) == n_pulls:
            return rows
    raise ValueError(
        f"states must be a list of states of the model, one for each of the {n_pulls} pulls, but is {in_short(states)}"
    )


def lai_robbins(probabilities: Any) -> float:
    """The constant of Lai and Robbins: no good strategy has a regret that grows more slowly than c ln T.

        c = Σ_a (p* - p_a) / KL(p_a, p*),    KL(p, q) = p ln(p/q) + (1 - p) ln((1 - p)/(1 - q))

    The sum is over the arms that are worse than the best; each pays 1 with probability p_a, else 0, and p* is the
    largest of these. "Good" is a strategy whose regret grows, on every bandit, more slowly than any power of T; the
    bound holds in the limit of long runs, so for small T a curve may lie below c ln T.

    Args:
        probabilities: p, how often each arm pays: one number from 0 to 1 for each of one or more arms.

    Raises:
        ValueError: `probabilities` is not as above.
    """
    p = an_array("probabilities", probabilities, ("n_arms",))
    if not len(p) or not ((p >= 0) & (p <= 1)).all():
        raise ValueError(f"probabilities must be one or more numbers from 0 to 1, but is {in_short(probabilities)}")
    best = float(p.max())
    worse = [one for one in p.tolist() if best - one > ROUNDING * best]
    return math.fsum((best - one) / divergence_of_coins(one, best) for one in worse)


def divergence_of_coins(p: float, q: float) -> float:
    """KL(p, q) = p ln(p/q) + (1 - p) ln((1 - p)/(1 - q)) of two coins, for p < q.

    Written as p f(d/p) + (1 - p) f(-d/(1 - p)), where d = q - p and f(x) = x - ln(1 + x), since the logarithms of the
    usual form nearly cancel where p is close to q. It is infinite if q is 1: a single 0 then gives p away.
    """
    if q == 1.0:
        return math.inf
    d = q - p
    first = p * _excess(d / p) if d < p else d - (p * (math.log(q) - math.log(p)) if p > 0.0 else 0.0)
    return first + (1.0 - p) * _excess(-d / (1.0 - p))


def _excess(x: float) -> float:
    """The function x - ln(1 + x): by its series where x is small."""
    if abs(x) < 0.01:
        return math.fsum((-x) ** k / k for k in range(2, 10))
    return x - math.log1p(x)

"""Exact planning in a finite MDP: the optimum that every learning curve is drawn against."""

from typing import NamedTuple

import numpy as np

from edugym.checks import above, between, whole_number
from edugym.exact.model import FiniteModel
from edugym.mdp.protocol import Reals


class Values(NamedTuple):
    """What planning found.

    Attributes:
        V: shape (S,): the value of each state, by the rows of the model.
        Q: shape (S, A): the value of each action in each state.
        start: the expected return of an episode, from the initial states.
    """

    V: Reals
    Q: Reals
    start: float


def value_iteration(
    model: FiniteModel,
    discount: float = 1.0,
    *,
    epsilon: float = 0.0,
    horizon: int | None = None,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
) -> Values:
    """The best values there are: sweep over all states until nothing changes.

        Q(s, a) <- Σ_s' p(s'|s, a) [r(s, a, s') + γ V(s')]
        V(s)    <- (1 - ε) max_a Q(s, a) + ε mean_a Q(s, a)

    With ε = 0 these are the optimal values; with ε > 0 the values of the best policy among those that take a random
    action with probability ε in every state, which is the best that an ε-greedy agent can do while it explores.

    Args:
        model: the exact model.
        discount: γ, from 0 to 1.
        epsilon: ε, from 0 to 1.
        horizon: with a number, the values of an episode that is cut off after so many steps; the policy may then
            depend on the steps that are left. Without one, episodes last until the task ends.
        tolerance: stop when no value changes by more; greater than 0.
        max_sweeps: give up after so many sweeps, 1 or more.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle (at discount 1, some episodes may never
        end and
            gather reward without limit: give a horizon).

    References: Sutton and Barto, 2nd edition, equation 4.10 and the box of section 4.4; section 5.4 for ε-soft
    policies.
    """
    between("discount", discount, 0, 1)
    between("epsilon", epsilon, 0, 1)
    above("tolerance", tolerance, 0)
    whole_number("max_sweeps", max_sweeps, 1)
    if horizon is not None:
        whole_number("horizon", horizon, 1)
    V = np.zeros(len(model.states))
    Q = np.zeros(model.successors.shape[:2])
    for _ in range(horizon or max_sweeps):
        Q = (model.probabilities * (model.rewards + discount * V[model.successors])).sum(axis=2)
        before, V = V, (1 - epsilon) * Q.max(axis=1) + epsilon * Q.mean(axis=1)
        if horizon is None and np.abs(V - before).max() < tolerance:
            break
    else:
        if horizon is None:
            raise ValueError(f"values do not settle in {max_sweeps} sweeps at discount {discount!r}: give a horizon")
    return Values(V, Q, float(model.initial @ V))

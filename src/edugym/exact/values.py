"""What planning finds, and the sweeps over all states by which it is found."""

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from edugym.checks.parameters import above, between, in_short, whole_number
from edugym.exact.tables import FiniteModel, looked_ahead
from edugym.mdp.protocol import Reals

StateValues: TypeAlias = Callable[[Reals], Reals]
"""From Q, shape (S, A), to V, shape (S,): what the actions in each state are worth together."""

MOST_SWEEPS = 10_000_000
"""The most sweeps over all states: of a small task they take some minutes."""
CLOSE = 1e-9
"""Action values that differ by less are taken as equal (of large values: by this share of them)."""


class Values(NamedTuple):
    """What planning found.

    Attributes:
        V: shape (S,): the value of each state, by the rows of the model. **Rows are not observations**: `V[8]` is the
            value of `model.states[8]`. Ask for `value(state)`, or for `table()`, which goes by observations.
        Q: shape (S, A): the value of each action in each state, by the rows of the model.
        start: the expected return of an episode, from the initial states.
        model: the model that it was found with.
    """

    V: Reals
    Q: Reals
    start: float
    model: FiniteModel

    def value(self, state: Any) -> float:
        """V(s) of a state.

        Raises:
            ValueError: the task has no such state.
        """
        return float(self.V[self.model.row(state)])

    def table(self) -> Reals:
        """The action values by what the agent observes: shape (observations, A), to be compared with an agent's `Q`.

        What is never observed has NaN; `np.nanmax(table, axis=1)` gives the values of observations.

        Raises:
            ValueError: the observation does not tell the state, or is not made of whole numbers.
        """
        observed = self.model.observations()
        table = np.full((self.model.table_task().observation_space.n, self.Q.shape[1]), np.nan)
        table[observed] = self.Q
        for s, other in enumerate(self.model.states):
            if not np.array_equal(table[observed[s]], self.Q[s]):
                raise ValueError(f"there is no table by observation: {other!r} looks like a state of other values")
        return table

    def greedy_policy(self) -> Reals:
        """The policy that takes the best action, shape (S, A): the best ones share the probability equally."""
        return greedy_actions(self.Q)


def greedy_actions(Q: Reals) -> Reals:
    """The policy that takes the best action, shape (S, A): the best ones share the probability equally."""
    best = Q.max(axis=1, keepdims=True)
    is_best = best - CLOSE * np.maximum(1.0, np.abs(best)) <= Q
    policy: Reals = is_best / is_best.sum(axis=1, keepdims=True)
    return policy


def largest(Q: Reals) -> Reals:
    """The largest action value of each state; by columns, since NumPy takes ten times as long for many short rows."""
    values: Reals = np.asfortranarray(Q).max(axis=1)
    return values


def sweeps(model: FiniteModel, state_values: StateValues, discount: float) -> Iterator[tuple[Reals, Reals]]:
    """V and Q with 0, 1, 2, ... steps left: each from the one before, by looking one step ahead in every state."""
    Q: Reals = np.zeros(model.successors.shape[:2])
    V: Reals = np.zeros(len(model.states))
    while True:
        yield V, Q
        Q = looked_ahead(model, V, discount)
        V = state_values(Q)


def sweep_until_settled(
    model: FiniteModel,
    state_values: StateValues,
    discount: float,
    horizon: int | None,
    tolerance: float,
    max_sweeps: int,
) -> Values:
    """The values with `horizon` steps left, or, without a horizon, those that a further sweep does not change.

    Raises:
        ValueError: a parameter is not as planning asks, or the values do not settle.
    """
    check_model(model, discount)
    above("tolerance", tolerance, 0)
    if tolerance == math.inf:
        raise ValueError(f"tolerance must be a finite number greater than 0, but is {in_short(tolerance)}")
    whole_number("max_sweeps", max_sweeps, 1, MOST_SWEEPS)
    if horizon is not None:
        whole_number("horizon", horizon, 1, MOST_SWEEPS)
    before = None
    for sweep, (V, Q) in enumerate(sweeps(model, state_values, discount)):
        settled = before is not None and np.abs(V - before).max() < tolerance  # Δ < θ in the boxes
        if sweep == horizon or (horizon is None and settled):
            return Values(V, Q, expected_return(model, V), model)
        if horizon is None and sweep == max_sweeps:
            break
        before = V
    remedy = "give a horizon, for some episodes may never end" if discount == 1 else "give a larger max_sweeps"
    in_sweeps = f"in {max_sweeps} sweep{'' if max_sweeps == 1 else 's'}"
    raise ValueError(f"values do not settle {in_sweeps} at discount {discount!r}: {remedy}")


def expected_return(model: FiniteModel, V: Reals) -> float:
    """The value of the start of an episode: Σ_s p(s) V(s) over the initial states."""
    starts = np.flatnonzero(model.initial)
    return math.fsum(model.initial[starts] * V[starts])


def check_model(model: FiniteModel, discount: float) -> None:
    """Check a model and a discount.

    Raises:
        ValueError: it is no model, or the discount is not from 0 to 1.
    """
    require_model(model)
    between("discount", discount, 0, 1)


def require_model(model: Any) -> None:
    """Check that something is a model.

    Raises:
        ValueError: it is not.
    """
    if not isinstance(model, FiniteModel):
        raise ValueError(f"model must be a FiniteModel, as finite_model(mdp) makes it, but is {in_short(model)}")

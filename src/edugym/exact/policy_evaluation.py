"""Policy evaluation: what a policy is worth."""

from typing import Any

import numpy as np

from edugym.checks.parameters import in_short
from edugym.exact.tables import FiniteModel
from edugym.exact.values import Values, check_model, sweep_until_settled
from edugym.mdp.protocol import Reals


def policy_evaluation(
    model: FiniteModel,
    policy: Any,
    discount: float = 1.0,
    *,
    horizon: int | None = None,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
) -> Values:
    """The values of a policy: sweep over all states until nothing changes.

        Q(s, a) <- Σ_s' p(s'|s, a) [r(s, a, s') + γ V(s')]
        V(s)    <- Σ_a π(a|s) Q(s, a)

    `policy_evaluation(model, policy_of(agent, model))` is what an agent's policy is really worth, exploring included.

    Args:
        model: the exact model.
        policy: π, by the rows of the model: shape (S, A), the probability of every action in every state, or shape
            (S,), an action for every state.
        discount: γ, from 0 to 1.
        horizon: with a number, the values of an episode that is cut off after so many steps, from 1 to 10 million, as
            the step limit `mdp.max_steps` does. Without one, episodes last until the task ends.
        tolerance: stop when no value changes by more; greater than 0.
        max_sweeps: give up after so many sweeps, from 1 to 10 million.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle: at discount 1, the policy may never end an
            episode and gather reward without limit (give a horizon).

    References: Sutton and Barto, 2nd edition, equation 4.5 and the box of section 4.1.
    """
    check_model(model, discount)
    probabilities = as_probabilities(policy, model)

    def expected(Q: Reals) -> Reals:
        V: Reals = np.einsum("sa,sa->s", probabilities, Q)
        return V

    return sweep_until_settled(model, expected, discount, horizon, tolerance, max_sweeps)


def as_probabilities(policy: Any, model: FiniteModel | tuple[int, int], name: str = "policy") -> Reals:
    """A policy as the probability of every action in every state, shape (S, A); messages call it by a name.

    Args:
        policy: what was given.
        model: the model by whose rows it goes, or (S, A).
        name: of the parameter.

    Raises:
        ValueError: it has another shape, actions that are not there, or probabilities that are none.
    """
    n_states, n_actions = model if not isinstance(model, FiniteModel) else model.successors.shape[:2]
    if hasattr(policy, "act"):
        kind = policy.__name__ if isinstance(policy, type) else type(policy).__name__
        raise ValueError(f"{name} must be an array, but is the agent {kind}: policy_of(agent, model) gives its policy")
    try:
        given = np.asarray(policy)
    except ValueError:  # rows of different lengths
        given = np.asarray(None)
    if given.shape == (n_states,) and np.issubdtype(given.dtype, np.integer):
        wrong = given[(given < 0) | (given >= n_actions)]
        if len(wrong):
            raise ValueError(f"{name} must hold actions from 0 to {n_actions - 1}, but holds {wrong[0]}")
        actions: Reals = np.eye(n_actions)[given]
        return actions
    if given.shape != (n_states, n_actions) or not np.issubdtype(given.dtype, np.number):
        shape = f", of shape {given.shape}" if given.shape else ""
        raise ValueError(
            f"{name} must be a whole number for each of the {n_states} rows of the model (`model.states`, not "
            f"observations) or an array of probabilities of shape {(n_states, n_actions)}, but is {in_short(policy)}"
            f"{shape}: policy_of(agent, model) gives that of an agent"
        )
    probabilities = given.astype(np.float64)
    bad = ~(probabilities >= 0).all(axis=1) | ~(np.abs(probabilities.sum(axis=1) - 1) < 1e-6)
    if bad.any():
        s = int(bad.argmax())
        raise ValueError(f"{name} must hold probabilities that sum to 1 in every row, but row {s} is {given[s]}")
    return probabilities

"""Planning with a penalty for leaving a reference policy, as when a language model is tuned to a learned reward."""

from typing import Any

import numpy as np

from edugym.checks.parameters import an_array, between
from edugym.exact.policy_evaluation import as_probabilities, policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.values import Values, check_model, require_model, sweep_until_settled
from edugym.mdp.protocol import Reals

LEAST_PENALTY, MOST_PENALTY = 1e-6, 1e6


def regularised_iteration(
    model: FiniteModel,
    reference: Any,
    penalty: float,
    discount: float = 1.0,
    *,
    horizon: int | None = None,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
) -> Values:
    """Optimal values when each step costs β times how far the policy is from a reference policy there.

        Q(s, a) <- Σ_s' p(s'|s, a) [r(s, a, s') + γ V(s')]
        V(s)    <- β ln Σ_a π_ref(a|s) exp(Q(s, a) / β)

    This V is the largest value of Σ_a π(a|s) Q(s, a) - β D(s) over all π, where D(s) = Σ_a π(a|s) ln(π(a|s) /
    π_ref(a|s)) is the Kullback-Leibler divergence of the two. `regularised_policy` gives the π that attains it. A large
    β keeps to the reference; as β goes to 0 the policy becomes the best one among the actions that the reference takes
    at all.

    Args:
        model: the exact model.
        reference: π_ref, by the rows of the model: shape (S, A), or shape (S,), an action for every state.
        penalty: β, from 1e-6 to 1e6, in units of reward.
        discount: γ, from 0 to 1.
        horizon: with a number, the values of an episode that is cut off after so many steps, from 1 to 10 million.
        tolerance: stop when no value changes by more; greater than 0.
        max_sweeps: without a horizon, give up after so many sweeps, from 1 to 10 million.

    Returns:
        The values, the penalty included: `start` is the expected return less β times the divergence of the whole
        episode.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle.

    References: Levine (2018), Reinforcement learning and control as probabilistic inference, section 2.4; Jaques et al.
    (2017), Sequence tutor, equation 7, with another name for β.
    """
    check_model(model, discount)
    between("penalty", penalty, LEAST_PENALTY, MOST_PENALTY)
    probabilities = as_probabilities(reference, model, "reference")

    def soft_maximum(Q: Reals) -> Reals:
        highest, below = _from_highest(Q, probabilities)
        # Written with e^x - 1 and ln(1 + x), it is exact for a large penalty too, where all exponents are near 0.
        V: Reals = highest + penalty * np.log1p((probabilities * np.expm1(below / penalty)).sum(axis=1))
        return V

    return sweep_until_settled(model, soft_maximum, discount, horizon, tolerance, max_sweeps)


def regularised_policy(values: Values, reference: Any, penalty: float) -> Reals:
    """The policy that `regularised_iteration` finds: π(a|s) = π_ref(a|s) exp((Q(s, a) - V(s)) / β), shape (S, A).

    Args:
        values: what `regularised_iteration` gave, without a horizon.
        reference: π_ref, as there.
        penalty: β, as there.

    Raises:
        ValueError: a parameter is not as above.
    """
    if not isinstance(values, Values):
        raise ValueError(f"values must be those of regularised_iteration, but is of type {type(values).__name__}")
    between("penalty", penalty, LEAST_PENALTY, MOST_PENALTY)
    probabilities = as_probabilities(reference, values.model, "reference")
    _, below = _from_highest(values.Q, probabilities)
    weights = probabilities * np.exp(below / penalty)
    policy: Reals = weights / weights.sum(axis=1, keepdims=True)
    return policy


def divergence(
    model: FiniteModel, policy: Any, reference: Any, discount: float = 1.0, *, horizon: int | None = None
) -> float:
    """How far a policy goes from a reference in an episode: the expected sum of D(s) over its steps, in nats.

    At discount 1 this is the Kullback-Leibler divergence of the whole episodes that the two policies make.

    Args:
        model: the exact model.
        policy: π, by the rows of the model: shape (S, A), or shape (S,), an action for every state.
        reference: π_ref, likewise. It must take every action that the policy takes, or the divergence is infinite.
        discount: γ, from 0 to 1.
        horizon: with a number, of an episode that is cut off after so many steps.

    Raises:
        ValueError: a parameter is not as above, or episodes may never end at discount 1.
    """
    require_model(model)
    taken, expected = as_probabilities(policy, model), as_probabilities(reference, model, "reference")
    ratio = np.divide(taken, expected, out=np.ones_like(taken), where=(taken > 0) & (expected > 0))
    in_state = (taken * np.log(ratio)).sum(axis=1)
    impossible = ((taken > 0) & (expected == 0)).any(axis=1) & ~model.terminal
    if impossible.any():
        visits = _per_state(model, impossible.astype(float))
        if policy_evaluation(visits, taken, discount, horizon=horizon).start > 0:
            return np.inf
    return policy_evaluation(_per_state(model, in_state), taken, discount, horizon=horizon).start


def with_rewards(model: FiniteModel, rewards: Any) -> FiniteModel:
    """The same task with another reward for each state and action, such as one that was learned.

    Args:
        model: the exact model.
        rewards: shape (S, A), by the rows of the model. Those of terminal states are not used.

    Raises:
        ValueError: `model` is no model, or the rewards are no finite numbers of this shape.
    """
    require_model(model)
    table = an_array("rewards", rewards, model.successors.shape[:2])
    by_outcome = np.broadcast_to(table[:, :, np.newaxis], model.rewards.shape)
    return model._replace(rewards=np.where(model.terminal[:, np.newaxis, np.newaxis], 0.0, by_outcome))


def _per_state(model: FiniteModel, costs: Reals) -> FiniteModel:
    return with_rewards(model, np.repeat(costs[:, np.newaxis], model.successors.shape[1], axis=1))


def _from_highest(Q: Reals, probabilities: Reals) -> tuple[Reals, Reals]:
    """The highest value of each state among the actions that the reference takes, and how far each action is below."""
    highest: Reals = np.where(probabilities > 0, Q, -np.inf).max(axis=1)
    below: Reals = np.where(probabilities > 0, Q - highest[:, np.newaxis], 0.0)
    return highest, below

"""Policy iteration: evaluate a policy, act greedily on its values, and begin again."""

import numpy as np

from edugym.checks.parameters import whole_number
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.values import MOST_SWEEPS, Values, check_model
from edugym.mdp.protocol import Reals

BETTER = 1e-8
"""How much better (of large values: by this share of them) than the policy an action must be for another round."""


def policy_iteration(
    model: FiniteModel,
    discount: float = 1.0,
    *,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
    max_iterations: int = 1_000,
) -> Values:
    """The best values there are: improve a policy until no action is better than its own.

        V <- the values of π                      (policy evaluation)
        π(s) <- argmax_a Σ_s' p(s'|s, a) [r(s, a, s') + γ V(s')]     (policy improvement)

    It starts from random actions, since these come to the end of every task that has one within reach. The policy found
    is `values.greedy_policy()`.

    Args:
        model: the exact model.
        discount: γ, from 0 to 1.
        tolerance: policy evaluation stops when no value changes by more; greater than 0.
        max_sweeps: how many sweeps it may take each time, from 1 to 10 million.
        max_iterations: give up after so many policies, likewise.

    Raises:
        ValueError: a parameter is not as above, or values or policies do not settle.

    References: Howard (1960); Sutton and Barto, 2nd edition, the box of section 4.3 (which would go on for ever between
    equally good policies, exercise 4.4: here it ends when no action is better).
    """
    check_model(model, discount)
    max_iterations = whole_number("max_iterations", max_iterations, 1, MOST_SWEEPS)
    n_states, n_actions, _ = model.successors.shape
    policy: Reals = np.full((n_states, n_actions), 1 / n_actions)
    for _ in range(max_iterations):
        values = policy_evaluation(model, policy, discount, tolerance=tolerance, max_sweeps=max_sweeps)
        better = values.Q.max(axis=1) > values.V + BETTER * np.maximum(1.0, np.abs(values.V))
        if not better.any():
            return values
        policy = values.greedy_policy()
    raise ValueError(f"the policy does not settle in {max_iterations} improvements")

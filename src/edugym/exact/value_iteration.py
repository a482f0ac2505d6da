"""Value iteration: the optimum of a task with a finite model."""

from edugym.checks.parameters import between
from edugym.exact.tables import FiniteModel
from edugym.exact.values import StateValues, Values, largest, sweep_until_settled
from edugym.mdp.protocol import Reals


def value_iteration(
    model: FiniteModel,
    discount: float = 1.0,
    *,
    epsilon: float = 0.0,
    horizon: int | None = None,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
) -> Values:
    """Optimal values: sweep over all states until no value changes by `tolerance` or more.

        Q(s, a) <- Σ_s' p(s'|s, a) [r(s, a, s') + γ V(s')]
        V(s)    <- (1 - ε) max_a Q(s, a) + ε mean_a Q(s, a)

    With ε = 0 these are the optimal values; with ε > 0 the values of the best policy among those that take a random
    action with probability ε in every state, which is the best that an ε-greedy agent can do while it explores.

    Args:
        model: the exact model.
        discount: γ, from 0 to 1.
        epsilon: ε, from 0 to 1.
        horizon: with a number, the values of an episode that is cut off after so many steps, from 1 to 10 million
            (those of `finite_horizon`); the policy may then depend on the steps that are left. Without one, episodes
            last until the task ends.
        tolerance: stop when every change is smaller; a finite number greater than 0.
        max_sweeps: without a horizon, give up after so many sweeps, from 1 to 10 million.

    Returns:
        The values `V` and `Q`, and `start`, the expected return from the start of an episode. `finite_model(mdp)` makes
        the model.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle. At discount 1, episodes that never end may
            gather reward without limit: give a horizon.

    References: Sutton and Barto, 2nd edition, equation 4.10 and the box of section 4.4; section 5.4 for ε-soft
    policies.
    """
    return sweep_until_settled(model, best_values(epsilon), discount, horizon, tolerance, max_sweeps)


def best_values(epsilon: float) -> StateValues:
    """Return a function from Q to V for the policy that is random with probability ε, else greedy.

    Raises:
        ValueError: ε is not from 0 to 1.
    """
    between("epsilon", epsilon, 0, 1)

    def best(Q: Reals) -> Reals:
        greedy = largest(Q)
        return (1 - epsilon) * greedy + epsilon * Q.mean(axis=1) if epsilon else greedy

    return best

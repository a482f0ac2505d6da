"""Value iteration: the optimum that every learning curve is drawn against."""

from edugym.checks import between
from edugym.exact.tables import FiniteModel
from edugym.exact.values import StateValues, Values, sweep_until_settled
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
    """The best values there are: sweep over all states until nothing changes.

        Q(s, a) <- Σ_s' p(s'|s, a) [r(s, a, s') + γ V(s')]
        V(s)    <- (1 - ε) max_a Q(s, a) + ε mean_a Q(s, a)

    With ε = 0 these are the optimal values; with ε > 0 the values of the best policy among those that take a random
    action with probability ε in every state, which is the best that an ε-greedy agent can do while it explores.

    Args:
        model: the exact model.
        discount: γ, from 0 to 1.
        epsilon: ε, from 0 to 1.
        horizon: with a number, the values of an episode that is cut off after so many steps (those of
            `finite_horizon`); the policy may then depend on the steps that are left. Without one, episodes last until
            the task ends.
        tolerance: stop when no value changes by more; greater than 0.
        max_sweeps: give up after so many sweeps, 1 or more.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle: at discount 1, some episodes may never end
            and gather reward without limit (give a horizon).

    References: Sutton and Barto, 2nd edition, equation 4.10 and the box of section 4.4; section 5.4 for ε-soft
    policies.
    """
    return sweep_until_settled(model, best_values(epsilon), discount, horizon, tolerance, max_sweeps)


def best_values(epsilon: float) -> StateValues:
    """The values of states where the best action is taken, but a random one with probability ε.

    Raises:
        ValueError: ε is not from 0 to 1.
    """
    between("epsilon", epsilon, 0, 1)

    def best(Q: Reals) -> Reals:
        V: Reals = (1 - epsilon) * Q.max(axis=1) + epsilon * Q.mean(axis=1)
        return V

    return best

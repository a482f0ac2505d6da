"""Dynamic programming backwards from the last step, for episodes that are cut off."""

import math
from itertools import islice

from edugym.checks.parameters import whole_number
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import best_values
from edugym.exact.values import MOST_SWEEPS, Values, check_model, expected_return, sweeps
from edugym.system.memory import require_memory

OVERHEAD = 64
"""Besides its numbers, each `Values` takes about as much memory as so many more."""


def finite_horizon(model: FiniteModel, horizon: int, discount: float = 1.0, *, epsilon: float = 0.0) -> list[Values]:
    """The best values with 0, 1, ..., `horizon` steps left: `finite_horizon(model, 10)[3]` has those with three left.

        Q_k(s, a) = Σ_s' p(s'|s, a) [r(s, a, s') + γ V_(k-1)(s')]
        V_k(s)    = (1 - ε) max_a Q_k(s, a) + ε mean_a Q_k(s, a),    V_0 = 0

    The best action may depend on the steps that are left: `finite_horizon(model, 10)[3].greedy_policy()`.

    Args:
        model: the exact model.
        horizon: the steps of an episode, from 1 to 10 million, as far as memory goes.
        discount: γ, from 0 to 1.
        epsilon: ε, from 0 to 1: the probability of a random action in every state.

    Raises:
        ValueError: a parameter is not as above.

    References: Bertsekas (2017), Dynamic Programming and Optimal Control, volume 1, section 1.3. Each step is one sweep
    of the box of section 4.4 of Sutton and Barto, 2nd edition.
    """
    check_model(model, discount)
    horizon = whole_number("horizon", horizon, 1, MOST_SWEEPS)
    entries = math.prod(model.successors.shape[:2]) + len(model.states) + OVERHEAD
    require_memory("the values for every step of the horizon", (horizon + 1, entries), "take a shorter horizon")
    steps = islice(sweeps(model, best_values(epsilon), discount), horizon + 1)
    return [Values(V, Q, expected_return(model, V), model) for V, Q in steps]

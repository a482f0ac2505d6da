"""What rewards teach, exactly: the best policy for a reward, judged by another one, and what happens under it."""

from collections.abc import Callable, Mapping
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.exact.values import Values
from edugym.experiments.results.statistics import in_short
from edugym.mdp.protocol import Reals
from edugym.mdp.task import task_of
from edugym_course.lessons.own_problem.morning import RING

DISCOUNT = 1.0
MOST_STEPS = 1_000
"""The step limit of a problem that has none."""
MEANT, WAKEFULNESS, WAKINGS = "what I meant", "2 for being awake", "10 for each waking"
POTENTIAL = "the same 10 as a potential"
BEST_GUESS = "v* as a potential"


class Night(NamedTuple):
    """What happens on average in one episode under a policy.

    Attributes:
        meant: the return by the reward that was meant.
        sleep: the minutes asleep or dozing.
        rings: the number of loud rings.
        wakings: how often she wakes.
        late: the probability that she oversleeps.
    """

    meant: float
    sleep: float
    rings: float
    wakings: float
    late: float

    def __str__(self) -> str:
        """Return all of it in one line."""
        return (
            f"return as meant {self.meant:6.2f}, asleep or dozing {self.sleep:3.0f} minutes, rings {self.rings:.2f}, "
            f"wakings {self.wakings:.2f}, oversleeps with probability {self.late:.2f}"
        )


def best_policy(mdp: Any) -> Reals:
    """Return the policy that is best for the reward of an MDP, by value iteration; equal actions share.

    With a step limit it is the one that is best in the first step.
    """
    return solve(mdp).greedy_policy()


def what_happens(mdp: Any, policy: Reals) -> Night:
    """Return what happens under a policy.

    Args:
        mdp: the morning with the reward that was meant.
        policy: the policy, by the rows of the model, shape (S, A). The rows do not depend on the reward.
    """
    model = finite_model(mdp)
    end = mdp.length
    return Night(
        meant=policy_evaluation(model, policy, DISCOUNT).start,
        sleep=10.0 * _count(model, policy, lambda state, action, after: after[1] > 0),
        rings=_count(model, policy, lambda state, action, after: action == RING),
        wakings=_count(model, policy, lambda state, action, after: state[1] > 0 and after[1] == 0),
        late=_count(model, policy, lambda state, action, after: after[0] == end and after[1] > 0),
    )


def _count(model: FiniteModel, policy: Reals, counts: Callable[[Any, int, Any], bool]) -> float:
    """Return how many transitions of a kind an episode has on average: the value of a reward of 1 for each."""
    ones = np.zeros_like(model.rewards)
    for s, a, k in np.argwhere((model.probabilities > 0) & ~model.terminal[:, np.newaxis, np.newaxis]).tolist():
        ones[s, a, k] = counts(model.states[s], a, model.states[model.successors[s, a, k]])
    return policy_evaluation(model._replace(rewards=ones), policy, DISCOUNT).start


def random_return(mdp: Any, horizon: int | None = None) -> float:
    """Return what random actions earn on average in an episode."""
    model = finite_model(mdp)
    uniform = np.full(model.successors.shape[:2], 1 / model.successors.shape[1])
    return worth(model, uniform, horizon)


def worth(model: FiniteModel, policy: Reals, limit: int | None) -> float:
    """Return the expected return of a policy up to a step limit, or to one of `MOST_STEPS` if it may never end."""
    try:
        return policy_evaluation(model, policy, DISCOUNT, horizon=limit, max_sweeps=MOST_STEPS).start
    except ValueError:  # it does not settle
        return policy_evaluation(model, policy, DISCOUNT, horizon=MOST_STEPS).start


def best_blind(mdp: Any, row: Callable[[Any], int]) -> tuple[float, tuple[int, ...]]:
    """Return the best deterministic policy of a clock that sees only a part of the state, by trying them all.

    Args:
        mdp: the morning.
        row: what the clock sees of a state, as a whole number from 0.

    Returns:
        The expected return, and the action for each observation.
    """
    model = finite_model(mdp)
    seen = np.array([row(state) for state in model.states])
    n_actions = model.successors.shape[1]
    p, r = model.p, model.r
    by_time = [
        [model.rows[state] for state in model.states if state[0] == time]
        for time in reversed(range(mdp.length))  # each state leads to one of the next time
    ]
    policies = np.array([*product(range(n_actions), repeat=len({*seen[~model.terminal]}))])  # shape (n, observations)
    V = np.zeros((len(policies), len(model.states)))
    for rows in by_time:
        for s in rows:
            actions = policies[:, seen[s]]
            V[:, s] = r[s, actions] + np.einsum("ns,ns->n", p[s, actions], V)
    returns = V @ model.initial
    best = int(returns.argmax())
    return float(returns[best]), tuple(int(action) for action in policies[best])


def in_words(values: Values, names: Mapping[int, str], most: int = 40) -> str:
    """Return the best action of each state, one line each."""
    policy = values.greedy_policy()
    lines = []
    for s, state in enumerate(values.model.states):
        if not values.model.terminal[s]:
            best = " or ".join(names[int(a)] for a in np.flatnonzero(policy[s]))
            lines.append(f"{state!s:>12}: {best} (value {in_short(float(values.V[s]))})")
    more = [f"... and {len(lines) - most} more"] if len(lines) > most else []
    return "\n".join([*lines[:most], *more])


def solve(mdp: Any) -> Values:
    """Return the undiscounted optimum of any finite MDP, up to its step limit if it has one.

    Raises:
        ValueError: it is not finite, episodes may go on for ever and gather reward without limit, or returns are larger
            than any number of a computer.
    """
    model = finite_model(mdp)
    limit = task_of(mdp).max_steps
    if not model.terminal.any() and limit is None:
        raise ValueError(
            f"no state of {type(mdp).__name__} is terminal, so an episode never ends: let `terminal` be True somewhere,"
            " for example when a number of steps that is kept in the state is reached"
        )
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # returns that are too large are refused below
            values = value_iteration(model, DISCOUNT, horizon=limit, max_sweeps=20_000)
    except ValueError:
        raise ValueError(
            f"some episodes of {type(mdp).__name__} may never end, and gather reward without limit: it needs"
            " terminal states that are always reached, for example after a number of steps that is kept in the state"
        ) from None
    if not np.isfinite(values.Q).all():
        raise ValueError(f"the returns of {type(mdp).__name__} are too large to be computed: give smaller rewards")
    return values


def player(mdp: Any) -> Callable[[Any], int]:
    """Return the best policy of an MDP whose agent sees the state, as a function of the observation, for a film."""
    values = solve(mdp)
    policy = values.greedy_policy()
    return lambda seen: int(policy[values.model.row(tuple(np.ravel(seen).tolist()))].argmax())


def awake_potential(length: int, bonus: float = 10.0) -> Reals:
    """Return the potential that is `bonus` while she is awake, by time and depth; at the end it is 0."""
    phi = np.zeros((length + 1, 3))
    phi[:length, 0] = bonus
    return phi


def value_potential(mdp: Any) -> Reals:
    """Return the potential v*(s) of a morning, by time and depth."""
    values = solve(mdp)
    phi = np.zeros((mdp.length + 1, 3))
    for state, value in zip(values.model.states, values.V, strict=True):
        phi[state] = value
    return phi

"""Fitted Q: values that are learned from a dataset alone, as they are, or with pessimism."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.dataset import Dataset, policy_for, require_dataset
from edugym.checks.parameters import a_number, above, at_least, between, whole_number
from edugym.exact.values import MOST_SWEEPS, greedy_actions, largest
from edugym.mdp.protocol import Reals


class FittedValues(NamedTuple):
    """What was learned from a dataset.

    Attributes:
        V: shape (S,): the value of each state, by the rows of the dataset.
        Q: shape (S, A): the value of each action in each state.
        start: the mean of V over the states in which the episodes of the dataset begin: the return that it promises.
    """

    V: Reals
    Q: Reals
    start: float

    def greedy_policy(self) -> Reals:
        """The policy that takes the best action, shape (S, A): the best ones share the probability equally."""
        return greedy_actions(self.Q)


def fitted_q_iteration(
    dataset: Dataset,
    discount: float = 1.0,
    *,
    unseen: float = 0.0,
    horizon: int | None = None,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
) -> FittedValues:
    """Q-learning without interaction: fit all targets of a dataset at once, again and again, until nothing changes.

        target  <- R + γ max_a Q(S', a), after a step that terminated R alone
        Q(s, a) <- mean of the targets of the steps with (s, a)

    A mean is what least squares fits where Q is a table. The value that comes out is the optimum of the task as the
    data show it. It is too high where the data are few: of several actions that are known badly, the maximum picks one
    whose luck was good.

    Args:
        dataset: the steps. Whoever took them, and with what probability, does not matter here.
        discount: γ, from 0 to 1.
        unseen: the value of actions that the dataset does not have, which no target ever changes.
        horizon: with a number, the values of an episode that is cut off after so many steps, from 1 to 10 million.
        tolerance: stop when no value changes by more; greater than 0.
        max_sweeps: without a horizon, give up after so many sweeps, from 1 to 10 million.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle: at discount 1, the steps of the dataset
            may lead round in a circle that pays.

    References: Ernst, Geurts and Wehenkel (2005), Tree-based batch mode reinforcement learning; they fit trees.
    """
    a_number("unseen", unseen)
    return fitted_values(dataset, largest, discount, horizon, tolerance, max_sweeps, unseen=unseen)


def fitted_q_evaluation(
    dataset: Dataset,
    policy: Any,
    discount: float = 1.0,
    *,
    unseen: float = 0.0,
    horizon: int | None = None,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
) -> FittedValues:
    """The values of a policy π, fitted to the data of another one.

        target  <- R + γ Σ_a π(a|S') Q(S', a), after a step that terminated R alone
        Q(s, a) <- mean of the targets of the steps with (s, a)

    Args:
        dataset: the steps.
        policy: π, by the rows of the dataset: shape (S, A), or shape (S,), an action for every state.
        discount: γ, from 0 to 1.
        unseen: the value of actions that the dataset does not have.
        horizon: as for `fitted_q_iteration`.
        tolerance: as there.
        max_sweeps: as there.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle.

    References: Le, Voloshin and Yue (2019), Batch policy learning under constraints.
    """
    a_number("unseen", unseen)
    require_dataset(dataset)
    probabilities = policy_for(dataset, policy)

    def expected(Q: Reals) -> Reals:
        V: Reals = np.einsum("sa,sa->s", probabilities, Q)
        return V

    return fitted_values(dataset, expected, discount, horizon, tolerance, max_sweeps, unseen=unseen)


def pessimistic_q_iteration(
    dataset: Dataset,
    penalty: float,
    lowest: float,
    discount: float = 1.0,
    *,
    horizon: int | None = None,
    tolerance: float = 1e-10,
    max_sweeps: int = 100_000,
) -> FittedValues:
    """Fitted Q-iteration that expects the worst of what it knows badly.

        Q(s, a) <- max(lowest, mean of the targets of the steps with (s, a) - penalty / √n(s, a))

    where n(s, a) counts those steps, and an action that the dataset does not have is worth `lowest`. A mean of n
    targets is off by about their spread / √n, so with a penalty of some times the spread values are hardly ever too
    high. The policy prefers what the data cover, and keeps what its values promise.

    Args:
        dataset: the steps.
        penalty: from 0 up, in units of reward.
        lowest: the lowest return there is: no value is below it.
        discount: γ, from 0 to 1.
        horizon: as for `fitted_q_iteration`.
        tolerance: as there.
        max_sweeps: as there.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle.

    References: Jin, Yang and Wang (2021), Is pessimism provably efficient for offline RL?; Rashidinejad, Zhu, Ma, Jiao
    and Russell (2021), Bridging offline reinforcement learning and imitation learning. Their penalties follow from
    bounds on the reward and from how sure one wants to be; here it is yours to choose.
    """
    a_number("penalty", penalty)
    at_least("penalty", penalty, 0)
    a_number("lowest", lowest)
    return fitted_values(
        dataset, largest, discount, horizon, tolerance, max_sweeps, unseen=lowest, penalty=penalty, lowest=lowest
    )


def fitted_values(
    dataset: Dataset,
    state_values: Callable[[Reals], Reals],
    discount: float,
    horizon: int | None,
    tolerance: float,
    max_sweeps: int,
    *,
    unseen: float,
    penalty: float = 0.0,
    lowest: float = -np.inf,
) -> FittedValues:
    """The values that a further fit does not change, or those after `horizon` fits.

    Raises:
        ValueError: a parameter is not as above, or the values do not settle.
    """
    require_dataset(dataset)
    between("discount", discount, 0, 1)
    above("tolerance", tolerance, 0)
    a_number("tolerance", tolerance)
    whole_number("max_sweeps", max_sweeps, 1, MOST_SWEEPS)
    if horizon is not None:
        whole_number("horizon", horizon, 1, MOST_SWEEPS)
    visits = dataset.visits
    pairs = dataset.states * dataset.n_actions + dataset.actions
    times = np.maximum(visits, 1)
    going_on = np.where(dataset.terminated, 0.0, discount)
    first = dataset.states[dataset.starts]
    V: Reals = np.zeros(dataset.n_states)
    for sweep in range(1, (max_sweeps if horizon is None else horizon) + 1):
        targets = dataset.rewards + going_on * V[dataset.next_states]
        means = np.bincount(pairs, targets, visits.size).reshape(visits.shape) / times
        Q: Reals = np.where(visits > 0, np.maximum(lowest, means - penalty / np.sqrt(times)), unseen)
        before, V = V, state_values(Q)
        if sweep == horizon or (horizon is None and np.abs(V - before).max() < tolerance):
            return FittedValues(V, Q, float(V[first].mean()))
    remedy = "give a horizon, or a discount below 1" if discount == 1 else "give a larger max_sweeps"
    raise ValueError(f"values do not settle in {max_sweeps} sweep(s) at discount {discount!r}: {remedy}")

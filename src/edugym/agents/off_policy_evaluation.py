"""Off-policy evaluation: what a policy is worth, from the data of another one."""

import math
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.dataset import Dataset, policy_for, require_dataset
from edugym.checks.parameters import an_array, between, one_of, true_or_false
from edugym.mdp.protocol import Integers, Reals

METHODS = ("ordinary", "weighted", "per decision", "weighted per decision")
MOST_PLACES = 50_000_000
"""Of a table with a row for each episode and a column for each step: so many take 400 megabytes."""


class Estimate(NamedTuple):
    """What a policy seems to be worth.

    Attributes:
        value: the estimated return of an episode.
        standard_error: how far the value goes up and down from one dataset to the next, estimated from this one;
            infinite if it has one episode. Where few episodes carry nearly all the weight, it is far too small.
        effective_episodes: (Σ ρ)² / Σ ρ² over the weights ρ of whole episodes: how many episodes of the policy itself
            would say as much, roughly. From 0 to the number of episodes.
    """

    value: float
    standard_error: float
    effective_episodes: float


class _Steps(NamedTuple):
    """The steps of a dataset in tables with a row for each episode and a column for each time; 0 after the end.

    Attributes:
        states: S_t.
        actions: A_t.
        rewards: R_t+1.
        ratios: π(A_t|S_t) / b(A_t|S_t); 1 after the end.
        going_on: whether there is such a step.
    """

    states: Integers
    actions: Integers
    rewards: Reals
    ratios: Reals
    going_on: Any


def importance_sampling(dataset: Dataset, policy: Any, discount: float = 1.0, *, method: str = "ordinary") -> Estimate:
    """What a policy π is worth, from episodes that another policy b played, each weighed by how likely π plays it.

    With ρ_t = Π_k<=t π(A_k|S_k) / b(A_k|S_k) and G the return of an episode of T steps:

        ordinary                 mean of ρ_T-1 G
        weighted                 Σ ρ_T-1 G / Σ ρ_T-1
        per decision             mean of Σ_t γ^t ρ_t R_t+1
        weighted per decision    Σ_t γ^t (Σ ρ_t R_t+1 / Σ ρ_t), the inner sums over the episodes

    A reward does not depend on what is done after it; so the last two weigh it by the actions before it alone. The
    ordinary ones have no bias, where b takes every action that π takes. The weighted ones have some bias, which goes
    away with more episodes, and often much less variance. Whether b takes every action that π takes, no data can tell.

    An episode that was cut off counts as it is: the value is that of an episode of `horizon` steps then.

    Args:
        dataset: the episodes.
        policy: π, by the rows of the dataset: shape (S, A), or shape (S,), an action for every state.
        discount: γ, from 0 to 1.
        method: "ordinary", "weighted", "per decision" or "weighted per decision".

    Raises:
        ValueError: a parameter is not as above; or weights cannot be divided by their sum, which is 0: the policy would
            not have played any of the episodes up to that step.

    References: Precup, Sutton and Singh (2000), Eligibility traces for off-policy policy evaluation; Sutton and Barto,
    2nd edition, sections 5.5 and 5.9; Thomas and Brunskill (2016) for the weighted per-decision form.
    """
    one_of("method", method, METHODS)
    steps = _by_step(dataset, policy, discount)
    rho = steps.ratios.cumprod(axis=1)
    weights = rho if "per decision" in method else np.repeat(rho[:, -1:], rho.shape[1], axis=1)
    return _estimate([(weights, steps.rewards)], rho[:, -1], discount, normalised=method.startswith("weighted"))


def doubly_robust(dataset: Dataset, policy: Any, Q: Any, discount: float = 1.0, *, weighted: bool = False) -> Estimate:
    """What a policy π is worth, from values that somebody believes in, corrected by the data of another policy.

    From the end of each episode to its start, with ρ = π(A|S) / b(A|S) of one step and V(s) = Σ_a π(a|s) Q(s, a):

        V_DR <- V(S) + ρ (R + γ V_DR - Q(S, A))

    and then the mean over episodes. Where b takes every action that π takes, it has no bias, whatever Q is, as long as
    Q does not come from the same episodes; and where Q is the true one and the task has no chance, it has no variance
    either. `fitted_q_evaluation` gives a Q. Fitted to the same episodes it can be wrong without a sign of it: where no
    step of the data tries what π does, nothing corrects Q, and the standard error is 0.

    Args:
        dataset: the episodes.
        policy: π, by the rows of the dataset: shape (S, A), or shape (S,), an action for every state.
        Q: shape (S, A): the action values of π that are believed.
        discount: γ, from 0 to 1.
        weighted: whether the weights of the episodes are divided by their sum at each step, instead of their number:
            some bias, and often much less variance.

    Raises:
        ValueError: a parameter is not as above; or weights cannot be divided by their sum, which is 0.

    References: Jiang and Li (2016), Doubly robust off-policy value evaluation for reinforcement learning; Thomas and
    Brunskill (2016), Data-efficient off-policy policy evaluation for reinforcement learning, for the weighted form.
    """
    true_or_false("weighted", weighted)
    steps = _by_step(dataset, policy, discount)
    table = an_array("Q", Q, (dataset.n_states, dataset.n_actions))
    if not np.isfinite(table).all():
        raise ValueError("Q must hold finite numbers, but one of them is not")
    V = (policy_for(dataset, policy) * table).sum(axis=1)
    believed = np.where(steps.going_on, table[steps.states, steps.actions], 0.0)
    values = np.where(steps.going_on, V[steps.states], 0.0)
    rho = steps.ratios.cumprod(axis=1)
    before = np.hstack([np.ones((len(rho), 1)), rho[:, :-1]])
    # The recursion, written out: Σ_t γ^t [ρ_t-1 V(S_t) + ρ_t (R_t+1 - Q(S_t, A_t))].
    parts = [(before, values), (rho, steps.rewards - believed)]
    return _estimate(parts, rho[:, -1], discount, normalised=weighted)


def _by_step(dataset: Dataset, policy: Any, discount: float) -> _Steps:
    """The steps of all episodes, one below the other.

    Raises:
        ValueError: a parameter is not as the estimators ask, or the table would be too large.
    """
    require_dataset(dataset)
    between("discount", discount, 0, 1)
    chosen = policy_for(dataset, policy)[dataset.states, dataset.actions] / dataset.probabilities
    lengths = dataset.ends - dataset.starts + 1
    if len(lengths) * int(lengths.max()) > MOST_PLACES:
        raise ValueError(
            f"dataset must have at most {MOST_PLACES} episodes times steps of the longest, but has {len(lengths)} times"
            f" {lengths.max()}"
        )
    going_on = np.arange(lengths.max()) < lengths[:, np.newaxis]

    def table(values: Any, after: float) -> Any:
        spread = np.full(going_on.shape, after, values.dtype)
        spread[going_on] = values
        return spread

    return _Steps(
        table(dataset.states, 0), table(dataset.actions, 0), table(dataset.rewards, 0), table(chosen, 1), going_on
    )


def _estimate(parts: list[tuple[Reals, Reals]], whole: Reals, discount: float, *, normalised: bool) -> Estimate:
    """The sum over parts and times of the weighted means over episodes, with its error.

    Args:
        parts: tables of weights, and of the numbers that they weigh, with a row for each episode.
        whole: the weights of whole episodes.
        discount: γ.
        normalised: whether the weights are divided by their sum, instead of the number of episodes.

    Raises:
        ValueError: they should be, and the sum is 0.
    """
    n, n_times = parts[0][0].shape
    discounts = float(discount) ** np.arange(n_times)
    value, deviations = 0.0, np.zeros(n)
    for weights, numbers in parts:
        sums = weights.sum(axis=0)
        if normalised and not sums.all():
            raise ValueError(
                f"dataset must have an episode that the policy could play, but each of {n} has an action to which it"
                " gives a probability of 0, so there are no weights to divide by their sum"
            )
        shares = weights / (sums if normalised else n)
        means = (shares * numbers).sum(axis=0)
        value += float(means @ discounts)
        deviations += (shares * numbers - (shares if normalised else 1 / n) * means) @ discounts
    error = math.sqrt(float(deviations @ deviations) * n / (n - 1)) if n > 1 else math.inf
    squares = float(whole @ whole)
    return Estimate(value, error, float(whole.sum()) ** 2 / squares if squares else 0.0)

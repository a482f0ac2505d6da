"""The n-step target of the start of an episode of Study, exactly: its bias, and what its variance comes from."""

from typing import NamedTuple

import numpy as np

from edugym.envs.study import Study
from edugym.exact.model import finite_model
from edugym.exact.policies import soft
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.results.claims import Below, Claim, Within
from edugym.experiments.results.statistics import exactly
from edugym.mdp.protocol import Reals

DAYS = 10
DISCOUNT = 1.0
EPSILON = 0.1


class Target(NamedTuple):
    """The n-step target of the start of an episode, exactly, under a policy.

    Attributes:
        mean: its expected value.
        noise: the part of its variance that comes from the noise of rewards.
        exploration: the part that comes from the choice of actions.
    """

    mean: float
    noise: float
    exploration: float


def soft_policy(model: FiniteModel, epsilon: float) -> Reals:
    """Return the best policy among those that act at random with probability ε, shape (S, A)."""
    greedy = value_iteration(model, DISCOUNT, epsilon=epsilon).greedy_policy()
    return soft(greedy, epsilon)


def true_values(model: FiniteModel, policy: Reals) -> Reals:
    """Return the values Q(s, a) of a policy, shape (S, A)."""
    return model.action_values(policy_evaluation(model, policy).V, DISCOUNT)


def target(model: FiniteModel, policy: Reals, values: Reals, n: int, sigma: float) -> Target:
    """Return mean and variance of R_1 + ... + R_n + Q(S_n, A_n), from the start (discount 1; equation 7.4).

    Both moments are computed backwards: M_k = E[(R + G_(k-1))²] = E[R² + 2 R m_(k-1) + M_(k-1)]. Given the actions, the
    noise of the n rewards is independent and adds n σ².

    Args:
        model: the exact model.
        policy: the probabilities of actions, shape (S, A).
        values: the values from which the target bootstraps: Q, shape (S, A), where the policy draws A_n; or, for the
            target R_1 + ... + R_n + V(S_n) of equation 7.1, V, shape (S,).
        n: the number of rewards, up to the length of an episode.
        sigma: the standard deviation of the noise of a reward.
    """
    Q = values if values.ndim == 2 else np.broadcast_to(values[:, np.newaxis], policy.shape)
    mean, square = ((policy * power).sum(axis=1) * ~model.terminal for power in (Q, Q**2))
    ways = policy[:, :, None] * model.probabilities
    for _ in range(n):
        ahead = mean[model.successors]
        square = (ways * (model.rewards**2 + 2 * model.rewards * ahead + square[model.successors])).sum(axis=(1, 2))
        mean = (ways * (model.rewards + ahead)).sum(axis=(1, 2))
    first, second = float(model.initial @ mean), float(model.initial @ square)
    return Target(first, n * sigma**2, second - first**2)


def noise_share(sigma: float, layout_seed: int = 0) -> float:
    """Return the share of reward noise in the variance of the return of the best ε-soft policy."""
    model = finite_model(Study.create(layout_seed=layout_seed))
    whole = target(model, soft_policy(model, EPSILON), np.zeros(len(model.states)), DAYS, sigma)
    return whole.noise / (whole.noise + whole.exploration)


def target_claims() -> list[Claim]:
    """Return the claims on the target of the first day, computed exactly for the best ε-soft policy."""
    model = finite_model(Study.create())
    policy = soft_policy(model, EPSILON)
    Q = true_values(model, policy)
    one, whole = (target(model, policy, Q, n, 0.05) for n in (1, DAYS))
    unlearned = target(model, policy, np.zeros_like(Q), 1, 0.05)
    return [
        Claim(
            "At the defaults reward noise is less than 1 % of the variance of the return; exploration is the rest",
            "share of reward noise, σ = 0.05, computed",
            exactly(noise_share(0.05)),
            Below(0.01),
            remark=f"an exploring step can cost the exam, 10; at σ = 1 noise is {noise_share(1.0):.0%}",
        ),
        Claim(
            "Once the values are learned, the one-step target varies much less than the Monte Carlo target",
            "variance of the target of the first day, n = 1 / Monte Carlo, computed",
            exactly((one.noise + one.exploration) / (whole.noise + whole.exploration)),
            Below(0.2),
        ),
        Claim(
            "With learned values the one-step target has the same mean as the return",
            "mean of the one-step target less that of the return, computed",
            exactly(one.mean - whole.mean),
            Within(-1e-6, 1e-6),
            remark="at the fixed point every n has the same mean",
        ),
        Claim(
            "Before anything is learned, the one-step target misses nearly the whole return",
            "mean of the one-step target with Q = 0 / mean return, computed",
            exactly(unlearned.mean / whole.mean),
            Within(-0.1, 0.1),
        ),
    ]

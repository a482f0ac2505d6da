"""The depth of credit assignment on Study: the claims hold with other seeds than those the lesson shows."""

import numpy as np
import pytest

from edugym.envs.study import Study
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.lessons.depth import (
    MONTE_CARLO,
    best_returns,
    compare,
    expected_returns,
    layouts,
)
from edugym.lessons.depth.targets import DAYS, noise_share, soft_policy, target


def test_target_against_samples() -> None:
    """Mean and variance of the three-step target agree with sampled episodes of a random policy."""
    task = Study.create(action_reward_noise_sigma=0.5)
    model = finite_model(task)
    policy = np.full(model.successors.shape[:2], 0.2)
    V = policy_evaluation(model, policy).V + 1.0
    rng = np.random.default_rng(0)
    targets = []
    for _ in range(10_000):
        state, total = task.initial(rng), 0.0
        for _ in range(3):
            action = int(rng.integers(5))
            next_state = task.transition(state, action, rng)
            total += task.reward(state, action, next_state, rng)
            state = next_state
        targets.append(total + V[model.row(state)])
    exact = target(model, policy, V, 3, 0.5)
    assert np.mean(targets) == pytest.approx(exact.mean, abs=0.04)
    assert np.var(targets) == pytest.approx(exact.noise + exact.exploration, rel=0.06)


def test_target_at_the_fixed_point() -> None:
    """With the values of the policy every n has the same mean; the variance grows with n."""
    model = finite_model(Study.create())
    policy = soft_policy(model, 0.1)
    values = policy_evaluation(model, policy)
    targets = [target(model, policy, values.V, n, 0.2) for n in range(1, DAYS + 1)]
    assert [one.mean for one in targets] == pytest.approx([values.start] * DAYS)
    variances = [one.noise + one.exploration for one in targets]
    assert variances == sorted(variances)


def test_noise_share() -> None:
    """Without noise there is none in the variance, and more noise is a larger part of it."""
    assert noise_share(0.0) == 0.0
    assert noise_share(0.05) < noise_share(0.2) < noise_share(1.0) < 1.0


def test_expected_returns_are_within_the_optimum() -> None:
    """The exact greedy return of every run is at most the optimum of its layout, and differs between layouts."""
    results = compare(n_steps=2_000, repetitions=3, seed=1)
    tasks = layouts(results)
    assert len({task.lectures.tobytes() + task.action_rewards.tobytes() for task in tasks.values()}) == 3
    returns = expected_returns(results, MONTE_CARLO)
    for repetition, task in tasks.items():
        [optimum] = best_returns({0: task}, 0.0)
        assert returns[repetition] <= optimum + 1e-9
    optimum, soft = best_returns(tasks, 0.0, 0.1)
    assert soft < optimum

"""Planning with a penalty for leaving a reference policy, against its definition, its limits and bad arguments."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import logsumexp, softmax

from edugym import (
    divergence,
    finite_model,
    policy_evaluation,
    regularised_iteration,
    regularised_policy,
    value_iteration,
    with_rewards,
)
from tests.exact.tasks import LOOP, random_model, value_of
from tests.messages import named

SEEDS = st.integers(0, 10**6)
PENALTIES = st.sampled_from([0.01, 0.3, 1.0, 20.0])


@settings(max_examples=40, deadline=None)
@given(SEEDS, PENALTIES, st.sampled_from([0.5, 0.95, 1.0]))
def test_no_policy_is_worth_more_than_the_one_that_is_found(seed: int, penalty: float, discount: float) -> None:
    """Its return less the penalty is the value that was found, and that of any other policy is no higher."""
    model = random_model(seed, n_actions=3)
    rng = np.random.default_rng(seed)
    reference, other = rng.dirichlet(np.ones(3), 4), rng.dirichlet(np.ones(3), 4)
    values = regularised_iteration(model, reference, penalty, discount, tolerance=1e-12)
    policy = regularised_policy(values, reference, penalty)

    def worth(policy: Any) -> float:
        costs = np.where(model.terminal, 0.0, (policy * np.log(policy / reference)).sum(axis=1))
        far = float(model.initial @ value_of(with_rewards(model, np.repeat(costs[:, None], 3, 1)), policy, discount))
        assert divergence(model, policy, reference, discount) == pytest.approx(far, abs=1e-7)
        return float(model.initial @ value_of(model, policy, discount)) - penalty * far

    if policy.min() > 0:  # else an exponential has become 0
        assert worth(policy) == pytest.approx(values.start, abs=1e-7)
    assert worth(other) <= values.start + 1e-7


@settings(max_examples=20, deadline=None)
@given(SEEDS, PENALTIES, st.sampled_from([0.5, 0.9]))
def test_agrees_with_a_second_implementation(seed: int, penalty: float, discount: float) -> None:
    """To 1e-12 of the largest value: V(s) = β ln Σ_a π_ref(a|s) exp(Q(s, a) / β), again and again."""
    model = random_model(seed, n_actions=3)
    reference = np.random.default_rng(seed).dirichlet(np.ones(3), len(model.states))
    Q = np.zeros_like(reference)
    for _ in range(500):
        V = np.where(model.terminal, 0.0, penalty * logsumexp(Q / penalty, axis=1, b=reference))
        Q = model.r + discount * model.p @ V
    found = regularised_iteration(model, reference, penalty, discount, tolerance=1e-14)
    assert np.abs(found.V - V).max() <= 1e-12 * max(1.0, np.abs(V).max())
    shares = softmax(Q / penalty + np.log(reference), axis=1)
    assert np.abs(regularised_policy(found, reference, penalty) - shares)[~model.terminal].max() <= 1e-12 / min(
        1.0, penalty
    )


@settings(max_examples=20, deadline=None)
@given(SEEDS)
def test_the_limits_are_the_reference_and_the_optimum(seed: int) -> None:
    """A large penalty keeps to the reference; a small one leaves the best policy among its actions."""
    model = random_model(seed, n_actions=3)
    reference = np.random.default_rng(seed).dirichlet(np.ones(3), 4)
    assert regularised_iteration(model, reference, 1e6).start == pytest.approx(
        policy_evaluation(model, reference).start, abs=1e-4
    )
    values = regularised_iteration(model, reference, 1e-6)
    assert values.start == pytest.approx(value_iteration(model).start, abs=1e-4)
    assert regularised_policy(values, reference, 1e-6).max(axis=1)[:3] == pytest.approx(np.ones(3))
    always_first = np.zeros(4, int)
    kept = regularised_iteration(model, always_first, 1e-6)
    assert kept.start == pytest.approx(policy_evaluation(model, always_first).start)
    assert (regularised_policy(kept, always_first, 1e-6)[:, 0] == 1).all()


def test_by_hand() -> None:
    """Leaving pays 0 and ends; staying pays 1. One step: V = β ln(1/2 + 1/2 e^(1/β)), π(stay) = e^(1/β) / (1 + ...)."""
    model = finite_model(LOOP)
    half = np.full((len(model.states), 2), 0.5)
    values = regularised_iteration(model, half, 2.0, horizon=1)
    assert values.start == pytest.approx(2 * np.log(0.5 + 0.5 * np.exp(0.5)))
    stay = np.exp(0.5) / (1 + np.exp(0.5))
    assert regularised_policy(values, half, 2.0)[model.row(3), 1] == pytest.approx(stay)
    one_step = np.where(np.arange(2) == 1, 1.0, 0.0) * np.ones((len(model.states), 1))
    assert divergence(model, one_step, half, horizon=1) == pytest.approx(np.log(2))
    assert divergence(model, half, one_step, horizon=1) == np.inf
    assert divergence(model, half, half) == 0.0


@pytest.mark.parametrize(
    ("call", "names"),
    [
        (lambda model, pi: regularised_iteration(model, pi, 0.0), ("penalty", 1e-06, 1000000.0, 0.0)),
        (lambda model, pi: regularised_iteration(model, pi, 2e6), ("penalty", 1e-06, 1000000.0, 2000000.0)),
        (lambda model, pi: regularised_iteration(model, pi[1:], 1.0), ("reference",)),
        (lambda model, pi: regularised_iteration(pi, pi, 1.0), ("model", "FiniteModel")),
        (lambda model, pi: regularised_policy(pi, pi, 1.0), ("values", "regularised_iteration", "ndarray")),
        (lambda model, pi: divergence(model, pi, [0.5]), ("reference",)),
        (lambda model, pi: with_rewards(model, [1.0]), ("rewards", (4, 2), [1.0])),
        (lambda model, pi: with_rewards(pi, [1.0]), ("model", "FiniteModel")),
    ],
)
def test_bad_arguments_are_named(call: Any, names: tuple[Any, ...]) -> None:
    """The message names the parameter, what is allowed and what was given."""
    with pytest.raises(ValueError, match=named(*names)):
        call(random_model(0), np.full((4, 2), 0.5))

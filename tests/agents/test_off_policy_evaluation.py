"""Importance sampling and doubly robust estimates: by hand, against a second implementation, and against the truth."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import (
    Dataset,
    FiniteModel,
    collect,
    doubly_robust,
    fitted_q_evaluation,
    importance_sampling,
    policy_evaluation,
)
from edugym.agents.off_policy_evaluation import METHODS
from tests.agents.offline import by_hand, random_data
from tests.exact.tasks import random_model
from tests.messages import named

TARGET = np.array([[0.25, 0.75], [1.0, 0.0], [0.5, 0.5]])
"""The ratios of the dataset by hand are 3/2 and 2, so 3; then 3/2; and 1. The returns at γ = 1/2 are 4, 0 and 8."""

NEVER = by_hand(actions=[1, 0, 0, 0])
"""A policy that always takes action 1 could play only the first step of the first episode."""


@pytest.mark.parametrize(
    ("method", "value"),
    [
        ("ordinary", (3 * 4 + 1.5 * 0 + 1 * 8) / 3),
        ("weighted", (3 * 4 + 1.5 * 0 + 1 * 8) / 5.5),
        ("per decision", (1.5 * 2 + 3 * 2 + 1.5 * 0 + 1 * 8) / 3),
        ("weighted per decision", (1.5 * 2 + 1.5 * 0 + 1 * 8) / 4 + 3 * 2 / 5.5),
    ],
)
def test_importance_sampling_by_hand(method: str, value: float) -> None:
    """At γ = 1/2. After the end of an episode its weight stays."""
    found = importance_sampling(by_hand(), TARGET, 0.5, method=method)
    assert found.value == pytest.approx(value)
    assert found.effective_episodes == pytest.approx(5.5**2 / (9 + 2.25 + 1))


def test_errors_by_hand() -> None:
    """Of the ordinary one, the standard deviation over √n; of the weighted one, that of the weighted deviations."""
    terms = np.array([12.0, 0.0, 8.0])
    assert importance_sampling(by_hand(), TARGET, 0.5).standard_error == pytest.approx(terms.std(ddof=1) / np.sqrt(3))
    far = np.array([3.0, 1.5, 1.0]) / 5.5 * (np.array([4.0, 0.0, 8.0]) - 20 / 5.5)
    weighted = importance_sampling(by_hand(), TARGET, 0.5, method="weighted")
    assert weighted.standard_error == pytest.approx(np.sqrt((far**2).sum() * 3 / 2))
    one = Dataset.create([0], [0], [1.0], [1], [True], [False], [0.5], 2, 1)
    assert importance_sampling(one, [0, 0]).standard_error == np.inf


def test_doubly_robust_by_hand() -> None:
    """With V(0) = 1/4 · 4 + 3/4 · 8 = 7 and V(1) = 2, from the last step of each episode to its first."""
    Q = [[4.0, 8.0], [2.0, 6.0], [9.0, 9.0]]
    last = 2 + 2 * (4 - 2)
    first = 7 + 1.5 * (2 + 0.5 * last - 8)
    second, third = 7 + 1.5 * (0 - 8), 7 + 1 * (8 - 4)
    found = doubly_robust(by_hand(), TARGET, Q, 0.5)
    assert found.value == pytest.approx((first + second + third) / 3)
    assert found.standard_error == pytest.approx(np.std([first, second, third], ddof=1) / np.sqrt(3))
    # Weighted: at step 0 the weights are 1.5, 1.5 and 1; at step 1 they are 3, 1.5 and 1.
    at_once = (1.5 * (2 - 8) + 1.5 * (0 - 8) + 1 * (8 - 4)) / 4
    then = 1.5 * 2 / 4 + 3 * (4 - 2) / 5.5
    assert doubly_robust(by_hand(), TARGET, Q, 0.5, weighted=True).value == pytest.approx(7 + at_once + 0.5 * then)


def second_implementation(dataset: Dataset, target: Any, discount: float, Q: Any) -> dict[str, float]:
    """All estimates, episode by episode and step by step, in plain Python."""
    episodes = [[*range(a, b + 1)] for a, b in zip(dataset.starts, dataset.ends, strict=True)]
    longest, n = max(map(len, episodes)), len(episodes)
    ratio = [target[s][a] / p for s, a, p in zip(dataset.states, dataset.actions, dataset.probabilities, strict=True)]
    rho = []
    for steps in episodes:
        products = [1.0]
        for k in steps:
            products.append(products[-1] * ratio[k])
        rho.append(products + [products[-1]] * (longest + 1 - len(products)))
    whole = [row[-1] for row in rho]
    returns = [sum(discount**t * dataset.rewards[k] for t, k in enumerate(steps)) for steps in episodes]
    V = [sum(target[s][a] * Q[s][a] for a in range(dataset.n_actions)) for s in range(dataset.n_states)]
    per_decision = weighted_per_decision = weighted_robust = 0.0
    for i, steps in enumerate(episodes):
        for t, k in enumerate(steps):
            s, a, r = dataset.states[k], dataset.actions[k], dataset.rewards[k]
            sums = [sum(row[time] for row in rho) for time in (t, t + 1)]
            per_decision += discount**t * rho[i][t + 1] * r / n
            weighted_per_decision += discount**t * rho[i][t + 1] * r / sums[1]
            weighted_robust += discount**t * (rho[i][t + 1] / sums[1] * (r - Q[s][a]) + rho[i][t] / sums[0] * V[s])
    robust = 0.0
    for steps in episodes:
        later = 0.0
        for k in reversed(steps):
            s, a, r = dataset.states[k], dataset.actions[k], dataset.rewards[k]
            later = V[s] + ratio[k] * (r + discount * later - Q[s][a])
        robust += later / n
    products = [w * g for w, g in zip(whole, returns, strict=True)]
    return {
        "ordinary": sum(products) / n,
        "weighted": sum(products) / sum(whole),
        "per decision": per_decision,
        "weighted per decision": weighted_per_decision,
        "robust": robust,
        "weighted robust": weighted_robust,
    }


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 10**6), st.sampled_from([0.5, 0.95, 1.0]), st.integers(1, 30))
def test_agrees_with_a_second_implementation(seed: int, discount: float, n_episodes: int) -> None:
    """To 1e-12, for random models and policies, with episodes that end and others that are cut off."""
    _, target, _, dataset = random_data(seed, n_episodes)
    Q = np.random.default_rng(seed).normal(size=(4, 3))
    expected = second_implementation(dataset, target, discount, Q)
    found = {method: importance_sampling(dataset, target, discount, method=method).value for method in METHODS}
    found["robust"] = doubly_robust(dataset, target, Q, discount).value
    found["weighted robust"] = doubly_robust(dataset, target, Q, discount, weighted=True).value
    assert found == {name: pytest.approx(value, rel=1e-12, abs=1e-12) for name, value in expected.items()}


def estimates(seed: int, repetitions: int, n_episodes: int) -> tuple[dict[str, Any], float]:
    """Values and standard errors of all estimators over many datasets, and the truth.

    Half of the time the target policy does what the behaviour policy does: with larger weights the standard error of a
    single dataset would be too small.
    """
    model, target, behaviour, _ = random_data(seed)
    target = 0.5 * target + 0.5 * behaviour
    exact = policy_evaluation(model, target, 0.9, horizon=6)
    found: dict[str, list[Any]] = {}
    for number in range(repetitions):
        dataset = collect(model, behaviour, n_episodes, max_steps=6, seed=number)
        believed = np.random.default_rng(number).normal(size=(4, 3))  # nonsense, and no bias comes of it
        made = {method: importance_sampling(dataset, target, 0.9, method=method) for method in METHODS}
        made["robust"] = doubly_robust(dataset, target, believed, 0.9)
        made["robust, fitted"] = doubly_robust(
            dataset, target, fitted_q_evaluation(dataset, target, 0.9).Q, 0.9, weighted=True
        )
        for name, estimate in made.items():
            found.setdefault(name, []).append(estimate[:2])
    return {name: np.array(pairs) for name, pairs in found.items()}, exact.start


@pytest.mark.parametrize("seed", [3, 11])
def test_means_are_the_exact_value(seed: int) -> None:
    """Those without bias to four standard errors; the weighted ones, whose bias is of order 1/n, to a little more."""
    found, exact = estimates(seed, 200, 100)
    for name, pairs in found.items():
        values, errors = pairs.T
        slack = 0.05 if "weighted" in name or "fitted" in name else 0.0
        assert abs(values.mean() - exact) < 4 * values.std() / np.sqrt(len(values)) + slack, name
        assert errors.mean() == pytest.approx(values.std(), rel=0.25), name
    spread = {name: pairs[:, 0].std() for name, pairs in found.items()}
    assert spread["robust, fitted"] < spread["per decision"] < spread["ordinary"]


def test_true_values_leave_no_variance_where_there_is_no_chance() -> None:
    """Doubly robust with the exact Q, in a task without chance."""
    model = without_chance()
    target, behaviour = np.random.default_rng(1).dirichlet(np.ones(2), (2, 4))
    Q = policy_evaluation(model, target, 0.9).Q
    found = doubly_robust(collect(model, behaviour, 50, seed=1), target, Q, 0.9)
    assert found.value == pytest.approx(policy_evaluation(model, target, 0.9).start)
    assert found.standard_error == pytest.approx(0.0, abs=1e-9)


def without_chance() -> FiniteModel:
    """From each state to the next, with a reward for each action, to the end."""
    model = random_model(5)
    rewards = np.random.default_rng(5).normal(size=(4, 2, 1))
    rewards[-1] = 0.0
    after = np.minimum(np.arange(4) + 1, 3)
    return model._replace(
        initial=np.eye(4)[0],
        successors=np.repeat(after[:, None, None], 2, axis=1),
        probabilities=np.ones((4, 2, 1)),
        rewards=rewards,
    )


@pytest.mark.parametrize("method", METHODS)
def test_on_its_own_data_a_policy_is_worth_what_it_gathered(method: str) -> None:
    """Then all weights are 1, and every episode counts."""
    model, _, behaviour, dataset = random_data(2)
    found = importance_sampling(dataset, behaviour, 0.9, method=method)
    assert found.value == pytest.approx(dataset.returns(0.9).mean())
    assert found.effective_episodes == pytest.approx(dataset.n_episodes)
    assert len(model.states) == dataset.n_states


@pytest.mark.parametrize(
    ("call", "names"),
    [
        (lambda data: importance_sampling(data, TARGET, method="best"), ("method", "ordinary", "weighted", "best")),
        (lambda data: importance_sampling(data, TARGET[:2]), ("policy", "(3, 2)")),
        (lambda data: importance_sampling(data, [0, 1, 2]), ("policy", 0, 1, 2)),
        (lambda data: importance_sampling(data.states, TARGET), ("dataset", "Dataset", "collect")),
        (lambda data: importance_sampling(data, TARGET, 1.5), ("discount", 0, 1, 1.5)),
        (lambda data: importance_sampling(NEVER, [1, 1, 1], method="weighted"), ("dataset", "policy", "each of 3")),
        (
            lambda data: doubly_robust(NEVER, [1, 1, 1], np.zeros((3, 2)), weighted=True),
            ("dataset", "policy", "each of 3"),
        ),
        (lambda data: doubly_robust(data, TARGET, [1.0]), ("Q", "(3, 2)")),
        (lambda data: doubly_robust(data, TARGET, np.full((3, 2), np.inf)), ("Q", "finite")),
        (
            lambda data: doubly_robust(data, TARGET, np.zeros((3, 2)), weighted=data.n_states),
            ("weighted", True, False, 3),
        ),
    ],
)
def test_bad_arguments_are_named(call: Any, names: tuple[Any, ...]) -> None:
    """The message names the parameter, what is allowed and what was given."""
    with pytest.raises(ValueError, match=named(*names)):
        call(by_hand())

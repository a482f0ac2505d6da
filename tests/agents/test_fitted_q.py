"""Fitted Q, with and without pessimism: by hand, against planning on what the data show, and against the truth."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import (
    Dataset,
    FiniteModel,
    collect,
    fitted_q_evaluation,
    fitted_q_iteration,
    pessimistic_q_iteration,
    policy_evaluation,
    value_iteration,
)
from edugym.mdp.protocol import Reals
from tests.agents.offline import by_hand, going_on, random_data
from tests.exact.tasks import random_model, value_of
from tests.messages import named


def test_by_hand() -> None:
    """At γ = 1/2: Q(1, 0) = 4 and Q(0, 1) = ((2 + V(1) / 2) + 0) / 2; the cut-off step goes on: Q(0, 0) = 8 + V(1) / 2.

    V(1) = max(4, unseen).
    """
    found = fitted_q_iteration(by_hand(), 0.5, unseen=6.0)
    assert found.Q.tolist() == [[8 + 3, (2 + 3 + 0) / 2], [4, 6], [6, 6]]
    assert found.V.tolist() == [11, 6, 6]
    assert found.start == 11
    assert found.greedy_policy().tolist() == [[1, 0], [0, 1], [0.5, 0.5]]
    assert fitted_q_iteration(by_hand(), 0.5).Q.tolist() == [[10, 2], [4, 0], [0, 0]]
    assert fitted_q_iteration(by_hand(), 0.5, horizon=1).Q.tolist() == [[8, 1], [4, 0], [0, 0]]


def test_a_policy_by_hand() -> None:
    """V(1) = 1/4 · 4 + 3/4 · 2."""
    policy = [[1.0, 0.0], [0.25, 0.75], [0.5, 0.5]]
    found = fitted_q_evaluation(by_hand(), policy, 0.5, unseen=2.0)
    assert found.Q.tolist() == [[8 + 1.25, (2 + 1.25) / 2], [4, 2], [2, 2]]
    assert found.V.tolist() == [9.25, 2.5, 2]


def test_pessimism_by_hand() -> None:
    """One step costs the penalty, two steps the penalty over √2; what is unseen is the lowest, and nothing is below."""
    found = pessimistic_q_iteration(by_hand(), 2.0, -1.0, 0.5)
    assert found.Q.ravel().tolist() == pytest.approx([8 + 1 - 2, (2 + 1) / 2 - 2 / np.sqrt(2), 2, -1, -1, -1])
    assert pessimistic_q_iteration(by_hand(), 1e6, -1.0, 0.5).V.tolist() == [-1, -1, -1]
    plain = pessimistic_q_iteration(by_hand(), 0.0, -9.0, 0.5)
    assert plain.Q.tolist() == fitted_q_iteration(by_hand(), 0.5, unseen=-9.0).Q.tolist()


def shown_by(dataset: Dataset, unseen: float) -> FiniteModel:
    """The task as the data show it: frequencies for probabilities; what is unseen pays that, and ends.

    Rows are those of the dataset, and one more for the end.
    """
    n, m = dataset.n_states, dataset.n_actions
    p, r = np.zeros((n + 1, m, n + 1)), np.zeros((n + 1, m, n + 1))
    p[:, :, n] = 1.0
    r[:n, :, n] = unseen
    for s, a in np.argwhere(dataset.visits > 0):
        here = (dataset.states == s) & (dataset.actions == a)
        after = np.where(dataset.terminated[here], n, dataset.next_states[here])
        p[s, a] = np.bincount(after, minlength=n + 1) / here.sum()
        sums = np.bincount(after, dataset.rewards[here], n + 1)
        r[s, a] = np.divide(sums, np.bincount(after, minlength=n + 1), out=np.zeros(n + 1), where=p[s, a] > 0)
    states = tuple(range(n + 1))
    ways = np.broadcast_to(np.arange(n + 1), p.shape).copy()
    first = np.append(np.bincount(dataset.states[dataset.starts], minlength=n) / dataset.n_episodes, 0.0)
    return FiniteModel(states, dict(enumerate(states)), first, np.arange(n + 1) == n, ways, p, r)


def pessimist(dataset: Dataset, discount: float) -> Reals:
    """Sweeps over the same model, less 0.7 / √n, and never below -4."""
    model, n = shown_by(dataset, -4.0), dataset.n_states
    less, Q = 0.7 / np.sqrt(np.maximum(dataset.visits, 1)), np.zeros((n + 1, dataset.n_actions))
    for _ in range(1_000):
        means = (model.probabilities * (model.rewards + discount * Q.max(axis=1))).sum(axis=2)
        Q[:n] = np.where(dataset.visits > 0, np.maximum(means[:n] - less, -4.0), -4.0)
    return Q[:n]


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 10**6), st.sampled_from([0.5, 0.9]), st.integers(1, 20), st.sampled_from([-3.0, 0.0, 5.0]))
def test_agrees_with_planning_on_what_the_data_show(seed: int, discount: float, n: int, unseen: float) -> None:
    """To 1e-12: value iteration, a pessimist's too, and the linear equations of a policy, on a model of frequencies."""
    _, target, _, dataset = random_data(seed, n)
    model = shown_by(dataset, unseen)
    found = fitted_q_iteration(dataset, discount, unseen=unseen, tolerance=1e-14)
    planned = value_iteration(model, discount, tolerance=1e-14)
    assert found.Q.ravel().tolist() == pytest.approx(planned.Q[:-1].ravel().tolist(), rel=1e-12, abs=1e-12)
    assert found.start == pytest.approx(planned.start, rel=1e-12, abs=1e-12)
    feared = pessimistic_q_iteration(dataset, 0.7, -4.0, discount, tolerance=1e-14)
    assert feared.Q.ravel().tolist() == pytest.approx(
        pessimist(dataset, discount).ravel().tolist(), rel=1e-12, abs=1e-12
    )
    evaluated = fitted_q_evaluation(dataset, target, discount, unseen=unseen, tolerance=1e-14)
    solved = value_of(model, np.vstack([target, np.full(3, 1 / 3)]), discount)
    assert evaluated.V.tolist() == pytest.approx(solved[:-1].tolist(), rel=1e-12, abs=1e-12)


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 10**6), st.floats(0, 5), st.floats(0, 5))
def test_more_penalty_never_raises_a_value(seed: int, one: float, other: float) -> None:
    """And no value is below the lowest."""
    _, _, _, dataset = random_data(seed)
    few, many = (pessimistic_q_iteration(dataset, penalty, -9.0, 0.9) for penalty in sorted((one, other)))
    assert (many.Q <= few.Q + 1e-9).all()
    assert many.Q.min() >= -9


@pytest.mark.parametrize("seed", [0, 5])
def test_with_many_data_the_optimum_comes_out(seed: int) -> None:
    """And with the penalty too, which goes away with the square root."""
    model = going_on(random_model(seed, n_actions=3))
    dataset = collect(model, np.full((4, 3), 1 / 3), 30_000, seed=seed)
    optimum = value_iteration(model, 0.9)
    assert np.abs(fitted_q_iteration(dataset, 0.9).Q - optimum.Q)[:3].max() < 0.15
    assert np.abs(pessimistic_q_iteration(dataset, 1.0, -20.0, 0.9).Q - optimum.Q)[:3].max() < 0.3
    policy = fitted_q_iteration(dataset, 0.9).greedy_policy()
    assert fitted_q_evaluation(dataset, policy, 0.9).start == pytest.approx(
        policy_evaluation(model, policy, 0.9).start, abs=0.1
    )


def test_a_circle_that_pays_never_settles() -> None:
    """At discount 1; with a horizon it pays so often."""
    circle = Dataset.create([0], [0], [2.0], [0], [False], [True], [1.0], 1, 1)
    with pytest.raises(ValueError, match=named("values", 50, "discount", 1.0, "horizon")):
        fitted_q_iteration(circle, max_sweeps=50)
    assert fitted_q_iteration(circle, horizon=7).V.tolist() == [14]
    assert fitted_q_iteration(circle, 0.5).start == pytest.approx(4)


@pytest.mark.parametrize(
    ("call", "names"),
    [
        (lambda data: fitted_q_iteration(data.n_states), ("dataset", "Dataset", 3)),
        (lambda data: fitted_q_iteration(data, -1), ("discount", 0, 1, -1)),
        (lambda data: fitted_q_iteration(data, unseen=np.inf), ("unseen", "finite", "inf")),
        (lambda data: fitted_q_iteration(data, horizon=0), ("horizon", 1, 0)),
        (lambda data: fitted_q_iteration(data, tolerance=0), ("tolerance", 0, 0)),
        (lambda data: fitted_q_evaluation(data, [0, 0]), ("policy", "(3, 2)")),
        (lambda data: fitted_q_evaluation(data.n_states, [0, 0]), ("dataset", "Dataset", 3)),
        (lambda data: pessimistic_q_iteration(data, -1, 0), ("penalty", 0, -1)),
        (lambda data: pessimistic_q_iteration(data, np.inf, 0), ("penalty", "finite", "inf")),
        (lambda data: pessimistic_q_iteration(data, 1, -np.inf), ("lowest", "finite", "-inf")),
    ],
)
def test_bad_arguments_are_named(call: Any, names: tuple[Any, ...]) -> None:
    """The message names the parameter, what is allowed and what was given."""
    with pytest.raises(ValueError, match=named(*names)):
        call(by_hand())

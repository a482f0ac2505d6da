"""Fitted Q, with and without pessimism, by hand."""

from typing import Any

import numpy as np
import pytest

from edugym import (
    Dataset,
    fitted_q_evaluation,
    fitted_q_iteration,
    pessimistic_q_iteration,
)
from tests.agents.offline import by_hand
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

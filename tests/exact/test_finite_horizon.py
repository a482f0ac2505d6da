"""Backwards from the last step: values and actions that depend on the steps that are left."""

from typing import Any

import numpy as np
import pytest

from edugym import finite_model, value_iteration
from edugym.exact.finite_horizon import finite_horizon
from tests.exact.tasks import Loop, Walk, random_model


@pytest.mark.parametrize("epsilon", [0.0, 0.3])
@pytest.mark.parametrize("discount", [0.9, 1.0])
def test_each_number_of_steps_left(epsilon: float, discount: float) -> None:
    """Entry k is what value iteration says of a horizon of k, bit for bit, and each follows from the one before."""
    model = random_model(5)
    plan = finite_horizon(model, 6, discount, epsilon=epsilon)
    assert len(plan) == 7
    assert not plan[0].V.any()
    assert plan[0].start == 0.0
    for k in range(1, 7):
        same = value_iteration(model, discount, epsilon=epsilon, horizon=k)
        assert np.array_equal(plan[k].V, same.V)
        assert np.array_equal(plan[k].Q, same.Q)
        assert plan[k].start == same.start
        after = np.einsum("san,n->sa", model.p, plan[k - 1].V)
        assert pytest.approx(model.r + discount * after) == plan[k].Q


def test_the_last_step_is_another_one() -> None:
    """In Loop the end pays nothing, so that staying is best while a step is left; with none left nothing matters."""
    plan = finite_horizon(finite_model(Loop()), 3)
    assert [values.start for values in plan] == [0.0, 1.0, 2.0, 3.0]
    assert [values.greedy_policy()[0].tolist() for values in plan] == [[0.5, 0.5], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0]]


@pytest.mark.parametrize(
    ("parameter", "value"),
    [("horizon", 0), ("horizon", 2.5), ("horizon", None), ("discount", 1.5), ("epsilon", -0.1)],
)
def test_bad_parameters_are_refused(parameter: str, value: Any) -> None:
    """By name and value."""
    with pytest.raises(ValueError, match=f"{parameter} must be .*, but is {value!r}"):
        finite_horizon(finite_model(Walk()), **{"horizon": 3, parameter: value})

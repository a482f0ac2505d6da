"""Policy iteration finds what value iteration finds."""

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import finite_model, make_mdp, value_iteration
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.policy_iteration import policy_iteration
from tests.exact.tasks import Loop, random_model


@settings(max_examples=40)
@given(st.integers(0, 10**6), st.sampled_from([0.0, 0.5, 0.95, 1.0]))
def test_it_agrees_with_value_iteration_on_random_models(seed: int, discount: float) -> None:
    """The same V and Q, and the greedy policy has these values."""
    model = random_model(seed, n_states=6, n_actions=3)
    found, other = policy_iteration(model, discount), value_iteration(model, discount)
    assert pytest.approx(other.V, abs=1e-6) == found.V
    assert pytest.approx(other.Q, abs=1e-6) == found.Q
    assert policy_evaluation(model, found.greedy_policy(), discount).start == pytest.approx(found.start, abs=1e-6)


@pytest.mark.parametrize("name", ["Boulder", "Roadrunner", "Study", "Supermarket"])
def test_it_agrees_with_value_iteration_on_the_tasks_of_the_course(name: str) -> None:
    """With and without a discount."""
    model = finite_model(make_mdp(name))
    for discount in (0.9, 1.0):
        assert pytest.approx(value_iteration(model, discount).V, abs=1e-6) == policy_iteration(model, discount).V


def test_too_few_improvements_and_no_end() -> None:
    """One policy is not enough; and a reward for ever has no value at discount 1."""
    with pytest.raises(ValueError, match="the policy does not settle in 1 improvements"):
        policy_iteration(finite_model(make_mdp("Boulder")), max_iterations=1)
    with pytest.raises(ValueError, match=r"values do not settle in 90 sweeps at discount 1\.0"):
        policy_iteration(finite_model(Loop()), max_sweeps=90)
    with pytest.raises(ValueError, match="max_iterations must be 1 or more, but is 0"):
        policy_iteration(finite_model(Loop()), max_iterations=0)
    with pytest.raises(ValueError, match="discount must be from 0 to 1, but is 2"):
        policy_iteration(finite_model(Loop()), 2)
    task: Any = Loop()
    with pytest.raises(ValueError, match="model must be a FiniteModel"):
        policy_iteration(task)

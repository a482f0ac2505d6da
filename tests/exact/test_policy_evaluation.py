"""The values of a policy against linear algebra and closed forms, and policy iteration against value iteration."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import QLearning, finite_model, make_mdp, value_iteration
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.policy_iteration import policy_iteration
from tests.exact.tasks import LOOP, Walk, random_model, value_of
from tests.messages import named

DISCOUNTS = st.sampled_from([0.0, 0.5, 0.95, 1.0])


@settings(max_examples=50)
@given(st.integers(0, 10**6), DISCOUNTS)
def test_the_values_solve_the_linear_equations(seed: int, discount: float) -> None:
    """V = r + γ P V, for policies that mix actions, and for those that do not."""
    model = random_model(seed, n_actions=3)
    rng = np.random.default_rng(seed)
    policy = rng.dirichlet(np.ones(3), 4)
    found = policy_evaluation(model, policy, discount, tolerance=1e-13)
    assert pytest.approx(value_of(model, policy, discount), abs=1e-9) == found.V
    assert found.V[:-1] == pytest.approx((policy * found.Q).sum(axis=1)[:-1])
    assert found.start == pytest.approx(float(model.initial @ found.V))
    actions = rng.integers(3, size=4)
    found = policy_evaluation(model, actions, discount, tolerance=1e-13)
    assert pytest.approx(value_of(model, np.eye(3)[actions], discount), abs=1e-9) == found.V


def test_a_policy_that_never_ends() -> None:
    """At discount 1 it gathers reward without limit; with a discount or a horizon it has a value."""
    model = finite_model(LOOP)
    staying = np.ones(len(model.states), int)
    with pytest.raises(ValueError, match=r"values do not settle in 60 sweeps at discount 1\.0: give a horizon"):
        policy_evaluation(model, staying, max_sweeps=60)
    assert policy_evaluation(model, staying, 0.9).start == pytest.approx(10.0)
    assert policy_evaluation(model, staying, horizon=7).start == 7.0
    assert policy_evaluation(model, np.full((len(model.states), 2), 0.5)).start == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("policy", "message"),
    [
        (np.zeros(8, int), r"a whole number for each of the 7 rows of the model.*policy_of\(agent, model\)"),
        (np.zeros(7), "a whole number for each of the 7 rows"),
        (["left"] * 7, "a whole number for each of the 7 rows"),
        (None, "a whole number for each of the 7 rows"),
        (QLearning.create((7, 1)), r"be an array, but is the agent QLearning: policy_of\(agent, model\)"),
        (np.full((7, 2), 0.5), r"shape \(7, 1\), but is array.*, of shape \(7, 2\)"),
        (np.ones(7, int), "actions from 0 to 0, but holds 1"),
        (np.full(7, -1), "actions from 0 to 0, but holds -1"),
        (np.full((7, 1), 0.9), r"sum to 1 in every row, but row 0 is \[0\.9\]"),
        (np.full((7, 1), np.nan), r"sum to 1 in every row, but row 0 is \[nan\]"),
    ],
)
def test_bad_policies(policy: Any, message: str) -> None:
    """The message says what the shape must be, and that rows are not observations."""
    with pytest.raises(ValueError, match=f"policy must .*{message}"):
        policy_evaluation(finite_model(Walk()), policy)
    with pytest.raises(ValueError, match=r"policy must hold probabilities .* row 2 is \[ 1\.5 -0\.5\]"):
        policy_evaluation(random_model(0), [[0.5, 0.5], [1, 0], [1.5, -0.5], [0, 1]])  # of which the sum is 1


def test_what_is_no_model() -> None:
    """The message says how to make one."""
    for ask in (lambda task: policy_evaluation(task, [0]), policy_iteration, value_iteration):
        with pytest.raises(ValueError, match=r"model must be a FiniteModel, as finite_model\(mdp\) makes it, but is"):
            ask(Walk())


@settings(max_examples=40)
@given(st.integers(0, 10**6), DISCOUNTS)
def test_policy_iteration_agrees_with_value_iteration(seed: int, discount: float) -> None:
    """The same V and Q, and the greedy policy has these values."""
    model = random_model(seed, n_states=6, n_actions=3)
    found, other = policy_iteration(model, discount), value_iteration(model, discount)
    assert pytest.approx(other.V, abs=1e-6) == found.V
    assert pytest.approx(other.Q, abs=1e-6) == found.Q
    assert policy_evaluation(model, found.greedy_policy(), discount).start == pytest.approx(found.start, abs=1e-6)


def test_policy_iteration_that_does_not_settle() -> None:
    """One policy is not enough; and a reward for ever has no value at discount 1."""
    model = finite_model(LOOP)
    with pytest.raises(ValueError, match="the policy does not settle in 1 improvements"):
        policy_iteration(finite_model(make_mdp("Boulder")), max_iterations=1)
    with pytest.raises(ValueError, match=r"values do not settle in 90 sweeps at discount 1\.0"):
        policy_iteration(model, max_sweeps=90)
    with pytest.raises(ValueError, match=named("max_iterations", 1, 10_000_000, 0)):
        policy_iteration(model, max_iterations=0)
    with pytest.raises(ValueError, match=named("discount", 0, 1, 2)):
        policy_iteration(model, 2)

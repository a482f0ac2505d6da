"""The values of a policy against linear algebra, closed forms and real episodes."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import finite_model, value_iteration
from edugym.exact.policy_evaluation import policy_evaluation
from tests.compiled.cells import SLIPPERY, cell
from tests.exact.tasks import Loop, Walk, random_model, value_of


@settings(max_examples=50)
@given(st.integers(0, 10**6), st.sampled_from([0.0, 0.5, 0.95, 1.0]))
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


@pytest.mark.parametrize("slipping", [0.1, 0.3, 0.45, 0.5, 0.7])
def test_the_ruin_of_the_gambler(slipping: float) -> None:
    """From capital k of N the chance to win is (1 - (q/p)^k) / (1 - (q/p)^N), or k/N in a fair game."""
    n = 9
    source = SLIPPERY.replace("return state == self.size", "return state in (0, self.size)").replace("-0.25", "0.0")
    model = finite_model(cell(source.replace("return 0\n", "return 4\n", 1))["SlipperyWalk"](n, slipping))
    found = policy_evaluation(model, np.ones(n + 1, int))
    ratio = slipping / (1 - slipping)
    for k in range(1, n):
        won = k / n if slipping == 0.5 else (1 - ratio**k) / (1 - ratio**n)
        assert found.value(k) == pytest.approx(won, abs=1e-8)
    assert found.start == found.value(4)
    assert found.value(0) == found.value(n) == 0.0


def test_a_policy_that_never_ends() -> None:
    """At discount 1 it gathers reward without limit; with a discount or a horizon it has a value."""
    model = finite_model(Loop())
    staying = np.ones(len(model.states), int)
    with pytest.raises(ValueError, match=r"values do not settle in 60 sweeps at discount 1\.0: give a horizon"):
        policy_evaluation(model, staying, max_sweeps=60)
    assert policy_evaluation(model, staying, 0.9).start == pytest.approx(10.0)
    assert policy_evaluation(model, staying, horizon=7).start == 7.0
    half = np.full((len(model.states), 2), 0.5)
    assert policy_evaluation(model, half).start == pytest.approx(1.0)


BAD: dict[str, tuple[Any, str]] = {
    "another number of states": (
        np.zeros(8, int),
        r"\(S|for each of the 7 rows of the model.*policy_of\(agent, model\)",
    ),
    "real numbers for actions": (np.zeros(7), "a whole number for each of the 7 rows"),
    "text": (["left"] * 7, "a whole number for each of the 7 rows"),
    "nothing": (None, "a whole number for each of the 7 rows"),
    "more actions": (np.full((7, 2), 0.5), r"shape \(7, 1\), but is an array of shape \(7, 2\)"),
    "an action that is not there": (np.ones(7, int), "actions from 0 to 0, but holds 1"),
    "a negative action": (np.full(7, -1), "actions from 0 to 0, but holds -1"),
    "a sum that is not 1": (np.full((7, 1), 0.9), r"sum to 1 in every row, but row 0 is \[0\.9\]"),
    "no numbers": (np.full((7, 1), np.nan), r"sum to 1 in every row, but row 0 is \[nan\]"),
}


@pytest.mark.parametrize(("policy", "message"), BAD.values(), ids=BAD)
def test_bad_policies_are_refused(policy: Any, message: str) -> None:
    """The message says what the shape must be, and that rows are not observations."""
    with pytest.raises(ValueError, match=f"policy must .*{message}"):
        policy_evaluation(finite_model(Walk()), policy)


def test_negative_probabilities_are_refused() -> None:
    """Also where the sum is 1."""
    with pytest.raises(ValueError, match=r"policy must hold probabilities .* row 2 is \[ 1\.5 -0\.5\]"):
        policy_evaluation(random_model(0), [[0.5, 0.5], [1, 0], [1.5, -0.5], [0, 1]])


@pytest.mark.parametrize("model", [Walk(), None, "Boulder"])
def test_what_is_no_model_is_refused(model: Any) -> None:
    """The message says how to make one."""
    message = r"model must be a FiniteModel, as finite_model\(mdp\) makes it, but is"
    with pytest.raises(ValueError, match=message):
        policy_evaluation(model, [0])
    with pytest.raises(ValueError, match=message):
        value_iteration(model)

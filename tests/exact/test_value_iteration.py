"""Value iteration and planning backwards from the last step, against closed forms, brute force and linear algebra."""

import itertools
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import FiniteModel, finite_model, value_iteration
from edugym.exact.finite_horizon import finite_horizon
from edugym.mdp.protocol import Reals
from tests.exact.tasks import GAMBLER, LOOP, Walk, random_model, value_of
from tests.messages import named


def test_the_gambler_plays_boldly() -> None:
    """At p = 0.4 staking all is optimal: V(50) = p, V(25) = p², V(75) = p + (1 - p) p (figure 4.3)."""
    found = value_iteration(finite_model(GAMBLER))
    for capital, value in ((50, 0.4), (25, 0.16), (75, 0.64), (0, 0.0), (100, 0.0)):
        assert found.value(capital) == pytest.approx(value)


def expected_return(model: FiniteModel, state: int, steps: int, discount: float, epsilon: float) -> float:
    """The best that can be had in so many steps, by trying everything."""
    if steps == 0:
        return 0.0
    values = []
    for action in range(model.p.shape[1]):
        ways = zip(model.probabilities[state, action], model.successors[state, action], strict=True)
        after = [p * expected_return(model, n, steps - 1, discount, epsilon) for p, n in ways]
        values.append(float(model.r[state, action]) + discount * float(sum(after)))
    return (1 - epsilon) * max(values) + epsilon * sum(values) / len(values)


@pytest.mark.parametrize("discount", [0.9, 1.0])
@pytest.mark.parametrize("epsilon", [0.0, 0.3])
def test_a_horizon_is_looking_ahead_so_many_steps(epsilon: float, discount: float) -> None:
    """Against brute force; entry k of a finite horizon is value iteration with horizon k, bit for bit."""
    model = random_model(3, n_states=3)
    plan = finite_horizon(model, 4, discount, epsilon=epsilon)
    assert len(plan) == 5
    assert plan[0].start == 0.0
    assert not plan[0].V.any()
    for k in range(1, 5):
        found = value_iteration(model, discount, epsilon=epsilon, horizon=k)
        by_force = [expected_return(model, state, k, discount, epsilon) for state in range(3)]
        assert pytest.approx(by_force) == found.V
        assert pytest.approx(model.r + discount * np.einsum("san,n->sa", model.p, plan[k - 1].V)) == found.Q
        assert found.start == pytest.approx(float(model.initial @ by_force))
        assert np.array_equal(plan[k].V, found.V)
        assert np.array_equal(plan[k].Q, found.Q)
        assert plan[k].start == found.start


def test_a_reward_for_ever() -> None:
    """Without a discount it does not settle; with a horizon, staying is best while a step is left."""
    model = finite_model(LOOP)
    with pytest.raises(ValueError, match=r"values do not settle in 50 sweeps at discount 1\.0: give a horizon"):
        value_iteration(model, max_sweeps=50)
    assert value_iteration(model, horizon=7).start == 7.0
    assert value_iteration(model, 0.5, horizon=3).start == 1.75
    policies = [values.greedy_policy()[0].tolist() for values in finite_horizon(model, 2)]
    assert policies == [[0.5, 0.5], [0.0, 1.0], [0.0, 1.0]]


def policies(model: FiniteModel, epsilon: float) -> list[Reals]:
    """Every deterministic policy, taking a random action with probability ε."""
    n_states, n_actions, _ = model.successors.shape
    chosen = itertools.product(np.eye(n_actions), repeat=n_states)
    return [(1 - epsilon) * np.array(rows) + epsilon / n_actions for rows in chosen]


@settings(max_examples=30)
@given(st.integers(0, 10**6), st.sampled_from([0.0, 0.2, 1.0]), st.sampled_from([0.0, 0.5, 0.95, 1.0]))
def test_no_policy_is_better(seed: int, epsilon: float, discount: float) -> None:
    """Of all 16 policies, each exploring with probability ε, the best in every state has these values."""
    model = random_model(seed)
    found = value_iteration(model, discount, epsilon=epsilon, tolerance=1e-13)
    values = np.array([value_of(model, policy, discount) for policy in policies(model, epsilon)])
    assert pytest.approx(values.max(axis=0), abs=1e-8) == found.V
    greedy = np.eye(2)[found.Q.argmax(axis=1)] * (1 - epsilon) + epsilon / 2
    assert value_of(model, greedy, discount) == pytest.approx(found.V, abs=1e-8)
    assert pytest.approx(found.start, abs=1e-8) == float(model.initial @ found.V)


@pytest.mark.parametrize(
    ("parameter", "value", "allowed"),
    [
        ("discount", -0.1, (0, 1)), ("discount", 1.1, (0, 1)), ("discount", float("nan"), (0, 1)),
        ("epsilon", 2, (0, 1)), ("epsilon", "0", ("number",)), ("horizon", 0, (1, 10_000_000)),
        ("horizon", 2.0, ("whole number",)), ("tolerance", 0, (0,)),
        ("tolerance", float("inf"), ("finite",)), ("max_sweeps", 0, (1, 10_000_000)),
    ],
)  # fmt: skip
def test_bad_parameters(parameter: str, value: Any, allowed: tuple[Any, ...]) -> None:
    """The message names the parameter, its value and what is allowed."""
    model, message = finite_model(Walk()), named(parameter, *allowed, repr(value))
    with pytest.raises(ValueError, match=message):
        value_iteration(model, **{parameter: value})
    if parameter in ("discount", "epsilon", "horizon"):
        with pytest.raises(ValueError, match=message):
            finite_horizon(model, **{"horizon": 3, parameter: value})

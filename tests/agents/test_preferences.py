"""Rewards from preferences: by hand, against an optimiser of SciPy, and with bad arguments."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq, minimize

from edugym import fit_rewards, preference
from tests.messages import named

PAIR = np.array([[[1.0, 0.0]]]), np.array([[[0.0, 1.0]]])
"""One comparison, of one step with action 0 and one step with action 1."""


def test_preferences_by_hand() -> None:
    """A difference of τ ln 3 is preferred three times of four; far ones are sure, and nothing overflows."""
    assert preference(2 * np.log(3), 0.0, noise=2.0) == pytest.approx(0.75)
    assert preference(1.0, 1.0) == 0.5
    assert preference([1e6, -1e6], [0.0, 0.0], 1e-3).tolist() == [1.0, 0.0]


@pytest.mark.parametrize("prior", [0.1, 3.0])
def test_one_comparison_by_hand(prior: float) -> None:
    """By symmetry the rewards are x and -x, and the gradient is 0 where 1 / (1 + exp(2 x)) = prior · x."""
    x = brentq(lambda x: 1 / (1 + np.exp(2 * x)) - prior * x, 0, 10, xtol=1e-15, rtol=1e-15)
    assert fit_rewards(*PAIR, [True], prior=prior).tolist() == [pytest.approx([x, -x], rel=1e-12)]
    assert fit_rewards(*PAIR, [False], prior=prior).tolist() == [pytest.approx([-x, x], rel=1e-12)]


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.integers(1, 30), st.sampled_from([0.01, 0.1, 1.0]), st.booleans())
def test_agrees_with_an_optimiser(seed: int, n: int, prior: float, never_errs: bool) -> None:
    """For random visits, also where the teacher never errs and the likelihood alone has no maximum."""
    rng = np.random.default_rng(seed)
    first, second = rng.integers(0, 4, (2, n, 3, 2)).astype(float)
    difference = (first - second).reshape(n, 6)
    meant = rng.normal(size=6)
    wins = difference @ meant > 0 if never_errs else rng.random(n) < 0.5

    def loss(w: Any) -> float:
        signed = np.where(wins[:, None], difference, -difference) @ w
        return float(np.logaddexp(0, -signed).sum() + prior / 2 * w @ w)

    found = fit_rewards(first, second, wins, prior=prior)
    best = minimize(loss, np.zeros(6), method="BFGS", options={"gtol": 1e-9})
    assert found.ravel() == pytest.approx(best.x, abs=1e-4)
    assert loss(found.ravel()) <= best.fun + 1e-9
    # The prior bends the loss everywhere, so the maximum is no farther away than the gradient divided by it.
    w, rows = found.ravel().astype(np.longdouble), np.where(wins[:, None], difference, -difference)
    gradient = (rows / (1 + np.exp(rows @ w))[:, None]).sum(axis=0) - prior * w
    assert np.linalg.norm(gradient.astype(float)) / prior <= 1e-12 * max(1.0, np.abs(found).max())


def test_what_no_comparison_tells_is_zero() -> None:
    """A state that nobody visited, and steps that both pieces took alike."""
    first, second = np.zeros((2, 5, 3, 2))
    first[:, 0, 0] = second[:, 0, 1] = 1.0
    first[:, 1, 0] = second[:, 1, 0] = 7.0
    rewards = fit_rewards(first, second, [True] * 5)
    assert rewards[0, 0] == pytest.approx(-rewards[0, 1])
    assert rewards[0, 0] > 0.5
    assert not rewards[1:].any()


@pytest.mark.parametrize(
    ("call", "names"),
    [
        (lambda: preference(1.0, 0.0, noise=0.0), ("noise", 0, 0.0)),
        (lambda: preference("a", 0.0), ("first_return",)),
        (lambda: fit_rewards(*PAIR, [True], prior=0.0), ("prior", "1e-09", 0.0)),
        (lambda: fit_rewards(*PAIR, [True, False]), ("prefers_first", 1)),
        (lambda: fit_rewards(*PAIR, [0.3]), ("prefers_first", 1, 0.3)),
        (lambda: fit_rewards(*PAIR, None), ("prefers_first", 1, None)),
        (lambda: fit_rewards(PAIR[0], PAIR[1][0], [True]), ("second", "(1, 1, 2)")),
        (lambda: fit_rewards(PAIR[0][0], PAIR[1], [True]), ("first", "n_states", "n_actions")),
        (lambda: fit_rewards(PAIR[0] * np.nan, PAIR[1], [True]), ("first", "finite")),
        (lambda: fit_rewards(np.zeros((1, 5001, 1)), np.zeros((1, 5001, 1)), [True]), ("first", 5000, 5001)),
    ],
)
def test_bad_arguments_are_named(call: Any, names: tuple[Any, ...]) -> None:
    """The message names the parameter, what is allowed and what was given."""
    with pytest.raises(ValueError, match=named(*names)):
        call()

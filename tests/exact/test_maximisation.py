"""Maximisation bias: by hand, by going through all outcomes, by simulation, and with bad arguments."""

from collections.abc import Callable
from itertools import product
from math import nan
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym import expected_choice, expected_maximum, make_mdp, mean_interval
from tests.messages import named


@pytest.mark.parametrize(
    ("payoffs", "n_tries", "n_tables", "maximum"),
    [
        ([[1, -1]], 7, 1, 0),  # one arm: no bias
        ([[1, -1]] * 2, 1, 1, 1 - 2 / 4),  # -1 only if both lose
        ([[1, -1]] * 10, 1, 1, 1 - 2 / 2**10),
        ([[1, -1]] * 2, 2, 1, 0.375),  # means 1, 0, -1 with 1/4, 1/2, 1/4: P(max = 1) = 7/16, P(max = -1) = 1/16
        ([[1, -1]], 1, 3, 2 / 8 - 1),  # the smallest of three: 1 only if all win
        ([[1, -1]] * 2, 1, 2, 2 * (1 - (3 / 4) ** 2) - 1),
        ([[0, 0], [3, 3]], 5, 4, 3),  # no noise: no bias
    ],
)
def test_maximum_by_hand(payoffs: Any, n_tries: int, n_tables: int, maximum: float) -> None:
    """Of fair coins."""
    assert expected_maximum(payoffs, n_tries, n_tables=n_tables) == pytest.approx(maximum, abs=1e-12)


@pytest.mark.parametrize(
    ("payoffs", "n_tries", "choice"),
    [
        ([[1, -1]] * 5, 3, 0),  # arms that are equal: no bias, whoever is chosen
        ([[0.5, 0.5], [1, -1]], 1, 0.25),  # the coin looks best every second time
        ([[2, 0], [2, -2]], 1, 0.5 * 0.25 + 0.5),  # 1 and 0; equals with 1/4, and then drawn; the second never alone
        ([[0, 0], [3, 3]], 5, 3),
    ],
)
def test_choice_by_hand(payoffs: Any, n_tries: int, choice: float) -> None:
    """Of fair coins."""
    assert expected_choice(payoffs, n_tries) == pytest.approx(choice, abs=1e-12)


def by_all_outcomes(payoffs: Any, n_tries: int, probabilities: Any, n_tables: int) -> tuple[float, float]:
    """Both, by going through everything that can be paid in all tables."""
    k, m = payoffs.shape
    maximum = choice = 0.0
    for drawn in product(range(m), repeat=k * n_tries * n_tables):
        paid = np.array(drawn).reshape(k, n_tables, n_tries)
        chance = float(np.prod(np.take_along_axis(probabilities, paid.reshape(k, -1), axis=1)))
        means = np.take_along_axis(payoffs, paid.reshape(k, -1), axis=1).reshape(paid.shape).mean(axis=2).min(axis=1)
        best = np.isclose(means, means.max(), rtol=0, atol=1e-9)
        maximum += chance * means.max()
        choice += chance * (payoffs * probabilities).sum(axis=1)[best].mean()
    return maximum, choice


SIZES = ((1, 2, 2, 1), (2, 2, 2, 1), (2, 2, 2, 2), (3, 2, 2, 1), (2, 3, 2, 1), (4, 2, 1, 2), (2, 2, 3, 1))


@settings(max_examples=15, deadline=None)
@given(st.sampled_from(SIZES), st.integers(0, 10**6), st.booleans())
def test_agrees_with_all_outcomes(size: tuple[int, int, int, int], seed: int, whole: bool) -> None:
    """To 1e-12, for random payoffs: whole numbers, of which many are equal, and real ones."""
    k, m, n_tries, n_tables = size
    rng = np.random.default_rng(seed)
    payoffs = rng.integers(-2, 3, (k, m)).astype(float) if whole else rng.normal(size=(k, m))
    probabilities = rng.dirichlet(np.ones(m), k)
    maximum, choice = by_all_outcomes(payoffs, n_tries, probabilities, n_tables)
    assert expected_maximum(payoffs, n_tries, probabilities, n_tables) == pytest.approx(maximum, abs=1e-12)
    assert expected_choice(payoffs, n_tries, probabilities, n_tables) == pytest.approx(choice, abs=1e-12)


@pytest.mark.parametrize(("n_tries", "n_tables", "advantage"), [(1, 1, 0.0), (5, 1, 0.0), (5, 4, 0.3), (40, 2, 0.3)])
def test_agrees_with_simulation(n_tries: int, n_tables: int, advantage: float) -> None:
    """On Casino, within a 99.9 % interval; with twice as many tries it does not agree."""
    payoffs = make_mdp("Casino", advantage=advantage).payoffs
    rng = np.random.default_rng(n_tries + n_tables)
    wins = rng.binomial(n_tries, 0.5, (20_000, n_tables, len(payoffs)))
    estimates = (payoffs[:, 1] + (payoffs[:, 0] - payoffs[:, 1]) * wins / n_tries).min(axis=1)
    maximum = mean_interval(estimates.max(axis=1), confidence=0.999)
    assert maximum.low <= expected_maximum(payoffs, n_tries, n_tables=n_tables) <= maximum.high
    assert not maximum.low <= expected_maximum(payoffs, 2 * n_tries, n_tables=n_tables) <= maximum.high
    looks_best = (estimates + rng.random(estimates.shape) * 1e-9).argmax(axis=1)
    worth = mean_interval(payoffs.mean(axis=1)[looks_best], confidence=0.999)
    exact = expected_choice(payoffs, n_tries, n_tables=n_tables)
    assert worth.low - 1e-12 <= exact <= worth.high + 1e-12


def test_large_ones() -> None:
    """Many tries bring the maximum to the best mean, from above, and the choice from below; a thousand machines fit."""
    payoffs = make_mdp("Casino", n_machines=3, advantage=0.3).payoffs
    assert 0.2 < expected_maximum(payoffs, 300) < 0.201
    assert 0.199 < expected_choice(payoffs, 300) < 0.2
    many = make_mdp("Casino", n_machines=1000).payoffs
    assert 0.5 < expected_maximum(many, 20) < 0.65
    assert expected_choice(many, 20) == pytest.approx(-0.1)


COINS = [[1.0, -1.0]] * 2


@pytest.mark.parametrize("function", [expected_maximum, expected_choice])
@pytest.mark.parametrize(
    ("given", "names"),
    [
        ({"payoffs": [1, -1]}, ["payoffs", "(n_arms, n_payoffs)"]),
        ({"payoffs": np.zeros((0, 2))}, ["payoffs", "finite"]),
        ({"payoffs": [[1, nan]]}, ["payoffs", "finite", "nan"]),
        ({"n_tries": 0}, ["n_tries", "1", "10000", "0"]),
        ({"probabilities": [0.5, 0.5]}, ["probabilities", "(2, 2)"]),
        ({"probabilities": [[0.5, 0.6]] * 2}, ["probabilities", "sum to 1", "0.6"]),
        ({"probabilities": [[1.5, -0.5]] * 2}, ["probabilities", "-0.5"]),
        ({"n_tables": 1.5}, ["n_tables", "whole number", "1.5"]),
        ({"payoffs": np.random.default_rng(0).normal(size=(2, 9)), "n_tries": 100}, ["n_tries", "less", "100"]),
    ],
)
def test_bad_arguments(function: Callable[..., float], given: dict[str, Any], names: list[str]) -> None:
    """Each message names the parameter, what is allowed, and the value."""
    with pytest.raises(ValueError, match=named(*names)):
        function(**{"payoffs": COINS, "n_tries": 2, **given})

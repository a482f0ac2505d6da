"""On- and off-policy learning on Roadrunner: the claims hold with other seeds than those the lesson shows."""

import numpy as np
import pytest

from edugym import make_mdp
from edugym.exact.model import finite_model
from edugym.lessons.on_off_policy import (
    EXPECTED_SARSA,
    Q_LEARNING,
    SARSA_,
    best_soft_return,
    compare,
    online,
    online_lead,
    soft_return_of,
    stopping_places,
    switch,
)


def test_exact_returns() -> None:
    """At ε = 0 the fast run returns -2 and the safe one -3; a soft policy is never better than the best one."""
    model = finite_model(make_mdp("Roadrunner"))
    assert best_soft_return(model, 0.0) == -2.0
    assert soft_return_of(model, 0.0, planned_for=0.1) == -3.0
    for epsilon in (0.01, 0.05, 0.1):
        best = best_soft_return(model, epsilon)
        runs = [soft_return_of(model, epsilon, planned_for) for planned_for in (0.01, 0.1)]
        assert max(runs) <= best + 1e-9
        assert best == pytest.approx(max(runs), abs=0.05)
    assert 0.03 < switch(model) < 0.05


def test_without_exploring_nobody_pays_for_slips() -> None:
    """Negative control of the online lead: at ε = 0 there is none, and both find the optimum or no better."""
    results = compare(epsilon=0.0, n_steps=4_000, repetitions=4, seed=3)
    assert online_lead(results, SARSA_).estimate == pytest.approx(0.0, abs=0.5)
    assert (online(results, Q_LEARNING) <= -2.0).all()


def test_stopping_places() -> None:
    """A trained runner ends within the stop zone or at the edge."""
    results = compare(epsilon=0.2, learning_rate=0.1, parameters={"stop_zone": 2}, n_steps=20_000, repetitions=3)
    for method in (Q_LEARNING, SARSA_, EXPECTED_SARSA):
        assert set(stopping_places(results, method, stop_zone=2)) <= {7, 8, 9}
    assert np.mean(stopping_places(results, Q_LEARNING, stop_zone=2)) >= np.mean(
        stopping_places(results, SARSA_, stop_zone=2)
    )

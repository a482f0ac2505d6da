"""Features, and values that are linear in them, worked out by hand."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym import Identity, TileCoding, make_mdp
from edugym.agents.features import check_features, follow_gradient, linear_value, linear_values


def seen(features: Any, *state: float) -> dict[int, float]:
    """The features that are not 0, by number."""
    features.see(np.array(state))
    n = features.n_active
    return dict(zip(features.active[:n].tolist(), features.values[:n].tolist(), strict=True))


def test_the_observation_itself_and_a_constant() -> None:
    """What is 0 is left out, also what was not in the observation before."""
    features = Identity.create((3, 2))
    assert seen(features, 1.0, 2.0, 3.0) == {0: 1.0, 1: 2.0, 2: 3.0, 3: 1.0}
    assert seen(features, 0.0, -2.5, 0.0) == {1: -2.5, 3: 1.0}
    assert seen(Identity.create((3, 2), constant=0.0), 0.0, 0.0, 4.0) == {2: 4.0}
    assert (features.n_inputs, features.n_features) == (3, 4)


def test_linear_values() -> None:
    """Σ x_i w_ik with w = [[1, 2], [3, 4], [10, 20]] and x = (2, 0, 1): 2·1 + 10 = 12 and 2·2 + 20 = 24.

    Before each an observation is seen that has more numbers, of which nothing must be left.
    """
    features, weights, room = Identity.create((2, 2)), np.array([[1.0, 2], [3, 4], [10, 20]]), np.zeros((1, 2))
    before, state = np.array([7.0, 8.0]), np.array([2.0, 0.0])
    features.see(before)
    linear_values(features, weights, state, room)
    assert room.tolist() == [[12.0, 24.0]]
    features.see(before)
    assert linear_value(features, weights, state, 1) == 24.0
    follow_gradient(features, weights, 1, 0.5)
    assert weights.tolist() == [[1, 3], [3, 4], [10, 20.5]]


def test_features_of_something_else_are_refused() -> None:
    """The message says how many numbers an observation has."""
    catch = make_mdp("Catch")
    check_features(Identity.create(catch), 50)
    with pytest.raises(ValueError, match="features must be of 3 numbers, as an observation has, but are of 50"):
        check_features(Identity.create(catch), 3)
    for wrong in (Identity, TileCoding, None, 8, SimpleNamespace(see=len), SimpleNamespace(n_features=50)):
        with pytest.raises(ValueError, match="features must be a value such as TileCoding"):
            check_features(wrong, 50)

"""Features, tiles, and values that are linear in them, worked out by hand; and what it takes to make them."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import Identity, TileCoding, make_mdp
from edugym.agents.features import check_features
from tests.messages import named


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


def test_features_of_something_else_are_refused() -> None:
    """The message says how many numbers an observation has."""
    catch = make_mdp("Catch")
    check_features(Identity.create(catch), 50)
    with pytest.raises(ValueError, match="features must be of 3 numbers, as an observation has, but are of 50"):
        check_features(Identity.create(catch), 3)
    for wrong in (Identity, TileCoding, None, 8, SimpleNamespace(see=len), SimpleNamespace(n_features=50)):
        with pytest.raises(ValueError, match="features must be a value such as TileCoding"):
            check_features(wrong, 50)


@pytest.mark.parametrize("kind", [Identity, TileCoding])
@pytest.mark.parametrize("state", [np.zeros(2), np.zeros((3, 1, 1))[:1], np.zeros(4)], ids=np.shape)
def test_an_observation_of_another_length_is_refused(kind: Any, state: Any) -> None:
    """In a loop without the wrapper the values would be those of other numbers, and nobody would see it."""
    with pytest.raises(ValueError, match=r"number for each input .*FlattenObservation"):
        kind.create((3, 2)).see(state)


def tiles_of(features: TileCoding, *state: float) -> list[int]:
    """The tiles of a state."""
    features.see(np.array(state))
    return [int(tile) for tile in features.active]


TWO_TILINGS: dict[str, Any] = {"tiles": 4, "tilings": 2}
ONE_OF_THREE: dict[str, Any] = {"tiles": [1, 4, 1], "tilings": 1, "low": [0, -2, 0], "high": [0, 2, 0]}


@pytest.mark.parametrize(
    ("settings", "state", "tiles", "n_features"),
    [
        (TWO_TILINGS, [0.0], [0, 5], 2 * 5),
        (TWO_TILINGS, [0.3], [1, 5 + 1], 2 * 5),  # 1.2 tiles from the start, and displaced by half a tile 1.7
        (TWO_TILINGS, [0.4], [1, 5 + 2], 2 * 5),  # 1.6 and 2.1
        (TWO_TILINGS, [1.0], [4, 5 + 4], 2 * 5),  # 4.0 and 4.5
        # (1.0, 1.5) tiles, displaced by k (1, 3) mod 8, in eighths: the second is 1.5, 1.875, 2.25, 1.625, 2.0, ...
        ({"tiles": [2, 3], "tilings": 8}, [0.5, 0.5], [12 * k + 5 + (k in (2, 4, 5, 7)) for k in range(8)], 8 * 3 * 4),
        (ONE_OF_THREE, [9.0, -1.5, math.inf], [0], 5),
        (ONE_OF_THREE, [9.0, -0.5, math.inf], [1], 5),
        ({"tiles": 9_999, "tilings": 1_000}, [0.0], [10_000 * k for k in range(1_000)], 10_000_000),  # the most
        ({"tilings": 1, "low": [0.0], "high": [0.99e9]}, [0.5e9], [4], 9),  # and the farthest bounds
    ],
)
def test_tiles(settings: dict[str, Any], state: list[float], tiles: list[int], n_features: int) -> None:
    """The tile in each tiling, by the book's displacement with odd numbers."""
    features = TileCoding.create((len(state), 2), **settings)
    assert features.n_features == n_features
    assert tiles_of(features, *state) == tiles


@given(st.lists(st.floats(), min_size=2, max_size=2), st.integers(1, 9), st.integers(1, 9), st.integers(1, 16))
def test_every_state_has_a_tile_in_every_tiling(state: list[float], x: int, y: int, tilings: int) -> None:
    """Also far outside the bounds; no two tilings share a tile, and there is none beyond the last."""
    features = TileCoding.create((2, 2), tiles=[x, y], tilings=tilings)
    each = features.n_features // tilings
    assert [tile // each for tile in tiles_of(features, *state)] == list(range(tilings))


@pytest.mark.parametrize(
    ("n_inputs", "settings", "message"),
    [
        (7, {"tiles": 0}, named("tiles", 1, 10_000_000, 0)),
        (7, {"tiles": [4]}, "tiles must be a whole number, or 7, one for each input, but is .4"),
        (7, {"tiles": [2.5] * 7}, named("tiles", 2.5)),
        (7, {"tilings": 0}, named("tilings", 1, 10_000_000, 0)),
        (7, {"low": [0.0]}, named("low", "(7,)", [0.0])),
        (1, {"low": [0.0], "high": [0.0]}, "low and high must be the bounds .* number 0 is from 0.0 to 0.0"),
        (1, {"low": [0.0], "high": [math.inf]}, r"number 0 is from 0.0 to inf: give low=\[...\] and high=\[...\]"),
        (1, {"low": [0.0], "high": [1e9]}, "less than a billion apart, but number 0 is from 0.0 to 1"),
        (7, {"tiles": 9}, "at most 10,000,000 tiles, but 9 and 8 make 80,000,000: leave numbers out by 1"),
        (1, {"tiles": 10_000, "tilings": 1_000}, "but 10000 and 1000 make 10,001,000"),
    ],
)
def test_what_makes_no_sense_is_refused(n_inputs: int, settings: dict[str, Any], message: str) -> None:
    """The message names the parameter and what is allowed."""
    with pytest.raises(ValueError, match=message):
        TileCoding.create((n_inputs, 2), **settings)

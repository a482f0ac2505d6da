"""Whether a value is in a space, is a number, and is still what it was, whatever form a student gives it."""

import random
from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym.checks.values import GlobalDraws, deep_copy, fits, is_finite_number, kept, same

PIXELS = spaces.Box(0, 255, (2,), np.uint8)
NEGATIVE = spaces.Discrete(3, start=-1)
BOTH = spaces.Tuple((NEGATIVE, PIXELS))
NAMED = spaces.Dict(place=NEGATIVE, picture=PIXELS)


@pytest.mark.parametrize(
    ("space", "inside", "outside"),
    [
        (NEGATIVE, [-1, 1, np.int8(0)], [-2, 2, 0.0, [0], None, "0", True]),
        (
            PIXELS,
            [[0, 255], (7, 7.0), np.array([1, 2])],
            [[0, 256], [-1, 0], [0.5, 1], [7], [[1, 2]], 3, ["a", "b"], [[1], 2]],
        ),
        (spaces.Box(-1.0, 1.0, (1,)), [[0.3], [1], [True]], [0.3, [1.5], [np.nan], [1j], [None]]),
        (spaces.MultiDiscrete([2, 3]), [(1, 2), [0.0, 2.0]], [(2, 0), (0, 0.5), (0,), (-1, 0), (0, np.inf)]),
        (spaces.MultiBinary(2), [(0, 1), [True, False]], [(0, 2), (1,), (10**30, 0)]),
        (BOTH, [(-1, [0, 0]), [1, (0, 0)]], [(2, [0, 0]), (0, [0]), (0,), (0, [0, 0], 0), 0]),
        (spaces.Tuple((spaces.Discrete(9), spaces.Discrete(2))), [(8, True), (0, np.False_)], [(True, 1), (1, None)]),
        (spaces.Tuple((PIXELS, spaces.Discrete(2))), [([0, 9], True)], [(True, 1), ([0, 9], 2)]),
        (NAMED, [{"picture": [0, 0], "place": 0}], [{"place": 0}, {"place": 2, "picture": [0, 0]}, (0, [0, 0])]),
        (spaces.Text(3, charset="ab"), ["aba"], ["abc", 3]),
    ],
    ids=lambda value: type(value).__name__ if isinstance(value, spaces.Space) else "",
)
def test_what_is_in_a_space(space: spaces.Space[Any], inside: list[Any], outside: list[Any]) -> None:
    """Python's numbers, lists and tuples count like arrays; another shape, a fraction or a number beside it do not."""
    assert [value for value in inside if not fits(space, value)] == []
    assert [value for value in outside if fits(space, value)] == []


def test_what_is_a_finite_number() -> None:
    """Python's and NumPy's, booleans and arrays of no dimension."""
    numbers = [0.5, 3, True, np.float32(1), np.int8(2), np.bool_(True), np.array(1.5)]
    others = [np.inf, np.nan, -np.inf, np.array(np.nan), 10**400, 1j, "1", None, np.zeros(1), [1.0]]
    assert all(map(is_finite_number, numbers))
    assert not any(map(is_finite_number, others))


Plain: Any = type("Plain", (), {"__init__": lambda self, x: setattr(self, "x", x)})
"""An ordinary class, without `__eq__`; and another one with the same contents."""
Other = type("Other", (Plain,), {})


@pytest.mark.parametrize(
    ("one", "equal", "different"),
    [
        (np.array([1.0, np.nan]), np.array([1.0, np.nan]), [np.array([1.0, 0.0]), np.array([[1.0, np.nan]]), 1.0]),
        ([1, [2, np.nan]], [1, [2, float("nan")]], [[1, [3, np.nan]], [1], (1, [2, np.nan])]),
        ({"a": np.zeros(2)}, {"a": np.zeros(2)}, [{"a": np.ones(2)}, {"b": np.zeros(2)}, {}]),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}, [{"a": 1, "b": 3}, {"a": 0, "b": 2}, {"a": 1}]),
        (Plain([1]), Plain([1]), [Plain([2]), Other([1]), [1]]),
        (2, 2.0, [3, "2", None, {}, {"a": 2}]),
        (np.nan, float("nan"), [1.0, None, "nan"]),
    ],
)
def test_what_is_the_same(one: Any, equal: Any, different: list[Any]) -> None:
    """NaN is the same as NaN, and contents count."""
    assert same(one, one)
    assert same(one, equal)
    assert same(equal, one)
    assert not any(same(one, other) or same(other, one) for other in different)


def test_global_draws_are_looked_for_in_the_first_calls() -> None:
    """In as many as it says."""
    draws = GlobalDraws("Walk", calls=2)
    with draws.refused("initial"):
        pass
    random.gauss(0, 1)  # it keeps a number, which is all that the next one takes
    with pytest.raises(ValueError, match=r"initial of Walk .*random"), draws.refused("initial"):
        random.gauss(0, 1)
    with draws.refused("initial"):
        random.random()


def test_what_cannot_be_copied() -> None:
    """What it holds is named; a mistake in the copying shows as it is."""
    with pytest.raises(ValueError, match=r"^list .*generator.* but we must$"):
        deep_copy([(k for k in range(2))], "we must")
    mistaken = type("Mistaken", (), {"__deepcopy__": lambda self, memo: "1" + memo})
    with pytest.raises(TypeError, match="concatenate"):
        deep_copy([mistaken()], "we must")


def test_what_is_kept() -> None:
    """A copy of what could be changed, all the way down."""
    state: Any = [np.zeros(2), 1]
    copied = kept(state)
    state[0][0] = 1.0
    assert copied[0].tolist() == [0.0, 0.0]
    number = 10**30
    assert kept(number) is number

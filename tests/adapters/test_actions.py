"""Actions as people give them: what stands for an element of each space, and what does not."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym.adapters.actions import checked_action

WHOLE, SEVERAL = spaces.Discrete(3, start=1), spaces.MultiDiscrete([2, 3])
REAL = spaces.Box(np.array([-1, 0], np.float32), np.array([1, 5], np.float32))


@pytest.mark.parametrize(
    ("space", "action", "taken"),
    [
        (WHOLE, 1, 1),
        (WHOLE, np.int8(3), 3),
        (SEVERAL, [1, 2], np.array([1, 2])),
        (SEVERAL, np.array([0, 0], np.uint8), np.array([0, 0])),
        (REAL, [0, 2], np.array([0, 2], np.float32)),
        (REAL, np.array([-1.5, 5.5]), np.array([-1, 5], np.float32)),
        (REAL, (1.5, -0.5), np.array([1, 0], np.float32)),
        (spaces.Text(3), "abc", "abc"),
    ],
)
def test_what_is_taken(space: spaces.Space[Any], action: Any, taken: Any) -> None:
    """In the type of the space; real numbers are cut off at the bounds; an array is one of its own."""
    found = checked_action(space, action)
    assert type(found) is type(taken)
    np.testing.assert_array_equal(found, taken)
    if isinstance(taken, np.ndarray):
        assert found.dtype == space.dtype
        assert found is not action


@pytest.mark.parametrize(
    ("space", "action"),
    [
        (WHOLE, 0), (WHOLE, 4), (WHOLE, 1.0), (WHOLE, "1"), (WHOLE, None), (WHOLE, 10**30), (WHOLE, [1]),
        (SEVERAL, [2, 0]), (SEVERAL, [0]), (SEVERAL, [0.0, 1.0]), (SEVERAL, [-1, 0]), (SEVERAL, [[0], [1, 2]]),
        (REAL, [np.nan, 0]), (REAL, [0, np.inf]), (REAL, [0]), (REAL, 0.5), (REAL, [[0, 0]]), (REAL, ["a", "b"]),
        (REAL, [True, False]), (spaces.Text(3), "abcd"),
    ],
)  # fmt: skip
def test_what_is_refused(space: spaces.Space[Any], action: Any) -> None:
    """The sentence has the action and the space."""
    with pytest.raises(ValueError, match=r"^action .* is not in the action space (Discrete|Multi|Box|Text)"):
        checked_action(space, action)


class Stumbling(spaces.Discrete):
    """As Gymnasium's own was up to 1.3."""

    def contains(self, x: Any) -> bool:
        """Fail at a huge number."""
        raise OverflowError("Python integer out of bounds")


def test_a_number_that_is_too_large_for_gymnasium_is_refused() -> None:
    """In the same words as every other."""
    with pytest.raises(ValueError, match=r"^action .* is not in the action space Discrete\(3\)"):
        checked_action(Stumbling(3), 10**30)

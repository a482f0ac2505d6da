"""Actions as the users of Gymnasium give them, as an MDP takes them."""

from typing import Any

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import in_short


def checked_action(space: spaces.Space[Any], action: Any, of_whom: str = "") -> Any:
    """An element of an action space, from what stands for one.

    Whole numbers may be Python's or NumPy's, arrays may be lists or of other types. Numbers beyond the bounds of a Box
    are clipped to them, as Gymnasium's own environments do.

    Args:
        space: the action space, of one environment or of several copies.
        action: what the user gave.
        of_whom: " of " and the name of a player, for the message, if there are several.

    Returns:
        An `int` for a Discrete space; an array of its own for a Box or a MultiDiscrete; else the action.

    Raises:
        ValueError: it has another shape, is not finite, or is not in the space.
    """
    if isinstance(space, spaces.Box):
        array = _array(action, "iuf")
        if array is not None and array.shape == space.shape and np.isfinite(array).all():
            return np.clip(array, space.low, space.high).astype(space.dtype)
    elif isinstance(space, spaces.MultiDiscrete):
        array = _array(action, "iu")
        if space.contains(array):
            return array.astype(space.dtype)
    else:
        try:  # Gymnasium up to 1.3 stumbles over huge numbers
            fits = space.contains(action)
        except OverflowError:
            fits = False
        if fits:
            return int(action) if isinstance(space, spaces.Discrete) else action
    raise ValueError(f"action {in_short(action)} is not in the action space{of_whom} {space}")


def _array(action: Any, kinds: str) -> Any:
    """The action as an array of numbers, of one of these kinds; None where it is not."""
    try:
        array = np.asarray(action)
    except (ValueError, OverflowError):
        return None
    return array if array.dtype.kind in kinds else None

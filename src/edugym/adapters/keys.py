"""The actions of an environment by name, and a key for each: for people who play."""

import string
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

QUIT, AGAIN = "q", "r"
"""The keys that end the game and start a new episode, which no action gets."""
KEYS = [*string.digits, *(letter for letter in string.ascii_lowercase if letter not in (QUIT, AGAIN))]
MOST_NAMED = 10_000
"""The actions of an environment with more of them get no names."""


def named_actions(environment: gymnasium.Env[Any, Any]) -> dict[str, Any]:
    """Return the actions to choose from, by name.

    An environment may name them itself. Otherwise whole numbers go by their digits. Where an action consists of several
    numbers, each of them can be set to its lowest and to its highest value, with the others in the middle. More than
    `MOST_NAMED` actions get no names.

    Raises:
        ValueError: the actions are of another kind, and the environment does not name them.
    """
    unwrapped: Any = environment.unwrapped
    space = environment.action_space
    if isinstance(space, spaces.Discrete) and space.n > MOST_NAMED:
        return {}
    offered: dict[str, Any] = unwrapped.named_actions() if hasattr(unwrapped, "named_actions") else {}
    if offered:
        return offered
    if isinstance(space, spaces.Discrete):
        return {str(action): action for action in range(int(space.start), int(space.start + space.n))}
    if isinstance(space, spaces.MultiDiscrete) and len(space.shape) == 1:
        low, high = space.start, space.start + space.nvec - 1
        middle = (low + high) // 2
    elif isinstance(space, spaces.Box) and len(space.shape) == 1 and space.is_bounded():
        low, high = space.low, space.high
        middle = (low + high) / 2
    else:
        raise ValueError(f"the actions of {space} have no names: give the environment a method named_actions")
    actions = {"middle": middle.astype(space.dtype)}
    for k in range(len(middle)):
        for name, end in (("low", low), ("high", high)):
            actions[f"{k} {name}"] = np.where(np.arange(len(middle)) == k, end, middle).astype(space.dtype)
    return actions


def keys_of(names: list[str]) -> dict[str, str]:
    """Give each action a key: its name if all names are single characters, else a digit or a letter.

    Args:
        names: the names of the actions, in order.

    Returns:
        The name of the action for each key.

    Raises:
        ValueError: there are more actions than keys.
    """
    if len(names) > len(KEYS):
        raise ValueError(f"actions must be at most {len(KEYS)} to be played by keys, but are {len(names)}")
    single = all(name in KEYS for name in names)
    return {name if single else key: name for key, name in zip(KEYS, names, strict=False)}

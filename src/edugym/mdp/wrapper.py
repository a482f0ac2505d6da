"""Wrappers of MDPs. A wrapper is an MDP that contains another one, the inner MDP.

Its class defines only the methods that differ; `@wrapper` adds the others, which call those of the inner MDP.
"""

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar

from edugym.checks.parameters import in_short
from edugym.mdp.protocol import Random

Kind = TypeVar("Kind", bound=type)


def _initial(self: Any, rng: Random) -> Any:
    return self.mdp.initial(rng)


def _transition(self: Any, state: Any, action: Any, rng: Random) -> Any:
    return self.mdp.transition(state, action, rng)


def _reward(self: Any, state: Any, action: Any, next_state: Any, rng: Random) -> Any:
    return self.mdp.reward(state, action, next_state, rng)


def _terminal(self: Any, state: Any) -> Any:
    return self.mdp.terminal(state)


def _observation(self: Any, state: Any, rng: Random) -> Any:
    return self.mdp.observation(state, rng)


PASSED_ON = {
    "initial": _initial,
    "transition": _transition,
    "reward": _reward,
    "terminal": _terminal,
    "observation": _observation,
}
"""The five methods of an MDP, each of which calls the same method of the inner MDP.

The class of a wrapper needs all five, since the compiler looks for methods in the class itself.
"""


def wrapper(kind: Kind) -> Kind:
    """Class decorator: turn a NamedTuple into an MDP; its field `mdp` is the inner MDP.

    It behaves like the inner MDP, except for what the class defines:

        @wrapper
        class Noisy(NamedTuple):
            \"\"\"An MDP whose rewards are noisy.\"\"\"

            mdp: Any
            sigma: float

            def reward(self, state, action, next_state, rng):
                return self.mdp.reward(state, action, next_state, rng) + rng.normal(0.0, self.sigma)

    Spaces, step limit, names of actions, picture (`scene`) and info are those of the inner MDP, unless the class
    defines them. (Private attributes are not passed on, nor is `observe_into`, by which some MDPs write an observation
    into an array.)

    If the wrapper's states differ from those of the inner MDP, the class must define `inside(state)`. It returns the
    inner MDP's state, from which `scene` and `info` are made.

    Raises:
        TypeError: it is no class, or one without a field `mdp`.
    """
    if not isinstance(kind, type) or "mdp" not in getattr(kind, "_fields", ()):
        given = kind.__name__ if isinstance(kind, type) else in_short(kind)
        raise TypeError(f"kind must be a NamedTuple with a field mdp, the MDP that it wraps, but is {given}")
    for name, method in PASSED_ON.items():
        if not hasattr(kind, name):
            setattr(kind, name, method)
    if not hasattr(kind, "__getattr__"):
        changed: Any = kind
        changed.__getattr__ = _from_inside
    return kind


def _from_inside(self: Any, name: str) -> Any:
    """If the wrapper does not define an attribute, get it from the inner MDP.

    Private attributes and `observe_into` are not passed on.
    """
    # `observe_into` of the inner MDP would write the inner MDP's observation, not the wrapper's.
    if name.startswith("_") or name == "observe_into":
        raise AttributeError(f"{type(self).__name__} has no attribute {name!r}")
    value = getattr(self.mdp, name)
    if name in ("scene", "info") and hasattr(type(self), "inside"):
        return _of_inner_states(self, value)
    return value


def _of_inner_states(self: Any, method: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that turns a state of the wrapper into one of the inner MDP, and calls `method` with it."""

    @wraps(method)
    def of_wrapped(state: Any, *arguments: Any, **named: Any) -> Any:
        if named.get("last_state") is not None:
            named["last_state"] = self.inside(named["last_state"])
        return method(self.inside(state), *arguments, **named)

    return of_wrapped

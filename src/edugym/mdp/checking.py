"""Whether an MDP is one, and what its methods return: each mistake is answered with one sentence.

The sentence names the method, what it returned, the state it was given, and what it should return. The first steps of
a student's MDP are checked in this way; the package's own MDPs are covered by its tests.
"""

import copy
import difflib
import inspect
import math
import numbers
from typing import Any

import numpy as np
from gymnasium import Env, spaces

from edugym.mdp.protocol import MDP, Random, step_limit

METHODS = {
    "initial": ("rng",),
    "transition": ("state", "action", "rng"),
    "reward": ("state", "action", "next_state", "rng"),
    "terminal": ("state",),
    "observation": ("state", "rng"),
}
"""What every MDP has, and what each method takes."""
SPACES = ("observation_space", "action_space")
CHECKED_STEPS = 200


def require_mdp(mdp: Any, name: str = "mdp") -> None:
    """Refuse what is no MDP: it needs five methods and two spaces; its step limit, if any, must be a whole number.

    Args:
        mdp: the value.
        name: of the parameter that it was given for.

    Raises:
        ValueError: something is missing, or is not as it must be.
    """
    if isinstance(mdp, type):
        made = f"{mdp.__name__}.create(...)" if hasattr(mdp, "create") else f"{mdp.__name__}(...)"
        raise ValueError(f"{name} must be a value, but is the class {mdp.__name__}: make one with {made}")
    if isinstance(mdp, str):
        raise ValueError(f"{name} must be an MDP, but is the name {mdp!r}: use edugym.make_mdp({mdp!r})")
    if isinstance(mdp, Env) or not any(_has(mdp, method) for method in METHODS):
        raise ValueError(
            f"{name} must be an MDP, a value with the methods {', '.join(METHODS)} and the properties"
            f" {' and '.join(SPACES)}, but is {mdp!r}"
        )
    for method, parameters in METHODS.items():
        _require_method(mdp, method, parameters)
    for space in SPACES:
        _require_space(mdp, space)
    actions = mdp.action_space
    if isinstance(actions, spaces.Discrete) and actions.start != 0:
        raise ValueError(f"action_space of {_name(mdp)} must number the actions from 0, but is {actions}")
    step_limit(mdp)


def check_mdp(mdp: Any, n_steps: int = CHECKED_STEPS) -> list[Any]:
    """Play some random steps of a student's MDP, and check what its methods return.

    It plays a copy, with a random stream of its own.

    Args:
        mdp: the task.
        n_steps: how many steps to play.

    Returns:
        The states met, in order; an initial one first.

    Raises:
        ValueError: it is no MDP, or one of its methods returns what it may not.
    """
    require_mdp(mdp)
    mdp, rng, actions = copy.deepcopy(mdp), np.random.default_rng(0), copy.deepcopy(mdp.action_space)
    actions.seed(0)
    checked = not is_own(mdp)
    state = mdp.initial(rng)
    states = [state]
    if checked:
        checked_observation(mdp, state, rng)
    for _ in range(n_steps):
        action = actions.sample()
        action = int(action) if isinstance(actions, spaces.Discrete) else action
        if checked:
            state, _, terminated, _ = checked_step(mdp, state, action, rng)
        else:
            state = mdp.transition(state, action, rng)
            terminated = mdp.terminal(state)
        states.append(state)
        if terminated:
            state = mdp.initial(rng)
            states.append(state)
    return states


def checked_step(mdp: MDP[Any, Any], state: Any, action: Any, rng: Random) -> tuple[Any, float, bool, Any]:
    """Take one step.

    Returns:
        The next state, the reward, whether the task has ended, and the observation as the MDP returned it.

    Raises:
        ValueError: a method returns what it may not, or changes the state that it was given.
    """
    before = _kept(state)
    next_state = mdp.transition(state, action, rng)
    _refuse_change(mdp, "transition", before, state)
    if next_state is None:
        raise ValueError(_sentence(mdp, "transition", None, "the next state", state, action))
    after = _kept(next_state)
    reward = mdp.reward(state, action, next_state, rng)
    _refuse_change(mdp, "reward", before, state)
    _refuse_change(mdp, "reward", after, next_state)
    if not _is_finite_number(reward):
        raise ValueError(_sentence(mdp, "reward", reward, "a finite number", state, action, next_state))
    terminated = mdp.terminal(next_state)
    _refuse_change(mdp, "terminal", after, next_state)
    if not isinstance(terminated, bool | np.bool_ | int | np.integer):
        raise ValueError(_sentence(mdp, "terminal", terminated, "True or False", next_state))
    return next_state, float(reward), bool(terminated), checked_observation(mdp, next_state, rng)


def checked_observation(mdp: MDP[Any, Any], state: Any, rng: Random) -> Any:
    """What the agent sees in a state.

    Raises:
        ValueError: it is not in the observation space, or the state was changed.
    """
    before = _kept(state)
    observation = mdp.observation(state, rng)
    _refuse_change(mdp, "observation", before, state)
    if not _fits(mdp.observation_space, observation):
        raise ValueError(_sentence(mdp, "observation", observation, f"an element of {mdp.observation_space}", state))
    return observation


def is_own(value: Any) -> bool:
    """Whether all classes in a value are the package's own, or Python's and NumPy's, and no student's."""
    if isinstance(value, tuple) and not all(map(is_own, value)):
        return False
    return type(value).__module__.partition(".")[0] in ("edugym", "builtins", "numpy")


def _require_method(mdp: Any, name: str, parameters: tuple[str, ...]) -> None:
    if not _has(mdp, name):
        near = difflib.get_close_matches(name, [other for other in dir(mdp) if other not in METHODS], 1)
        hint = f"; is {near[0]!r} misspelt?" if near else ""
        raise ValueError(f"{_name(mdp)} must have a method {name}(self, {', '.join(parameters)}){hint}")
    method = getattr(mdp, name)
    if not callable(method):
        raise ValueError(f"{name} of {_name(mdp)} must be a method, but is {method!r}")
    signature = inspect.signature(method)
    try:
        signature.bind(*parameters)
    except TypeError:
        raise ValueError(
            f"{name} of {_name(mdp)} must take (self, {', '.join(parameters)}), but takes"
            f" (self{''.join(f', {parameter}' for parameter in signature.parameters)})"
        ) from None


def _require_space(mdp: Any, name: str) -> None:
    if not _has(mdp, name):
        raise ValueError(f"{_name(mdp)} must have a property {name}, a Gymnasium space such as spaces.Discrete(2)")
    space = getattr(mdp, name)
    if not isinstance(space, spaces.Space):
        hint = ": put @property above it" if inspect.ismethod(space) else ""
        raise ValueError(
            f"{name} of {_name(mdp)} must be a Gymnasium space, such as spaces.Discrete(2), but is {space!r}{hint}"
        )


def _has(mdp: Any, name: str) -> bool:
    """Whether there is such an attribute, even if getting it fails inside (which must show, not mean "no")."""
    missing = object()
    return inspect.getattr_static(mdp, name, missing) is not missing or hasattr(mdp, name)


def _name(mdp: Any) -> str:
    return type(mdp).__name__


def _sentence(
    mdp: Any, method: str, returned: Any, allowed: str, state: Any, action: Any = None, next_state: Any = None
) -> str:
    given = f"state {_short(state)}"
    given += "" if action is None else f", action {_short(action)}"
    given += "" if next_state is None else f", next state {_short(next_state)}"
    forgotten = " (is a return missing?)" if returned is None else ""
    return f"{method} of {_name(mdp)} must return {allowed}, but returned {_short(returned)} for {given}{forgotten}"


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 200 else f"{text[:197]}..."


def _is_finite_number(value: Any) -> bool:
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if not isinstance(value, numbers.Real | np.bool_):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def _fits(space: spaces.Space[Any], observation: Any) -> bool:
    """Whether an observation is an element of a space, given as Python's numbers, tuples or lists, or as arrays."""
    if isinstance(space, spaces.Tuple):
        several = isinstance(observation, tuple | list) and len(observation) == len(space.spaces)
        return several and all(map(_fits, space.spaces, observation))
    if isinstance(space, spaces.Dict):
        named = isinstance(observation, dict) and observation.keys() == space.spaces.keys()
        return named and all(_fits(part, observation[name]) for name, part in space.spaces.items())
    if isinstance(space, spaces.Discrete):
        return isinstance(observation, int | np.integer | np.bool_) and 0 <= int(observation) - int(space.start) < int(
            space.n
        )
    if not isinstance(space, spaces.Box | spaces.MultiDiscrete | spaces.MultiBinary):
        return bool(space.contains(observation))
    try:
        given = np.asarray(observation)
        if given.dtype.kind not in "biuf" or given.shape != space.shape:
            return False
        with np.errstate(all="ignore"):
            cast = given.astype(space.dtype)
    except (ValueError, OverflowError):
        return False
    unchanged = space.dtype is None or space.dtype.kind == "f" or bool((cast == given).all())
    return unchanged and bool(space.contains(cast))


def _kept(state: Any) -> Any:
    """A copy of a state that could be changed in place; of one that could not, the state itself."""
    return state if isinstance(state, int | float | str | None) else copy.deepcopy(state)


def _refuse_change(mdp: Any, method: str, before: Any, now: Any) -> None:
    if not _same(before, now):
        raise ValueError(
            f"{method} of {_name(mdp)} must not change the state that it is given, but turned {_short(before)} into"
            f" {_short(now)}: make a new one, for example from a copy"
        )


def _same(one: Any, other: Any) -> bool:
    if one is other:
        return True
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return np.shape(one) == np.shape(other) and np.asarray(one).tobytes() == np.asarray(other).tobytes()
    if isinstance(one, tuple | list) and type(one) is type(other):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_same(one[key], other[key]) for key in one)
    if vars(object)["__eq__"] is type(one).__eq__:  # of ordinary classes, whose values are compared by what is in them
        return type(one) is type(other) and _same(getattr(one, "__dict__", None), getattr(other, "__dict__", None))
    return bool(one == other) or (one != one and other != other)

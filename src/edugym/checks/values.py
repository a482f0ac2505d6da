"""What checks of students' code ask of values: whether one is in a space, is a number, or is still what it was."""

import copy
import ctypes
import math
import numbers
import random
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from gymnasium import spaces

ANSWERS = (bool, np.bool_, int, np.integer)
"""The types of what may say whether an episode ends."""


def is_finite_number(value: Any) -> bool:
    """Whether it is a real number, Python's or NumPy's, and neither infinite nor NaN."""
    if type(value) is float:  # most are, and this is asked at every step
        return math.isfinite(value)
    if isinstance(value, np.ndarray):
        value = value[()]  # the number in an array of no dimension
    if not isinstance(value, numbers.Real | np.bool_):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def fits(space: spaces.Space[Any], observation: Any) -> bool:
    """Whether an observation is an element of a space, given as Python's numbers, tuples or lists, or as arrays.

    True and False are no whole numbers: as an index of a table they stand for all of it and for nothing. Among several
    numbers they may stand for one of two, since these are made one number first.
    """
    if isinstance(space, spaces.Tuple):
        several = isinstance(observation, tuple | list) and len(observation) == len(space.spaces)
        return several and all(map(fits, space.spaces, map(without_flag, space.spaces, observation)))
    if isinstance(space, spaces.Dict):
        named = isinstance(observation, dict) and observation.keys() == space.spaces.keys()
        return named and all(fits(part, observation[name]) for name, part in space.spaces.items())
    if isinstance(space, spaces.Discrete):
        whole = isinstance(observation, int | np.integer) and not isinstance(observation, bool)  # Q[True] is all of Q
        return whole and 0 <= int(observation) - int(space.start) < int(space.n)
    if not isinstance(space, spaces.Box | spaces.MultiDiscrete | spaces.MultiBinary):
        return bool(space.contains(observation))
    try:
        given = np.asarray(observation)
        if given.dtype.kind not in "biuf":
            return False
        with np.errstate(all="ignore"):
            cast = given.astype(space.dtype)
    except (ValueError, OverflowError):
        return False
    unchanged = space.dtype is None or space.dtype.kind == "f" or bool((cast == given).all())
    return unchanged and bool(space.contains(cast))


def without_flag(space: spaces.Space[Any], value: Any) -> Any:
    """1 and 0 for True and False where a space has two numbers; any other value as it is."""
    is_flag = isinstance(value, bool | np.bool_) and isinstance(space, spaces.Discrete) and space.n == 2
    return int(value) if is_flag else value


def kept(state: Any) -> Any:
    """A copy of a state that could be changed in place; of one that could not, the state itself."""
    return state if isinstance(state, int | float | str | None) else copy.deepcopy(state)


def deep_copy(value: Any, why: str) -> Any:
    """A copy that shares nothing with a value.

    Args:
        value: an agent or an environment.
        why: what the copy is for, and what to do where there can be none.

    Raises:
        ValueError: something in it cannot be copied.
    """
    try:
        return copy.deepcopy(value)
    except TypeError as error:
        if "cannot pickle" not in str(error):
            raise
        held = str(error).removeprefix("cannot pickle ").removesuffix(" object").strip("'")
        name = type(getattr(value, "unwrapped", value)).__name__
        raise ValueError(f"{name} holds a {held}, which cannot be copied, but {why}") from None


def same(one: Any, other: Any) -> bool:
    """Whether two values are the same, whatever they are made of; NaN is the same as NaN."""
    if one is other:
        return True
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return np.shape(one) == np.shape(other) and np.asarray(one).tobytes() == np.asarray(other).tobytes()
    if isinstance(one, tuple | list) and type(one) is type(other):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    if vars(object)["__eq__"] is type(one).__eq__:  # of ordinary classes, whose values are compared by what is in them
        return type(one) is type(other) and same(getattr(one, "__dict__", None), getattr(other, "__dict__", None))
    return bool(one == other) or (one != one and other != other)


class GlobalDraws:
    """Finds methods that draw from `random` or `np.random`, which no seed of a run reaches.

    Args:
        owner: the name of the class whose methods are looked at.
        calls: how many calls are looked at.
    """

    def __init__(self, owner: str, calls: int = 100) -> None:
        """See the class."""
        self._owner, self._calls = owner, calls

    @contextmanager
    def refused(self, method: str) -> Iterator[None]:
        """Raise a `ValueError` where the block, a call of this method, draws from one of them."""
        if self._calls <= 0:
            yield
            return
        self._calls -= 1
        before = _global_streams()
        yield
        if _global_streams() != before:
            raise ValueError(
                f"{method} of {self._owner} draws from random or np.random, which no seed of a run reaches, so that"
                " the run could not be repeated: draw from rng, for example rng.random()"
            )


def _global_streams() -> tuple[Any, ...]:
    """What changes with every draw from the global random streams.

    NumPy's own functions take five times as long as reading the 624 numbers of its generator, and its place in them.
    """
    _, pythons, gauss = random.getstate()
    numpys = vars(np.random)["get_bit_generator"]()  # another one than this may be set, which is no student's slip
    seen = ctypes.string_at(numpys.ctypes.state_address, 625 * 4) if isinstance(numpys, np.random.MT19937) else b""
    return seen, pythons[-1], gauss

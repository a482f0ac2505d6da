"""Whether an observation or an action is in a space, in a form that machine code can ask at every step.

`edugym.checks.values.fits` asks the same in the interpreter, and takes more forms. What is asked here is never less:
where it says no, the interpreter plays the call again.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Reals
from edugym.system.generated import generated_class

FEW = 16
"""Up to this many numbers an observation may be a tuple of several types."""


class Between(NamedTuple):
    """For one number.

    Attributes:
        low: the least.
        high: the greatest.
    """

    low: Any
    high: Any

    def hold(self, value: Any) -> bool:
        """Return whether it is between them; NaN is not."""
        inside: bool = self.low <= value <= self.high
        return inside


class WholeBetween(NamedTuple):
    """For one whole number, such as the index of a row.

    Attributes:
        low: the least.
        high: the greatest.
        least: the least `wholeness` that it may have.
    """

    low: Any
    high: Any
    least: int

    def hold(self, value: Any) -> bool:
        """Return whether it is between them, and whole by its type: 2.0 is no index."""
        inside: bool = wholeness(value) >= self.least and self.low <= value <= self.high
        return inside


def wholeness(value: Any) -> int:
    """Return 2 for a whole number, 1 for True and False, and 0 for anything else: it is the type that counts.

    Machine code has another implementation, by type (`edugym.compiled.finite`).
    """
    if isinstance(value, bool | np.bool_):
        return 1
    return 2 if isinstance(value, int | np.integer) else 0


class Bounds(NamedTuple):
    """For a vector of many numbers.

    Attributes:
        low: shape (k,).
        high: shape (k,).
        step: 1.0 where they must be whole, and 0.0 where not.
    """

    low: Reals
    high: Reals
    step: float

    def hold(self, value: Any) -> bool:
        """Return whether it has so many numbers, all of them between the bounds."""
        within = len(value) == self.low.size
        for i in range(self.low.size):
            within = within and self.low[i] <= value[i] <= self.high[i]
            within = within and (self.step == 0.0 or value[i] % 1 == 0)
        return within


class ArrayBounds(NamedTuple):
    """For an array of several dimensions.

    Attributes:
        low: of the same shape.
        high: of the same shape.
        step: as in `Bounds`.
    """

    low: Any
    high: Any
    step: float

    def hold(self, value: Any) -> bool:
        """Return whether it has this shape, and all its numbers are between the bounds."""
        if value.shape != self.low.shape:
            return False
        for i in range(self.low.size):
            if not self.low.flat[i] <= value.flat[i] <= self.high.flat[i]:
                return False
            if self.step != 0.0 and value.flat[i] % 1 != 0:
                return False
        return True


def membership(space: spaces.Space[Any]) -> Any:
    """What has a method `hold(value)` that tells whether a value is in the space; None for spaces of other kinds."""
    if isinstance(space, spaces.Discrete):
        return WholeBetween(int(space.start), int(space.start) + int(space.n) - 1, 2)
    if isinstance(space, spaces.Tuple):
        return _of_parts(space)
    if isinstance(space, spaces.Box):
        whole = space.dtype.kind != "f"
        low = space.low.astype(float) if whole else _widened(space.low, -math.inf)
        high = space.high.astype(float) if whole else _widened(space.high, math.inf)
        return _of_bounds(low, high, whole)
    if isinstance(space, spaces.MultiDiscrete):
        start = np.asarray(space.start).astype(float)
        return _of_bounds(start, start + space.nvec - 1, True)
    if isinstance(space, spaces.MultiBinary):
        return _of_bounds(np.zeros(space.shape), np.ones(space.shape), True)
    return None


class FiniteAction(NamedTuple):
    """For an action of real numbers, whose bounds the MDP checks itself.

    Attributes:
        shape: of the action.
    """

    shape: Any

    def hold(self, value: Any) -> bool:
        """Return whether it is of this shape, or a single number as the space has, and finite."""
        return is_finite_of_shape(value, self.shape)


def is_finite_of_shape(value: Any, shape: tuple[int, ...]) -> bool:
    """Whether a value is finite, and has the shape or is the one number that it asks for.

    Machine code has another implementation, by type (`edugym.compiled.finite`).
    """
    numbers = np.asarray(value)
    finite = bool(np.isfinite(numbers).all())
    return finite and (numbers.shape == shape or math.prod(shape) == numbers.size == 1)


def membership_of_actions(space: spaces.Space[Any]) -> Any:
    """The same for what an agent may give an MDP as an action."""
    return FiniteAction(space.shape) if isinstance(space, spaces.Box) else membership(space)


def _of_bounds(low: Any, high: Any, whole: bool) -> Any:
    """For an array of numbers.

    A few may come as a tuple of several types. Numba can index such a tuple only with constants, as in `value[0]`, so
    the comparison is written out as code.
    """
    step = 1.0 if whole else 0.0
    if low.ndim == 0:
        return Between(float(low), float(high))
    if low.ndim > 1:
        return ArrayBounds(low, high, step)
    if low.size > FEW:
        return Bounds(low, high, step)
    asked = [f"self.low[{i}] <= value[{i}] <= self.high[{i}]" for i in range(low.size)]
    asked += [f"value[{i}] % 1 == 0" for i in range(low.size) if whole]
    return _generated(["low", "high"], [f"len(value) == {low.size}", *asked])(low, high)


def _of_parts(space: Any) -> Any:
    parts = [membership(part) for part in space.spaces]
    for place, part in enumerate(parts):
        if isinstance(part, WholeBetween) and part.high == part.low + 1:
            parts[place] = part._replace(least=1)  # among several numbers flags may stand for one of two (see `fits`)
    if None in parts:
        return None
    names = [f"part{i}" for i in range(len(parts))]
    asked = [f"self.{name}.hold(value[{i}])" for i, name in enumerate(names)]
    return _generated(names, [f"len(value) == {len(parts)}", *asked])(*parts)


def _generated(fields: list[str], asked: list[str]) -> Any:
    lines = [*(f"    {name}: object" for name in fields), "    def hold(self, value):"]
    return generated_class("Membership", [*lines, f"        return {' and '.join(asked)}"], {})


def _widened(bounds: Any, to: float) -> Any:
    """Return the bounds, half a last digit wider: the space rounds a number to its own type before it compares."""
    with np.errstate(over="ignore", invalid="ignore"):  # at infinite bounds, which stay so
        beyond = np.nextafter(bounds, bounds.dtype.type(to))
        wider = bounds.astype(float) + (beyond.astype(float) - bounds) / 2
    return np.where(np.isfinite(bounds), wider, bounds)

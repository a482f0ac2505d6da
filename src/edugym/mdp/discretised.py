"""Real numbers as bins: observations for a table, and actions 0, 1, ... for a task with continuous ones."""

import itertools
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.parameters import a_number, an_array, in_short, whole_number
from edugym.mdp.in_place import blank, in_place, written
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.task import task_of
from edugym.mdp.wrapper import wrapper
from edugym.system.memory import in_digits

MOST_ACTIONS = 100_000


@wrapper
class Discretised(NamedTuple):
    """An MDP that shows, of every number it observes, only the bin in which it lies.

    The range of a number is cut into bins of the same width, numbered from 0. Numbers outside the range are in the
    first or the last bin.

    Make one with `Discretised.create(mdp, bins)`.

    Attributes:
        mdp: the task, which observes real numbers.
        bins: shape (n,): how many bins there are for each number.
        lows: shape (n,): where the first bin begins.
        highs: shape (n,): where the last bin ends.
        values: the present observation, before it is put into bins.
        blank: shape (n,): an observation in bins, empty.
    """

    mdp: Any
    bins: Integers
    lows: Reals
    highs: Reals
    values: Any
    blank: Integers

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """A bin for every number, in one row: an image is flattened."""
        return spaces.MultiDiscrete(self.bins)

    def observation(self, state: Any, rng: Random) -> Any:
        """What `observe_into` writes, as a new array."""
        return written(self, state, rng)

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the bins into `out`, shape (n,)."""
        self.mdp.observe_into(state, rng, self.values)
        for k in range(self.values.size):
            value = float(self.values.flat[k])
            if value != value:
                raise ValueError("an observation that is not a number (NaN) lies in no bin")
            share = (value - self.lows[k]) / (self.highs[k] - self.lows[k])
            if share >= 1.0:
                out[k] = self.bins[k] - 1
            else:
                out[k] = int(share * self.bins[k]) if share > 0.0 else 0

    @classmethod
    def create(
        cls,
        mdp: Any,
        bins: int | Sequence[int],
        low: float | Sequence[float] | None = None,
        high: float | Sequence[float] | None = None,
    ) -> "Discretised":
        """The wrapper for an MDP with a Box observation space.

        Args:
            mdp: the task.
            bins: how many bins: one number for all that it observes, or one for each.
            low: where the first bin begins, likewise; by default the low end of the observation space.
            high: where the last bin ends, likewise; by default the high end of the observation space.

        Raises:
            ValueError: the task observes something else, or a number is not as said.
        """
        task_of(mdp, "mdp", MDP_ONLY)
        space = mdp.observation_space
        if not isinstance(space, spaces.Box):
            raise ValueError(f"mdp must observe real numbers (a Box), but its observation space is {space}")
        mdp = in_place(mdp)
        values = blank(mdp)
        n = values.size
        numbers = bins_of(bins, n)
        lows, highs = _ends("low", low, space.low, n), _ends("high", high, space.high, n)
        if not (lows < highs).all():
            k = int(np.argmin(lows < highs))
            raise ValueError(f"low must be less than high, but for number {k} they are {lows[k]} and {highs[k]}")
        return cls(mdp, numbers, lows, highs, values, np.zeros(n, np.int64))


@wrapper
class DiscreteActions(NamedTuple):
    """An MDP with continuous actions, of which some are taken out and numbered 0, 1, ...

    Make one with `DiscreteActions.create(mdp, bins)`.

    Attributes:
        mdp: the task, whose actions are arrays.
        actions: shape (n_actions, length of an action): what is done when an action is chosen.
    """

    mdp: Any
    actions: Any

    @property
    def action_space(self) -> spaces.Discrete:
        """The numbers of the actions."""
        return spaces.Discrete(len(self.actions))

    @property
    def action_names(self) -> tuple[str, ...]:
        """The numbers that each stands for."""
        return tuple(", ".join(f"{part:g}" for part in action) for action in self.actions)

    def transition(self, state: Any, action: int, rng: Random) -> Any:
        """Do what the number stands for."""
        return self.mdp.transition(state, self.actions[action], rng)

    def reward(self, state: Any, action: int, next_state: Any, rng: Random) -> float:
        """The reward for what the number stands for."""
        reward: float = self.mdp.reward(state, self.actions[action], next_state, rng)
        return reward

    @classmethod
    def create(cls, mdp: Any, bins: int | Sequence[int]) -> "DiscreteActions":
        """The wrapper for an MDP with a Box action space of one axis and finite bounds.

        Args:
            mdp: the task.
            bins: into how many values each number of an action is cut, evenly from its low end to its high end, 2 or
                more: one number for all, or one for each. The last number changes fastest.

        Raises:
            ValueError: the actions are something else, a number is not as said, or there are more than 100 000 actions.
        """
        task_of(mdp, "mdp", MDP_ONLY)
        space = mdp.action_space
        if not isinstance(space, spaces.Box) or len(space.shape) != 1 or not space.is_bounded():
            raise ValueError(f"the actions of mdp must be a Box of one axis with finite bounds, but are {space}")
        numbers = bins_of(bins, space.shape[0], least=2)
        n_actions = int(np.prod(numbers, dtype=object))
        if n_actions > MOST_ACTIONS:
            raise ValueError(
                f"bins must give at most {MOST_ACTIONS} actions, but {bins!r} gives {in_digits(n_actions)}"
            )
        values = [np.linspace(*ends) for ends in zip(space.low, space.high, numbers, strict=True)]
        return cls(mdp, np.array(list(itertools.product(*values)), np.float64))


def bins_of(bins: int | Sequence[int], n: int, least: int = 1) -> Integers:
    """How many bins there are for each of n numbers.

    Raises:
        ValueError: there is not one whole number of `least` or more for each.
    """
    each = np.ravel(np.full(n, bins, object) if np.ndim(bins) == 0 else np.array(bins, object))
    if len(each) != n:
        raise ValueError(f"bins must be one number or {n}, one for each, but is {in_short(bins)}")
    return np.array([whole_number("bins", number, least, 2**31) for number in each], np.int64)


def _ends(name: str, given: float | Sequence[float] | None, of_space: Any, n: int) -> Reals:
    """Where the bins of each of n numbers begin or end."""
    if given is None:
        ends: Reals = np.ravel(np.asarray(of_space, np.float64))
        if not np.isfinite(ends).all():
            raise ValueError(f"{name} must be given for a task that observes numbers without bounds: {name}=...")
        return ends
    if isinstance(given, int | float | np.number):
        return np.full(n, a_number(name, given))
    ends = an_array(name, given, (n,))
    if not np.isfinite(ends).all():
        raise ValueError(f"{name} must hold finite numbers, but is {in_short(given)}")
    return ends

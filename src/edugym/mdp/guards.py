"""Guards around an MDP: they stop machine code at a reward, an observation or an action that is invalid.

The first steps of a student's MDP or agent are checked in every way (see `edugym.checks`). A mistake in a rare state
comes later, when the loop may run as machine code. There NaN would spread silently, and the row -1 of a table is its
last. Where a guard stops machine code, the interpreter plays the call again with all checks, which say what is wrong.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Random, Reals, writes_in_place
from edugym.mdp.wrapper import wrapper
from edugym.system.generated import generated_class
from edugym.system.packages import is_own

FEW = 16
"""Up to this many numbers an observation may be a tuple of several types."""


@wrapper
class FiniteRewards(NamedTuple):
    """An MDP that stops at a reward that is NaN or infinite.

    Attributes:
        mdp: the task.
    """

    mdp: Any

    def reward(self, state: Any, action: Any, next_state: Any, rng: Random) -> float:
        """The reward of the task.

        Raises:
            ValueError: it is not finite.
        """
        reward: float = self.mdp.reward(state, action, next_state, rng)
        if not math.isfinite(reward):
            raise ValueError("a reward is no finite number")
        return reward


class FiniteRewardsInPlace(FiniteRewards):
    """The same for an MDP that writes its observations into an array."""

    __slots__ = ()

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the observation of the task into `out`."""
        self.mdp.observe_into(state, rng, out)


@wrapper
class RowsOfATable(NamedTuple):
    """An MDP that stops at an observation that is not a row of a table.

    Attributes:
        mdp: the task, which numbers its observations from 0.
        n_observations: how many there are.
    """

    mdp: Any
    n_observations: int

    def observation(self, state: Any, rng: Random) -> int:
        """The observation of the task.

        Raises:
            ValueError: it is not from 0 to `n_observations` - 1.
        """
        observation: int = self.mdp.observation(state, rng)
        if not 0 <= observation < self.n_observations:
            raise ValueError("an observation is not in the observation space")
        return observation


@wrapper
class WithinABox(NamedTuple):
    """An MDP that stops at a vector of observations that is not within its bounds.

    Attributes:
        mdp: the task.
        bounds: between which its numbers must be.
    """

    mdp: Any
    bounds: Any

    def observation(self, state: Any, rng: Random) -> Any:
        """The observation of the task.

        Raises:
            ValueError: a number is too small or too large, or NaN.
        """
        observation = self.mdp.observation(state, rng)
        if not self.bounds.hold(observation):
            raise ValueError("an observation is not in the observation space")
        return observation


class Bounds(NamedTuple):
    """The least and the greatest numbers of a vector.

    Attributes:
        low: shape (k,).
        high: shape (k,).
    """

    low: Reals
    high: Reals

    def hold(self, vector: Any) -> bool:
        """Return whether all its numbers are between them; NaN is not."""
        within = True
        for i in range(self.low.size):
            within = within and self.low[i] <= vector[i] <= self.high[i]
        return within


def _bounds(space: spaces.Box) -> Any:
    """Return the bounds of a space of vectors.

    A few numbers may come as a tuple of several types. Numba can index such a tuple only with constants, as in
    `vector[0]`, so the comparison is written out as code.
    """
    low, high = _widened(space.low, -math.inf), _widened(space.high, math.inf)
    if low.size > FEW:
        return Bounds(low, high)
    between = " and ".join(f"self.low[{i}] <= vector[{i}] <= self.high[{i}]" for i in range(low.size)) or "True"
    lines = ["    low: object", "    high: object", "    def hold(self, vector):", f"        return {between}"]
    return generated_class("Bounds", lines, {})(low, high)


def _widened(bounds: Any, to: float) -> Reals:
    """Return the bounds, half a last digit wider: the space rounds a number to its own type before it compares."""
    with np.errstate(over="ignore", invalid="ignore"):  # at infinite bounds, which stay so
        beyond = np.nextafter(bounds, bounds.dtype.type(to))
        wider = bounds.astype(float) + (beyond.astype(float) - bounds) / 2
    widened: Reals = np.where(np.isfinite(bounds), wider, bounds)
    return widened


@wrapper
class ActionsOfASpace(NamedTuple):
    """An MDP that stops at an action that it does not have.

    Attributes:
        mdp: the task, which numbers its actions from 0.
        n_actions: how many there are.
    """

    mdp: Any
    n_actions: int

    def transition(self, state: Any, action: Any, rng: Random) -> Any:
        """The next state of the task.

        Raises:
            ValueError: the action is not from 0 to `n_actions` - 1.
        """
        if not 0 <= action < self.n_actions:
            raise ValueError("an action is not in the action space")
        return self.mdp.transition(state, action, rng)


class ActionsOfASpaceInPlace(ActionsOfASpace):
    """The same for an MDP that writes its observations into an array."""

    __slots__ = ()

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the observation of the task into `out`."""
        self.mdp.observe_into(state, rng, out)


def guarded(mdp: Any, agent: Any) -> Any:
    """Return an MDP with guards against what a student's MDP, or a student's agent, may do."""
    in_place, actions, observations = writes_in_place(mdp), mdp.action_space, mdp.observation_space
    if not is_own(mdp):
        if isinstance(observations, spaces.Discrete) and observations.start == 0:
            mdp = RowsOfATable(mdp, int(observations.n))
        vector = isinstance(observations, spaces.Box) and len(observations.shape) == 1 and not in_place
        if vector and observations.dtype.kind == "f":
            mdp = WithinABox(mdp, _bounds(observations))
        mdp = FiniteRewardsInPlace(mdp) if in_place else FiniteRewards(mdp)
    if not is_own(agent) and isinstance(actions, spaces.Discrete) and actions.start == 0:
        mdp = (ActionsOfASpaceInPlace if in_place else ActionsOfASpace)(mdp, int(actions.n))
    return mdp


GUARDS = (ActionsOfASpace, ActionsOfASpaceInPlace, FiniteRewards, FiniteRewardsInPlace, RowsOfATable, WithinABox)
"""The classes of the guards. They say less than the checks."""

"""Guards around a student's MDP: they stop machine code where the MDP returns what no agent can learn from.

The first steps of a student's MDP are checked by `edugym.training.checking`. A mistake in a rare state comes later,
when the loop may run as machine code. There NaN would spread silently, and the row -1 of a table is its last. Where a
guard stops machine code, the interpreter plays the call again with all checks, and they say what is wrong.
"""

import math
from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.mdp.checking import is_own
from edugym.mdp.protocol import Random, writes_in_place
from edugym.mdp.wrapper import wrapper


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
            ValueError: it is no finite number.
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
    """An MDP that stops at an observation that is no row of a table.

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


def guarded(mdp: Any) -> Any:
    """Return a student's MDP with guards around it, and one of the package's own as it is."""
    if is_own(mdp):
        return mdp
    space = mdp.observation_space
    if isinstance(space, spaces.Discrete) and space.start == 0:
        mdp = RowsOfATable(mdp, int(space.n))
    return FiniteRewardsInPlace(mdp) if writes_in_place(mdp) else FiniteRewards(mdp)


GUARDS = (FiniteRewards, RowsOfATable)
"""The classes of the guards. They say less than the checks."""

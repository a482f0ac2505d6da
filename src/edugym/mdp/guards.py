"""Guards around an MDP: they stop machine code at a start, a reward, an observation or an action that is invalid.

The first steps of a student's MDP or agent are checked in every way (see `edugym.checks`). A mistake in a rare state
comes later, when the loop may run as machine code. There NaN would spread silently, and the row -1 of a table is its
last. Where a guard stops machine code, the interpreter plays the call again with all checks, which say what is wrong.
"""

import math
from typing import Any, NamedTuple

from edugym.mdp.membership import membership, membership_of_actions
from edugym.mdp.protocol import Random, writes_in_place
from edugym.mdp.wrapper import wrapper
from edugym.system.packages import is_ours, is_own


@wrapper
class StartsAndRewards(NamedTuple):
    """An MDP that stops at an episode that starts in a terminal state, and at a reward that is NaN or infinite.

    Attributes:
        mdp: the task.
    """

    mdp: Any

    def initial(self, rng: Random) -> Any:
        """The first state of the task.

        Raises:
            ValueError: it is terminal.
        """
        state = self.mdp.initial(rng)
        if self.mdp.terminal(state):
            raise ValueError("an episode starts in a terminal state")
        return state

    def reward(self, state: Any, action: Any, next_state: Any, rng: Random) -> float:
        """The reward of the task.

        Raises:
            ValueError: it is not finite.
        """
        reward: float = self.mdp.reward(state, action, next_state, rng)
        if not math.isfinite(reward):
            raise ValueError("a reward is no finite number")
        return reward


class StartsAndRewardsInPlace(StartsAndRewards):
    """The same for an MDP that writes its observations into an array."""

    __slots__ = ()

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the observation of the task into `out`."""
        self.mdp.observe_into(state, rng, out)


@wrapper
class InSpace(NamedTuple):
    """An MDP that stops at an observation that is not in its space.

    Attributes:
        mdp: the task.
        space: what tells whether an observation is in it (see `edugym.mdp.membership`).
    """

    mdp: Any
    space: Any

    def observation(self, state: Any, rng: Random) -> Any:
        """The observation of the task.

        Raises:
            ValueError: it is not in the space.
        """
        observation = self.mdp.observation(state, rng)
        if not self.space.hold(observation):
            raise ValueError("an observation is not in the observation space")
        return observation


class InSpaceInPlace(InSpace):
    """The same for an MDP that writes its observations into an array."""

    __slots__ = ()

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the observation of the task into `out`.

        Raises:
            ValueError: it is not in the space.
        """
        self.mdp.observe_into(state, rng, out)
        if not self.space.hold(out):
            raise ValueError("an observation is not in the observation space")


@wrapper
class ActionsOfASpace(NamedTuple):
    """An MDP that stops at an action that it does not have.

    Attributes:
        mdp: the task.
        actions: what tells whether an action is in its space.
    """

    mdp: Any
    actions: Any

    def transition(self, state: Any, action: Any, rng: Random) -> Any:
        """The next state of the task.

        Raises:
            ValueError: the action is not in the action space.
        """
        if not self.actions.hold(action):
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
    actions = None if is_own(agent) else membership_of_actions(mdp.action_space)
    mdp = _guarded_mdp(mdp)
    if actions is None:
        return mdp
    return (ActionsOfASpaceInPlace if writes_in_place(mdp) else ActionsOfASpace)(mdp, actions)


def _guarded_mdp(mdp: Any) -> Any:
    """The MDP with guards around a student's MDP, also where that is inside the package's wrappers."""
    if is_own(mdp):
        return mdp
    if is_ours(type(mdp)) and not is_own(getattr(mdp, "mdp", None)):
        return mdp._replace(mdp=_guarded_mdp(mdp.mdp))
    in_place, observations = writes_in_place(mdp), membership(mdp.observation_space)
    if observations is not None:
        mdp = (InSpaceInPlace if in_place else InSpace)(mdp, observations)
    return (StartsAndRewardsInPlace if in_place else StartsAndRewards)(mdp)


GUARDS = (ActionsOfASpace, ActionsOfASpaceInPlace, InSpace, InSpaceInPlace, StartsAndRewards, StartsAndRewardsInPlace)
"""The classes of the guards. They say less than the checks."""

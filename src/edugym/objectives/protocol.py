"""The interface of MDPs with several objectives, and the gate for what users give as one.

Such an MDP is an ordinary one, with a vector of rewards beside its reward. You do not inherit from the protocol.
"""

from collections.abc import Sequence
from typing import Any, Protocol

from gymnasium import spaces

from edugym.checks.interfaces import MDP_ONLY, class_name, require_method
from edugym.checks.parameters import an_array, in_short
from edugym.mdp.protocol import MDP, Observation_co, Reals, State
from edugym.mdp.task import task_of

METHODS = {"rewards": ("state", "action", "next_state")}
"""What such an MDP has besides the methods of every MDP, and what it takes."""


class MultiObjectiveMDP(MDP[State, Observation_co], Protocol[State, Observation_co]):
    """An MDP with several objectives. More is better in each of them.

    Its `reward` makes one number of the vector, in a way of its own (in `Diver`, by weights), so that every agent can
    learn on it.

    References: Roijers et al. (2013), A survey of multi-objective sequential decision-making.
    """

    @property
    def reward_space(self) -> spaces.Box:
        """The Gymnasium space of the vectors of rewards, of shape (n_objectives,)."""

    def rewards(self, state: State, action: int, next_state: State) -> Sequence[float]:
        """The rewards of a transition, one for each objective."""


def require_objectives(mdp: Any) -> Any:
    """The MDP with several objectives that a user gave; what is none is refused.

    Raises:
        ValueError: it is no MDP, or `rewards` or `reward_space` are missing or not as they must be.
    """
    played = task_of(mdp, "mdp", MDP_ONLY).played
    if not hasattr(played, "rewards") or not hasattr(played, "reward_space"):
        raise ValueError(
            "mdp must have several objectives, with a method rewards(state, action, next_state) and a property"
            f" reward_space, but is {in_short(mdp)}"
        )
    require_method(played, "rewards", METHODS["rewards"], METHODS)
    space = played.reward_space
    if not isinstance(space, spaces.Box) or len(space.shape) != 1:
        raise ValueError(
            f"reward_space of {class_name(played)} must be a Box of shape (n_objectives,), but is {in_short(space)}"
        )
    return played


def vector(mdp: Any, state: Any, action: int, next_state: Any) -> Reals:
    """The vector of rewards of a transition, shape (n_objectives,).

    Raises:
        ValueError: `rewards` returns something else.
    """
    rewards = mdp.rewards(state, action, next_state)
    return an_array(f"what rewards of {class_name(mdp)} returns", rewards, mdp.reward_space.shape)

"""The interface of MDPs with several objectives, and the gate for what users give as one.

Such an MDP is an ordinary one, with a vector of rewards beside its reward. You do not inherit from the protocol.
"""

from collections.abc import Sequence
from typing import Any, Protocol

import gymnasium
from gymnasium import spaces

from edugym.checks.interfaces import MADE, class_name, require_method
from edugym.checks.parameters import an_array, in_short, whole_number
from edugym.mdp.protocol import MDP, Observation_co, Reals, State
from edugym.mdp.task import bare, table_size, task_of

MOST_OBJECTIVES = 1_000
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


def require_objectives(mdp: Any, name: str = "mdp", allowed: str = MADE) -> Any:
    """The MDP with several objectives that a user gave; what is none is refused.

    Args:
        mdp: the MDP, or an environment that plays it, such as `VectorRewardEnv`.
        name: the argument's name, for messages.
        allowed: `MADE`, or `NAMED` if it may be a name, too.

    Raises:
        ValueError: it is no MDP, or `rewards` or `reward_space` are missing or not as they must be.
    """
    inside = bare(mdp)
    has_vectors = isinstance(inside, gymnasium.Env) and hasattr(inside, "reward_space")
    played = task_of(inside.mdp if has_vectors else mdp, name, allowed).played
    if not hasattr(played, "rewards") or not hasattr(played, "reward_space"):
        raise ValueError(
            f"{name} must have several objectives, with a method rewards(state, action, next_state) and a property"
            f" reward_space, but is {in_short(mdp)}"
        )
    require_method(played, "rewards", METHODS["rewards"], METHODS)
    space = played.reward_space
    if not isinstance(space, spaces.Box) or len(space.shape) != 1:
        raise ValueError(
            f"reward_space of {class_name(played)} must be a Box of shape (n_objectives,), but is {in_short(space)}"
        )
    return played


def table_shape(environment: Any) -> tuple[int, int, int]:
    """The shape of a table with a vector for each pair: (n_states, n_actions, n_objectives).

    Args:
        environment: a task with several objectives whose observations fit a table, an environment of one, or the shape
            itself.

    Raises:
        ValueError: it is something else.
    """
    if isinstance(environment, tuple | list) and not hasattr(environment, "_fields"):
        if len(environment) != 3:
            raise ValueError(f"environment must have a shape of three numbers, but is {in_short(environment)}")
        n_states, n_actions, n_objectives = environment
        return *table_size((n_states, n_actions)), whole_number("n_objectives", n_objectives, 1, MOST_OBJECTIVES)
    played = require_objectives(environment, "environment")
    return *table_size(played), int(played.reward_space.shape[0])


def vector(mdp: Any, state: Any, action: int, next_state: Any) -> Reals:
    """The vector of rewards of a transition, shape (n_objectives,).

    Raises:
        ValueError: `rewards` returns something else.
    """
    rewards = mdp.rewards(state, action, next_state)
    return an_array(f"what rewards of {class_name(mdp)} returns", rewards, mdp.reward_space.shape)

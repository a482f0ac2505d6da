"""The gate: what a user gives as an environment becomes a `Task`; later code does not inspect the input again."""

import math
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.checks.interfaces import HARMLESS, MDP_ONLY, NAMED, SHAPED, require_playable
from edugym.checks.mdps import CHECKED_STEPS, random_steps
from edugym.checks.parameters import coerced, whole_number
from edugym.mdp.tabular import space_of_row, table_sizes
from edugym.system.packages import is_own

MOST_CHECKED = 1_000_000
"""The most steps that `check_mdp` plays: it keeps every state."""


class Task(NamedTuple):
    """What a user gave as an environment, looked at once.

    Attributes:
        environment: the MDP or the Gymnasium environment, as given, or what its name resolves to.
        played: what training plays: the MDP, if that alone gives the same episodes, else the Gymnasium environment.
        is_mdp: whether `played` is an MDP; then its numbers are plain Python, not NumPy.
        is_own: whether it is an MDP made of nothing but the package's own classes.
        max_steps: the step at which an episode is truncated; None where there is no limit, or it is unknown.
    """

    environment: Any
    played: Any
    is_mdp: bool
    is_own: bool
    max_steps: int | None

    @property
    def table_shape(self) -> tuple[int, int]:
        """The shape (n_states, n_actions) of a table of action values.

        Raises:
            ValueError: observations are not whole numbers, or actions are not 0, 1, ...
        """
        actions = self.played.action_space
        if not isinstance(actions, spaces.Discrete) or actions.start != 0:
            raise ValueError(f"a table needs the actions 0, 1, ..., but the action space is {actions}")
        shown = self.played.observation_space
        return math.prod(table_sizes(shown if self.is_mdp else space_of_row(shown))), int(actions.n)

    @property
    def n_inputs(self) -> int:
        """How many numbers an observation is as a vector.

        Raises:
            ValueError: the observation cannot be made a vector.
        """
        return vector_length(self.played.observation_space)


def task_of(environment: Any, name: str = "environment", allowed: str = NAMED) -> Task:
    """Look at what a user gave as an environment, and refuse what is not one.

    Args:
        environment: an MDP, a Gymnasium environment, the name or id of one, or a `Task`, which is returned.
        name: the argument's name, for error messages.
        allowed: `MDP_ONLY`, `MADE`, `SHAPED` or `NAMED`; only the last takes names.

    Raises:
        ValueError: it is something else, or something in it is missing or not as it must be.
    """
    if isinstance(environment, Task):
        return environment
    if isinstance(environment, str) and allowed == NAMED:
        environment = gymnasium.make(full_id(environment))
    played = environment if allowed == MDP_ONLY else _played(environment)
    is_mdp = allowed == MDP_ONLY or not isinstance(played, gymnasium.Env)
    own = is_mdp and is_own(played)
    limit = require_playable(name, played, allowed, is_mdp=is_mdp, own=own)
    return Task(environment, coerced(played) if is_mdp else played, is_mdp, own, limit)


def _played(environment: Any) -> Any:
    """The MDP that alone gives the same episodes; the environment where that, or a wrapper, does more."""
    inside = bare(environment)
    if getattr(inside, "only_plays_its_mdp", False):
        return inside.mdp
    return environment if isinstance(inside, gymnasium.Env) else inside


def bare(environment: Any) -> Any:
    """What was given without the wrappers that change nothing."""
    while isinstance(environment, HARMLESS):
        environment = environment.env
    return environment


def full_id(name: str) -> str:
    """The Gymnasium id of an environment of the course; any other id stays as it is.

    The name alone (Boulder) is enough. The prefix `edugym:`, which tells Gymnasium to import this package, is removed.
    """
    name = name.removeprefix("edugym:")
    ours = f"edugym/{name.removesuffix('-v0')}-v0"
    return ours if ours in gymnasium.registry else name


def table_size(environment: Any) -> tuple[int, int]:
    """The shape (n_states, n_actions) of a table of action values for an environment.

    Args:
        environment: an MDP, a Gymnasium environment, or the shape itself.

    Raises:
        ValueError: it is not an environment, its observations are not whole numbers, or its actions are not 0, 1, ...
    """
    if is_shape(environment):
        return checked_shape(environment, "(n_states, n_actions)")
    return task_of(environment, allowed=SHAPED).table_shape


def is_shape(environment: Any) -> bool:
    """Whether two numbers (or what is meant so) were given in place of an environment."""
    return isinstance(environment, tuple) and not hasattr(environment, "_fields")


def checked_shape(shape: tuple[Any, ...], name: str) -> tuple[int, int]:
    """Refuse a shape that is not two whole numbers of 1 or more.

    Args:
        shape: what was given in place of an environment.
        name: what the two numbers are.

    Raises:
        ValueError: it is something else.
    """
    if len(shape) != 2 or not all(isinstance(size, int | np.integer) and size >= 1 for size in shape):
        raise ValueError(
            f"environment must be an environment or the shape {name} of a table, two whole numbers of 1 or more, but is"
            f" {shape!r}"
        )
    return int(shape[0]), int(shape[1])


def vector_length(space: spaces.Space[Any]) -> int:
    """How many numbers an element of a space is as a vector.

    Raises:
        ValueError: the observation cannot be made a vector.
    """
    if isinstance(space, spaces.Box):
        return math.prod(space.shape)
    try:
        if isinstance(space, spaces.MultiBinary):
            raise ValueError
        return sum(table_sizes(space))
    except ValueError:
        raise ValueError(
            f"a vector needs observations that are numbers, but the observation space is {space}"
        ) from None


def check_mdp(mdp: Any, n_steps: int = CHECKED_STEPS) -> list[Any]:
    """Play some random steps of a student's MDP, and check what its methods return.

    It plays a copy, with a random stream of its own.

    Args:
        mdp: the task.
        n_steps: how many steps to play, from 0 to 1 000 000.

    Returns:
        The states met, in order; an initial one first.

    Raises:
        ValueError: it is not an MDP, one of its methods returns what it may not, or the number is not as above.
    """
    n_steps = whole_number("n_steps", n_steps, 0, MOST_CHECKED)
    return random_steps(task_of(mdp, "mdp", MDP_ONLY).environment, n_steps)

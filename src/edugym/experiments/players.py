"""Agents of students, and policies that were written for Gymnasium alone: objects with `predict`, and functions."""

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
from gymnasium import spaces

from edugym.adapters.fitting import tabular
from edugym.checks.agents import is_action, wrong_action
from edugym.mdp.protocol import Random
from edugym.mdp.task import table_size


def is_policy(value: Any) -> bool:
    """Whether a value acts by `predict(observation)`, as models of Stable-Baselines3 do, and has no `act`."""
    return callable(getattr(value, "predict", None)) and not hasattr(value, "act")


def takes_observations(value: Any) -> bool:
    """Whether a value is a function from observations to actions: its one parameter says so."""
    try:
        needed = [one.name for one in inspect.signature(value).parameters.values() if one.default is one.empty]
    except (TypeError, ValueError):  # no function
        return False
    return not isinstance(value, type) and len(needed) == 1 and needed[0] in ("observation", "obs")


def made_by(make: Callable[[Any], Any], environment: Any) -> Any:
    """What a function makes for an environment.

    One that asks for `observation_space.n`, to make a table, gets an environment with the rows that `train` will
    show to its agent, even where the observations are several numbers.

    Raises:
        ValueError: it asks so, and the environment fits no table.
        Exception: what the function raises.
    """
    try:
        return make(environment)
    except AttributeError as error:
        if error.name != "n" or not isinstance(error.obj, spaces.Space):
            raise
    table_size(environment)  # says why it fits no table
    return make(tabular(environment))


class Player:
    """An agent that acts as a policy says, and learns nothing.

    Args:
        policy: a function from observations to actions, or an object with such a method `predict`. If `predict` has
            the parameter `state`, it returns a pair of the action and its memory, which is the `state` of the next
            call; `episode_start` and `deterministic` are those of Stable-Baselines3.
        environment: the environment, of which it takes the spaces.
    """

    tabular = False
    """It takes observations as the environment gives them."""

    def __init__(self, policy: Any, environment: Any) -> None:
        """See the class."""
        self._policy = policy
        self._takes = inspect.signature(policy.predict).parameters.keys() if is_policy(policy) else ()
        self._observed: spaces.Space[Any] = environment.observation_space
        self._acted: spaces.Space[Any] = environment.action_space
        self._memory: Any = None

    def act(self, state: Any, rng: Random) -> Any:
        """The action of the policy.

        Raises:
            ValueError: it is not in the action space.
        """
        observation = self._as_in_gymnasium(state)
        action = self._chosen(observation)
        if isinstance(self._acted, spaces.Discrete):
            action = _as_whole_number(action)
        if not is_action(self._acted, action):
            raise ValueError(wrong_action(_name_of(self._policy), self._acted, action, observation))
        return action if isinstance(self._acted, spaces.Discrete) else np.asarray(action, self._acted.dtype)

    def learn(self, reward: float) -> None:
        """Learn nothing."""

    def __deepcopy__(self, memo: Any) -> "Player":
        """The same policy, with a memory that is empty: evaluation plays each episode with a copy."""
        copied: Player = object.__new__(type(self))
        copied.__dict__ |= self.__dict__ | {"_memory": None}
        return copied

    def _chosen(self, observation: Any) -> Any:
        if not is_policy(self._policy):
            return self._policy(observation)
        first = np.array([self._memory is None])
        told = {"state": self._memory, "episode_start": first, "deterministic": True}
        answer = self._policy.predict(observation, **{name: told[name] for name in told if name in self._takes})
        if not isinstance(answer, tuple):
            return answer
        action, self._memory = answer
        return action

    def _as_in_gymnasium(self, state: Any) -> Any:
        """The observation as an element of the observation space; an MDP may show plain tuples of numbers."""
        if isinstance(self._observed, spaces.Box | spaces.MultiDiscrete | spaces.MultiBinary):
            return np.asarray(state, self._observed.dtype)
        return state


def _name_of(policy: Any) -> str:
    """What a message calls a policy."""
    if is_policy(policy):
        return f"predict of {type(policy).__name__}"
    return f"policy {getattr(policy, '__name__', type(policy).__name__)}"


def _as_whole_number(action: Any) -> Any:
    """Python's number for one of NumPy's, an array of one, True or False; any other action as it is."""
    if isinstance(action, np.ndarray) and action.size == 1:
        action = action.item()
    return int(action) if isinstance(action, int | np.integer | np.bool_) else action

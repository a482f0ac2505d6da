"""An environment in the form in which an agent takes it: vectors, rows of a table, or as it is."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.wrappers import FlattenObservation

from edugym.checks.contract import Contract, tables_of
from edugym.checks.parameters import in_short
from edugym.mdp.tabular import number_of_rows, parts_for_row, space_of_row, table_lows, table_sizes, tabular_mdp
from edugym.mdp.task import Task
from edugym.system.packages import package_of


def fitted(task: Task, contract: Contract) -> Task:
    """The task as an agent sees it.

    Raises:
        ValueError: the two do not fit each other.
    """
    if contract.takes_vectors:
        check_sizes(contract.agent, task)
        return task if task.is_mdp else task._replace(played=FlattenObservation(task.played))
    if not contract.tabular:
        return task
    _check_tables(contract, task)
    try:
        return task._replace(played=tabular(task.played))
    except ValueError as error:
        if contract.is_own:
            raise
        kind = type(contract.agent).__name__
        what = f"write `tabular = False` in the class {kind} if it takes such observations as they are"
        raise ValueError(f"{error}: {what}") from None


def check_sizes(agent: Any, task: Task) -> None:
    """Refuse an agent that takes vectors where it was made for another environment.

    Raises:
        ValueError: its `n_inputs` or `n_actions` are not those of the environment.
    """
    actions = task.played.action_space
    sizes = {"n_inputs": task.n_inputs}
    if isinstance(actions, spaces.Discrete | spaces.Box):
        sizes["n_actions"] = int(actions.n) if isinstance(actions, spaces.Discrete) else math.prod(actions.shape)
    for name, needed in sizes.items():
        given = getattr(agent, name, needed)
        if given != needed:
            raise ValueError(f"agent must be one for {name} = {needed}, as this environment has, but its is {given}")


def _check_tables(contract: Contract, task: Task) -> None:
    """Refuse a table that was made for another environment.

    A student's may have other rows, as where states are aggregated; but not a row for each state and too few actions.
    """
    kind = type(contract.agent)
    own, discrete = package_of(kind) == "edugym", isinstance(task.played.action_space, spaces.Discrete)
    for name, table in tables_of(contract.agent).items():
        if own and name in ("Q", "preferences"):
            if table.shape[-2:] != task.table_shape:
                raise ValueError(
                    f"agent must have a table {name} of shape {task.table_shape} for this environment, but its is"
                    f" {table.shape[-2:]}"
                )
        elif not own and name == "Q" and table.ndim == 2 and discrete:
            n_states, n_actions = task.table_shape
            if len(table) == n_states and table.shape[1] < n_actions:
                raise ValueError(
                    f"{name} of {kind.__name__} has the shape {table.shape}, but this environment has {n_states}"
                    f" observations and {n_actions} actions"
                )


def tabular(environment: Any) -> Any:
    """The MDP or Gymnasium environment with each observation replaced by the index of its row in a table.

    An MDP, or an environment of this package, whose observations are already 0, 1, ... is returned unchanged. Any other
    environment is wrapped, and the wrapper checks each observation.

    Raises:
        ValueError: the observations are not whole numbers, an MDP does not number them from 0, or the table would have
            2^63 rows or more.
    """
    if isinstance(environment, gymnasium.Env):
        space = environment.observation_space
        is_checked = hasattr(environment.unwrapped, "only_plays_its_mdp")  # an `MDPEnv`; those of others are checked
        is_table = isinstance(space, spaces.Discrete) and space.start == 0 and is_checked
        return environment if is_table else TabularObservation(environment)
    return tabular_mdp(environment)


class TabularObservation(gymnasium.ObservationWrapper[int, Any, Any]):
    """Number the observations of a Gymnasium environment 0, 1, ..., so that an agent can use them as rows of a table.

    The last number of an observation varies fastest: (i, j) of sizes (3, 4) becomes row 4 i + j. For an MDP,
    `edugym.Tabular` does the same.

    Args:
        env: an environment with a Discrete, MultiDiscrete or MultiBinary observation space, or a (nested) Tuple or a
            Dict of these; its parts come in the order of the space. Of a goal environment, such as Switches, these are
            the observation, then the desired goal: what is achieved follows from the observation. For others see
            `edugym.Discretised`, `edugym.Hashed`, and agents without a table.

    Raises:
        ValueError: the observation space is of another kind, or the table would have 2^63 rows or more.
    """

    def __init__(self, env: gymnasium.Env[Any, Any]) -> None:
        """See the class."""
        if not isinstance(env, gymnasium.Env):
            raise ValueError(f"env must be a Gymnasium environment, but is {in_short(env)}")
        super().__init__(env)
        space, shown = env.observation_space, space_of_row(env.observation_space)
        self._names = parts_for_row(space) if isinstance(space, spaces.Dict) else None
        self._sizes = table_sizes(shown)
        self._is_plain = isinstance(shown, spaces.Discrete)
        self._lows = [int(low) for low in table_lows(shown)]
        rows: spaces.Space[Any] = spaces.Discrete(number_of_rows(self._sizes))
        self.observation_space = rows

    def observation(self, observation: Any) -> int:
        """The row of the table that stands for an observation.

        Raises:
            ValueError: the observation is not in the observation space of the environment.
        """
        if self._is_plain and isinstance(observation, int | np.integer):
            row = int(observation) - self._lows[0]
            if 0 <= row < self._sizes[0]:
                return row
        parts = list(_numbers(observation if self._names is None else _parts(observation, self._names)))
        fits = len(parts) == len(self._lows) and all(
            _is_whole(part) and 0 <= int(part) - low < size
            for part, low, size in zip(parts, self._lows, self._sizes, strict=True)
        )
        if not fits:
            raise ValueError(
                f"observation {in_short(observation)} is not in the observation space {self.env.observation_space} that"
                f" {self.env.unwrapped} declares"
            )
        row = 0
        for part, low, size in zip(parts, self._lows, self._sizes, strict=True):
            row = row * size + int(part) - low
        return row


def _parts(observation: Any, names: tuple[str, ...]) -> tuple[Any, ...]:
    """The parts of a dictionary with these names; none if it lacks one."""
    has_all = isinstance(observation, Mapping) and all(name in observation for name in names)
    return tuple(observation[name] for name in names) if has_all else ()


def _numbers(observation: Any) -> Iterator[Any]:
    """The whole numbers in an observation: a number, an array, or a tuple of these, nested as it may be."""
    if isinstance(observation, tuple):
        for part in observation:
            yield from _numbers(part)
    else:
        yield from np.ravel(observation)


def _is_whole(part: Any) -> bool:
    """Whether a part of an observation is a whole number; 2.0 is one."""
    if isinstance(part, float | np.floating):
        return part.is_integer()
    return isinstance(part, int | np.integer | np.bool_)

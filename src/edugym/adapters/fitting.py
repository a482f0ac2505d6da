"""An environment in the form in which an agent takes it: vectors, rows of a table, or as it is."""

import math
from typing import Any

import gymnasium
from gymnasium import spaces
from gymnasium.wrappers import FlattenObservation, OrderEnforcing, PassiveEnvChecker

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.tabular_observation import tabular
from edugym.checks.mdps import is_own
from edugym.mdp.sizes import table_size, vector_length


def fitting(environment: Any, agent: Any, tables: dict[str, Any]) -> Any:
    """Return the MDP behind an environment if no wrapper changes it, else the environment, as an agent sees it.

    Args:
        environment: an MDP or a Gymnasium environment.
        agent: the agent.
        tables: its tables, by name.

    Raises:
        ValueError: they do not fit each other.
    """
    inside = environment
    while isinstance(inside, PassiveEnvChecker | OrderEnforcing):
        inside = inside.env
    if isinstance(inside, MDPEnv) and inside.only_plays_its_mdp:
        environment = inside.mdp
    if takes_vectors(agent):
        check_sizes(agent, environment)
        return FlattenObservation(environment) if isinstance(environment, gymnasium.Env) else environment
    if getattr(agent, "tabular", True) is False:
        return environment
    _check_tables(tables, agent, environment)
    try:
        return tabular(environment)
    except ValueError as error:
        if is_own(agent):
            raise
        what = f"write `tabular = False` in the class {type(agent).__name__} if it takes such observations as they are"
        raise ValueError(f"{error}: {what}") from None


def _check_tables(tables: dict[str, Any], agent: Any, environment: Any) -> None:
    """Refuse a table that was made for another environment.

    A student's may have other rows, as where states are aggregated; but not a row for each state and too few actions.
    """
    own, discrete = (
        type(agent).__module__.startswith("edugym.agents."),
        isinstance(environment.action_space, spaces.Discrete),
    )
    needed = {
        name: table
        for name, table in tables.items()
        if (own and name in ("Q", "preferences")) or (not own and name == "Q" and table.ndim == 2 and discrete)
    }
    shape = table_size(environment) if needed else (0, 0)
    for name, table in needed.items():
        if own and table.shape[-2:] != shape:
            raise ValueError(
                f"agent must have a table {name} of shape {shape} for this environment, but its is {table.shape[-2:]}"
            )
        if not own and len(table) == shape[0] and table.shape[1] < shape[1]:
            raise ValueError(
                f"{name} of {type(agent).__name__} has the shape {table.shape}, but this environment has"
                f" {shape[0]} observations and {shape[1]} actions"
            )


def takes_vectors(agent: Any) -> bool:
    """Whether an agent takes vectors of numbers: it has no table, and says how long they are."""
    return getattr(agent, "tabular", True) is False and hasattr(agent, "n_inputs")


def check_sizes(agent: Any, environment: Any) -> None:
    """Refuse an agent that takes vectors where it was made for another environment.

    Raises:
        ValueError: its `n_inputs` or `n_actions` are not those of the environment.
    """
    actions = environment.action_space
    sizes = {"n_inputs": vector_length(environment.observation_space)}
    if isinstance(actions, spaces.Discrete | spaces.Box):
        sizes["n_actions"] = int(actions.n) if isinstance(actions, spaces.Discrete) else math.prod(actions.shape)
    for name, needed in sizes.items():
        given = getattr(agent, name, needed)
        if given != needed:
            raise ValueError(f"agent must be one for {name} = {needed}, as this environment has, but its is {given}")

"""What an experiment does: the task of each repetition, and how the results describe task and agents."""

import hashlib
import inspect
import json
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium.envs.registration import load_env_creator

from edugym.adapters.registration import specification
from edugym.checks.contract import recorded
from edugym.checks.interfaces import MADE, a_class
from edugym.checks.parameters import a_dictionary
from edugym.checks.values import deep_copy
from edugym.mdp.task import task_of

Setting = bool | int | float | str

GIVE_A_FUNCTION = "each run has a copy: give a function"
"""How the message begins where a task or an agent cannot be copied; it goes on with "that makes ..."."""
LISTED = 32  # entries: larger tables are described by their shape and contents' hash


class ExperimentTask(NamedTuple):
    """The task of an experiment.

    Attributes:
        make: makes the environment for a `layout_seed`; where `has_layout` is False it is always the same one, as a
            copy.
        has_layout: whether the seed changes what is made.
        settings: its name and parameters, by the names of the columns of the table of results (with `layout_seed` if it
            is fixed).
        origin: the values that determine what `make` makes.
    """

    make: Callable[[int], Any]
    has_layout: bool
    settings: dict[str, Setting]
    origin: tuple[Any, ...]


class Repetition(NamedTuple):
    """What the runs of all methods in one repetition have in common.

    Attributes:
        number: 0, 1, ...
        seed: the seed of all random streams of the run.
        layout_seed: the seed of the task's layout, where it has one.
    """

    number: int
    seed: int
    layout_seed: int


class Planned(NamedTuple):
    """A run of the plan: a method in a repetition."""

    method: str
    repetition: Repetition


def planned_runs(methods: list[str], repetitions: int, seed: int) -> list[Planned]:
    """All runs in order; the seeds of the repetitions are independent streams from one number."""
    children = np.random.SeedSequence(seed).spawn(repetitions)
    seeds = [Repetition(i, *map(int, child.generate_state(2))) for i, child in enumerate(children)]
    return [Planned(method, repetition) for repetition in seeds for method in methods]


def task(environment: Any, parameters: Mapping[str, Any] | None = None) -> ExperimentTask:
    """The task that `environment` means.

    Args:
        environment: the name of an environment of this package ("Boulder"), an id that Gymnasium knows, an MDP, a
            Gymnasium environment, or a function that makes an MDP or an environment for a `layout_seed`.
        parameters: those of a name or id. With `layout_seed` among them, or none to choose, every repetition has one
            layout.

    Raises:
        ValueError: there is no such environment, it has no such parameter, or it is made already and takes none.
    """
    parameters = a_dictionary("parameters", parameters)
    if isinstance(environment, str):
        return _registered(environment, parameters)
    if parameters:
        raise ValueError(
            f"parameters can be given with the name of an environment only, but environment is {environment!r}"
        )
    if isinstance(environment, type):
        raise ValueError(
            f"environment must be an environment or a function that makes one, but is {a_class(environment)}"
        )
    if callable(environment) and not hasattr(environment, "action_space"):
        # The settings that layouts have in common: what differs, such as the grips of a wall, comes from the seed.
        make = _by_layout(environment)
        first, second = (_settings(make(layout_seed)).items() for layout_seed in (0, 1))
        return ExperimentTask(make, True, dict(setting for setting in first if setting in second), (environment,))
    task_of(environment)
    # A copy for each run: wrappers of MDPs have arrays to write into, which runs at the same time may not share.
    return ExperimentTask(
        lambda _: deep_copy(environment, f"{GIVE_A_FUNCTION} that makes one"),
        False,
        _settings(environment),
        (environment,),
    )


def _by_layout(function: Callable[..., Any]) -> Callable[[int], Any]:
    """A function that makes the environment for a `layout_seed`, passed by name where there is that parameter.

    Raises:
        ValueError: the function does not take one argument.
    """
    parameters = inspect.signature(function).parameters
    by_name = "layout_seed" in parameters
    try:
        inspect.signature(function).bind(layout_seed=0) if by_name else inspect.signature(function).bind(0)
    except TypeError:
        raise ValueError(
            "environment must be a function of layout_seed, such as lambda layout_seed: ..., but takes"
            f" ({', '.join(map(str, parameters.values()))})"
        ) from None

    def make(layout_seed: int) -> Any:
        made = function(layout_seed=layout_seed) if by_name else function(layout_seed)
        task_of(made, "the environment that the function makes", MADE)
        return made

    return make


def _settings(environment: Any) -> dict[str, Setting]:
    """The name and parameters of an environment."""
    if not isinstance(environment, gymnasium.Env):
        return described(environment, "environment")
    name = environment.spec.id if environment.spec else type(environment.unwrapped).__name__
    return {"environment": name, **_named(environment.spec.kwargs if environment.spec else {})}


def _registered(name: str, parameters: dict[str, Any]) -> ExperimentTask:
    """A task that is made anew for every repetition."""
    spec, allowed = specification(name, parameters)
    given = {**spec.kwargs, **parameters}
    has_layout = "layout_seed" in allowed and "layout_seed" not in given

    def make(layout_seed: int) -> Any:
        layout = {"layout_seed": layout_seed} if has_layout else {}
        return gymnasium.make(spec.id, disable_env_checker=True, **parameters, **layout)

    defaults = {key: value for key, value in allowed.items() if value is not inspect.Parameter.empty}
    settings = {"environment": spec.id, **_named({**defaults, **given})}
    default_layout = settings.pop("environment.layout_seed", None)
    if default_layout is not None and not has_layout:
        settings["layout_seed"] = default_layout
    entry = spec.entry_point if callable(spec.entry_point) else load_env_creator(str(spec.entry_point))
    return ExperimentTask(make, has_layout, settings, (spec, entry, parameters))


def _named(parameters: dict[str, Any]) -> dict[str, Setting]:
    """Parameters by the names of their columns; None says nothing."""
    return {f"environment.{key}": plain(value) for key, value in parameters.items() if value is not None}


def described(value: Any, name: str) -> dict[str, Setting]:
    """The settings of an MDP or agent: `{"agent": "QLearning", "agent.learning_rate": 0.1, ...}`.

    The fields of a NamedTuple are described in turn, each value once, without arrays of zeros, which are empty tables.
    Of other objects, the public attributes that are numbers, texts or booleans are described. A `VisitRecorder` is
    described as the agent in it.
    """
    value = recorded(value)
    seen: set[int] = set()

    def walk(part: Any, path: str) -> dict[str, Setting]:
        fields = getattr(part, "_fields", None) if isinstance(part, tuple) else None
        if fields is None:
            empty = part is None or (isinstance(part, np.ndarray) and not part.any())
            return {} if empty else {path: plain(part)}
        if id(part) in seen:
            return {}
        seen.add(id(part))
        below: dict[str, Setting] = {path: type(part).__name__}
        for field, inner in zip(fields, part, strict=True):
            below |= walk(inner, f"{path}.{field}")
        return below

    if isinstance(value, tuple):
        return walk(value, name)
    simple = {
        key: inner for key, inner in vars(value).items() if not key.startswith("_") and isinstance(inner, Setting)
    }
    return {name: type(value).__name__, **{f"{name}.{key}": inner for key, inner in simple.items()}}


def plain(value: Any) -> Setting:
    """A setting as a number or a text; of a long array, its shape and what it is filled with."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, np.ndarray):
        if value.size <= LISTED:
            value = value.tolist()
        elif (value == value.flat[0]).all():
            value = {"shape": value.shape, "filled_with": value.flat[0].item()}
        else:
            value = {"shape": value.shape, "sha256": hashlib.sha256(value.tobytes()).hexdigest()[:16]}
    return json.dumps(value, default=lambda other: type(other).__name__)

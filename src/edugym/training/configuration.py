"""What is done in an experiment: the task of each repetition, and how task and agents are described in the results."""

import copy
import hashlib
import inspect
import json
import platform
from collections.abc import Callable, Mapping
from importlib.metadata import PackageNotFoundError, version
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.registration import specification

Setting = bool | int | float | str

LISTED = 32  # entries: larger tables are described by their shape and contents' hash


class Task(NamedTuple):
    """The task of an experiment.

    Attributes:
        make: makes the environment for a `layout_seed`; where `has_layout` is False it is always the same one, as a
            copy.
        has_layout: whether the seed changes what is made.
        settings: its name and parameters, by the names of the columns of the table of results (with `layout_seed` if it
            is fixed).
    """

    make: Callable[[int], Any]
    has_layout: bool
    settings: dict[str, Setting]


def task(environment: Any, parameters: Mapping[str, Any] | None = None) -> Task:
    """The task that `environment` means.

    Args:
        environment: the name of an environment of this package ("Boulder"), an id that Gymnasium knows, an MDP, or a
            Gymnasium environment.
        parameters: those of a name or id. With `layout_seed` among them, or none to choose, every repetition has one
            layout.

    Raises:
        ValueError: there is no such environment, it has no such parameter, or it is made already and takes none.
    """
    if isinstance(environment, str):
        return _registered(environment, dict(parameters or {}))
    if parameters:
        raise ValueError(
            f"parameters can be given with the name of an environment only, but environment is {environment!r}"
        )
    if isinstance(environment, gymnasium.Env):
        name = environment.spec.id if environment.spec else type(environment.unwrapped).__name__
        given = environment.spec.kwargs if environment.spec else {}
        return Task(lambda _: copy.deepcopy(environment), False, {"environment": name, **_named(given)})
    return Task(lambda _: environment, False, described(environment, "environment"))


def _registered(name: str, parameters: dict[str, Any]) -> Task:
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
    return Task(make, has_layout, settings)


def _named(parameters: dict[str, Any]) -> dict[str, Setting]:
    """Parameters by the names of their columns; None is what says nothing."""
    return {f"environment.{key}": plain(value) for key, value in parameters.items() if value is not None}


def described(value: Any, name: str) -> dict[str, Setting]:
    """The settings of an MDP or agent: `{"agent": "QLearning", "agent.learning_rate": 0.1, "agent.exploration": ...}`.

    What a NamedTuple holds is described in turn, each part once, less arrays of zeros, which are empty tables; of other
    objects, the public attributes that are numbers, texts, or true or false. That an agent's visits are recorded is no
    setting.
    """
    value = getattr(value, "recorded", value)
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


def versions() -> str:
    """The versions of what the numbers depend on."""
    parts = [f"python {platform.python_version()}"]
    for package in ("edugym", "numpy", "numba", "gymnasium"):
        try:
            parts.append(f"{package} {version(package)}")
        except PackageNotFoundError:  # numba, where there is no compiler
            continue
    return ", ".join(parts)

"""The environments, found by their files in `edugym/envs`, and their registration with Gymnasium.

`envs/memory_corridor.py` holds the MDP `MemoryCorridor`, which becomes `edugym/MemoryCorridor-v0`. The first line of
the file says its challenge, and its lesson if it has one: "Boulder: exploration (lesson 1)."
"""

import dataclasses
import importlib
import inspect
import math
import pkgutil
import re
from collections.abc import Callable, Mapping
from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import gymnasium
from gymnasium.envs.registration import EnvSpec, load_env_creator

FIRST_LINE = re.compile(r"(?P<name>\w+): (?P<challenge>.+?)( \(lesson (?P<lesson>\d+[a-z]?)\))?\.$")


class Entry(NamedTuple):
    """One environment of the course.

    Attributes:
        name: its name; its Gymnasium id is `edugym/<name>-v0`.
        module: where its MDP of this name is.
    """

    name: str
    module: str

    @property
    def id(self) -> str:
        """The id for `gymnasium.make` and `gymnasium.make_vec`."""
        return f"edugym/{self.name}-v0"

    @property
    def challenge(self) -> str:
        """The one challenge that it isolates, from the first line of its file."""
        return self._from_first_line("challenge") or ""

    @property
    def lesson(self) -> str | None:
        """The number of its lesson, such as "1" or "0b", if it has one."""
        return self._from_first_line("lesson")

    def load_mdp(self) -> Any:
        """The class of its MDP."""
        return getattr(importlib.import_module(self.module), self.name)

    def load(self) -> Any:
        """Its Gymnasium class: `<name>Env` in its file, or else one that only adds the API to the MDP."""
        from edugym.adapters.gymnasium_env import gymnasium_class

        module = importlib.import_module(self.module)
        own = getattr(module, f"{self.name}Env", None)
        return gymnasium_class(self.load_mdp(), __name__) if own is None else own

    def _from_first_line(self, group: str) -> str | None:
        text = (importlib.import_module(self.module).__doc__ or "").strip().splitlines()
        match = FIRST_LINE.match(text[0]) if text else None
        return match[group] if match else None


def in_snake_case(name: str) -> str:
    """The file name of a class: memory_corridor for MemoryCorridor, q_learning for QLearning."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def _find_all() -> tuple[Entry, ...]:
    found = pkgutil.iter_modules([str(Path(__file__).parents[1] / "envs")])
    files = (module.name for module in found if module.name != "games")  # a folder: games of two players
    return tuple(Entry("".join(map(str.capitalize, file.split("_"))), f"edugym.envs.{file}") for file in files)


ENVIRONMENTS = _find_all()
"""Every environment, by name."""


def in_course_order() -> list[Entry]:
    """The environments by the numbers of their lessons, those without one last."""
    return sorted(ENVIRONMENTS, key=lambda entry: place_in_course(entry.lesson))


def place_in_course(lesson: str | None) -> tuple[float, str]:
    """What sorts lessons by their numbers: "0", "0b", "1", ... A lesson without a number comes last."""
    letter = "" if lesson is None else lesson.lstrip("0123456789")
    return (math.inf if lesson is None else int(lesson.removesuffix(letter))), letter


def register_environments() -> None:
    """Register every environment with Gymnasium; nothing else is imported. A second call does nothing."""
    for entry in ENVIRONMENTS:
        if entry.id not in gymnasium.registry:
            gymnasium.register(
                entry.id,
                entry_point=f"{__name__}:{entry.name}Env",
                vector_entry_point=f"{__name__}:make_{entry.name}_vector",
            )


def find(name: str) -> Entry:
    """The entry with this name or id.

    Raises:
        ValueError: there is none.
    """
    from edugym.checks.parameters import (
        in_short,  # as below: `import edugym` registers, and takes no longer than it must
    )

    for entry in ENVIRONMENTS:
        if isinstance(name, str) and name in (entry.name, entry.id):
            return entry
    known = ", ".join(entry.name for entry in ENVIRONMENTS)
    raise ValueError(f"name of an environment must be one of {known}, but is {in_short(name)}")


def specification(name: str, parameters: Mapping[str, Any]) -> tuple[EnvSpec, dict[str, Any]]:
    """The specification of an environment, and all of its parameters with their defaults.

    Args:
        name: of an environment of the course, or the id of any of Gymnasium's.
        parameters: the parameters to make it with.

    Raises:
        ValueError: there is no such environment, or it has no such parameter.
    """
    from edugym.mdp.task import full_id  # `import edugym` registers, and takes no longer than it must

    try:
        spec = gymnasium.spec(full_id(name))
        creator = load_env_creator(spec.entry_point) if isinstance(spec.entry_point, str) else spec.entry_point
    except gymnasium.error.Error as error:
        known = ", ".join(entry.name for entry in ENVIRONMENTS)
        raise ValueError(f"environment must be one of {known}, or an id of Gymnasium's; {error}") from error
    if creator is None:
        raise ValueError(f"environment must exist as a single one, but {name!r} is a vector of copies only")
    allowed = parameters_of(creator)
    open_ended = any(part.kind is part.VAR_KEYWORD for part in inspect.signature(creator).parameters.values())
    unknown = [key for key in parameters if key not in allowed]
    if unknown and not open_ended:
        raise ValueError(f"{name} has no parameter {unknown[0]!r}; it has {', '.join(allowed)}")
    return spec, allowed


def parameters_of(creator: Callable[..., Any]) -> dict[str, Any]:
    """The parameters of a task with their defaults. `render_mode` is left out: it changes nothing in the task."""
    parts = inspect.signature(creator).parameters
    return {name: part.default for name, part in parts.items() if name != "render_mode"}


def make_mdp(name: str, **parameters: Any) -> Any:
    """The MDP of an environment by its name: `make_mdp("Boulder", height=30)` is `Boulder.create(height=30)`.

    Args:
        name: its name, such as "Boulder", or its id, such as "edugym/Boulder-v0".
        **parameters: those of its `create`; the others have their defaults.

    Returns:
        The MDP: for `train`, `finite_model` and the `create` of agents.

    Raises:
        ValueError: there is no such environment, it has no such parameter, or one is not as its class says.
    """
    return make_environment(name, **parameters).mdp


def make_environment(name: str, **parameters: Any) -> Any:
    """An environment of the course without Gymnasium's wrappers.

    Raises:
        ValueError: as `make_mdp`.
    """
    entry = find(name)
    spec, _ = specification(name, {key: value for key, value in parameters.items() if key != "render_mode"})
    environment = entry.load()(**parameters)
    environment.spec = dataclasses.replace(spec, kwargs=dict(parameters))
    return environment


def _make_vector(
    entry: Entry,
    num_envs: int = 1,
    autoreset_mode: str = "NextStep",
    max_episode_steps: int | None = None,
    **parameters: Any,
) -> Any:
    from edugym.adapters.gymnasium_env import MDPEnv
    from edugym.adapters.vector_env import MDPVectorEnv

    env = entry.load()(**parameters)
    if not env.only_plays_its_mdp:  # copies do not wait, as Supermarket says
        env = MDPEnv(env.mdp, env.render_mode)
    return MDPVectorEnv(env, num_envs, autoreset_mode, max_episode_steps)


@cache
def __getattr__(name: str) -> Any:
    """`<name>Env` and `make_<name>_vector` for every environment: the names that Gymnasium and pickle look up."""
    for entry in ENVIRONMENTS:
        if name == f"make_{entry.name}_vector":
            return partial(_make_vector, entry)
        if name == f"{entry.name}Env":
            return entry.load()
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

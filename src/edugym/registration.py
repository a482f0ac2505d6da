"""The environments, in one table, and their registration with Gymnasium."""

import importlib
import inspect
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple

import gymnasium
from gymnasium.envs.registration import EnvSpec, load_env_creator


class Entry(NamedTuple):
    """One environment of the course.

    Attributes:
        name: its name; its Gymnasium id is `edugym/<name>-v0`.
        module: where its class `<name>Env` is.
        challenge: the one challenge that it isolates.
        lesson: the lesson that is about it.
    """

    name: str
    module: str
    challenge: str
    lesson: str

    @property
    def id(self) -> str:
        """What to pass to `gymnasium.make` and `gymnasium.make_vec`."""
        return f"edugym/{self.name}-v0"

    def load(self) -> Any:
        """Its Gymnasium class."""
        return getattr(importlib.import_module(self.module), f"{self.name}Env")


ENVIRONMENTS = (
    Entry("Boulder", "edugym.envs.boulder", "Exploration", "exploration"),
    Entry("Roadrunner", "edugym.envs.roadrunner", "Credit assignment: on- and off-policy", "on_off_policy"),
    Entry("Study", "edugym.envs.study", "Credit assignment: depth", "depth"),
    Entry("Catch", "edugym.envs.catch", "Dimensionality", "dimensionality"),
    Entry("MemoryCorridor", "edugym.envs.memory_corridor", "Partial observability", "memory"),
    Entry("Tamagotchi", "edugym.envs.tamagotchi", "Amount of signal", "signal"),
    Entry("Trashbot", "edugym.envs.trashbot.task", "Discrete and continuous", "discrete_continuous"),
    Entry("Golf", "edugym.envs.golf", "Stochasticity", "stochasticity"),
    Entry("Supermarket", "edugym.envs.supermarket", "Model-based reinforcement learning", "model_based"),
)


def register_environments() -> None:
    """Register every environment with Gymnasium; nothing else is imported. A second call does nothing."""
    for entry in ENVIRONMENTS:
        if entry.id not in gymnasium.registry:
            gymnasium.register(
                entry.id,
                entry_point=f"{entry.module}:{entry.name}Env",
                vector_entry_point=f"edugym.registration:make_{entry.name}_vector",
            )


def find(name: str) -> Entry:
    """The entry with this name or id.

    Raises:
        ValueError: there is none.
    """
    for entry in ENVIRONMENTS:
        if name in (entry.name, entry.id):
            return entry
    raise ValueError(f"environment must be one of {', '.join(e.name for e in ENVIRONMENTS)}, but is {name!r}")


def full_id(name: str) -> str:
    """The Gymnasium id of an environment of the course that is given by its name alone; any other id as it is.

    The prefix `edugym:`, by which Gymnasium is told to import this package, is taken off.
    """
    name = name.removeprefix("edugym:")
    return next((entry.id for entry in ENVIRONMENTS if entry.name == name), name)


def specification(name: str, parameters: Mapping[str, Any]) -> tuple[EnvSpec, dict[str, Any]]:
    """What Gymnasium knows of an environment, and all of its parameters with their defaults.

    Args:
        name: of an environment of the course, or the id of any of Gymnasium's.
        parameters: those that it is to be made with.

    Raises:
        ValueError: there is no such environment, or it has no such parameter.
    """
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
    """The parameters of a task with their defaults, as its class has them (how it is drawn is none)."""
    parts = inspect.signature(creator).parameters
    return {name: part.default for name, part in parts.items() if name != "render_mode"}


def make_mdp(name: str, **parameters: Any) -> Any:
    """The MDP of an environment, for experiments: `make_mdp("Boulder", height=30)`.

    Raises:
        ValueError: there is no such environment, it has no such parameter, or one is not as its class says.
    """
    return make_environment(name, **parameters).mdp


def make_environment(name: str, **parameters: Any) -> Any:
    """An environment of the course without Gymnasium's wrappers; errors are those of `make_mdp`."""
    entry = find(name)
    specification(name, {key: value for key, value in parameters.items() if key != "render_mode"})
    return entry.load()(**parameters)


def _make_vector(entry: Entry, num_envs: int = 1, autoreset_mode: str = "NextStep", **parameters: Any) -> Any:
    from edugym.adapters.vector_env import MDPVectorEnv

    return MDPVectorEnv(entry.load()(**parameters), num_envs, autoreset_mode)


def __getattr__(name: str) -> Any:
    """`make_<name>_vector` for every environment: Gymnasium asks for a name, where to find what makes its copies."""
    for entry in ENVIRONMENTS:
        if name == f"make_{entry.name}_vector":
            return partial(_make_vector, entry)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

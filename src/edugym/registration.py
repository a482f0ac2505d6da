"""The environments, in one table, and their registration with Gymnasium."""

import importlib
from functools import partial
from typing import Any, NamedTuple

import gymnasium


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
    Entry("Trashbot", "edugym.envs.trashbot", "Discrete and continuous", "discrete_continuous"),
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


def make_mdp(name: str, **parameters: Any) -> Any:
    """The MDP of an environment, for experiments: `make_mdp("Boulder", height=30)`.

    Raises:
        ValueError: there is no such environment, or a parameter is not as its class says.
    """
    return find(name).load()(**parameters).mdp


def _make_vector(entry: Entry, num_envs: int = 1, autoreset_mode: str = "NextStep", **parameters: Any) -> Any:
    from edugym.mdp.vector import MDPVectorEnv

    return MDPVectorEnv(entry.load()(**parameters), num_envs, autoreset_mode)


def __getattr__(name: str) -> Any:
    """`make_<name>_vector` for every environment: Gymnasium asks for a name, where to find what makes its copies."""
    for entry in ENVIRONMENTS:
        if name == f"make_{entry.name}_vector":
            return partial(_make_vector, entry)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

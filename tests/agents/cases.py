"""Every agent and every exploration strategy of the package, for the tests that hold for all of them.

Both are found by their files. `tests/agents/test_<name>.py` may describe an agent in a dictionary `CASES`, and says in
`STRATEGIES` how strategies are made for an environment.
"""

import importlib
import pkgutil
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

from edugym import QLearning, agents
from tests.agents.case import Case
from tests.agents.case import same as same


def package_classes(method: str) -> Iterator[type]:
    """Every NamedTuple class in `edugym.agents` that has such a method."""
    for module in pkgutil.iter_modules(agents.__path__, "edugym.agents."):
        for thing in vars(importlib.import_module(module.name)).values():
            mine = isinstance(thing, type) and thing.__module__ == module.name
            if mine and issubclass(thing, tuple) and hasattr(thing, method):
                yield thing


def _test_file(kind: type) -> ModuleType:
    """The test file of the file that a class is in."""
    return importlib.import_module(f"tests.agents.test_{kind.__module__.rpartition('.')[2]}")


def _described(kind: Any) -> dict[str, Case]:
    """The cases of an agent: as its test file has them, or as it is at its defaults."""
    described: dict[str, Case] = getattr(_test_file(kind), "CASES", {})
    return described or {kind.__name__: Case(kind, kind.create)}


def _exploring(make: Callable[[Any], Any]) -> Case:
    return Case(QLearning, lambda env: QLearning.create(env, exploration=make(env)))


STRATEGIES: dict[str, Callable[[Any], Any]] = {
    name: make for kind in package_classes("choose") for name, make in _test_file(kind).STRATEGIES.items()
}
AGENTS = {name: case for kind in package_classes("learn") for name, case in _described(kind).items()}

CASES: dict[str, Case] = {**AGENTS, **{f"QLearning, {name}": _exploring(make) for name, make in STRATEGIES.items()}}

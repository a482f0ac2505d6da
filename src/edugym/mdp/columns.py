"""Room for n values of one shape: a column for each number in it, which machine code reads and writes in place."""

import hashlib
import sys
from types import ModuleType
from typing import Any, NamedTuple, Protocol

import numpy as np


class Storage(Protocol):
    """Room for n values."""

    def load(self, i: int) -> Any:
        """The i-th value."""

    def store(self, i: int, value: Any) -> None:
        """Put a value in the i-th place."""


class Listed(NamedTuple):
    """Values of any shape, such as states that hold arrays, in a list."""

    values: Any

    def load(self, i: int) -> Any:
        """The i-th value."""
        return self.values[i]

    def store(self, i: int, value: Any) -> None:
        """Put a value in the i-th place."""
        self.values[i] = value


def columns(sample: Any, n: int) -> Storage:
    """Room for `n` values like `sample`: a number, or a (nested) tuple of numbers.

    The class is written for the sample, for example for a state (x, speed):

        def load(self, i):
            return (self.columns[0][i], self.columns[1][i],)
        def store(self, i, value):
            self.columns[0][i] = value[0]
            self.columns[1][i] = value[1]
    """
    arrays: list[np.ndarray[Any, Any]] = []
    kinds: dict[str, type] = {}
    stores: list[str] = []

    def walk(value: Any, path: str) -> str:
        if isinstance(value, tuple):
            inside = "".join(walk(part, f"{path}[{k}]") + ", " for k, part in enumerate(value))
            if not hasattr(value, "_fields"):
                return f"({inside})"
            kinds[f"Kind{len(kinds)}"] = type(value)
            return f"Kind{len(kinds) - 1}({inside})"
        stores.append(f"        self.columns[{len(arrays)}][i] = value{path}")
        arrays.append(np.zeros(n, np.asarray(value).dtype))
        return f"self.columns[{len(arrays) - 1}][i]"

    loaded = walk(sample, "")
    source = "\n".join(
        [
            "class Columns(NamedTuple):",
            "    columns: tuple",
            "    def load(self, i):",
            f"        return {loaded}",
            "    def store(self, i, value):",
            *stores,
        ]
    )
    storage: Storage = _module(source, kinds).Columns(tuple(arrays))
    return storage


def listed(values: list[Any]) -> Listed:
    """The values as they are, in a list that machine code can use where there is a compiler."""
    try:
        from numba.typed import List
    except ImportError:
        return Listed(values)
    return Listed(List(values))


def holds_arrays(value: Any) -> bool:
    """Whether there is an array anywhere in a value."""
    return isinstance(value, np.ndarray) or (isinstance(value, tuple) and any(map(holds_arrays, value)))


def _module(source: str, kinds: dict[str, type]) -> Any:
    """The module with this source: one for each source and classes, by a name that is the same in every process.

    The name lets the disk cache of machine code find the class again.
    """
    key = repr((source, [(kind.__module__, kind.__qualname__, id(kind)) for kind in kinds.values()]))
    stable = repr((source, [(kind.__module__, kind.__qualname__) for kind in kinds.values()]))
    name = f"edugym.mdp.columns_{hashlib.sha256(stable.encode()).hexdigest()[:16]}"
    module = sys.modules.get(name)
    if module is None or module.__dict__["key"] != key:
        module = ModuleType(name)
        module.__dict__.update(kinds, NamedTuple=NamedTuple, key=key)
        exec(source, module.__dict__)  # generated above from the sample's shape alone
        sys.modules[name] = module
    return module

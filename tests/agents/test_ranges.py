"""The range of every setting, written down once more: what is at its ends is allowed, and what is beyond is not."""

import importlib
import math
import pkgutil
from collections.abc import Iterator
from typing import Any, get_type_hints

import numpy as np
import pytest

from edugym import agents
from edugym.agents.settings import Range

RANGES = {
    "(0, 1]": ("learning_rate", "value_learning_rate", "rate"),
    "[0, 1]": ("REINFORCE.value_learning_rate", "discount", "trace_decay", "epsilon", "start", "end"),
    "(0, inf]": ("error_clip", "temperature"),
    "(0, inf)": ("spread", "clip"),
    "[0, inf)": ("bonus", "exploration_bonus", "threshold", "c", "constant", "entropy_bonus"),
    "[1, inf]": ("NStepSARSA.n",),
    "[1, inf)": (
        "TreeBackup.n", "learn_every", "learn_from", "copy_every", "known_after", "explore_steps", "steps",
        "num_envs", "length", "epochs", "minibatches", "hidden",
    ),
    "[-1e+300, 1e+300]": ("risk", "highest_return", "lowest_return"),
}  # fmt: skip
"""By their ends: the settings of these names, or of one class."""
EXPECTED = {name: ends for ends, names in RANGES.items() for name in names}


def ranges() -> Iterator[tuple[str, str, Range]]:
    """Every range in the annotations of agents and strategies, with the class and the field."""
    modules = [module.name for module in pkgutil.iter_modules(agents.__path__, "edugym.agents.")]
    for module in (*modules, "edugym.deep.ppo"):
        if module == "edugym.deep.ppo":
            pytest.importorskip("torch")
        for thing in vars(importlib.import_module(module)).values():
            if isinstance(thing, type) and hasattr(thing, "_fields") and thing.__module__ == module:
                for field, hint in get_type_hints(thing, include_extras=True).items():
                    marks: tuple[Any, ...] = getattr(hint, "__metadata__", ())
                    yield from ((thing.__name__, field, mark) for mark in marks if isinstance(mark, Range))


def allows(mark: Range, value: float) -> bool:
    """Whether a value is in a range."""
    try:
        mark.check("x", value)
    except ValueError:
        return False
    return True


def test_the_ends_of_every_range() -> None:
    """A rate of 0 learns nothing, a clip of 0 has no gradient, and a discount of 0 is legitimate."""
    wrong, found = [], set()
    for kind, field, mark in ranges():
        name = f"{kind}.{field}" if f"{kind}.{field}" in EXPECTED else field
        ends = EXPECTED[name]
        low, high = map(float, ends[1:-1].split(","))
        found.add(name)
        inside = {low: ends[0] == "[", high: ends[-1] == "]", np.nextafter(low, -math.inf): False, math.nan: False}
        inside |= {np.nextafter(low, math.inf): True, min(high, 1e300): ends[-1] == "]" or high == math.inf}
        inside |= {} if high == math.inf else {np.nextafter(high, math.inf): False}
        wrong += [f"{kind}.{field}: {value}" for value, allowed in inside.items() if allows(mark, value) != allowed]
    assert wrong == []
    assert found == set(EXPECTED)

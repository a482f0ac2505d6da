"""The range of every setting: what is at its ends is allowed, and what is beyond is refused, also by `create`."""

import importlib
import math
import pkgutil
import re
from collections.abc import Iterator
from typing import Any, get_type_hints

import numpy as np
import pytest

from edugym import (
    DQN,
    REINFORCE,
    UCB,
    Dutch,
    DynaQ,
    GoExplore,
    Greedy,
    NStepSARSA,
    PrioritisedSweeping,
    QLambda,
    QLearning,
    RMax,
    SARSALambda,
    TreeBackup,
    agents,
)
from edugym.agents.settings import Range
from tests.agents.cases import AGENTS

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


def ranges() -> Iterator[tuple[type, str, Range]]:
    """Every range in the annotations of agents and strategies, with the class and the field."""
    modules = [module.name for module in pkgutil.iter_modules(agents.__path__, "edugym.agents.")]
    for module in (*modules, "edugym.deep.ppo"):
        if module == "edugym.deep.ppo":
            pytest.importorskip("torch")
        for thing in vars(importlib.import_module(module)).values():
            if isinstance(thing, type) and hasattr(thing, "_fields") and thing.__module__ == module:
                for field, hint in get_type_hints(thing, include_extras=True).items():
                    marks: tuple[Any, ...] = getattr(hint, "__metadata__", ())
                    yield from ((thing, field, mark) for mark in marks if isinstance(mark, Range))


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
        name = f"{kind.__name__}.{field}" if f"{kind.__name__}.{field}" in EXPECTED else field
        if name not in EXPECTED:
            continue  # of a new agent, whose own test says what it allows
        ends = EXPECTED[name]
        low, high = map(float, ends[1:-1].split(","))
        found.add(name)
        inside = {low: ends[0] == "[", high: ends[-1] == "]", np.nextafter(low, -math.inf): False, math.nan: False}
        inside |= {np.nextafter(low, math.inf): True, min(high, 1e300): ends[-1] == "]" or high == math.inf}
        inside |= {} if high == math.inf else {np.nextafter(high, math.inf): False}
        wrong += [f"{name}: {value}" for value, allowed in inside.items() if allows(mark, value) != allowed]
    assert wrong == []
    assert found == set(EXPECTED)


@pytest.mark.parametrize("kind", sorted({case.kind for case in AGENTS.values()}, key=str))
def test_settings_out_of_range_are_refused(kind: Any) -> None:
    """Every field with a range; the message names it and its value."""
    for _, field, _ in (found for found in ranges() if found[0] is kind):
        for value in (-math.inf, math.nan, "0.1", None, True):
            with pytest.raises(ValueError, match=rf"{field} must be .*, but is {re.escape(repr(value))}"):
                kind.create((4, 2), **{field: value})


OWN: list[tuple[Any, str, tuple[Any, ...]]] = [
    (DQN, "hidden", (0, 2.5, "8")),
    (DQN, "memory_size", (0, 2.5)),
    (DQN, "batch_size", (0, 2.5)),
    (DynaQ, "planning_steps", (math.inf, -1, 2.5)),
    (DynaQ, "planning_seconds", (0,)),
    (DynaQ, "memory", (0,)),
    (DynaQ, "expected_updates", (1,)),
    (GoExplore, "longest", (0,)),
    (NStepSARSA, "n", (0, 2.5)),
    (NStepSARSA, "longest", (0,)),
    (PrioritisedSweeping, "planning_steps", (-1, 2.5, 2**70)),
    (PrioritisedSweeping, "planning_seconds", (-1.0,)),
    (PrioritisedSweeping, "expected_updates", ("yes",)),
    (QLambda, "traces", (Dutch,)),
    (QLearning, "initial_value", ("1", None, math.nan, math.inf, True)),
    (REINFORCE, "longest", (0,)),
    (RMax, "planning_seconds", (0,)),
    (RMax, "lowest_return", (101.0,)),
    (SARSALambda, "traces", ("replacing",)),
    (TreeBackup, "n", (1.5,)),
]
"""What `create` itself looks at."""


@pytest.mark.parametrize(("kind", "name", "values"), OWN, ids=lambda part: getattr(part, "__name__", None))
def test_other_settings_are_refused(kind: Any, name: str, values: tuple[Any, ...]) -> None:
    """Likewise by name and value."""
    for value in values:
        with pytest.raises(ValueError, match=rf"{name} must be .*but is {re.escape(repr(value))}"):
            kind.create((4, 2), **{name: value})


@pytest.mark.parametrize(("policy", "given"), [(UCB.create((4, 2)), "UCB"), (Greedy, "the class Greedy")])
def test_a_target_policy_has_probabilities(policy: Any, given: str) -> None:
    """UCB has none, and a class is none."""
    with pytest.raises(ValueError, match=f"target_policy must be a strategy that knows .*but is {given}$"):
        TreeBackup.create((4, 2), target_policy=policy)

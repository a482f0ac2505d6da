"""What the test file of an environment says of its parameters, for the contract tests."""

from collections.abc import Callable
from dataclasses import dataclass, field
from math import nan
from typing import Any

from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

Keywords = dict[str, Any]


@dataclass(frozen=True)
class Bad:
    """A parameter value that must be refused, alone or where the others are as given."""

    name: str
    value: Any
    given: Keywords = field(default_factory=dict)


@dataclass(frozen=True)
class Parameters:
    """What an environment's constructor takes.

    Attributes:
        valid: draws small tasks of all kinds.
        corners: the defaults and the extremes; every parameter is in one of them at least.
        bad: what must be refused, with a ValueError that names the parameter and the value; likewise.
        finite: tasks with a finite model, small enough to look at every state and action; empty if there is none.
        layout: parameters with which the layout seed makes a difference, to the task or to its model.
        random: whether what happens depends on the seed of `reset`. With the default parameters 40 steps of play must
            show it.
        endless: whether no state is terminal, so that only the step limit ends an episode.
        informed: an action from `info` and the environment, for tasks of which random play alone would see little.
    """

    valid: SearchStrategy[Keywords]
    corners: tuple[Keywords, ...]
    bad: tuple[Bad, ...]
    finite: tuple[Keywords, ...] = ()
    layout: Keywords = field(default_factory=dict)
    random: bool = True
    endless: bool = False
    informed: Callable[[dict[str, Any], Any], Any] | None = None


def refused(name: str, *values: Any, **given: Any) -> tuple[Bad, ...]:
    """Several bad values of one parameter."""
    return tuple(Bad(name, value, given) for value in values)


NO_WHOLE_NUMBER = (0.5, "1", None, True, nan)
"""What no whole number may be."""
NO_STEPS = (0, -1, 2**62 + 1, 10**400, 0.5, "1", True, nan)
"""What no number of steps may be."""

LAYOUT_SEEDS = st.integers(0, 2**32)

"""What the contract tests need to know of an agent: its test file may describe it in `CASES`."""

from collections.abc import Callable
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium.wrappers import FlattenObservation

from edugym.adapters.fitting import tabular
from edugym.checks.contract import takes_vectors


class Case(NamedTuple):
    """An agent to test.

    Attributes:
        kind: its class.
        create: makes a new one for an environment (or the shape of its table).
        estimates_return: whether its Q(s, a) estimates the discounted return at learning rate and discount 0.5, for
            which there are closed forms.
        real_actions: whether its actions are real numbers: it is then tested in environments that have such.
    """

    kind: Any
    create: Callable[[Any], Any]
    estimates_return: bool = False
    real_actions: bool = False

    @property
    def vectors(self) -> bool:
        """Whether it takes observations as vectors of numbers."""
        return takes_vectors(self.create((2, 2)))

    def fit(self, environment: Any) -> Any:
        """An MDP or Gymnasium environment with observations as `train` shows them to the agent."""
        if not self.vectors:
            return tabular(environment)
        return FlattenObservation(environment) if isinstance(environment, gymnasium.Env) else environment


def same(one: Any, other: Any) -> bool:
    """Whether two agents (or any nested tuples) are of the same classes and equal to the last bit, NaN included."""
    if type(one) is not type(other):
        return False
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, np.ndarray):
        return bool(one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes())
    if isinstance(one, np.random.Generator):
        return bool(one.bit_generator.state == other.bit_generator.state)
    return bool(one == other)

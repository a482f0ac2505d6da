"""Agents whose tables do not change are doubted only where that is a slip."""

import functools
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from edugym import train
from tests.training.tasks import Ring


class Silent:
    """An agent that always does the same, with what it is given as tables."""

    def __init__(self, **tables: Any) -> None:
        """See the class."""
        vars(self).update(tables)

    def act(self, state: Any, rng: Any) -> int:
        """The first."""
        return 0


class Thinking(Silent):
    """It computes something and stores nothing."""

    def learn(self, state: Any, reward: float) -> None:
        """A number that is gone."""
        _ = state + reward


class Adding(Silent):
    """It adds to all its weights at once."""

    weights: Any

    def learn(self, reward: float) -> None:
        """Without an index."""
        self.weights += reward


class Counting(Silent):
    """It has a number, and no table."""

    total = 0.0

    def learn(self, reward: float) -> None:
        """Count."""
        self.total = self.total + reward


class Lent(Silent):
    """What it learns by is no method."""

    def __init__(self, **tables: Any) -> None:
        """See the class."""
        super().__init__(**tables)
        self.learn = functools.partial(_ignored, 2)


def _ignored(factor: int, reward: float) -> None:
    _ = factor * reward


def test_one_that_thinks_and_stores_nothing_is_doubted() -> None:
    """The control: it has a table."""
    with pytest.warns(UserWarning, match="learn of Thinking has changed nothing in Q in 1000 steps"):
        train(Ring(), Thinking(Q=np.zeros((2, 2))), 1_000)


@pytest.mark.parametrize(
    "make",
    [
        lambda: Thinking(weights=np.zeros(1)),
        lambda: Adding(weights=np.zeros(3)),
        lambda: Adding(weights=np.arange(3.0), Q=np.zeros((2, 2))),
        lambda: Counting(),
        lambda: Lent(Q=np.zeros((2, 2))),
    ],
    ids=["one number", "all at once", "one table of two", "no table", "no method"],
)
def test_others_are_not(make: Callable[[], Any]) -> None:
    """They have no table to fill, fill it in another way, or cannot be looked into."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*cannot be compiled")
        train(Ring(), make(), 1_000)


@pytest.mark.parametrize(
    "tables",
    [{"Q": np.zeros(2)}, {"V": np.zeros((2, 1))}, {"Q": np.zeros((3, 1))}, {"weights": np.ones((2, 1))}],
    ids=["a value of each state", "values in a column", "other rows", "weights"],
)
def test_only_a_table_of_states_and_actions_must_have_their_numbers(tables: dict[str, Any]) -> None:
    """What has another form or name may be of any size."""
    assert train(Ring(), Adding(**{"weights": np.arange(3.0), **tables}), 10).complete

"""Copies, putting back, and comparing: what is shared stays shared, and a last digit is no difference."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym.compiled.copies import Snapshot, copied, difference


class Agent(NamedTuple):
    """Tables that are views of one memory, and a stream."""

    Q: Any
    row: Any
    column: Any
    rng: Any


def agent(order: str = "C") -> Agent:
    """One of them."""
    Q = np.asarray(np.arange(12.0).reshape(3, 4), order="F" if order == "F" else "C")
    return Agent(Q, Q[1], Q[:, 2][::-1], np.random.default_rng(0))


@pytest.mark.parametrize("order", ["C", "F"])
def test_views_stay_views(order: str) -> None:
    """A change of one table shows in its views, in the copy as in the original, and in nothing else."""
    original = agent(order)
    copy = copied((original, original.rng))
    assert difference(copy[0], original, "") is None
    copy[0].row[2] = 100.0
    assert copy[0].Q[1, 2] == copy[0].column[1] == 100.0
    assert original.Q[1, 2] == 6.0
    assert copy[0].rng is copy[1]
    copy[1].random()
    assert original.rng.bit_generator.state != copy[1].bit_generator.state


def test_put_back() -> None:
    """Tables, views and streams are as they were, each time; what cannot be written to is left alone."""
    original, before = agent(), Snapshot()
    original.Q.flags.writeable = False
    for _ in range(2):
        before.take((original, 3))
        original.row[:] = 7.0
        original.rng.random()
        before.put_back()
        assert difference(original, agent(), "") is None
    before.take(original._replace(Q=np.zeros(2)))
    original.column[:] = 1.0
    before.put_back()
    assert difference(original, agent(), "") is None


def test_difference_names_what_differs() -> None:
    """The first field that differs is named; a stream is one."""
    one = agent()
    changes: list[tuple[Callable[[Agent], Any], str]] = [
        (lambda other: other.Q.__setitem__((2, 3), 5.0), "Q"),
        (lambda other: other.rng.random(), "a random stream"),
    ]
    for change, name in changes:
        other = agent()
        change(other)
        assert difference(one, other, "the agent") == name
    assert difference((1, 2.0), (1, 3.0), "x") == "x[1]"
    assert difference((1,), (1, 2), "x") == "x"
    assert difference("a", "b", "x") == "x"
    assert difference(None, None, "x") is None
    assert difference(np.nan, np.nan, "x") is None


def test_last_digits() -> None:
    """Real numbers may differ in their last digits, whole ones may not."""
    table = np.array([1.0, 1e6])
    assert difference(table, table * (1 + 1e-15), "x") is None
    assert difference(table, table * (1 + 1e-9), "x") == "x"
    assert difference(2**60, 2**60 + 1, "x") == "x"

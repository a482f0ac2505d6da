"""Copies, putting back, and comparing: what is shared stays shared, and a last digit is no difference."""

import traceback
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
from numba.typed import List

from edugym.compiled import execution
from edugym.compiled.snapshot import LARGE, Snapshot, copied, difference
from tests.compiled.cells import cell

RNG = np.random.default_rng(0)


class Agent(NamedTuple):
    """Tables that are views of one memory, and a stream."""

    Q: Any
    row: Any
    column: Any
    rng: Any


def agent(order: Any = "C") -> Agent:
    """One of them."""
    Q = np.asarray(np.arange(12.0).reshape(3, 4), order=order)
    return Agent(Q, Q[1], Q[:, 2][::-1], np.random.default_rng(0))


@pytest.mark.parametrize("order", ["C", "F"])
def test_views_stay_views(order: Any) -> None:
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
    original.row.flags.writeable = False  # a loop that writes there fails when it is tried, and not later
    assert [part.flags.writeable for part in copied(original)[:3]] == [True, False, True]


def test_arrays_of_other_kinds() -> None:
    """One of objects, and one that skips parts of a memory that is no array's: a copy shares nothing with them."""
    objects = np.array([[1], None], dtype=object)
    copied(objects)[0].append(2)
    assert objects[0] == [1]
    skipping = np.lib.stride_tricks.as_strided(np.arange(6.0), (3,), (16,))
    copy = copied(skipping)
    copy[0] = 7.0
    assert (skipping[0], *copy) == (0.0, 7.0, 2.0, 4.0)


def test_another_number_of_values() -> None:
    """A call with fewer, and with more."""
    before, tables, left = Snapshot(), [np.zeros(3) for _ in range(3)], np.zeros(LARGE // 8)
    for count in (2, 1, 3):
        before.take((*tables[:count], left), large=count > 1)
        for table in tables[:count]:
            table += 1.0
        before.put_back()
        assert not np.any(tables)


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


@pytest.mark.parametrize("then", [np.zeros(3, np.int64), np.zeros(4), np.zeros((3, 1)), RNG, List([1.0, 2.0])])
@pytest.mark.parametrize("first", [np.zeros(3), np.zeros(3, np.int8), np.zeros(1), RNG])
def test_memory_is_used_again_only_for_what_fits(first: Any, then: Any) -> None:
    """After other arrays, types, shapes or streams, all of the values is put back."""
    kept, was = Snapshot(), copied(then)
    kept.take((first,))
    kept.take((then,))
    if isinstance(then, np.random.Generator):
        then.random()
    else:
        then[0] = 5
    kept.put_back()
    assert difference(then, was, "x") is None
    assert getattr(then, "dtype", None) == getattr(was, "dtype", None)


@pytest.mark.parametrize(
    ("one", "other", "name"),
    [
        (agent(), agent()._replace(Q=np.zeros((3, 4))), "Q"),
        (agent(), agent()._replace(rng=np.random.default_rng(1)), "a random stream"),
        ((1, 2.0), (1, 3.0), "x[1]"),
        ((1,), (1, 2), "x"),
        ((1, 2), 3, "x"),
        (3, (1, 2), "x"),
        (np.ones(2), 1.0, "x"),
        ("a", "b", "x"),
        (np.array([1, None]), np.array([2, None]), "x"),
        (np.array([1, None]), np.array([1, None]), None),
        (np.nan, np.nan, None),
        (np.array([1.0, 1e6]), np.array([1.0, 1e6]) * (1 + 1e-15), None),
        (np.array([1.0, 1e6]), np.array([1.0, 1e6]) * (1 + 1e-9), "x"),
        (2**60, 2**60 + 1, "x"),
        (1, 1 + 1e-15, None),
        (1 + 1e-15, 1, None),
        (1e-10, 1.5e-10, "x"),
        (np.array([1e-7, 1e6]), np.array([1.5e-7, 1e6]), None),  # the last digits of a sum with the other
        (1.7e308, -1.7e308, "x"),
    ],
)
def test_differences(one: Any, other: Any, name: str | None) -> None:
    """Real numbers may differ in their last digits, whole ones may not."""
    assert difference(one, other, "x") == name


def test_large_arrays_may_be_left_out() -> None:
    """Small ones and streams are put back; the next whole one is whole again."""
    large, small, rng = np.zeros(LARGE // 8), np.zeros(3), np.random.default_rng(0)
    state, kept = rng.bit_generator.state, Snapshot()
    for with_large in (True, False, True):
        large[:] = 0.0
        kept.take((1, (large, small), rng), large=with_large)
        assert kept.is_whole == with_large
        large += 1.0
        small += 1.0
        rng.random()
        kept.put_back()
        assert rng.bit_generator.state == state
        assert not small.any()
        assert large.any() != with_large


TAKER = """
class Taker(NamedTuple):
    table: np.ndarray
    memory: np.ndarray
    def take(self, rng):
        self.table[0] += 1
        self.memory[0] += 1.0
        return {}
"""


def call(n: int, taker: Any, rng: np.random.Generator) -> float:
    """Take n times."""
    total = 0.0
    for _ in range(n):
        total += taker.take(rng)
    return total


def taker(step: str, large: bool, monkeypatch: pytest.MonkeyPatch) -> tuple[Any, Callable[..., float]]:
    """A value with a large table, which is copied before each call or never, and the machine code of a loop over it."""
    monkeypatch.setattr(execution, "COPY_EVERY", 1e-9 if large else np.inf)
    thing = cell(TAKER.format(step))["Taker"](np.zeros(1, np.int64), np.zeros(LARGE // 8))
    run = execution.executable(call, (thing, RNG))
    assert run is not call
    return thing, run


@pytest.mark.parametrize("large", [True, False])
def test_a_late_mistake_with_a_large_table(large: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """It shows the student's line, whether the table was copied before the call or not."""
    thing, run = taker(f"self.memory[{LARGE} * (self.table[0] > 3_500)]", large, monkeypatch)
    for _ in range(2):
        run(1_000, thing, RNG)
    with pytest.raises(IndexError, match="out of bounds") as error:
        run(2_000, thing, RNG)
    assert traceback.extract_tb(error.value.__traceback__)[-1].name == "take"
    assert thing.table[0] == 3_501
    assert thing.memory[0] == (3_501 if large else 5_002)  # what the failed call had done to it is still there


@pytest.mark.parametrize("large", [True, False])
def test_where_only_machine_code_stops(large: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Python counts on beyond 64 bits; from tables that were not kept that would be another run: an error says so."""
    thing, run = taker("1.0 * (4_611_686_018_427_387_904 * (1 + int(self.table[0] > 1_500)))", large, monkeypatch)
    run(1_000, thing, RNG)
    if large:
        assert run(1_000, thing, RNG) == 1_500 * 2.0**62
    else:
        with pytest.raises(RuntimeError, match=r"tables are too large to be kept .*NUMBA_DISABLE_JIT=1"):
            run(1_000, thing, RNG)

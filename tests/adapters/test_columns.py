"""Room for n states: what is stored comes back, in columns of numbers where that can be."""

import copy
import pickle
import subprocess
import sys
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym.adapters.columns import columns, copy_of, head, listed, loose, storage
from tests.contract.play import plain


class Pair(NamedTuple):
    """Two values."""

    first: Any
    second: Any


class Turned(NamedTuple):
    """Two values under other names."""

    second: Any
    first: Any


NUMBERS = st.integers(-(2**62), 2**62) | st.floats(allow_nan=False) | st.booleans()
STATES = st.recursive(
    NUMBERS, lambda inner: st.lists(inner, max_size=3).map(tuple) | st.builds(Pair, inner, inner), max_leaves=6
)


def kinds(state: Any) -> Any:
    """The classes of the tuples in a state, and the types of its numbers."""
    return (type(state), [*map(kinds, state)]) if isinstance(state, tuple) else type(plain(state))


@given(state=STATES, n=st.integers(1, 4))
def test_what_is_stored_comes_back(state: Any, n: int) -> None:
    """Any state of numbers is loaded as it was stored: the same classes, values and types of numbers."""
    room = columns(state, n)
    assert all(room.store(i, state) for i in range(n))
    for one in (room, copy.deepcopy(room), pickle.loads(pickle.dumps(room)), copy_of(room)):
        assert [(plain(one.load(i)), kinds(one.load(i))) for i in range(n)] == [(plain(state), kinds(state))] * n


def test_another_process_can_read_them() -> None:
    """What is pickled is read in a process that has never seen such states."""
    room = storage([(1, (0.5, True))], 3)
    room.store(2, (7, (0.25, False)))
    code = "import pickle, sys; print(pickle.loads(bytes.fromhex(sys.argv[1])).load(2))"
    command = [sys.executable, "-c", code, pickle.dumps(room).hex()]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout == f"{room.load(2)}\n"


@pytest.mark.parametrize(
    ("states", "later"),
    [
        ([0, 0.5], 0.25), ([False, 2], 3),
        ([Pair(0, (1, 2)), Pair(0.5, (1, 2)), Pair(1, (True, 2.5))], Pair(0.25, (7, 0.125))), ([2**63, 3], 4),
        ([3, -(2**63) - 1], 2**70), (["left", "right"], "straight on"), ([(), (1,)], (1, 2, 3)),
        ([Pair(1, 2), (1, 2)], Pair(5, 6)), ([Pair((1,), 2), Turned((1,), 2)], Pair((3,), 4)),
        ([Pair(np.zeros(2), 0), Pair(np.ones(3), 0.5)], Pair(np.ones(5), 0.25)),
        ([Pair(np.zeros(2), 0), Pair(np.ones((3, 2)), 1)], Pair(np.ones(5), 1)),
    ],
)  # fmt: skip
def test_states_of_several_kinds(states: list[Any], later: Any) -> None:
    """There is room for all the states that were tried, and for others of their kinds; the places are apart."""
    room = storage(states, 2)
    room.store(0, states[0])
    for state in (*states, later):
        assert room.store(1, state)
        assert plain(room.load(1)) == plain(state)
        assert not isinstance(state, tuple) or type(room.load(1)) is type(state)
    assert plain([room.load(0), pickle.loads(pickle.dumps(room)).load(1)]) == plain([states[0], later])


@pytest.mark.parametrize(
    ("sample", "stored", "kept"),
    [((0, 0), (0, 0.5), False), ((0, 0), (1,), False), ((0, 0), (1, 2, 3), False),
     ((0, (0, 0)), (1, (2.5, 3)), False), ((0, (0, 0)), (1, (2, 3, 4)), False), ((0.0, 0), (np.nan, 1), True)],
)  # fmt: skip
def test_columns_tell_of_a_loss(sample: Any, stored: Any, kept: bool) -> None:
    """A fraction among whole numbers, or another number of parts; not so in our own tasks, which are not checked."""
    assert columns(sample, 2).store(1, stored) == kept
    if len(stored) == len(sample):
        assert columns(sample, 2, checked=False).store(1, stored)


@pytest.mark.parametrize("kind", [listed, loose])
def test_copies_of_listed_values(kind: Any) -> None:
    """All or the first ones, in storage of the same type; what is stored in a copy stays out of the original."""
    storage = kind([(k, np.array([0.5 * k])) for k in range(4)])
    for copied, n in ((copy_of(storage), 4), (head(storage, 2), 2)):
        assert type(copied.values) is type(storage.values)
        assert [copied.load(i)[0] for i in range(n)] == [*range(n)]
        assert len(copied.values) == n
        assert copied.store(1, (9, np.array([1.5])))
        assert (copied.load(1)[0], storage.load(1)[0]) == (9, 1)


@pytest.mark.parametrize(
    ("stored", "value", "kept"),
    [
        ((2, (np.nan, np.ones(2))), (2, (np.nan, np.zeros(2))), True),  # an array is not looked at
        ((2, (0.5, np.ones(2))), (2.5, (0.5, np.ones(2))), False),
        ((2, (0.5, np.ones(2))), (2, (0.25, np.ones(2))), False),
        ((2, (0.5, np.ones(2))), (2, (0.5, np.ones(2)), 3), False),
    ],
)
def test_a_list_tells_of_a_loss(stored: Any, value: Any, kept: bool) -> None:
    """A number that its place has cut, beside an array; and a tuple of another length."""
    assert listed([(1, (0.5, np.zeros(2)))] * 2).kept.equal(stored, value) == kept

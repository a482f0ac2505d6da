"""Copies, snapshots and comparisons of a loop's arguments, to rehearse steps and to undo calls."""

import copy
from collections.abc import Iterator
from typing import Any

import numpy as np

CLOSE = 1e-12
"""How much real numbers may differ, as a share: sums, powers and exp are rounded differently in the last digits."""
LARGE = 1_000_000
"""From how many bytes on an array may be left out of a snapshot."""
ARRAYS_AND_STREAMS = (np.ndarray, np.random.Generator)  # a union would take longer at each call


def copied(value: Any, known: dict[int, Any] | None = None) -> Any:
    """A copy that shares nothing with the value; what is shared within the value is shared within the copy.

    Arrays that are views of one another stay so, and a random generator met twice is one generator.
    """
    known = {} if known is None else known
    if id(value) in known:
        return known[id(value)][0]
    made: Any
    if isinstance(value, np.ndarray):
        made = _copied_array(value, known)
    elif isinstance(value, np.random.Generator):
        made = np.random.Generator(copied(value.bit_generator, known))
    elif isinstance(value, tuple):
        made = tuple.__new__(type(value), [copied(part, known) for part in tuple.__iter__(value)])
    elif _is_typed_list(value):
        made = type(value)([copied(part, known) for part in value])
    else:
        made = copy.deepcopy(value)
    known[id(value)] = made, value  # keeps the value alive, so that no other object gets its id
    return made


def _copied_array(array: Any, known: dict[int, Any]) -> Any:
    owner = array
    while isinstance(owner.base, np.ndarray):
        owner = owner.base
    if array.dtype.hasobject or not (owner.flags.c_contiguous or owner.flags.f_contiguous):
        return copy.deepcopy(array)
    if -id(owner) not in known:  # negative, for `id(owner)` is the key of the copy of that array itself
        known[-id(owner)] = owner.ravel(order="K").copy(), owner
    memory = known[-id(owner)][0]
    offset = array.__array_interface__["data"][0] - owner.__array_interface__["data"][0]
    made = np.ndarray(array.shape, array.dtype, memory, offset, array.strides)
    made.flags.writeable = array.flags.writeable
    return made


def _is_typed_list(value: Any) -> bool:
    """Whether it is one of Numba's lists."""
    return type(value).__module__.startswith("numba.typed")


class Snapshot:
    """The tables and random streams that a call may change, as they were before it. The memory is reused.

    Attributes:
        is_whole: whether no large array was left out.
    """

    def __init__(self) -> None:
        """An empty snapshot: `take` fills it."""
        self.is_whole = True
        self._leaves: list[Any] = []
        self._saved: list[Any] = []
        self._left_out: set[int] = set()  # indices of leaves

    def take(self, values: tuple[Any, ...], *, large: bool = True) -> None:
        """Saves what these values hold now; large arrays only if asked for."""
        leaves: list[Any] = []
        _collect(values, leaves)
        self._left_out = set() if large else {k for k, leaf in enumerate(leaves) if getattr(leaf, "nbytes", 0) >= LARGE}
        self.is_whole = not self._left_out
        old = self._saved if len(self._saved) == len(leaves) else [None] * len(leaves)
        self._saved = [old[k] if k in self._left_out else _saved(leaf, old[k]) for k, leaf in enumerate(leaves)]
        self._leaves = leaves

    def put_back(self) -> None:
        """Restores what was saved, except in what cannot be written to."""
        for k, (leaf, saved) in enumerate(zip(self._leaves, self._saved, strict=True)):
            if k in self._left_out:
                continue
            if isinstance(leaf, np.random.Generator):
                leaf.bit_generator.state = saved
            elif not isinstance(leaf, np.ndarray):
                for place, part in enumerate(saved):
                    leaf[place] = part
            elif leaf.flags.writeable:
                np.copyto(leaf, saved)


def _collect(values: tuple[Any, ...], leaves: list[Any]) -> None:
    for value in tuple.__iter__(values):
        if isinstance(value, tuple):
            _collect(value, leaves)
        elif isinstance(value, ARRAYS_AND_STREAMS) or _is_typed_list(value):
            leaves.append(value)


def _saved(leaf: Any, old: Any) -> Any:
    """A copy of what a leaf holds, in the memory of an old copy if that fits."""
    if isinstance(leaf, np.random.Generator):
        return leaf.bit_generator.state
    fits = isinstance(leaf, np.ndarray) and isinstance(old, np.ndarray) and old.shape == leaf.shape
    if not (fits and old.dtype == leaf.dtype):
        return leaf.copy()
    np.copyto(old, leaf)
    return old


def difference(one: Any, other: Any, name: str, close: float = CLOSE) -> str | None:
    """What differs between two values, by more than the last digits of real numbers; None if nothing does.

    Args:
        one: a value.
        other: another.
        name: what to call it.
        close: how much real numbers may differ, as a share.
    """
    if isinstance(one, tuple) and isinstance(other, tuple):
        if tuple.__len__(one) != tuple.__len__(other):
            return name
        fields = getattr(one, "_fields", None)
        for k, (part, other_part) in enumerate(_pairs(one, other)):
            part_name = f"{name}[{k}]" if fields is None else fields[k]
            if found := difference(part, other_part, part_name, close):
                return found
        return None
    if isinstance(one, np.random.Generator):
        return None if str(one.bit_generator.state) == str(other.bit_generator.state) else "a random stream"
    if _is_typed_list(one):
        return difference(tuple(one), tuple(other), name, close)
    try:
        first, second = np.asarray(one), np.asarray(other)
        same = first.shape == second.shape and _are_close(first, second, close)
    except (TypeError, ValueError):
        same = False
    return None if same else name


def _pairs(one: tuple[Any, ...], other: tuple[Any, ...]) -> Iterator[tuple[Any, Any]]:
    """The parts of two tuples, even if their classes override `__iter__`."""
    return zip(tuple.__iter__(one), tuple.__iter__(other), strict=True)


def _are_close(one: np.ndarray[Any, Any], other: np.ndarray[Any, Any], close: float) -> bool:
    if one.dtype.kind in "biu" and other.dtype.kind in "biu":
        return bool(np.array_equal(one, other))
    if one.dtype.kind in "biuf" and other.dtype.kind in "biuf":
        with np.errstate(all="ignore"):
            finite = np.abs(one[np.isfinite(one)])
            largest = float(finite.max()) if finite.size else 0.0
            return bool(np.allclose(one, other, rtol=close, atol=close * largest, equal_nan=True))
    return bool(np.all(one == other))

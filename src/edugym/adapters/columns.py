"""Arrays for the states and the observations of n copies, which machine code reads and writes in place.

States have a column (an array of length n) for each number in a state; observations are the rows of one array.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, Protocol

import numpy as np

from edugym.mdp.protocol import MDP, Random, writes_in_place
from edugym.system.generated import generated_class


class Storage(Protocol):
    """A place for each of n values."""

    def load(self, i: int) -> Any:
        """The i-th value."""

    def store(self, i: int, value: Any) -> bool:
        """Put a value in the i-th place, and tell whether it is there without loss."""


class Rows(Protocol):
    """An array with a row for each of n observations."""

    @property
    def rows(self) -> Any:
        """The array, of shape (n, ...)."""

    def put(self, i: int, mdp: MDP[Any, Any], state: Any, rng: Random) -> None:
        """Observe a state, and write what is seen into the i-th row."""


class WholeRows(NamedTuple):
    """Rows for observations that are numbers, or arrays, which are copied."""

    rows: Any

    def put(self, i: int, mdp: MDP[Any, Any], state: Any, rng: Random) -> None:
        """Observe a state, and write what is seen into the i-th row."""
        self.rows[i] = mdp.observation(state, rng)


class RowsInPlace(NamedTuple):
    """Rows for observations that are arrays, which the MDP itself writes into them."""

    rows: Any

    def put(self, i: int, mdp: Any, state: Any, rng: Random) -> None:
        """Observe a state, and write what is seen into the i-th row."""
        mdp.observe_into(state, rng, self.rows[i])


class Listed(NamedTuple):
    """Values of any shape, such as states that hold arrays, in a list or an array of objects.

    Attributes:
        values: the list.
        kept: tells whether a value is there without loss (see `columns`).
    """

    values: Any
    kept: Any

    def load(self, i: int) -> Any:
        """The i-th value."""
        return self.values[i]

    def store(self, i: int, value: Any) -> bool:
        """Put a value in the i-th place, and tell whether it is there without loss."""
        self.values[i] = value
        kept: bool = self.kept.equal(self.values[i], value)
        return kept

    def __reduce__(self) -> tuple[Any, ...]:
        """How it is copied and pickled: Numba's lists cannot be."""
        return loose if isinstance(self.values, np.ndarray) else listed, (list(self.values),)


class Always(NamedTuple):
    """Tells of every value that it is kept as it is."""

    def equal(self, stored: Any, value: Any) -> bool:
        """True."""
        return True


def storage(states: list[Any], n: int, *, checked: bool = True) -> Storage:
    """A place for each of `n` states, chosen by some states that occur.

    A number that is whole in some of them and not in others is stored as a real number.

    Args:
        states: some that occur.
        n: how many to store.
        checked: whether `store` tells of a loss; there is none in the package's own MDPs.
    """
    if not all(map(_regular, states)) or len({_form(state, numbers=False) for state in states}) > 1:
        return loose([states[0]] * n)
    if not holds_arrays(states[0]):
        return columns(_joint(states), n, checked=checked)
    several = len({_form(state, numbers=True) for state in states}) > 1
    return (loose if several else listed)([states[0]] * n)


def columns(sample: Any, n: int, *, checked: bool = True) -> Storage:
    """A place for each of `n` values like `sample`: a number, or a (nested) tuple of numbers.

    It writes a class for the sample. For a state (x, speed) that is:

        def load(self, i):
            return (self.columns[0][i], self.columns[1][i],)
        def store(self, i, value):
            if len(value) != 2:
                return False
            self.columns[0][i] = value[0]
            self.columns[1][i] = value[1]
            return same(self.columns[0][i], value[0]) and same(self.columns[1][i], value[1])

    A value that does not fit the type of its column is cut (0.5 becomes 0 among whole numbers); then `store` returns
    False, unless it is not `checked`.
    """
    arrays: list[np.ndarray[Any, Any]] = []
    kinds: dict[str, Any] = {"same": _same}
    lengths: list[str] = []
    stores: list[str] = []
    kept: list[str] = []

    def walk(value: Any, path: str) -> str:
        if isinstance(value, tuple):
            lengths.append(f"        if len(value{path}) != {len(value)}:\n            return False")
            inside = "".join(walk(part, f"{path}[{k}]") + ", " for k, part in enumerate(value))
            if not hasattr(value, "_fields"):
                return f"({inside})"
            kind = f"Kind{len(kinds)}"
            kinds[kind] = type(value)
            return f"{kind}({inside})"
        kept.append(f"same(self.columns[{len(arrays)}][i], value{path})")
        stores.append(f"        self.columns[{len(arrays)}][i] = value{path}")
        arrays.append(np.zeros(n, np.asarray(value).dtype))
        return f"self.columns[{len(arrays) - 1}][i]"

    loaded = walk(sample, "")
    if not checked:
        kinds.pop("same")
        lengths, kept = [], []
    lines = [
        "    columns: tuple",
        "    def load(self, i):",
        f"        return {loaded}",
        "    def store(self, i, value):",
        *lengths,
        *stores,
        f"        return {' and '.join(kept) or 'True'}",
    ]
    storage: Storage = generated_class("Columns", lines, kinds)(tuple(arrays))
    return storage


def observation_rows(mdp: MDP[Any, Any], sample: Any) -> Callable[[np.ndarray[Any, Any]], Rows]:
    """The class of the rows for observations of `mdp` like `sample`; it is made from the array.

    For tuples it writes a class for the sample. For (x, speed) that is:

        def put(self, i, mdp, state, rng):
            value = mdp.observation(state, rng)
            self.rows[i, 0] = value[0]
            self.rows[i, 1] = value[1]
    """
    if writes_in_place(mdp):
        return RowsInPlace
    if not isinstance(sample, tuple):
        return WholeRows
    stores: list[str] = []

    def walk(value: Any, path: str, place: str) -> None:
        if not isinstance(value, tuple):
            stores.append(f"        self.rows[i{place}] = value{path}")
            return
        for k, part in enumerate(value):
            walk(part, f"{path}[{k}]", f"{place}, {k}")

    walk(sample, "", "")
    lines = [
        "    rows: object",
        "    def put(self, i, mdp, state, rng):",
        "        value = mdp.observation(state, rng)",
        *stores,
    ]
    kind: Callable[[np.ndarray[Any, Any]], Rows] = generated_class("TupleRows", lines, {})
    return kind


def copy_of(storage: Any) -> Any:
    """The same values in arrays of their own."""
    if isinstance(storage, Listed):
        return _copied(storage, slice(None))
    return type(storage)(tuple(column.copy() for column in storage.columns))


def head(storage: Any, n: int) -> Any:
    """The first `n` values, in storage of the same type."""
    if isinstance(storage, Listed):
        return _copied(storage, slice(n))
    return type(storage)(tuple(column[:n].copy() for column in storage.columns))


def _copied(storage: Listed, part: slice) -> Listed:
    if isinstance(storage.values, np.ndarray):
        return storage._replace(values=storage.values[part].copy())
    try:
        return storage._replace(values=storage.values[part])
    except NotImplementedError:  # Numba takes the class for an older one of the same name
        return listed(list(storage.values)[part])


def as_sampled(value: Any, sample: Any) -> Any:
    """A value from a column, with Python's numbers where the `sample` has them."""
    if isinstance(sample, tuple):
        parts = [as_sampled(part, like) for part, like in zip(value, sample, strict=True)]
        return type(sample)(*parts) if hasattr(sample, "_fields") else tuple(parts)
    return value if isinstance(sample, np.generic) else value.item()


def listed(values: list[Any]) -> Listed:
    """The values in a list that machine code can use, where there is a compiler."""
    try:
        from numba.typed import List
    except ImportError:
        return loose(values)
    return Listed(List(values), _comparison(values[0]))


def _comparison(sample: Any) -> Any:
    """A comparison of the numbers in a stored value and in the original, since Numba's lists cast them."""
    parts: list[str] = []

    def walk(value: Any, path: str) -> None:
        if isinstance(value, tuple):
            parts.append(f"len(value{path}) == {len(value)}")
            for k, part in enumerate(value):
                walk(part, f"{path}[{k}]")
        elif not isinstance(value, np.ndarray):
            parts.append(f"same(stored{path}, value{path})")

    walk(sample, "")
    lines = ["    def equal(self, stored, value):", f"        return {' and '.join(parts) or 'True'}"]
    known: dict[str, Any] = {"same": _same}
    return generated_class("Comparison", lines, known)()


def loose(values: list[Any]) -> Listed:
    """The values in an array of objects, which takes values of any kind but cannot be used by machine code."""
    objects = np.empty(len(values), object)
    for i, value in enumerate(values):
        objects[i] = value
    return Listed(objects, Always())


def holds_arrays(value: Any) -> bool:
    """Whether there is an array anywhere in a value."""
    return isinstance(value, np.ndarray) or (isinstance(value, tuple) and any(map(holds_arrays, value)))


def _same(stored: Any, value: Any) -> Any:
    """Whether a number has been stored without loss; NaN equals itself here."""
    return stored == value or (stored != stored and value != value)


def _regular(value: Any) -> bool:
    """Whether it is made of numbers that machine code computes with as Python does, arrays of numbers, and tuples."""
    if isinstance(value, tuple):
        return all(map(_regular, value))
    if isinstance(value, np.ndarray):
        return value.dtype.kind in "biuf"
    if isinstance(value, int) and not -(2**63) <= value < 2**63:
        return False
    return isinstance(value, bool | int | float | np.bool_ | np.int64 | np.float64)


def _form(value: Any, *, numbers: bool) -> Any:
    """The form of a value: values that fit in one place have the same. With `numbers`, their types count too."""
    if isinstance(value, tuple):
        return type(value), tuple(_form(part, numbers=numbers) for part in value)
    if isinstance(value, np.ndarray):
        return value.dtype, value.ndim
    return np.asarray(value).dtype if numbers else None


def _joint(values: list[Any]) -> Any:
    """The first value, its numbers of types that can hold those of all the others."""
    first = values[0]
    if isinstance(first, tuple):
        parts = [_joint(list(parts)) for parts in zip(*values, strict=True)]
        return type(first)(*parts) if hasattr(first, "_fields") else tuple(parts)
    return np.result_type(*map(np.asarray, values)).type(first)

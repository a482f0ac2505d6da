"""Defines the kind of a value: what the translation to JavaScript knows of it before code runs.

JavaScript has numbers of one type only. So the kind decides what an operation does: a sum of whole numbers must
stay one of Python's whole numbers, a sum of real ones may be infinite.
"""

from enum import Enum
from types import FunctionType, ModuleType
from typing import Any, NamedTuple, TypeAlias

import numpy as np

INT, FLOAT, MIXED, BOOL, NONE, RNG, NEVER = "int", "float", "mixed", "bool", "none", "rng", "never"
"""Kinds of plain values. `MIXED` is a number that may be whole or real; `NEVER` belongs to code that never runs."""
NUMBERS = frozenset({INT, FLOAT, MIXED})
DTYPES = {"float64": FLOAT, "int64": INT, "bool": BOOL}
"""The kinds of the elements of arrays, by the names of their types."""
ARRAYS = {FLOAT: "Real", INT: "Whole", BOOL: "Flags"}
"""The classes of arrays in JavaScript, by the kind of their elements."""
FROZEN = "it writes to an array that is no field: pass it as a field"


class Untranslatable(Exception):
    """Says in `str(error)` which code or value has no translation that does the same for sure."""


class Array(NamedTuple):
    """An array.

    Attributes:
        of: the kind of its elements.
        ndim: its number of dimensions.
        frozen: whether code may only read it, since it reaches it by a name, and not by a field or an argument.
        name: of the constant that it is for sure; None where it may be another array.
    """

    of: str
    ndim: int
    frozen: bool = False
    name: str | None = None


class Tuple(NamedTuple):
    """A tuple or a NamedTuple.

    Attributes:
        type: its class; None for a plain tuple.
        parts: the kinds of what is in it.
        name: of the constant that it is for sure, with an underscore and a number for what is in it; None where it may
            be another.
    """

    type: type | None
    parts: tuple[Any, ...]
    name: str | None = None

    @property
    def shape(self) -> tuple[Any, int]:
        """Returns its class and its length."""
        return self.type, len(self.parts)


class List(NamedTuple):
    """A list. `Known` keeps the kind of what is in it, since two names may stand for one list.

    Attributes:
        site: where in the code it is made.
    """

    site: Any


class Static(NamedTuple):
    """A value that is known before code runs: a module, a class, a function, a text, a member of an Enum."""

    value: Any

    def __eq__(self, other: object) -> bool:
        """Returns whether it is the very same value, or an equal text."""
        return isinstance(other, Static) and (self.value is other.value or self._text == other._text is not None)

    def __hash__(self) -> int:
        """Returns a hash that equal ones share."""
        return hash(self._text or id(self.value))

    @property
    def _text(self) -> str | None:
        return self.value if isinstance(self.value, str) else None


Kind: TypeAlias = str | Array | Tuple | List | Static


class Code(NamedTuple):
    """An expression in JavaScript.

    Attributes:
        text: the expression; it is evaluated once, wherever it stands.
        kind: of its value.
        line: for an array of one axis, its data, offset, length and stride where they are known without it; a call that
            makes a number of it needs no array.
        where: for a comparison of an array and a number, the call that makes the array of the places where it holds.
    """

    text: str
    kind: Kind
    line: str | None = None
    where: str | None = None


def kind_of(value: Any, name: str) -> Kind:
    """Returns the kind of a value; `name` is what a message calls it.

    Raises:
        Untranslatable: the value has none.
    """
    if isinstance(value, bool | np.bool_):
        return BOOL
    if isinstance(value, int | np.int64) and not isinstance(value, Enum):
        return INT
    if isinstance(value, float):
        return FLOAT
    if isinstance(value, tuple) and not isinstance(value, Enum):
        fields = getattr(value, "_fields", range(tuple.__len__(value)))
        parts = zip(tuple.__iter__(value), fields, strict=True)
        return Tuple(
            type(value) if hasattr(value, "_fields") else None,
            tuple(kind_of(part, _part_name(value, name, field)) for part, field in parts),
        )
    if isinstance(value, np.ndarray) and value.dtype.name in DTYPES:
        if value.ndim == 0:
            raise Untranslatable(f"{name} is an array without dimensions: give it one, as in np.zeros(1)")
        if not value.flags.writeable:
            raise Untranslatable(f"{name} is an array that may only be read: use a copy of it")
        if not value.flags.aligned or not value.dtype.isnative:
            raise Untranslatable(f"{name} is an array whose memory is not as NumPy makes it: use a copy of it")
        return Array(DTYPES[value.dtype.name], value.ndim)
    if isinstance(value, np.random.Generator):
        if not isinstance(value.bit_generator, np.random.PCG64):
            raise Untranslatable(f"{name} draws from {type(value.bit_generator).__name__}, not from PCG64")
        return RNG
    if value is None:
        return NONE
    if isinstance(value, str | Enum | type | FunctionType | ModuleType) or callable(value):
        return Static(value)
    what = f"an array of {value.dtype.name}" if isinstance(value, np.ndarray) else f"a {type(value).__name__}"
    raise Untranslatable(f"{name} is {what}")


def _part_name(value: Any, name: str, field: Any) -> str:
    """Returns what a message calls a part of a tuple."""
    return f"the field {field} of {type(value).__name__}" if hasattr(value, "_fields") else f"{name}[{field}]"


def frozen(kind: Kind) -> Kind:
    """Returns the same kind, with arrays that code may only read."""
    if isinstance(kind, Array):
        return kind._replace(frozen=True)
    return kind._replace(parts=tuple(map(frozen, kind.parts))) if isinstance(kind, Tuple) else kind


def joined(one: Kind, other: Kind) -> Kind:
    """Returns the kind of what may be of one kind or of the other.

    Raises:
        Untranslatable: a name that stands for both would hold values that JavaScript cannot tell apart.
    """
    if one == other or other == NEVER:
        return one
    if one == NEVER:
        return other
    if isinstance(one, str) and isinstance(other, str) and {one, other} <= NUMBERS:
        return MIXED
    if isinstance(one, Array) and isinstance(other, Array) and one[:2] == other[:2]:
        return Array(one.of, one.ndim, one.frozen or other.frozen)
    if isinstance(one, Tuple) and isinstance(other, Tuple) and one.shape == other.shape:
        return Tuple(one.type, tuple(map(joined, one.parts, other.parts)))
    first, second = described(one), described(other)
    raise Untranslatable(f"one name stands for {first} and {'another elsewhere' if first == second else second}")


def skeleton(kind: Kind) -> Any:
    """Returns what is the same for all kinds whose values look the same in JavaScript."""
    if isinstance(kind, Tuple):
        return (kind.type, tuple(map(skeleton, kind.parts)))
    return "number" if kind in NUMBERS else (kind if isinstance(kind, Static | str) else type(kind))


def described(kind: Kind) -> str:
    """Returns what a message calls a kind."""
    if isinstance(kind, Array):
        return f"an array of {kind.ndim} dimension{'s' * (kind.ndim > 1)}"
    if isinstance(kind, Tuple):
        return f"a {kind.type.__name__}" if kind.type else f"a tuple of {len(kind.parts)}"
    if isinstance(kind, List):
        return "a list"
    if isinstance(kind, Static):
        if isinstance(kind.value, Enum):
            return f"{type(kind.value).__name__}.{kind.value.name}, a member of an enum"
        return "a text" if isinstance(kind.value, str) else f"{getattr(kind.value, '__name__', kind.value)}"
    return {
        INT: "a whole number",
        FLOAT: "a real number",
        MIXED: "a number",
        BOOL: "True or False",
        NONE: "None",
        RNG: "rng",
    }.get(kind, "nothing")

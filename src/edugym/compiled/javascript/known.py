"""Keeps what the translator knows of a program so far: the kinds of variables, results and lists, and the constants."""

from abc import ABC, abstractmethod
from enum import Enum
from types import FunctionType
from typing import Any

import numpy as np

from edugym.compiled.javascript.kinds import (
    BOOL,
    FLOAT,
    INT,
    NEVER,
    NONE,
    RNG,
    Code,
    Kind,
    List,
    Static,
    Tuple,
    Untranslatable,
    frozen,
    joined,
    kind_of,
    skeleton,
)


class Constants:
    """Collects the constants of a program and the classes of its tuples.

    Attributes:
        arrays: the arrays that the program reaches by a name, and only reads; JavaScript calls them g0, g1, ...
        tuples: the JavaScript that makes the constant tuples c0, c1, ...
        classes: the name and the number of fields of each class of tuples, by the `skeleton` of its kinds.
        operations: the functions o0, o1, ... of two elements of arrays.
    """

    def __init__(self) -> None:
        """Begins with no constants."""
        self.arrays: list[Any] = []
        self.tuples: list[str] = []
        self.classes: dict[Any, tuple[str, int]] = {}
        self.operations: list[str] = []
        self._kept: dict[int, tuple[Any, Code]] = {}  # with the value itself, so that no other gets its id

    def code(self, value: Any, name: str) -> Code:
        """Writes a value that is known before the program runs; `name` is what a message calls it.

        Raises:
            Untranslatable: the value has no translation.
        """
        if isinstance(value, Enum):
            return Code("null", Static(value))
        if isinstance(value, np.generic):
            kind_of(value, name)
            value = value.item()
        if value is None:
            return Code("null", NONE)
        if isinstance(value, bool):
            return Code(str(value).lower(), BOOL)
        if isinstance(value, int):
            if abs(value) > 2**1000 or int(float(value)) != value:
                raise Untranslatable(f"{name} is a whole number of more than 53 bits")
            return Code(f"({float(value)!r})" if value < 0 else repr(float(value)).removesuffix(".0"), INT)
        if isinstance(value, float):
            text = repr(value).replace("inf", "Infinity").replace("nan", "NaN")
            return Code(f"({text})" if text.startswith("-") else text, FLOAT)
        if isinstance(value, np.ndarray | tuple):
            return self._kept_constant(value, name)
        return Code("null", kind_of(value, name))

    def _kept_constant(self, value: Any, name: str) -> Code:
        """Returns the name under which JavaScript keeps an array or a tuple."""
        if id(value) not in self._kept:
            if isinstance(value, np.ndarray):
                made = Code(f"g{len(self.arrays)}", frozen(kind_of(value, name)))
                self.arrays.append(value)
            else:
                parts = [self.code(part, name) for part in tuple.__iter__(value)]
                kind = Tuple(type(value) if hasattr(value, "_fields") else None, tuple(part.kind for part in parts))
                made = Code(f"c{len(self.tuples)}", kind)
                values = ",".join(one.text for one in parts)
                self.tuples.append(f"{made.text}=new {self.tuple_class(kind)}({values})")
            self._kept[id(value)] = value, made
        return self._kept[id(value)][1]

    def tuple_class(self, kind: Tuple) -> str:
        """Returns the name of the JavaScript class for tuples of this kind."""
        bones = skeleton(kind)
        if bones not in self.classes:
            self.classes[bones] = (f"T{len(self.classes)}", len(kind.parts))
        return self.classes[bones][0]

    def operation(self, text: str) -> str:
        """Returns the name of the JavaScript function for this one, which is then made once and not at every use."""
        if text not in self.operations:
            self.operations.append(text)
        return f"o{self.operations.index(text)}"


class Known(ABC):
    """Keeps what is known of a program. The translator writes the program again until nothing new is noted.

    Attributes:
        libm: the functions of the library of mathematics that the program may call.
        kinds: the kinds of variables, by function and kinds of its arguments, and by name.
        results: the kinds of what functions return, by function and kinds of its arguments.
        constants: the constants that the present pass has met.
        changed: whether the present pass has noted anything new.
    """

    def __init__(self, libm: frozenset[str]) -> None:
        """Begins with nothing known."""
        self.libm = libm
        self.kinds: dict[Any, Kind] = {}
        self.results: dict[Any, Kind] = {}
        self._lists: dict[Any, Kind] = {}
        self._same: dict[Any, Any] = {}  # sites of lists that are one
        self.begin_pass()

    def begin_pass(self) -> None:
        """Forgets the constants, but no kinds."""
        self.constants = Constants()
        self.changed = False

    @abstractmethod
    def function(self, called: FunctionType, kinds: dict[str, Kind]) -> Code | None:
        """Returns the name of a function for arguments of these kinds, with the kind of what it returns.

        The answer is None for a function that calls itself.
        """

    def note(self, key: Any, kind: Kind) -> None:
        """Notes that a variable has a value of this kind.

        Raises:
            Untranslatable: the variable has values of another kind, too, and the two do not fit.
        """
        self._note(self.kinds, key, kind)

    def note_result(self, key: Any, kind: Kind) -> None:
        """Notes that a function returns a value of this kind.

        Raises:
            Untranslatable: the function returns values of another kind, too, and the two do not fit.
        """
        if kind != NONE or self.results.get(key, NEVER) in (NEVER, NONE):
            self._note(self.results, key, kind)

    def _note(self, table: dict[Any, Kind], key: Any, kind: Kind) -> None:
        before = table.get(key, NEVER)
        after = self._joined(before, kind)
        if after != before:
            table[key], self.changed = after, True

    def _joined(self, one: Kind, other: Kind) -> Kind:
        if isinstance(one, List) and isinstance(other, List):
            first, second = self._root(one.site), self._root(other.site)
            if first != second:
                self._same[second], self.changed = first, True
                self._lists[first] = joined(self._lists.get(first, NEVER), self._lists.pop(second, NEVER))
            return one
        return joined(one, other)

    def _root(self, site: Any) -> Any:
        while site in self._same:
            site = self._same[site]
        return site

    def part(self, kind: List) -> Kind:
        """Returns the kind of what is in a list."""
        return self._lists.get(self._root(kind.site), NEVER)

    def widen(self, kind: List, part: Kind) -> None:
        """Notes that the program puts something of kind `part` into a list.

        Raises:
            Untranslatable: it is no number, or does not fit what else is in the list.
        """
        if not isinstance(part, str) or part in (NONE, RNG):
            raise Untranslatable("it makes a list of other things than numbers")
        site = self._root(kind.site)
        before = self._lists.get(site, NEVER)
        try:
            after = joined(before, part)
        except Untranslatable as error:
            raise Untranslatable(str(error).replace("one name stands", "one list is")) from error
        if after != before:
            self._lists[site], self.changed = after, True

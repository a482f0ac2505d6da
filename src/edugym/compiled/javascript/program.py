"""A loop over an MDP and an agent as JavaScript: how students' code runs fast in a web browser, where Numba is not.

The second back end for the subset of `edugym.compiled.subset`. The source of the loop and of all that it reaches is
translated for the kinds of its arguments, with Python's own arithmetic: whole numbers up to 53 bits, floor division,
the order of additions, NumPy's random streams. What has no translation that does the same for sure is refused, with its
line; where a running program comes to something that JavaScript may do otherwise, it stops, and the interpreter repeats
the call (see `edugym.compiled.execution`).

Arrays and random streams are not copied: translated code works on the memory in which NumPy has them. How it gets there
is the business of an `Engine`, which a web page gives (or Node.js, in tests).
"""

import ast
import inspect
from collections.abc import Callable, Iterator, Sequence
from enum import Enum
from pathlib import Path
from types import FunctionType
from typing import Any, Protocol

import numpy as np

from edugym.compiled.code import place
from edugym.compiled.javascript.kinds import (
    ARRAYS,
    BOOL,
    FLOAT,
    INT,
    MIXED,
    NEVER,
    NONE,
    RNG,
    Array,
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
from edugym.compiled.javascript.sources import source_of
from edugym.compiled.javascript.statements import Writer

RUNTIME = Path(__file__).with_name("runtime.js")
MOST_PASSES = 30
"""After so many passes the kinds of all variables are known, or are not to be found out."""
MOST_DEEP = 60
"""How deep functions may call each other."""
HEAPS = {FLOAT: "reals", INT: "halves", BOOL: "bytes"}
Loop = Callable[..., Any]


class Doubt(Exception):
    """Translated code has come to what JavaScript might do otherwise, or to an error: the interpreter repeats it."""


class Engine(Protocol):
    """Where JavaScript runs.

    Attributes:
        libm: the functions of the library of mathematics that give there what they give to Python, bit for bit.
    """

    libm: frozenset[str]

    def load(self, text: str) -> Callable[[Sequence[float]], Sequence[float]]:
        """What runs a translation: from its numbers to those of its result.

        `text` is the body of a JavaScript function of `memory` (which gives the ArrayBuffer), `draw` (which has
        next_double, normal and exponential of the state of a random stream, and bounded) and `libm`. What it throws is
        raised as `Doubt`.
        """

    def address(self, array: Any) -> int:
        """Where in the memory an array begins, in bytes."""

    def stream(self, rng: np.random.Generator) -> int:
        """Where in the memory the state of a random stream is."""


engine: Engine | None = None
"""What runs translations here; None where there is no JavaScript."""


def translated(loop: Loop, arguments: tuple[Any, ...], on: Engine) -> Loop:
    """The loop over arguments like these, as JavaScript.

    Args:
        loop: a plain function whose first argument is a number.
        arguments: what follows it, or values of the same kinds.
        on: where it runs.

    Raises:
        Untranslatable: there is no translation that does the same for sure.
    """
    program = Program(loop, arguments, on.libm)
    run = on.load(program.text)

    def call(n: int, *given: Any) -> Any:
        numbers = [float(n)]
        for value, kind in zip(given, program.given, strict=True):
            numbers += _numbers(value, kind, on)
        for array in program.arrays:
            numbers += _numbers(array, kind_of(array, "a constant"), on)
        return program.result_of(iter(run(numbers)))

    return call


def _numbers(value: Any, kind: Kind, on: Engine) -> Iterator[float]:
    """The numbers by which translated code is told a value."""
    if isinstance(kind, Tuple):
        if not isinstance(value, tuple) or (kind.type is not None and type(value) is not kind.type):
            raise Doubt("an argument of another type")
        for part, inner in zip(tuple.__iter__(value), kind.parts, strict=True):
            yield from _numbers(part, inner, on)
    elif isinstance(kind, Array):
        if kind_of(value, "an array") != kind._replace(frozen=False) or any(
            one % value.itemsize for one in value.strides
        ):
            raise Doubt("an array of another type")
        yield on.address(value) / value.itemsize
        yield from map(float, value.shape)
        yield from (stride / value.itemsize for stride in value.strides)
    elif kind == RNG:
        yield float(on.stream(value))
    elif kind in (INT, FLOAT, BOOL):
        if kind_of(value, "a number") != kind or (kind == INT and int(float(value)) != value):
            raise Doubt("a number of another type")
        yield float(value)
    elif kind_of(value, "a value") != kind:
        raise Doubt("another value")


class Program:
    """A translation: the loop, and all functions that it reaches.

    Attributes:
        text: the body of a function of JavaScript, for `Engine.load`.
        given: the kinds of the arguments after the first.
        arrays: those that it reaches by a name, and only reads.
        libm: the functions of the library of mathematics that it may call.
        kinds: of variables: (function and kinds of its arguments, name) -> kind.
        results: the kinds of what functions return.
    """

    def __init__(self, loop: Loop, arguments: tuple[Any, ...], libm: frozenset[str]) -> None:
        """Translates it."""
        self.libm = libm
        self.kinds: dict[Any, Kind] = {}
        self.results: dict[Any, Kind] = {}
        self._lists: dict[Any, Kind] = {}
        self._same: dict[Any, Any] = {}  # sites of lists that are one
        names = list(inspect.signature(loop).parameters)
        given = [INT, *(kind_of(one, name) for one, name in zip(arguments, names[1:], strict=True))]
        key = (loop, "the loop")
        for _ in range(MOST_PASSES):
            self._changed = False
            self.arrays: list[Any] = []
            self._array_names: dict[int, str] = {}
            self._constants: list[str] = []
            self._kept: dict[int, tuple[str, Any]] = {}
            self._classes: dict[Any, tuple[str, int]] = {}
            self._functions: dict[Any, str] = {}
            self._texts: list[str] = []
            self._open: set[Any] = set()
            main = self._write(_plain(loop), key, dict(zip(names, given, strict=True)))
            result = self.results[key]
            if names[-1] == "carry":  # what the next call begins with
                given[-1] = joined(given[-1], result)
            if not self._changed and (names[-1] != "carry" or result == given[-1]):
                break
        else:
            raise Untranslatable("the types of its variables are not to be found out")
        self.given, self._result = given[1:], result
        _require_plain(result, "what the loop carries from step to step")
        self.text = self._whole(main, given)

    # What is known

    def note(self, key: Any, kind: Kind) -> None:
        """Notes that a variable has a value of this kind.

        Raises:
            Untranslatable: it has others that do not fit.
        """
        before = self.kinds.get(key, NEVER)
        after = self._joined(before, kind)
        if after != before:
            self.kinds[key], self._changed = after, True

    def _joined(self, one: Kind, other: Kind) -> Kind:
        if isinstance(one, List) and isinstance(other, List):
            first, second = self._root(one.site), self._root(other.site)
            if first != second:
                self._same[second], self._changed = first, True
                self._lists[first] = joined(self._lists.get(first, NEVER), self._lists.pop(second, NEVER))
            return one
        return joined(one, other)

    def _root(self, site: Any) -> Any:
        while site in self._same:
            site = self._same[site]
        return site

    def part(self, kind: List) -> Kind:
        """The kind of what is in a list."""
        return self._lists.get(self._root(kind.site), NEVER)

    def widen(self, kind: List, part: Kind) -> None:
        """Notes that something is put into a list.

        Raises:
            Untranslatable: it does not fit what else is in it.
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
            self._lists[site], self._changed = after, True

    # What functions and expressions ask for

    def placed(self, found: str, function: FunctionType, line: int | None) -> str:
        """A problem with its line."""
        return f"{found} ({place(function.__code__.co_filename, line or function.__code__.co_firstlineno)})"

    def member(self, kind: type | None, name: str) -> Any:
        """A member of a class, as it stands there."""
        return inspect.getattr_static(kind, name, None)

    def function(self, called: FunctionType, kinds: dict[str, Kind], caller: Any, node: ast.AST) -> Code:
        """The name of a function for arguments of these kinds, and the kind of what it returns."""
        if NEVER in kinds.values():
            return Code("(()=>doubt('never reached'))", NEVER)
        key = (called, tuple(kinds.values()))
        if key in self._open or len(self._open) > MOST_DEEP:
            raise caller.refused(node, f"it calls itself: {called.__name__}")
        if key not in self._functions:
            self._functions[key] = name = f"f{len(self._functions)}_{called.__name__.strip('<>')}"
            self._texts.append(f"function {name}{self._write(called, key, kinds)}")
        return Code(self._functions[key], self.results[key])

    def _write(self, function: FunctionType, key: Any, kinds: dict[str, Kind]) -> str:
        self._open.add(key)
        writer = Writer(self, function, key)
        text, result = writer.write(source_of(function), kinds)
        self._open.discard(key)
        before = self.results.get(key, NEVER)
        after = self._joined(before, result) if result != NONE or before in (NEVER, NONE) else before
        if after != before:
            self.results[key], self._changed = after, True
        return text

    def constant(self, value: Any, name: str) -> Code:
        """A value that is known by now.

        Raises:
            Untranslatable: it has no translation.
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
        """An array or a tuple, which is kept under a name."""
        if id(value) not in self._kept:
            if isinstance(value, np.ndarray):
                text = f"g{len(self.arrays)}"
                self.arrays.append(value)
                self._kept[id(value)] = text, (value, frozen(kind_of(value, name)))
            else:
                parts = [self.constant(part, name) for part in tuple.__iter__(value)]
                kind = Tuple(type(value) if hasattr(value, "_fields") else None, tuple(part.kind for part in parts))
                text = f"c{len(self._constants)}"
                self._constants.append(f"{text}=new {self.tuple_class(kind)}({','.join(one.text for one in parts)})")
                self._kept[id(value)] = text, (value, kind)
        text, (_, kept) = self._kept[id(value)]
        return Code(text, kept)

    def tuple_class(self, kind: Tuple) -> str:
        """The class of JavaScript's whose values look so."""
        bones = skeleton(kind)
        if bones not in self._classes:
            self._classes[bones] = (f"T{len(self._classes)}", len(kind.parts))
        return self._classes[bones][0]

    # The text

    def _whole(self, main: str, given: list[Kind]) -> str:
        calls = [self._made(kind) for kind in given]  # first, since it may add classes
        arrays = "".join(f"g{k}={self._made(kind_of(one, 'a constant'))};" for k, one in enumerate(self.arrays))
        classes = [
            f"class {name}{{constructor({parts}){{{fields}}}}}"
            for name, count in self._classes.values()
            for parts in [",".join(f"a{k}" for k in range(count))]
            for fields in ["".join(f"this.a{k}=a{k};" for k in range(count))]
        ]
        names = [f"g{k}" for k in range(len(self.arrays))] + [f"c{k}" for k in range(len(self._constants))]
        result = ",".join(_told("result", self._result))
        return "\n".join(
            [
                "'use strict'",
                RUNTIME.read_text(encoding="utf-8"),
                *classes,
                f"let {','.join(['numbers', 'at_number', 'heap', *names])}",
                "const next=()=>numbers[at_number++]",
                *self._texts,
                f"function loop{main}",
                "return told=>{",
                "numbers=told;at_number=0;heap=views(memory())",
                f"const given=[{','.join(calls)}]",
                arrays + ";".join(self._constants),
                "const result=loop(...given)",
                f"return [{result}]",
                "}",
            ]
        )

    def _made(self, kind: Kind) -> str:
        """What makes an argument of the numbers that follow."""
        if isinstance(kind, Tuple):
            return f"new {self.tuple_class(kind)}({','.join(map(self._made, kind.parts))})"
        if isinstance(kind, Array):
            axes = "[" + ",".join(["small(next())"] * kind.ndim) + "]"
            return f"new {ARRAYS[kind.of]}(heap.{HEAPS[kind.of]},small(next()),{axes},{axes})"
        if kind == BOOL:
            return "next()!==0"
        return "next()" if kind in (INT, FLOAT, RNG) else "null"

    def result_of(self, numbers: Iterator[float]) -> Any:
        """What the loop returns, from its numbers."""
        return _value(self._result, numbers)


def _told(text: str, kind: Kind) -> Iterator[str]:
    """The numbers of a result."""
    if isinstance(kind, Tuple):
        for k, part in enumerate(kind.parts):
            yield from _told(f"{text}.a{k}", part)
    elif kind in (INT, FLOAT, BOOL):
        yield f"+{text}"


def _value(kind: Kind, numbers: Iterator[float]) -> Any:
    if isinstance(kind, Tuple):
        parts = [_value(part, numbers) for part in kind.parts]
        return tuple(parts) if kind.type is None else tuple.__new__(kind.type, parts)
    if isinstance(kind, Static):
        return kind.value
    makers: dict[Any, Callable[[float], Any]] = {INT: int, FLOAT: float, BOOL: bool}
    return makers[kind](next(numbers)) if kind in makers else None


def _require_plain(kind: Kind, name: str) -> None:
    """Refuses what cannot be handed back."""
    if isinstance(kind, Tuple):
        for part in kind.parts:
            _require_plain(part, name)
    elif kind == MIXED:
        raise Untranslatable(f"{name} is made of whole numbers in one place and of real ones in another")
    elif not (isinstance(kind, Static) or kind in (INT, FLOAT, BOOL, NONE)):
        raise Untranslatable(f"{name} holds an array or a list")


def _plain(loop: Loop) -> FunctionType:
    if not isinstance(loop, FunctionType):
        raise Untranslatable("it is no plain function")
    return loop

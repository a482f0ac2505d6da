"""Translates a loop over an MDP and an agent to JavaScript, so that students' code runs fast in a web browser.

Numba does not run there. This is the second back end for the subset of `edugym.compiled.subset`. It translates the
source of the loop and of all that it reaches, for arguments of given kinds, and keeps Python's arithmetic: whole
numbers up to 53 bits, floor division, the order of additions, NumPy's random streams. It refuses code that has no
translation that does the same for sure, and names its line. A translation stops where JavaScript may do otherwise than
Python, and the interpreter repeats the call (see `edugym.compiled.execution`).

Translated code does not copy arrays and random streams, but works on the memory in which NumPy has them. An `Engine`
gives it that memory: that of a web page, or in tests that of Node.js.
"""

import inspect
from collections.abc import Callable, Iterator, Sequence
from itertools import chain, count
from pathlib import Path
from types import FunctionType
from typing import Any, Protocol

import numpy as np

from edugym.compiled.javascript.kinds import (
    ARRAYS,
    BOOL,
    FLOAT,
    INT,
    MIXED,
    NONE,
    RNG,
    Array,
    Code,
    Kind,
    Static,
    Tuple,
    Untranslatable,
    joined,
    kind_of,
)
from edugym.compiled.javascript.known import Known
from edugym.compiled.javascript.named import constants, with_names, without_names
from edugym.compiled.javascript.sources import source_of
from edugym.compiled.javascript.statements import Writer

RUNTIME = Path(__file__).with_name("runtime.js")
MOST_PASSES = 30
"""If kinds still change after so many passes, the translator gives up."""
MOST_DEEP = 60
"""Calls of functions within functions may be this deep."""
MOST_LOADS = 4
"""A translation is loaded anew so often for other arguments, such as those of the run after those of the rehearsal.

V8 is quick with the first constants that a program gets, and slow with all later ones; and it takes programs of equal
text for one.
"""
_numbered = count()  # makes the texts differ
HEAPS = {FLOAT: "reals", INT: "halves", BOOL: "bytes"}
KEPT = """// The loop for the arguments at hand: they stay the same from call to call, but for the carry.
let buffer, last, loop
const kept = told => {
  const fixed = told.slice(at_number)
  if (buffer !== memory() || fixed.length !== last.length || fixed.some((x, k) => !Object.is(x, last[k]))) {
    buffer = memory()
    heap = views(buffer)
    last = fixed
    loop = begun()
  }
  return loop
}"""
Loop = Callable[..., Any]


class Doubt(Exception):
    """Translated code has come to what JavaScript might do otherwise, or to an error: the interpreter repeats it."""


class Engine(Protocol):
    """Runs JavaScript.

    Attributes:
        libm: the functions of the library of mathematics that give there what they give to Python, bit for bit.
    """

    libm: frozenset[str]

    def load(self, text: str) -> Callable[[Sequence[float]], Sequence[float]]:
        """Returns a function that runs a translation, with the numbers of its arguments and those of its result.

        `text` is the body of a JavaScript function of `memory` (which gives the ArrayBuffer), `draw` (which has
        next_double, normal and exponential of the state of a random stream, and bounded) and `libm`. Where the
        translation throws an error, the function raises `Doubt`.
        """

    def address(self, array: Any) -> int:
        """Returns where in the memory an array begins, in bytes."""

    def stream(self, rng: np.random.Generator) -> int:
        """Returns where in the memory the state of a random stream is."""


engine: Engine | None = None
"""What runs translations here; None where there is no JavaScript."""


def translated(loop: Loop, arguments: tuple[Any, ...], on: Engine) -> Loop:
    """Translates the loop to JavaScript, for arguments like these.

    Args:
        loop: a plain function whose first argument is a number.
        arguments: the other arguments, or values of the same kinds.
        on: what runs the translation.

    Raises:
        Untranslatable: there is no translation that does the same for sure.
    """
    program = Program(loop, arguments, on.libm)
    run: Callable[[Sequence[float]], Sequence[float]] | None = None
    fixed, loads = list[float](), 0

    def call(n: int, *given: Any) -> Any:
        nonlocal run, fixed, loads
        told = [[*_numbers(value, kind, on)] for value, kind in zip(given, program.given, strict=True)]
        carry = told.pop() if program.carries else []
        told += [[*_numbers(array, kind_of(array, "a constant"), on)] for array in program.constants.arrays]
        now = [*chain.from_iterable(told)]
        if run is None or (now != fixed and loads < MOST_LOADS):
            run, loads = on.load(f"{program.text}\n//{next(_numbered)}"), loads + 1
        fixed = now
        return program.result_of(iter(run([float(n), *carry, *now])))

    return call


def _numbers(value: Any, kind: Kind, on: Engine) -> Iterator[float]:
    """Yields the numbers that tell translated code a value."""
    if isinstance(kind, Tuple):
        if not isinstance(value, tuple) or (kind.type is not None and type(value) is not kind.type):
            raise Doubt("an argument of another type")
        for part, inner in zip(tuple.__iter__(value), kind.parts, strict=True):
            yield from _numbers(part, inner, on)
    elif isinstance(kind, Array):
        if kind_of(value, "an array")[:2] != kind[:2] or any(one % value.itemsize for one in value.strides):
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


class Program(Known):
    """A translation of the loop and of all functions that it reaches.

    Attributes:
        text: the body of a JavaScript function, for `Engine.load`.
        given: the kinds of the arguments after the first.
        carries: whether the last of them is what the loop carries from call to call; the others stay the same in a run.
    """

    def __init__(self, loop: Loop, arguments: tuple[Any, ...], libm: frozenset[str]) -> None:
        """Translates the loop for arguments like these; the program may call the functions of `libm`."""
        super().__init__(libm)
        names = list(inspect.signature(loop).parameters)
        carries = names[-1] == "carry"  # what the next call begins with
        given = [
            kind if name == "carry" else with_names(kind, f"h{k}")
            for k, (one, name) in enumerate(zip(arguments, names[1:], strict=True))
            for kind in [kind_of(one, name)]
        ]
        key = (loop, "the loop")
        for _ in range(MOST_PASSES):
            self.begin_pass()
            main = self._write(_plain(loop), key, dict(zip(names, [INT, *given], strict=True)))
            result = without_names(self.results[key])
            if carries:
                given[-1] = joined(given[-1], result)
            if not self.changed and (not carries or result == given[-1]):
                break
        else:
            raise Untranslatable("the types of its variables are not to be found out")
        self.given, self.carries, self._result = given, carries, result
        _require_plain(result, "what goes from step to step (state, observation, action)")
        self.text = self._whole(main)

    def begin_pass(self) -> None:
        """Forgets all that is written, but no kinds."""
        super().begin_pass()
        self._functions: dict[Any, str] = {}
        self._texts: list[str] = []
        self._open: set[Any] = set()

    def function(self, called: FunctionType, kinds: dict[str, Kind]) -> Code | None:
        """See `Known`; writes the function, if this pass has not written it for arguments of these kinds."""
        key = (called, tuple(kinds.values()))
        if key in self._open or len(self._open) > MOST_DEEP:
            return None
        if key not in self._functions:
            known_as = called.__name__ if called.__name__.isidentifier() else ""
            self._functions[key] = name = f"f{len(self._functions)}_{known_as}"
            self._texts.append(f"function {name}{self._write(called, key, kinds)}")
        return Code(self._functions[key], self.results[key])

    def _write(self, function: FunctionType, key: Any, kinds: dict[str, Kind]) -> str:
        self._open.add(key)
        text, result = Writer(self, function, key).write(source_of(function), kinds)
        self._open.discard(key)
        self.note_result(key, result)
        return text

    # The text

    def _whole(self, main: str) -> str:
        known, kinds = self.constants, [kind_of(one, "a constant") for one in self.constants.arrays]
        fixed = self.given[:-1] if self.carries else self.given
        told = [("carry", self.given[-1])] if self.carries else []
        named = [(f"{letter}{k}", kind) for letter, some in (("h", fixed), ("g", kinds)) for k, kind in enumerate(some)]
        made = {name: self._made(kind) for name, kind in told + named}  # first, since it may add classes
        classes = [
            f"class {name}{{constructor({parts}){{{fields}}}}}"
            for name, count in known.classes.values()
            for parts in [",".join(f"a{k}" for k in range(count))]
            for fields in ["".join(f"this.a{k}=a{k};" for k in range(count))]
        ]
        defined = [text for name, kind in named for text in (f"{name}={made[name]}", *constants(kind, name))]
        given = ",".join([*(f"h{k}" for k in range(len(fixed))), *(["carry"] if self.carries else [])])
        return "\n".join(
            [
                "'use strict'",
                RUNTIME.read_text(encoding="utf-8"),
                *classes,
                "let numbers,at_number,heap",
                "const next=()=>numbers[at_number++]",
                *(f"const o{k}={text}" for k, text in enumerate(known.operations)),
                "const begun=()=>{",
                *(f"const {text}" for text in [*defined, *known.tuples]),
                *self._texts,
                f"function loop{main}",
                f"return (n,carry)=>loop(n,{given})",
                "}",
                KEPT,
                f"return told=>{{numbers=told;at_number=0;const n=integer(next()),carry={made.get('carry', 'null')}",
                "const result=kept(told)(n,carry)",
                f"return [{','.join(_told('result', self._result))}]",
                "}",
            ]
        )

    def _made(self, kind: Kind) -> str:
        """Writes what makes an argument of the next numbers."""
        if isinstance(kind, Tuple):
            return f"new {self.constants.tuple_class(kind)}({','.join(map(self._made, kind.parts))})"
        if isinstance(kind, Array):
            axes = "[" + ",".join(["small(next())"] * kind.ndim) + "]"
            return f"{ARRAYS[kind.of]}.of(heap.{HEAPS[kind.of]},small(next()),{axes},{axes})"
        if kind == BOOL:
            return "next()!==0"
        if kind in (INT, RNG):
            return "integer(next())"
        return "next()" if kind == FLOAT else "null"

    def result_of(self, numbers: Iterator[float]) -> Any:
        """Returns what the loop returns, made of its numbers."""
        return _value(self._result, numbers)


def _told(text: str, kind: Kind) -> Iterator[str]:
    """Yields, in JavaScript, the numbers of a result."""
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
    """Refuses a result that JavaScript cannot hand back."""
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

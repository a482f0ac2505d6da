"""Writes the use of arrays that stay the same in all of a run, by names for their data, offset, lengths and strides.

These are the arrays in the arguments of the loop, such as the table of an agent. V8 runs code with such constants about
twice as fast as code that asks an object for them at every step.
"""

from collections.abc import Iterator, Sequence

from edugym.compiled.javascript.kinds import BOOL, FLOAT, INT, Array, Kind, Tuple

ELEMENT = {FLOAT: "{}[{}]", INT: "whole64({},{})", BOOL: "({}[{}]!==0)"}
PUT = {FLOAT: "{}[{}]={};", INT: "put64({},{},{});", BOOL: "{}[{}]={};"}


def with_names(kind: Kind, name: str) -> Kind:
    """Returns the kind of an argument that has a name, with names for all that is in it."""
    if isinstance(kind, Tuple):
        parts = tuple(with_names(part, f"{name}_{k}") for k, part in enumerate(kind.parts))
        return Tuple(kind.type, parts, name)
    return kind._replace(name=name) if isinstance(kind, Array) else kind


def without_names(kind: Kind) -> Kind:
    """Returns the kind of any value of the same type."""
    if isinstance(kind, Tuple):
        return Tuple(kind.type, tuple(map(without_names, kind.parts)))
    return kind._replace(name=None) if isinstance(kind, Array) else kind


def constants(kind: Kind, name: str) -> Iterator[str]:
    """Yields the definitions of the constants for a value that has a name, and for all that is in it."""
    if isinstance(kind, Tuple):
        for k, part in enumerate(kind.parts):
            yield f"{name}_{k}={name}.a{k}"
            yield from constants(part, f"{name}_{k}")
    elif isinstance(kind, Array):
        yield f"{name}_d={name}.data,{name}_o={name}.offset"
        yield from (f"{name}_n{k}={name}.shape[{k}],{name}_s{k}={name}.strides[{k}]" for k in range(kind.ndim))


def place(array: Array, indices: Sequence[str]) -> str:
    """Writes where in the data of an array that has a name an element or the row of a table begins."""
    name = array.name
    return "+".join([f"{name}_o", *(f"at({one},{name}_n{k})*{name}_s{k}" for k, one in enumerate(indices))])


def element(array: Array, at: str) -> str:
    """Writes the element at a place of the data of an array that has a name."""
    return ELEMENT[array.of].format(f"{array.name}_d", at)


def put(array: Array, at: str, value: str) -> str:
    """Writes the statement that puts a value at a place of the data of an array that has a name."""
    return PUT[array.of].format(f"{array.name}_d", at, value)


def line(array: Array, indices: Sequence[str] = ()) -> str:
    """Writes data, offset, length and stride of an array of one axis that has a name, or of such a row of it."""
    k = len(indices)
    return f"{array.name}_d,{place(array, indices)},{array.name}_n{k},{array.name}_s{k}"

"""Reads Python's byte code: which global names it uses, its constants, the variables of outer functions, its lines."""

import dis
from types import CellType, CodeType
from typing import Any

EXTENDED_ARG, LOAD_GLOBAL = dis.opmap["EXTENDED_ARG"], dis.opmap["LOAD_GLOBAL"]


def global_names(code: CodeType) -> set[str]:
    """The names that byte code looks up among the globals, and not as attributes, those of inner functions included.

    Decoded by hand: `dis` takes ten times as long, and a run begins with some hundred functions.
    """
    names: set[str] = set()
    high = 0
    for operation, low in zip(code.co_code[::2], code.co_code[1::2], strict=True):
        argument = high | low
        high = argument << 8 if operation == EXTENDED_ARG else 0
        if operation == LOAD_GLOBAL:
            names.add(code.co_names[argument >> 1])  # its last bit is about a call
    return names.union(*(global_names(constant) for constant in code.co_consts if isinstance(constant, CodeType)))


def in_order(constant: Any) -> Any:
    """A constant of code in a form whose `repr` is the same in every process: sets have no order."""
    return ("set", sorted(repr(in_order(part)) for part in constant)) if isinstance(constant, frozenset) else constant


def inside(cell: CellType, default: Any = None) -> Any:
    """The value of a variable of an outer function, or `default` where it has none yet."""
    try:
        return cell.cell_contents
    except ValueError:
        return default


def place(file: str, line: int) -> str:
    """A line as its author knows it: without the file of a notebook's cell, whose name is made of digits."""
    name = file.replace("\\", "/").rpartition("/")[2]
    stem = name.partition(".")[0]
    return f"line {line}" if stem.isdigit() or name.startswith("<ipython") else f"{name}, line {line}"

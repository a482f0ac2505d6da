"""Finds the source of a function, which the translator reads, and makes sure that it is that of the code that runs."""

import ast
import linecache
from collections.abc import Iterator
from functools import cache
from types import CodeType, FunctionType

from edugym.compiled.byte_code import place
from edugym.compiled.javascript.kinds import Untranslatable


def source_of(function: FunctionType) -> ast.FunctionDef:
    """Returns the definition of a function, in the text from which Python made it.

    Raises:
        Untranslatable: the text is not there, or has changed since.
    """
    code = function.__code__
    if code.co_name == "<lambda>":
        where = place(code.co_filename, code.co_firstlineno)
        raise Untranslatable(f"it calls a lambda: write the function with def ({where})")
    found = _definition("".join(linecache.getlines(code.co_filename, function.__globals__)), code)
    if found is None:
        raise Untranslatable(
            f"the text of {function.__name__} is not there ({place(code.co_filename, code.co_firstlineno)})"
        )
    return found


@cache
def _definition(text: str, code: CodeType) -> ast.FunctionDef | None:
    """Returns the definition from which Python made this code; None if the text has no such definition."""
    try:
        tree = ast.parse(text)
    except SyntaxError:
        return None
    _write_private_names(tree, "")
    for node in ast.walk(tree):
        if not isinstance(node, ast.FunctionDef) or node.name != code.co_name:
            continue
        if min([node.lineno, *(one.lineno for one in node.decorator_list)]) == code.co_firstlineno:
            made = _codes(compile(text, code.co_filename, "exec", dont_inherit=True))
            places = (code.co_name, code.co_firstlineno)
            there = (one for one in made if (one.co_name, one.co_firstlineno) == places)
            return node if any(_is_same(one, code) for one in there) else None
    return None


def _write_private_names(node: ast.AST, owner: str) -> None:
    """Writes names with two underscores in a class as Python takes them: `__x` in a class T is `_T__x`."""
    for child in ast.iter_child_nodes(node):
        for kind in ("id", "attr", "arg"):
            name = getattr(child, kind, None)
            if owner and isinstance(name, str) and name.startswith("__") and not name.endswith("__"):
                setattr(child, kind, f"_{owner}{name}")
        _write_private_names(child, child.name.lstrip("_") if isinstance(child, ast.ClassDef) else owner)


def _is_same(one: CodeType, other: CodeType) -> bool:
    """Returns whether two codes do the same, with the same names and constants: 0, 0.0 and -0.0 are three."""
    names = ("co_code", "co_names", "co_varnames", "co_freevars", "co_cellvars")
    constants = [*zip(one.co_consts, other.co_consts, strict=False)]
    return (
        all(getattr(one, name) == getattr(other, name) for name in names)
        and len(one.co_consts) == len(other.co_consts)
        and all(
            _is_same(first, second)
            if isinstance(first, CodeType) and isinstance(second, CodeType)
            else (type(first), repr(first)) == (type(second), repr(second))
            for first, second in constants
        )
    )


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for one in code.co_consts:
        if isinstance(one, CodeType):
            yield from _codes(one)

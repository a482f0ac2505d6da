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
    for node in ast.walk(tree):
        if not isinstance(node, ast.FunctionDef) or node.name != code.co_name:
            continue
        if min([node.lineno, *(one.lineno for one in node.decorator_list)]) == code.co_firstlineno:
            made = _codes(compile(text, code.co_filename, "exec", dont_inherit=True))
            places = (code.co_name, code.co_firstlineno)
            same = (one for one in made if (one.co_name, one.co_firstlineno) == places)
            return node if any(one.co_code == code.co_code for one in same) else None
    return None


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for one in code.co_consts:
        if isinstance(one, CodeType):
            yield from _codes(one)

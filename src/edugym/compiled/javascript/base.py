"""Holds what all expressions need: kinds, constants, and the sentence that refuses an expression with its line."""

import ast
from collections.abc import Callable
from types import FunctionType
from typing import Any

from edugym.compiled.byte_code import place
from edugym.compiled.code import is_foreign
from edugym.compiled.javascript.kinds import (
    BOOL,
    INT,
    NEVER,
    NONE,
    NUMBERS,
    Code,
    Kind,
    List,
    Static,
    Tuple,
    Untranslatable,
    described,
    joined,
)
from edugym.compiled.javascript.known import Known


class Base:
    """Writes one function.

    Attributes:
        known: what is known of the program to which the function belongs.
        function: the function.
        key: the function and the kinds of its arguments.
    """

    def __init__(self, known: Known, function: FunctionType, key: Any) -> None:
        """See the class."""
        self.known, self.function, self.key = known, function, key
        self.assigned: set[str] = set()  # names that have a value for sure, here
        self.temporary: list[str] = []
        self.local = {*function.__code__.co_varnames, *function.__code__.co_cellvars}
        self.scopes: list[dict[str, Kind]] = []  # of comprehensions

    def refused(self, node: ast.AST, found: str) -> Untranslatable:
        """Returns the error that says what was found, and in which line of the student's code."""
        code = self.function.__code__
        line = getattr(node, "lineno", None) or code.co_firstlineno
        if not is_foreign(self.function):  # a student does not know the package's lines
            return Untranslatable(found)
        return Untranslatable(f"{found} ({place(code.co_filename, line)})")

    def joined(self, node: ast.AST, one: Kind, other: Kind) -> Kind:
        """Returns the kind of what may be of one kind or of the other."""
        try:
            return joined(one, other)
        except Untranslatable as error:
            raise self.refused(node, str(error)) from error

    def fresh(self) -> str:
        """Returns the name of a new variable in JavaScript."""
        self.temporary.append(f"t{len(self.temporary)}")
        return self.temporary[-1]

    def kind_of_name(self, name: str) -> Kind:
        """Returns the kind of a local variable."""
        return self.known.kinds.get((self.key, name), NEVER)

    def visit(self, node: ast.expr) -> Code:
        """Writes an expression."""
        method: Callable[[Any], Code] | None = getattr(self, f"_of_{type(node).__name__}", None)
        if method is None:
            raise self.refused(node, f"it has {_named(node)}")
        return method(node)

    def index(self, node: ast.expr) -> str:
        """Writes an index, and refuses one that is no whole number."""
        code = self.visit(node)
        if code.kind != INT and code.kind != NEVER:
            raise self.refused(node, f"its index is {described(code.kind)}, not a whole number")
        return code.text

    def constant(self, node: ast.AST, value: Any, name: str) -> Code:
        """Writes a value that is known before the program runs."""
        try:
            return self.known.constants.code(value, name)
        except Untranslatable as error:
            raise self.refused(node, str(error)) from error

    def libm(self, node: ast.AST, name: str, *texts: str) -> str:
        """Writes a call of the library of mathematics."""
        if name not in self.known.libm:
            known = {"pow": "a power of real numbers"}.get(name, name)
            raise self.refused(node, f"it uses {known}, whose last digit JavaScript may have otherwise")
        return f"finiteOf(libm.{name}({','.join(texts)}))"

    def tuple_of(self, kind: type | None, parts: list[Code]) -> Code:
        """Writes a new tuple; `kind` is its class, or None for a plain tuple."""
        made = Tuple(kind, tuple(part.kind for part in parts))
        return Code(f"new {self.known.constants.tuple_class(made)}({','.join(part.text for part in parts)})", made)

    def list_at(self, node: ast.AST) -> List:
        """Returns the kind of the list that is made at a place."""
        return List((self.key, getattr(node, "lineno", 0), getattr(node, "col_offset", 0)))

    def widen(self, node: ast.AST, kind: List, part: Kind) -> None:
        """Notes that the program puts something of kind `part` into a list."""
        try:
            self.known.widen(kind, part)
        except Untranslatable as error:
            raise self.refused(node, str(error)) from error

    def truth(self, node: ast.AST, code: Code) -> str:
        """Writes the test whether Python takes a value for true."""
        if code.kind == BOOL:
            return code.text
        if code.kind in NUMBERS:
            return f"({code.text}!==0)"
        if isinstance(code.kind, List):
            return f"({code.text}.length!==0)"
        if code.kind in (NONE, NEVER):
            return f"({code.text},false)"
        if isinstance(code.kind, Static) and isinstance(code.kind.value, str):
            return str(bool(code.kind.value)).lower()
        raise self.refused(node, f"it asks whether {described(code.kind)} is true")


def _named(node: ast.AST) -> str:
    names = {
        "Lambda": "a lambda",
        "Dict": "a dict",
        "Set": "a set",
        "JoinedStr": "text",
        "GeneratorExp": "a for in a call",
        "NamedExpr": "a :=",
    }
    return names.get(type(node).__name__, f"a {type(node).__name__}")

"""What all expressions need: their kinds, constants, and the sentence that refuses them with their line."""

import ast
from collections.abc import Callable
from types import FunctionType
from typing import TYPE_CHECKING, Any

from edugym.compiled.javascript.kinds import (
    BOOL,
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

if TYPE_CHECKING:
    from edugym.compiled.javascript.program import Program


class Base:
    """Writes one function.

    Attributes:
        program: of which it is a part.
        function: the function.
        key: the function and the kinds of its arguments.
    """

    def __init__(self, program: "Program", function: FunctionType, key: Any) -> None:
        """See the class."""
        self.program, self.function, self.key = program, function, key
        self.assigned: set[str] = set()  # names that have a value for sure, here
        self.temporary: list[str] = []
        self.local = {*function.__code__.co_varnames, *function.__code__.co_cellvars}
        self.scopes: list[dict[str, Kind]] = []  # of comprehensions

    def refused(self, node: ast.AST, found: str) -> Untranslatable:
        """The error that names the line of the student's code."""
        return Untranslatable(self.program.placed(found, self.function, getattr(node, "lineno", None)))

    def joined(self, node: ast.AST, one: Kind, other: Kind) -> Kind:
        """The kind of what is of one kind or of the other."""
        try:
            return joined(one, other)
        except Untranslatable as error:
            raise self.refused(node, str(error)) from error

    def fresh(self) -> str:
        """A new variable of JavaScript's."""
        self.temporary.append(f"t{len(self.temporary)}")
        return self.temporary[-1]

    def kind_of_name(self, name: str) -> Kind:
        """The kind of a local variable."""
        kind: Kind = self.program.kinds.get((self.key, name), NEVER)
        return kind

    def visit(self, node: ast.expr) -> Code:
        """An expression."""
        method: Callable[[Any], Code] | None = getattr(self, f"_of_{type(node).__name__}", None)
        if method is None:
            raise self.refused(node, f"it has {_named(node)}")
        return method(node)

    def constant(self, node: ast.AST, value: Any, name: str) -> Code:
        """A value that is known by now."""
        try:
            text, kind = self.program.constant(value, name)
        except Untranslatable as error:
            raise self.refused(node, str(error)) from error
        return Code(text, kind)

    def tuple_of(self, kind: type | None, parts: list[Code]) -> Code:
        """A new tuple."""
        made = Tuple(kind, tuple(part.kind for part in parts))
        return Code(f"new {self.program.tuple_class(made)}({','.join(part.text for part in parts)})", made)

    def list_at(self, node: ast.AST) -> List:
        """The kind of a list that is made at a place."""
        return List((self.key, getattr(node, "lineno", 0), getattr(node, "col_offset", 0)))

    def widen(self, node: ast.AST, kind: List, part: Kind) -> None:
        """Notes that something is put into a list."""
        try:
            self.program.widen(kind, part)
        except Untranslatable as error:
            raise self.refused(node, str(error)) from error

    def truth(self, node: ast.AST, code: Code) -> str:
        """Whether Python takes a value for true."""
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
    }
    return names.get(type(node).__name__, f"a {type(node).__name__}")

"""Writes in JavaScript how a `for` goes through lists, tuples, arrays, and range, enumerate and zip."""

import ast
from typing import Any, NamedTuple

from edugym.compiled.javascript.kinds import (
    INT,
    NEVER,
    Array,
    Code,
    Kind,
    List,
    Static,
    Tuple,
    described,
)
from edugym.compiled.javascript.operations import Operations


class Iteration(NamedTuple):
    """Tells in JavaScript how a `for` goes through something.

    Attributes:
        begin: the statements before the loop, which evaluate once what it goes through.
        more: the test whether there is another value.
        advance: the expression that goes on to the next value.
        value: the present value.
    """

    begin: str
    more: str
    advance: str
    value: Code


class Iterations(Operations):
    """Writes what a `for` goes through."""

    def iteration(self, node: ast.expr) -> Iteration:
        """Returns how a `for` goes through what stands after `in`."""
        if isinstance(node, ast.Call):
            called = self.visit(node.func).kind if isinstance(node.func, ast.Name) else None
            if isinstance(called, Static) and called.value in (range, enumerate, zip):
                return self._special(node, called.value)
        return self.through(node, self.visit(node))

    def through(self, node: ast.AST, code: Code) -> Iteration:
        """Returns how a `for` goes through a list, a tuple or an array."""
        held, k = self.fresh(), self.fresh()
        kind = code.kind
        if isinstance(kind, Tuple):
            found: Kind = NEVER
            for one in kind.parts:
                found = self.joined(node, found, one)
            value, text, size = Code(f"{held}[{k}]", found), self.as_list(code), f"{held}.length"
        elif isinstance(kind, List):
            value, text, size = Code(f"{held}[{k}]", self.known.part(kind)), code.text, f"{held}.length"
        elif isinstance(kind, Array):
            of = kind.of if kind.ndim == 1 else Array(kind.of, kind.ndim - 1, kind.frozen)
            get = f"{held}.at1({k})" if kind.ndim == 1 else f"{held}.part({k})"
            value, text, size = Code(get, of), code.text, f"{held}.length"
        elif kind == NEVER:
            value, text, size = Code(f"{held}[{k}]", NEVER), f"({code.text},[])", f"{held}.length"
        else:
            raise self.refused(node, f"it goes through {described(kind)}")
        return Iteration(f"{held}={text};{k}=0;", f"{k}<{size}", f"{k}++", value)

    def _special(self, node: ast.Call, called: Any) -> Iteration:
        if called is range:
            if node.keywords or not 1 <= len(node.args) <= 3:
                raise self.refused(node, "it calls range with other arguments")
            bounds = [self.index(one) for one in node.args]
            begin, end, step = {1: ["0", *bounds, "1"], 2: [*bounds, "1"], 3: bounds}[len(bounds)]
            k, last, by = self.fresh(), self.fresh(), self.fresh()
            first = f"{k}={begin};{last}={end};{by}={step};"
            if len(bounds) < 3:
                return Iteration(first, f"{k}<{last}", f"{k}++", Code(k, INT))
            check = f"if({by}===0)doubt('a range of step 0');"
            return Iteration(first + check, f"({by}>0?{k}<{last}:{k}>{last})", f"{k}+={by}", Code(k, INT))
        if called is enumerate:
            start = [*node.args[1:], *(keyword.value for keyword in node.keywords)]
            inner, k = self.iteration(node.args[0]), self.fresh()
            begin = f"{k}={self.index(start[0]) if start else '0'};"
            value = self.tuple_of(None, [Code(k, INT), inner.value])
            return Iteration(inner.begin + begin, inner.more, f"{inner.advance},{k}++", value)
        if node.keywords or not node.args:
            raise self.refused(node, "it calls zip with strict")
        parts = [self.iteration(one) for one in node.args]
        return Iteration(
            "".join(part.begin for part in parts),
            "&&".join(part.more for part in parts),
            ",".join(part.advance for part in parts),
            self.tuple_of(None, [part.value for part in parts]),
        )

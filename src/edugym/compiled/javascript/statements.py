"""Writes the statements of one function in JavaScript, for arguments of given kinds.

A variable has one kind in all of its function, and a value wherever it is used. The writer finds out the kinds while it
writes, so the program is written again until no kind changes any more (`edugym.compiled.javascript.program`).
"""

import ast
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from edugym.compiled.code import is_foreign
from edugym.compiled.javascript import named
from edugym.compiled.javascript.expressions import Expressions, Written
from edugym.compiled.javascript.kinds import (
    FROZEN,
    INT,
    MIXED,
    NEVER,
    NONE,
    Array,
    Code,
    Kind,
    List,
    Tuple,
    Untranslatable,
    described,
    joined,
)


class Writer(Expressions):
    """Writes one function."""

    def write(self, node: ast.FunctionDef, kinds: dict[str, Kind]) -> tuple[str, Kind]:
        """Writes the function, without its name, and returns the kind of its result with it."""
        if node.args.vararg or node.args.kwarg or node.args.kwonlyargs:
            raise self.refused(node, "it has parameters with *")
        self.result: Kind = NEVER
        self.gives_nothing = False
        for name, kind in kinds.items():
            self.known.note((self.key, name), kind)
            self.assigned.add(name)
        body, ends = self.block(node.body)
        if not ends or self.gives_nothing:
            end = "" if ends else ("return null" if self.result == NEVER else "doubt('nothing is returned')")
            self.result = NONE if self.result == NEVER else self.result
            body += end
        if self.result == MIXED and node.name in ("act", "greedy") and is_foreign(self.function):
            raise self.refused(node, f"{node.name} returns a number that is whole in one place and real in another")
        names = [f"${name}" for name in sorted(self.local - set(kinds))] + self.temporary
        declared = f"let {','.join(names)};" if names else ""
        return f"({','.join(f'${name}' for name in kinds)}){{{declared}{body}}}", self.result

    def bind(self, node: ast.AST, target: ast.expr, value: Code) -> str:
        """Writes the statement that assigns to a name, to several, or to a part of an array or a list."""
        if isinstance(target, ast.Name):
            try:
                self.known.note((self.key, target.id), value.kind)
            except Untranslatable as error:
                raise self.refused(node, str(error).replace("one name", target.id)) from error
            self.assigned.add(target.id)
            return f"${target.id}={value.text};"
        if isinstance(target, ast.Tuple | ast.List):
            if not isinstance(value.kind, Tuple) or len(value.kind.parts) != len(target.elts):
                raise self.refused(node, f"it takes {described(value.kind)} apart")
            whole = self.fresh()
            parts = enumerate(zip(target.elts, value.kind.parts, strict=True))
            return f"{whole}={value.text};" + "".join(
                self.bind(node, one, Code(f"{whole}.a{k}", kind)) for k, (one, kind) in parts
            )
        if isinstance(target, ast.Subscript):
            owner, held = self.owner(target), self.fresh()
            given = self.fresh()
            begin = f"{given}={value.text};{held}={owner.text};"
            return begin + self.put(node, Code(held, owner.kind), target.slice, Code(given, value.kind))
        raise self.refused(node, f"it assigns {ast.unparse(target)}")

    def put(self, node: ast.AST, owner: Code, index: ast.expr, value: Code) -> str:
        """Writes the statement that assigns to a part of an array or a list, which a variable holds."""
        if isinstance(owner.kind, List):
            if isinstance(index, ast.Slice):
                raise self.refused(node, "it assigns to several places of a list at once")
            self.widen(node, owner.kind, value.kind)
            return f"putItem({owner.text},{self.index(index)},{value.text});"
        if owner.kind == NEVER:
            return ""
        if not isinstance(owner.kind, Array):
            raise self.refused(node, f"it assigns to a part of {described(owner.kind)}")
        array = owner.kind
        if array.frozen:
            raise self.refused(node, FROZEN)
        indices = self.indices(index)
        alone = self.is_one_place(node, array, indices)
        self.require_fits(node, array.of, value.kind, alone=alone)
        if alone:
            texts = list(map(self.index, indices))
            if array.name:
                return named.put(array, named.place(array, texts), value.text)
            return f"{owner.text}.put{array.ndim}({','.join(texts)},{value.text});"
        part = self.part(owner, indices)
        return f"assign({part.text},{self.spreadable(node, value, array.of)});"

    # Statements: each gives its text, and whether what follows is never reached

    def block(self, body: list[ast.stmt]) -> tuple[str, bool]:
        """Writes the statements of a block, and tells whether what follows is never reached."""
        texts, ends = [], False
        for statement in body:
            if ends:
                break
            method: Callable[[Any], tuple[str, bool]] | None = getattr(self, f"_do_{type(statement).__name__}", None)
            if method is None:
                raise self.refused(statement, f"it has a {type(statement).__name__.lower()}")
            text, ends = method(statement)
            texts.append(text)
        return "".join(texts), ends

    def _do_Expr(self, node: ast.Expr) -> tuple[str, bool]:
        if isinstance(node.value, ast.Constant):
            return "", False
        return f"{self.visit(node.value).text};", False

    def _do_Pass(self, node: ast.Pass) -> tuple[str, bool]:
        return "", False

    def _do_Assign(self, node: ast.Assign) -> tuple[str, bool]:
        value, (first, *others) = self.visit(node.value), node.targets
        if not others:
            return self.bind(node, first, value), False
        held = self.fresh()
        return f"{held}={value.text};" + "".join(
            self.bind(node, target, Code(held, value.kind)) for target in node.targets
        ), False

    def _do_AnnAssign(self, node: ast.AnnAssign) -> tuple[str, bool]:
        return ("", False) if node.value is None else (self.bind(node, node.target, self.visit(node.value)), False)

    def _do_AugAssign(self, node: ast.AugAssign) -> tuple[str, bool]:
        target, operation = node.target, type(node.op)
        if isinstance(target, ast.Name):
            before = self.visit(ast.copy_location(ast.Name(target.id, ast.Load()), target))
            if isinstance(before.kind, Array):
                return self.in_place(node, before, self.visit(node.value)), False
            if isinstance(before.kind, List):
                raise self.refused(node, "it changes a list in place: use append")
            return self.bind(node, target, self.operation(node, operation, before, self.visit(node.value))), False
        if not isinstance(target, ast.Subscript):
            raise self.refused(node, f"it assigns {ast.unparse(target)}")
        owner, indices = self.owner(target), self.indices(target.slice)
        kind, names = owner.kind, list[ast.expr]()
        if isinstance(kind, Array) and kind.name and self.is_one_place(node, kind, indices):
            return self._augment(node, operation, kind, [self.index(one) for one in indices]), False
        held = self.fresh()
        begin = f"{held}={owner.text};"
        if isinstance(kind, Array) and (len(indices) < kind.ndim or any(isinstance(one, ast.Slice) for one in indices)):
            part, whole = self.part(Code(held, kind), indices), self.fresh()
            return f"{begin}{whole}={part.text};" + self.in_place(
                node, Code(whole, part.kind), self.visit(node.value)
            ), False
        for one in indices:
            name, index = self.fresh(), self.index(one)
            begin += f"{name}={index};"
            names.append(Written(Code(name, INT)))
        slices = names[0] if len(names) == 1 else ast.Tuple([*names], ast.Load())
        before, present = self.item(node, Code(held, kind), slices), self.fresh()
        begin += f"{present}={before.text};"
        after = self.operation(node, operation, Code(present, before.kind), self.visit(node.value))
        given = self.fresh()
        return f"{begin}{given}={after.text};" + self.put(
            node, Code(held, kind), slices, Code(given, after.kind)
        ), False

    def _augment(self, node: ast.AugAssign, operation: type, array: Array, indices: list[str]) -> str:
        """Writes the statement that changes an element of an array that has a name."""
        if array.frozen:
            raise self.refused(node, FROZEN)
        place, present, given = self.fresh(), self.fresh(), self.fresh()
        begin = f"{place}={named.place(array, indices)};"
        value = self.visit(node.value)
        if array.of == value.kind == INT and operation is ast.Add and isinstance(node.value, ast.Constant | ast.Name):
            return f"{begin}add64({array.name}_d,{place},{value.text});"
        after = self.operation(node, operation, Code(present, array.of), value)
        self.require_fits(node, array.of, after.kind, alone=True)
        begin += f"{present}={named.element(array, place)};{given}={after.text};"
        return begin + named.put(array, place, given)

    def in_place(self, node: ast.AugAssign, array: Code, value: Code) -> str:
        """Writes the statement that changes an array in place."""
        kind: Any = array.kind
        if kind.frozen:
            raise self.refused(node, FROZEN)
        after = self.operation(node, type(node.op), Code(array.text, kind), value)
        if not isinstance(after.kind, Array) or after.kind.of != kind.of or after.kind.ndim > kind.ndim:
            raise self.refused(node, "it changes an array in place by what is of another type or shape")
        return f"assign({array.text},{after.text});"

    def _do_Return(self, node: ast.Return) -> tuple[str, bool]:
        value = Code("null", NONE) if node.value is None else self.visit(node.value)
        if value.kind == NONE:
            known = self.known.results.get(self.key, NEVER)
            self.gives_nothing = True
            if known not in (NEVER, NONE):
                return f"{value.text};doubt('nothing is returned');", True
            return f"return {value.text};", True
        try:
            self.result = joined(self.result, value.kind)
        except Untranslatable as error:
            raise self.refused(node, str(error).replace("one name stands for", "it returns")) from error
        return f"return {value.text};", True

    def _do_Raise(self, node: ast.Raise) -> tuple[str, bool]:
        return "doubt('an error of the author');", True

    def _do_Assert(self, node: ast.Assert) -> tuple[str, bool]:
        return f"if(!{self.truth(node, self.visit(node.test))})doubt('assert');", False

    def _do_If(self, node: ast.If) -> tuple[str, bool]:
        test = self.truth(node, self.visit(node.test))
        before = set(self.assigned)
        then, then_ends = self.block(node.body)
        after_then, self.assigned = self.assigned, before
        other, other_ends = self.block(node.orelse)
        if then_ends != other_ends:
            self.assigned = self.assigned if then_ends else after_then
        elif not then_ends:
            self.assigned &= after_then
        return f"if({test}){{{then}}}else{{{other}}}", then_ends and other_ends

    @contextmanager
    def once_or_never(self) -> Iterator[None]:
        """Forgets afterwards what is assigned within, since that may never happen."""
        before = set(self.assigned)
        yield
        self.assigned = before

    def _do_While(self, node: ast.While) -> tuple[str, bool]:
        if node.orelse:
            raise self.refused(node, "it has an else after a while")
        test = self.truth(node, self.visit(node.test))
        with self.once_or_never():
            body, _ = self.block(node.body)
        endless = isinstance(node.test, ast.Constant) and bool(node.test.value)
        leaves = any(isinstance(one, ast.Break) for one in _of_this_loop(node.body))
        return f"while({test}){{{body}}}", endless and not leaves

    def _do_For(self, node: ast.For) -> tuple[str, bool]:
        if node.orelse:
            raise self.refused(node, "it has an else after a for")
        through = self.iteration(node.iter)
        with self.once_or_never():
            bound = self.bind(node, node.target, through.value)
            body, _ = self.block(node.body)
        return f"{{{through.begin}for(;{through.more};{through.advance}){{{bound}{body}}}}}", False

    def _do_Break(self, node: ast.Break) -> tuple[str, bool]:
        return "break;", True

    def _do_Continue(self, node: ast.Continue) -> tuple[str, bool]:
        return "continue;", True


def _of_this_loop(body: list[ast.stmt]) -> Iterator[ast.stmt]:
    """Yields the statements of a loop, but not those of the loops within it."""
    for statement in body:
        yield statement
        if isinstance(statement, ast.If):
            yield from _of_this_loop([*statement.body, *statement.orelse])

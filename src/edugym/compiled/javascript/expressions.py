"""Writes expressions in JavaScript: names, parts of things, and new lists and tuples; and passes calls on."""

import ast
from inspect import getattr_static
from types import FunctionType, ModuleType
from typing import Any

from edugym.compiled.byte_code import inside
from edugym.compiled.javascript import named
from edugym.compiled.javascript.calls import call, own_function
from edugym.compiled.javascript.iterations import Iterations
from edugym.compiled.javascript.kinds import (
    ARRAYS,
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

MOST_DIMENSIONS = 3
"""An array may have so many dimensions if code uses single elements of it."""


class Written(ast.expr):
    """Holds an expression that is written already."""

    def __init__(self, code: Code) -> None:
        """See the class."""
        super().__init__()
        self.code = code


class Expressions(Iterations):
    """Writes the expressions of one function."""

    def _of_Call(self, node: ast.Call) -> Code:
        return call(self, node)

    def _of_Written(self, node: Written) -> Code:
        return node.code

    def _of_Constant(self, node: ast.Constant) -> Code:
        return self.constant(node, node.value, ast.unparse(node))

    def _of_Name(self, node: ast.Name) -> Code:
        for scope in reversed(self.scopes):
            if node.id in scope:
                return Code(f"${node.id}", scope[node.id])
        code = self.function.__code__
        if node.id in self.local:
            if node.id not in self.assigned:
                raise self.refused(node, f"the variable {node.id} may have no value")
            return Code(f"${node.id}", self.kind_of_name(node.id))
        if node.id in code.co_freevars:
            cell = (self.function.__closure__ or ())[code.co_freevars.index(node.id)]
            return self.constant(node, inside(cell), node.id)
        missing = object()
        builtins: Any = self.function.__globals__.get("__builtins__", {})
        space = builtins if isinstance(builtins, dict) else vars(builtins)
        value = self.function.__globals__.get(node.id, space.get(node.id, missing))
        if value is missing:
            raise self.refused(node, f"there is no {node.id}")
        return self.constant(node, value, node.id)

    def _of_Attribute(self, node: ast.Attribute) -> Code:
        owner = self.visit(node.value)
        kind = owner.kind
        if isinstance(kind, Static):
            if isinstance(kind.value, ModuleType) and kind.value.__name__.startswith("numpy.random"):
                raise self.refused(node, "it draws from np.random, which no seed of a run reaches: draw from rng")
            if not hasattr(kind.value, node.attr):
                raise self.refused(node, f"it uses {ast.unparse(node)}")
            return self.constant(node, getattr(kind.value, node.attr), ast.unparse(node))
        if isinstance(kind, Tuple) and kind.type is not None:
            return self.member(node, owner, kind)
        if isinstance(kind, Array) and node.attr == "shape":
            shape = Tuple(None, (INT,) * kind.ndim)
            made = f"new {self.known.constants.tuple_class(shape)}"
            if kind.name:
                return Code(f"{made}({','.join(f'{kind.name}_n{k}' for k in range(kind.ndim))})", shape)
            held = self.fresh()
            sizes = ",".join(f"{held}[{k}]" for k in range(kind.ndim))
            return Code(f"({held}={owner.text}.shape,{made}({sizes}))", shape)
        if isinstance(kind, Array) and node.attr == "size":
            return Code(f"{owner.text}.size", INT)
        if isinstance(kind, Array) and node.attr == "ndim":
            return Code(str(kind.ndim), INT)
        if kind == NEVER:
            return owner
        raise self.refused(node, f"it uses .{node.attr} of {described(kind)}")

    def field(self, owner: Code, k: int) -> Code:
        """Writes a part of a tuple."""
        kind: Any = owner.kind
        text = f"{kind.name}_{k}" if kind.name else f"{owner.text}.a{k}"
        part = kind.parts[k]
        alone = isinstance(part, Array) and part.name and part.ndim == 1
        return Code(text, part, line=named.line(part) if alone else None)

    def member(self, node: ast.Attribute, owner: Code, kind: Tuple) -> Code:
        """Writes a field, a property or a constant of a NamedTuple."""
        fields: Any = getattr(kind.type, "_fields", ())
        found = getattr_static(kind.type, node.attr, None)
        if node.attr in fields:
            k = fields.index(node.attr)
            return self.field(owner, k)
        if isinstance(found, property) and isinstance(found.fget, FunctionType):
            return own_function(self, node, found.fget, [owner], {})
        if found is None or isinstance(found, FunctionType | classmethod | staticmethod):
            raise self.refused(node, f"it uses {ast.unparse(node)}")
        return self.constant(node, found, ast.unparse(node))

    def _of_Tuple(self, node: ast.Tuple) -> Code:
        return self.tuple_of(None, [self.visit(one) for one in node.elts])

    def _of_List(self, node: ast.List) -> Code:
        site = self.list_at(node)
        parts = [self.visit(one) for one in node.elts]
        for part in parts:
            self.widen(node, site, part.kind)
        return Code(f"[{','.join(part.text for part in parts)}]", site)

    def _of_ListComp(self, node: ast.ListComp) -> Code:
        if len(node.generators) != 1:
            raise self.refused(node, "it has two for in one [ ]")
        (generator,), site = node.generators, self.list_at(node)
        through = self.iteration(generator.iter)
        scope: dict[str, Kind] = {}
        bound = self._bind_in(node, generator.target, through.value, scope)
        self.scopes.append(scope)
        tests = "".join(f"if(!{self.truth(node, self.visit(one))})continue;" for one in generator.ifs)
        element = self.visit(node.elt)
        self.scopes.pop()
        self.widen(node, site, element.kind)
        loop = f"for(;{through.more};{through.advance}){{{bound}{tests}gathered.push({element.text});}}"
        return Code(f"(()=>{{const gathered=[];{through.begin}{loop}return gathered}})()", site)

    def _bind_in(self, node: ast.AST, target: ast.expr, value: Code, scope: dict[str, Kind]) -> str:
        """Writes the variables of a comprehension, and notes their kinds in `scope`."""
        if isinstance(target, ast.Name):
            scope[target.id] = value.kind
            return f"const ${target.id}={value.text};"
        kinds = value.kind.parts if isinstance(value.kind, Tuple) else ()
        if not isinstance(target, ast.Tuple) or len(target.elts) != len(kinds):
            raise self.refused(node, f"it takes {described(value.kind)} apart")
        held = self.fresh()
        parts = enumerate(zip(target.elts, kinds, strict=True))
        return f"{held}={value.text};" + "".join(
            self._bind_in(node, one, Code(f"{held}.a{k}", kind), scope) for k, (one, kind) in parts
        )

    def _of_IfExp(self, node: ast.IfExp) -> Code:
        test, then, other = self.truth(node, self.visit(node.test)), self.visit(node.body), self.visit(node.orelse)
        kind = self.joined(node, then.kind, other.kind)
        return Code(f"({test}?{then.text}:{other.text})", kind)

    # Parts of arrays, lists and tuples

    def _of_Subscript(self, node: ast.Subscript) -> Code:
        return self.item(node, self.owner(node), node.slice)

    def owner(self, node: ast.Subscript) -> Code:
        """Writes what a part is taken of. For one number, `flat` of an array with one axis is the array."""
        value = node.value
        if (
            isinstance(value, ast.Attribute)
            and value.attr == "flat"
            and not isinstance(node.slice, ast.Slice | ast.Tuple)
        ):
            array = self.visit(value.value)
            if isinstance(array.kind, Array) and array.kind.ndim == 1:
                return array
        return self.visit(value)

    def item(self, node: ast.AST, owner: Code, index: ast.expr) -> Code:
        """Writes a part of an array, a list or a tuple."""
        kind = owner.kind
        if isinstance(kind, Tuple):
            return self._part_of_tuple(node, owner, kind, index)
        if isinstance(kind, List):
            if isinstance(index, ast.Slice):
                bounds = ",".join("null" if one is None else self.index(one) for one in (index.lower, index.upper))
                step = "1" if index.step is None else self.index(index.step)
                return Code(f"listSlice({owner.text},{bounds},{step})", kind)
            return Code(f"item({owner.text},{self.index(index)})", self.known.part(kind))
        if isinstance(kind, Array):
            indices = self.indices(index)
            if self.is_one_place(node, kind, indices):
                texts = list(map(self.index, indices))
                if kind.name:
                    return Code(named.element(kind, named.place(kind, texts)), kind.of)
                return Code(f"{owner.text}.at{kind.ndim}({','.join(texts)})", kind.of)
            return self.part(owner, indices)
        if kind == NEVER:
            return owner
        raise self.refused(node, f"it takes a part of {described(kind)}")

    def _part_of_tuple(self, node: ast.AST, owner: Code, kind: Tuple, index: ast.expr) -> Code:
        if isinstance(index, ast.Slice):
            raise self.refused(node, "it takes several parts of a tuple at once")
        known = _literal(index)
        if known is not None and -len(kind.parts) <= known < len(kind.parts):
            return self.field(owner, known % len(kind.parts))
        found = kind.parts[0] if kind.parts else NEVER
        for one in kind.parts:
            found = self.joined(node, found, one)
        return Code(f"item({self.as_list(owner)},{self.index(index)})", found)

    def is_one_place(self, node: ast.AST, kind: Array, indices: list[ast.expr]) -> bool:
        """Returns whether indices lead to one element of an array."""
        alone = len(indices) == kind.ndim and not any(isinstance(one, ast.Slice) for one in indices)
        if alone and kind.ndim > MOST_DIMENSIONS:
            raise self.refused(node, f"it uses elements of an array of {kind.ndim} dimensions")
        return alone

    def indices(self, index: ast.expr) -> list[ast.expr]:
        """Returns the indices between brackets."""
        return list(index.elts) if isinstance(index, ast.Tuple) else [index]

    def part(self, owner: Code, indices: list[ast.expr]) -> Code:
        """Writes a part of an array that is an array itself."""
        kind: Any = owner.kind
        texts, left = list[str](), kind.ndim
        for one in indices:
            if isinstance(one, ast.Slice):
                bounds = ["null" if bound is None else self.index(bound) for bound in (one.lower, one.upper)]
                texts.append(f"[{bounds[0]},{bounds[1]},{'1' if one.step is None else self.index(one.step)}]")
            else:
                texts.append(self.index(one))
                left -= 1
        if len(indices) > kind.ndim:
            raise self.refused(indices[-1], "it has more indices than the array has dimensions")
        picked = Array(kind.of, left, kind.frozen)
        if kind.name and len(indices) == left == 1 and kind.ndim == 2:
            line = named.line(kind, texts)
            return Code(f"new {ARRAYS[kind.of]}({line},null,null)", picked, line=line)
        return Code(f"{owner.text}.part({','.join(texts)})", picked)


def _literal(node: ast.expr) -> int | None:
    """Returns the whole number for which an expression stands, if it is a literal one."""
    try:
        value = ast.literal_eval(node)
    except ValueError:
        return None
    return value if type(value) is int else None

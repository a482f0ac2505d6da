"""Writes operations and comparisons in JavaScript: of whole numbers, of real ones, of arrays and of tuples."""

import ast
from typing import Any

from edugym.compiled.javascript.base import Base
from edugym.compiled.javascript.kinds import (
    ARRAYS,
    BOOL,
    FLOAT,
    INT,
    MIXED,
    NEVER,
    NONE,
    NUMBERS,
    Array,
    Code,
    Kind,
    List,
    Static,
    Tuple,
    described,
)

WHOLE: dict[type, str] = {
    ast.Add: "whole({}+{})",
    ast.Sub: "whole({}-{})",
    ast.Mult: "whole({}*{}+0)",
    ast.Div: "divided({},{})",
    ast.FloorDiv: "quotient({},{})",
    ast.Mod: "remainder({},{})",
    ast.Pow: "power({},{})",
    ast.LShift: "shifted({},{})",
    ast.RShift: "shiftedBack({},{})",
    ast.BitAnd: "both({},{})",
    ast.BitOr: "either({},{})",
    ast.BitXor: "one({},{})",
}
REAL: dict[type, str] = {
    ast.Add: "({}+{})",
    ast.Sub: "({}-{})",
    ast.Mult: "({}*{})",
    ast.Div: "divided({},{})",
    ast.FloorDiv: "floored({},{})",
    ast.Mod: "modulo({},{})",
}
"""Operations on whole and on real numbers."""
POWERS = {"1": "x=>x", "1.0": "x=>x", "2": "x=>x*x", "2.0": "x=>x*x", "0.5": "root"}
"""What NumPy does for an array to one of these powers, which is more exact than a power."""
FLAGS: dict[type, str] = {ast.BitAnd: "&&", ast.BitOr: "||", ast.BitXor: "!=="}
SIGNS: dict[type, str] = {
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "===",
    ast.NotEq: "!==",
}


class Operations(Base):
    """Writes operations."""

    def _of_BoolOp(self, node: ast.BoolOp) -> Code:
        parts = [self.visit(one) for one in node.values]
        sign = "&&" if isinstance(node.op, ast.And) else "||"
        result = parts[-1]
        for part in reversed(parts[:-1]):
            if part.kind == result.kind == BOOL:
                result = Code(f"({part.text}{sign}{result.text})", BOOL)
                continue
            kind = self.joined(node, part.kind, result.kind)
            held = self.fresh()
            test = self.truth(node, Code(held, part.kind))
            ways = (result.text, held) if sign == "&&" else (held, result.text)
            result = Code(f"(({held}={part.text}),{test}?{ways[0]}:{ways[1]})", kind)
        return result

    def _of_UnaryOp(self, node: ast.UnaryOp) -> Code:
        value = self.visit(node.operand)
        if isinstance(node.op, ast.Not):
            return Code(f"(!{self.truth(node, value)})", BOOL)
        if isinstance(value.kind, Array) and isinstance(node.op, ast.USub) and value.kind.of != BOOL:
            zero = "-x" if value.kind.of == FLOAT else "whole(0-x)"
            return Code(
                f"mapped({ARRAYS[value.kind.of]},x=>{zero},{value.text})", Array(value.kind.of, value.kind.ndim)
            )
        if value.kind == NEVER:
            return value
        if value.kind not in NUMBERS:
            raise self.refused(node, f"it computes with {described(value.kind)}")
        if isinstance(node.op, ast.UAdd):
            return value
        if isinstance(node.op, ast.Invert):
            if value.kind != INT:
                raise self.refused(node, "it uses ~ of a real number")
            return Code(f"whole(-1-{value.text})", INT)
        text = {INT: f"whole(0-{value.text})", FLOAT: f"(-{value.text})", MIXED: f"mixed(-{value.text})"}
        return Code(text[str(value.kind)], value.kind)

    def _of_BinOp(self, node: ast.BinOp) -> Code:
        inner = node.left
        if isinstance(node.op, ast.Mod) and isinstance(inner, ast.BinOp) and isinstance(inner.op, ast.Mult):
            factors = [self.visit(one) for one in (inner.left, inner.right, node.right)]
            if all(one.kind == INT for one in factors):  # as random numbers are made: the product may be large
                return Code(f"productModulo({','.join(one.text for one in factors)})", INT)
            product = self.operation(inner, ast.Mult, *factors[:2])
            return self.operation(node, ast.Mod, product, factors[2])
        return self.operation(node, type(node.op), self.visit(node.left), self.visit(node.right))

    def operation(self, node: ast.AST, operation: type, left: Code, right: Code) -> Code:
        """Writes an operation."""
        kinds = (left.kind, right.kind)
        if NEVER in kinds:
            return Code(f"({left.text},{right.text})", NEVER)
        if any(isinstance(kind, Array) for kind in kinds):
            return self.of_arrays(node, operation, left, right)
        if isinstance(left.kind, List) and operation is ast.Mult and right.kind == INT:
            return Code(f"repeated({left.text},{right.text})", left.kind)
        if isinstance(left.kind, List) and isinstance(right.kind, List) and operation is ast.Add:
            site = self.list_at(node)
            for one in (left.kind, right.kind):
                self.widen(node, site, self.known.part(one))
            return Code(f"[...{left.text},...{right.text}]", site)
        if not all(kind in NUMBERS or kind == BOOL for kind in kinds):
            other = next(kind for kind in kinds if kind not in NUMBERS and kind != BOOL)
            raise self.refused(node, f"it computes with {described(other)}")
        if kinds == (BOOL, BOOL):
            if operation not in FLAGS:
                raise self.refused(node, "it computes with True and False")
            first, second = self.fresh(), self.fresh()
            text = f"({first}={left.text},{second}={right.text},{first}{FLAGS[operation]}{second})"
            return Code(text, BOOL)
        left, right = (Code(f"(+{one.text})", INT) if one.kind == BOOL else one for one in (left, right))
        if left.kind == right.kind == INT:
            return self._whole(node, operation, left, right)
        if operation is ast.Pow:
            if FLOAT not in (left.kind, right.kind):
                raise self.refused(node, "it computes a power of a number that may be whole or real")
            return Code(self.libm(node, "pow", left.text, right.text), FLOAT)
        if operation not in REAL:
            raise self.refused(node, "it computes with a real number where Python takes whole ones only")
        kind = self._real(node, left, right) if operation is not ast.Div else FLOAT
        text = REAL[operation].format(left.text, right.text)
        return Code(f"mixed({text})" if kind == MIXED else text, kind)

    def _whole(self, node: ast.AST, operation: type, left: Code, right: Code) -> Code:
        if operation not in WHOLE:
            raise self.refused(node, "it multiplies matrices")
        return Code(WHOLE[operation].format(left.text, right.text), FLOAT if operation is ast.Div else INT)

    def _real(self, node: ast.AST, left: Code, right: Code) -> str:
        return FLOAT if FLOAT in (left.kind, right.kind) else MIXED

    def of_arrays(self, node: ast.AST, operation: type, left: Code, right: Code) -> Code:
        """Writes an operation on the elements of arrays."""
        if operation is ast.MatMult:
            raise self.refused(node, "it multiplies matrices")
        ndim = max((kind.ndim for kind in (left.kind, right.kind) if isinstance(kind, Array)), default=0)
        elements = [kind.of if isinstance(kind, Array) else kind for kind in (left.kind, right.kind)]
        if isinstance(left.kind, List | Tuple) or isinstance(right.kind, List | Tuple):
            left, right = (Code(self.spreadable(node, one), self.spread_kind(node, one.kind)) for one in (left, right))
            return self.of_arrays(node, operation, left, right)
        if MIXED in elements:
            raise self.refused(
                node, "it computes with an array and a number that is whole in one place and real in another"
            )
        if operation is ast.Pow and BOOL in elements:
            raise self.refused(node, "it raises True and False to a power as if they were numbers")
        if operation is ast.Pow and FLOAT in elements and not isinstance(right.kind, Array):
            if elements[0] == FLOAT and right.text in POWERS:
                return Code(f"mapped(Real,{POWERS[right.text]},{left.text})", Array(FLOAT, ndim))
            if elements[0] != FLOAT or not right.text.replace(".", "").isdigit():
                raise self.refused(node, "it raises an array to a power for which NumPy may know a shorter way")
        held = len(self.temporary)
        one = self.operation(node, operation, Code("x", elements[0]), Code("y", elements[1]))
        if str(one.kind) not in ARRAYS:
            raise self.refused(node, f"it computes with {described(one.kind)}")
        text = f"paired({ARRAYS[str(one.kind)]},{self._named(one, held)},{left.text},{right.text})"
        return Code(text, Array(str(one.kind), ndim))

    def _named(self, one: Code, held: int) -> str:
        """Names a function of x and y; one that uses new variables, of which there were `held`, stays where it is."""
        text = f"(x,y)=>{one.text}"
        return text if len(self.temporary) > held else self.known.constants.operation(text)

    def _where(self, test: str, array: Code, number: Code) -> str:
        """Writes the call that makes the array of the places where a test of an array's x and of y holds.

        Its function is written for this test and kind of array, since V8 is quick only with those that meet one kind.
        """
        kind: Any = array.kind
        x = {FLOAT: "data[p]", INT: "whole64(data,p)", BOOL: "(data[p]!==0)"}[kind.of]
        put = "places[2*n++]=k"
        through = f"for(let k=0,p=offset;k<length;k++,p+=stride){{const x={x};if({test}){put}}}"
        of_line = self.known.constants.operation(
            f"(data,offset,length,stride,y)=>{{const begin=search(length);let n=begin;{through}return found(begin,n)}}"
        )
        if array.line:
            return f"{of_line}({array.line},{number.text})"
        of_array = f"(a,y)=>{of_line}(a.data,a.offset,a.length,a.stride,y)"
        return f"{self.known.constants.operation(of_array)}({array.text},{number.text})"

    def spread_kind(self, node: ast.AST, kind: Kind) -> Kind:
        """Returns the kind of the array that `spreadable` makes."""
        if isinstance(kind, Tuple):
            return Array(self.element(node, kind.parts), 1)
        return Array(self.element(node, [self.known.part(kind)]), 1) if isinstance(kind, List) else kind

    def _of_Compare(self, node: ast.Compare) -> Code:
        if len(node.ops) == 1:
            return self.compared(node, type(node.ops[0]), self.visit(node.left), self.visit(node.comparators[0]))
        left, parts = self.visit(node.left), list[str]()
        for k, (sign, one) in enumerate(zip(node.ops, node.comparators, strict=True)):
            right = self.visit(one)
            held = right
            if k < len(node.ops) - 1:
                name = self.fresh()
                held, right = Code(name, right.kind), Code(f"({name}={right.text})", right.kind)
            found = self.compared(node, type(sign), left, right)
            if found.kind != BOOL:
                raise self.refused(node, "it compares arrays in a chain")
            parts.append(found.text)
            left = held
        return Code(f"({'&&'.join(parts)})", BOOL)

    def compared(self, node: ast.AST, sign: type, left: Code, right: Code) -> Code:
        """Writes a comparison."""
        kinds = (left.kind, right.kind)
        if sign in (ast.Is, ast.IsNot):
            if NONE not in kinds:
                raise self.refused(node, "it compares with 'is'")
            return Code(f"({left.text},{right.text},{str((kinds == (NONE, NONE)) == (sign is ast.Is)).lower()})", BOOL)
        if sign in (ast.In, ast.NotIn):
            return self.contained(node, sign, left, right)
        if NEVER in kinds:
            return Code(f"({left.text},{right.text},false)", BOOL)
        if any(isinstance(kind, Array) for kind in kinds):
            ndim = max(kind.ndim for kind in kinds if isinstance(kind, Array))
            elements = [kind.of if isinstance(kind, Array) else kind for kind in kinds]
            held = len(self.temporary)
            one = self.compared(node, sign, Code("x", elements[0]), Code("y", elements[1]))
            text = f"paired(Flags,{self._named(one, held)},{left.text},{right.text})"
            with_number = isinstance(left.kind, Array) and ndim == 1 and isinstance(right.kind, str)
            where = self._where(one.text, left, right) if with_number and len(self.temporary) == held else None
            return Code(text, Array(BOOL, ndim), where=where)
        plain = {BOOL} | NUMBERS
        if all(kind in plain for kind in kinds):
            texts = [
                f"(+{code.text})" if code.kind == BOOL and kinds != (BOOL, BOOL) else code.text
                for code in (left, right)
            ]
            return Code(f"({SIGNS[sign].join(texts)})", BOOL)
        if sign not in (ast.Eq, ast.NotEq):
            raise self.refused(node, f"it compares {described(kinds[0])} with {described(kinds[1])}")
        wanted = str(sign is ast.Eq).lower()
        if all(isinstance(kind, Static) for kind in kinds):
            one_value, other_value = (kind.value for kind in kinds if isinstance(kind, Static))
            return Code(str((one_value == other_value) == (sign is ast.Eq)).lower(), BOOL)
        if all(isinstance(kind, Tuple) for kind in kinds):
            return Code(f"({self.equal(node, left, right)}==={wanted})", BOOL)
        raise self.refused(node, f"it compares {described(kinds[0])} with {described(kinds[1])}")

    def equal(self, node: ast.AST, left: Code, right: Code) -> str:
        """Writes the test whether two tuples are equal."""
        one, other = self.fresh(), self.fresh()
        kinds: Any = (left.kind, right.kind)
        if len(kinds[0].parts) != len(kinds[1].parts):
            return f"({left.text},{right.text},false)"
        parts = [
            f"sameReal({one}.a{k},{other}.a{k})"  # Python takes one and the same NaN for equal, in tuples
            if {kind, kinds[1].parts[k]} <= NUMBERS
            else self.compared(node, ast.Eq, Code(f"{one}.a{k}", kind), Code(f"{other}.a{k}", kinds[1].parts[k])).text
            for k, kind in enumerate(kinds[0].parts)
        ]
        return f"({one}={left.text},{other}={right.text},{'&&'.join(parts) or 'true'})"

    def contained(self, node: ast.AST, sign: type, left: Code, right: Code) -> Code:
        """Writes the test whether a number is in a list or a tuple of numbers."""
        kinds = [self.known.part(right.kind)] if isinstance(right.kind, List) else getattr(right.kind, "parts", ["?"])
        if left.kind not in (INT, MIXED) or not set(kinds) <= {INT, MIXED, FLOAT}:
            raise self.refused(node, "it uses in with other things than whole numbers in a list or a tuple")
        text = right.text if isinstance(right.kind, List) else self.as_list(right)
        return Code(f"({str(sign is ast.NotIn).lower()}===differsFromAll({text},{left.text}))", BOOL)

    def as_list(self, code: Code) -> str:
        """Writes the parts of a tuple as a JavaScript list."""
        kind, held = code.kind, self.fresh()
        count = len(kind.parts) if isinstance(kind, Tuple) else 0
        return f"({held}={code.text},[{','.join(f'{held}.a{k}' for k in range(count))}])"

    def spreadable(self, node: ast.AST, value: Code, into: str | None = None) -> str:
        """Writes what NumPy makes of a value with which it computes or fills an array.

        That is an array for a list or a tuple, with elements of the kind `into` if it is given; else the value itself.
        """
        if isinstance(value.kind, Tuple):
            kind = into or self.element(node, value.kind.parts)
            given = self.fresh()
            parts = ",".join(f"{given}.a{k}" for k in range(len(value.kind.parts)))
            return f"({given}={value.text},made({ARRAYS[kind]},[{len(value.kind.parts)}],[{parts}]))"
        if isinstance(value.kind, List):
            held, kind = self.fresh(), into or self.element(node, [self.known.part(value.kind)])
            return f"({held}={value.text},made({ARRAYS[kind]},[{held}.length],{held}))"
        return value.text

    def element(self, node: ast.AST, kinds: Any) -> str:
        """Returns the kind of the elements of the array that NumPy makes of values of these kinds."""
        found = set(kinds) - {NEVER}
        if found <= {INT} or found <= {BOOL}:
            return next(iter(found), FLOAT)
        if found <= NUMBERS and FLOAT in found:
            return FLOAT
        raise self.refused(node, "it makes an array of other things than numbers of one type")

    def require_fits(self, node: ast.AST, of: str, kind: Kind, *, alone: bool = False) -> None:
        """Refuses a value of a kind that does not fit into an array `of` a kind, or if `alone` into one place of it."""
        if alone and not isinstance(kind, str):
            raise self.refused(node, f"it puts {described(kind)} in one place of an array")
        if isinstance(kind, Array):
            kind = kind.of
        for one in (
            kind.parts if isinstance(kind, Tuple) else [self.known.part(kind)] if isinstance(kind, List) else [kind]
        ):
            fits = {FLOAT: {*NUMBERS, BOOL, NEVER}, INT: {INT, NEVER}, BOOL: {BOOL, NEVER}}[of]
            if one not in fits:
                into = {FLOAT: "real numbers", INT: "whole numbers", BOOL: "True and False"}[of]
                raise self.refused(node, f"it puts {described(one)} in an array of {into}")

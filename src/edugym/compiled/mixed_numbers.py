"""Proves that numbers which are whole in one place and real in another are the same in machine code.

A variable of Python's may hold 0 on one way and 0.5 on another; in machine code it is real on both. Such numbers are
called *mixed* here. They are followed through variables, tuples, lists, calls and results, from the types that Numba
has inferred for all branches, whether a branch was ever reached or not. Most uses come to the same: `0.9 * x`, `x < y`,
`Q[s] = x`. Where two numbers that may both be whole meet, Python computes with whole numbers: machine code then raises
an error if the result is beyond 2^53 or a negative zero, and the interpreter repeats the call. What is not known to be
the same is refused.

What functions are given and return is collected in `facts`. Callees are compiled before callers, so that a caller may
find that a parameter is mixed when its function is finished. Then the build begins again with what is known
(`Incomplete`).
"""

import operator
from types import FunctionType
from typing import Any

from numba.core import ir, ir_utils, types

from edugym.compiled.arithmetic import CALLED, sum_of_mixed
from edugym.compiled.code import is_foreign
from edugym.compiled.facts import facts
from edugym.compiled.insertions import insert_name, insert_operation
from edugym.compiled.namedtuples import member_of
from edugym.compiled.number_kinds import (
    COMPARED,
    SAME_OF_WHOLE,
    as_number,
    holds_list,
    holds_real,
    is_in,
    is_whole_array,
    method_name,
    pairs_of_types,
    passes_on,
)
from edugym.compiled.operations import CHECK_EXACT, CHECK_NUMBER, MIXED, MIXED_NEGATIVE, signature_of
from edugym.compiled.untyped_checks import Refused, refuse, statements
from edugym.mdp.membership import wholeness

WRITE = "write 0.0 for 0, and so on"


def follow_only(state: Any) -> bool:
    """Follows mixed numbers through the package's own code, if there is a student's in the build: the pass."""
    if facts.is_foreign:
        follow_mixed(state)
    return True


def follow_mixed(state: Any) -> None:
    """Follows mixed numbers through a function, adds what must be checked, and refuses what is not known to be same."""
    _Followed(state).run()


class _Followed:
    """A function in which mixed numbers are followed."""

    def __init__(self, state: Any) -> None:
        self.state, self.ir, self.kinds, self.calltypes = state, state.func_ir, state.typemap, state.calltypes
        self.result, self.function = state.return_type, state.func_id.func
        self.in_training = self.function.__module__.startswith("edugym.training")
        self.mixed: set[str] = set()  # variables
        self.group: dict[str, str] = {}  # of variables that stand for the same list
        self.local_lists: set[str] = set()
        self.checks: list[tuple[Any, Any, Any, Any]] = []  # operation, block, statement (None: its end), variable

    def run(self) -> None:
        """Marks until nothing is added, then checks."""
        self._join_lists()
        before = -1
        while len(self.mixed) != before:
            before = len(self.mixed)
            for _, statement in statements(self.ir):
                self._mark(statement)
        for block, statement in statements(self.ir):
            self._check(block, statement)
        for operation, block, statement, variable in self.checks:
            insert_operation(self.state, block, statement, operation, variable)

    # what is mixed

    def kind(self, variable: Any) -> Any:
        """The type of a variable, without what is known of its value."""
        kind = types.unliteral(self.kinds[variable.name])
        return types.unliteral(kind.type) if isinstance(kind, types.Optional) else kind

    def is_mixed(self, variable: Any) -> bool:
        """Whether a variable may hold a mixed number, or holds a list or tuple of such."""
        return isinstance(variable, ir.Var) and self._root(variable.name) in self.mixed

    def may_be_whole(self, variable: Any) -> bool:
        """Whether it may stand for a whole number in Python, or hold some."""
        if not isinstance(variable, ir.Var):
            return False
        kind = self.kind(variable)
        listed = kind.dtype if isinstance(kind, types.List | types.Array) else kind
        return as_number(listed) == types.int64 or self.is_mixed(variable)

    def _root(self, name: str) -> str:
        while name in self.group:
            name = self.group[name]
        return name

    def _add(self, variable: Any) -> None:
        if holds_real(self.kind(variable)):
            self.mixed.add(self._root(variable.name))

    def _join_lists(self) -> None:
        """Finds the variables that stand for the same list."""
        for _, statement in statements(self.ir):
            if not isinstance(statement, ir.Assign) or not holds_list(self.kind(statement.target)):
                continue
            value, target = statement.value, statement.target.name
            op = getattr(value, "op", "")
            if isinstance(value, ir.Var) or op in (
                "phi",
                "cast",
                "build_tuple",
                "static_getitem",
                "getitem",
                "exhaust_iter",
                "inplace_binop",
            ):
                same = value.lhs if op == "inplace_binop" else value  # the list that it changes is its result
                for other in [same] if isinstance(same, ir.Var) else value.list_vars():
                    if holds_list(self.kind(other)) and self._root(other.name) != self._root(target):
                        self.group[self._root(other.name)] = self._root(target)
            elif op in ("build_list", "call", "binop"):
                self.local_lists.add(target)

    def _mark(self, statement: Any) -> None:
        if isinstance(statement, ir.SetItem | ir.StaticSetItem):
            target = self.kind(statement.target)
            if isinstance(target, types.List) and holds_real(target) and self.may_be_whole(statement.value):
                self._put(statement.target, statement.loc)
        elif isinstance(statement, ir.Assign) and self._extends_by_whole(statement.value):
            self._put(statement.target, statement.loc)
        elif isinstance(statement, ir.Assign) and self._gives_mixed(statement.target, statement.value, statement.loc):
            self._add(statement.target)

    def _extends_by_whole(self, value: Any) -> bool:
        """Whether it adds a list with whole numbers to a list of real ones, in place."""
        if getattr(value, "op", "") != "inplace_binop" or not holds_list(self.kind(value.lhs)):
            return False
        wholes = isinstance(self.kind(value.rhs), types.List) and self.may_be_whole(value.rhs)
        return holds_real(self.kind(value.lhs)) and wholes

    def _put(self, variable: Any, loc: Any) -> None:
        """A whole number is put in a list of real ones."""
        root = self._root(variable.name)
        if not any(self._root(name) == root for name in self.local_lists):
            refuse(f"it puts a whole number in a list of real ones: {WRITE}", loc)
        self._add(variable)

    def _gives_mixed(self, target: Any, value: Any, loc: Any) -> bool:
        """Whether a value is mixed."""
        if isinstance(value, ir.Arg):
            return (self.function, value.name) in facts.parameters
        if isinstance(value, ir.Var):
            return self.is_mixed(value)
        if not isinstance(value, ir.Expr):
            return False
        kind, given = self.kind(target), [one for one in value.list_vars() if isinstance(one, ir.Var)]
        if value.op == "phi":
            return any(map(self.is_mixed, given)) or (holds_real(kind) and any(map(self.may_be_whole, given)))
        if value.op == "build_list":
            return holds_real(kind) and any(map(self.may_be_whole, given))
        if value.op in ("binop", "inplace_binop", "unary"):
            return self._operation_gives_mixed(value, kind, given)
        if value.op == "call":
            return self._call_gives_mixed(value, kind, loc)
        if value.op == "getattr":
            return self._attribute_gives_mixed(value)
        return any(map(self.is_mixed, given))  # parts, iterators and the like

    def _operation_gives_mixed(self, expr: Any, kind: Any, given: list[Any]) -> bool:
        function = expr.immutable_fn if expr.op == "inplace_binop" else expr.fn
        if isinstance(kind, types.List):
            return any(map(self.is_mixed, given)) or any(
                isinstance(self.kind(one), types.List) and not holds_real(self.kind(one)) for one in given
            )
        if kind != types.float64 or function is operator.truediv:
            return False
        return all(map(self.may_be_whole, given)) and any(map(self.is_mixed, given))

    def _attribute_gives_mixed(self, expr: Any) -> bool:
        kind = self.kind(expr.value)
        if isinstance(kind, types.BaseNamedTuple):
            member = member_of(kind, expr.attr)
            if isinstance(member, property) and isinstance(member.fget, FunctionType):
                if self.is_mixed(expr.value):
                    self._suppose(member.fget, "self")
                return member.fget in facts.results
        return self.is_mixed(expr.value)

    def _call_gives_mixed(self, call: Any, kind: Any, loc: Any) -> bool:
        called, given = self.kind(call.func), [*call.args, *(variable for _, variable in call.kws)]
        function = self._own_function(call)
        if function is not None:
            self._pass(function, call)
            return function in facts.results
        if isinstance(called, types.BoundFunction) and isinstance(called.this, types.List):
            return self._list_method(call, called, given, loc)
        key = getattr(called, "typing_key", None)
        if not any(map(self.is_mixed, given)):
            smallest = key in (max, min) and kind == types.float64
            return smallest and any(map(self.may_be_whole, given))
        return passes_on(called, key)

    def _list_method(self, call: Any, called: Any, given: list[Any], loc: Any) -> bool:
        name, this = method_name(called.typing_key), self._bound_to(call.func)
        if name in ("append", "insert") and self.may_be_whole(given[-1]) and holds_real(self.kind(this)):
            self._put(this, loc)
        elif name == "extend" and holds_real(self.kind(this)):
            kind = self.kind(given[0])
            if self.is_mixed(given[0]) or getattr(kind, "dtype", kind) != types.float64:
                self._put(this, loc)
        return self.is_mixed(this)

    def _bound_to(self, variable: Any) -> Any:
        """The variable of which a method is called."""
        return ir_utils.get_definition(self.ir, variable).value

    def _own_function(self, call: Any) -> FunctionType | None:
        """The plain function or method that is called, if it is one."""
        called = self.kind(call.func)
        if isinstance(called, types.Dispatcher):
            function: FunctionType = called.dispatcher.py_func
            return function
        if isinstance(called, types.BoundFunction) and isinstance(called.this, types.BaseTuple):
            member = member_of(called.this, called.typing_key[1])
            return member if isinstance(member, FunctionType) else None
        return None

    def _pass(self, function: FunctionType, call: Any) -> None:
        """Notes which parameters of a function are given mixed numbers."""
        code = function.__code__
        names = list(code.co_varnames[: code.co_argcount])
        if isinstance(self.kind(call.func), types.BoundFunction):
            if self.is_mixed(call.func):
                self._suppose(function, names[0])
            names = names[1:]
        for name, variable in [*zip(names, call.args, strict=False), *call.kws]:
            if self.is_mixed(variable):
                self._suppose(function, name)

    def _suppose(self, function: FunctionType, name: str) -> None:
        if (function, name) not in facts.parameters:
            facts.parameters.add((function, name))
            facts.is_incomplete = True

    # what is to be checked

    def _check(self, block: Any, statement: Any) -> None:
        if isinstance(statement, ir.Return):
            self._check_return(block, statement)
        elif isinstance(statement, ir.SetItem | ir.StaticSetItem):
            target, value = self.kind(statement.target), self.kind(statement.value)
            if isinstance(target, types.List):
                if not holds_real(target) and holds_real(value):
                    refuse(f"it puts a real number in a list of whole ones: {WRITE}", statement.loc)
                self._require_exact(block, statement, statement.value, target.dtype)
        elif isinstance(statement, ir.Assign) and isinstance(statement.value, ir.Expr):
            expr, target = statement.value, statement.target
            if expr.op == "phi":
                for label, variable in zip(expr.incoming_blocks, expr.incoming_values, strict=True):
                    if isinstance(variable, ir.Var):
                        self._require_same_parts(variable, self.kind(target), statement.loc)
                        self._require_exact(self.ir.blocks[label], None, variable, self.kind(target))
            elif expr.op == "build_list":
                for variable in expr.items:
                    self._require_exact(block, statement, variable, self.kind(target).dtype)
            elif expr.op in ("binop", "inplace_binop", "unary"):
                if expr.op == "binop" and expr.fn is operator.contains and self.kind(expr.rhs) == types.float64:
                    self.checks.append((CHECK_NUMBER, block, statement, expr.rhs))
                self._check_operation(expr, self.kind(target), statement.loc)
            elif expr.op == "call":
                self._check_call(block, statement)

    def _check_return(self, block: Any, statement: Any) -> None:
        name, loc, result = self.function.__name__, statement.loc, types.unliteral(self.result)
        definition = ir_utils.guard(ir_utils.get_definition, self.ir, statement.value)
        loc = getattr(definition, "loc", loc)
        self._require_same_parts(statement.value, result, loc)
        self._require_exact(block, statement, statement.value, result)
        whole = self.kind(statement.value) == types.int64 and holds_real(result)
        if whole or self.is_mixed(statement.value):
            if name in ("act", "greedy") and is_foreign(self.function):
                refuse(f"{name} returns a number that is whole in one place and real in another: use int()", loc)
            facts.results.add(self.function)
            if "carry" in self.function.__code__.co_varnames:
                self._suppose(self.function, "carry")

    def _require_same_parts(self, variable: Any, into: Any, loc: Any) -> None:
        """Refuses a tuple that becomes one of other types, and in training a whole number that becomes a real one."""
        kind = self.kind(variable)
        into = types.unliteral(into.type) if isinstance(into, types.Optional) else into
        if self.in_training and kind == types.int64 and into == types.float64:
            self._refuse_in_training(variable)
        if isinstance(kind, types.List) and isinstance(into, types.List) and kind.dtype != into.dtype:
            refuse(f"one name stands for lists of whole and of real numbers: {WRITE}", loc)
        if isinstance(kind, types.BaseTuple) and isinstance(into, types.BaseTuple):
            for one, other in pairs_of_types(kind, into):
                if isinstance(types.unliteral(one), types.Integer) and isinstance(types.unliteral(other), types.Float):
                    if self.in_training:
                        self._refuse_in_training(variable)
                    refuse(f"one name stands for tuples with whole and with real numbers: {WRITE}", loc)

    def _refuse_in_training(self, variable: Any) -> None:
        what = next((one for one in ("observation", "action") if one in variable.unversioned_name), "state")
        raise _mixed(what)

    def _require_exact(self, block: Any, statement: Any, variable: Any, into: Any) -> None:
        """Checks a whole number that becomes a real one, unless it is a small constant."""
        if isinstance(variable, ir.Var) and self.kind(variable) == types.int64 and holds_real(into):
            known = self.kinds[variable.name]
            if not (isinstance(known, types.IntegerLiteral) and abs(known.literal_value) <= 2**53):
                self.checks.append((CHECK_EXACT, block, statement, variable))

    def _check_operation(self, expr: Any, kind: Any, loc: Any) -> None:
        given = list(expr.list_vars())
        function = expr.immutable_fn if expr.op == "inplace_binop" else expr.fn
        with_array = any(map(self.is_mixed, given)) and any(is_whole_array(self.kind(one)) for one in given)
        if with_array and function not in COMPARED:
            refuse(f"it computes with an array of whole numbers and one that is whole or real: {WRITE}", loc)
        if not self._operation_gives_mixed(expr, kind, given) or isinstance(kind, types.List):
            return
        if expr.op == "unary":
            if function is operator.neg:
                self._replace(expr, "fn", MIXED_NEGATIVE)
        elif function in MIXED:
            self._replace(expr, "fn" if expr.op == "binop" else "immutable_fn", MIXED[function])
        else:
            refuse(f"it computes with a number that is whole in one place and real in another: {WRITE}", loc)

    def _replace(self, expr: Any, name: str, operation: Any) -> None:
        setattr(expr, name, operation.function)
        del self.calltypes[expr]
        self.calltypes[expr] = signature_of(operation)

    def _check_call(self, block: Any, statement: Any) -> None:
        call, kind = statement.value, self.kind(statement.target)
        called, given = self.kind(call.func), [*call.args, *(variable for _, variable in call.kws)]
        key = getattr(called, "typing_key", None)
        if self._own_function(call) is CALLED[divmod] and any(map(self.is_mixed, given)):
            refuse(f"it divides a number that is whole in one place and real in another: {WRITE}", statement.loc)
        if self._own_function(call) is not None:
            return
        if isinstance(called, types.BoundFunction) and isinstance(called.this, types.List):
            for variable in given:
                if method_name(called.typing_key) in ("append", "insert"):
                    self._require_exact(block, statement, variable, called.this.dtype)
            return
        if key in (max, min) and kind == types.float64:
            for variable in given:
                self._require_exact(block, statement, variable, kind)
        if getattr(key, "__name__", "") == "sum" and any(map(self.is_mixed, given)):
            self._call_instead(block, statement, sum_of_mixed)
        if any(map(self.is_mixed, given)) and not (passes_on(called, key) or self._is_same(called, key, given)):
            if key is wholeness:  # a guard asks it of an observation, since `act` may not return such a number
                raise _mixed("observation", "use int()")
            refuse(
                f"it gives a number that is whole in one place and real in another to a function: {WRITE}",
                statement.loc,
            )

    def _call_instead(self, block: Any, statement: Any, function: Any) -> None:
        """Calls another function with the same arguments."""
        call = statement.value
        call.func = insert_name(self.state, block, statement, function)
        del self.calltypes[call]
        given = tuple(self.kinds[one.name] for one in call.args)
        self.calltypes[call] = self.kinds[call.func.name].get_call_type(self.state.typingctx, given, {})

    def _is_same(self, called: Any, key: Any, given: list[Any]) -> bool:
        """Whether a function does the same with whole and with real numbers."""
        if isinstance(called, types.ExceptionClass) or is_in(key, SAME_OF_WHOLE):
            return True
        if isinstance(called, types.NumberClass):
            return True
        if isinstance(called, types.BoundFunction):
            return called.typing_key == (types.Array, "fill") or isinstance(called.this, types.NumPyRandomGeneratorType)
        return all(not self.is_mixed(one) or self._has_real(one) for one in given)

    def _has_real(self, variable: Any) -> bool:
        """Whether it is a list with a real number in it for sure, of which NumPy makes an array of real numbers."""
        definition = ir_utils.guard(ir_utils.get_definition, self.ir, variable)
        listed = isinstance(definition, ir.Expr) and definition.op == "build_list" and variable.is_temp
        return listed and any(self.kind(one) == types.float64 and not self.is_mixed(one) for one in definition.items)


def _mixed(what: str, advice: str = WRITE) -> Refused:
    """The error of a state, an observation or an action that is whole in one place and real in another."""
    error = Refused(f"the {what} is made of whole numbers in one place and of real ones in another: {advice}")
    error.method = {"observation": "observation", "action": "act"}.get(what, "transition")
    return error

"""Loops of machine code that can be interrupted: from time to time they ask Python whether to go on.

A `while` whose condition stays true would never come back to the interpreter, where Ctrl-C is answered. So every
`while` counts its iterations and polls after each `ITERATIONS_BETWEEN_POLLS` of them. In a student's function a `for`
with a loop inside does so too. Innermost `for` loops, such as one over the actions, end by themselves, and polling
would make them slower.
"""

import ctypes
from typing import Any

from llvmlite import binding
from llvmlite import ir as llvm
from numba import extending
from numba.core import analysis, cgutils, ir, ir_utils, types

from edugym.system.interrupts import Stopped, asked_to_stop

ITERATIONS_BETWEEN_POLLS = 2**12
"""A power of two. A poll takes a microsecond, and that many short iterations a few in all."""
SYMBOL = "edugym_asked_to_stop"
_callback = ctypes.CFUNCTYPE(ctypes.c_bool, ctypes.c_int64)(asked_to_stop)  # it lives as long as machine code
binding.add_symbol(SYMBOL, ctypes.cast(_callback, ctypes.c_void_p).value)


def poll(line: int) -> None:
    """Raises `Stopped` in machine code if it is to end."""
    raise NotImplementedError


def _lower_poll(context: Any, builder: Any, signature: Any, values: Any) -> Any:
    kind = llvm.FunctionType(llvm.IntType(8), [llvm.IntType(64)])
    callback = cgutils.get_or_insert_function(builder.module, kind, SYMBOL)
    with builder.if_then(cgutils.is_not_null(builder, builder.call(callback, values)), likely=False):
        context.call_conv.return_user_exc(builder, Stopped, ())
    return context.get_dummy_value()


extending.type_callable(poll)(lambda context: lambda line: types.none)
extending.lower_builtin(poll, types.int64)(_lower_poll)


def count_iteration(iterations: int, line: int) -> int:
    """Counts one more iteration of the loop at a line, and polls from time to time."""
    if iterations & (ITERATIONS_BETWEEN_POLLS - 1) == ITERATIONS_BETWEEN_POLLS - 1:
        poll(line)
    return iterations + 1


def insert_polling(func_ir: Any, foreign: bool) -> None:
    """Makes the loops of a function count their iterations and poll.

    Args:
        func_ir: the function, as Numba has it before types are known.
        foreign: whether it is a student's. Then a `for` with a loop inside polls too, and `asked_to_stop` gets the
            lines of the loops; else it gets 0.
    """
    blocks = func_ir.blocks
    graph = analysis.compute_cfg_from_blocks(blocks)
    loops = graph.loops()
    headers = [
        label
        for label, loop in loops.items()
        if not _is_for(blocks[label]) or (foreign and not loop.body.isdisjoint(loops.keys() - {label}))
    ]
    if not headers:
        return
    first = blocks[graph.entry_point()]
    iterations = ir.Var(first.scope, ir_utils.mk_unique_var("iterations"), func_ir.loc)
    first.prepend(ir.Assign(ir.Const(0, func_ir.loc), iterations, func_ir.loc))
    for label in headers:
        block, loc = blocks[label], blocks[label].loc
        function, line = (ir.Var(block.scope, ir_utils.mk_unique_var(name), loc) for name in ("$count", "$line"))
        block.prepend(ir.Assign(ir.Expr.call(function, [iterations, line], (), loc), iterations, loc))
        first_line = min(statement.loc.line for part in loops[label].body for statement in blocks[part].body)
        block.prepend(ir.Assign(ir.Const(first_line if foreign else 0, loc), line, loc))
        block.prepend(ir.Assign(ir.Global("count_iteration", count_iteration, loc), function, loc))
    func_ir._definitions = ir_utils.build_definitions(blocks)


def _is_for(block: Any) -> bool:
    return any(isinstance(line, ir.Assign) and getattr(line.value, "op", "") == "iternext" for line in block.body)

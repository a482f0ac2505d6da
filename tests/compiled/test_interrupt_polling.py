"""Loops without an end: machine code answers Ctrl-C and the order to stop."""

import subprocess
import sys
from typing import Any

import pytest
from numba.core import compiler, ir

from edugym.compiled.interrupt_polling import insert_polling

EXPECTED = {
    "training": ["in the loop at line 6 of your code", "False True 0.0", "Timeout", "False"],
    "in_threads": ["Interrupted True", "Interrupted True"],
    "vector": ["True 300 300"],
    "planning": ["Interrupted"],
    "evaluation": ["Interrupted 0"],
}
SLOW = ("in_threads", "vector", "planning", "evaluation")


@pytest.mark.parametrize("how", [pytest.param(how, marks=[pytest.mark.slow] * (how in SLOW)) for how in EXPECTED])
def test_what_never_ends_can_be_stopped(how: str) -> None:
    """See `unending.py`. Without `edugym.compiled.interrupt_polling` these programs go on until they are killed."""
    command = [sys.executable, "-m", "tests.compiled.unending", how]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert (done.stdout.splitlines(), done.stderr) == (EXPECTED[how], "")


def loops(n: int) -> int:
    """A short loop, a loop with one inside, and one that may never end."""
    total = 0
    for k in range(n):
        total += k
    for k in range(n):
        for j in range(n):
            total += j * k
    while total > n:
        total -= n
    return total


@pytest.mark.parametrize(("foreign", "lines"), [(True, [5, 8]), (False, [0])])
def test_which_loops_count(foreign: bool, lines: list[int]) -> None:
    """A student's `for` with a loop inside as well, each with its line; the package's only where the end is open."""
    frontend: Any = compiler.run_frontend
    function = frontend(loops)
    insert_polling(function, foreign)
    statements = (one for block in function.blocks.values() for one in block.body)
    assigned: list[Any] = [one for one in statements if isinstance(one, ir.Assign)]
    given = [one.value.value for one in assigned if one.target.name.startswith("$line")]
    assert sorted(line and line - loops.__code__.co_firstlineno for line in given) == lines
    called = [one.value.value.__name__ for one in assigned if one.target.name.startswith("$count.")]
    assert called == ["count_iteration"] * len(lines)

"""Runs programs interpreted and as `executable` runs them, and compares every bit.

    python -m tests.compiled.oracle < programs.json

reads a list of programs (the source of a cell with an instance `thing` of a class) and writes a line of JSON for each
as soon as it is known: when the process dies, the lines tell at which program.
"""

import json
import re
import resource
import sys
import traceback
import warnings
from typing import Any

import numpy as np

from edugym.compiled import compiler, execution
from edugym.compiled.execution import executable
from edugym.compiled.snapshot import difference
from tests.compiled.cells import cell

CALLS, STEPS = 5, 300
MOST_MEMORY = 3 * 2**30
LIKELY_TO_ALLOCATE = re.compile(r"np\.(?!ndarray|zeros\(|int64)|rng\.(?!random)|size|\bfor\b.*\]")
needs_no_counts = compiler._needs_no_counts


def loop(n: int, thing: Any, rng: np.random.Generator, out: Any, carry: Any) -> Any:
    """Call a method n times with what it gave before; `out` holds the number of calls."""
    for _ in range(n):
        carry = thing.f(carry, rng)
        out[0] += 1
    return carry


def played(source: str, *, fast: bool) -> dict[str, Any]:
    """What a program comes to: its last value, tables and random stream, or its error, and what was said of it."""
    notebook = cell(source)
    thing, start = notebook["thing"], notebook.get("start", 0.0)
    rng, out = np.random.default_rng(3), np.zeros(1)
    found: dict[str, Any] = {"error": None, "line": None, "said": "", "printed": notebook.get("printed")}
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        execution._warned.clear()
        try:
            run = executable(loop, (thing, rng, out, start)) if fast else loop
            found["compiled"] = run is not loop
            carry = start
            for _ in range(CALLS):
                carry = run(STEPS, thing, rng, out, carry)
            found["result"] = (carry, thing, rng, out)
        except Exception as error:
            found["error"] = type(error).__name__
            # Python 3.11 takes `k = j` and the read that follows for one instruction once it is warm: an unset variable
            # of the second line is told with the first line. So here the name tells where.
            unset = isinstance(error, UnboundLocalError)
            found["line"] = str(error) if unset else traceback.extract_tb(error.__traceback__)[-1].line
            found["result"] = ()
    found["said"] = " ".join(str(w.message) for w in caught if "runs interpreted" in str(w.message))
    return found


def verdict(source: str) -> dict[str, Any]:
    """Whether both ways came to the same, how the fast one was run, and what was said."""
    allocates = bool(LIKELY_TO_ALLOCATE.search(source))  # saves a build that is likely to fail
    compiler._needs_no_counts = lambda kind: not allocates and needs_no_counts(kind)
    slow = played(source, fast=False)
    if slow["error"] == "MemoryError":  # a tuple that grows a hundredfold at every step: no student waits for its end
        return {"same": True, "compiled": False, "said": "", "error": None, "seen": ""}
    fast = played(source, fast=True)
    same = all(slow[key] == fast[key] for key in ("error", "line", "printed"))
    found = None if not same else difference(slow["result"], fast["result"], "the result")
    return {
        "same": same and found is None,
        "compiled": fast.get("compiled", False) and not fast["said"],
        "said": fast["said"],
        "error": fast["error"],
        "seen": repr((slow, fast)) if not same or found else "",
    }


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    for program in json.load(sys.stdin):
        print(json.dumps(verdict(program)), flush=True)

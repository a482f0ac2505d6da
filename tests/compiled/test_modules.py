"""What code that is compiled reaches by names: modules, what is in them, and arrays."""

import math
import os
import random
import sys
import time
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym.compiled import namedtuples
from edugym.compiled.code import Code
from edugym.compiled.subset import _name_problem, refusal
from tests.compiled.cells import cell
from tests.compiled.test_code import loop, notebook

SAID: dict[str, tuple[Any, str | None]] = {
    "math": (math, None),
    "np": (np, None),
    "one's own": (sys.modules[__name__], None),
    "random": (random, "it draws from random, which no seed of a run reaches: draw from rng"),
    "np.random": (np.random, "it draws from numpy.random, which no seed of a run reaches: draw from rng"),
    "np.linalg": (np.linalg, "it uses the module numpy.linalg"),
    "G": (np.random.default_rng(0), "the global G is a random generator: take it as rng"),
    "time": (time, "it uses the module time"),
    "os": (os, "it uses the module os"),
}


@pytest.mark.parametrize("name", SAID)
def test_modules(name: str) -> None:
    """Before anything is compiled."""
    value, said = SAID[name]
    assert _name_problem(value, name) == said


@pytest.mark.parametrize(
    ("used", "said"),
    [
        ("m.K", None),
        ("m.draw()", "it draws from random, which no seed of a run reaches: draw from rng"),
        ("m.inner.draw()", "it draws from random, which no seed of a run reaches: draw from rng"),
        ("m.inner.POINT.x", "the global m.inner.POINT is a value of SimpleNamespace, which is no NamedTuple"),
        ("m.missing", None),
    ],
)
def test_what_is_in_a_module_of_ones_own(used: str, said: str | None) -> None:
    """Also in a module in a module: what machine code would do otherwise is refused; a slip is left to Python."""
    outer, inner = ModuleType("student"), ModuleType("student.inner")
    vars(outer).update(inner=inner, draw=random.random, K=2)
    vars(inner).update(draw=random.random, POINT=SimpleNamespace(x=1))
    variables = cell(notebook("m = None", f"return s + {used}"))
    variables["m"] = outer
    arguments = variables["T"](1), np.random.default_rng(0)
    found = refusal(Code(loop, (10, *arguments)), arguments, ("thing", "rng"))
    assert (found or "").partition(" (")[0] == (said or "")


def test_arrays_that_code_reaches() -> None:
    """Those that stand alone and those in tuples: of the notebook, of a class, and of a function around."""
    source = (
        "A, B, UNUSED = np.zeros(1), (1, (np.zeros(2), 3)), np.zeros(9)\n"
        "def g(x): return A[0] + B[1][0][0] + x\n"
        "def around():\n    c = (np.zeros(3),)\n    return lambda x: c[0][0] + x\n"
        "h = around()"
    )
    task = cell(notebook(source, "return s + g(1.0) + h(1.0) + self.D[0][0]", "D = (np.zeros(4),)"))["T"](1)
    assert sorted(array.size for array in Code(loop, (10, task)).arrays) == [1, 2, 3, 4]


def test_nothing_is_left_of_a_build() -> None:
    """Not its options, nor functions, which would keep a notebook's old classes alive; after an error, too."""
    function: Any = loop
    with pytest.raises(KeyError), namedtuples.building({"boundscheck": True}, {function}):
        raise KeyError(len(namedtuples._helpers))
    assert (namedtuples._options, namedtuples._helpers, namedtuples._parts) == ({}, set(), {})

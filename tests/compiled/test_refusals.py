# ruff: noqa: E501 (a table, with a case in each line)
"""The sentences that say why something is not compiled, each in full, and what is next to it and may be."""

import re
from typing import Any

import numpy as np
import pytest
from numba.typed import List

from edugym.compiled.byte_code import place
from edugym.compiled.code import Code
from edugym.compiled.subset import refusal
from tests.compiled.cells import cell


def loop(n: int, thing: Any, rng: np.random.Generator, out: Any, carry: Any) -> Any:
    """Call a method n times with what it gave before."""
    for _ in range(n):
        carry = thing.f(carry, rng)
    return carry


def said(
    before: str, members: str, body: str, value: Any = 1.5, carry: Any = (0.0,), out: Any = (), namespace: Any = None
) -> str | None:
    """What is said of a class with a field, and of the loop's other arguments."""
    inside = "\n".join(f"    {line}" for line in members.splitlines())
    source = f"{before}\nclass T(NamedTuple):\n    v: object\n{inside}\n    def f(self, s, rng):\n        {body}\n"
    variables = cell(source, None if namespace is None else cell("") | namespace)
    thing = variables["T"](value)
    arguments = (thing, np.random.default_rng(0), out, carry)
    found = refusal(Code(loop, (10, *arguments)), arguments, ("thing", "rng", "out", "carry"))
    return found and re.sub(r"<cell \d+>, ", "", found)


FIELD = "the field v of T"
VALUES: list[tuple[Any, str | None]] = [
    (None, None),
    (True, None),
    (np.bool_(1), None),
    ("word", None),
    (np.float64(1.5), None),
    (np.int64(3), None),
    (2**63 - 1, None),
    (-(2**63), None),
    ((1, (2.5, "word")), None),
    (np.zeros(2, np.int64), None),
    (np.array(1.5), None),
    (2**63, f"{FIELD} is 9223372036854775808, beyond the whole numbers of 64 bits"),
    (-(2**63) - 1, f"{FIELD} is -9223372036854775809, beyond the whole numbers of 64 bits"),
    (np.str_("word"), f"{FIELD} is a number of type str_"),
    (np.int32(3), f"{FIELD} is a number of type int32"),
    ([1], f"{FIELD} is a list: use an array or a tuple"),
    (np.zeros(2).view(np.recarray), f"{FIELD} is a recarray: use an ordinary array"),
    ({1}, f"{FIELD} is a set: use an array or a tuple"),
    ({1: 2}, f"{FIELD} is a dict: use an array or a tuple"),
    (frozenset({1}), f"{FIELD} is a frozenset: use an array or a tuple"),
    (np.array([1, None]), f"{FIELD} is an array of objects"),
    (np.zeros(2, np.int32), f"{FIELD} is an array of int32; of arrays it takes those of float64, int64 and bool"),
    (
        np.zeros(2, ">f8"),
        f"{FIELD} is an array with its bytes in another order: use a copy of it, as by .astype(float)",
    ),
    (np.zeros(2, "U3"), f"{FIELD} is an array of str96; of arrays it takes those of float64, int64 and bool"),
    (np.random.default_rng(0), f"{FIELD} is a random generator: take it as rng"),
    (int, f"{FIELD} is a function or class"),
    (max, f"{FIELD} is a function or class"),
    (1j, f"{FIELD} is a value of complex, which is no NamedTuple"),
    ((1, [2]), f"{FIELD}[1] is a list: use an array or a tuple"),
    ((1, (2, np.random.default_rng(0))), f"{FIELD}[1][1] is a random generator: take it as rng"),
]


@pytest.mark.parametrize(
    ("value", "sentence"), VALUES, ids=lambda value: re.sub(" at 0x[0-9A-F]+", "", repr(value))[:40]
)
def test_values(value: Any, sentence: str | None) -> None:
    """Of a field: named by its class, and in a tuple by its place."""
    assert said("", "", "return s + 1", value) == sentence


def test_what_a_loop_is_called_with() -> None:
    """A student knows a loop's carry by what is in it, and other arguments by their names."""
    a_list = "is a list: use an array or a tuple"
    assert said("", "", "return s", carry=([0],)) == f"a state {a_list}"
    assert said("", "", "return s", carry=(0, (1, [0]))) == f"observation[1] {a_list}"
    assert said("", "", "return s", carry=(0, 1, [0])) == f"an action {a_list}"
    assert said("", "", "return s", carry=(0, 1, 2, 3)) is None
    assert said("", "", "return s", carry=[0]) == f"the argument carry {a_list}"
    assert said("", "", "return s", out=[0]) == f"the argument out {a_list}"
    assert said("", "", "return s", out=(0, [0])) == f"the argument out[1] {a_list}"


MODULES = """import random, types
m = types.ModuleType('m')
m.inner = types.ModuleType('n')
m.draw = m.inner.draw = random.random
m.inner.P, m.inner.K = types.SimpleNamespace(x=1), 2"""
TRY = "try:\n            s = 1 / s\n        except ZeroDivisionError:\n            s = 5.0\n        return s"
CODE: list[tuple[str, str, str, str | None]] = [
    ("", "def g(self, s, k=np.zeros(1)): return s", "return self.g(s)", "a default of g is an array (line 4)"),
    ("", "def g(self, s, k=(1, [2])): return s", "return self.g(s)", "default of g[1] is a list: use an array or a tuple (line 4)"),
    ("", "def g(self, s, k=None): return s", "return self.g(s)", None),
    ("", "K = (1, [2])", "return s + self.K[0]", "T.K[1] is a list: use an array or a tuple"),
    ("K = {1}", "", "return s + len(K)", "the global K is a set: use an array or a tuple (line 6)"),
    ("K = 2**64", "", "return s + K", "the global K is 18446744073709551616, beyond the whole numbers of 64 bits (line 6)"),
    ("", "", "return s + math.gamma(s)", "it uses math.gamma (line 6)"),
    ("", "", "return s + np.median(s)", None),
    ("", "", "return s + np.percentile(s, 3)", "it uses np.percentile (line 6)"),
    ("", "", "return s + np.linalg.norm(s)", "it uses np.linalg (line 6)"),
    ("", "", "return s + np.random.random()", "it draws from np.random, which no seed of a run reaches: draw from rng (line 6)"),
    ("", "", "return s + len(sorted(set()))", "it makes a set (line 6)"),
    ("", "", "return s + len(dict())", "it makes a dict (line 6)"),
    ("", "", "return s + len(repr(s))", "it makes text (line 6)"),
    ("", "", "return s if type(s) is int else s", "it asks for the type of a value (line 6)"),
    ("", "", "return s + hash(s)", "it uses hash (line 6)"),
    ("", "", "return s + complex(s).real", "it uses complex (line 6)"),
    ("from collections import deque", "", "return s + len(deque())", "it uses deque (line 6)"),
    ("class C: pass", "", "return s + (C is None)", "it uses the class C, which is no NamedTuple (line 6)"),
    ("class C(enum.Enum): R = 1", "", "return s + (s is C.R)", None),
    ("class C(enum.IntEnum):\n    R = 1\n    def __add__(self, x): return 7", "", "return s + (C.R + 1)", "C defines __add__, which machine code would not call"),
    ("class C(enum.Enum):\n    R = 1\n    def __eq__(self, x): return True\nk = C.R", "", "return s + (s == k)", "C defines __eq__, which machine code would not call (line 9)"),
    ("class C(enum.Enum):\n    R = 1, 2\n    def __init__(self, x, y): self.x = x\n    def __str__(self): return ''", "", "return s + (s is C.R)", None),
    ("class C(enum.IntFlag):\n    normal = 1\n    B = 2", "", "return s + (C.normal | C.B)", None),
    ("class M(int):\n    def __add__(self, x): return 5\nk = M(3)", "", "return s + (k + 1)", "the global k is a value of M, which is no NamedTuple (line 8)"),
    ("class V(tuple):\n    def __add__(self, x): return 5\nk = V((1, 2))", "", "return s + (k + k)", "the global k is a value of V, which is no NamedTuple (line 8)"),
    ("class C(enum.Enum): R = 1\nk = C.R", "", "return s + (s is k)", None),
    ("draw = np.random.default_rng(0).random", "", "return s + draw()", "it draws from random, which no seed of a run reaches: draw from rng (line 6)"),
    ("class P(NamedTuple):\n    x: float\n    def twice(self): return 2 * self.x\np = P(1.5)", "", "return s + p.twice()", None),
    ("make = np.random.default_rng", "", "return s + make(3).random()", "it draws from random, which no seed of a run reaches: draw from rng (line 6)"),
    ("from numba import int64", "K = int64", "return s + self.K(s)", "T.K is a function or class"),
    ("", "def g(self, s, *, k): return s", "return self.g(s, k=1)", "g has parameters after *: leave the * out (line 4)"),
    ("", "def g(self, s, **k): return s", "return self.g(s)", "g takes **: name its parameters (line 4)"),
    ("", "", "return self._replace(v=s).v", None),
    ("f = np.linalg.norm", "", "return s + f(s)", "it uses f (line 6)"),
    ("from numba import int64 as k", "", "return s + k(s)", "it uses k (line 6)"),
    ("def g(x):\n    def h(y):\n        return y\n    return h(x)", "", "return g(s)", None),
    ("", "", "import math; return s", "it imports (line 6)"),
    ("", "", "with s: return s", "it has a try or with (line 6)"),
    ("", "", "yield s", "it has a yield (line 6)"),
    ("", "", "class C: pass", "it makes a class (line 6)"),
    ("", "", "self.v = 2", "it assigns the attribute v (line 6)"),
    ("", "", "return s + missing.y", "there is no missing (line 6)"),
    ("from numpy import *", "", "return s + round(s)", "it uses np.round (line 6)"),
    ("from math import *", "", "return s + pow(s, 2)", "it uses math.pow (line 6)"),
    ("def g(x):\n    k = 1\n    def h():\n        nonlocal k\n        k += 1\n    return x", "", "return g(s)", None),
    ("", "def __call__(self): return 1", "return s", "T defines __call__, which machine code would not call"),
    ("", "@classmethod\ndef __sub__(cls, x): return 1", "return s - (self - s)", "T defines __sub__, which machine code would not call"),
    ("class M:\n    def __bool__(self): return False\nclass N(NamedTuple):\n    x: float\nclass P(N, M): pass\np = P(1.5)", "", "return s + p.x", "M defines __bool__, which machine code would not call"),
    ("", "def __repr__(self): return 'T'", "return s", None),
    ("", "def own__(self): return 2", "return s + self.own__()", None),
    ("", "def uniform(self): return 2", "return s + self.uniform()", "T has a member named uniform, as rng has"),
    ("A = np.zeros(2)", "K = A[1:]", "return s + self.K[0]", None),
    ("", "def g(self, s, k=(np.zeros(1, np.int32),)): return s", "return self.g(s)", "default of g[0] is an array of int32; of arrays it takes those of float64, int64 and bool (line 4)"),
    ("", "K = np.zeros(2, np.int32)", "return s + self.K[0]", "T.K is an array of int32; of arrays it takes those of float64, int64 and bool"),
    ("K = np.zeros(2, np.int32)", "", "return s + K[0]", "the global K is an array of int32; of arrays it takes those of float64, int64 and bool (line 6)"),
    ("class P(NamedTuple):\n    x: float\n    K = [1.0]\nP.__module__ = 'edugym.somewhere'\np = P(1.5)", "", "return s + p.K[0]", None),
    ("K = {1}\ndef g(x):\n    K = x\n    def h(y):\n        return y + K\n    return h(K)", "", "return g(s)", None),
    ("def make(k):\n    def g(x):\n        def h(y):\n            return y + k\n        return h(x)\n    return g\ng = make(2)", "", "return g(s)", None),
    ("class P(NamedTuple):\n    x: tuple\np = P((1, [2]))", "", "return s + p.x[0]", "the field x of P[1] is a list: use an array or a tuple (line 8)"),
    ("import types\nm = types.ModuleType('m')", "", "return s + m.missing", None),
    ("import sys", "", "return s + sys.maxsize % 2", "it uses the module sys (line 6)"),
    ("import os", "", "return s + len(os.name)", "it uses the module os (line 6)"),
    ("class P(NamedTuple):\n    x: float\nclass U(P):\n    def __new__(cls, x): return P.__new__(cls, 2 * x)", "", "return s + U(1.0).x", "U defines __new__, which machine code would not call"),
    ("import time", "", "return s + time.time()", "it uses the module time (line 6)"),
    ("f = 'word'.count", "", "return s + f('w')", "it uses f (line 6)"),
    ("class C: _fields = ()", "", "return s + (C is None)", "it uses the class C, which is no NamedTuple (line 6)"),
    ("class P(NamedTuple):\n    x: float", "", "return P(s)", None),
    ("", "", "k = math; return s.gamma", None),
    ("", "", "return s + math.pi", None),
    ("", "", "return s + sum({k} is None for k in range(3))", "it makes a set (line 6)"),
    ("def make(k):\n    def g(x):\n        nonlocal k\n        k += 1\n        return x + k\n    return g\ng = make(0)", "", "return g(s)", "it assigns k, a variable of the function around it (line 4)"),
    ("import random", "", "return s + random.random()", "it draws from random, which no seed of a run reaches: draw from rng (line 6)"),
    ("R = np.random", "", "return s + R.random()", "it draws from numpy.random, which no seed of a run reaches: draw from rng (line 6)"),
    ("L = np.linalg", "", "return s + L.norm(s)", "it uses the module numpy.linalg (line 6)"),
    ("G = np.random.default_rng(0)", "", "return s + G.random()", "the global G is a random generator: take it as rng (line 6)"),
    (MODULES, "", "return s + m.inner.draw()", "it draws from random, which no seed of a run reaches: draw from rng (line 10)"),
    (MODULES, "", "return s + m.inner.P.x", "the global m.inner.P is a value of SimpleNamespace, which is no NamedTuple (line 10)"),
    (MODULES, "", "return s + m.inner.K", None),
    ("", "", "return s + len(f'{s}')", "it makes text (line 6)"),
    ("", "", "print(s); return s", "it prints (line 6)"),
    ("", "", "global K; K = 1; return s", "it assigns a global variable (line 6)"),
    ("", "", "global K; del K; return s", "it deletes a global variable (line 6)"),
    ("", "", "del T.K; return s", "it assigns the attribute K (line 6)"),
    ("", "", "return s + isinstance(s, float)", "it asks for the type of a value (line 6)"),
    ("", "", "return s + sum(x > 0 for x in range(3))", "a for in a call needs [ ], as in sum([...]) (line 6)"),
    ("", "", "return s + len({1, s})", "it makes a set (line 6)"),
    ("", "", "return s + {1: s}[1]", "it makes a dict (line 6)"),
    ("", "", TRY, "it has a try or with (line 7)"),
    ("def make(h):\n    def g(x): return x + len(h)\n    return g\ng = make([])", "", "return g(s)", "the global h is a list: use an array or a tuple (line 2)"),
]  # fmt: skip


@pytest.mark.parametrize(("before", "members", "body", "sentence"), CODE, ids=lambda text: str(text)[:40])
def test_code(before: str, members: str, body: str, sentence: str | None) -> None:
    """With the line, and the names as they stand there."""
    assert said(before, members, body) == sentence


@pytest.mark.parametrize(
    ("home", "value", "reason"),
    [
        ("edugym.adapters.made", np.zeros(2, np.int32), None),
        ("edugym.adapters.made", (1, np.zeros(2, np.int32)), None),
        ("edugym.adapters.made", np.array(1, np.int32), "is an array of int32"),
        ("edugym.adapters.made", List([1.0]), None),  # made for what has any number of parts
        ("edugym.adapters.made", max, "is a function or class"),
        ("edugym.envs.made", np.zeros(2, np.int32), "is an array of int32"),
        ("edugym.envs.made", np.random.default_rng(0), None),
        ("__main__", np.random.default_rng(0), "is a random generator"),
    ],
)
def test_what_the_package_holds(home: str, value: Any, reason: str | None) -> None:
    """Its adapters keep other programs' tables, and pass them on; its streams are its own."""
    before = f"class P(NamedTuple):\n    x: object\nP.__module__ = {home!r}\np = P(given)"
    found = said(before, "", "return s + (p.x is None)", namespace={"given": value})
    assert (found is None) == (reason is None)
    assert (reason or "") in (found or "")


def test_an_array_that_is_a_field_as_well() -> None:
    """Also a part of one, also in a class; what is shown to the loop from step to step may be one."""
    table = np.zeros(4)
    for members, body, sentence in (
        ("K = (1, A[1:])", "return s + self.K[1][0]", "the array K is a field as well: use only the field"),
        ("", "return s + A[0]", "the array A is a field as well: use only the field (line 5)"),
    ):
        outer: dict[str, Any] = {"A": table}
        assert said("", members, body, (1, table[:2]), namespace=outer) == sentence
        assert said("", members, body, (1, np.zeros(2)), carry=(table[:],), namespace=outer) is None


def test_lines() -> None:
    """Cells of a notebook have files with names that mean nothing to their author."""
    assert place("/tmp/ipykernel_7/1234.py", 3) == "line 3"
    assert place("<ipython-input-3-abc>", 3) == "line 3"
    assert place("C:\\work\\agents.py", 3) == "agents.py, line 3"
    assert place("/work/12/agents.v2.py", 3) == "agents.v2.py, line 3"

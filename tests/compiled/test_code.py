"""Redefine a class, edit a method, change a constant: the next call runs the new code, interpreted and compiled."""

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from edugym.adapters.registration import make_mdp
from edugym.agents.q_learning import QLearning
from edugym.compiled import code
from edugym.compiled.code import Code
from edugym.compiled.compiler import compiled
from edugym.compiled.subset import refusal
from edugym.training.loops import play_episodes
from tests.compiled.cells import cell
from tests.compiled.processes import printed


def loop(n: int, thing: Any, rng: np.random.Generator) -> float:
    """What is run: a method, n times."""
    s = 0.0
    for _ in range(n):
        s = thing.f(s, rng)
    return s


def notebook(before: str, method: str = "return s + g(1.0)", others: str = "") -> str:
    """The source of a class `T` whose method may use what comes before it, and its other members."""
    return f"{before}\nclass T(NamedTuple):\n    size: int\n    def f(self, s, rng):\n        {method}\n    {others}\n"


POINT = "class P(NamedTuple):\n    x: int\n    def m(self): return self.x"
"""The start of a class with a method."""


def versions(before: str, one: str, other: str, method: str = "return s + g(1.0)", others: str = "") -> tuple[str, str]:
    """Two versions of a notebook, in which one text stands where the other does."""

    def version(k: str) -> str:
        return notebook(*(part.replace("?", k) for part in (before, method, others)))

    return version(one), version(other)


TWO = "def a(x): return x + 1\ndef b(x): return x + 2\ng = ?"
NJIT = "import numba\n@numba.{}\ndef g(x): return x + ?"
CHANGES = {
    "method": versions("", "1", "2", "return s + ?"),
    "operator": versions("", "+", "-", "return s ? 2"),
    "other method": versions("", "1", "2", "return self.g(s)", "def g(self, s): return s + ?"),
    "method named as one of tuple": versions("", "1", "2", "return self.count(s)", "def count(self, s): return s + ?"),
    "static method": versions("", "1", "2", "return self.g(s)", "@staticmethod\n    def g(s): return s + ?"),
    "inner function": versions("", "1", "2", "return self.g(s)", "def g(self, x): return (lambda y: y + ?)(x)"),
    "property": versions("", "1", "2", "return s + self.k", "k = property(lambda self: ?)"),
    "class constant": versions("", "1", "2", "return s + self.K", "K = ?"),
    "class constant tuple": versions("", "2", "3", "return s + self.K[1]", "K = (1, ?)"),
    "helper": versions("def g(x): return x + ?", "1", "2"),
    "helper of a helper": versions("def h(x): return x + ?\ndef g(x): return h(x)", "1", "2"),
    "default of a helper": versions("def g(x, k=?): return x + k", "1", "2"),
    "default of a keyword": versions("def g(x, *, k=?): return x + k", "1", "2"),
    "array as default": versions("A = np.zeros(2000)\nA[1000] = ?\ndef g(x, k=A): return x + k[1000]", "1", "2"),
    "lambda": versions("g = lambda x: x + ?", "1", "2"),
    "closure": versions("def make(k):\n    def g(x): return x + k\n    return g\ng = make(?)", "1", "2"),
    "comprehension": versions("def g(x): return [k * x for k in (1, ?)][1]", "2", "3"),
    "constant": versions("K = ?", "1", "2", "return s + K"),
    "type of a constant": versions("K = ?", "1", "1.5", "return s + 1 / (K + 1)"),
    "one of equal constants": versions("A = 1\nB = 2\nC = ?", "1", "2", "return s + A + 10 * B + 100 * C"),
    "array": versions("A = np.full(3, ?)", "1.0", "2.0", "return s + A[1]"),
    "type of an array": versions("A = np.array([2**24 + 1], np.float?)", "64", "32", "return s + A[0]"),
    "tuple": versions("A = (1, (2, ?))", "3", "4", "return s + A[1][1]"),
    "slice": versions("A = slice(0, ?)", "2", "3", "return s + np.arange(10.0)[A].sum()"),
    "number of an enum": versions("class E(enum.Enum):\n    A = ?", "1", "2", "return s + E.A.value"),
    "kind of an enum": versions("class E(enum.?):\n    A = 1", "Enum", "IntEnum", "return s + (E.A == 1)"),
    "default of a field": versions("class P(NamedTuple): x: int = ?", "1", "2", "return s + P().x"),
    "library function": versions("from math import ? as g", "sin", "cos"),
    "library function of arrays": versions("g = np.?", "sin", "cos"),
    "library type": versions("K = np.?", "int64", "float64", "return s + K(2.7)"),
    "which helper a name stands for": versions(TWO, "a", "b", "return g(a(b(s)))"),
    "value of another class": versions("class P(NamedTuple):\n    x: int\np = P(?)", "1", "2", "return s + p.x"),
    "method of a value": versions(f"{POINT} + ?\np = P(1)\ndel P", "1", "2", "return s + p.m()"),
    "method of a class that is called": versions(f"{POINT} + ?", "1", "2", "return s + P(1).m()"),
    "inherited method": tuple(
        f"{POINT} + {k}\nclass T(P):\n    def f(self, s, rng): return s + self.m()" for k in (1, 2)
    ),
    "type of Numba's": versions("import numba\nK = numba.?", "int64", "float64", "return s + K(2.7)"),
    "data type": versions("K = np.dtype(np.?)", "int64", "float64", "return s + np.full(1, 2.7).astype(K)[0]"),
    "function compiled by its author": versions(NJIT.format("njit"), "1", "2"),
    "function of arrays compiled by its author": versions(NJIT.format("vectorize"), "1", "2"),
}
"""Two versions of a notebook, which differ in one thing only."""


def fingerprint(source: str) -> str:
    """The fingerprint of a loop over a value of a notebook's class."""
    return Code(loop, (10, cell(source)["T"](1))).fingerprint


def values(thing: Any) -> tuple[float, float]:
    """The result of the loop, interpreted and compiled."""
    arguments = (10, thing, np.random.default_rng(0))
    return float(loop(*arguments)), float(compiled(loop, *arguments)(*arguments))


def edit(kind: type, notebook: dict[str, Any], source: str) -> None:
    """Run an edited cell in its notebook, and give a class from before the new members."""
    cell(source, notebook)
    for old, new in zip(kind.__mro__, notebook[kind.__name__].__mro__, strict=True):
        for name, member in vars(new).items() if old is not new else ():
            if not name.startswith("_") and name not in kind.__annotations__:
                setattr(old, name, member)


BUILT = ["method", "property", "class constant", "helper", "closure", "array", "value of another class"]
"""Of each kind one that is compiled; the fingerprints of all of them are compared below."""


@pytest.mark.parametrize("change", BUILT)
def test_redefined(change: str) -> None:
    """An edited class runs its own code, in whatever order; so does the old one, until it is edited in place."""
    before, after = CHANGES[change]
    notebook = cell(before)
    old, new = notebook["T"](1), cell(after)["T"](1)
    (first, first_compiled), (second, second_compiled) = values(old), values(new)
    assert first == first_compiled != second == second_compiled
    assert values(old) == (first, first)
    edit(type(old), notebook, after)
    assert values(old) == (second, second)


@pytest.mark.parametrize(("before", "after"), CHANGES.values(), ids=CHANGES)
def test_fingerprints(before: str, after: str) -> None:
    """The fingerprint changes with the code, however little of it changes, and with nothing else; in place, too."""
    assert fingerprint(before) == fingerprint(before) == fingerprint("# a comment\n\n" + before)
    assert fingerprint(after) == fingerprint(after) != fingerprint(before)
    notebook = cell(before)
    thing = notebook["T"](1)
    old = Code(loop, (10, thing)).fingerprint
    edit(type(thing), notebook, after)
    assert Code(loop, (10, thing)).fingerprint != old
    edit(type(thing), notebook, before)
    assert Code(loop, (10, thing)).fingerprint == old


def test_which_of_pythons_own_names_is_hidden_counts() -> None:
    """The same helper under the name of one function of Python's, or of another."""
    before, after = versions("def h(x): return 2 * x\n? = h", "abs", "round", "return abs(s) + round(s)")
    assert fingerprint(before) != fingerprint(after)


def made(n: int, thing: Any) -> Any:
    """What is run: a method that makes a value."""
    value = thing.make(0)
    for k in range(1, n):
        value = thing.make(k)
    return value


def test_values_are_of_the_new_class() -> None:
    """Run the cell of a class again, and what others make of it is of the class as it is now, changed or not."""
    point = "class P(NamedTuple):\n    x: int"
    notebook = cell(f"{point}\nclass Maker(NamedTuple):\n    size: int\n    def make(self, k): return P(k)")
    maker = notebook["Maker"](1)
    for _ in range(2):
        assert type(compiled(made, 5, maker)(5, maker)) is notebook["P"]
        cell(point, notebook)


def test_modules_of_a_student() -> None:
    """What code takes from a module of its author counts, also from a module in a module; nothing else in it does."""
    outer, inner = ModuleType("student"), ModuleType("student.inner")
    vars(outer).update(inner=inner, K=1, unused=0)
    vars(inner).update(L=2, outer=outer)
    variables = cell(notebook("", "return s + m.K + m.inner.L") + "m = None")
    variables["m"] = outer
    task = variables["T"](1)
    known = Code(loop, (10, task))
    assert values(task) == (30.0, 30.0)
    vars(outer).update(unused=1)
    assert known.first_change() is None
    assert known.fingerprint == Code(loop, (10, task)).fingerprint
    fingerprints = {known.fingerprint}
    for module, change, named in ((outer, {"K": 5}, "student.K"), (inner, {"L": 7}, "student.inner.L")):
        known = Code(loop, (10, task))
        vars(module).update(change)
        assert known.first_change() == named
        fingerprints.add(Code(loop, (10, task)).fingerprint)
    assert len(fingerprints) == 3
    assert values(task) == (120.0, 120.0)


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


def test_what_is_reached() -> None:
    """Classes and functions are found wherever they are used; those of libraries are left out."""
    source = notebook(
        "class P(NamedTuple):\n    x: int\n    def m(self): return h(self.x)\ndef h(x): return math.sqrt(x)\n"
        "def g(x): return P(3).m() + np.sin(x)"
    )
    kind, task = cell(source)["T"], make_mdp("Boulder")
    reached = Code(loop, (10, kind(1)))
    assert [one.__qualname__ for one in reached.classes] == ["T", "P"]
    assert {function.__qualname__ for function in reached.functions} == {"loop", "T.f", "g", "P.m", "h"}
    assert (reached.foreign, reached.importable, reached.names()) == (True, False, "T, P")
    assert Code(loop, (10, kind(1), task)).names() == "T, P", "none of the package"
    own = Code(play_episodes, (10, task, QLearning.create(task)))
    assert (own.foreign, own.importable) == (False, True)
    assert own.names().startswith("Boulder, QLearning")
    assert Code(loop, (10, task)).foreign


UNREACHED = """
    @classmethod
    def create(cls): return cls(len({}))
    def scene(self, state): return draw(state, {})
    def info(self, state): return {{"k": {}}}
    @property
    def observation_space(self): return spaces.Discrete({})
"""


def test_what_no_loop_names_does_not_count() -> None:
    """Methods that machine code cannot reach are neither walked through nor hashed, whatever they use."""

    def code(k: str) -> Code:
        body = UNREACHED.format(*[k] * 4)
        source = notebook("big = {i: (i,) for i in range(9)}\ndef draw(a, b): return big", "return s + 1", body)
        return Code(loop, (10, cell(source)["T"](1)))

    first, second = code("'abc'"), code("'abcd'")
    assert first.fingerprint == second.fingerprint
    assert {function.__qualname__ for function in first.functions} == {"loop", "T.f"}
    assert {name for _, name in first.members} == {"f"}


HASHES = """
from tests.compiled.cells import cell
from tests.compiled.test_code import Code, loop, notebook
before = (
    "import types\\nS = frozenset({'x', 'yy', 'zzz'})\\nA, B, C = 1, 2, 3\\nm = types.ModuleType('m')\\n"
    "m.G, m.H, m.I = 1, 2, 3"
)
body = "return s + ('a' in {'a', 'b', 'c', ('d', 'e')}) + ('x' in S) + A + B + C + self.D + self.E + m.G + m.H + m.I"
source = notebook(before, body, "D, E = 1, 2")
print(Code(loop, (10, cell(source)["T"](1))).fingerprint)
"""


def test_same_fingerprint_in_every_process() -> None:
    """Sets of strings, whose order changes from process to process, do not change it."""
    assert len({printed(HASHES, PYTHONHASHSEED=seed) for seed in ("1", "2", "3")}) == 1


def test_every_file_of_the_compiler_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """What another version of any file of the compiler has left on disk is not used."""
    thing = cell(notebook("", "return s + 1"))["T"](1)
    original, seen = Path.read_bytes, set()

    def read(path: Path) -> bytes:
        seen.add(path.name)
        return original(path)

    monkeypatch.setattr(Path, "read_bytes", read)
    fresh: Any = code._hash_of_compiler
    fresh.cache_clear()
    Code(loop, (10, thing))
    assert {"code.py", "compiler.py", "execution.py", "random_generators.py"} <= seen


def test_changes_are_noticed() -> None:
    """A look tells whether a method, a constant of a class, a global or the code of a function has changed."""
    notebook = cell(
        "K, A = 1, np.zeros(2)\ndef g(x): return x + K + A[0]\n"
        "def around():\n    k = 1\n    return lambda x: x + k\n"
        "h = around()\nclass T(NamedTuple):\n    size: int\n    L = 3\n"
        "    def f(self, s, rng): return g(s) + h(s) + self.L"
    )
    kind, other = notebook["T"], cell("def g(x): return x + 5")["g"]
    changes: list[Callable[[], Any]] = [
        lambda: notebook.update(K=2),
        lambda: notebook["A"].fill(1),
        lambda: setattr(notebook["h"].__closure__[0], "cell_contents", 2),
        lambda: setattr(kind, "L", 4),
        lambda: setattr(notebook["g"], "__code__", other.__code__),
        lambda: notebook.update(g=other),
        lambda: setattr(kind, "f", lambda self, s, rng: s),
    ]
    for change in changes:
        now = Code(loop, (10, kind(1)))
        assert now.first_change() is None
        change()
        assert now.first_change()


def test_a_global_is_one_that_is_loaded_as_one() -> None:
    """A notebook's variable with the name of a field, of which no method knows, keeps nothing from being compiled."""
    source = notebook("size = [3]\ntable = {}", "return s + self.size + (lambda k: k + OTHER)(1)")
    values = cell(f"OTHER = 2\n{source}")
    reached = Code(loop, (values["T"](3),))
    assert {name for function, name in reached.globals if function.__module__ == "__main__"} == {"OTHER"}
    assert refusal(reached, (), ()) is None
    long = "\n".join(f"        s = s + self.a{k}" for k in range(300))  # names beyond the first 256
    many = cell(
        f"LATE = 5\nclass T(NamedTuple):\n    size: int\n    def f(self, s, rng):\n{long}\n        return LATE\n"
    )
    assert "LATE" in {name for _, name in Code(loop, (many["T"](3),)).globals}

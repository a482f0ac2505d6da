"""Machine code of plain Python: what it can be made of, where it is kept, and that it leaves everything else alone."""

import importlib
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import permutations
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import Mock

import numba
import numpy as np
import pytest
from numba.core.errors import TypingError

import edugym
from edugym.compiled import compiler, namedtuples
from edugym.compiled.compiler import compiled
from edugym.compiled.numba_setup import CompilationError
from tests.compiled.cells import cell
from tests.compiled.processes import printed


def plain_loop(n: int, thing: Any, rng: np.random.Generator) -> float:
    """Call a method n times."""
    s = 0.0
    for _ in range(n):
        s = thing.f(s, rng)
    return float(s)


def loop_of_two(n: int, first: Any, second: Any, rng: np.random.Generator) -> float:
    """Call a method of two values in turn."""
    s = 0.0
    for _ in range(n):
        s = first.f(s, rng) - 2 * second.f(s, rng)
    return s


def both(loop: Callable[..., Any], *arguments: Any) -> tuple[Any, Any]:
    """The result, and the random stream afterwards, interpreted and compiled."""
    results = []
    for run in (loop, compiled(loop, *arguments, np.random.default_rng(0))):
        rng = np.random.default_rng(5)
        result = run(*arguments, rng)
        results.append((result, rng.bit_generator.state["state"]["state"]))
    return results[0], results[1]


EVERYTHING = """
class Inner(NamedTuple):
    scale: float
    table: np.ndarray

    @property
    def doubled(self):
        return 2.0 * self.scale

    def f(self, s, rng):
        return s * self.scale + self.table[int(rng.random() * len(self.table))]

class Outer(NamedTuple):
    inner: Inner
    pair: tuple
    doubled: float

    SHIFT = 0.25
    WEIGHTS = (1, 2.5, True)
    LABEL = "outer"

    @property
    def size(self):
        return int(self.inner.doubled + self.doubled)

    def scale(self, s, by=2):
        return s * by if self.LABEL == "outer" else 0.0

    def made(self, s):
        return Inner(s, self.inner.table)

    def f(self, s, rng):
        number, other = self.pair
        s = helper(s, number) + self.scale(s) + self.scale(s, by=3) + self.SHIFT
        s += self.WEIGHTS[1] * self.size + other.f(s, rng) + self.made(s).f(0.5, rng) + self.inner.doubled
        return s % 1000.0 if s > 0 else -s

def helper(s, number):
    return other_helper(s) + number

def other_helper(s):
    return s / 3.0

inner = Inner(0.5, np.array([1.0, 2.0, 4.0]))
outer = Outer(inner, (3, inner._replace(scale=0.75)), 1.5)
"""


class Adder(NamedTuple):
    """A class that other processes can import."""

    k: float

    def f(self, s: float, rng: np.random.Generator) -> float:
        """Add, and draw."""
        return s + self.k * rng.random()


def test_what_a_class_may_be_made_of() -> None:
    """Nested values, properties, constants, defaults, keywords, helpers, new values, and names that are used twice."""
    interpreted, machine_code = both(plain_loop, 100, cell(EVERYTHING)["outer"])
    assert interpreted == machine_code


def test_same_names_in_two_classes() -> None:
    """A name may be a field here, a method there and a property elsewhere, in classes of one name."""
    sources = (
        "k: float\n    def f(self, s, rng): return s + self.k",
        "other: float\n    k = property(lambda self: 2.0)\n    def f(self, s, rng): return s + self.k",
        "other: float\n    def k(self): return 3.0\n    def f(self, s, rng): return self.other * self.k() - s",
    )
    things = [cell(f"class A(NamedTuple):\n    {source}")["A"](k) for k, source in enumerate(sources, 1)]
    for one, other in permutations(things, 2):
        interpreted, machine_code = both(loop_of_two, 20, one, other)
        assert interpreted == machine_code


def test_types_that_change(monkeypatch: pytest.MonkeyPatch) -> None:
    """Machine code that is called with values of other types is made for these as well, and never by Numba alone."""
    build = Mock(wraps=compiler._build)
    monkeypatch.setattr(compiler, "_build", build)
    monkeypatch.setattr(compiler, "_built", {})  # as in a new process
    task = cell("class A(NamedTuple):\n    k: int\n    def f(self, s, rng): return s / 2 + self.k")["A"]
    run = compiled(plain_loop, 3, task(1), np.random.default_rng(0))
    for value in (1, 1.5, 2**40, np.float64(0.1), np.int64(7), -2.5, True):
        assert run(3, task(value), np.random.default_rng(0)) == plain_loop(3, task(value), np.random.default_rng(0))
    with pytest.raises(CompilationError):
        run(3, task("one"), np.random.default_rng(0))
    assert build.call_count == 4


EVERYDAY = """x = self.t.max() + self.t.min() + np.max(self.t) + np.min(self.t) + max(self.t) + np.argmax(self.t)
        self.t[self.t.argmax()] += rng.integers(3) + rng.integers(1, 3) + rng.integers(low=0, high=9, endpoint=True)
        self.t[0] = self.t.sum() + np.mean(self.t) + np.dot(self.t, self.t) % 2 + rng.normal() + rng.uniform(0, 1)
        self.t[:] *= 0.2
        self.t[int(s) % 3 :] += np.clip(x, 0, 1) + rng.integers(3, dtype=int)
        return (s + x) % 100"""
"""What students write in every agent."""


@pytest.fixture
def builds(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, bool]]:
    """Numba's options in the builds that are tried, none of which was made before."""
    built: list[dict[str, bool]] = []
    original = compiler._compile

    def watched(*arguments: Any) -> Any:
        built.append(arguments[-1])
        return original(*arguments)

    monkeypatch.setattr(compiler, "_compile", watched)
    monkeypatch.setattr(compiler, "_built", {})
    return built


def rest_of_the_table(n: int, mdp: Any, rng: Any) -> tuple[int, Any]:
    """Give back a part of an array, which owns nothing itself."""
    return n, mdp.t[1:]


@pytest.mark.parametrize(
    ("loop", "body", "counts"),
    [
        (plain_loop, "return s + self.t[0]", False),
        (plain_loop, EVERYDAY, False),
        (plain_loop, "return s + (2 * self.t).sum()", True),
        (rest_of_the_table, "return s", True),
    ],
)
def test_reference_counts(loop: Any, body: str, counts: bool, builds: list[dict[str, bool]]) -> None:
    """There are some only where something allocates or is given back; all that is allocated is freed."""
    kind = cell(f"class A(NamedTuple):\n    t: np.ndarray\n    def f(self, s, rng):\n        {body}\n")["A"]
    run = compiled(loop, 1, kind(np.arange(4.0)), np.random.default_rng(0))
    interpreted, machine_code = (way(50, kind(np.arange(4.0)), np.random.default_rng(5)) for way in (loop, run))
    assert str(interpreted) == str(machine_code)
    assert [options.get("_nrt", True) for options in builds] == [False, True][: 1 + counts]
    assert all(options["boundscheck"] for options in builds)
    values = kind(np.arange(4.0)), np.random.default_rng(0)
    run(1, *values)
    memory: Any = importlib.import_module("numba.core.runtime._nrt_python")
    memory.memsys_enable_stats()
    made, freed = memory.memsys_get_stats_alloc(), memory.memsys_get_stats_free()
    references = [sys.getrefcount(value) for value in (*values, values[0].t)]
    for _ in range(100):
        run(10, *values)
    assert [sys.getrefcount(value) for value in (*values, values[0].t)] == references
    assert memory.memsys_get_stats_alloc() - made == memory.memsys_get_stats_free() - freed
    memory.memsys_disable_stats()


def starts(n: int, mdp: Any, rng: np.random.Generator) -> int:
    """Draw n first states of a panel with switches."""
    wrong = 0
    for _ in range(n):
        state = mdp.initial(rng)
        wrong += state.switches ^ state.goal
    return wrong


def test_own_code_draws_integers_without_an_array(builds: list[dict[str, bool]]) -> None:
    """An environment that calls `rng.integers` costs its loop no reference counts, and draws what NumPy draws."""
    interpreted, machine_code = both(starts, 99, edugym.make_mdp("Switches", n_switches=7))
    assert interpreted == machine_code
    assert [options.get("_nrt", True) for options in builds] == [False]


def test_threads() -> None:
    """Threads may compile at once, the same or different code."""
    source = "class A(NamedTuple):\n    k: int\n    def f(self, s, rng): return s + {0} * h(s)\ndef h(s): return {0}.5"
    all_arguments = [(10, cell(source.format(k))["A"](1), np.random.default_rng(0)) for k in range(4)] * 2
    with ThreadPoolExecutor(8) as threads:
        results = list(threads.map(lambda arguments: compiled(plain_loop, *arguments)(*arguments), all_arguments))
    assert results == [plain_loop(*arguments) for arguments in all_arguments]


def user_helper(x: float) -> float:
    """A plain function of a user who knows Numba."""
    return x + 1.0


def users_function(x: float) -> float:
    """A function that calls it."""
    return user_helper(x)


def test_numba_itself_is_as_before() -> None:
    """A user's own @njit code meets the Numba it knows: undecorated helpers are refused, NamedTuples are as ever."""
    thing = cell(EVERYTHING)["outer"]
    both(plain_loop, 3, thing)
    njit: Any = numba.njit
    with pytest.raises(TypingError, match="Untyped global name 'user_helper'"):
        njit(users_function)(1.0)
    with pytest.raises(TypingError, match="annot determine Numba type"):
        njit(lambda function, x: function(x))(user_helper, 1.0)
    assert njit(lambda thing: thing.doubled + thing[0][0])(thing) == 2.0
    with pytest.raises(TypingError, match="missing"):
        njit(lambda thing: thing.missing)(thing)


def test_users_own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Numba's own cache folder stays where the user has put it, also when compiling fails."""
    config: Any = numba.config
    monkeypatch.setattr(config, "CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(compiler, "_built", {})  # as in a new process
    both(plain_loop, 3, Adder(0.5))
    thing = cell("class A(NamedTuple):\n    k: int\n    def f(self, s, rng): return s + self.missing")["A"](1)
    with pytest.raises(CompilationError):
        compiled(plain_loop, 1, thing, np.random.default_rng(0))
    assert str(tmp_path) == config.CACHE_DIR
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_left_of_a_build() -> None:
    """Not its options, nor functions, which would keep a notebook's old classes alive; after an error, too."""
    function: Any = plain_loop
    with pytest.raises(KeyError), namedtuples.building({"boundscheck": True}, {function}):
        raise KeyError(len(namedtuples._helpers))
    assert (namedtuples._options, namedtuples._helpers, namedtuples._parts) == ({}, set(), {})


def test_the_first_result_needs_no_linear_algebra() -> None:
    """Numba imports scipy.linalg at its start only to see that it is there: a sixth of the time to the first result."""
    printed("""
import sys
from edugym import QLearning, make_mdp, train
wall = make_mdp("Boulder")
train(wall, QLearning.create(wall), 10_000)
assert "numba" in sys.modules
assert "scipy.linalg" not in sys.modules
import numba.np.linalg
assert numba.np.linalg.ensure_blas.__name__ == "ensure_blas", "a user's own code still has it looked at"
""")

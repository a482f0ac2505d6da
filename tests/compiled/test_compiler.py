"""Machine code of plain Python: what it can be made of, where it is kept, and that it leaves everything else alone."""

import importlib
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import Mock

import numba
import numpy as np
import pytest
from numba.core.errors import TypingError

from edugym.compiled import compiler
from edugym.compiled.compiler import CompilationError, compiled
from edugym.compiled.disk import cache_directory
from tests.compiled.cells import cell


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
        ("k: float", "", "s + self.k"),
        ("other: float", "k = property(lambda self: 2.0)", "s + self.k"),
        ("other: float", "def k(self): return 3.0", "self.other * self.k() - s"),
    )
    things = [
        cell(f"class A(NamedTuple):\n    {field}\n    {member}\n    def f(self, s, rng): return {value}")["A"](float(k))
        for k, (field, member, value) in enumerate(sources, 1)
    ]
    for one in things:
        for other in things:
            interpreted, machine_code = both(loop_of_two, 20, one, other)
            assert interpreted == machine_code


def test_types_of_fields() -> None:
    """Fields may be of other types than the class says, and each runs by its own."""
    kind = cell("class A(NamedTuple):\n    k: int\n    def f(self, s, rng): return s / 2 + self.k")["A"]
    for value in (7, 7.0, 7.5, True, np.int64(7), np.float64(0.1), 2**40, -1):
        interpreted, machine_code = both(plain_loop, 5, kind(value))
        assert interpreted == machine_code


def test_types_that_change(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same machine code may be called with values of other types afterwards: then it is made for these as well.

    That is never left to Numba, which knows nothing of what code may do.
    """
    build = Mock(wraps=compiler._build)
    monkeypatch.setattr(compiler, "_build", build)
    monkeypatch.setattr(compiler, "_built", {})  # as in a new process
    task = cell("class A(NamedTuple):\n    k: int\n    def f(self, s, rng): return s / 2 + self.k")["A"]
    run = compiled(plain_loop, 3, task(1), np.random.default_rng(0))
    for value in (1, 1.5, 2, 2.5, True):
        assert run(3, task(value), np.random.default_rng(0)) == plain_loop(3, task(value), np.random.default_rng(0))
    with pytest.raises(CompilationError):
        run(3, task("one"), np.random.default_rng(0))
    assert build.call_count == 4


LEAN = """
class A(NamedTuple):
    t: np.ndarray
    def f(self, s, rng):
        self.t[int(rng.random() * 4)] += 1
        return s + 1
"""


def test_builds_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    """A build without reference counts gives what one with them gives; neither keeps what it was called with."""
    built = []
    original = compiler._compile

    def watched(*arguments: Any) -> Any:
        built.append(arguments[-1])
        return original(*arguments)

    monkeypatch.setattr(compiler, "_compile", watched)
    outcomes = []
    for lean in (True, False):
        monkeypatch.setattr(compiler, "_built", {})
        if not lean:
            monkeypatch.setattr(compiler, "_needs_no_counts", lambda kind: False)
        table = np.zeros(4)
        thing, rng = cell(LEAN)["A"](table), np.random.default_rng(0)
        outcomes.append((both(plain_loop, 100, thing), table.tolist()))
        run = compiled(plain_loop, 1, thing, rng)
        run(1, thing, rng)
        before = [sys.getrefcount(value) for value in (table, rng, thing)]
        for _ in range(100):
            run(1, thing, rng)
        assert [sys.getrefcount(value) for value in (table, rng, thing)] == before
    assert outcomes[0] == outcomes[1]
    assert [options.get("_nrt", True) for options in built] == [False, True]
    assert all(options["boundscheck"] for options in built)


def test_allocation_needs_counts() -> None:
    """Where something allocates, memory does not grow with the steps."""
    thing = cell("class A(NamedTuple):\n    k: int\n    def f(self, s, rng): return s + np.arange(self.k).sum()")["A"](
        5
    )
    assert both(plain_loop, 50, thing)[0] == both(plain_loop, 50, thing)[1]
    run = compiled(plain_loop, 1, thing, np.random.default_rng(0))
    memory: Any = importlib.import_module("numba.core.runtime._nrt_python")
    memory.memsys_enable_stats()
    made, freed = memory.memsys_get_stats_alloc(), memory.memsys_get_stats_free()
    run(1000, thing, np.random.default_rng(0))
    assert memory.memsys_get_stats_alloc() - made == memory.memsys_get_stats_free() - freed >= 1000
    memory.memsys_disable_stats()


TABLE = "class A(NamedTuple):\n    t: np.ndarray\n"


def rest_of_the_table(n: int, mdp: Any, rng: Any) -> tuple[int, Any]:
    """Give back a part of an array, which owns nothing itself."""
    return n, mdp.t[1:]


def test_an_array_that_is_given_back_needs_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without them the whole array would come in place of its part."""
    monkeypatch.setattr(compiler, "_built", {})
    arguments = 3, cell(TABLE)["A"](np.arange(4.0)), np.random.default_rng(0)
    n, part = compiled(rest_of_the_table, *arguments)(*arguments)
    assert (n, part.tolist()) == (3, [1.0, 2.0, 3.0])


EVERYDAY = """x = self.t.max() + self.t.min() + np.max(self.t) + np.min(self.t) + max(self.t) + np.argmax(self.t)
        self.t[self.t.argmax()] += rng.integers(3) + rng.integers(1, 3) + rng.integers(low=0, high=9, endpoint=True)
        self.t[0] = self.t.sum() + np.mean(self.t) + np.dot(self.t, self.t) + rng.normal() + rng.uniform(0, 1)
        self.t[:] *= 0.9
        self.t[int(s) % 3 :] += np.clip(x, 0, 1) + rng.integers(3, dtype=int)
        return s + x"""
"""What students write in every agent."""


@pytest.mark.parametrize(
    ("body", "counts"), [("return s + self.t[0]", False), (EVERYDAY, False), ("return s + (2 * self.t).sum()", True)]
)
def test_counting_is_seen_in_machine_code(body: str, counts: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where something allocates there are calls that count, and they are named."""
    monkeypatch.setattr(compiler, "_built", {})
    builds: list[Any] = []
    original = compiler._compile

    def watched(*arguments: Any) -> Any:
        builds.append(original(*arguments))
        return builds[-1]

    monkeypatch.setattr(compiler, "_compile", watched)
    thing = cell(f"{TABLE}    def f(self, s, rng):\n        {body}\n")["A"](np.arange(4.0))
    compiled(plain_loop, 1, thing, np.random.default_rng(0))
    (build,) = builds[-1].overloads.values()
    if counts:
        with pytest.raises(CompilationError, match=r"it allocates \(NRT_\w+\)"):
            compiler._check_no_counts(build)
    else:
        compiler._check_no_counts(build)


def test_indices_are_checked() -> None:
    """An index outside an array raises an IndexError, in builds of both kinds, and does not read or write beside it."""
    lean = "class A(NamedTuple):\n    t: np.ndarray\n    def f(self, s, rng): return self.t[4 + int(s)]"
    counting = (
        "class A(NamedTuple):\n    t: np.ndarray\n    def f(self, s, rng): return np.append(self.t, 1.0)[5 + int(s)]"
    )
    for source in (lean, counting):
        thing = cell(source)["A"](np.zeros(4))
        with pytest.raises(IndexError):
            compiled(plain_loop, 1, thing, np.random.default_rng(0))(1, thing, np.random.default_rng(0))


def test_threads() -> None:
    """Threads may compile at once, the same or different code."""
    sources = [
        f"class A(NamedTuple):\n    k: int\n    def f(self, s, rng): return s + {k} * h(s)\ndef h(s): return {k}.5"
        for k in range(4)
    ]
    things = [cell(source)["A"](1) for source in sources] * 2
    results: dict[int, Any] = {}

    def work(i: int) -> None:
        arguments = 10, things[i], np.random.default_rng(0)
        results[i] = compiled(plain_loop, *arguments)(*arguments)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results == {i: plain_loop(10, things[i], np.random.default_rng(0)) for i in range(8)}


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


def test_where_the_cache_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """$EDUGYM_CACHE_DIR, or `edugym` in the user's cache directory."""
    monkeypatch.setenv("EDUGYM_CACHE_DIR", str(tmp_path / "mine"))
    assert cache_directory() == tmp_path / "mine"
    monkeypatch.delenv("EDUGYM_CACHE_DIR")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache_directory() == tmp_path / "edugym"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cache_directory() == tmp_path / ".cache" / "edugym"


def test_cache_that_cannot_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a folder to keep machine code in, it is made anew and works."""
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("EDUGYM_CACHE_DIR", str(tmp_path / "file" / "cache"))

    monkeypatch.setattr(compiler, "_built", {})  # as in a new process
    interpreted, machine_code = both(plain_loop, 10, Adder(0.5))
    assert interpreted == machine_code


STUDENT = """
from typing import NamedTuple
import numpy as np
from student_constants import SPEED

def helper(s): return s + SPEED

class Task(NamedTuple):
    k: int
    def f(self, s, rng): return helper(s) + 1.0 * self.k
"""

MAIN = """
import sys
from pathlib import Path
import numpy as np
from student_loop import loop
from student import Task
from edugym.compiled.compiler import compiled

arguments = 10, Task(1), np.random.default_rng(0)
assert compiled(loop, *arguments)(*arguments) == loop(*arguments)
print(loop(*arguments))
"""

LOOP = """
def loop(n, task, rng):
    s = 0.0
    for _ in range(n):
        s = task.f(s, rng)
    return s
"""


def files(folder: Path) -> dict[str, int]:
    """All files below a folder, and when each was last written."""
    return {str(path): path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}


@pytest.mark.slow
def test_disk_cache(tmp_path: Path) -> None:
    """Another process finds machine code on the disk, and does not use it once what it was made of has changed."""
    code, cache = tmp_path / "code", tmp_path / "cache"
    code.mkdir()
    environment = os.environ | {"EDUGYM_CACHE_DIR": str(cache), "PYTHONPATH": str(code), "PYTHONDONTWRITEBYTECODE": "1"}

    def write(**modules: str) -> None:
        for name, source in modules.items():
            (code / f"{name}.py").write_text(source)

    def run() -> float:
        done = subprocess.run(
            [sys.executable, "-c", MAIN], env=environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        return float(done.stdout)

    write(student=STUDENT, student_constants="SPEED = 2", student_loop=LOOP)
    assert run() == 30
    first = files(cache)
    assert len(first) >= 2
    assert run() == 30
    assert files(cache) == first
    for modules, result in (
        ({"student_constants": "SPEED = 3"}, 40),
        ({"student": STUDENT.replace("+ 1.0 *", "+ 2.0 *")}, 50),
        ({"student_loop": LOOP.replace("s = task", "s = 1 + task")}, 60),
    ):
        write(**modules)
        before = files(cache)
        assert run() == result
        assert set(files(cache)) > set(before)


def test_the_first_result_needs_no_linear_algebra() -> None:
    """Numba imports scipy.linalg at its start only to see that it is there: a sixth of the time to the first result."""
    code = """
import sys
from edugym import QLearning, make_mdp, train
wall = make_mdp("Boulder")
train(wall, QLearning.create(wall), 10_000)
assert "numba" in sys.modules
assert "scipy.linalg" not in sys.modules
import numba.np.linalg
assert numba.np.linalg.ensure_blas.__name__ == "ensure_blas", "a user's own code still has it looked at"
"""
    subprocess.run([sys.executable, "-c", code], check=True)

"""Fingerprints: the same in every process, and others for other values or code."""

import copy
import functools
import importlib
import math
import os
import subprocess
import sys
from collections import defaultdict, deque
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import QLearning
from edugym.exact.value_iteration import best_values
from edugym.experiments import fingerprints
from edugym.experiments.fingerprints import _own_code, fingerprint


def defined(code: str, name: str = "use") -> Any:
    """A function or class of a notebook."""
    names: dict[str, Any] = {"__name__": "__main__", "sys": sys, "NamedTuple": NamedTuple}
    exec(code, names)
    return names[name]


make_adder = defined("def make_adder(n): return lambda x: x + n", "make_adder")
Settings = defined("class Settings(NamedTuple):\n    rate: float\n    table: object", "Settings")
Counter = defined("class Counter:\n    def __init__(self, start): self.count = start", "Counter")


def made(body: str, base: type = object) -> Any:
    """A class of a notebook."""
    names: dict[str, Any] = {"__name__": "__main__", "functools": functools, "Base": base}
    exec(f"class Made(Base):\n    {body}", names)
    return names["Made"]


def noted(thing: Any, note: int) -> Any:
    """Give it an attribute."""
    thing.note = note
    return thing


def row(value: Any) -> Any:
    """A row of a table whose column holds any object."""
    return np.array([(value,)], [("column", object)])[0]


FIRST, SECOND = [1], [1]
MEMBERS = [
    "x = 1",
    "def f(self): return 1",
    "def f(self, x=1): return x",
    "def f(self, *, x=1): return x",
    "f = staticmethod(functools.partial(pow, 1))",
    *(f"@{kind}\n    def f(self): return 1" for kind in ("property", "staticmethod", "classmethod", "functools.cache")),
]
"""What a class may have that is changed in one place."""
INNER = [
    "def use():\n    def inner(): return rate\n    return inner()",
    "def use(): return [rate for _ in '12']",
    "def helper(): return rate\ndef use(): return helper() + 1",
]
"""Functions that reach a global only from inside."""


VALUES: list[tuple[Any, Any]] = [
    (1, 1.0), (0.0, -0.0), (1, True), ("1", 1), ([1, 2], (1, 2)), ({1, 2}, frozenset({1, 2})), ({1, 2}, {1, 3}),
    ([[1], 2], [[1, 2]]), ({"a": 1}, {"a": 2}), ([FIRST, SECOND, FIRST], [FIRST, SECOND, SECOND]),
    (np.float64(1), np.float64(2)), (np.int64(1), np.int32(1)), (np.zeros(3), np.zeros((3, 1))),
    (np.zeros(3), np.zeros(3, np.float32)), (Settings(0.1, None), Settings(0.2, None)), (Counter(1), Counter(2)),
    (np.ma.array([1, 2], mask=[False, True]), np.ma.array([1, 2], mask=[True, False])),
    (np.array([[1], "x"], object), np.array([[2], "x"], object)),
    (deque([1, 2]), deque([1, 3])), (defaultdict(int), defaultdict(float)), (row([1]), row([2])),
    (QLearning.create((2, 2)), QLearning.create((2, 2), learning_rate=0.2)),
    (np.random.default_rng(1), np.random.default_rng(2)),
    *((made("x = 1", base)(), made("x = 2", base)()) for base in (dict, float)),
    (noted(made("pass", dict)(), 1), noted(made("pass", dict)(), 2)),
    (noted(made("pass", list)(), 1), noted(made("pass", list)(), 2)),
]  # fmt: skip
CODE: list[tuple[Any, Any]] = [
    (make_adder(1), make_adder(2)),
    (best_values(0.1), best_values(0.2)),
    (lambda x: x + 1, lambda x: x + 2),
    (lambda x: math.sin(x), lambda x: math.cos(x)),
    (defined("def one(): pass", "one"), defined("def two(): pass", "two")),
    (property(make_adder), staticmethod(make_adder)),
    (functools.partial(int, base=2), functools.partial(int, base=3)),
    (noted(lambda f: f.note, 1), noted(lambda f: f.note, 2)),
    (made("x = 1"), made("y = 1")),
    (type("One", (), {}), type("Two", (), {})),
    (type("Slots", (), {"__slots__": ("a",)}), type("Slots", (), {"__slots__": ("b",)})),
    (made("def f(self): return 1")().f, made("def f(self): return 2")().f),
    (made("x = 1", made("y = 1")), made("x = 1", made("y = 2"))),
    *((made(body), made(body.replace("1", "2"))) for body in MEMBERS),
    *((defined(f"rate = 1\n{code}"), defined(f"rate = 2\n{code}")) for code in INNER),
]


@pytest.mark.parametrize(("one", "other"), VALUES + CODE)
def test_what_differs_has_another_one(one: Any, other: Any) -> None:
    """Values, types, shapes and code; a copy has the same one."""
    assert fingerprint(one) == fingerprint(one) == fingerprint(copy.deepcopy(one))
    assert fingerprint(one) != fingerprint(other)


def test_values_that_are_made_for_the_fingerprint() -> None:
    """Objects that tell what is in them by a new list each time: the place of one that is gone is another's again."""
    fresh = defined("class Fresh:\n    def __getstate__(self): return [[self.note]]", "Fresh")
    one, other = ([noted(fresh(), k) for k in order] for order in ((1, 2, 3), (1, 3, 2)))
    assert fingerprint(one) != fingerprint(other)


def test_what_is_the_same() -> None:
    """One number twice and two equal ones, equal closures; and what a function takes from a library is not visited."""
    number = np.float64(0.5)
    assert fingerprint([number, number]) == fingerprint([number, np.float64(0.5)])
    assert fingerprint(row([1])) == fingerprint(row([1]))
    assert fingerprint(best_values(0.1)) == fingerprint(best_values(0.1))
    use = defined("def use(): sys.stdout.flush()")
    assert fingerprint(use) == fingerprint(use)


@pytest.mark.parametrize(
    ("name", "other"),
    [("platform.machine", lambda: "another machine"), ("platform.python_version", lambda: "3.99"),
     ("version_of", lambda package: "99"), ("_own_code", lambda: "other code of this package")],
)  # fmt: skip
def test_what_the_numbers_depend_on_counts(name: str, other: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """The machine, versions, and all files of this package."""
    before = fingerprint(1)
    monkeypatch.setattr(f"edugym.experiments.fingerprints.{name}", other)
    assert fingerprint(1) != before


def test_every_file_of_the_package_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By its name and its contents, in folders too."""
    monkeypatch.setattr("edugym.experiments.fingerprints.own_folders", lambda: [tmp_path])
    (tmp_path / "inner").mkdir()
    seen = {_own_code.__wrapped__()}
    for name, contents in (("a.py", "1"), ("a.py", "2"), ("inner/b.py", ""), ("inner/c.py", "2")):
        (tmp_path / name).write_text(contents)
        seen.add(_own_code.__wrapped__())
    (tmp_path / "a.py").rename(tmp_path / "d.py")
    seen.add(_own_code.__wrapped__())
    assert len(seen) == 6
    (tmp_path / "table.csv").write_text("3")
    assert _own_code.__wrapped__() in seen


def test_a_module_of_ones_own_counts_where_it_is_used(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a function takes from it, and from a module inside it; the rest does not."""
    mine, inner = ModuleType("mine"), ModuleType("mine.inner")
    vars(mine).update(rate=1, other=1, inner=inner)
    vars(inner).update(deep=1, other=1)
    names: dict[str, Any] = {"__name__": "__main__", "mine": mine}
    exec("def use(): return mine.rate + mine.inner.deep", names)
    before = fingerprint(names["use"])
    for module in (mine, inner):
        monkeypatch.setattr(module, "other", 2)
    assert fingerprint(names["use"]) == before
    for module, name in ((mine, "rate"), (inner, "deep")):
        with monkeypatch.context() as changed:
            changed.setattr(module, name, 2)
            assert fingerprint(names["use"]) != before


@pytest.mark.parametrize(
    "line",
    ["import mine.part as p; return p.f()", "from mine.part import f; return f()",
     "from mine import part; return part.f()", "from .part import f; return f()", "import other; return other.f()",
     "import third; return third.f()", "import no_such_module, ring; return ring.back.f()"],
)  # fmt: skip
def test_a_folder_of_ones_own_counts(line: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also one without __init__.py, one that is imported in a call, and two that import each other."""
    monkeypatch.syspath_prepend(str(tmp_path))
    (tmp_path / "mine").mkdir()
    (tmp_path / "other.py").write_text("import sys, numpy, mine.part\nsys.exit()")  # it is read, and not run
    (tmp_path / "third.py").write_text("from mine.part import f")
    (tmp_path / "ring.py").write_text("import back")
    (tmp_path / "back.py").write_text("import ring\nfrom mine.part import f")
    names: dict[str, Any] = {"__name__": "__main__", "__package__": "mine"}
    exec(f"def use(): {line}", names)
    prints = set()
    for result in ("1", "22"):
        (tmp_path / "mine/part.py").write_text(f"def f(): return {result}")
        for name in ("mine", "mine.part"):
            monkeypatch.delitem(sys.modules, name, raising=False)
        prints |= {fingerprint(names["use"]), fingerprint(importlib.import_module("mine.part").f)}
    assert len(prints) == 4


def test_every_process_reads_a_folder_in_the_same_order(tmp_path: Path) -> None:
    """Whatever its hash seed, which orders sets, and the names that a file imports or a function uses."""
    names = [f"part_{letter}" for letter in "abcdef"]
    for name in names:
        (tmp_path / f"{name}.py").write_text(f"{name} = 1")
    (tmp_path / "mine.py").write_text("".join(f"import {name}\n" for name in names))
    (tmp_path / "kit.py").write_text("u, v, w, x, y, z = range(6)")
    code = (
        "import kit\nfrom edugym.experiments.fingerprints import fingerprint\na, b, c, d, e, f = range(6)\n"
        "def use():\n    import mine, part_c, part_b, part_a\n"
        "    return a + b + c + d + e + f in {'one', 'two', 'three'}\n"
        "def use_kit(): return kit.u + kit.v + kit.w + kit.x + kit.y + kit.z\n"
        "print(fingerprint(use), fingerprint(use_kit), fingerprint({'b', 'a', 'c'}), fingerprint(1))"
    )
    command, own = [sys.executable, "-c", code], [{**os.environ, "PYTHONHASHSEED": seed} for seed in "01"]
    assert len({subprocess.check_output(command, env=environment, cwd=tmp_path) for environment in own}) == 1


@pytest.mark.parametrize("module", ["__main__", "gone"])
def test_code_of_a_notebook_counts(module: str) -> None:
    """Its module is the program that runs it, or one that is no file."""
    prints = set()
    for body in ("1", "2"):
        names: dict[str, Any] = {"__name__": module}
        exec(f"def f(): return {body}\nclass C:\n    def g(self): return {body}", names)
        prints |= {fingerprint(names["f"]), fingerprint(names["C"])}
    assert len(prints) == 4
    assert fingerprint(type(sys.flags)) == fingerprint(type(sys.flags))  # a class of a module that is no file either


def test_a_library_that_a_function_imports_counts_by_its_version(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where the import is inside the function."""
    use = defined("def use(): import pandas")
    before, version = fingerprint(use), fingerprints.version_of
    monkeypatch.setattr(fingerprints, "version_of", lambda package: "99" if package == "pandas" else version(package))
    assert fingerprint(use) != before

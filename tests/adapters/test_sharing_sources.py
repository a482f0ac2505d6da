"""Where a shared MDP's code is found: in which cell, under which name, and in which module."""

import linecache
import math
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from edugym import read_mdp, share
from edugym.adapters.sharing import _home
from tests.adapters import test_sharing
from tests.adapters.test_sharing import run

cell = test_sharing.cell


def test_functions_that_call_each_other(tmp_path: Path, cell: dict[str, Any]) -> None:
    """Each is written once."""
    text = (
        "def even(n): return n == 0 or odd(n - 1)\ndef odd(n): return n != 0 and even(n - 1)\n\n"
        "class Parity(Walk):\n    __slots__ = ()\n"
        "    def reward(self, state, action, next_state, rng): return float(even(next_state.x))\n"
    )
    run(text, 4, cell)
    path = share(cell["Parity"](5, steps=np.array([1, 2])), tmp_path / "parity.py")
    assert path.read_text(encoding="utf-8").count("def odd") == 1
    assert read_mdp(path).reward(None, 0, cell["Place"](3), None) == 0.0


@pytest.mark.parametrize("more", ["", "    def terminal(self, state): return state.x == 0\n"])
def test_a_method_that_is_another_function(more: str, tmp_path: Path, cell: dict[str, Any]) -> None:
    """Where the class says so itself, the function is in the file too, and does not stand for where the class is."""
    text = "def paid(self, state, action, next_state, rng): return 7.0\n\n"
    run(f"{text}class Paying(Walk):\n    __slots__ = ()\n    reward = paid\n{more}", 4, cell)
    path = share(cell["Paying"](5, steps=np.array([1, 2])), tmp_path / "paying.py")
    assert read_mdp(path).reward(0, 0, 0, None) == 7.0


def test_where_classes_without_methods_are_looked_for(tmp_path: Path, cell: dict[str, Any]) -> None:
    """In cells of every kind of notebook, by their names; not in files, nor in what was not read yet."""
    mine = "class Place(NamedTuple):\n    x: int  # mine\n"
    file = "<ipython-input-8-ab>"
    linecache.cache[file] = (len(mine), None, mine.splitlines(keepends=True), file)
    exec(compile(mine, file, "exec"), cell)
    for other, text in (
        ("<ipython-input-9-ab>", "class Spot(NamedTuple):\n    x: int\n"),
        ("/somewhere/places.py", "class Place(NamedTuple):\n    x: int  # another program's\n"),
    ):
        linecache.cache[other] = (len(text), None, text.splitlines(keepends=True), other)
    linecache.cache["<not read yet>"] = (lambda: "",)
    text = share(cell["Walk"](5, steps=np.array([1, 2])), tmp_path / "mine.py").read_text(encoding="utf-8")
    assert mine in text
    assert "another program's" not in text


def test_a_parameter_with_the_name_of_a_variable(tmp_path: Path, cell: dict[str, Any]) -> None:
    """It has nothing to do with it."""
    cell["state"] = cell["by"] = object()
    assert share(cell["Slow"](5, steps=np.array([1, 2])), tmp_path / "slow.py").exists()


def test_what_no_friend_can_import(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the program itself has, and what is in a module that was made by hand."""
    program, made = ModuleType("__main__"), ModuleType("made")
    program.__spec__ = math.__spec__  # as python -m has it
    for module in (program, made):
        kind = type("Mine", (), {"__module__": module.__name__})
        vars(module)["Mine"] = kind
        monkeypatch.setitem(sys.modules, module.__name__, module)
        assert _home("Mine", kind) is None

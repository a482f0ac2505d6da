"""Walks through the package's own code are kept, and made again when anything in them has changed."""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numba import njit

from edugym.agents.strategies import EpsilonGreedy
from edugym.compiled import code
from edugym.compiled.code import Code, code_of
from tests.compiled.cells import cell
from tests.compiled.test_code import loop, notebook

OWN = """
import types
class Plain(NamedTuple):
    x: int
class Between(Plain):
    __slots__ = ()
    abs = 5
class Helped(Plain):
    __slots__ = ()
    LEVEL = 2
    def f(self, s, rng): return s + self.LEVEL + CONSTANT + helper(1.0) + abs(-1.0) + outer() + MODULE.K
CONSTANT, MODULE = 1.0, types.ModuleType("edugym.made")
MODULE.K = 1.0
def helper(x, more=0.0): return x + more
def around():
    k, m = 1.0, 2.0
    return lambda: k + m
outer = around()
def loop(n, thing, other, rng): return thing.f(0.0, rng)
"""
"""Values, and a loop over one whose method uses names of every kind, which seem to be the package's own."""


@pytest.fixture
def own(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """What that code has made, as in a new process."""
    monkeypatch.setattr(code, "_known", {})
    return cell(OWN, cell("") | {"__name__": "edugym.test"})


def walked(own: dict[str, Any]) -> Code:
    """The walk through the loop."""
    return code_of(own["loop"], (10, own["Helped"](1), own["Plain"](2)))


OWN_CHANGES: dict[str, Callable[[Any, dict[str, Any]], Any]] = {
    "method": lambda patch, own: patch.setattr(own["Helped"], "f", lambda self, s, rng: s),
    "code of a method": lambda patch, own: patch.setattr(own["Helped"].f, "__code__", (lambda a, b, c: b).__code__),
    "constant of a class": lambda patch, own: patch.setattr(own["Helped"], "LEVEL", 3),
    "member that was inherited": lambda patch, own: patch.setattr(own["Helped"], "abs", 3, raising=False),
    "fields": lambda patch, own: patch.setattr(own["Plain"], "_fields", ("y",)),
    "default of a keyword": lambda patch, own: patch.setattr(own["helper"], "__kwdefaults__", {"more": 4.0}),
    "global": lambda patch, own: patch.setitem(own, "CONSTANT", 2.0),
    "what a module has": lambda patch, own: patch.setattr(own["MODULE"], "K", 2.0),
    "helper": lambda patch, own: patch.setitem(own, "helper", lambda x: x + 5),
    "default of a helper": lambda patch, own: patch.setattr(own["helper"], "__defaults__", (4.0,)),
    "builtin that is hidden": lambda patch, own: patch.setitem(own, "abs", lambda x: x + 5),
    "variable around": lambda patch, own: patch.setattr(own["outer"].__closure__[0], "cell_contents", 7.0),
}


@pytest.mark.parametrize("change", OWN_CHANGES.values(), ids=OWN_CHANGES)
def test_a_kept_walk_is_never_stale(change: Any, own: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """A walk through the package's own code is kept until anything that it met is another: then there is a new one."""
    known = walked(own)
    assert known.is_watchable
    assert walked(own) is known
    with monkeypatch.context() as patch:
        change(patch, own)
        changed = walked(own)
        anew = Code(own["loop"], (10, own["Helped"](1), own["Plain"](2)))
        assert changed is not known
        assert changed.fingerprint == anew.fingerprint != known.fingerprint
    assert walked(own).fingerprint == known.fingerprint


def test_other_bases(own: dict[str, Any]) -> None:
    """A walk is made again when a class has other bases, though each class has what it had."""
    known = walked(own)
    own["Helped"].__bases__ = (own["Between"],)
    assert walked(own).fingerprint != known.fingerprint


def test_what_changes_in_place_is_walked_through_each_time(own: dict[str, Any]) -> None:
    """No walk is kept through students' code, nor where an array is reached by a name."""
    assert walked(own).is_watchable
    own["CONSTANT"] = table = np.zeros(3)
    before = walked(own)
    table[1] = 1.0
    assert walked(own).fingerprint != before.fingerprint
    own["CONSTANT"] = njit(own["outer"])  # whose own code seems to be the package's
    assert not walked(own).is_watchable
    own["CONSTANT"] = 1.0
    assert walked(own).is_watchable
    own["helper"].__kwdefaults__ = {"more": 4.0}
    assert not walked(own).is_watchable
    values = 10, cell(notebook("", "return s + 1"))["T"](1), own["Plain"](2)
    assert code_of(own["loop"], values) is not code_of(own["loop"], values)


def test_which_classes_another_process_finds(monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that a module has under their names; in another program `__main__` is another module."""
    local, mine = (cell(f"class {name}(NamedTuple):\n    x: int")[name] for name in ("Local", "Mine"))
    local.__module__ = __name__
    monkeypatch.setattr(sys.modules["__main__"], "Mine", mine, raising=False)
    found = [Code(loop, (10, kind(1))).importable for kind in (EpsilonGreedy, local, mine)]
    assert found == [True, False, False]

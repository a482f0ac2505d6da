"""Walks through the package's own code are kept, and made again when anything in them has changed."""

import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
import pytest
from numba import njit

from edugym.compiled import code
from edugym.compiled.code import Code, code_of
from tests.compiled.cells import cell
from tests.compiled.test_code import loop, notebook


class Plain(NamedTuple):
    """A value without methods."""

    x: int


class Between(Plain):
    """What may come between the classes above and below."""

    __slots__ = ()
    abs = 5


class Helped(Plain):
    """A value of the package's own, as far as its module says, whose method uses names of every kind."""

    __slots__ = ()
    LEVEL = 2

    def f(self, s: float, rng: object) -> Any:
        """Use a member, a global, a helper and a function of Python's own."""
        return s + self.LEVEL + CONSTANT + helper(1.0) + abs(-1.0) + outer() + MODULE.K


CONSTANT: Any = 1.0
MODULE: Any = ModuleType("edugym.made")
MODULE.K = 1.0


def helper(x: float, more: float = 0.0) -> float:
    """A helper with a default."""
    return x + more


def _closure() -> Any:
    k, m = 1.0, 2.0
    return lambda: k + m


outer = _closure()


@pytest.fixture
def own(monkeypatch: pytest.MonkeyPatch) -> Any:
    """The value and a loop over it, which seem to be the package's own."""
    for thing in (Plain, Helped, Helped.f, helper, outer, loop):
        monkeypatch.setattr(thing, "__module__", "edugym.test")
    monkeypatch.setattr(code, "_known", {})
    return Helped(1)


OWN_CHANGES: dict[str, Callable[[pytest.MonkeyPatch], Any]] = {
    "method": lambda patch: patch.setattr(Helped, "f", lambda self, s, rng: s),
    "code of a method": lambda patch: patch.setattr(Helped.f, "__code__", (lambda self, s, rng: s + 3).__code__),
    "constant of a class": lambda patch: patch.setattr(Helped, "LEVEL", 3),
    "member that was inherited": lambda patch: patch.setattr(Helped, "abs", 3, raising=False),
    "fields": lambda patch: patch.setattr(Plain, "_fields", ("y",)),
    "default of a keyword": lambda patch: patch.setattr(helper, "__kwdefaults__", {"more": 4.0}),
    "global": lambda patch: patch.setitem(globals(), "CONSTANT", 2.0),
    "what a module has": lambda patch: patch.setattr(MODULE, "K", 2.0),
    "helper": lambda patch: patch.setitem(globals(), "helper", lambda x: x + 5),
    "default of a helper": lambda patch: patch.setattr(helper, "__defaults__", (4.0,)),
    "builtin that is hidden": lambda patch: patch.setitem(globals(), "abs", lambda x: x + 5),
    "variable of a function around it": lambda patch: patch.setattr(outer.__closure__[0], "cell_contents", 7.0),
}


@pytest.mark.parametrize("change", OWN_CHANGES.values(), ids=OWN_CHANGES)
def test_a_kept_walk_is_never_stale(change: Any, own: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A walk through the package's own code is kept until anything that it met is another: then there is a new one."""
    values = (10, own, Plain(2))
    known = code_of(loop, values)
    assert known.is_watchable
    assert code_of(loop, values) is known
    with monkeypatch.context() as patch:
        change(patch)
        changed = code_of(loop, values)
        assert changed is not known
        assert changed.fingerprint == Code(loop, values).fingerprint != known.fingerprint
    assert code_of(loop, values).fingerprint == known.fingerprint


def test_other_bases(own: Any) -> None:
    """A walk is made again when a class has other bases, though each class has what it had."""
    known = code_of(loop, (10, own))
    Helped.__bases__ = (Between,)
    try:
        changed = code_of(loop, (10, own))
    finally:
        Helped.__bases__ = (Plain,)
    assert changed.fingerprint != known.fingerprint


def test_what_changes_in_place_is_walked_through_each_time(own: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """No walk is kept through students' code, nor where an array is reached by a name."""
    values = (10, own)
    table = np.zeros(3)
    monkeypatch.setitem(globals(), "CONSTANT", table)
    before = code_of(loop, values)
    table[1] = 1.0
    assert code_of(loop, values).fingerprint != before.fingerprint
    monkeypatch.setitem(globals(), "CONSTANT", njit(outer))  # whose own code seems to be the package's
    assert not code_of(loop, values).is_watchable
    monkeypatch.setitem(globals(), "CONSTANT", 1.0)
    assert code_of(loop, values).is_watchable
    monkeypatch.setattr(helper, "__kwdefaults__", {"more": 4.0})
    assert not code_of(loop, values).is_watchable
    students = cell(notebook("", "return s + 1"))["T"](1)
    assert code_of(loop, (10, students)) is not code_of(loop, (10, students))


def test_which_classes_another_process_finds(monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that a module has under their names; in another program `__main__` is another module."""

    class Local(NamedTuple):
        """A class that no module has."""

        x: int

    mine = cell("class Mine(NamedTuple):\n    x: int")["Mine"]
    monkeypatch.setattr(sys.modules["__main__"], "Mine", mine, raising=False)
    found = [Code(loop, (10, kind(1))).importable for kind in (Plain, Local, mine)]
    assert found == [True, False, False]

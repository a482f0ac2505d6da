"""A build without reference counts is taken only where none are needed."""

from typing import Any

import numpy as np
import pytest

from edugym.compiled import compiler
from edugym.compiled.compiler import CompilationError, compiled
from tests.compiled.cells import cell
from tests.compiled.test_compiler import plain_loop

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

"""Random generators taken by their address draw what they draw elsewhere, and are kept by nobody."""

import copy
import pickle
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from edugym.compiled import compiler, random_generators
from edugym.compiled.compiler import compiled
from edugym.mdp.protocol import Random
from tests.compiled.cells import cell

KINDS = [np.random.PCG64, np.random.PCG64DXSM, np.random.MT19937, np.random.Philox, np.random.SFC64]


def test_type_is_found_by_its_name() -> None:
    """The disk cache knows builds by their pickled types: one that is not found by its name makes every build new."""
    kind = random_generators.LocatedGeneratorType
    assert pickle.loads(pickle.dumps(kind)) is kind


def draw(n: int, rng: Random, out: Any) -> None:
    """One number of each kind."""
    for i in range(n):
        out[i, 0] = rng.random()
        out[i, 1] = rng.normal(1.0, 2.0)
        out[i, 2] = rng.integers(0, 10)
        out[i, 3] = rng.uniform(-1.0, 1.0)
        out[i, 4] = rng.exponential(3.0)


def drawn(loop: Any, rng: Random, n: int = 20) -> list[Any]:
    """What a loop draws, and the state in which it leaves the generator."""
    out = np.zeros((n, 5))
    loop(n, rng, out)
    return [out.tolist(), str(rng.bit_generator.state)]


@pytest.mark.parametrize("kind", KINDS)
def test_same_numbers(kind: Any) -> None:
    """Machine code and NumPy take turns on one stream: every bit is as if NumPy had drawn it all."""
    mixed, alone = np.random.Generator(kind(3)), np.random.Generator(kind(3))
    fast = compiled(draw, 1, mixed, np.zeros((1, 5)))
    for loop in (fast, draw, fast, fast, draw):
        assert drawn(loop, mixed) == drawn(draw, alone)
    mixed.bit_generator.state = alone.bit_generator.state = np.random.Generator(kind(8)).bit_generator.state
    assert drawn(fast, mixed) == drawn(draw, alone)


NOTEBOOK = cell("""
class Draws(NamedTuple):
    endpoint: bool
    def one(self, rng, low, high): return rng.integers(low, high, endpoint=self.endpoint)

class Choices(NamedTuple):
    values: np.ndarray
    p: np.ndarray
    def one(self, rng, low, high):
        return rng.choice(self.values, p=self.p) + 10 * rng.choice(len(self.p), p=self.p) + 100 * rng.choice(high)
""")
Draws, Choices = NOTEBOOK["Draws"], NOTEBOOK["Choices"]


def draw_whole(n: int, draws: Any, rng: Random, low: int, high: int, out: Any) -> None:
    """Whole numbers of a range."""
    for i in range(n):
        out[i] = draws.one(rng, low, high)


SPANS = st.sampled_from([0, 2**31, 2**32, 2**63]).flatmap(lambda n: st.integers(n, n + 3) | st.integers(n - 3, n))


@given(low=st.integers(-(2**63), 2**63 - 1), span=SPANS | st.integers(0, 2**64 - 1), seed=st.integers(0, 99))
@example(low=0, span=2**32 - 1, seed=0)
@example(low=-(2**63), span=2**64 - 1, seed=0)
def test_whole_numbers(low: int, span: int, seed: int) -> None:
    """Of every range: those that NumPy draws, and no number more is taken from the stream."""
    high = min(low + abs(span), 2**63 - 1)
    for draws in [Draws(True), Draws(False)][: 2 if high > low else 1]:
        results = []
        for loop in (draw_whole, compiled(draw_whole, 1, draws, np.random.default_rng(), 0, 1, np.zeros(1, np.int64))):
            rng, out = np.random.default_rng(seed), np.zeros(20, np.int64)
            loop(20, draws, rng, low, high, out)
            results.append([out.tolist(), str(rng.bit_generator.state)])
        assert results[0] == results[1]


@given(st.lists(st.floats(0.0, 1.0) | st.floats(1e-12, 1e-9), min_size=1, max_size=40), st.integers(0, 99))
@example([0.0, 0.0, 1.0, 0.0], 0)
@example([1.0] * 3 + [0.0] * 9, 0)
def test_choices(weights: list[float], seed: int) -> None:
    """With probabilities: those that NumPy makes, to the last number of the stream, or its error."""
    p = np.array(weights) / max(sum(weights), 1e-300)
    choices, results = Choices(np.arange(len(p)) + 0.5, p), []
    for loop in (draw_whole, compiled(draw_whole, 1, choices, np.random.default_rng(), 0, 1, np.zeros(1))):
        rng, out = np.random.default_rng(seed), np.zeros(20)
        try:
            loop(20, choices, rng, 0, 2**33, out)
        except ValueError:
            assert np.sum(p) == 0
        results.append([out.tolist(), str(rng.bit_generator.state)])
    assert results[0] == results[1]


def test_many_generators() -> None:
    """Each has its own address, also when more are in use than are remembered, and when old ones are gone.

    A generator is referred to once, by those that are remembered, however often it is passed; and no array is.
    """
    fast = compiled(draw, 1, np.random.default_rng(), np.zeros((1, 5)))
    for _ in range(3):
        streams = [np.random.default_rng(seed) for seed in range(150)]
        copies = copy.deepcopy(streams)
        for _ in range(2):
            assert [drawn(fast, rng, 2) for rng in streams] == [drawn(draw, rng, 2) for rng in copies]
    rng, out = streams[-1], np.zeros((1, 5))
    before = sys.getrefcount(rng), sys.getrefcount(out)
    for _ in range(1_000):
        fast(1, rng, out)
    assert (sys.getrefcount(rng), sys.getrefcount(out)) == before


def test_fall_back(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Where this file cannot be used generators are passed as they are, to the same effect."""
    expected = drawn(draw, np.random.default_rng(4))
    assert isinstance(compiler._locator()(np.random.default_rng(4)), random_generators.LocatedGenerator)
    monkeypatch.setenv("EDUGYM_CACHE_DIR", str(tmp_path))
    monkeypatch.setitem(sys.modules, "edugym.compiled.random_generators", None)
    compiler._locator.cache_clear()
    try:
        rng = np.random.default_rng(4)
        assert compiler._locator()(rng) is rng
        assert drawn(compiled(draw, 1, rng, np.zeros((1, 5))), rng) == expected
    finally:
        compiler._locator.cache_clear()


def test_unexpected_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    """If Numba made generators of other parts than these, importing the file would fail, and say so."""
    monkeypatch.setattr(random_generators, "WORDS", ("state_address", "state"))
    with pytest.raises(ImportError, match="random generators of other parts"):
        random_generators._teach_numba()

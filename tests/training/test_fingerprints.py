"""Fingerprints: the same in every process, and others for other values or code."""

import functools
import math
import subprocess
import sys
import threading
from typing import Any, NamedTuple

import numpy as np
import pytest

from edugym import QLearning
from edugym.exact.value_iteration import best_values
from edugym.training.fingerprints import fingerprint

CODE = """
import functools
from typing import NamedTuple
import numpy as np
from edugym import EpsilonGreedy, QLearning
from edugym.training.fingerprints import fingerprint

class Plain:
    names = {"b", "a", "c"}
    def __init__(self):
        self.memory = {"x": [1, 2.5], "y": {3, 4}}
        self.rng = np.random.default_rng(3)
        self.me = self
    def act(self, state, rng):
        return [k for k in range(3) if k in {"p", "q"}]

make = functools.partial(QLearning.create, exploration=EpsilonGreedy(0.2))
print(fingerprint(Plain(), make, lambda task: Plain().act(np.pi, len)))
"""


def test_every_process_agrees() -> None:
    """Whatever its hash seed."""
    said = {
        subprocess.run([sys.executable, "-c", CODE], env=None, capture_output=True, text=True, check=True).stdout
        for _ in range(2)
    }
    assert len(said) == 1


class Settings(NamedTuple):
    """Values."""

    rate: float
    table: Any


FACTOR = 2


def helper(x: float) -> float:
    """Something that a function may call."""
    return x * FACTOR


def with_helper(x: float) -> float:
    """Call it."""
    return helper(x) + 1


class Counter:
    """An ordinary object."""

    def __init__(self, start: int) -> None:
        """From a number on."""
        self.count = start


def make_adder(n: int) -> Any:
    """A closure."""
    return lambda x: x + n


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, 1.0),
        (0.0, -0.0),
        (1, True),
        ("1", 1),
        ([1, 2], (1, 2)),
        ({1, 2}, frozenset({1, 2})),
        (property(helper), staticmethod(helper)),
        ([[1], 2], [[1, 2]]),
        ({"a": 1}, {"a": 2}),
        (np.zeros(3), np.zeros((3, 1))),
        (np.zeros(3), np.zeros(3, np.float32)),
        (Settings(0.1, None), Settings(0.2, None)),
        (Counter(1), Counter(2)),
        (make_adder(1), make_adder(2)),
        (lambda x: x + 1, lambda x: x + 2),
        (lambda x: math.sin(x), lambda x: math.cos(x)),
        (functools.partial(helper, x=1), functools.partial(helper, x=2)),
        (QLearning.create((2, 2)), QLearning.create((2, 2), learning_rate=0.2)),
        (np.random.default_rng(1), np.random.default_rng(2)),
    ],
)
def test_what_differs_has_another_one(one: Any, other: Any) -> None:
    """Values, types, shapes and code."""
    assert fingerprint(one) == fingerprint(one)
    assert fingerprint(one) != fingerprint(other)


def test_code_counts_with_what_it_reaches(monkeypatch: pytest.MonkeyPatch) -> None:
    """A global of a helper of a function."""
    before = fingerprint(with_helper)
    monkeypatch.setattr(sys.modules[__name__], "FACTOR", 3)
    assert fingerprint(with_helper) != before


def test_what_a_function_of_the_package_holds_counts() -> None:
    """Functions that one factory makes differ by what they were made with."""
    assert fingerprint(best_values(0.1)) == fingerprint(best_values(0.1))
    assert fingerprint(best_values(0.1)) != fingerprint(best_values(0.2))


def test_a_method_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of an ordinary class, also its `__init__`."""
    before = fingerprint(Counter(1))
    monkeypatch.setattr(Counter, "__init__", lambda self, start: None)
    assert fingerprint(Counter) != before


def test_what_cannot_be_taken_apart_is_an_error() -> None:
    """There is no fingerprint of a lock."""
    with pytest.raises(TypeError):
        fingerprint([threading.Lock()])

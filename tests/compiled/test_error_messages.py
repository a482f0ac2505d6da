"""What keeps code from being compiled is said in words that its author understands, with the line."""

import re

import numpy as np
import pytest

from edugym import QLearning, train
from edugym.compiled import compiler
from edugym.compiled.code import code_of
from edugym.compiled.compiler import compiled
from edugym.compiled.error_messages import reason
from edugym.compiled.execution import COMPILE_FROM
from edugym.compiled.numba_setup import CompilationError
from tests.compiled.cells import WALK, cell
from tests.compiled.test_compiler import plain_loop


@pytest.fixture
def built_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do not try first to build without reference counts, which would fail as well."""
    monkeypatch.setattr(compiler, "_needs_no_counts", lambda kind: False)


ONE_DRAW = "rng.choice is compiled only for one draw, as rng.choice(n) or rng.choice(values)"
ONE_BY_ONE = "draws an array of numbers: draw them one by one"
METHODS = [
    ("return self.missing", "missing"),
    ("return s + self.k.strip()", "it uses strip of a value of type int"),
    ("return s + rng.choice(3, 2)[0]", ONE_DRAW),
    ("return s + rng.choice(4, p=np.ones((2, 2)) / 4)", ONE_DRAW),
    ("return s + rng.permuted(np.ones(3))[0]", "it uses rng's permuted"),
    ("return range(3)[int(s)]", "Numba has no getitem(range, int)"),
    ("a = None\n        if s > 3: a = 0\n        return 1 if a else 2", "Numba has no bool(int or None)"),
    ("return s + 1 if s < 3 else (1, 2)", "values of two types, "),
    ("a, *b = (s, 1, 2)\n        return a", "it takes something apart with *"),
    ("return s + A.f(self, s, rng)", "it calls f of the class A: write it as a function outside of the class"),
    ("return s + len({1, int(s)})", "it makes a set"),
    ("return s + A.T", "it takes T from the class A: take it from a value, as in self.T"),
    ("t = (1.5, s > 3)\n        for i in range(2): s += t[i]\n        return s", "can be indexed only by a constant"),
    ("return s + rng.normal(np.zeros(2), np.ones(2))[0]", f"rng.normal {ONE_BY_ONE}"),
    ("return s + rng.integers(np.array([3, 4]))[0]", f"rng.integers {ONE_BY_ONE}"),
    ("return s + rng.integers(2.5)", "rng.integers takes whole numbers, but was given something else"),
    ("return s + np.zeros(3)[0.5]", "an index of an array is of type float"),
    ("return s + rng.integers(3, dtype=np.int8)", "rng.integers draws numbers of another type than int"),
    ("return s + np.argmax([s, 1.0])", "it gives a list to a function that takes arrays"),
    ("return s + int('123'[int(s) % 3])", "it makes a number of text"),
    ("return s + np.max([s, 1.0])", "Numba has no np.max(list)"),
    ("a = np.zeros(2)\n        a[:] = s, True\n        return a[0]", "it puts values of several types in an array"),
    ("for x in (1, 2.5): s += x\n        return s", "it loops over values of several types, tuple"),
    ("return s + Colour.RED", "it computes with Colour as if it were float: write .value"),
    ("return s + Colour(int(s))", "Numba cannot call Colour with int"),
    ("return self._replace(k=2).k", "it uses _replace of a value of type A: make a new one of all fields"),
]


@pytest.mark.parametrize(("method", "words"), METHODS)
def test_reasons(method: str, words: str, built_once: None) -> None:
    """What cannot be compiled is named in one line, with the student's line where it is known."""
    colours = "class Colour(enum.IntEnum):\n    RED = 0\n"
    thing = cell(f"{colours}class A(NamedTuple):\n    k: int\n    def f(self, s, rng):\n        {method}")["A"](1)
    with pytest.raises(CompilationError, match=f"{re.escape(words)}.*, line ") as caught:
        compiled(plain_loop, 1, thing, np.random.default_rng(0))
    assert "\n" not in str(caught.value)


def test_the_innermost_line(built_once: None) -> None:
    """Of a method that calls one that calls one the line is named at which something cannot be compiled."""
    lines = "def f(self, s, rng): return self.g(s)", "def g(self, s): return self.h(s)", "def h(self, s): return len(s)"
    thing = cell("class A(NamedTuple):\n    k: int\n    " + "\n    ".join(lines))["A"](1)
    with pytest.raises(CompilationError, match=r"Numba has no len\(float\) \(.*, line 5\)"):
        compiled(plain_loop, 1, thing, np.random.default_rng(0))


def test_a_value_that_numba_does_not_know() -> None:
    """It is said what it is: here numbers in another order of bytes."""
    with pytest.raises(CompilationError, match="array dtype: >f8"):
        compiled(plain_loop, 1, np.zeros(2, ">f8"), np.random.default_rng(0))


ARRAYS = {
    "return 0\n": "return (0,)\n",
    "return max(0, state + 2 * action - 1)": "return np.array([max(0, state[0] + 2 * action - 1)])",
    "return state\n": "return int(state[0])\n",
    "state ==": "state[0] ==",
}
STARTED = "return {}.start()\n\n    @{}\n    def start({}): return 0\n"
STUDENTS: list[tuple[dict[str, str], str]] = [
    (  # what shows in the package's own code, or only when machine code runs, has no line
        {"return 1.0 if": "return np.where(next_state == self.size, 1.0, -0.25)\n        1.0 if"},
        "the reward is an array,",
    ),
    (
        {"return max(": "x = (state + 1) * 6364136223846793005\n        return max("},
        "it computes a whole number of more",
    ),
    (ARRAYS, "the state should always be of the same type, but is of two, (tuple and array|array and tuple)$"),
    (
        {"return 0\n": STARTED.format("self", "classmethod", "cls")},
        r"start of Walk is a class method: make it a method, with self \(<cell \d+>, line 6\)$",
    ),
    (
        {"return 0\n": STARTED.format("Walk", "staticmethod", "")},
        r"start of Walk is a static method: make it a method, with self \(<cell \d+>, line 6\)$",
    ),
]


@pytest.mark.parametrize(
    ("changes", "because"),
    [pytest.param(*case, marks=[pytest.mark.slow] * (k in (1, 2, 4))) for k, case in enumerate(STUDENTS)],
)
def test_reasons_in_training(changes: dict[str, str], because: str, compiled_at_once: None) -> None:
    """Mistakes in a task are named in the words of its author, though they are met in the package's loop."""
    source = WALK
    for old, new in changes.items():
        source = source.replace(old, new)
    with pytest.warns(UserWarning, match=f"Walk cannot be compiled .*slower: {because}"):
        train(cell(source)["Walk"](5), QLearning.create((6, 2)), COMPILE_FROM, max_steps=9)


class NumbaError(Exception):
    """As Numba's own."""

    __module__ = "numba.core.errors"


OTHER_ARGUMENTS = "a call has other arguments than Numba takes"
MESSAGES = {
    "Unknown attribute 'k' of type array(float64, 2d, C)": "it uses k of a value of type array",
    "TypingError: Cannot unify Literal[int](3) and OptionalType(float64) for 'x.2', defined at a (3)": (
        "one name stands for values of two types, int and float or None"
    ),
    "Unsupported array index type unicode_type in [unicode_type]": "an index of an array is of type str",
    "Argument rng is not one of the expected type(s)": "a call is given something of a type that Numba does not take",
    "Cannot bind to (a, b)": OTHER_ARGUMENTS,
    "missing a required argument: 'b'": OTHER_ARGUMENTS,
    "got an unexpected keyword argument 'b'": OTHER_ARGUMENTS,
    "Type of variable 'x' cannot be determined, operation: y": (
        "Numba cannot tell the type of a value (as after := and case)"
    ),
    "No implementation of function\n >>> sorted(UniTuple(float64 x 2), Function(<class 'bool'>))": (
        "Numba has no sorted(tuple, bool)"
    ),
    ">>> f(IntEnum class<int64>(Colour), Pair(int x 2), Mixed(int, float))": "Numba has no f(Colour, Pair, Mixed)",
    "Invalid use of getiter with parameters (int64)": "it loops over a single number",
    "Invalid use of getiter with parameters (Tuple())": "it loops over an empty tuple",
    "Invalid use of float64 with parameters (int64)": "it calls a number as if it were a function",
    "Invalid use of NumPyRandomGeneratorType with parameters ()": "it calls rng as if it were a function",
    "Invalid use of BoundFunction(array.item for array(float64, 1d, C)) with parameters (int64)": (
        "it uses an array's item like this"
    ),
    "Use of unsupported opcode (MATCH_SEQUENCE) found": "it has a match that takes something apart",
    "compiler re-entrant to the same function signature": "it calls itself",
    "Unknown attribute 'at' of type Function(<ufunc 'add'>)": "it uses at of a value of type np.add",
    "Unknown attribute 'q' of type T(array(float64, 2d, C), int64)": "it uses q of a value of type T",
    ">>> f(list(list(float64)<iv=None>)<iv=None>, Function(<built-in function abs>))": "Numba has no f(list, abs)",
    "Cannot unify array(int64, 1d, C) and array(float64, 1d, A) for 'y.2', defined at a (3)": (
        "one name stands for arrays of two types, or of other numbers of dimensions"
    ),
    "Cannot unify Tuple(int64) and UniTuple(int64 x 2) for 'y.2', defined at a (3)": (
        "one name stands for values of two types of tuples, as those of other lengths are"
    ),
    "Int value is too large: 9": "it has a whole number of more than 64 bits",
    "Illegal IR, del found at: del x": "it deletes a variable",
    "Failed in nopython mode\n- of which:\nSomething else": "Something else",
    'Failed in nopython mode\nFile "a.py", line 3:\n>>> sorted(int64)': "Numba does not say why",
    "\x1b[1m\x1b[31mIllegal IR, del found\x1b[0m": "it deletes a variable",
    "First.\nDuring: typing of\n>>> sorted(int64)": "First.",
    200 * "x": 150 * "x",
}


@pytest.mark.parametrize(("message", "said"), MESSAGES.items())
def test_what_numba_says_in_other_words(message: str, said: str) -> None:
    """Of each kind of message the words for it, with types as Python writes them; of another error its kind."""
    code = code_of(plain_loop, ())
    assert reason(NumbaError(message), code) == said
    assert reason(KeyError(message), code) == "Numba cannot compile it (KeyError)"

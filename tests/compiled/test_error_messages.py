"""What keeps code from being compiled is said in words that its author understands, with the line."""

import re

import numpy as np
import pytest

from edugym import QLearning, train
from edugym.compiled import compiler
from edugym.compiled.code import code_of
from edugym.compiled.compiler import CompilationError, compiled
from edugym.compiled.error_messages import reason
from edugym.compiled.execution import COMPILE_FROM
from tests.compiled.cells import WALK, cell
from tests.compiled.test_compiler import plain_loop


@pytest.fixture
def built_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do not try first to build without reference counts, which would fail as well."""
    monkeypatch.setattr(compiler, "_needs_no_counts", lambda kind: False)


ONE_DRAW = "rng.choice is compiled only for one draw, as rng.choice(n) or rng.choice(values)"
ONE_BY_ONE = "draws an array of numbers: draw them one by one"
METHODS = [
    ("return {1: s}[1] + open('x')", "open"),
    ("return self.missing", "missing"),
    ("return s + self.k.strip()", "it uses strip of a value of type int"),
    ("return s + rng.choice(3, 2)[0]", ONE_DRAW),
    ("return s + rng.choice(4, p=np.ones((2, 2)) / 4)", ONE_DRAW),
    ("return s + rng.choice((1, 2.5))", ONE_DRAW),
    ("return s + rng.choice([(0, 1), (2, 3)])[0]", ONE_DRAW),
    ("return s + rng.permuted(np.ones(3))[0]", "it uses rng's permuted"),
    ("return range(3)[int(s)]", "Numba has no getitem(range, int)"),
    ("a = None\n        if s > 3: a = 0\n        return 1 if a else 2", "Numba has no bool(int or None)"),
    ("return s + 1 if s < 3 else (1, 2)", "one name stands for values of two types, float and tuple"),
    ("a, *b = (s, 1, 2)\n        return a", "it has a statement that Numba does not know, UNPACK_EX"),
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
    (
        "a = np.zeros(2)\n        a[:] = s, True\n        return a[0]",
        "it puts values of several types in an array",
    ),
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


@pytest.mark.parametrize(
    ("old", "new", "because"),
    [
        (
            "return 1.0 if",
            "return np.where(next_state == self.size, 1.0, -0.25)\n        1.0 if",
            "the reward is an array,",
        ),
        (
            "return max(",
            "x = (state + 1) * 6364136223846793005\n        return max(",
            "it computes a whole number of more",
        ),
    ],
)
def test_reasons_that_have_no_line(old: str, new: str, because: str, compiled_at_once: None) -> None:
    """What shows in the package's own code, or only when machine code runs."""
    task = cell(WALK.replace(old, new))["Walk"](5)
    with pytest.warns(UserWarning, match=f"Walk cannot be compiled .*: {because}"):
        train(task, QLearning.create((6, 2)), COMPILE_FROM, max_steps=9)


def test_a_state_of_two_types(compiled_at_once: None, built_once: None) -> None:
    """The loop's own name of it is known to students."""
    walk = WALK.replace("return 0\n", "return (0,)\n").replace(
        "return max(0, state", "return np.array([max(0, state[0]"
    )
    walk = walk.replace("action - 1)", "action - 1)])").replace("return state\n", "return int(state[0])\n")
    says = "slower: the state should always be of the same type, but is of two, (tuple and array|array and tuple)$"
    with pytest.warns(UserWarning, match=says):
        train(
            cell(walk.replace("state ==", "state[0] =="))["Walk"](5),
            QLearning.create((6, 2)),
            COMPILE_FROM,
            max_steps=5,
        )


@pytest.mark.parametrize(("decorator", "owner"), [("classmethod", "self"), ("staticmethod", "Walk")])
def test_other_methods(decorator: str, owner: str, compiled_at_once: None, built_once: None) -> None:
    """Only ordinary ones are compiled; the sentence names the method and its kind."""
    start = f"return {owner}.start()\n\n    @{decorator}\n    def start({'cls' if decorator == 'classmethod' else ''}):"
    task = cell(WALK.replace("return 0\n", f"{start}\n        return 0\n"))["Walk"](5)
    kind = {"classmethod": "class", "staticmethod": "static"}[decorator]
    says = rf"start of Walk is a {kind} method: make it a method, with self \(<cell \d+>, line 6\)$"
    with pytest.warns(UserWarning, match=says):
        train(task, QLearning.create((6, 2)), COMPILE_FROM, max_steps=9)


class NumbaError(Exception):
    """As Numba's own."""

    __module__ = "numba.core.errors"


NOTHING = code_of(plain_loop, ())


@pytest.mark.parametrize(
    ("message", "said"),
    [
        (
            "Unknown attribute 'gamma' of type NumPyRandomGeneratorType(x)",
            "it uses rng's gamma",
        ),
        (
            "Unknown attribute 'T' of type class(<class '__main__.A'>)",
            "it takes T from the class A: take it from a value, as in self.T",
        ),
        ("Unknown attribute 'k' of type array(float64, 2d, C)", "it uses k of a value of type array"),
        (
            "TypingError: Cannot unify Literal[int](3) and OptionalType(float64) for 'x.2', defined at a (3)",
            "one name stands for values of two types, int and float or None",
        ),
        ("Unsupported array index type unicode_type in [unicode_type]", "an index of an array is of type str"),
        ("Argument rng is not one of the expected type(s)", "rng is of a type that Numba does not take"),
        ("Cannot bind to (a, b)", "a call has other arguments than Numba takes"),
        ("missing a required argument: 'b'", "a call has other arguments than Numba takes"),
        ("got an unexpected keyword argument 'b'", "a call has other arguments than Numba takes"),
        (
            "Type of variable 'x' cannot be determined, operation: y",
            "Numba cannot tell the type of a value (as after := and case)",
        ),
        ("Use of unsupported opcode (UNPACK_EX) found", "it has a statement that Numba does not know, UNPACK_EX"),
        (
            "No implementation of function\n >>> sorted(UniTuple(float64 x 2), Function(<class 'bool'>))",
            "Numba has no sorted(tuple, bool)",
        ),
        (
            ">>> f(IntEnum class<int64>(Colour), Pair(int x 2), Mixed(int, float))",
            "Numba has no f(Colour, Pair, Mixed)",
        ),
        (
            ">>> _impl(array(float32, 2d, C), array(float64, 2d, C))",
            "it multiplies matrices of whole numbers, or of two types: make both arrays of real numbers",
        ),
        ("Int value is too large: 9", "it has a whole number of more than 64 bits"),
        ("Illegal IR, del found at: del x", "it deletes a variable"),
        ("Failed in nopython mode\n- of which:\nSomething else", "Something else"),
        ('Failed in nopython mode\nFile "a.py", line 3:\n>>> sorted(int64)', "Numba does not say why"),
        ("\x1b[1m\x1b[31mIllegal IR, del found\x1b[0m", "it deletes a variable"),
        ("First.\nDuring: typing of\n>>> sorted(int64)", "First."),
        (200 * "x", 150 * "x"),
        ("Unknown attribute 'k' of type " + 200 * "x", "it uses k of a value of type " + 121 * "x"),
    ],
)
def test_what_numba_says_in_other_words(message: str, said: str) -> None:
    """Of each kind of message the words for it, with types as Python writes them."""
    assert reason(NumbaError(message), NOTHING) == said


def test_what_numba_is_not_prepared_for() -> None:
    """An error of another kind is named, and no more."""
    assert reason(KeyError("x"), NOTHING) == "Numba cannot compile it (KeyError)"

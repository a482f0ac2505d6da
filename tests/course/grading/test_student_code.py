"""Errors in an answer: a sentence that ends at the student's own line."""

import linecache
import math
import random
import warnings
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest

from edugym import QLearning
from edugym_course.grading import Unsolved, WrongAnswer
from edugym_course.grading.student_code import HINTS, PACKAGES, student_code


def run(code: str, **names: Any) -> str:
    """Run a student's function `f`, and return what is said of its error."""
    linecache.cache["<cell>"] = (len(code), None, code.splitlines(keepends=True), "<cell>")
    namespace: dict[str, Any] = names
    exec(compile(code, "<cell>", "exec"), namespace)
    with pytest.raises(WrongAnswer) as caught, student_code("f()"):
        namespace["f"]()
    assert caught.value.__suppress_context__
    assert caught.value.__cause__ is None  # one sentence, and no chain of tracebacks
    return str(caught.value)


def test_the_line_is_the_students() -> None:
    """Also when the error is raised further down; each is one line, also a message of several lines."""
    assert run("def f():\n    x = 1\n    return x / 0") == (
        "the line `return x / 0` raises ZeroDivisionError: division by zero"
        " (the number below the line can be 0: if it is a count, should it grow first, or is 0 a case apart?)"
    )
    said = run("def f():\n    return np.zeros(2).reshape(3)\n", np=np)
    assert said.startswith("the line `return np.zeros(2).reshape(3)` raises ValueError: cannot reshape")
    said = run("def f():\n    return QLearning.create((2, 2), alpha=1)\n", QLearning=QLearning)
    assert said.startswith("the line `return QLearning.create((2, 2), alpha=1)` raises ValueError: QLearning ")
    assert "raises KeyError: there is no key 'a'" in run("def f():\n    return {}['a']")
    assert run("def f():\n    f()").endswith("raises RecursionError: in f() a function calls itself for ever")
    assert "\n" not in run("def f():\n    raise ValueError('one\\ntwo')")


@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("QLearning.create((2, 2), alpha=1)", "QLearning "),
        ("QLearning.create()", "my_agent raises TypeError: "),
        ("random.sample([], 2)", "my_agent raises ValueError: Sample larger than population"),
    ],
)
def test_without_a_line_of_the_students(code: str, says: str) -> None:
    """What the package refuses says all that there is to say; of other errors it is told where they come from."""
    check = f"with student_code('my_agent'):\n    {code}\n"
    with pytest.raises(WrongAnswer) as caught:
        exec(
            compile(check, f"{PACKAGES[0]}/check.py", "exec"),
            {"student_code": student_code, "QLearning": QLearning, "random": random},
        )
    assert str(caught.value).startswith(says)


class Pair(NamedTuple):
    """Two numbers."""

    a: int
    b: int


ERRORS = [
    ("Pair(1, 2).a = 3", "the fields of a NamedTuple are fixed"),
    ("Pair(1, 2)[0] = 3", "only arrays and lists have entries"),
    ("return 1 if np.zeros(2) > 0 else 0", "compare single entries"),
    ("return tries[0]", "write `self.` before a field"),
    ("return preferences[0]", "write `self.` before a field"),
    ("return f[0]", "a function is called, with parentheses"),
    ("return 1 + f", "a function is called, with parentheses"),
    ("return np.random.default_rng(0).random < 1", "a function is called, with parentheses"),
    ("return float(np.zeros(2))", "an array stands where one number is needed"),
    ("table = np.zeros(3); table[0] = np.ones(2)", "an array stands where one number is needed"),
    ("return np.zeros(2) + np.zeros(3)", "two arrays of different sizes meet there"),
    ("return np.zeros((2, 3)) @ np.zeros(2)", "two arrays of different sizes meet there"),
    ("return np.dot(np.zeros((2, 3)), np.zeros(2))", "two arrays of different sizes meet there"),
    ("return np.ones((2, 3))[np.ones((3, 2)) > 0]", "two arrays of different sizes meet there"),
    ("return np.random.default_rng(0).normal(0, -1)", "a standard deviation is below 0"),
    ("return random.random()", "`import` it first"),
    ("x = 0.5 ^ 2", "`^` is no power in Python: write `**`"),
    ("x += 1; x = 2", "it gets a value on some paths only"),
    ("x = None; return x[0]", "something is None there"),
    ("return 1 / 0", "the number below the line can be 0"),
    ("return Pair.a[0]", "that is the field of the class"),
    ("return np.zeros(2)[0, 1]", "the array has fewer axes than there are indices"),
    ("return np.zeros(0)[0]", "it is empty, so it has no entries"),
    ("return np.zeros(2)[2]", "indices go from 0 to the size less 1"),
    (
        'raise AssertionError("Environment truncates after 1 step, something has gone very wrong.")',
        "is that step `terminated`, and not truncated?",
    ),
    ("return [1, 2][2]", "indices go from 0 to the size less 1"),
    ("return math.exp(710)", "the exponential of a number above 709 is too large"),
    ("return math.log(0)", "a logarithm needs a number above 0"),
    ("return alpha * 2", "the exercise has another name for it"),
    ("return rewards[0]", "write `self.` before a field"),
    ("return inf", "infinity is math.inf"),
    ("return max(np.zeros(2)[0])", "that is a single number, and a row, a list or range(...) is needed there"),
    ("return reversed(2)", "that is a single number, and a row"),
    ("return np.zeros(2)[0][1]", "that is a single number, and a row"),
    ("return np.zeros(2)(0)", "that is no function: leave the parentheses out"),
    ("y = 1.5; return y()", "that is no function: leave the parentheses out"),
    ("return np.random.default_rng(0).choice([])", "nothing is left to choose from"),
    ("return np.array([[1], [1, 2]])", "an array of numbers is needed there"),
    ("return np.zeros(2)[1.0]", "an index is a whole number"),
    ("return np.zeros(2)[np.ones(2)]", "an index is a whole number"),
    ("return create()", "`create` takes the environment first"),
    ("return g(1)", "it has more parameters than the call gives it values"),
    ("return g(1, 2, 3)", "its parameters are not those of the exercise"),
    ("return g(1, z=2)", "its parameters are not those of the exercise"),
    ("return [True].all()", "that is a list: np.array(...) makes an array of it"),
    ("return np.zeros(2).append(1)", "an array keeps its size: write into an entry of it"),
    ("return math(2)", "a module has this name too: write `self.` before a method"),
    (
        "return gymnasium.spaces.MultiDiscrete([2]).n",
        "`nvec` has its sizes; for a table, `table_size(environment)` has them",
    ),
    ("return np.zeros(2).maximum()", "is the name spelt as in the exercise?"),
]
"""Lines that raise an error, and what is said of it."""


@pytest.mark.parametrize(("line", "hint"), ERRORS)
def test_what_often_lies_behind_an_error(line: str, hint: str) -> None:
    """The hint belongs to the error, and no other one comes first."""

    def create(environment: Any) -> None:
        """A function that needs an environment."""

    def g(x: int, y: int) -> None:
        """A function of two parameters."""

    said = run(f"def f(self=None):\n    {line}", np=np, math=math, gymnasium=gymnasium, Pair=Pair, create=create, g=g)
    assert f"({hint}" in said


def test_an_array_that_is_compared() -> None:
    """The sentence is about the student's line, in words that she knows."""
    said = run("def f(self=None):\n    return max(np.zeros(2), np.ones(2))", np=np)
    assert "raises ValueError: an array of several stands where one number is compared (compare single" in said
    assert "ambiguous" not in said


def test_a_name_that_self_has() -> None:
    """Any field and any method of the student's own class is known as such."""
    for line in ("return b + 1", "return count(1)"):
        said = run(f"def m(self):\n    {line}\n\ndef f():\n    return m(Pair(1, 2))", Pair=Pair)
        assert said.endswith("is not defined (write `self.` before a field or a method)")


def test_no_self_in_a_plain_function() -> None:
    """There a name that is a field elsewhere is more likely a parameter."""
    assert "discount' is not defined (is it a parameter, under another name?)" in run("def f():\n    return discount")


def test_every_hint_has_an_error() -> None:
    """And so each pattern is known to find what it should."""
    for _, told in HINTS:
        assert any(hint in told for _, hint in ERRORS), told


def test_what_passes() -> None:
    """Placeholders are not solved yet, warnings are not shown, a wrong answer stays, an interrupt ends the check."""
    for placeholder in (
        "raise NotImplementedError('not solved yet: replace this line')",
        "raise NotImplementedError()",
    ):
        assert run(f"def f():\n    {placeholder}").startswith("Not solved yet")
    with pytest.raises(Unsolved), student_code("f()"):
        raise NotImplementedError
    with warnings.catch_warnings(record=True) as caught, student_code("f()"):
        warnings.warn("old", stacklevel=1)
        assert np.isinf(np.float64(1.0) / np.float64(0.0))
    assert caught == []
    with pytest.raises(WrongAnswer, match=r"^as it is$"), student_code("f()"):
        raise WrongAnswer("as it is")
    with pytest.raises(KeyboardInterrupt), student_code("f()"):
        raise KeyboardInterrupt

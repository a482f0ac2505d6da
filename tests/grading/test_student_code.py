"""Errors in an answer: a sentence that ends at the student's own line."""

import linecache
import warnings
from typing import Any

import numpy as np
import pytest

from edugym import QLearning
from edugym.grading import Unsolved, WrongAnswer
from edugym.grading.student_code import running


def run(code: str, **names: Any) -> str:
    """Run a student's function `f`, and return what is said of its error."""
    linecache.cache["<cell>"] = (len(code), None, code.splitlines(keepends=True), "<cell>")
    namespace: dict[str, Any] = names
    exec(compile(code, "<cell>", "exec"), namespace)
    with pytest.raises(WrongAnswer) as caught, running("f()"):
        namespace["f"]()
    return str(caught.value)


def test_the_line_is_the_students() -> None:
    """Also when the error is raised further down, in a library or in this package."""
    assert run("def f():\n    x = 1\n    return x / 0") == (
        "the line `return x / 0` raises ZeroDivisionError: division by zero"
        " (nothing was counted yet: count first, then divide)"
    )
    said = run("def f():\n    return np.zeros(2).reshape(3)\n", np=np)
    assert said.startswith("the line `return np.zeros(2).reshape(3)` raises ValueError: cannot reshape")
    said = run("def f():\n    return QLearning.create((2, 2), alpha=1)\n", QLearning=QLearning)
    assert said.startswith("the line `return QLearning.create((2, 2), alpha=1)` raises ValueError: QLearning has no")


def test_every_error_is_one_line() -> None:
    """A key, an endless recursion, a message of several lines."""
    assert "raises KeyError: there is no key 'a'" in run("def f():\n    return {}['a']")
    assert run("def f():\n    f()").endswith("raises RecursionError: a function calls itself for ever")
    assert "\n" not in run("def f():\n    raise ValueError('one\\ntwo')")


def test_placeholders_are_not_solved_yet() -> None:
    """Neither the lesson's nor that of nbgrader is an error of the student's."""
    for placeholder in (
        "raise NotImplementedError('not solved yet: replace this line')",
        "raise NotImplementedError()",
    ):
        assert run(f"def f():\n    {placeholder}").startswith("Not solved yet")
    with pytest.raises(Unsolved), running("f()"):
        raise NotImplementedError


def test_warnings_and_verdicts_pass() -> None:
    """Warnings are not shown, a verdict stays as it is, and an interrupt ends the check."""
    with warnings.catch_warnings(record=True) as caught, running("f()"):
        warnings.warn("old", stacklevel=1)
        assert np.isinf(np.float64(1.0) / np.float64(0.0))
    assert caught == []
    with pytest.raises(WrongAnswer, match=r"^as it is$"), running("f()"):
        raise WrongAnswer("as it is")
    with pytest.raises(KeyboardInterrupt), running("f()"):
        raise KeyboardInterrupt

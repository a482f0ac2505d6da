"""Errors in a student's code: one sentence, which ends at the student's own line."""

import linecache
import re
import traceback
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

import numpy as np

from edugym.system.packages import is_installed, own_folders
from edugym_course.grading.errors import Unsolved, WrongAnswer
from edugym_course.grading.time_limit import LIMIT, time_limit

PACKAGES = tuple(map(str, own_folders()))

FIELD = "write `self.` before a field or a method"
HINTS = (
    (
        "can't set attribute",
        "the fields of a NamedTuple are fixed: change entries of its arrays, and give settings to `create`",
    ),
    ("object does not support item assignment", "only arrays and lists have entries that can be changed"),
    ("an array of several stands where one number", "compare single entries, not whole rows"),
    (
        r"name '(Q|V|w|visits|tries|preferences|probabilities|weights|memory|steps|learning_rate|value_learning_rate"
        r"|discount|bonus|epsilon|target_epsilon|kappa|last|ring|late|states|actions|rewards)' is not defined",
        FIELD,
    ),
    (r"name '(alpha|beta|gamma|alfa|lr)' is not defined", "the exercise has another name for it"),
    (r"name '(math|np|numpy|random)' is not defined", "`import` it first"),
    (r"name 'inf(inity)?' is not defined", "infinity is math.inf"),
    ("cannot access local variable", "it gets a value on some paths only"),
    (r"operand type\(s\) for \^", "`^` is no power in Python: write `**`"),
    ("'NoneType'", "something is None there: is a `return` missing, or does what is called return nothing?"),
    (
        "division by zero",
        "the number below the line can be 0: if it is a count, should it grow first, or is 0 a case apart?",
    ),
    ("_tuplegetter", "that is the field of the class: write `self.` for the table of this agent"),
    (
        r"converted to Python scalar|array element with a sequence\.$",
        "an array stands where one number is needed: take an entry of it, or calculate with + - * / **, which arrays"
        " have as well",
    ),
    (
        "could not be broadcast",
        "two arrays of different sizes meet there: are rows and columns in order? (`+` adds, np.concatenate joins.)",
    ),
    (
        "boolean index did not match|mismatch in its core dimension|shapes .* not aligned",
        "two arrays of different sizes meet there: are rows and columns in order?",
    ),
    ("truncates after 1 step", "is that step `terminated`, and not truncated? Have the two changed places?"),
    ("scale < 0", "a standard deviation is below 0: is it ln σ that is learned, and σ = e^(ln σ)?"),
    (
        "(function|method)' (object is not subscriptable|and )|and '\\w*(function|method)'",
        "a function is called, with parentheses",
    ),
    (
        r"(float|int)\d*' object is not (iterable|reversible|subscriptable)|index to scalar",
        "that is a single number, and a row, a list or range(...) is needed there",
    ),
    (
        r"(float|int|list|array)\d*' object is not callable",
        "that is no function: leave the parentheses out, or take an entry with [ ]",
    ),
    (
        "cannot be empty",
        "nothing is left to choose from: for which values does that happen? 0 / 0 gives nan, which equals nothing, not"
        " even itself",
    ),
    ("with size 0", "it is empty, so it has no entries: is something left to choose from in all cases?"),
    ("too many indices", "the array has fewer axes than there are indices"),
    (
        "out of bounds|index out of range",
        "indices go from 0 to the size less 1: is the range, or the order of the indices, right?",
    ),
    ("math range error", "the exponential of a number above 709 is too large: write it with a negative exponent"),
    (
        "math domain error|expected a positive input",
        "a logarithm needs a number above 0: what should come out where it is 0?",
    ),
    (
        "inhomogeneous|policy must be a whole number",
        "an array of numbers is needed there: is a call such as `.greedy_policy()` missing?",
    ),
    ("only integer|indices must be of integer", "an index is a whole number"),
    (r"create\(\) (missing|takes)", "`create` takes the environment first, and then settings by their names"),
    (r"missing \d+ required", "it has more parameters than the call gives it values"),
    ("positional argument", "its parameters are not those of the exercise"),
    ("unexpected keyword argument", "its parameters are not those of the exercise"),
    ("'module' object is not callable", "a module has this name too: write `self.` before a method"),
    (
        "ndarray' object has no attribute '(append|extend|insert|pop|remove)'",
        "an array keeps its size: write into an entry of it",
    ),
    ("'list' object has no attribute", "that is a list: np.array(...) makes an array of it"),
    (
        "'MultiDiscrete' object has no attribute 'n'",
        "`nvec` has its sizes; for a table, `table_size(environment)` has them",
    ),
    (
        r"'[A-Z]\w*' object has no attribute",
        "is the name spelt as in the exercise? (A NamedTuple takes no new names: use a plain variable.)",
    ),
    ("has no attribute", "is the name spelt as in the exercise?"),
)
"""What often lies behind an error, by what its message contains."""


@contextmanager
def student_code(what: str, limit: float = LIMIT) -> Iterator[None]:
    """Run a student's code: an error in it becomes one sentence, and a placeholder "not solved yet".

    Args:
        what: what is running, for the sentence: "optimist(wall)".
        limit: the seconds of processor time that it may take.

    Raises:
        WrongAnswer: the code raises an error, or does not end.
        Unsolved: the code is the placeholder of the exercise.
    """
    try:
        with time_limit(what, limit), np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    except WrongAnswer:
        raise
    except NotImplementedError:
        raise Unsolved(
            "Not solved yet: the line `raise NotImplementedError` is still there. Put your solution in its place (if it"
            " stands above that line, delete the line), run that cell, and run this one."
        ) from None
    except Exception as error:
        raise WrongAnswer(_sentence(what, error)) from None


def _sentence(what: str, error: Exception) -> str:
    message = " ".join(str(error).split())
    if isinstance(error, KeyError):
        message = f"there is no key {message}"
    if isinstance(error, StopIteration):
        message = "next(...) finds nothing: no value passes its test"
    if "truth value of an array" in message:
        message = "an array of several stands where one number is compared"
    hints = [hint for pattern, hint in HINTS if re.search(pattern, message)]
    if isinstance(error, NameError) and error.name and hasattr(_self_of(error), error.name):
        hints = [FIELD]
    elif hints and hints[0] == FIELD and not _in_method(error):
        hints = ["is it a parameter, under another name?"]
    line = _student_line(error)
    if re.search(r"has no attribute '(\w+)'.*\nself\.\1 [-+*/]?= ", f"{message}\n{line}"):
        hints = ["a NamedTuple takes no new fields: without `self.` it is a variable of the method"]
    because = f" ({hints[0]})" if hints else ""
    kind = type(error).__name__
    if isinstance(error, RecursionError):
        message, because = f"in {what} a function calls itself for ever", ""
    if not line and isinstance(error, ValueError) and _last_file(error).startswith(PACKAGES):
        return message  # a check of the package refuses what it was given, and says so in a sentence
    place = f"the line `{line}`" if line else what
    return f"{place} raises {kind}: {message}{because}"


def _student_line(error: Exception) -> str:
    """Return the last line of the student's own code on the way to the error, or "" if there is none."""
    lines = [
        linecache.getline(frame.f_code.co_filename, number).strip()
        for frame, number in traceback.walk_tb(error.__traceback__)
        if not _is_ours(frame.f_code.co_filename)
    ]
    return next(filter(None, reversed(lines)), "")


def _in_method(error: Exception) -> bool:
    """Return whether the error comes from a method of a student's."""
    frames = _student_frames(error)
    return bool(frames) and "self" in frames[-1].f_code.co_varnames


def _self_of(error: Exception) -> Any:
    """Return the object whose method the error comes from; None if it is no method of a student's."""
    frames = _student_frames(error)
    return frames[-1].f_locals.get("self") if frames else None


def _student_frames(error: Exception) -> list[FrameType]:
    """Return the calls of the student's own code on the way to the error."""
    return [frame for frame, _ in traceback.walk_tb(error.__traceback__) if not _is_ours(frame.f_code.co_filename)]


def _last_file(error: Exception) -> str:
    """Return the file in which an error was raised."""
    return [frame.f_code.co_filename for frame, _ in traceback.walk_tb(error.__traceback__)][-1]


def _is_ours(file: str) -> bool:
    """Whether a file belongs to this package or to a library, and not to the student."""
    return file.startswith(PACKAGES) or is_installed(file)

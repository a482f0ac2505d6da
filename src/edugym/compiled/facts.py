"""What is known of a build so far: which functions are given, and return, numbers that may be whole or real."""

from types import FunctionType
from typing import Any


class Facts:
    """What is known of a build so far.

    Attributes:
        parameters: those that may be given mixed numbers: (function, name).
        results: functions that may return them.
        is_incomplete: whether a function was finished before something of it was known.
        is_foreign: whether there is a student's code in the build.
    """

    is_foreign = False

    def __init__(self) -> None:
        """Nothing is known."""
        self.parameters: set[tuple[FunctionType, str]] = set()
        self.results: set[FunctionType] = set()
        self.is_incomplete = False

    def clear(self) -> None:
        """Forgets everything."""
        self.parameters.clear()
        self.results.clear()
        self.is_incomplete = False


facts = Facts()
"""Those of the build in progress, of which there is one at a time."""


class Incomplete(Exception):
    """The build is to begin again with the facts that were found."""


def require_complete(state: Any) -> bool:
    """Ends a build in which a function was finished too early: the pass for the loop, which comes last."""
    if facts.is_incomplete:
        facts.is_incomplete = False
        raise Incomplete
    return True

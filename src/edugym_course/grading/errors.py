"""The exceptions that say what is wrong with an answer."""

import textwrap
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

WIDTH = 100
"""The most characters in a line of a message: JupyterLab breaks longer ones in the middle of a word."""
_VERDICTS: ContextVar[bool] = ContextVar("only verdicts", default=False)


class WrongAnswer(AssertionError):
    """An answer is not right; the message is one sentence that says what was expected, what came, and why.

    In a notebook the sentence is all that is shown. The cell still counts as failed, for nbgrader too.
    """

    def _render_traceback_(self) -> list[str]:
        """Return what IPython shows in place of a traceback."""
        return [folded(f"✗ {self}")]


class Unsolved(WrongAnswer):
    """There is no answer yet."""


class TooSlow(WrongAnswer):
    """An answer was ended because it took too long."""


def folded(message: str) -> str:
    """The message, its long lines broken between words."""
    lines = message.splitlines()
    return "\n".join(textwrap.fill(line, WIDTH, break_long_words=False, break_on_hyphens=False) for line in lines)


@contextmanager
def only_verdicts() -> Iterator[None]:
    """Within it nobody reads why an answer is wrong, so that a check need not look for the mistake."""
    token = _VERDICTS.set(True)
    try:
        yield
    finally:
        _VERDICTS.reset(token)


def nobody_asks_why() -> bool:
    """Whether `only_verdicts` is in force."""
    return _VERDICTS.get()

"""The exceptions that say what is wrong with an answer."""


class WrongAnswer(AssertionError):
    """An answer is not right; the message is one sentence that says what was expected, what came, and why.

    In a notebook the sentence is all that is shown. The cell still counts as failed, for nbgrader too.
    """

    def _render_traceback_(self) -> list[str]:
        """Return what IPython shows in place of a traceback."""
        return [f"✗ {self}"]


class Unsolved(WrongAnswer):
    """There is no answer yet."""

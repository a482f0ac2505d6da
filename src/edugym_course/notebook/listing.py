"""Show the code that really runs, so that the equations of a lesson and its code cannot drift apart."""

import inspect
import textwrap
from typing import Any, NamedTuple

from edugym.checks.parameters import a_text, in_short


class Listing(NamedTuple):
    """Code from its file. In a notebook it shows itself, highlighted.

    Attributes:
        module: the module that contains it.
        code: its lines.
    """

    module: str
    code: str

    def __repr__(self) -> str:
        """The lines, for front ends without highlighting."""
        return self.code

    def _repr_markdown_(self) -> str:
        return f"From `{self.module}`:\n\n```python\n{self.code}\n```"


def source(subject: Any, *names: str) -> Listing:
    """Show the source of a class, or of some of its methods: `source(QLearning)`, `source(QLearning, "act", "learn")`.

    Args:
        subject: a class, a function, a method (`QLearning.learn`), or a value, which stands for its class.
        names: the methods and properties to show instead of the whole class.

    Returns:
        The code. As the last value of a cell it shows itself.

    Raises:
        ValueError: there is no such method, or it has no Python source because it is written in C.
    """
    whole = subject if inspect.isclass(subject) or inspect.isroutine(subject) else type(subject)
    parts = [inspect.getattr_static(whole, a_text("names", name), None) for name in names] or [whole]
    for name, part in zip(names, parts, strict=False):
        if part is None:
            raise ValueError(f"names must be of methods of subject, {whole.__name__}, but {in_short(name)} is none")
    return Listing(whole.__module__, "\n\n".join(map(_code, parts)))


def _code(part: Any) -> str:
    """The lines of a class or function with its decorators, from the left margin."""
    for inside in ("fget", "__func__", "func", "py_func"):  # of properties, class methods, cached ones, compiled code
        part = getattr(part, inside, None) or part
    try:
        return textwrap.dedent(inspect.getsource(part)).rstrip()
    except (OSError, TypeError) as error:
        raise ValueError(f"subject must have Python source, but {in_short(part)} has none here") from error

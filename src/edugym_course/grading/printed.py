"""What an answer prints: its first lines, and how many more there were."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from edugym.system.packages import OURS

LINES = 20
"""So many lines of what an answer prints are shown in a cell."""


class FewLines:
    """A stream in the place of `sys.stdout` that lets only the first lines pass of what an answer prints.

    What the cell itself prints, outside functions, and what this package prints passes.

    Attributes:
        lines: how many lines the answer has printed.
    """

    def __init__(self, out: Any) -> None:
        """Take the place of `out`."""
        self._out, self.lines = out, 0

    def write(self, text: str) -> int:
        """Write what is said, or nothing if it is too much."""
        caller = sys._getframe(1)
        if caller.f_code.co_name == "<module>" or caller.f_globals.get("__name__", "").partition(".")[0] in OURS:
            self._out.write(text)
            return len(text)
        for line in text.splitlines(keepends=True):
            if self.lines < LINES:
                self._out.write(line)
            self.lines += line.endswith("\n")
        return len(text)

    def end(self) -> None:
        """Say how many lines were left out."""
        if self.lines > LINES:
            self._out.write(f"... and {self.lines - LINES:,} more lines\n".replace(",", " "))

    def __getattr__(self, name: str) -> Any:
        """Everything else is that of the stream."""
        return getattr(self._out, name)


@contextmanager
def few_lines() -> Iterator[FewLines]:
    """Show only the first lines of what an answer prints: in a notebook until the end of the cell, elsewhere within."""
    present: Any = sys.stdout
    if isinstance(present, FewLines):  # a second check in the same cell
        yield present
        return
    stream: Any = FewLines(present)
    sys.stdout = stream
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None

    def end(result: Any = None) -> None:
        sys.stdout = present
        stream.end()
        if shell is not None:
            shell.events.unregister("post_run_cell", end)

    if shell is not None:
        shell.events.register("post_run_cell", end)
    try:
        yield stream
    finally:
        if shell is None:
            end()

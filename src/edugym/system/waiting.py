"""One line for a person who waits: what is being done, or how long it still takes. It disappears when that is done."""

import os
import sys
from typing import Any

_handles: dict[int, Any] = {}  # the display of the notebook's present cell, by the number of the cell: one a cell


def show(text: str) -> None:
    """Show a line in place of the one before, where a person watches: in a notebook's output, or else in a terminal.

    The environment variable EDUGYM_QUIET leaves it out.
    """
    if os.environ.get("EDUGYM_QUIET"):
        return
    shell = _notebook()
    if shell is not None:  # not on stderr, which a notebook shows as if something were wrong
        _display(shell, text)
    elif sys.stderr.isatty():
        print(f"\r{text}", end="", file=sys.stderr, flush=True)


def clear(text: str) -> None:
    """Take away the line that `show` has shown."""
    show(" " * len(text))
    if _notebook() is None:
        show("")  # the cursor goes back


def _notebook() -> Any:
    """IPython's shell in a notebook; None elsewhere."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell if type(shell).__name__ == "ZMQInteractiveShell" else None


def _display(shell: Any, text: str) -> None:
    """Write the line into the present cell's output."""
    data, cell = {"text/plain": text.rstrip()}, shell.execution_count
    if cell in _handles:
        _handles[cell].update(data, raw=True)
    else:
        _handles.clear()
        _handles[cell] = sys.modules["IPython"].display.display(data, raw=True, display_id=True)

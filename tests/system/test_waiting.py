"""The line for a person who waits: where it is shown, and that it goes away."""

import io
import sys
from types import SimpleNamespace
from typing import Any

import pytest

from edugym.system import waiting


class Terminal(io.StringIO):
    """A stream that somebody watches."""

    def isatty(self) -> bool:
        """It is one."""
        return True


class Notebook:
    """What IPython has: a shell, and displays that can be updated."""

    def __init__(self, kind: str) -> None:
        """With nothing displayed yet."""
        self.shell = type(kind, (), {"execution_count": 1})()
        self.lines: list[str] = []
        self.display = SimpleNamespace(display=self._new)

    def get_ipython(self) -> Any:
        """The shell."""
        return self.shell

    def _new(self, data: dict[str, str], **how: bool) -> Any:
        assert how == {"raw": True, "display_id": True}
        self.lines.append(data["text/plain"])
        return SimpleNamespace(update=self._update)

    def _update(self, data: dict[str, str], raw: bool) -> None:
        assert raw
        self.lines[-1] = data["text/plain"]


@pytest.mark.parametrize("kind", ["ZMQInteractiveShell", "TerminalInteractiveShell", "no IPython"])
@pytest.mark.parametrize("stderr", [Terminal, io.StringIO])
def test_where_it_is_shown(kind: str, stderr: type[io.StringIO], monkeypatch: pytest.MonkeyPatch) -> None:
    """In a notebook in the output, one line a cell; elsewhere only in a terminal; and nowhere if it is not wanted."""
    err, notebook = stderr(), Notebook(kind)
    monkeypatch.setitem(sys.modules, "IPython", None if kind == "no IPython" else notebook)
    monkeypatch.setattr(sys, "stderr", err)
    monkeypatch.setattr(waiting, "_handles", {})
    monkeypatch.setenv("EDUGYM_QUIET", "1")
    waiting.show("compiling")
    assert (notebook.lines, err.getvalue()) == ([], "")
    monkeypatch.setenv("EDUGYM_QUIET", "")
    in_notebook, in_terminal = kind.startswith("ZMQ"), stderr is Terminal
    for text in ("compiling", "10% done"):
        waiting.show(text)
        assert notebook.lines == [text] * in_notebook
        waiting.clear(text)
        assert notebook.lines == [""] * in_notebook
    assert (f"\r10% done\r{' ' * 8}\r" in err.getvalue()) == (in_terminal and not in_notebook)
    notebook.shell.execution_count = 2
    waiting.show("compiling")
    assert notebook.lines == ["", "compiling"] * in_notebook

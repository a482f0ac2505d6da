"""The client that runs a lesson's cells in a kernel."""

import os
import time
from contextlib import suppress
from queue import Empty
from typing import Any

from nbclient import NotebookClient
from nbclient.exceptions import CellControlSignal, DeadKernelError
from nbformat import NotebookNode
from rules import where

ENVIRONMENT = {  # of the kernel: figures go into the notebook, and sets print in the same order every time
    "MPLBACKEND": "module://matplotlib_inline.backend_inline",
    "PYTHONHASHSEED": "0",
    "EDUGYM_QUIET": "1",  # whether something must be compiled first depends on the machine
}


class LessonClient(NotebookClient):
    """Executes a notebook and keeps a list of what a reader would see go wrong.

    ipywidgets catches an exception in a widget's callback and shows it inside the widget; the cell succeeds, and the
    message that the kernel sends is the only trace.
    """

    def begin(self, notebook: NotebookNode) -> None:
        """Looks for the kernel's replies once a second.

        A client that waits without looking may miss a reply while a widget's messages go out, and then waits until the
        cell's time is over: https://github.com/jupyter/nbclient/issues/312.
        """
        assert self.kc is not None
        channel = self.kc.shell_channel
        get_msg = channel.get_msg

        async def often(timeout: float) -> dict[str, Any]:
            end = time.monotonic() + timeout
            while (left := end - time.monotonic()) > 1:
                with suppress(Empty):
                    return dict(await get_msg(timeout=1))
            return dict(await get_msg(timeout=max(0, left)))

        channel.get_msg = often

    def start(self, cell: NotebookNode, cell_index: int) -> None:
        """Notes which cell is running."""
        self.running = where(cell)

    def process_message(self, msg: dict[str, Any], cell: NotebookNode, cell_index: int) -> NotebookNode | None:
        """Notes errors, wherever they are shown, and text on stderr; then does what every client does."""
        content = msg["content"]
        if "raises-exception" not in cell.metadata.get("tags", []):
            if msg["msg_type"] == "error":
                self.faults.append(f"{where(cell)}: {content['ename']}: {content['evalue']}")
            elif msg["msg_type"] == "stream" and content["name"] == "stderr":
                self.faults.append(f"{where(cell)}: wrote to stderr: {content['text'].strip()}")
        return super().process_message(msg, cell, cell_index)

    def run(self) -> list[str]:
        """Executes the notebook in place, and returns the faults that it noted."""
        self.faults: list[str] = []
        self.running = "before the first cell"
        self.on_notebook_start, self.on_cell_execute = self.begin, self.start
        try:
            self.execute(env=os.environ | ENVIRONMENT)
        except (CellControlSignal, DeadKernelError) as error:
            self.faults.append(f"{self.running}: {error}")
        return self.faults

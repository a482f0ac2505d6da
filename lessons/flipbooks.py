"""The pictures that the website shows for the sliders of a lesson, made in a kernel of their own.

They stand beside the notebooks: `notebooks/flipbooks/NN_name`. A lesson need not have them for every slider.
"""

import re
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from lesson_client import LessonClient
from nbformat import NO_CONVERT, NotebookNode, reads
from nbformat.v4 import new_code_cell, new_notebook
from rules import is_code

from edugym_course.notebook.flipbook import fingerprint, flipbooks

SECONDS = 600  # for all pictures of a slider, on a busy machine
KEEP = """\
import pathlib
import edugym_course.notebook.flipbook
edugym_course.notebook.flipbook.keep(Out[max(Out)], pathlib.Path({folder!r}), {fingerprint!r})"""


def place(name: str, notebooks: Path) -> Path:
    """The folder of a lesson's flipbooks."""
    return notebooks / "flipbooks" / name


def make(name: str, notebooks: Path) -> list[str]:
    """Runs the cells of an executed lesson up to its last sliders, and writes its flipbooks in the place of older ones.

    Args:
        name: The lesson, such as "01_exploration".
        notebooks: The folder of the notebooks; none of them changes.

    Returns:
        What went wrong; nothing is written then.
    """
    cells = list(filter(is_code, _executed(name, notebooks).cells))
    with tempfile.TemporaryDirectory() as folder:
        made, empty = Path(folder, "made"), Path(folder, "empty")
        made.mkdir()
        empty.mkdir()
        run, end = new_notebook(), 0
        for cell in cells:
            run.cells.append(cell)
            if has_sliders(cell.source):
                known = fingerprint(cell.source, cell.outputs)
                run.cells.append(new_code_cell(KEEP.format(folder=str(made), fingerprint=known)))
                end = len(run.cells)
        del run.cells[end:]
        faults = LessonClient(
            run,
            timeout=SECONDS,
            kernel_name="python3",
            extra_arguments=["--log-level=ERROR"],
            resources={"metadata": {"path": str(empty)}},
        ).run()
        if not faults:
            shutil.rmtree(place(name, notebooks), ignore_errors=True)
            if any(made.iterdir()):
                shutil.copytree(made, place(name, notebooks))
    return faults


def outdated(name: str, notebooks: Path) -> Iterator[Path]:
    """The flipbooks of a lesson that belong to no cell of its executed notebook as it is now."""
    if found := flipbooks(place(name, notebooks)):
        current = {fingerprint(cell.source, cell.outputs) for cell in filter(is_code, _executed(name, notebooks).cells)}
        for book in found:
            if book.fingerprint not in current:
                yield place(name, notebooks) / f"{book.function}.json"


def has_sliders(source: str) -> bool:
    """Whether a cell makes sliders."""
    return re.search(r"^sliders\(", source, re.MULTILINE) is not None


def _executed(name: str, notebooks: Path) -> NotebookNode:
    path = notebooks / "solutions" / f"{name}.ipynb"
    notebook: NotebookNode = reads(path.read_text(encoding="utf-8"), as_version=NO_CONVERT)
    return notebook

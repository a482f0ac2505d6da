"""The pictures that the website shows for the sliders and films of a lesson, made in a kernel of their own.

They stand beside the notebooks: `notebooks/flipbooks/NN_name`.
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

from edugym_course.notebook.filmstrip import ENDING, filmstrips
from edugym_course.notebook.flipbook import fingerprint, flipbooks
from edugym_course.notebook.widget import WITHOUT_KERNEL

SECONDS = 1800  # for all pictures of a cell, on a busy machine
KEEP = """\
import pathlib
import edugym_course.notebook.{module}
edugym_course.notebook.{module}.keep(Out[max(Out)], pathlib.Path({folder!r}), {fingerprint!r})"""


def place(name: str, notebooks: Path) -> Path:
    """The folder of a lesson's flipbooks."""
    return notebooks / "flipbooks" / name


def make(name: str, notebooks: Path) -> list[str]:
    """Runs the cells of an executed lesson up to its last sliders or film, and writes what the website shows of them.

    Args:
        name: The lesson, such as "01_exploration".
        notebooks: The folder of the notebooks; none of them changes.

    Returns:
        What went wrong; the older files stay then.
    """
    cells = list(filter(is_code, _executed(name, notebooks).cells))
    with tempfile.TemporaryDirectory() as folder:
        made, empty = Path(folder, "made"), Path(folder, "empty")
        made.mkdir()
        empty.mkdir()
        run, end = new_notebook(), 0
        for cell in cells:
            run.cells.append(cell)
            module = "flipbook" if has_sliders(cell.source) else "filmstrip" if has_film(cell) else ""
            if module:
                known = fingerprint(cell.source, cell.outputs)
                run.cells.append(new_code_cell(KEEP.format(module=module, folder=str(made), fingerprint=known)))
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
            try:
                replace(place(name, notebooks), made, notebooks / f".{name}.unfinished")
            except OSError as error:
                faults.append(f"the pictures cannot be written: {error}")
    return faults


def replace(folder: Path, made: Path, unfinished: Path) -> None:
    """Puts all files of the folder `made` in the place of those of another one; where that fails, the old ones stay.

    Raises:
        OSError: they cannot be written.
    """
    new, old = unfinished / "new", unfinished / "old"
    if old.exists() and not folder.exists():  # somebody was killed between the two steps
        old.rename(folder)
    shutil.rmtree(unfinished, ignore_errors=True)
    try:
        new.mkdir(parents=True)
        for file in made.iterdir():
            shutil.copy(file, new)
        folder.parent.mkdir(parents=True, exist_ok=True)
        if folder.exists():
            folder.rename(old)
        if any(new.iterdir()):
            new.rename(folder)
    except BaseException:
        if old.exists() and not folder.exists():
            old.rename(folder)
        raise
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)


def outdated(name: str, notebooks: Path) -> Iterator[Path]:
    """The files that a lesson's executed notebook lacks or has no cell for, and pictures that flipbooks lack."""
    folder = place(name, notebooks)
    books = {book.function: book for book in flipbooks(folder)}
    films = {film.fingerprint for film in filmstrips(folder)}
    if not books and not films and not (notebooks / "solutions" / f"{name}.ipynb").exists():
        return
    current = dict[str, str]()  # fingerprints of all cells, and the functions of sliders that show a picture
    for cell in filter(is_code, _executed(name, notebooks).cells):
        pictured = any(kind.startswith("image/") for output in cell.outputs for kind in output.get("data", {}))
        function = _function(cell.source) if pictured else ""
        known = fingerprint(cell.source, cell.outputs)
        current[known] = function
        if function and function not in books:
            yield folder / f"{function}.json"
        if has_film(cell) and known not in films:
            yield folder / f"{known}{ENDING}"
    for book in books.values():
        if book.fingerprint not in current:
            yield folder / f"{book.function}.json"
        else:
            yield from (folder / file for file in book.files if not (folder / file).exists())
    yield from (folder / f"{film}{ENDING}" for film in films - current.keys())


def has_film(cell: NotebookNode) -> bool:
    """Whether a cell shows an episode step by step: a widget with pictures, and neither sliders nor a game to play."""
    if re.search(r"^(sliders|play)\(", cell.source, re.MULTILINE):
        return False
    shown = [output.get("data", {}) for output in cell.outputs]
    return any(data.get("text/plain") == WITHOUT_KERNEL and "image/svg+xml" in data for data in shown)


def has_sliders(source: str) -> bool:
    """Whether a cell makes sliders."""
    return bool(_function(source))


def _function(source: str) -> str:
    """The name of the function for which a cell makes sliders, "" if it makes none."""
    found = re.search(r"^sliders\(\s*(?:\w+\.)*(\w+)", source, re.MULTILINE)
    return found[1] if found else ""


def _executed(name: str, notebooks: Path) -> NotebookNode:
    path = notebooks / "solutions" / f"{name}.ipynb"
    notebook: NotebookNode = reads(path.read_text(encoding="utf-8"), as_version=NO_CONVERT)
    return notebook

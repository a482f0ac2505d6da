"""Builds the notebooks of every lesson from its source.

The text of a lesson is one file, `src/edugym_course/lessons/name/NN_name.py`, in the py:percent format of jupytext.
Three editions come from its marks:

- `notebooks/NN_name.ipynb` for students: without solutions, hidden tests and outputs;
- `notebooks/solutions/NN_name.ipynb`: everything, executed, with its outputs;
- `notebooks/teacher/NN_name.ipynb`: everything, with the metadata of nbgrader, for `nbgrader generate_assignment`.

The command line:

    python lessons/build.py                   write what its source has changed; execute where code has
    python lessons/build.py 01_exploration    the same for one lesson
    python lessons/build.py --execute         execute solutions again though their source has not changed
    python lessons/build.py --flipbooks       make what the website shows of sliders and films; no notebook changes
    python lessons/build.py --check           write nothing; fail if a notebook is not what its source makes

A new lesson begins as a copy of the folder `template`. CONTRIBUTING.md tells how to write one; `rules.py` checks it.
"""

import argparse
import json
import re
import sys
import tempfile
import time
import tomllib
from collections.abc import Sequence
from copy import deepcopy
from pathlib import Path

import flipbooks
import jupytext
import nbformat
import times
from asides import with_asides
from lesson_client import LessonClient
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell
from rules import is_check, is_code, is_exercise, is_project, problems, where, without_marks, without_solutions

from edugym_course.teaching.assignment import guarded_check, modules_of

ROOT = Path(__file__).resolve().parent.parent
LESSONS = Path("src", "edugym_course", "lessons")  # the folders of the lessons, below the root of a checkout
REPOSITORY: str = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["urls"]["Repository"]

CELL_SECONDS = 60  # a reader waits no longer than this for any cell
VIEW = "application/vnd.jupyter.widget-view+json"
SIZE_LIMIT = 2_000_000  # bytes; GitHub stops showing notebooks that are much larger
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}

INSTALL = f"""\
# @title Install EduGym where it is missing, as on Colab (the NumPy and torch found there stay as they are)
import importlib.metadata
import importlib.util
import subprocess
import sys
import tempfile
from pathlib import Path

if importlib.util.find_spec("edugym") is None:
    kept = [name for name in ("numpy", "torch") if importlib.util.find_spec(name) is not None]
    constraints = Path(tempfile.mkdtemp(), "constraints.txt")
    constraints.write_text("\\n".join(f"{{name}}=={{importlib.metadata.version(name)}}" for name in kept))
    requirement = "edugym[notebook] @ git+{REPOSITORY}"
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--constraint", str(constraints), requirement]
    subprocess.run(command, check=True)
    importlib.invalidate_caches()"""
INSTALL_METADATA = {"cellView": "form", "jupyter": {"source_hidden": True}}  # folded on Colab and in JupyterLab

CLOSING = f"""\
### Before you go: a self-check (optional)
Do you agree, disagree, or something in between?
- EduGym improves my *conceptual* understanding of reinforcement learning.
- EduGym improves my *practical* understanding of reinforcement learning.
- I think EduGym is a useful tool for reinforcement learning education.

[The feedback form]({REPOSITORY}/issues/new?template=lesson-feedback.yml&lesson={{name}}) takes two minutes:
what helped, what did not, and what you would change."""

COLAB = REPOSITORY.replace("https://github.com/", "https://colab.research.google.com/github/") + "/blob/main/notebooks"

CHECK_TAGS = ["check", "raises-exception"]  # the second lets `Run All` go on when an exercise is not solved yet
PROJECT_TAGS = ["project", "raises-exception"]


class LessonError(Exception):
    """A lesson breaks a rule or does not run; the message names the lesson, the cell and what to do."""


def lesson_sources(root: Path = ROOT) -> dict[str, Path]:
    """The texts of all lessons, by name (`01_exploration`) and in order."""
    paths = sorted((root / LESSONS).glob("*/[0-9][0-9]*_*.py"), key=lambda path: path.name)
    return {path.stem: path for path in paths}


def read_lesson(source: Path) -> NotebookNode:
    """Reads a lesson and checks it against the rules.

    Args:
        source: The py:percent file, `NN_name.py`.

    Returns:
        What the editions share: a notebook with marks and solutions, ids set by position, a second cell that installs
        the package, a last one that asks for feedback, folded asides, and the times that all of it takes.

    Raises:
        LessonError: Names every rule that the lesson breaks, and where.
    """
    lesson: NotebookNode = jupytext.reads(source.read_text(encoding="utf-8"), fmt="py:percent")
    lesson.metadata = METADATA
    lesson.cells.insert(1, new_code_cell(INSTALL, metadata=INSTALL_METADATA))
    lesson.cells = [*with_asides(lesson.cells), new_markdown_cell(CLOSING.format(name=source.stem))]
    for position, cell in enumerate(lesson.cells):
        cell.id = f"cell-{position:03d}"
    if found := problems(lesson.cells):
        raise LessonError("\n".join(f"{source.name}: {problem}" for problem in found))
    times.announce(lesson.cells)
    return lesson


def editions(source: Path, notebooks: Path) -> dict[Path, NotebookNode]:
    """Makes the three notebooks of a lesson, none executed, by the path of each under the folder `notebooks`."""
    lesson = read_lesson(source)
    file = f"{source.stem}.ipynb"
    return {
        notebooks / file: student_edition(lesson, source.stem),
        notebooks / "solutions" / file: solution_edition(lesson),
        notebooks / "teacher" / file: teacher_edition(lesson),
    }


def student_edition(lesson: NotebookNode, name: str) -> NotebookNode:
    """The notebook for students: no solutions, no hidden tests; a check that fails does not stop `Run All`."""
    notebook = deepcopy(lesson)
    notebook.cells[0].source += f"\n\n[Open this lesson in Colab]({COLAB}/{name}.ipynb)"
    for cell in filter(is_code, notebook.cells):
        cell.metadata.pop("points", None)
        if is_check(cell):
            cell.metadata.tags = CHECK_TAGS
        if is_project(cell):
            cell.metadata.tags = PROJECT_TAGS
        cell.source = without_solutions(cell.source)
    return notebook


def solution_edition(lesson: NotebookNode) -> NotebookNode:
    """The notebook with every solution and every test, not executed yet."""
    notebook = deepcopy(lesson)
    for cell in filter(is_code, notebook.cells):
        cell.metadata.pop("points", None)
        cell.source = without_marks(cell.source)
    return notebook


def teacher_edition(lesson: NotebookNode) -> NotebookNode:
    """The notebook for `nbgrader generate_assignment`: marks, and metadata of nbgrader's schema 3.

    Grade ids count exercises, so that they stay when other cells come and go.
    """
    notebook = deepcopy(lesson)
    number, modules = 0, modules_of(lesson)
    for cell in filter(is_code, notebook.cells):
        points = cell.metadata.pop("points", 1)
        if is_exercise(cell):
            number += 1
            role = {"grade_id": f"exercise-{number}", "grade": False, "solution": True, "locked": False}
            cell.metadata.tags = ["raises-exception"]  # what nbgrader puts in the place of a solution raises
        elif is_check(cell):
            role = {"grade_id": f"check-{number}", "grade": True, "solution": False, "locked": True, "points": points}
            cell.metadata.tags = CHECK_TAGS
            cell.source = guarded_check(cell.source, modules)
        else:
            if is_project(cell):  # nbgrader knows nothing of it, and would leave the program in
                cell.source, cell.metadata.tags = without_solutions(cell.source), PROJECT_TAGS
            continue
        cell.metadata.nbgrader = {"schema_version": 3, "task": False} | role
    return notebook


def execute(notebook: NotebookNode, name: str, *, seconds: int = CELL_SECONDS) -> None:
    """Executes a notebook in place, in an empty folder, and keeps only outputs that are the same next time.

    Widgets are left out of the outputs, for their state has random names; what a widget shows besides, a still picture
    for where no kernel runs, stays.

    Args:
        notebook: The notebook; its outputs are replaced.
        name: The lesson, for messages.
        seconds: The longest time that one cell may take.

    Raises:
        LessonError: A cell raised, timed out, killed the kernel, wrote to stderr or printed a memory address, or a
            callback of a widget raised. Cells with the tag `raises-exception` may do so.
    """
    with tempfile.TemporaryDirectory() as folder:
        client = LessonClient(
            notebook,
            timeout=seconds,
            kernel_name="python3",
            extra_arguments=["--log-level=ERROR"],  # no warnings of Jupyter's own in the terminal
            record_timing=False,
            coalesce_streams=True,
            resources={"metadata": {"path": folder}},
        )
        faults = client.run()
    for cell in filter(is_code, notebook.cells):
        widgets = [output.data for output in cell.outputs if VIEW in output.get("data", {})]
        for data in widgets:
            del data[VIEW]
        cell.outputs = [output for output in cell.outputs if output.get("data") not in widgets or len(output.data) > 1]
        address = re.search(r"<[^<>]* at 0x[0-9a-f]+>", json.dumps(cell.outputs))
        if address and "raises-exception" not in cell.metadata.get("tags", []):
            faults.append(f"{where(cell)}: prints {address[0]}, another each time; end with plt.show() or _ = ...")
    notebook.metadata = METADATA  # without the state of widgets and the kernel's version
    if faults:
        raise LessonError("\n".join(f"{name}: {fault}" for fault in faults))


def to_text(notebook: NotebookNode, name: str) -> str:
    """The file of a notebook, valid and small enough for GitHub to show."""
    nbformat.validate(notebook)
    text: str = nbformat.writes(notebook)
    if (size := len(text.encode())) > SIZE_LIMIT:
        raise LessonError(
            f"{name}: the notebook has {size:,} bytes, and {SIZE_LIMIT:,} are allowed: draw fewer or plainer "
            "figures (a plotly figure carries megabytes of JavaScript)"
        )
    return text


def is_current(path: Path, notebook: NotebookNode) -> bool:
    """Whether the notebook at a path is what its source makes; outputs count for nothing in solutions, only there."""
    if not path.exists():
        return False
    text = path.read_text(encoding="utf-8")
    if path.parent.name == "solutions":
        present = nbformat.reads(text, as_version=nbformat.NO_CONVERT)
        for cell in filter(is_code, present.cells):
            cell.outputs, cell.execution_count = [], None
        text = nbformat.writes(present)
    return bool(text == nbformat.writes(notebook))


def keep_outputs(path: Path, notebook: NotebookNode) -> bool:
    """Take over the outputs of the notebook at a path if no code has changed since, and say whether that was so."""
    if not path.exists():
        return False
    present = nbformat.reads(path.read_text(encoding="utf-8"), as_version=nbformat.NO_CONVERT)
    before, now = (list(filter(is_code, one.cells)) for one in (present, notebook))
    if [cell.source for cell in before] != [cell.source for cell in now]:
        return False
    for cell, old in zip(now, before, strict=True):
        cell.outputs, cell.execution_count = old.outputs, old.execution_count
    notebook.metadata = present.metadata
    return True


def build(source: Path, notebooks: Path, *, execute_again: bool = False) -> list[Path]:
    """Writes the notebooks of a lesson that are not current; where only the text has changed, nothing is executed.

    Args:
        source: The py:percent file of the lesson.
        notebooks: The folder to write to.
        execute_again: Also executes and writes the solutions when their source has not changed, as after a change of
            the package.

    Returns:
        The notebooks that were written.

    Raises:
        LessonError: The lesson breaks a rule or does not run; nothing is written then.
    """
    texts: dict[Path, str] = {}
    for path, notebook in editions(source, notebooks).items():
        solutions = path.parent.name == "solutions"
        if is_current(path, notebook) and not (solutions and execute_again):
            continue
        if solutions and (execute_again or not keep_outputs(path, notebook)):
            start = time.perf_counter()
            execute(notebook, source.stem)
            print(f"{source.stem}: executed in {time.perf_counter() - start:.0f} s")
        texts[path] = to_text(notebook, source.stem)
    for path, text in texts.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")
    return list(texts)


def outdated(source: Path, notebooks: Path) -> list[Path]:
    """The notebooks of a lesson that are missing, or are not what its source makes."""
    return [path for path, notebook in editions(source, notebooks).items() if not is_current(path, notebook)]


def main(arguments: Sequence[str] | None = None, root: Path = ROOT) -> int:
    """The command line.

    Args:
        arguments: What follows the name of the program; those of the process if None.
        root: The checkout: texts are below `src/edugym_course/lessons` in it, notebooks in `notebooks`.

    Returns:
        The exit status: 0, or 1 where a lesson breaks a rule, does not run, or (`--check`) is not up to date.
    """
    parser = argparse.ArgumentParser(description="Build the notebooks of the lessons.")
    parser.add_argument("lessons", nargs="*", metavar="NN_name", help="lessons to build (default: all)")
    parser.add_argument("--check", action="store_true", help="write nothing; fail if a notebook is not up to date")
    parser.add_argument(
        "--flipbooks", action="store_true", help="make the pictures and films of the website, nothing else"
    )
    parser.add_argument("--execute", action="store_true", help="execute solutions again, changed or not")
    options = parser.parse_args(arguments)
    known = lesson_sources(root)
    if unknown := [name for name in options.lessons if name not in known]:
        parser.error(f"no lesson {', '.join(unknown)}; there are: {', '.join(known) or 'none'}")
    sources = [known[name] for name in options.lessons or known]
    notebooks = root / "notebooks"
    try:
        if options.check:
            present = [path for pattern in ("*.ipynb", "[!.]*/*.ipynb") for path in notebooks.glob(pattern)]
            stale = [path for path in sorted(present) if path.stem not in known]  # no source any more
            stale += [path for source in sources for path in outdated(source, notebooks)]
            for path in stale:
                print(f"not what its source makes: {path.relative_to(root)}", file=sys.stderr)
            turned = [path for source in sources for path in flipbooks.outdated(source.stem, notebooks)]
            for path in turned:
                again = f"python lessons/build.py --flipbooks {path.parent.name}"
                print(f"missing, or of a cell that has changed: {path.relative_to(root)}; {again}", file=sys.stderr)
            return 1 if stale or turned else 0
        if options.flipbooks:
            faults = [
                f"{source.stem}: {fault}" for source in sources for fault in flipbooks.make(source.stem, notebooks)
            ]
            if faults:
                raise LessonError("\n".join(faults))
            return 0
        for source in sources:
            for path in build(source, notebooks, execute_again=options.execute):
                print(f"wrote {path.relative_to(root)}")
    except LessonError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

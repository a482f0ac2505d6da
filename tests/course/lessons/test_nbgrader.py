"""The teachers' edition in nbgrader itself: it is handed out, comes back, and is graded."""

import dis
import importlib.util
import os
import subprocess
import sys
from copy import deepcopy
from pathlib import Path
from types import CodeType

import build
import nbformat
import pytest
from nbformat import NotebookNode
from rules import is_check, is_code, is_exercise, without_marks

from tests.course.lab.browser import CHROMIUM, DRIVER
from tests.course.lessons.answers import is_imports

LESSONS = list(build.lesson_sources().values())
QUICKEST = next(path for path in LESSONS if path.parent.name == "memory")
BROWSER = bool(CHROMIUM and DRIVER and importlib.util.find_spec("selenium"))
"""Whether all cells run in a browser, in another test: then those that no grade depends on do not run here again."""


def nbgrader(course: Path, *arguments: str) -> None:
    """Run a command of nbgrader in a course."""
    command = [sys.executable, "-m", "nbgrader", *arguments]
    scripts = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"  # nbgrader runs `alembic`
    own = {"JUPYTER_CONFIG_DIR": str(course / "configuration"), "PATH": scripts}
    made = subprocess.run(command, cwd=course, env=os.environ | own, capture_output=True, text=True)
    assert made.returncode == 0, made.stderr


def submit(course: Path, student: str, notebook: NotebookNode, name: str) -> None:
    """Hand in what a student has made of a lesson."""
    folder = course / "submitted" / student / name
    folder.mkdir(parents=True)
    nbformat.write(notebook, folder / f"{name}.ipynb")


def without_demonstrations(notebook: NotebookNode, runs: dict[str, str]) -> NotebookNode:
    """Return a notebook with nothing but imports, what runs in exercises and checks, and what it uses."""
    short = deepcopy(notebook)
    wanted: set[str] = set()
    for cell in reversed(list(filter(is_code, short.cells))):
        used, given = names(runs.get(cell.id, cell.source))
        if cell.id in runs or is_imports(cell) or given & wanted:
            wanted = (wanted - given) | used
        else:
            cell.source = ""
    return short


def names(code: str | CodeType) -> tuple[set[str], set[str]]:
    """Return the names that code needs from the cells above it, and those that it gives a value.

    What it first gives a value itself it does not need: the name of a loop, say.
    """
    used: set[str] = set()
    given: set[str] = set()
    for step in dis.get_instructions(compile(code, "cell", "exec") if isinstance(code, str) else code):
        if step.opname == "STORE_NAME":
            given.add(step.argval)
        elif step.opname in ("LOAD_NAME", "LOAD_GLOBAL", "LOAD_FROM_DICT_OR_GLOBALS"):
            used |= {step.argval} - given
        elif isinstance(step.argval, CodeType):  # of a function, a class or a comprehension
            used |= names(step.argval)[0] - given
    return used, given


@pytest.mark.skipif(importlib.util.find_spec("nbgrader") is None, reason="nbgrader is not installed")
@pytest.mark.parametrize(
    ("path", "in_short"),
    [(QUICKEST, True), *(pytest.param(path, BROWSER, marks=pytest.mark.slow) for path in LESSONS)],
    ids=lambda value: value.stem if isinstance(value, Path) else "",
)
def test_solutions_get_full_marks_and_blanks_none(path: Path, in_short: bool, tmp_path: Path) -> None:
    """What is handed out has no solution; each student fills in the cells that are theirs and no others."""
    from nbgrader.api import Gradebook

    name, lesson = path.stem, build.read_lesson(path)
    source = tmp_path / "source" / name / f"{name}.ipynb"
    source.parent.mkdir(parents=True)
    nbformat.write(build.teacher_edition(lesson), source)
    nbgrader(tmp_path, "generate_assignment", name)
    released = nbformat.read(tmp_path / "release" / name / f"{name}.ipynb", as_version=4)
    assert not any("### BEGIN" in cell.source for cell in released.cells)
    cells = list(filter(is_code, released.cells))
    exercises = {cell.id: without_marks(cell.source) for cell in filter(is_exercise, lesson.cells)}
    checks = {cell.id: without_marks(cell.source) for cell in filter(is_check, lesson.cells)}
    placeholders = {cell.id: cell.source for cell in cells if cell.metadata.get("nbgrader", {}).get("solution")}
    assert placeholders.keys() == exercises.keys()

    blank, solved = deepcopy(released), deepcopy(released)
    for cell in filter(is_code, solved.cells):
        cell.source = exercises.get(cell.id, cell.source)
    if in_short:
        solved = without_demonstrations(solved, exercises | checks)
        blank = without_demonstrations(blank, placeholders | dict.fromkeys(checks, "check"))  # the first call raises
    submit(tmp_path, "blank", blank, name)
    submit(tmp_path, "solved", solved, name)

    nbgrader(tmp_path, "autograde", name, f"--Execute.timeout={10 * build.CELL_SECONDS}")
    with Gradebook(f"sqlite:///{tmp_path / 'gradebook.db'}") as gradebook:
        rows = gradebook.assignment_submissions(name)
        scores = {row.student.id: (row.score, row.max_score) for row in rows}
    graded = {
        student: nbformat.read(tmp_path / "autograded" / student / name / f"{name}.ipynb", as_version=4).cells
        for student in ("blank", "solved")
    }
    for cell in filter(is_code, graded["solved"]):
        assert not [output for output in cell.outputs if output.output_type == "error"], cell.source
        assert not [output for output in cell.outputs if output.get("name") == "stderr"], cell.source
    for cell in filter(is_check, graded["blank"]):
        said = [output.evalue for output in cell.outputs if output.output_type == "error"]
        assert len(said) == 1, cell.source
        assert "ot solved yet" in said[0] or "began" in said[0]
    points = sum(cell.metadata.get("points", 1) for cell in lesson.cells if "check" in cell.metadata.get("tags", []))
    assert scores == {"blank": (0, points), "solved": (points, points)}

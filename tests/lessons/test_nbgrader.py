"""The teachers' edition in nbgrader itself: it is handed out, comes back, and is graded."""

import ast
import csv
import importlib.util
import os
import subprocess
import sys
from collections.abc import Iterable
from copy import deepcopy
from pathlib import Path

import build
import nbformat
import pytest
from nbformat import NotebookNode
from rules import is_check, is_code, is_exercise, without_marks

from tests.lab.browser import CHROMIUM, DRIVER
from tests.lessons.answers import is_imports

ASSIGNMENT = "lesson"
BROWSER = CHROMIUM and DRIVER and importlib.util.find_spec("selenium")
"""Whether all cells run in a browser, in another test: then those that no grade depends on do not run here again."""


def nbgrader(course: Path, *arguments: str) -> None:
    """Run a command of nbgrader in a course."""
    command = [sys.executable, "-m", "nbgrader", *arguments]
    scripts = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"  # nbgrader runs `alembic`
    own = {"JUPYTER_CONFIG_DIR": str(course / "configuration"), "PATH": scripts}
    made = subprocess.run(command, cwd=course, env=os.environ | own, capture_output=True, text=True)
    assert made.returncode == 0, made.stderr


def submit(course: Path, student: str, notebook: NotebookNode, name: str) -> None:
    """Hand in what a student has made of the notebook."""
    folder = course / "submitted" / student / ASSIGNMENT
    folder.mkdir(parents=True)
    nbformat.write(notebook, folder / name)


def without_demonstrations(notebook: NotebookNode, solutions: Iterable[str]) -> NotebookNode:
    """Return a notebook with nothing but imports, exercises, their checks, and what these or their solutions use.

    Other cells of code are empty.
    """
    short = deepcopy(notebook)
    cells = list(filter(is_code, short.cells))
    wanted = {name for code in solutions for name in names(code)[0]}
    for cell in reversed(cells):
        used, given = names(cell.source)
        if "nbgrader" in cell.metadata or is_imports(cell) or given & wanted:
            wanted |= used
        else:
            cell.source = ""
    return short


def names(code: str) -> tuple[set[str], set[str]]:
    """Return the names that code uses, and those that it gives a value."""
    nodes = [node for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Name)]
    used = {node.id for node in nodes if isinstance(node.ctx, ast.Load)}
    defined = {node.name for node in ast.walk(ast.parse(code)) if isinstance(node, ast.ClassDef | ast.FunctionDef)}
    return used, {node.id for node in nodes if isinstance(node.ctx, ast.Store)} | defined


@pytest.mark.slow
@pytest.mark.skipif(importlib.util.find_spec("nbgrader") is None, reason="nbgrader is not installed")
@pytest.mark.parametrize("path", sorted((build.ROOT / "lessons").glob("[0-9][0-9]_*.py")), ids=lambda path: path.stem)
def test_solutions_get_full_marks_and_blanks_none(path: Path, tmp_path: Path) -> None:
    """What is handed out has no solution; each student fills in the cells that are theirs and no others."""
    lesson = build.read_lesson(path)
    source = tmp_path / "source" / ASSIGNMENT / f"{path.stem}.ipynb"
    source.parent.mkdir(parents=True)
    nbformat.write(build.teacher_edition(lesson), source)
    nbgrader(tmp_path, "generate_assignment", ASSIGNMENT)

    released = nbformat.read(tmp_path / "release" / ASSIGNMENT / source.name, as_version=4)
    assert not any("### BEGIN" in cell.source for cell in released.cells)
    solutions = {cell.id: without_marks(cell.source) for cell in filter(is_exercise, lesson.cells)}
    released = without_demonstrations(released, solutions.values()) if BROWSER else released
    submit(tmp_path, "blank", released, source.name)
    for cell in filter(is_code, released.cells):
        assert (cell.id in solutions) is bool(cell.metadata.get("nbgrader", {}).get("solution"))
        cell.source = solutions.get(cell.id, cell.source)
    submit(tmp_path, "solved", released, source.name)

    nbgrader(tmp_path, "autograde", ASSIGNMENT, f"--Execute.timeout={10 * build.CELL_SECONDS}")
    nbgrader(tmp_path, "export", f"--to={tmp_path / 'grades.csv'}")
    with (tmp_path / "grades.csv").open() as file:
        scores = {row["student_id"]: (float(row["score"]), float(row["max_score"])) for row in csv.DictReader(file)}
    graded = {
        student: nbformat.read(tmp_path / "autograded" / student / ASSIGNMENT / source.name, as_version=4).cells
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

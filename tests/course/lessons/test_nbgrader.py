"""The teachers' edition in nbgrader itself: it is handed out, comes back, and is graded."""

import importlib.util
import os
import subprocess
import sys
from copy import deepcopy
from pathlib import Path

import build
import nbformat
import pytest
from nbformat import NotebookNode
from rules import is_check, is_code, is_exercise, is_project, without_marks

from tests.course.lessons.test_build import LESSON


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


@pytest.mark.skipif(importlib.util.find_spec("nbgrader") is None, reason="nbgrader is not installed")
@pytest.mark.slow
@pytest.mark.parametrize("lesson", ["", *build.lesson_sources()])
def test_solutions_get_full_marks_and_blanks_none(lesson: str, tmp_path: Path) -> None:
    """What is handed out has no solution; each student fills in the cells that are theirs; quickly in a tiny lesson."""
    from nbgrader.api import Gradebook

    name, tiny = lesson or "01_doubling", tmp_path / "01_doubling.py"
    # nbgrader may miss that a cell with `interact` has ended (https://github.com/jupyter/nbclient/issues/312)
    text = LESSON.replace("import ipywidgets\n", "from edugym_course.notebook import sliders\n")
    tiny.write_text(text.replace("ipywidgets.interact(", "sliders("), encoding="utf-8")
    notebook = build.read_lesson(build.lesson_sources().get(lesson, tiny))
    source = tmp_path / "source" / name / f"{name}.ipynb"
    source.parent.mkdir(parents=True)
    nbformat.write(build.teacher_edition(notebook), source)
    nbgrader(tmp_path, "generate_assignment", name)
    released = nbformat.read(tmp_path / "release" / name / f"{name}.ipynb", as_version=4)
    assert not any("### BEGIN" in cell.source for cell in released.cells)
    cells = list(filter(is_code, released.cells))
    exercises = {cell.id: without_marks(cell.source) for cell in filter(is_exercise, notebook.cells)}
    assert {cell.id for cell in cells if cell.metadata.get("nbgrader", {}).get("solution")} == exercises.keys()

    programs = {cell.id: without_marks(cell.source) for cell in filter(is_project, notebook.cells)}
    blank, solved, renamed = (deepcopy(released) for _ in range(3))
    for cell in filter(is_code, solved.cells):
        cell.source = (exercises | programs).get(cell.id, cell.source)
    for cell in filter(is_code, renamed.cells):
        if cell.id in exercises:
            cell.source += "\ncheck = exercise_1 = exercise_2 = exercise_3 = exercise_4 = print"
    submit(tmp_path, "blank", blank, name)
    if lesson in ("", "10_own_problem"):  # in others it is the same, and takes a minute each
        submit(tmp_path, "renamed", renamed, name)
    submit(tmp_path, "solved", solved, name)

    seconds = (10 if lesson else 1) * build.CELL_SECONDS
    nbgrader(tmp_path, "autograde", name, f"--Execute.timeout={seconds}")
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
        assert not lesson or "ot solved yet" in said[0] or "began" in said[0]
    points = sum(cell.metadata.get("points", 1) for cell in filter(is_check, notebook.cells))
    assert scores.pop("renamed", (0, points)) == (0, points), "whoever gives `check` another meaning gains nothing"
    assert scores == {"blank": (0, points), "solved": (points, points)}

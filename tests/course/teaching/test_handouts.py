"""Lessons for Otter-Grader and GitHub Classroom: what they hold, and that they grade."""

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import build
import nbformat
import pytest
import yaml
from rules import is_exercise, without_marks
from typer.testing import CliRunner

from edugym_course import commands
from edugym_course.grading.errors import Unsolved

LESSON = "00_loop"
EMPTY, RIGHT = [0, 0, 0], [1, 1, 2]


@pytest.fixture(scope="module")
def lesson() -> Any:
    """The teacher's notebook of a lesson."""
    return build.teacher_edition(build.read_lesson(build.lesson_sources()[LESSON]))


def handed_out(lesson: Any, system: str, folder: Path) -> Path:
    """What the command makes for a system."""
    nbformat.write(lesson, folder / f"{LESSON}.ipynb")
    arguments = ["handout", str(folder / f"{LESSON}.ipynb"), "--for", system, "--output", str(folder / system)]
    ran = CliRunner().invoke(commands.app, arguments)
    assert ran.exit_code == 0, ran.output
    return folder / system


def solutions(lesson: Any) -> list[str]:
    """The solutions of a lesson, in order."""
    return [without_marks(cell.source) for cell in lesson.cells if is_exercise(cell)]


def solve(notebook: Any, answers: list[Any], solved: list[str]) -> None:
    """Write solutions into the cells of the answers."""
    for cell, source in zip(answers, solved, strict=True):
        assert "raise NotImplementedError" in cell.source
        cell.source = source


def run(command: str, folder: Path) -> int:
    """Run a line of a workflow as GitHub does, with this interpreter."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    set_up = {"PATH": path, "GITHUB_STEP_SUMMARY": str(folder / "summary.md")}
    return subprocess.run(["bash", "-ec", command], cwd=folder, env=os.environ | set_up, check=False).returncode


def test_a_repository_for_github_classroom(lesson: Any, tmp_path: Path) -> None:
    """Its workflow has a test for each exercise, with its points, and reports them all; it holds no solution."""
    folder = handed_out(lesson, "classroom", tmp_path)
    workflow = yaml.safe_load((folder / ".github" / "workflows" / "classroom.yml").read_text())
    steps = workflow["jobs"]["grade"]["steps"]
    tests = {step["id"]: step["with"] for step in steps if "id" in step}
    assert [test["max-score"] for test in tests.values()] == RIGHT
    assert steps[-1]["with"]["runners"].split(",") == [*tests]
    assert steps[-1]["env"] == {f"{name.upper()}_RESULTS": f"${{{{ steps.{name}.outputs.result }}}}" for name in tests}
    everything = "\n".join(path.read_text() for path in folder.rglob("*") if path.is_file())
    for solution in solutions(lesson):
        assert json.dumps(solution.splitlines()[-1])[1:-1] not in everything


@pytest.mark.slow
@pytest.mark.parametrize("points", [EMPTY, RIGHT], ids=["empty", "right"])
def test_the_workflow_grades(points: list[int], lesson: Any, tmp_path: Path) -> None:
    """The commands of the workflow fail just for the exercises that are not solved."""
    folder = handed_out(lesson, "classroom", tmp_path)
    notebook = nbformat.read(folder / f"{LESSON}.ipynb", as_version=nbformat.NO_CONVERT)
    answers = [cell for cell in notebook.cells if cell.metadata.get("nbgrader", {}).get("solution")]
    if points == RIGHT:
        solve(notebook, answers, solutions(lesson))
    nbformat.write(notebook, folder / f"{LESSON}.ipynb")
    workflow = yaml.safe_load((folder / ".github" / "workflows" / "classroom.yml").read_text())
    steps = {step.get("name"): step for step in workflow["jobs"]["grade"]["steps"]}
    assert run(steps["Grade"]["run"], folder) == 0
    tests = [step["with"] for step in steps.values() if "id" in step]
    assert [test["max-score"] * (run(test["command"], folder) == 0) for test in tests] == points
    assert "exercise 1" in (folder / "summary.md").read_text()


def test_a_master_notebook_for_otter(lesson: Any, tmp_path: Path) -> None:
    """Two hidden tests an exercise accept its solution, and say that what students get is not solved yet."""
    master = nbformat.read(handed_out(lesson, "otter", tmp_path) / f"{LESSON}.ipynb", as_version=nbformat.NO_CONVERT)
    tests = [cell.source for cell in master.cells if cell.source.startswith("# HIDDEN")]
    assert len(tests) == 2 * len(RIGHT)
    both = [cell.source for cell in master.cells if "# BEGIN SOLUTION NO PROMPT" in cell.source]
    parts = [source.partition("''' # BEGIN PROMPT\n") for source in both]
    solved = {name: value for part in parts for name, value in executed(part[0], lesson).items()}
    unsolved = {
        name: value
        for part in parts
        for name, value in executed(part[2].removesuffix("\n'''; # END PROMPT"), lesson).items()
    }
    for source in tests:
        passes = executed(source, lesson)["passes"]
        passes(solved)
        with pytest.raises(Unsolved):
            passes(unsolved)


def executed(source: str, lesson: Any) -> dict[str, Any]:
    """The names that a cell of a lesson defines, after the imports of the lesson."""
    imports = next(cell.source for cell in lesson.cells if cell.source.startswith(("import ", "from ")))
    names: dict[str, Any] = {}
    exec(f"{imports}\n{source}", names)
    return names


@pytest.mark.slow
@pytest.mark.skipif(importlib.util.find_spec("otter") is None, reason="needs Otter: pip install otter-grader")
def test_otter_grades(lesson: Any, tmp_path: Path) -> None:
    """All points for the solutions, and none for what students get, or for another `check`."""
    folder = handed_out(lesson, "otter", tmp_path)
    otter = [sys.executable, "-m", "otter"]
    subprocess.run([*otter, "assign", str(folder / f"{LESSON}.ipynb"), "made"], cwd=tmp_path, check=True)
    archive = next((tmp_path / "made" / "autograder").glob("*.zip"))
    for name, points in {"empty": EMPTY, "right": RIGHT, "cheating": EMPTY}.items():
        notebook = nbformat.read(tmp_path / "made" / "student" / f"{LESSON}.ipynb", as_version=nbformat.NO_CONVERT)
        answers = [cell for cell in notebook.cells if "otter_answer_cell" in cell.metadata.get("tags", [])]
        if name == "right":
            solve(notebook, answers, solutions(lesson))
        if name == "cheating":
            answers[0].source = "check = lambda *given, **more: None\nexercise_1 = None"
        (tmp_path / name).mkdir()
        nbformat.write(notebook, tmp_path / name / f"{LESSON}.ipynb")
        command = [*otter, "run", "-a", str(archive), "-o", name, f"{name}/{LESSON}.ipynb"]
        subprocess.run(command, cwd=tmp_path, check=True)
        results = json.loads((tmp_path / name / "results.json").read_text())["tests"]
        assert [test["score"] for test in results if test["name"].startswith("exercise")] == points


@pytest.mark.parametrize("system", ["otter", "classroom"])
def test_a_notebook_without_exercises_is_refused(system: str, tmp_path: Path) -> None:
    """In one sentence."""
    nbformat.write(nbformat.v4.new_notebook(), tmp_path / "empty.ipynb")
    arguments = ["handout", str(tmp_path / "empty.ipynb"), "--for", system, "--output", str(tmp_path)]
    ran = CliRunner().invoke(commands.app, arguments)
    assert ran.exit_code == 2
    assert "teacher's notebook" in " ".join(ran.output.split())

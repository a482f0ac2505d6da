"""The template of a lesson, from which teachers start: its checks, and the lesson that a copy of it makes."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import build
import pytest

import edugym_course.lessons
from edugym_course.grading.errors import folded
from edugym_course.lessons import lesson_names
from tests.course.lessons.answers import read_answers, read_exercises, verdict

TEMPLATE = build.ROOT / "lessons" / "template"


def test_answers_of_the_template(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Its checks tell right answers from wrong ones, in the sentences that the answers name."""
    monkeypatch.setattr(edugym_course.lessons, "__path__", [*edugym_course.lessons.__path__, str(TEMPLATE.parent)])
    monkeypatch.setattr(build, "lesson_sources", lambda: {"99_template": TEMPLATE / "99_template.py"})
    assert lesson_names()[-1] == "template"
    imports, exercises = read_exercises(TEMPLATE / "99_template.py")
    setup, answers = read_answers("99_template")
    for answer in answers:
        said = verdict(answer, exercises[answer.exercise - 1], (imports, setup))
        told = capsys.readouterr().out if answer.right else said
        assert (said == "") == answer.right
        assert [words for words in answer.says if (folded(f"✓ {words}") if answer.right else words) not in told] == []
    assert {(answer.exercise, answer.right) for answer in answers} == {(k, r) for k in (1, 2) for r in (True, False)}


@pytest.mark.slow
def test_the_template_is_a_lesson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Copied to the place of a lesson it makes three notebooks, runs from top to bottom, and its claims hold."""
    course = tmp_path / "src" / "edugym_course"
    shutil.copytree(build.ROOT / "src" / "edugym_course", course, ignore=shutil.ignore_patterns("[0-9]*_*.py"))
    shutil.copytree(TEMPLATE, course / "lessons" / "template")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(map(str, (course.parent, build.ROOT / "src"))))
    assert build.main([], tmp_path) == 0
    assert len([*(tmp_path / "notebooks").rglob("99_template.ipynb")]) == 3
    code = "from edugym_course.lessons.template.experiments import report; print(all(c.holds for c in report().claims))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "True\n"

"""The start page, and the record of solved exercises that it shows."""

import re
from pathlib import Path

import pytest

from edugym_course.lab import lessons
from edugym_course.lab.progress import record_passed
from edugym_course.lab.records import PASSED, passed
from edugym_course.lab.server import prepare
from edugym_course.lab.start_page import START_PAGE, write_start_page
from tests.course.lab.conftest import notebook


@pytest.fixture
def folder(tmp_path: Path, shipped: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A student's folder, which is the present folder."""
    prepare(tmp_path / "mine")
    monkeypatch.chdir(tmp_path / "mine")
    return tmp_path / "mine"


def test_it_shows_what_is_done(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A check may pass often, in a folder inside the student's; the page is never the student's own work by that."""
    (folder / "deeper").mkdir()
    monkeypatch.chdir(folder / "deeper")
    for _ in range(2):
        record_passed("01_doubling", 1)
        record_passed("doubling", 7)  # an exercise of a later version
    assert passed(folder, "doubling") == {1, 7}
    assert len((folder / PASSED).read_text().splitlines()) == 2
    assert "1 of 1 solved ✓" in (folder / START_PAGE).read_text()
    assert [path.name for path in folder.glob("*.md")] == [START_PAGE]
    (folder / PASSED).unlink()
    (folder / PASSED).mkdir()
    record_passed("doubling", 1)  # a record that cannot be written is no error: the check has passed all the same
    monkeypatch.chdir(folder.parent)
    before = sorted(folder.parent.rglob("*"))
    record_passed("doubling", 2)  # a notebook on Colab, or under nbgrader, leaves no file
    assert sorted(folder.parent.rglob("*")) == before


def test_every_lesson_of_the_course_can_be_shown(tmp_path: Path) -> None:
    """All have a title, a challenge, a time, knowledge that is needed, and exercises."""
    found = lessons.student_lessons()
    text = write_start_page(tmp_path).read_text()
    assert re.findall(r"\*\*(\w+)\. \[", text) == [lesson.number for lesson in found]
    assert len(found) > 9
    for lesson in found:
        assert lesson.title
        assert lesson.exercises >= 2
        assert all(lesson.part(label) for label in ("The challenge", "Time", "Before you start")), lesson.name


def test_files_do_not_depend_on_the_language_of_the_computer() -> None:
    """Each is read and written with an encoding."""
    files = {path: path.read_text(encoding="utf-8") for path in Path(str(lessons.__file__)).parents[1].rglob("*.py")}
    calls = [(path, line) for path, code in files.items() for line in re.findall(r"\.(?:read|write)_text\(.*", code)]
    assert len(calls) >= 5
    assert [(path, line) for path, line in calls if "encoding=" not in line] == []


def test_new_versions_are_told_and_linked(folder: Path, shipped: Path) -> None:
    """One sentence for each lesson that has been changed."""
    page = folder / START_PAGE
    assert "<br>Small \\| numbers.<br>**Time.** 1 minute." in page.read_text()
    assert "0 of 1 solved |" in page.read_text()
    assert prepare(folder) == []
    (folder / "01_doubling.ipynb").write_text("mine")
    (shipped / "01_doubling.ipynb").write_text(notebook("2 + 2"))
    [said] = prepare(folder)
    assert re.search(r"01_doubling\.ipynb.*01_doubling_new_version\.ipynb", said)
    assert "([01_doubling_new_version](01_doubling_new_version.ipynb))" in page.read_text()

"""Fresh files in a student's folder, and never over the student's work."""

import json
from pathlib import Path

import pytest

from edugym_course.lab.delivery import deliver, versions
from edugym_course.lab.records import DELIVERED
from tests.course.lab.conftest import notebook

FIRST, SECOND, THIRD, FOURTH = (notebook(f"{n} + {n}") for n in range(4))
MINE = notebook("my own work")


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """The place of a lesson in a student's folder, with its first version."""
    assert deliver(FIRST, tmp_path / "lesson.ipynb") == tmp_path / "lesson.ipynb"
    return tmp_path / "lesson.ipynb"


def names(path: Path) -> list[str]:
    """The notebooks in the folder."""
    return sorted(place.name for place in path.parent.glob("*.ipynb"))


def test_whose_file_it_is(path: Path) -> None:
    """An untouched one is replaced, one without a record is the student's, and one that was deleted comes back."""
    assert deliver(SECOND, path) == path
    assert path.read_text() == SECOND
    assert names(path) == ["lesson.ipynb"]
    (path.parent / DELIVERED).write_bytes(b"\xff")  # damaged: it costs nobody's work
    assert deliver(SECOND, path) == path
    assert deliver(THIRD, path) != path
    assert path.read_text() == SECOND
    path.unlink()
    deliver(THIRD, path)
    assert path.read_text() == THIRD


def test_what_the_student_changed_stays(path: Path) -> None:
    """Newer versions come beside it, each in the place of the last one while that is untouched."""
    path.write_text(MINE)
    assert deliver(FIRST, path) == path  # there is nothing new
    beside = path.with_name("lesson_new_version.ipynb")
    assert deliver(SECOND, path) == deliver(SECOND, path) == beside
    assert deliver(THIRD, path) == beside
    assert (path.read_text(), beside.read_text()) == (MINE, THIRD)
    beside.write_text(MINE)
    assert deliver(THIRD, path) == beside
    assert deliver(FOURTH, path) == path.with_name("lesson_new_version_2.ipynb")
    assert (path.read_text(), beside.read_text()) == (MINE, MINE)
    assert versions(path) == [path, beside, path.with_name("lesson_new_version_2.ipynb")]


def test_running_a_lesson_does_not_change_it(path: Path) -> None:
    """Outputs, and the form in which JupyterLab writes lines, are no changes; they stay while there is nothing new."""
    run = json.loads(FIRST)
    run["cells"][0]["source"] = run["cells"][0]["source"].splitlines(keepends=True)
    run["cells"][1] |= {"outputs": [{"output_type": "stream"}], "execution_count": 1}
    path.write_text(json.dumps(run))
    deliver(FIRST, path)
    assert json.loads(path.read_text()) == run
    assert deliver(SECOND, path) == path
    assert path.read_text() == SECOND


@pytest.mark.parametrize("damaged", ["", "{", "[1]", '{"cells": [3]}', "\udcff"])
def test_what_is_not_a_notebook_any_more_stays(path: Path, damaged: str) -> None:
    """Who knows what it was."""
    path.write_bytes(damaged.encode(errors="surrogateescape"))
    assert deliver(SECOND, path) != path
    assert path.read_bytes() == damaged.encode(errors="surrogateescape")


def test_a_folder_in_its_place_stays(path: Path) -> None:
    """The lesson goes beside it."""
    path.unlink()
    path.mkdir()
    assert deliver(SECOND, path).name == "lesson_new_version.ipynb"

"""How the experiments of lessons are found."""

from pathlib import Path

import pytest

import edugym_course.lessons
from edugym_course.lessons import lesson_names, load_experiments


@pytest.mark.parametrize("lesson", lesson_names())
def test_every_lesson_has_a_report(lesson: str) -> None:
    """Each module has the one function that all share."""
    assert callable(load_experiments(lesson).report)


def test_a_lesson_is_found_by_its_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A new module needs no list. Lessons come by their numbers, and those without one follow by name."""
    for name, line in (("zebra", ""), ("first", '"""First (lesson 0): it comes first."""'), ("apple", "")):
        (tmp_path / f"{name}.py").write_text(f"{line}\nreport = 'found here'\n")
    monkeypatch.setattr(edugym_course.lessons, "__path__", [*edugym_course.lessons.__path__, str(tmp_path)])
    names = lesson_names()
    assert [name for name in names if name in ("first", "exploration", "apple", "zebra")] == [
        "first", "exploration", "apple", "zebra"
    ]  # fmt: skip
    assert str(load_experiments("zebra").report) == "found here"


def test_unknown_lessons_are_named() -> None:
    """The message lists the lessons."""
    with pytest.raises(ValueError, match=r"lesson must be one of .*'exploration'.* but is 'explore'"):
        load_experiments("explore")

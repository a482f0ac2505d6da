"""What holds for the experiments of every lesson, wherever it is found."""

import ast
import re
import threading
from pathlib import Path

import build
import pytest

import edugym_course.lessons
from edugym_course.lessons import lesson_names, load_experiments
from edugym_course.report import rows_of
from tests.course.lessons.answers import cells_of, read_exercises
from tests.course.lessons.shown import NOTEBOOKS
from tests.messages import named

FOLDER = Path(edugym_course.lessons.__path__[0])


@pytest.mark.parametrize("lesson", lesson_names())
def test_every_claim_is_reported(lesson: str) -> None:
    """What makes claims is used, by its name, in the experiments of the lesson."""
    code = "".join(path.read_text(encoding="utf-8") for path in (FOLDER / lesson).rglob("*.py"))
    makers = {*re.findall(r"^def (\w+_claims?)\(", code, re.MULTILINE)}
    experiments = ast.walk(ast.parse((FOLDER / lesson / "experiments.py").read_text(encoding="utf-8")))
    assert makers
    assert makers <= {node.id for node in experiments if isinstance(node, ast.Name)}


@pytest.mark.parametrize("lesson", lesson_names())
def test_a_stopped_lesson_claims_nothing(lesson: str) -> None:
    """Comparisons of incomplete results would mean nothing; finished runs are kept in the folder, if one is given."""
    stop = threading.Event()
    stop.set()
    assert load_experiments(lesson).report(repetitions=2, stop=stop) == ([], [])


@pytest.mark.slow
@pytest.mark.parametrize("lesson", lesson_names())
def test_every_claim_holds(lesson: str) -> None:
    """With other seeds than those that the lesson shows."""
    claims = load_experiments(lesson).report(seed=7).claims
    assert claims
    assert [claim.statement for claim in claims if not claim.holds] == []
    rows_of(claims)  # which knows the claims that test a reason


def test_a_lesson_is_found_by_its_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A new folder needs no list: lessons come by their numbers, then by name; one that is unknown is named."""
    for name, line in (
        ("zebra", ""),
        ("first", '"""First (lesson 0): it comes first."""'),
        ("next", '"""Next (lesson 0b)."""'),
        ("apple", ""),
    ):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text(f"{line}\n")
        (tmp_path / name / "experiments.py").write_text("report = 'found here'\n")
    monkeypatch.setattr(edugym_course.lessons, "__path__", [*edugym_course.lessons.__path__, str(tmp_path)])
    names = lesson_names()
    assert [name for name in names if name in ("first", "next", "exploration", "apple", "zebra")] == [
        "first", "next", "exploration", "apple", "zebra"
    ]  # fmt: skip
    assert str(load_experiments("zebra").report) == "found here"
    with pytest.raises(ValueError, match=named("lesson", "'exploration'", "'explore'")):
        load_experiments("explore")


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_every_check_checks_what_stands_before_it(lesson: str) -> None:
    """In order, for one to five points; code is checked again with another seed, and says nothing then."""
    n_hidden = 0
    for number, exercise in enumerate(read_exercises(NOTEBOOKS[lesson])[1], start=1):
        visible, *hidden = exercise.check.splitlines()
        name = visible.removeprefix(f"check(exercise_{number}, ").removesuffix(")")
        is_code = re.search(rf"^(def|class) {name}\b", exercise.solution, re.MULTILINE) is not None
        assert is_code or re.search(rf"^{name} = ", exercise.solution, re.MULTILINE), visible
        assert hidden == [f"check(exercise_{number}, {name}, seed=1, quiet=True)"] * is_code
        n_hidden += is_code
    cells = cells_of(NOTEBOOKS[lesson])
    assert sum("\n### BEGIN HIDDEN TESTS\n" in cell.source for cell in cells) == n_hidden
    assert {cell.metadata.get("points", 1) for cell in cells} <= {*range(1, 6)}


def test_the_hours_of_the_course_plans_are_those_that_the_lessons_announce() -> None:
    """Main path and exercises together, for every lesson."""
    hours: list[tuple[str, tuple[str, str]]] = []
    text = (build.ROOT / "docs" / "course-plans.md").read_text(encoding="utf-8")
    for row, last in re.findall(r"^(\|.*/notebooks/.*\|) (\d:\d\d.*) \|$", text, re.MULTILINE):
        names, times = re.findall(r"/notebooks/(\w+)\.ipynb\)", row), re.findall(r"(\d):(\d\d)", last)
        hours += zip(names, times, strict=True)
    assert {name for name, _ in hours} == build.lesson_sources().keys()
    for name, (hour, minute) in hours:
        opening = cells_of(build.lesson_sources()[name])[0].source
        path, exercises = re.findall(r"About (\d+) minutes.* (\d+) more for the exercises", opening)[0]
        assert 60 * int(hour) + int(minute) == int(path) + int(exercises), name

"""What holds for the experiments of every lesson, wherever it is found."""

import ast
import re
import threading
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import build
import pytest

import edugym_course.lessons
from edugym_course.lessons import lesson_names, load_experiments
from edugym_course.report import rows_of
from tests.course.lessons.shown import NOTEBOOKS

FOLDER = Path(edugym_course.lessons.__path__[0])
NO_SENTENCE = re.compile(
    r"(?i:and|but|nor|or|so|than|then|that|which|who|whose|it|its|they|their|this|these|too|also)\b|[a-z]{2,}"
)
"""What begins a statement that needs the one before it: such a word, or a small letter (but `n = 1` may begin one)."""


def code(folder: Path) -> Iterator[tuple[Path, ast.AST]]:
    """Yield the parts of all code in a folder, with their files."""
    for path in sorted(folder.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            yield path, node


def statements() -> Iterator[tuple[str, str]]:
    """Yield file and line of every claim in the code of the lessons, and how its statement begins.

    The beginning is empty where it is computed, as in `f"{method} solves ..."`.
    """
    for path, node in code(FOLDER):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Claim":
            text = node.args[0]
            begins = text.values[0] if isinstance(text, ast.JoinedStr) else text
            yield (
                f"{path.relative_to(FOLDER)}:{node.lineno}",
                str(getattr(begins, "value", "")) * (isinstance(begins, ast.Constant)),
            )


def test_every_claim_is_a_sentence() -> None:
    """It can be understood without the claim above it, as far as its first word tells."""
    found = [*statements()]
    assert len(found) > 150
    assert [(place, statement) for place, statement in found if NO_SENTENCE.match(statement)] == []


@pytest.mark.parametrize("lesson", lesson_names())
def test_every_claim_is_reported(lesson: str) -> None:
    """What makes claims is used, by its name, in the experiments of the lesson."""
    makers = {
        node.name
        for _, node in code(FOLDER / lesson)
        if isinstance(node, ast.FunctionDef) and re.search(r"_claims?$", node.name)
    }
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
    statements = [claim.statement for claim in claims if not claim.statement.startswith("novelty reward ")]  # a label
    assert [statement for statement in statements if NO_SENTENCE.match(statement)] == []


def test_a_lesson_is_found_by_its_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A new folder needs no list: lessons come by their numbers, then by name; one that is unknown is named."""
    for name, line in (("zebra", ""), ("first", '"""First (lesson 0): it comes first."""'), ("apple", "")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text(f"{line}\n")
        (tmp_path / name / "experiments.py").write_text("report = 'found here'\n")
    monkeypatch.setattr(edugym_course.lessons, "__path__", [*edugym_course.lessons.__path__, str(tmp_path)])
    names = lesson_names()
    assert [name for name in names if name in ("first", "exploration", "apple", "zebra")] == [
        "first", "exploration", "apple", "zebra"
    ]  # fmt: skip
    assert str(load_experiments("zebra").report) == "found here"
    with pytest.raises(ValueError, match=r"lesson must be one of .*'exploration'.* but is 'explore'"):
        load_experiments("explore")


VISIBLE = re.compile(r"^check\((exercise_\d), (\w+)\)$", re.MULTILINE)
HIDDEN = re.compile(r"^### BEGIN HIDDEN TESTS\n(.+)\n### END HIDDEN TESTS$", re.MULTILINE)


def checks(lesson: str) -> Iterator[tuple[str, int, bool]]:
    """Yield the source of the cells that check the exercises, their points, and whether the answer is code."""
    cells = build.read_lesson(NOTEBOOKS[lesson]).cells
    for before, cell in pairwise(cells):
        if "check" in cell.metadata.get("tags", []):
            found = VISIBLE.search(cell.source)
            assert found, cell.source
            is_code = re.search(rf"^(def|class) {found[2]}\b", before.source, re.MULTILINE) is not None
            assert is_code or re.search(rf"^{found[2]} = ", before.source, re.MULTILINE), cell.source
            yield cell.source, cell.metadata.get("points", 1), is_code


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_every_check_checks_what_stands_before_it(lesson: str) -> None:
    """In order, for one to five points; code is checked again with another seed, and says nothing then."""
    found = [*checks(lesson)]
    assert found
    for number, (source, points, is_code) in enumerate(found, start=1):
        assert points in range(1, 6)
        visible = VISIBLE.findall(source)
        assert [exercise for exercise, _ in visible] == [f"exercise_{number}"]
        again = f"check(exercise_{number}, {visible[0][1]}, seed=1, quiet=True)"
        assert HIDDEN.findall(source) == ([again] if is_code else [])

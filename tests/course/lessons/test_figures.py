"""What a lesson trains, claims and draws is what `report.txt` and `cells.txt` in its folder say.

All runs are two, short, and made up: what the numbers are means nothing, but whatever is changed in an experiment, a
claim or a figure changes a line. If that is meant, `REWRITE=1 .venv/bin/python -m pytest -k as_written` writes the
files anew: read `git diff`, and commit them. They have no colours, sizes or places.
"""

import os
import re
from collections.abc import Iterable
from pathlib import Path

import pytest

from edugym.experiments.results.claims import Claim
from tests.course.lessons import records
from tests.course.lessons.shown import NOTEBOOKS, check_legends, sheets_of_cells, short_report
from tests.course.lessons.test_measured import SMALL

NO_SENTENCE = re.compile(
    r"(?i:and|but|nor|or|so|than|then|that|which|who|whose|it|its|they|their|this|these|too|also)\b|[a-z]{2,}"
)
"""What begins a statement that needs the one before it: such a word, or a small letter (but `n = 1` may begin one)."""
LONG_REPORTS = {
    *("bandits", "several_agents", "search", "model_based", "profiles", "objectives", "goals", "signal"),
    *("continuous_actions", "dimensionality", "depth"),
}
"""The lessons whose reports take two seconds or more."""
QUICK_CELLS = {"loop", "own_problem"}
"""The lessons whose cells take least. The reports of more lessons are quick, and are compared in the same way."""
COUNTED = "(item|frame|sweep|step|reward|episode|word|run|hit)"
BOUND = re.compile(
    r"at (?:least|most) ([\d.]+)|up to ([\d.]+)(?=,|$)|within ([\d.]+) of each|([\d.]+) or more"
    r"|more than (\w+)fold|(\w+) times less|one in (?P<share>\w+) or more|less than (?P<percent>\d+) %"
)
"""The number that a statement gives as its bound."""
WRONG_PLURAL = re.compile(rf"(?<![\d.])(?<!\d )(?<!= )1 {COUNTED}s\b|(?<![\d.])([02-9]|\d\d+) {COUNTED}\b")


def asks_for_what_it_says(claim: Claim) -> bool:
    """Whether the bounds that a statement names are those that the numbers must keep."""
    asked = [abs(bound) for bound in claim.expected]
    for found in BOUND.finditer(claim.statement):
        said = found[found.lastindex or 0]
        number = float(SMALL.get(said, said))
        number = 1 / number if found["share"] else number / 100 if found["percent"] else number
        if number not in [pytest.approx(bound) for bound in asked]:
            return False
    return True


@pytest.fixture(autouse=True)
def torch_is_there_where_it_is_needed(lesson: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Networks are trained with it."""
    if lesson == "continuous_actions":
        pytest.importorskip("torch")
    monkeypatch.chdir(tmp_path)


def compare(lesson: str, name: str, parts: dict[str, Iterable[str]]) -> None:
    """Compare what a lesson does with the parts of a file in its folder, or write these anew."""
    path = NOTEBOOKS[lesson].with_name(name)
    before = path.read_text(encoding="utf-8") if path.exists() else ""
    now = {title: lines for title, *lines in map(str.splitlines, re.split("^# ", before, flags=re.MULTILINE)[1:])}
    now |= {title: [*lines] for title, lines in parts.items()}
    text = "\n\n".join("\n".join([f"# {title}", *lines]).rstrip("\n") for title, lines in now.items()) + "\n"
    if os.environ.get("REWRITE") or not path.exists():
        path.write_text(text, encoding="utf-8")
        pytest.fail(f"{path} is written anew: read `git diff`, and commit it")
    changed = records.differences(before, text)
    assert not changed, f"{changed}\nIf this is meant: REWRITE=1 .venv/bin/python -m pytest -k as_written"


@pytest.mark.parametrize(
    "lesson", [pytest.param(name, marks=[pytest.mark.slow] * (name in LONG_REPORTS)) for name in NOTEBOOKS]
)
def test_the_report_is_as_written(lesson: str) -> None:
    """What it trains, claims and draws."""
    runs: dict[str, None] = {}
    claims, sheets = short_report(lesson, calls=runs)
    drawn = [*records.figures(sheets)]
    compare(lesson, "report.txt", {"Runs": runs, "Claims": records.claims(claims), "Figures": drawn})
    assert [claim.statement for claim in claims if not asks_for_what_it_says(claim)] == []
    statements = [claim.statement for claim in claims if not claim.statement.startswith("novelty reward ")]  # a label
    panels = [line for line in drawn if not line.startswith(" ")]
    assert [text for text in [*panels, *statements] if WRONG_PLURAL.search(text)] == []
    assert [statement for statement in statements if NO_SENTENCE.match(statement)] == []
    for sheet in sheets:
        check_legends(sheet)


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_the_defaults_are_as_written(lesson: str) -> None:
    """The numbers that its files name, and those that stand for what nobody says."""
    compare(lesson, "report.txt", {"Defaults": records.defaults(NOTEBOOKS[lesson].parent)})


@pytest.mark.parametrize(
    "lesson", [pytest.param(name, marks=[pytest.mark.slow] * (name not in QUICK_CELLS)) for name in NOTEBOOKS]
)
def test_the_cells_are_as_written(lesson: str) -> None:
    """What the cells of a lesson train and draw, and its sliders where they start."""
    runs: dict[str, None] = {}
    sheets = sheets_of_cells(lesson, calls=runs)
    compare(lesson, "cells.txt", {"Runs": runs, "Figures": records.figures(sheets)})
    for sheet in sheets:
        check_legends(sheet)

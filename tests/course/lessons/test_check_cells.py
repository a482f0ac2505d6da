"""The cells that check exercises: each checks its own exercise, and its hidden test checks the same once more."""

import re
from collections.abc import Iterator
from itertools import pairwise

import build
import pytest

from tests.course.lessons.shown import NOTEBOOKS

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

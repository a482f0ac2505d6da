"""The page of the claims is what its data and the lessons make of it."""

import re
from typing import Any

import claims
import pytest

from edugym_course.lessons import lesson_names

ROW: dict[str, Any] = {
    "statement": "It works", "quantity": "share", "expected": "> 0.5", "reason": "", "tested_by": "", "remark": "",
    "estimate": 0.9, "low": 0.8, "high": 1.0, "n": 9, "holds": True,
}  # fmt: skip


def test_the_page_is_current() -> None:
    """Every claim that was measured has its row, and holds."""
    measured, page = claims.read(), claims.PAGE.read_text(encoding="utf-8")
    assert page == claims.page(measured), "run python docs/claims.py"
    rows = [row for found in measured.values() for row in found["claims"]]
    assert len(re.findall(r"^\| \d+ \| .* \| yes \|$", page, re.MULTILINE)) == len(rows) > 0
    assert set(measured) <= set(lesson_names())


def test_the_page_says_what_is_old_and_what_is_missing() -> None:
    """By what a lesson trains and claims, as its report has it."""
    found = {"experiments": claims.experiments_of("loop"), "runs": 20, "claims": [ROW]}
    text = claims.page({"loop": found, "bandits": found})
    parts = dict(part.split("\n", 1) for part in text.split("\n## ")[1:])
    assert "| 1 | It works | 0.9 [0.8, 1], n = 9: share | > 0.5 | yes |" in parts["Lesson 0: the loop"]
    assert claims.OLD not in parts["Lesson 0: the loop"]
    assert claims.OLD in parts["Lesson 0b: bandits"]
    assert all("edugym reproduce" in part for part in list(parts.values())[2:])


def test_what_is_measured_is_kept(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A claim a line, in the order of the course."""
    monkeypatch.setattr(claims, "DATA", tmp_path / "claims.json")
    found = {"experiments": "0", "runs": 2, "claims": [ROW, ROW]}
    claims.write({"bandits": found, "loop": found})
    assert claims.read() == {"loop": found, "bandits": found}
    assert list(claims.read()) == ["loop", "bandits"]
    assert sum("It works" in line for line in claims.DATA.read_text().splitlines()) == 4

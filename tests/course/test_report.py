"""The report on all lessons, word for word."""

from pathlib import Path
from typing import Any

from edugym_course.report import Section, markdown

FIRST: dict[str, Any] = {
    "statement": "A | B", "quantity": "share", "expected": "> 0.5", "reason": "why", "estimate": 0.75, "low": 0.625,
    "high": 0.875, "n": 12.0, "holds": True,
}  # fmt: skip
SECOND = FIRST | {"statement": "C", "reason": float("nan"), "n": 0.0, "holds": False}
REPORT = r"""# What the experiments show

| lesson | claims that hold |
| --- | --- |
| [one](#one) | 1 of 2 |
| [two](#two) | 0 of 0 |

<a id="one"></a>

## One.

Rest of
it.

| claim | measured, with 95 % interval | expected | holds |
| --- | --- | --- | --- |
| A \| B — why | 0.75 [0.625, 0.875]: share | > 0.5 | yes |
| C | not measured: share | > 0.5 | **NO** |

![b](one/b.svg)

![a](one/a.svg)

<a id="two"></a>

## Two.

| claim | measured, with 95 % interval | expected | holds |
| --- | --- | --- | --- |
"""


def test_a_report() -> None:
    """An overview, then for each lesson what was done, its claims and its figures, in the order in which they came."""
    folder = Path("results")
    sections = [
        Section(
            "one", "One.\n\n    Rest of\n    it.\n    ", [FIRST, SECOND], [folder / "one/b.svg", folder / "one/a.svg"]
        ),
        Section("two", "Two.", [], []),
    ]
    assert markdown(sections, folder) == REPORT

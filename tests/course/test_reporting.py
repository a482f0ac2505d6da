"""The form of a lesson's experiments, and the report on all lessons."""

import inspect
import threading
from pathlib import Path
from typing import Any

import pytest

from edugym.experiments.checkpoints import CHECKPOINTS
from edugym.experiments.results.claims import Above, Claim
from edugym.experiments.results.statistics import Interval
from edugym_course.report import Report, Section, explanation, markdown, rows_of
from edugym_course.reporting import SharedArguments, reporting


def test_how_an_experiment_is_run() -> None:
    """What all share, the file of one, and what replaces either."""
    shared = {"repetitions": "7", "seed": 3}
    how, nowhere = SharedArguments(shared, Path("folder")), SharedArguments(shared, None)
    assert how() == nowhere("name") == shared
    assert how("name") == shared | {"save_to": Path("folder/name.csv")}
    assert how("name", seed=4, save_to=None, jobs=1) == {"repetitions": "7", "seed": 4, "save_to": None, "jobs": 1}
    assert how.repetitions == 7


def test_a_report_is_measured_and_judged() -> None:
    """With the caller's arguments; after an interruption nothing is judged."""
    asked: list[SharedArguments] = []

    def measure(how: SharedArguments) -> tuple[Any, ...]:
        asked.append(how)
        return 1, 2

    def judge(one: Any, other: Any) -> Report:
        return Report([one], [other])

    report = reporting(measure, judge, 30)
    assert report() == judge(1, 2)
    stop = threading.Event()
    assert report(repetitions=4, seed=5, jobs=6, progress=True, stop=stop, folder=Path("here")) == report()
    default, given, _ = asked
    assert isinstance(default.shared.pop("stop"), threading.Event)
    shared = {"repetitions": 30, "seed": 0, "jobs": -1, "progress": False, "checkpoints": None}
    assert default == SharedArguments(shared, None)
    assert given.shared.pop("stop") is stop
    assert given.shared.pop("checkpoints") == Path("here") / CHECKPOINTS
    assert given == SharedArguments({"repetitions": 4, "seed": 5, "jobs": 6, "progress": True}, Path("here"))
    stop.set()
    assert report(stop=stop) == Report([], [])
    assert inspect.signature(report).parameters["repetitions"].default == 30


FIRST: dict[str, Any] = {
    "statement": "A | B", "quantity": "share", "expected": "> 0.5", "reason": "why", "estimate": 0.75, "low": 0.625,
    "high": 0.875, "n": 12.0, "holds": True, "tested_by": 2.0, "remark": "as the paper says",
}  # fmt: skip
NOTHING = float("nan")
SECOND = FIRST | {"statement": "C", "tested_by": NOTHING, "remark": NOTHING, "n": 0.0, "holds": False}


def test_a_report() -> None:
    """An overview, then for each lesson what was done, its claims and its figures, in the order in which they came."""
    folder = Path("results")
    sections = [
        Section("one", "One.\n\n    Rest of\n    it.", [FIRST, SECOND], [folder / "one/b.svg", folder / "one/a.svg"]),
        Section("two", "Two.", [], []),
    ]
    lines = [line for line in markdown(sections, folder).splitlines() if line and "---" not in line]
    head, _, *overview = lines[:4]
    assert (head[:2], overview) == ("# ", ["| [one](#one) | 1 of 2 | 1 of 2 |", "| [two](#two) | 0 of 0 | 0 of 0 |"])
    one, two = lines[4:-3], lines[-3:]
    assert one[:4] == ['<a id="one"></a>', "## One.", "Rest of", "it."]
    assert one[5:] == [
        r"| 1 | A \| B — because why (tested by 2) — as the paper says | "
        "0.75 [0.625, 0.875], n = 12: share | > 0.5 | yes |",
        "| 2 | C — our guess: why | not measured: share | > 0.5 | **NO** |",
        "![b](one/b.svg)",
        "![a](one/a.svg)",
    ]
    assert two[:2] == ['<a id="two"></a>', "## Two."]


def test_a_reason_is_tested_by_claims_of_the_same_report() -> None:
    """The row has their numbers; one that is not there is an error, which names both."""
    first = Claim("A", "share", Interval(1.0, 1.0, 1.0, 3), Above(0.5), "why", ("C", "B"))
    others = [Claim(name, "share", first.measured, Above(0.5)) for name in "BC"]
    rows = rows_of([first, *others])
    assert [row["tested_by"] for row in rows] == ["3, 2", "", ""]
    assert explanation(rows[0]) == ["because why (tested by 3, 2)"]
    with pytest.raises(ValueError, match=r"'A'.*'C'"):
        rows_of([first])

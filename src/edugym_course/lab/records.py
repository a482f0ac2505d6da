"""The records in a student's folder: text files with one line for each entry, in a hidden folder.

Lines are only ever added, so that notebooks which run at the same time can write to the same record.
"""

import re
from pathlib import Path

HIDDEN = Path(".edugym")
"""The folder with the records, inside a student's folder."""

DELIVERED = HIDDEN / "delivered.txt"
"""The files that were put into the folder: fingerprint and name."""

PASSED = HIDDEN / "passed.txt"
"""The exercises that were solved: lesson and number."""


def read_lines(record: Path) -> list[str]:
    """The lines of a record; none if it does not exist or is damaged."""
    try:
        return record.read_text(encoding="utf-8").splitlines()
    except (OSError, ValueError):
        return []


def append_line(record: Path, line: str) -> None:
    """Add a line to a record.

    Raises:
        OSError: it cannot be written.
    """
    record.parent.mkdir(parents=True, exist_ok=True)
    with record.open("a", encoding="utf-8", newline="\n") as file:
        file.write(f"{line}\n")


def passed(folder: Path, lesson: str) -> set[int]:
    """The numbers of the exercises of a lesson that were solved in a student's folder."""
    entries = (line.partition(" ") for line in read_lines(folder / PASSED))
    return {int(number) for name, _, number in entries if name == without_number(lesson) and number.isdecimal()}


def without_number(lesson: str) -> str:
    """The name of a lesson without its number: "exploration" for "01_exploration"."""
    return re.sub(r"^\d+[a-z]?_", "", lesson)


def number_of(lesson: str) -> str:
    """The number of a lesson from its name: "1" from "01_exploration", "0b" from "00b_bandits"."""
    return lesson.partition("_")[0].removeprefix("0")

"""The list of a class: a CSV file with a row for each student."""

import csv
import re
from pathlib import Path
from typing import NamedTuple

ID = re.compile(r"[\w@+-][\w.@+-]*", flags=re.ASCII)


class Student(NamedTuple):
    """A student.

    Attributes:
        id: her number or short name, that of her folder.
        name: what she is called in her lesson and in the results.
    """

    id: str
    name: str


def read_students(path: Path) -> list[Student]:
    """Read the list of a class: a column `id`, and if you like `name`, or `first_name` and `last_name` as in nbgrader.

    Raises:
        ValueError: a row has no id, one that cannot name a folder, or that of another row.
        OSError: the file cannot be read.
    """
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise ValueError(f"{path.name} must be a text file in UTF-8, but is not: save it as 'CSV UTF-8'") from None
    first = text.partition("\n")[0]
    rows = csv.DictReader(text.splitlines(), delimiter=";" if first.count(";") > first.count(",") else ",")
    if "id" not in (rows.fieldnames or []):
        raise ValueError(
            f"{path.name} must begin with the names of its columns, one of them id, but begins with {first!r}"
        )
    students: dict[str, Student] = {}
    for row in rows:
        found = (row["id"] or "").strip()
        where = f"{path.name}, line {rows.line_num}: the id"
        if not ID.fullmatch(found):
            raise ValueError(
                f"{where} names a folder, so it has letters, digits and . _ - @ + only, but it is {found!r}"
            )
        if found.casefold() in students:
            raise ValueError(f"{where} must be that of one student, but {found!r} is there twice")
        names = (row.get("name") or "", row.get("first_name") or "", row.get("last_name") or "")
        students[found.casefold()] = Student(found, " ".join(filter(None, map(str.strip, names))) or found)
    if not students:
        raise ValueError(f"{path.name} must have a row for each student, but has none")
    return [*students.values()]

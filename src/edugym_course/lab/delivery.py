"""Put files into a student's folder, and never over the student's work.

A hidden record in that folder lists the fingerprints of all files that were ever put there. A file whose fingerprint is
not in the list has been changed by the student.
"""

import hashlib
import json
import os
from collections.abc import Iterator
from itertools import count
from pathlib import Path

from edugym.system.files import write_whole
from edugym_course.lab.records import DELIVERED, append_line, read_lines


def deliver(contents: str, path: Path) -> Path:
    """Bring a file up to date, unless the student has changed it: then put the new version beside it.

    Args:
        contents: the contents of the newest version.
        path: where the file goes, directly inside the student's folder.

    Returns:
        The path of the newest version: `path`, or one beside it. If the student has edited the newest version, that
        file is returned.

    Raises:
        OSError: the file cannot be written.
    """
    newest = fingerprint(contents)
    for place in places(path):
        delivered = _delivered(place)
        if os.path.lexists(place):
            present = _fingerprint_of(place)
            if present == newest:
                return place
            if present not in delivered:  # the student's own work
                if newest in delivered:
                    return place
                continue
        append_line(place.parent / DELIVERED, f"{newest} {place.name}")
        write_whole(place, contents.encode())
        return place
    raise AssertionError("there is always another place")


def places(path: Path) -> Iterator[Path]:
    """The places for versions of a file: its own path, then others beside it, without end."""
    yield path
    yield path.with_stem(f"{path.stem}_new_version")
    yield from (path.with_stem(f"{path.stem}_new_version_{number}") for number in count(2))


def versions(path: Path) -> list[Path]:
    """The versions of a file that exist, the student's first and the newest last."""
    found: list[Path] = []
    for place in places(path):
        if not os.path.lexists(place):
            return found
        found.append(place)
    return found


def fingerprint(contents: str) -> str:
    """The fingerprint of a text. That of a notebook depends on its cells only: running it changes nothing."""
    try:
        cells = [[cell["cell_type"], "".join(cell["source"])] for cell in json.loads(contents)["cells"]]
    except (ValueError, TypeError, KeyError):
        return hashlib.sha256(contents.encode()).hexdigest()
    return hashlib.sha256(json.dumps(cells).encode()).hexdigest()


def _fingerprint_of(path: Path) -> str:
    """The fingerprint of a file; "" for a folder, or for what is not text: neither came from us."""
    try:
        return fingerprint(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return ""


def _delivered(path: Path) -> set[str]:
    """The fingerprints of all files that were ever put at this path."""
    lines = read_lines(path.parent / DELIVERED)
    return {mark for mark, _, name in (line.partition(" ") for line in lines) if name == path.name}

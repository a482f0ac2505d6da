"""Record which exercises a student has solved."""

import contextlib
from pathlib import Path

from edugym_course.lab.records import DELIVERED, PASSED, append_line, passed, without_number
from edugym_course.lab.start_page import write_start_page


def record_passed(lesson: str, exercise: int) -> None:
    """Record that the check of an exercise has passed, for the start page of `edugym lab`.

    Nothing happens outside a folder that `edugym lab` has made: a check in another place leaves no file behind. A
    record that cannot be written is no reason for a check to fail.

    Args:
        lesson: the name of the lesson, with or without its number: "01_exploration" or "exploration".
        exercise: the number of the exercise, from 1.
    """
    with contextlib.suppress(OSError):
        folder = _folder_of_the_lab()
        if folder is not None and exercise not in passed(folder, lesson):
            append_line(folder / PASSED, f"{without_number(lesson)} {exercise}")
            write_start_page(folder)


def _folder_of_the_lab() -> Path | None:
    """The student's folder around the present folder, in which Jupyter starts the kernel of a notebook."""
    here = Path.cwd()
    return next((folder for folder in (here, *here.parents) if (folder / DELIVERED).is_file()), None)

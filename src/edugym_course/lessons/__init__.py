"""The lessons. Each is a folder with its text, experiments, figures, exercises and sample answers.

They are found by their place; there is no list of them.
"""

import importlib
import pkgutil
import re
from pathlib import Path
from typing import Protocol, cast

from edugym.adapters.registration import place_in_course
from edugym.checks.parameters import one_of
from edugym_course.reporting import Reporter


class Experiments(Protocol):
    """The module `experiments` of a lesson."""

    report: Reporter


def lesson_names() -> list[str]:
    """Return the names of all lessons, in order: by "(lesson 1)" in the first line of each folder's `__init__.py`."""

    def place(name: str) -> tuple[tuple[float, str], str]:
        files = (Path(path, name, "__init__.py") for path in __path__)
        with next(file for file in files if file.exists()).open(encoding="utf-8") as file:
            number = re.search(r"\(lesson (\d+[a-z]?)\)", file.readline())
        return place_in_course(number[1] if number else None), name

    return sorted((module.name for module in pkgutil.iter_modules(__path__) if module.ispkg), key=place)


def load_experiments(lesson: str) -> Experiments:
    """Import the experiments of a lesson.

    Raises:
        ValueError: there is no such lesson.
    """
    one_of("lesson", lesson, lesson_names())
    return cast(Experiments, importlib.import_module(f"{__name__}.{lesson}.experiments"))

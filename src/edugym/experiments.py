"""The experiments of the lessons: the form of their reports, and how to find them.

A lesson with experiments has a module `edugym/lessons/<name>.py` with one function for the command line and for tests:

    report(*, repetitions=..., seed=0, jobs=-1, progress=False, stop=None, folder=None) -> Report

It runs the experiments, saves their results in the folder one by one, and returns the claims and figures. Ctrl-C ends
all of it with a `KeyboardInterrupt`. Modules are found by their place; there is no list of them.
"""

import importlib
import math
import pkgutil
import re
import threading
from pathlib import Path
from typing import Protocol, cast

import edugym.lessons
from edugym.checks import one_of
from edugym.plotting.report import Report


class Experiments(Protocol):
    """The module of a lesson."""

    def report(
        self,
        *,
        repetitions: int = ...,
        seed: int = ...,
        jobs: int | None = ...,
        progress: bool = ...,
        stop: threading.Event | None = ...,
        folder: Path | None = ...,
    ) -> Report:
        """Run the experiments.

        Args:
            repetitions: the number of runs of each method; by default that of the lesson.
            seed: the number from which all seeds are spawned.
            jobs: the number of runs at a time, as in `edugym.training.repeat`.
            progress: whether to show progress, as there.
            stop: an event that ends all experiments when it is set, as there. Claims without data are then reported as
                not measured.
            folder: the folder for the results, which are saved as soon as they are complete. Finished runs are kept in
                a folder `checkpoints` in it: the same call goes on from there.
        """


def lesson_names() -> list[str]:
    """Return the names of all lessons with experiments, in order: by "(lesson 1)" in the first lines of the files."""

    def place(name: str) -> tuple[float, str]:
        folder = next(path for path in edugym.lessons.__path__ if Path(path, f"{name}.py").exists())
        with Path(folder, f"{name}.py").open(encoding="utf-8") as file:
            number = re.search(r"\(lesson (\d+)\)", file.readline())
        return (int(number[1]) if number else math.inf), name

    return sorted((module.name for module in pkgutil.iter_modules(edugym.lessons.__path__)), key=place)


def load_experiments(lesson: str) -> Experiments:
    """Import the module of a lesson.

    Raises:
        ValueError: there is no such lesson.
    """
    one_of("lesson", lesson, lesson_names())
    return cast(Experiments, importlib.import_module(f"{edugym.lessons.__name__}.{lesson}"))

"""Runs what one student handed in, in a process of its own, and says which of her answers are right.

It reads a job from the standard input, as JSON, and writes a line of JSON for each check to the standard output. What
the student's code prints goes nowhere. `grading.py` starts it: `python -m edugym_course.teaching.session`.

The checks are those of the installed package. What the student's notebook calls `check` is never called, and an answer
counts for nothing once her code has changed something inside the package. That stops shortcuts, and no attack: code
can deceive the process in which it runs if it wants to. Look at what seems too good.
"""

import json
import math
import os
import sys
import tempfile
import types
from collections.abc import Callable, Iterator
from typing import Any

from edugym_course.grading.errors import TooSlow, Unsolved, WrongAnswer
from edugym_course.grading.own_numbers import passes
from edugym_course.grading.student_code import student_code
from edugym_course.teaching.assignment import Draw, Task

CELL_SECONDS = 120
"""The seconds of processor time that a cell of the student's may take."""

GUARDED = ("edugym", "edugym_course", "builtins", "math", "numpy")
"""The packages whose functions a student's code should leave as they are."""


class Session:
    """A student's notebook while it runs."""

    def __init__(self, tell: Callable[[dict[str, Any]], None]) -> None:
        """Start with nothing defined; `tell` takes what is to be reported."""
        from IPython.core.interactiveshell import InteractiveShell
        from traitlets.config import Config

        settings = Config()
        settings.HistoryManager.enabled = False
        self.shell: Any = InteractiveShell.instance(config=settings)
        self.tell = tell
        self.failed: dict[int, str] = {}  # by exercise, why its cell failed
        self.whole = {*_functions()}

    def run(self, source: str, exercise: int | None) -> None:
        """Run a cell; `exercise` is the number of the exercise if it is that of an answer."""
        try:
            with student_code("a cell", CELL_SECONDS):
                ran = self.shell.run_cell(source, store_history=False)
            error = ran.error_before_exec or ran.error_in_exec
        except WrongAnswer as late:
            error = late
        if error is not None and exercise is not None:
            self.failed[exercise] = f"its cell raises {type(error).__name__}: {' '.join(str(error).split())}"

    def check(self, task: Task, draw: Draw, others: dict[str, dict[str, Any]]) -> None:
        """Check an answer, and report the verdict.

        Args:
            task: the exercise.
            draw: the student's numbers and seeds.
            others: by the id of each other student, her numbers; by "", those of the ordinary lesson.
        """
        fits: list[str] = []
        says = ""
        if changed := self.whole - {*_functions()}:
            names = ", ".join(sorted({name for name, *_ in changed})[:3])
            says = f"nothing is graded after the code has changed {names} inside the package"
        else:
            exercise = task.check()
            try:
                answer = self._answer(task)
                with student_code("the code", math.inf):
                    for seed in (draw.seed, draw.hidden_seed):
                        exercise(answer, seed, **draw.numbers)
            except WrongAnswer as wrong:
                says = str(wrong)
                if draw.numbers and not isinstance(wrong, Unsolved | TooSlow):
                    different = {name: numbers for name, numbers in others.items() if numbers != draw.numbers}
                    fits = [name for name, own in different.items() if passes(exercise, answer, draw.seed, own)]
        self.tell({"exercise": task.number, "passed": not says, "says": says, "fits": fits})

    def _answer(self, task: Task) -> Any:
        """Return a student's answer.

        Raises:
            Unsolved: there is none.
        """
        try:
            return eval(task.answer, self.shell.user_ns)
        except Exception as error:
            why = self.failed.get(task.number, f"{type(error).__name__}: {error}")
            raise Unsolved(f"there is no {task.answer}: {why}") from None


def _functions() -> Iterator[tuple[str, int, int]]:
    """Yield the functions of the guarded packages, and the methods of their classes: name, identity, code."""
    for module in [*sys.modules.values()]:
        package = module.__name__.partition(".")[0] if isinstance(module, types.ModuleType) else ""
        if package in GUARDED:
            for name, value in [*vars(module).items()]:
                yield from _codes(f"{module.__name__}.{name}", value)
                if isinstance(value, type) and value.__module__.partition(".")[0] == package:
                    for part, method in [*vars(value).items()]:
                        yield from _codes(f"{module.__name__}.{name}.{part}", method)


def _codes(name: str, value: Any) -> Iterator[tuple[str, int, int]]:
    if isinstance(value, types.FunctionType | type):
        yield name, id(value), id(getattr(value, "__code__", None))


def main() -> None:
    """Run the job that the standard input holds."""
    job = json.load(sys.stdin)
    reports = os.fdopen(os.dup(1), "w", encoding="utf-8")
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)

    def tell(report: dict[str, Any]) -> None:
        print(json.dumps({**report, "token": job["token"]}), file=reports, flush=True)

    tasks = {task["number"]: Task(**task) for task in job["tasks"]}
    draws = {number: Draw(**draw) for number, draw in zip(tasks, job["draws"], strict=True)}
    for task in tasks.values():
        task.check()
    os.environ["IPYTHONDIR"] = tempfile.mkdtemp()
    session = Session(tell)
    for step in job["steps"]:
        if step["check"]:
            number = step["exercise"]
            session.check(tasks[number], draws[number], job["others"][str(number)])
        else:
            session.run(step["source"], step["exercise"])
    tell({"end": True})
    reports.close()
    os._exit(0)  # whatever threads or windows the student's code has left


if __name__ == "__main__":
    main()

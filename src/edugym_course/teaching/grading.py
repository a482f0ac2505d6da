"""Grades what a class handed in: each student's answers with the checks of her own numbers."""

import ast
import builtins
import json
import os
import secrets
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import asdict
from functools import partial
from pathlib import Path
from symtable import SymbolTable, symtable
from typing import Any, NamedTuple

from edugym.system.extras import require
from edugym_course.grading.own_numbers import ordinary_numbers
from edugym_course.teaching.assignment import Assignment, Task, handed_out
from edugym_course.teaching.marks import is_check, is_code
from edugym_course.teaching.students import Student

NOTHING = "nothing came in"

ORDINARY = ""
"""The ordinary lesson, whose solutions everybody can read, among those whose numbers answers may fit."""


class Verdict(NamedTuple):
    """What one answer is worth.

    Attributes:
        points: the points that it gets.
        says: what is wrong with it, "" if nothing is.
        fits: the ids of the other students for whose numbers it is right, and `ORDINARY`.
    """

    points: float
    says: str
    fits: tuple[str, ...]


class Graded(NamedTuple):
    """What one student's work is worth.

    Attributes:
        student: the student.
        verdicts: of each exercise, in order.
        remarks: what the teacher should know: nothing came in, a check was edited, or is another student's, it took too
            long.
    """

    student: Student
    verdicts: tuple[Verdict, ...]
    remarks: tuple[str, ...]

    @property
    def points(self) -> float:
        """All points together."""
        return sum(verdict.points for verdict in self.verdicts)

    @property
    def fits(self) -> dict[str, list[int]]:
        """By the id of another student, the exercises whose answers are right for her numbers and not for one's own."""
        ids = sorted({other for verdict in self.verdicts for other in verdict.fits})
        return {
            other: [number for number, verdict in enumerate(self.verdicts, start=1) if other in verdict.fits]
            for other in ids
        }


def submission(folder: Path, student: str, lesson: str) -> Path:
    """Find what a student handed in: `STUDENT/LESSON.ipynb`, or one such as `LESSON (1).ipynb`, or any one notebook.

    Raises:
        ValueError: there is none, or several of which none has that name.
    """
    present = [path for path in (folder / student).rglob("*.ipynb") if ".ipynb_checkpoints" not in path.parts]
    if not present:
        raise ValueError(NOTHING)
    named = [path for path in present if path.stem == lesson]
    like = [path for path in present if path.stem.startswith(lesson)]  # as browsers call what they save again
    found = named or like or present
    if len(found) > 1:
        raise ValueError(f"there are {len(found)} notebooks, and it is not clear which one counts")
    return found[0]


def grade(assignment: Assignment, folder: Path, seconds: float = 600) -> Iterator[Graded]:
    """Grade what came back.

    Args:
        assignment: what was handed out.
        folder: it has a folder for each student, named by her id, with her notebook somewhere in it.
        seconds: the longest time for one student; what was not checked by then gets no points.

    Yields:
        What each student gets, in the order of the list.

    Raises:
        OSError: what was handed out cannot be read.
    """
    require("teach", "nbformat", "IPython")
    for student in assignment.students.values():
        yield _grade(assignment, student, folder, seconds)


def strangers(assignment: Assignment, folder: Path) -> list[str]:
    """Return the names of folders that belong to nobody on the list."""
    return sorted(path.name for path in folder.iterdir() if path.is_dir() and path.name not in assignment.students)


def _grade(assignment: Assignment, student: Student, folder: Path, seconds: float) -> Graded:
    import nbformat

    def without_points(why: str) -> Graded:
        return Graded(student, tuple(Verdict(0, why, ()) for _ in assignment.tasks), (why,))

    try:
        path = submission(folder, student.id, assignment.lesson)
        notebook = nbformat.read(path, as_version=4)
    except ValueError as error:
        return without_points(str(error))
    except Exception:
        return without_points("what came in cannot be read as a notebook")
    given = handed_out(nbformat.read(assignment.source(student.id), as_version=4))
    steps = needed_steps(notebook.cells, given.cells, assignment.tasks)
    reports, remark = _run(assignment, student.id, steps, seconds)
    said = {report["exercise"]: report for report in reports if "exercise" in report}
    verdicts = [
        Verdict(task.points if report["passed"] else 0, report["says"], tuple(report["fits"]))
        if (report := said.get(task.number))
        else Verdict(0, remark or "it was not checked", ())
        for task in assignment.tasks
    ]
    remarks = _remarks(notebook.cells, given.cells, partial(_owners, assignment, student))
    return Graded(student, tuple(verdicts), tuple(filter(None, [*remarks, remark])))


def _owners(assignment: Assignment, student: Student, checks: Mapping[str, str]) -> dict[str, Student]:
    """Return by the names of checks the other students who got one with the same text."""
    import nbformat

    owners: dict[str, Student] = {}
    for other in assignment.students.values() if checks else ():
        if other != student:
            theirs = handed_out(nbformat.read(assignment.source(other.id), as_version=4)).cells
            owners |= {_grade_id(cell): other for cell in theirs if checks.get(_grade_id(cell)) == cell.source.strip()}
    return owners


def _remarks(
    cells: Iterable[Any], given: Iterable[Any], owners_of: Callable[[Mapping[str, str]], Mapping[str, Student]]
) -> Iterator[str]:
    """Yield what was done to the checks; `owners_of` tells whose those are that were changed."""
    checks = {_grade_id(cell): cell.source.strip() for cell in given if is_check(cell)}
    came = {_grade_id(cell): cell.source.strip() for cell in cells if _grade_id(cell) in checks}
    changed = {name: source for name, source in came.items() if source != checks[name]}
    owners = owners_of(changed)
    for name in checks:
        number = name.rpartition("-")[2]
        if name not in came:
            yield f"the cell of check {number} is missing"
        elif name in owners:
            yield f"check {number} is that of {owners[name].name} ({owners[name].id})"
        elif name in changed:
            yield f"check {number} was edited, which changes nothing"
    new = {cell.source for cell in cells if is_code(cell)} - {cell.source for cell in given if is_code(cell)}
    for name in ("check", *(f"exercise_{number}" for number in range(1, len(checks) + 1))):
        if any(name in _bound(source) for source in new):
            yield f"`{name}` gets another meaning, which changes nothing"


def _grade_id(cell: Any) -> str:
    """Return the name that nbgrader knows a cell by, "" if it has none."""
    return str(cell.metadata.get("nbgrader", {}).get("grade_id", ""))


def needed_steps(cells: Iterable[Any], given: Iterable[Any], tasks: list[Task]) -> list[dict[str, Any]]:
    """Return what has to run, in order: the student's own cells, what these need of the lesson, and the checks.

    A lesson has experiments of a minute and more. Of its cells that the student has left as they were, only those run
    that define a name which her cells use, or which another of them needs.
    """
    lesson = {cell.source for cell in given if is_code(cell)}
    answers = {f"exercise-{task.number}": task for task in tasks}
    steps: list[dict[str, Any]] = []
    unchecked: dict[int, Task] = {}
    for cell in filter(is_code, cells):
        name = _grade_id(cell)
        if name.startswith("check-"):
            unchecked = _checked(steps, unchecked)
            continue
        if name in answers:
            unchecked[answers[name].number] = answers[name]
        number = answers[name].number if name in answers else None
        own = number is not None or cell.source not in lesson
        steps.append({"check": False, "source": cell.source, "exercise": number, "own": own})
    _checked(steps, unchecked)
    steps += [{"check": True, "exercise": task.number} for task in tasks if not _is_checked(task, steps)]
    while not steps[-1]["check"]:  # what follows the last exercise, such as the open challenge, takes minutes
        steps.pop()
    _leave_out(steps, {name for task in tasks for name in _used(task.answer)})
    return [{key: value for key, value in step.items() if key != "own"} for step in steps]


def _checked(steps: list[dict[str, Any]], unchecked: dict[int, Task]) -> dict[int, Task]:
    """Add the checks of answers that have been given."""
    steps += [{"check": True, "exercise": number} for number in unchecked]
    return {}


def _is_checked(task: Task, steps: list[dict[str, Any]]) -> bool:
    return any(step["check"] and step["exercise"] == task.number for step in steps)


def _leave_out(steps: list[dict[str, Any]], wanted: set[str]) -> None:
    """Remove the cells of the lesson that define nothing which is wanted."""
    cells = [step for step in steps if not step["check"]]
    kept = [step for step in cells if step["own"]]
    while kept:
        wanted |= {name for step in kept for name in _used(step["source"])}
        for step in kept:
            cells.remove(step)
        kept = [step for step in cells if wanted & _bound(step["source"])]
    for step in cells:
        steps.remove(step)


def _statements(source: str) -> list[ast.stmt]:
    """Return the statements of a cell; none if it is not plain Python."""
    with suppress(SyntaxError, ValueError):
        return ast.parse(source).body
    return []


def _bound(source: str) -> set[str]:
    """Return the names that a cell defines."""
    return {name for statement in _statements(source) for name in _bindings(statement)}


def _bindings(statement: ast.stmt) -> Iterator[str]:
    """Yield the names that a statement defines outside of functions and classes."""
    if isinstance(statement, ast.FunctionDef | ast.ClassDef | ast.AsyncFunctionDef):
        yield statement.name
        return
    for node in ast.walk(statement):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.Import | ast.ImportFrom):
            yield from ((alias.asname or alias.name).partition(".")[0] for alias in node.names)
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name


def _used(source: str) -> set[str]:
    """Return the names that a cell takes from others, and perhaps a few more."""
    defined = {*dir(builtins)}
    used: set[str] = set()
    for statement in _statements(source):
        if isinstance(statement, ast.For):
            defined |= {node.id for node in ast.walk(statement.target) if isinstance(node, ast.Name)}
        used |= {*_globals_of(symtable(ast.unparse(statement), "cell", "exec"))} - defined
        if isinstance(statement, ast.Assign | ast.FunctionDef | ast.ClassDef | ast.Import | ast.ImportFrom):
            defined |= {*_bindings(statement)}
    return used


def _globals_of(scope: SymbolTable) -> Iterator[str]:
    """Yield the names that are read in a scope, or in one inside it, and are local to none of them."""
    for symbol in scope.get_symbols():
        if symbol.is_referenced() and (scope.get_type() == "module" or symbol.is_global()):
            yield symbol.get_name()
    for inner in scope.get_children():
        yield from _globals_of(inner)


def _run(
    assignment: Assignment, student: str, steps: list[dict[str, Any]], seconds: float
) -> tuple[list[dict[str, Any]], str]:
    """Run a student's cells in a process of its own, and return what it reports, and what went wrong with it."""
    token = secrets.token_hex(16)
    others: dict[int, dict[str, dict[str, Any]]] = {}
    for place, task in enumerate(assignment.tasks):
        others[task.number] = {name: dict(draws[place].numbers) for name, draws in assignment.draws.items()}
        del others[task.number][student]
        if ordinary := ordinary_numbers(task.check()):
            others[task.number][ORDINARY] = ordinary
    job = {
        "token": token,
        "tasks": [asdict(task) for task in assignment.tasks],
        "draws": [asdict(draw) for draw in assignment.draws[student]],
        "others": others,
        "steps": steps,
    }
    quietly = {"EDUGYM_QUIET": "1", "MPLBACKEND": "agg"}
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        process = subprocess.Popen(
            [sys.executable, "-m", "edugym_course.teaching.session"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            cwd=folder,
            env=os.environ | quietly,
            start_new_session=True,
        )
        remark = ""
        try:
            said, _ = process.communicate(json.dumps(job).encode(), timeout=seconds)
        except subprocess.TimeoutExpired:
            remark = f"it was ended after {seconds:g} seconds"
            _end(process)
            said, _ = process.communicate()
        except BaseException:
            _end(process)
            raise
        _end(process)
    reports = [report for line in said.splitlines() if (report := _report(line)).get("token") == token]
    if not remark and not any("end" in report for report in reports):
        remark = "its process ended before all was checked"
    return reports, remark


def _end(process: "subprocess.Popen[bytes]") -> None:
    """End a process and all that it has started."""
    with suppress(ProcessLookupError, PermissionError):
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()


def _report(line: bytes) -> dict[str, Any]:
    """Return a line that a session wrote, empty if it is none."""
    try:
        report = json.loads(line)
    except ValueError:
        return {}
    return report if isinstance(report, dict) else {}

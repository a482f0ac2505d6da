"""A lesson for each student of a class, with layouts and numbers of her own.

All that is drawn for a student comes from a key, which is computed from her id and a secret of the teacher's. Without
the secret nobody can compute another student's numbers, or the seeds of the hidden tests.
"""

import ast
import hashlib
import hmac
import importlib
import json
import secrets
from collections.abc import Iterator, Mapping
from copy import deepcopy
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from edugym.system.extras import require
from edugym.system.files import write_whole
from edugym_course.grading.own_numbers import Exercise, draw_numbers, drawn, own_parameters, told
from edugym_course.lab.lessons import CHECKOUT
from edugym_course.lab.records import without_number
from edugym_course.teaching.marks import is_check, is_code, is_exercise, with_own_numbers, without_solutions
from edugym_course.teaching.students import Student

HANDOUT = "handout"
"""The folder with what students get."""

TEACHER = "teacher"
"""The folder with what they must not see."""

SOMEBODY = '"Ada Lovelace"'
"""Whose tasks the open challenge of a lesson has, until it belongs to a student."""


@dataclass(frozen=True)
class Task:
    """An exercise of a lesson.

    Attributes:
        number: its number, from 1.
        module: the module of its check.
        function: the name of its check there.
        answer: the name, or the expression, that the check is given.
        points: what it is worth.
    """

    number: int
    module: str
    function: str
    answer: str
    points: float

    def check(self) -> Exercise:
        """Return the check."""
        exercise: Exercise = getattr(importlib.import_module(self.module), self.function)
        return exercise


@dataclass(frozen=True)
class Draw:
    """What was drawn for a student in one exercise.

    Attributes:
        numbers: her own numbers, by name.
        seed: the number from which the cases of the check are drawn that she sees.
        hidden_seed: that of the hidden test.
    """

    numbers: Mapping[str, Any]
    seed: int
    hidden_seed: int


@dataclass(frozen=True)
class Assignment:
    """A lesson that was handed out. It is kept as a JSON file in the teacher's folder.

    Attributes:
        lesson: its name, such as "01_exploration".
        secret: what the numbers come from, besides the students' ids.
        tasks: its exercises, in order.
        students: the students, by id.
        draws: by id, what was drawn for each exercise, in order.
        path: the JSON file.
    """

    lesson: str
    secret: str
    tasks: list[Task]
    students: dict[str, Student]
    draws: dict[str, list[Draw]]
    path: Path = field(default=Path())

    @classmethod
    def read(cls, path: Path) -> "Assignment":
        """Read an assignment.

        Raises:
            ValueError: the file is none.
            OSError: it cannot be read.
        """
        try:
            parts = json.loads(path.read_text(encoding="utf-8"))
            return cls(
                parts["lesson"],
                parts["secret"],
                [Task(**task) for task in parts["tasks"]],
                {name: Student(*student) for name, student in parts["students"].items()},
                {name: [Draw(**draw) for draw in draws] for name, draws in parts["draws"].items()},
                path,
            )
        except (KeyError, TypeError, ValueError, AttributeError):
            raise ValueError(
                f"{path} must be the file that `edugym assign` wrote, such as 01_exploration.json"
            ) from None

    def write(self) -> None:
        """Write it to its file."""
        parts = {name: value for name, value in asdict(self).items() if name != "path"}
        write_whole(self.path, (json.dumps(parts, indent=1, ensure_ascii=False) + "\n").encode())

    def source(self, student: str) -> Path:
        """The notebook of a student, with solutions and hidden tests, as nbgrader wants it."""
        return self.path.parent / "source" / student / self.lesson / f"{self.lesson}.ipynb"


def teacher_edition(lesson: str) -> Path:
    """Find the teacher's notebook of a lesson.

    Args:
        lesson: its name, with or without its number, or the path of the notebook.

    Raises:
        ValueError: there is none. It is no part of the installed package, for it has the solutions.
    """
    if lesson.endswith(".ipynb") and Path(lesson).is_file():
        return Path(lesson)
    there = {path.stem: path for path in sorted((CHECKOUT / "teacher").glob("*.ipynb"))}
    for name, path in there.items():
        if lesson in (name, without_number(name)):
            return path
    hint = f"one of {', '.join(there)}, or " if there else ""
    raise ValueError(
        f"the lesson must be {hint}the path of a teacher's notebook, such as notebooks/teacher/01_exploration.ipynb,"
        f" but is {lesson!r}"
    )


def read_lesson(notebook: Path) -> Any:
    """Read the notebook of a lesson.

    Raises:
        ValueError: it is no notebook.
    """
    require("teach", "nbformat")
    import nbformat

    try:
        return nbformat.read(notebook, as_version=4)
    except Exception:
        raise ValueError(f"{notebook} must be a notebook, but cannot be read as one") from None


def assign(notebook: Path, students: list[Student], output: Path) -> Assignment:
    """Make the lesson of each student.

    `output/handout/ID/LESSON.ipynb` is for the student; `output/teacher` is for nobody else. Who does it again,
    with more students, gets the same numbers for those who were there: they are in the teacher's folder. No two
    students of a class have the same number, as long as there are enough; then each is given a second time, in the
    order of the list.

    Args:
        notebook: the teacher's notebook of the lesson, with solutions and hidden tests.
        students: the class.
        output: the folder to write to.

    Raises:
        ValueError: the notebook is none of a lesson.
        OSError: something cannot be read or written.
    """
    lesson = read_lesson(notebook)
    import nbformat

    path = output / TEACHER / f"{notebook.stem}.json"
    before = Assignment.read(path) if path.exists() else None
    secret = before.secret if before else secrets.token_hex(16)
    tasks = tasks_of(lesson)
    draws = _kept(before, tasks) if before else {}
    for student in students:
        if student.id not in draws:
            key = _key(secret, notebook.stem, student.id)
            draws[student.id] = [
                _draw(task, key, [others[place].numbers for others in draws.values()])
                for place, task in enumerate(tasks)
            ]
    draws = {student.id: draws[student.id] for student in students}
    made = Assignment(notebook.stem, secret, tasks, {student.id: student for student in students}, draws, path)
    made.write()
    for student in students:
        own = own_notebook(lesson, tasks, draws[student.id], student)
        write_whole(made.source(student.id), nbformat.writes(own).encode())
        write_whole(output / HANDOUT / student.id / notebook.name, nbformat.writes(handed_out(own)).encode())
    return made


def _key(secret: str, lesson: str, student: str) -> bytes:
    return hmac.digest(secret.encode(), f"{lesson} {student.casefold()}".encode(), hashlib.sha256)


def _kept(before: Assignment, tasks: list[Task]) -> dict[str, list[Draw]]:
    """Return what was drawn for students who have their lesson already; nothing if the lesson is another one now."""
    own = [own_parameters(task.check()).keys() for task in tasks]
    return {name: draws for name, draws in before.draws.items() if [draw.numbers.keys() for draw in draws] == own}


def _draw(task: Task, key: bytes, others: list[Mapping[str, Any]]) -> Draw:
    """Draw for a student in one exercise; `others` are the numbers of her class so far."""
    return Draw(
        draw_numbers(task.check(), key, others),
        1 + drawn(key, f"{task.function} seed", 99_999),
        1 + drawn(key, f"{task.function} hidden seed", 2**31),
    )


def tasks_of(lesson: Any) -> list[Task]:
    """Return the exercises of a lesson.

    Raises:
        ValueError: it has none, or one is not checked by `check(exercise_1, answer)`.
    """
    modules, tasks = modules_of(lesson), list[Task]()
    for number, cell in enumerate(filter(is_check, lesson.cells), start=1):
        called = {tuple(map(ast.unparse, call.args)) for _, call in check_calls(cell.source)}
        function, answer = called.pop() if [*map(len, called)] == [2] else ("", "")
        if function not in modules:
            raise ValueError(
                f"exercise {number} must be checked by check(exercise_{number}, answer), but is checked otherwise"
            )
        points = cell.metadata.get("nbgrader", {}).get("points", 1)
        tasks.append(Task(number, modules[function], function, answer, points))
    if not tasks or not any(map(is_exercise, lesson.cells)):
        raise ValueError("the lesson must be a teacher's notebook, with solutions and checks, but has none")
    return tasks


def modules_of(lesson: Any) -> dict[str, str]:
    """Return the modules from which a lesson imports, by the names that it imports."""
    return {
        alias.asname or alias.name: node.module
        for cell in filter(is_code, lesson.cells)
        for node in ast.walk(ast.parse(cell.source))
        if isinstance(node, ast.ImportFrom) and node.module
        for alias in node.names
    }


def check_calls(source: str) -> Iterator[tuple[ast.Expr, ast.Call]]:
    """Yield the lines of a cell that call `check`."""
    for line in ast.parse(source).body:
        match line:
            case ast.Expr(value=ast.Call(func=ast.Name("check")) as call):
                yield line, call


def own_notebook(lesson: Any, tasks: list[Task], draws: list[Draw], student: Student) -> Any:
    """Return a student's lesson, with the solutions and the hidden tests of her numbers."""
    notebook = deepcopy(lesson)
    notebook.cells[0].source += f"\n\n*This copy, with its numbers, belongs to {student.name} ({student.id}).*"
    remaining = iter(zip(tasks, draws, strict=True))
    text = None
    for cell in notebook.cells:
        if is_exercise(cell):
            task, draw = next(remaining)
            cell.source = with_own_numbers(cell.source, draw.numbers)
            if draw.numbers and text is not None:
                before, fold, hint = text.source.partition("<details>")
                sentence = told(task.check(), draw.numbers)
                text.source = f"{before.rstrip()}\n\n**Your own version.** {sentence}\n\n{fold}{hint}"
        elif is_check(cell):
            cell.source = _own_check(cell.source, task, draw)
        elif is_code(cell) and "CHALLENGE.score(" in cell.source:
            cell.source = cell.source.replace(SOMEBODY, json.dumps(student.name, ensure_ascii=False))
        text = None if is_code(cell) else cell
    return notebook


def _own_check(source: str, task: Task, draw: Draw) -> str:
    """Return a check with a student's numbers."""
    own = "".join(f", {name}={value!r}" for name, value in draw.numbers.items())
    return _checked(source, task.module, f", seed={draw.seed}{own}", f", seed={draw.hidden_seed}{own}")


def guarded_check(source: str, modules: Mapping[str, str]) -> str:
    """Return a check of a lesson with a hidden test that a student's names do not change.

    Args:
        source: the cell. If it calls no check of a module, it stays as it is.
        modules: by the names that the lesson imports, their modules.
    """
    calls = [call for _, call in check_calls(source)]
    module = modules.get(ast.unparse(calls[0].args[0])) if calls else None
    if module is None:
        return source
    shown, hidden = (
        "".join(f", {given.arg}={ast.unparse(given.value)}" for given in call.keywords if given.arg != "quiet")
        for call in (calls[0], calls[-1])
    )
    return _checked(source, module, shown, hidden)


def _checked(source: str, module: str, shown: str, hidden: str) -> str:
    """Return a check with these settings, for the student and in the hidden test.

    The hidden test imports what it calls: a student may have given other meanings to `check` and `exercise_1`.
    """
    visible = without_solutions(source)
    line, call = next(check_calls(visible))
    function, answer = map(ast.unparse, call.args)
    lines = visible.splitlines()
    assert line.end_lineno is not None
    lines[line.lineno - 1 : line.end_lineno] = [
        f"check({function}, {answer}{shown})",
        "### BEGIN HIDDEN TESTS",
        "import edugym_course.grading as the_grading",
        f"import {module} as the_exercises",
        f"the_grading.check(the_exercises.{function}, {answer}, quiet=True{hidden})",
        "### END HIDDEN TESTS",
    ]
    return "\n".join(lines)


def handed_out(notebook: Any) -> Any:
    """Return what a student gets: no solutions and no hidden tests. Its metadata are those of nbgrader."""
    made = deepcopy(notebook)
    for cell in filter(is_code, made.cells):
        cell.source = without_solutions(cell.source)
    return made

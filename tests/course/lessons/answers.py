"""Right and wrong answers to the exercises of a lesson: how they are read, and tried on the lesson's own checks."""

import ast
import contextlib
import linecache
import re
import textwrap
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

import build
from nbformat import NotebookNode
from rules import is_check, is_code, is_exercise, is_project, without_marks, without_solutions

from edugym.experiments import repeat as repeating
from edugym_course.grading import WrongAnswer

NAME = re.compile(r"(exercise_(?P<exercise>\d+)|project)_(?P<verdict>right|wrong)")
SAYS = re.compile(r"^# says: (.+\n(?:#   .+\n)*)", flags=re.MULTILINE)
SLOW = re.compile(r"^# slow\n", flags=re.MULTILINE)
SOLUTION = "the solution of "
LONG_CHECKS = {
    *(f"02_on_off_policy-{number}" for number in (1, 2, 3)),
    *("07_continuous_actions-3", "08_stochasticity-3", "15_profiles-2", "16_offline-3", "18_search-3"),
}
"""The exercises whose check takes half a second or more."""
LONG = {
    *("00_loop", "00b_bandits", "02_on_off_policy", "03_depth", "04_dimensionality", "05_memory", "06_signal"),
    *("08_stochasticity", "09_model_based", "11_goals", "12_objectives", "13_several_agents", "14_preferences"),
    "17_maximisation_bias",
}
"""The lessons in which checking a right program takes two seconds or more."""
EDIT = re.compile(r"((?:^# - .+\n)+)((?:^# \+ .+\n)*)", flags=re.MULTILINE)


class Answer(NamedTuple):
    """An answer to an exercise, such as 1 in the lesson "01_exploration", and what is special about it."""

    lesson: str
    exercise: int  # 0 is the project
    right: bool
    name: str
    says: tuple[str, ...]  # what the message must contain; if the answer is right, the line that is printed
    code: str  # what stands in the cell, or methods that replace those of the solution
    slow: bool = False  # whether only the slow tests try it


class Exercise(NamedTuple):
    """An exercise: its cell for students, the one with its solution, and the calls of `check`, hidden ones too."""

    placeholder: str
    solution: str
    check: str


def read_answers(lesson: str) -> tuple[str, list[Answer]]:
    """Return the code that runs before every answer, and the answers: `answers/exercise_1_wrong.py`, ..."""
    setup, answers = "", list[Answer]()
    for path in sorted((build.lesson_sources()[lesson].parent / "answers").glob("*.py")):
        text = path.read_text(encoding="utf-8")
        if path.stem == "setup":
            setup = text
            continue
        found = NAME.fullmatch(path.stem)
        assert found, f"{path}: its name should be like 'exercise_1_wrong.py' or 'project_right.py'"
        exercise, right = int(found["exercise"] or 0), found["verdict"] == "right"
        for part in re.split(r"^# %% ", text, flags=re.MULTILINE)[1:]:
            name, _, body = part.partition("\n")
            says = tuple(words.strip().replace("\n#  ", "") for words in SAYS.findall(body))
            assert right or says, f"{path}: {name!r}: a wrong answer has a line '# says: ...'"
            code = SLOW.sub("", SAYS.sub("", body)).strip() + "\n"
            if code.startswith("# in: "):
                of, _, edits = code.removeprefix("# in: ").partition("\n")
                if of.startswith(SOLUTION):
                    source = build.lesson_sources()[lesson]
                    asked = read_exercises(source)[1][exercise - 1] if exercise else read_project(source)
                    assert asked, f"{path}: the lesson has no project"
                    functions = functions_of(asked.solution)
                    programs = {of: "\n\n".join(functions[part] for part in of.removeprefix(SOLUTION).split(", "))}
                else:
                    programs = {answer.name: answer.code for answer in answers if answer[1:3] == (exercise, True)}
                assert of in programs, f"{path}: {name!r}: no right answer to this exercise is called {of!r}"
                code = _edited(programs[of], edits, f"{path}: {name!r}")
            answers.append(Answer(lesson, exercise, right, name, says, code, bool(SLOW.search(body))))
    return setup, answers


def _edited(program: str, edits: str, where: str) -> str:
    """Return a program after edits: lines '# - ...' that it has once, at any indentation, become '# + ...'."""
    assert not EDIT.sub("", edits).strip(), f"{where}: only lines '# - ...' and '# + ...' follow '# in: ...'"
    for pair in EDIT.findall(edits):
        old, new = (re.sub(r"^# [-+] ", "", lines, flags=re.MULTILINE) for lines in pair)
        place = r"^(?P<indent> *)" + r"\n(?P=indent)".join(map(re.escape, old.splitlines())) + r"\n"
        found = [*re.finditer(place, program, flags=re.MULTILINE)]
        assert len(found) == 1, f"{where}: the right answer has these lines {len(found)} times, not once:\n{old}"
        program = program[: found[0].start()] + textwrap.indent(new, found[0][1]) + program[found[0].end() :]
    return program


@cache
def functions_of(solution: str) -> dict[str, str]:
    """Return the functions and methods of a solution by name, at the left margin and without their docstrings."""
    found, lines = dict[str, str](), solution.splitlines(keepends=True)
    for node in ast.walk(ast.parse(solution)):
        if isinstance(node, ast.FunctionDef):
            first = node.body[0] if ast.get_docstring(node) else None
            described = range(first.lineno - 1, first.end_lineno or 0) if first else ()
            kept = (lines[k] for k in range(node.lineno - 1, node.end_lineno or 0) if k not in described)
            found[node.name] = textwrap.dedent("".join(kept)).rstrip("\n") + "\n"
    return found


@cache
def notebook_of(lesson: Path) -> NotebookNode:
    """Return a lesson: to read it takes a tenth of a second, and hundreds of answers need it."""
    return build.read_lesson(lesson)


def cells_of(lesson: Path) -> list[NotebookNode]:
    """Return the cells of a lesson."""
    return [*notebook_of(lesson).cells]


@cache
def read_exercises(lesson: Path) -> tuple[str, list[Exercise]]:
    """Return the imports of a lesson, and its exercises in order."""
    cells = [cell for cell in cells_of(lesson) if is_code(cell)]
    imports = "\n".join(cell.source for cell in cells if is_imports(cell))
    pairs = [(cell, below) for cell, below in pairwise(cells) if is_exercise(cell)]
    return imports, [
        Exercise(without_solutions(cell.source), without_marks(cell.source), _checks(below)) for cell, below in pairs
    ]


def read_project(lesson: Path) -> Exercise | None:
    """Return the program from a blank file that a lesson asks for, and its check; None if it asks for none."""
    cells = [cell.source for cell in cells_of(lesson) if is_project(cell)]
    return Exercise(without_solutions(cells[0]), without_marks(cells[0]), cells[1]) if cells else None


def is_imports(cell: NotebookNode) -> bool:
    """Whether a cell has nothing but imports."""
    return all(isinstance(part, ast.Import | ast.ImportFrom) for part in ast.parse(cell.source).body)


def _checks(cell: NotebookNode) -> str:
    """Return the calls of `check` in a cell, without the figures that it also draws."""
    assert is_check(cell)
    parts = ast.parse(without_marks(cell.source)).body
    calls = [ast.unparse(part) for part in parts]
    return "\n".join(call for call in calls if call.startswith("check("))


def verdict(answer: Answer, exercise: Exercise, before: Sequence[str]) -> str:
    """Return what the check of its exercise says of an answer, "" if it passes; first runs the code `before`."""
    whole, placeholder = _with_methods(exercise.solution, answer.code), ""
    if whole is None:
        whole, placeholder = answer.code, exercise.placeholder
    file = f"<answer {answer.exercise}, {answer.name}>"
    linecache.cache[file] = (len(whole), None, whole.splitlines(keepends=True), file)
    with namespace_after(*before, placeholder) as namespace:
        exec(compile(whole, file, "exec"), namespace)
        try:
            exec(exercise.check, namespace)
        except WrongAnswer as wrong:
            return str(wrong)
    return ""


@contextlib.contextmanager
def namespace_after(*before: str) -> Iterator[dict[str, Any]]:
    """Yield the names that such code defines. Its setup may leave out training in `repeat`, which then comes back."""
    namespace: dict[str, Any] = {"__name__": "__main__"}
    with patch.dict(vars(repeating)):
        for code in before:
            exec(code, namespace)
        yield namespace


def _with_methods(solution: str, answer: str) -> str | None:
    """Return the solution with methods from the answer in the place of its own; None if the answer is a whole cell."""
    classes = [node for node in ast.parse(solution).body if isinstance(node, ast.ClassDef)]
    methods = {part.name: part for node in classes for part in node.body if isinstance(part, ast.FunctionDef)}
    parts = ast.parse(answer).body
    imports = [ast.unparse(part) for part in parts if isinstance(part, ast.Import | ast.ImportFrom)]
    given = [part for part in parts if not isinstance(part, ast.Import | ast.ImportFrom)]
    if not all(isinstance(part, ast.FunctionDef) and part.name in methods for part in given):
        return None
    lines = solution.splitlines()
    mine = {
        part.name: ast.get_source_segment(answer, part) or "" for part in given if isinstance(part, ast.FunctionDef)
    }
    for name in sorted(mine, key=lambda name: -methods[name].lineno):
        old = methods[name]
        lines[old.lineno - 1 : old.end_lineno] = textwrap.indent(mine[name], " " * old.col_offset).splitlines()
    return "\n".join([*imports, *lines]) + "\n"


@cache
def solution(lesson: str, number: int, name: str) -> Any:
    """Return what the solution of an exercise defines by a name; lessons are called "01_exploration", say."""
    imports, exercises = read_exercises(build.lesson_sources()[lesson])
    namespace: dict[str, Any] = {"__name__": "__main__"}
    exec(imports, namespace)
    exec(exercises[number - 1].solution, namespace)
    return namespace[name]

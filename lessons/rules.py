"""The rules for the source of a lesson, and what its marks mean.

A lesson is a list of notebook cells. Each function `*_problems` yields what is wrong with them, one sentence each, and
nothing when all is well. CONTRIBUTING.md tells the same to the authors of lessons.
"""

import ast
import re
from collections.abc import Iterator, Sequence

from asides import aside_problems
from nbformat import NotebookNode
from times import TIME, length_problems

from edugym_course.teaching.marks import MARKED
from edugym_course.teaching.marks import is_check as is_check
from edugym_course.teaching.marks import is_code as is_code
from edugym_course.teaching.marks import is_exercise as is_exercise
from edugym_course.teaching.marks import is_project as is_project
from edugym_course.teaching.marks import without_marks as without_marks
from edugym_course.teaching.marks import without_solutions as without_solutions

# The headings of a lesson, in order: how each begins, what its text must contain, and whether code belongs to it.
SHAPE: list[tuple[str, tuple[str, ...], bool]] = [
    ("# ", ("**The challenge.**", "**You will be able to**", TIME, "**Before you start.**"), False),
    ("## Meet the environment", (), True),
    ("## The idea", ("$",), True),
    ("## The experiment", (), True),
    ("## Your turn", (), True),
    ("## See inside", (), True),
    ("## Predict, then check", ("**Predict.**", "**Measured.**"), True),
    ("## Exercises", ("<details>",), True),
    ("## What you saw", ("### Limits", "### Further reading"), False),
]
EXERCISES = range(2, 5)  # how many a lesson may have
WIDGET_MAKERS = {"interact", "interact_manual", "interactive", "interactive_output"}


def where(cell: NotebookNode) -> str:
    """Names a cell for messages: its id, which is the same in every edition, and its first line."""
    first_line = cell.source.strip().split("\n")[0]
    return f"{cell.id} ({first_line!r})"


def problems(cells: Sequence[NotebookNode]) -> list[str]:
    """Everything that is wrong with a lesson; rules about several cells are looked at once each cell is in order."""
    found = [problem for cell in cells for problem in cell_problems(cell)]
    if not found:
        for rule in RULES:
            found.extend(rule(cells))
    return found


def cell_problems(cell: NotebookNode) -> Iterator[str]:
    """Yields what is wrong within one cell: signs that none can see, marks misspelt, code that is not plain Python."""
    if unseen := sorted({sign for sign in cell.source if not sign.isprintable() and sign != "\n"}):
        yield f"{where(cell)}: no sign may be invisible, but {unseen} are (was \\alpha written in a string?)"
    for kind in MARKED:
        marks = [line.strip() for line in cell.source.splitlines() if kind in line]
        if marks != [f"### BEGIN {kind}", f"### END {kind}"] * (len(marks) // 2) or (marks and not is_code(cell)):
            yield f"{where(cell)}: {kind} is marked in code by a line '### BEGIN {kind}' and a line '### END {kind}'"
            return
    if not is_code(cell):
        return
    try:
        ast.parse(cell.source)
        visible = ast.parse(without_solutions(cell.source))
    except SyntaxError as error:
        yield f"{where(cell)}: not valid Python, with or without the solution (use no % or ! lines): {error}"
        return
    if is_check(cell) and not visible.body:
        yield f"{where(cell)}: a check needs a part that students see, outside the hidden tests"


def section_problems(cells: Sequence[NotebookNode]) -> Iterator[str]:
    """Yields where the headings, or what is under each of them, are not those of `SHAPE`."""
    sections: list[tuple[str, list[NotebookNode]]] = []
    for cell in cells:
        text = "" if is_code(cell) else re.sub(r"^```.*?^```", "", cell.source, flags=re.MULTILINE | re.DOTALL)
        headings = re.findall(r"^##? .*", text, flags=re.MULTILINE)
        if len(headings) > 1 or (headings and not text.startswith(headings[0])):
            yield f"{where(cell)}: a heading of level 1 or 2 opens its cell, and is the only one in it"
        if headings:
            sections.append((headings[0], []))
        if sections:
            sections[-1][1].append(cell)
    found = [heading for heading, _ in sections]
    expected = [start for start, _, _ in SHAPE]
    if len(found) != len(expected) or not all(map(str.startswith, found, expected)):
        yield f"the headings must begin so, in this order: {expected}; they are {found}"
        return
    for (heading, inside), (_, parts, has_code) in zip(sections, SHAPE, strict=True):
        text = "\n".join(cell.source for cell in inside if not is_code(cell))
        yield from (f"{heading!r} must contain {part!r}" for part in parts if part not in text)
        if has_code and not any(map(is_code, inside)):
            yield f"{heading!r} must have a code cell"


def exercise_problems(cells: Sequence[NotebookNode]) -> Iterator[str]:
    """Yields exercises without a hint before and a check after them, and checks of nothing."""
    number = sum(map(is_exercise, cells))
    if number not in EXERCISES:
        yield f"a lesson has {EXERCISES[0]} to {EXERCISES[-1]} exercises (code cells with a solution), not {number}"
    for before, cell, after in zip([None, *cells], cells, [*cells[1:], None], strict=False):
        if is_exercise(cell):
            if before is None or is_code(before) or "<details>" not in before.source:
                yield f"{where(cell)}: an exercise follows a text cell with a hint that folds out, <details>"
            if after is None or not is_check(after):
                yield f"{where(cell)}: an exercise is followed by its check, a code cell with the tag 'check'"
        if is_check(cell) and (before is None or not is_exercise(before)):
            yield f"{where(cell)}: a check follows the exercise that it checks"


def project_problems(cells: Sequence[NotebookNode]) -> Iterator[str]:
    """Yields cells of a project that are not the program and, next, its check."""
    found = [index for index, cell in enumerate(cells) if is_project(cell)]
    marks = [
        mark in cells[index].source for index, mark in zip(found, ("### BEGIN PROGRAM", "check(project_"), strict=False)
    ]
    if found and not (len(found) == 2 and found[1] == found[0] + 1 and all(marks)):
        yield "a project is two cells with the tag 'project': '### BEGIN PROGRAM', and next check(project_...)"


def prediction_problems(cells: Sequence[NotebookNode]) -> Iterator[str]:
    """Yields questions that are not followed by a field for the answer, the cell to run and, folded, what was measured.

    The cell to run shows the answer beside what was measured.
    """
    for index, cell in enumerate(cells):
        if not is_code(cell) and "**Predict.**" in cell.source:
            following = [*cells[index + 1 : index + 4]]
            whole = len(following) == 3 and [is_code(part) for part in following] == [True, True, False]
            wanted = (("predict(",), (".measured(",), ("<details>", "**Measured.**"))
            if not whole or not all(
                text in part.source for part, texts in zip(following, wanted, strict=True) for text in texts
            ):
                yield (
                    f"{where(cell)}: **Predict.** needs next a code cell with predict(...), a code cell with"
                    " .measured(...), then text with <details> and **Measured.**"
                )


def widget_problems(cells: Sequence[NotebookNode]) -> Iterator[str]:
    """Yields widgets that do not call a plain named function which the lesson also calls itself.

    A widget shows nothing on GitHub or on a site; the plain call does.
    """
    parsed = [(cell, node) for cell in cells if is_code(cell) for node in ast.walk(ast.parse(cell.source))]
    calls = [(cell, node) for cell, node in parsed if isinstance(node, ast.Call)]
    plain = {ast.unparse(call.func) for _, call in calls}
    for cell, call in calls:
        if ast.unparse(call.func).rpartition(".")[2] in WIDGET_MAKERS:
            shown = ast.unparse(call.args[0]) if call.args else "a decorated function"
            if shown not in plain:
                yield f"{where(cell)}: the widget calls {shown}; give it a named function, and call that once outside"


RULES = (
    section_problems,
    exercise_problems,
    project_problems,
    prediction_problems,
    widget_problems,
    aside_problems,
    length_problems,
)

"""Asides: sections of a lesson that open folded, since neither its one idea nor anything after them needs them.

In the source, an aside is a text cell with the tag `aside` that begins with `### Aside: `. It ends where the next
heading of its level or higher opens a cell. JupyterLab, Notebook 7 and the website show its heading alone at first.
"""

import ast
import re
from collections.abc import Iterator, Sequence

from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell

from edugym_course.teaching.marks import is_aside, is_check, is_code, is_exercise, is_project

OPENS = "### Aside: "
FOLDED = {"jp-MarkdownHeadingCollapsed": True}
"""The metadata of a text cell whose heading hides the cells below it, but not the rest of its own cell."""


def with_asides(cells: Sequence[NotebookNode]) -> list[NotebookNode]:
    """Return the cells with each marked heading in a folded cell of its own, and the tag on all cells of its aside."""
    made: list[NotebookNode] = []
    inside = False
    for cell in cells:
        if is_aside(cell):
            heading, _, text = cell.source.partition("\n")
            made.append(new_markdown_cell(heading, metadata=FOLDED | {"tags": ["aside"]}))
            cell.source, inside = text.strip("\n"), True
            if not cell.source:
                continue
        elif not is_code(cell) and re.match("#{1,3} ", cell.source):
            inside = False
        elif inside:
            cell.metadata.tags = ["aside", *cell.metadata.get("tags", [])]
        made.append(cell)
    return made


def is_opening(cell: NotebookNode) -> bool:
    """Whether a cell is the heading of an aside."""
    return is_aside(cell) and "jp-MarkdownHeadingCollapsed" in cell.metadata


def aside_problems(cells: Sequence[NotebookNode]) -> Iterator[str]:
    """Yield asides that are not marked so, that do not end, and what a reader who skips them would miss."""
    heading = ""  # of the aside that the cell is in
    owners: dict[str, str] = {}  # the aside in which a name was given its value last
    for cell in cells:
        if is_opening(cell):
            heading = cell.source
            if not heading.startswith(OPENS):
                yield f"{heading!r} is marked as an aside, so it must begin with {OPENS!r}"
            continue
        if not is_aside(cell):
            heading = ""
        if not is_code(cell):
            text = re.sub(r"^```.*?^```", "", cell.source, flags=re.MULTILINE | re.DOTALL)
            if heading and (headings := re.findall(r"^#+ .*", text, flags=re.MULTILINE)):
                yield f"{heading!r} has no other heading in it, but {headings[0]!r}: what follows it opens a cell"
            if not heading and text.startswith("### Aside"):
                yield f"{text.splitlines()[0]!r} is an aside, so its cell needs the tag 'aside'"
            continue
        if heading and (is_exercise(cell) or is_check(cell) or is_project(cell)):
            yield f"{heading!r} has an exercise, a check or a project in it; these belong to everybody"
        for statement in ast.parse(cell.source).body:
            needed, given = _names(statement)
            for name in sorted(needed & owners.keys()):
                if owners[name] != heading:
                    yield f"{name!r} comes from {owners[name]!r}, and whoever skips that has none in {cell.id}"
            for name in given:
                owners.pop(name, None)
                if heading:
                    owners[name] = heading


def _names(statement: ast.stmt) -> tuple[set[str], set[str]]:
    """Return the names whose values a statement needs, and those to which it gives one; loops give their own first."""
    nodes = [*ast.walk(statement)]
    names = [node for node in nodes if isinstance(node, ast.Name)]
    needed = {name.id for name in names if isinstance(name.ctx, ast.Load)}
    given = {name.id for name in names if isinstance(name.ctx, ast.Store)}
    given |= {(node.asname or node.name).partition(".")[0] for node in nodes if isinstance(node, ast.alias)}
    within = {node.arg for node in nodes if isinstance(node, ast.arg)}
    for loop in (node for node in nodes if isinstance(node, ast.comprehension)):
        within |= {node.id for node in ast.walk(loop.target) if isinstance(node, ast.Name)}
    if isinstance(statement, ast.FunctionDef | ast.ClassDef):
        return needed - within - given - {statement.name}, {statement.name}
    if isinstance(statement, ast.AugAssign):
        needed |= given
    elif not isinstance(statement, ast.Assign | ast.AnnAssign | ast.Expr):
        needed -= given
    return needed - within, given - within

"""The marks in the cells of a lesson: what is a solution, a hidden test, a check, and what students get of them."""

import ast
import re
from collections.abc import Mapping
from typing import Any

MARKED = ("SOLUTION", "HIDDEN TESTS", "PROGRAM")
"""Regions between `### BEGIN ...` and `### END ...`."""

EMPTY = "= ...  # your program"
"""How the line ends that stands in the place of a program from a blank file."""

OWN = "# own: "
"""In a solution, the line below it with a student's own numbers, in the place of the line above it."""


def is_code(cell: Any) -> bool:
    """Whether a cell holds code."""
    return bool(cell.cell_type == "code")


def is_exercise(cell: Any) -> bool:
    """Whether a cell is an exercise: code with a solution in it."""
    return is_code(cell) and "### BEGIN SOLUTION" in cell.source


def is_check(cell: Any) -> bool:
    """Whether a cell checks an exercise."""
    return is_code(cell) and ("check" in cell.metadata.get("tags", []) or "### BEGIN HIDDEN TESTS" in cell.source)


def is_project(cell: Any) -> bool:
    """Whether a cell is a program from a blank file, or its check. They are no exercise, and nobody grades them."""
    return is_code(cell) and "project" in cell.metadata.get("tags", [])


def is_aside(cell: Any) -> bool:
    """Whether a cell belongs to an aside, which is folded and which nothing else needs."""
    return "aside" in cell.metadata.get("tags", [])


def without_marks(source: str) -> str:
    """Takes the lines that are marks or placeholders out of a source, and leaves what they mark."""
    return "\n".join(
        line
        for line in source.splitlines()
        if not line.strip().startswith(("### BEGIN ", "### END ", OWN)) and not line.endswith(EMPTY)
    )


def with_own_numbers(source: str, numbers: Mapping[str, Any]) -> str:
    """Puts the lines with a student's own numbers in the place of the ordinary ones."""
    return re.sub(
        rf"^( *).*\n *{OWN}(.*)$", lambda line: line[1] + line[2].format(**numbers), source, flags=re.MULTILINE
    )


def without_solutions(source: str) -> str:
    """Takes solutions, programs and hidden tests out of the source of a code cell.

    What is left is valid Python: in a function a solution becomes `raise NotImplementedError`, so that the check can
    say that it is not solved yet; elsewhere it becomes `pass`, so that the cell still runs and shows nothing.
    """
    nodes = ast.walk(ast.parse(source))
    functions = [node for node in nodes if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]
    kept: list[str] = []
    inside = False
    for number, line in enumerate(source.splitlines(), start=1):
        mark = line.strip()
        if mark.startswith("### BEGIN "):
            inside = True
            if mark == "### BEGIN SOLUTION":
                in_function = any(node.lineno <= number <= (node.end_lineno or 0) for node in functions)
                stub = 'raise NotImplementedError("not solved yet: replace this line")' if in_function else "pass"
                indent = line[: -len(line.lstrip())]
                kept += [f"{indent}# Your solution here.", indent + stub]
        elif mark.startswith("### END "):
            inside = False
        elif not inside:
            kept.append(line)
    return "\n".join(kept).strip("\n")

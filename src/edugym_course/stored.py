"""Results of experiments that take minutes: they are stored with the package, so that a lesson can show them at once.

    python -m edugym_course.stored memory.recurrent

makes those of one module of the lessons again. Each table says from which code it was made.
"""

import ast
import hashlib
import importlib
import importlib.util
import shutil
import sys
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from edugym.experiments.results.tables import Results

LESSONS = "edugym_course.lessons"
CODE = "code"
"""The column with the hash of the code that determines the results."""
REPETITIONS = 10


class Stored(NamedTuple):
    """Stored results.

    Attributes:
        module: the module of the experiment below `edugym_course.lessons`, such as "memory.recurrent". The table is the
            file beside it with the ending .csv.
        make: runs the experiment, with `repetitions` and `checkpoints`.
        determined_by: the other modules whose code determines the results, besides that module.
    """

    module: str
    make: Callable[..., Results]
    determined_by: tuple[str, ...]

    @property
    def path(self) -> Path:
        """The file with the table."""
        return source(f"{LESSONS}.{self.module}").with_suffix(".csv")

    def load(self) -> Results:
        """The stored results; they have no agents."""
        return Results.load(self.path)

    def code_hash(self) -> str:
        """A hash of the code that determines the results.

        Imports, docstrings, comments, pictures (`scene`) and functions that judge the results do not count; those
        are the functions whose names end in `_claims`.
        """
        names = (f"{LESSONS}.{self.module}", *self.determined_by)
        trees = (what_determines(source(name).read_text(encoding="utf-8")) for name in names)
        return hashlib.sha256("\n".join(trees).encode()).hexdigest()[:32]

    def is_current(self) -> bool:
        """Whether the results were made by the code that is there now."""
        return set(self.load().table[CODE]) == {self.code_hash()}

    def make_again(self) -> Results:
        """Run the experiment, and store its results; finished runs are kept in a folder until all are complete."""
        unfinished = self.path.with_suffix(".unfinished")
        results = self.make(repetitions=REPETITIONS, checkpoints=unfinished)
        results.table[CODE] = self.code_hash()
        results.save(self.path)
        shutil.rmtree(unfinished, ignore_errors=True)
        return results


def source(module: str) -> Path:
    """The file of a module, without importing it."""
    spec = importlib.util.find_spec(module)
    if spec is None or spec.origin is None:
        raise ValueError(f"there is no module {module}")
    return Path(spec.origin)


@lru_cache(256)
def what_determines(code: str, shown: tuple[str, ...] = ("scene",)) -> str:
    """Code without imports, docstrings, what judges the results, and methods that only show: by default pictures.

    It is remembered by its text: the profiles of all agents ask for the same sixty files some two thousand times.
    """
    tree = ast.parse(code)
    tree.body = [statement for statement in tree.body if not _only_judges(statement)]
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            described = ast.get_docstring(node) is not None
            # Without the docstring, which is the first statement, if there is one (True counts as 1).
            node.body = [part for part in node.body[described:] if getattr(part, "name", "") not in shown]
    return ast.dump(tree)


def _only_judges(statement: ast.stmt) -> bool:
    """Whether a statement changes no result: an import, a function with claims, or what is stored itself."""
    if isinstance(statement, ast.FunctionDef):
        return statement.name.endswith("_claims")
    stored = isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == "STORED"
    return stored or isinstance(statement, ast.Import | ast.ImportFrom)


def stored_in(module: str) -> Stored:
    """What a module of the lessons, such as "memory.recurrent", stores.

    Raises:
        ValueError: there is no such module, or it stores nothing.
    """
    source(f"{LESSONS}.{module}")
    found: Any = getattr(importlib.import_module(f"{LESSONS}.{module}"), "STORED", None)
    if not isinstance(found, Stored):
        raise ValueError(f"{LESSONS}.{module} stores no results: it has no STORED")
    return found


if __name__ == "__main__":
    # Run as a script, this module is loaded twice; `isinstance` needs the package's class.
    from edugym_course.stored import stored_in as stored_of

    if len(sys.argv) < 2:
        raise SystemExit("give the modules whose results to make again, such as memory.recurrent")
    for name in sys.argv[1:]:
        stored_of(name).make_again()

"""The numbers and names that the experiments and exercises of lessons are made with.

The text tells them, readers use them by name (`depth.EPSILON`), and stored results were made with them.
"""

import ast
import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest
from gymnasium.error import DependencyNotInstalled

import edugym.exercises
import edugym.lessons

FILE = Path(__file__).with_name("constants.txt")
LABEL = 50
"""How long a text is that is no label any more, but a sentence."""
MODULES = [
    found.name
    for package in (edugym.lessons, edugym.exercises)
    for found in pkgutil.walk_packages(package.__path__, f"{package.__name__}.", onerror=str)
]


def constants(name: str) -> Iterator[str]:
    """A line for each plain value in capitals that a module itself defines."""
    module = importlib.import_module(name)
    for statement in ast.parse(Path(module.__file__ or "").read_text(encoding="utf-8")).body:
        targets = statement.targets if isinstance(statement, ast.Assign) else [getattr(statement, "target", None)]
        for node in (part for target in targets if target is not None for part in ast.walk(target)):
            if isinstance(node, ast.Name) and node.id.isupper() and not node.id.startswith("_"):
                value = getattr(module, node.id)
                if is_plain(value):
                    yield f"{name}.{node.id} = {dict(value) if isinstance(value, Mapping) else value!r}"


def is_plain(value: Any) -> bool:
    """Whether it is a number or a label, or made of such; sentences have tests of their own."""
    if isinstance(value, Mapping):
        value = (*value.keys(), *value.values())
    if isinstance(value, tuple):
        return all(map(is_plain, value))
    return isinstance(value, int | float) or (isinstance(value, str) and len(value) < LABEL)


def test_constants() -> None:
    """If the change is meant, delete the file: this test writes it anew, for you to read what has changed."""
    now: list[str] = []
    missing: list[str] = []
    for module in MODULES:
        try:
            now += constants(module)
        except (ImportError, DependencyNotInstalled):
            missing.append(f"{module}.")
    if not FILE.exists():
        FILE.write_text("\n".join(now) + "\n", encoding="utf-8")
        pytest.fail(f"{FILE} is new: read it, and commit it")
    before = FILE.read_text(encoding="utf-8").splitlines()
    assert now == [line for line in before if not line.startswith(tuple(missing))]

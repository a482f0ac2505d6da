"""Notebooks that students wrote with version 0.1 still find what they call in a lesson, by its old name."""

import ast
import importlib
import sys
from types import ModuleType

import pytest

from edugym.training.attempt import attempt
from edugym_course.lessons.exploration.methods import compare
from edugym_course.lessons.loop.methods import Q_LEARNING
from edugym_course.lessons.memory.players import N_STEPS
from edugym_course.lessons.own_problem.bedroom import bedroom
from tests.course.lessons.shown import NOTEBOOKS

pytestmark = pytest.mark.filterwarnings("ignore:.* has moved")


def called(lesson: str) -> set[str]:
    """What the text of a lesson calls in the lesson's own modules; version 0.1 handed all of it on."""
    tree = ast.parse(NOTEBOOKS[lesson].read_text(encoding="utf-8"))
    imports = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    own = {name.name for node in imports if node.module == f"edugym_course.lessons.{lesson}" for name in node.names}
    attributes = [node for node in ast.walk(tree) if isinstance(node, ast.Attribute)]
    return {node.attr for node in attributes if isinstance(node.value, ast.Name) and node.value.id in own}


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_a_notebook_finds_what_it_calls(lesson: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """None is a module, and the first import says where the lesson is now."""
    monkeypatch.delitem(sys.modules, f"edugym.lessons.{lesson}", raising=False)
    with pytest.warns(DeprecationWarning, match=f"import edugym_course.lessons.{lesson}"):
        old = importlib.import_module(f"edugym.lessons.{lesson}")
    assert called(lesson)
    assert [name for name in called(lesson) if isinstance(getattr(old, name), ModuleType)] == []
    with pytest.raises(AttributeError, match="nothing"):
        _ = old.nothing


@pytest.mark.parametrize(
    ("lesson", "name", "value"),
    [
        ("exploration", "compare", compare),
        ("model_based", "attempt", attempt),
        ("loop", "Q_LEARNING", Q_LEARNING),
        ("memory", "N_STEPS", N_STEPS),
        ("own_problem", "bedroom", bedroom),
    ],
)
def test_names_that_several_files_have(lesson: str, name: str, value: object) -> None:
    """Files, exercises or other modules have them too."""
    assert getattr(importlib.import_module(f"edugym.lessons.{lesson}"), name) is value

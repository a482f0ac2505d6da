"""A page for each agent, from its docstring, its code, the lessons that use it, and what it was measured to return."""

import ast
import inspect
import json
import re
import sys
from collections.abc import Iterator
from typing import Any

from docstrings import described, markdown, source, summary
from lesson_pages import Lesson
from repository import REPOSITORY, ROOT

import edugym
from edugym.adapters.registration import in_course_order

PAGE = """\
# {name}

{equation}

## The code that runs

{code}

The whole file: [`{path}`]({repository}/blob/main/{path}).

{details}

## Where it works

This is what {name} returned after 100,000 training steps at its defaults, in the environments that it fits.
[All agents side by side](index.md) says how this was measured.

| environment | return | best possible |
|---|---|---|
{works}

## In the lessons

{lessons}

## Reference

{reference}
"""
SHOWN = ("learn", "act")
"""The methods that are the algorithm."""

MEASURED = json.loads((ROOT / "docs" / "agents.json").read_text(encoding="utf-8"))
AGENTS: dict[str, Any] = {name: getattr(edugym, name) for name in MEASURED["cells"]}


def place(kind: Any) -> str:
    """Return the page of an agent, such as "agents/q_learning"."""
    return f"agents/{kind.__module__.rpartition('.')[2]}"


def pages(lessons: list[Lesson]) -> dict[str, str]:
    """Return the pages of all agents, in Markdown."""
    return {place(kind): page(name, kind, lessons) for name, kind in AGENTS.items()}


def page(name: str, kind: Any, lessons: list[Lesson]) -> str:
    """Return the page of an agent."""
    code = "\n\n\n".join([*map(source, (vars(kind)[method] for method in SHOWN)), *helpers(kind)])
    equation, attributes, details = markdown(kind).partition("**Attributes**")
    path = f"src/{kind.__module__.replace('.', '/')}.py"
    return PAGE.format(
        name=name,
        equation=equation,
        details=attributes + details,
        code=f"```python\n{code}\n```",
        path=path,
        repository=REPOSITORY,
        works="\n".join(_works(name)),
        lessons="\n".join(_used(name, lessons))
        or "No lesson uses it. Try it in one of them, in place of another agent.",
        reference=described(name, kind, docstring=summary(kind)),
    )


def helpers(kind: Any) -> Iterator[str]:
    """Yield the source of what the algorithm calls: methods of the agent, and functions of the room of agents."""
    module, seen, todo = sys.modules[kind.__module__], set(SHOWN), [vars(kind)[method] for method in SHOWN]
    while todo:
        function = todo.pop(0)
        for node in ast.walk(ast.parse(source(function))):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "self":
                label, found = node.attr, vars(kind).get(node.attr)
            elif isinstance(node, ast.Name):
                label, found = node.id, vars(module).get(node.id)
            else:
                continue
            if label not in seen and inspect.isfunction(found) and found.__module__.startswith("edugym.agents."):
                seen.add(label)
                todo.append(found)
                yield source(found)


def _works(name: str) -> Iterator[str]:
    for entry in in_course_order():
        if entry.name in MEASURED["cells"][name]:
            best = MEASURED["bounds"][entry.name].get("best")
            returned = MEASURED["cells"][name][entry.name]["return"]
            link = f"[{entry.name}](../environments/{entry.name.lower()}.md)"
            yield f"| {link} | {returned:.3g} | {'' if best is None else f'{best:.3g}'} |"


def _used(name: str, lessons: list[Lesson]) -> Iterator[str]:
    for lesson in lessons:
        if re.search(rf"\b{name}\b", lesson.text):
            yield f"- [{lesson.title}](../lessons/{lesson.name}.md)"

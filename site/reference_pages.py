"""The reference: every public name of the package, by the room in which it is defined."""

import ast
import importlib
from typing import Any, NamedTuple

from agent_pages import AGENTS, place
from docstrings import described, markdown, summary
from repository import ROOT

HEAD = "# Reference\n\nEvery public name of `edugym`, by the room of the package in which it is defined.\n"


class Name(NamedTuple):
    """A public name.

    Attributes:
        name: the name.
        room: the room of the package, such as "agents".
        thing: what has the name.
    """

    name: str
    room: str
    thing: Any


def public_names() -> list[Name]:
    """Return the public names in the order of `__init__.pyi`, the one list of them."""
    listed = ast.parse((ROOT / "src" / "edugym" / "__init__.pyi").read_text(encoding="utf-8")).body
    return [
        Name(alias.name, node.module.split(".")[1], getattr(importlib.import_module(node.module), alias.name))
        for node in listed
        if isinstance(node, ast.ImportFrom) and node.module
        for alias in node.names
    ]


def pages() -> dict[str, str]:
    """Return the page of each room, and the one that lists all names."""
    names = public_names()
    rooms = {name.room: importlib.import_module(f"edugym.{name.room}") for name in names}
    written = {f"reference/{room}": _page(room, rooms[room], names) for room in rooms}
    tables = [_table(room, names) for room in rooms]
    toctree = "\n".join(["```{toctree}", ":hidden:", *rooms, "```"])
    return {"reference/index": "\n\n".join([HEAD, *tables, toctree, ""]), **written}


def _page(room: str, module: Any, names: list[Name]) -> str:
    own = [name for name in names if name.room == room and name.name not in AGENTS]
    parts = [described(name.name, name.thing) for name in own]
    more = "Each agent has [a page of its own](../agents/index.md).\n" if room == "agents" else ""
    return "\n\n".join([f"# edugym.{room}", markdown(module), more, *parts, ""])


def _table(room: str, names: list[Name]) -> str:
    rows = [f"| {_link(name)} | {_says(name)} |" for name in names if name.room == room]
    return "\n".join([f"## [{room}]({room}.md)", "", "| name | what it is |", "|---|---|", *rows])


def _link(name: Name) -> str:
    return f"[`{name.name}`](../{place(name.thing)}.md)" if name.name in AGENTS else f"{{py:obj}}`edugym.{name.name}`"


def _says(name: Name) -> str:
    return "The environments of the course." if name.name == "ENVIRONMENTS" else summary(name.thing).replace("|", "\\|")

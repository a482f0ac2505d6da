"""The reference: every public name of the package, by the room in which it is defined."""

import ast
import importlib
from contextlib import suppress
from typing import Any, NamedTuple

from agent_pages import AGENTS, place
from docstrings import described, markdown, summary
from gymnasium.error import DependencyNotInstalled
from repository import ROOT

HEAD = """# Reference

Every public name of `edugym`, by the room of the package in which it is defined; and those of `edugym.games`,
`edugym.objectives` and `edugym.deep`, which one imports from there.
"""
ENTRIES = (
    "The environments of the course, by name. Each entry has a `name`, such as `Boulder`, an `id` for"
    " `gymnasium.make`, the `challenge` that it isolates, and the number of its `lesson`."
)
MORE = {
    "agents": "Each agent has [a page of its own](../agents/index.md).\n",
    "envs": "Each environment has [a page of its own](../environments/index.md).\n",
}
LISTS = ("games", "objectives", "deep")
"""Modules that list public names of their own."""


class Name(NamedTuple):
    """A public name.

    Attributes:
        name: the name.
        room: the room of the package, such as "agents", or the module that lists it, such as "games".
        thing: what has the name.
        module: where it is imported from.
    """

    name: str
    room: str
    thing: Any
    module: str = "edugym"


def public_names() -> list[Name]:
    """Return the public names in the order of `__init__.pyi`, the one list of them, and then those of `LISTS`."""
    listed = ast.parse((ROOT / "src" / "edugym" / "__init__.pyi").read_text(encoding="utf-8")).body
    names = [
        Name(alias.name, node.module.split(".")[1], getattr(importlib.import_module(node.module), alias.name))
        for node in listed
        if isinstance(node, ast.ImportFrom) and node.module
        for alias in node.names
    ]
    for listing in LISTS:
        module = importlib.import_module(f"edugym.{listing}")
        for name in module.__all__:
            with suppress(DependencyNotInstalled):  # the site needs no torch, and some names of `deep` do
                names.append(Name(name, listing, getattr(module, name), module.__name__))
    return names


def pages() -> dict[str, str]:
    """Return the page of each room, and the one that lists all names."""
    names = public_names()
    rooms = {name.room: importlib.import_module(f"edugym.{name.room}") for name in names}
    written = {f"reference/{room}": _page(room, rooms[room], names) for room in rooms}
    tables = [_table(room, names) for room in rooms]
    toctree = "\n".join(["```{toctree}", ":hidden:", *rooms, "```"])
    return {"reference/index": "\n\n".join([HEAD, *tables, toctree, ""]), **written}


def _page(room: str, module: Any, names: list[Name]) -> str:
    own = [name for name in names if name.room == room and _own_page(name) is None]
    about = {"ENVIRONMENTS": ENTRIES}
    parts = [described(name.name, name.thing, name.module, about.get(name.name)) for name in own]
    return "\n\n".join([f"# edugym.{room}", markdown(module), MORE.get(room, ""), *parts, ""])


def _table(room: str, names: list[Name]) -> str:
    rows = [f"| {_link(name)} | {_says(name)} |" for name in names if name.room == room]
    return "\n".join([f"## [{room}]({room}.md)", "", "| name | what it is |", "|---|---|", *rows])


def _link(name: Name) -> str:
    page = _own_page(name)
    return f"[`{name.name}`](../{page}.md)" if page else f"{{py:obj}}`{name.module}.{name.name}`"


def _own_page(name: Name) -> str | None:
    """The page of an agent or an environment."""
    if name.room == "envs":
        return f"environments/{name.name.lower()}"
    return place(name.thing) if name.name in AGENTS else None


def _says(name: Name) -> str:
    return "The environments of the course." if name.name == "ENVIRONMENTS" else summary(name.thing).replace("|", "\\|")

"""Draw the rooms of EduGym and what imports what, and write their table into ARCHITECTURE.md; both come from the code.

The floors are the layers in pyproject.toml, which import-linter checks. The sentence about a room is the first one of
its `__init__.py`, and the arrows are the imports in its files. Arrows that follow from a chain of others are left out.

    python docs/architecture.py            write the picture and the table
    python docs/architecture.py --check    write nothing; fail if one of them is out of date
"""

import argparse
import ast
import math
import sys
import tomllib
from pathlib import Path
from typing import NamedTuple

import grimp

from edugym.rendering import palette
from edugym.rendering.scene import Line, Polygon, Rectangle, Scene, Shape, Text
from edugym.rendering.svg import to_svg

ROOT = Path(__file__).resolve().parent.parent
PAGE, PICTURE = ROOT / "ARCHITECTURE.md", ROOT / "docs" / "architecture.svg"
BEGIN, END = "<!-- rooms: written by docs/architecture.py -->\n", "<!-- end of rooms -->\n"
WIDTH, BOX, BOX_HEIGHT, FLOOR, MARGIN = 62.0, 15.0, 3.2, 5.4, 1.0
"""Sizes in the picture: of the whole, of a box, between two floors, around all."""


class Room(NamedTuple):
    """A folder of the package.

    Attributes:
        name: its name, "edugym.agents".
        floor: the number of the layer, 0 for the lowest.
        purpose: what it is for, in one sentence.
        imports: the rooms that its files import.
    """

    name: str
    floor: int
    purpose: str
    imports: frozenset[str]


def layers() -> list[list[str]]:
    """Return the names of the rooms on each floor, the highest first: the course, then the library's layers."""
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    contracts = tomllib.loads(text)["tool"]["importlinter"]["contracts"]
    [library] = [contract for contract in contracts if contract.get("containers") == ["edugym"]]
    floors = [[f"edugym.{name.strip()}" for name in layer.split("|")] for layer in library["layers"]]
    folders = [[name for name in floor if (ROOT / "src" / name.replace(".", "/")).is_dir()] for floor in floors]
    return [["edugym_course"], *filter(None, folders)]


def rooms() -> list[Room]:
    """Return all rooms, the highest first."""
    graph = grimp.build_graph("edugym", "edugym_course", cache_dir=None)
    floors = layers()
    names = {name for floor in floors for name in floor}
    for name in names:
        graph.squash_module(name)
    return [
        Room(
            name,
            height,
            purpose(name),
            frozenset(graph.find_modules_directly_imported_by(name) & (names - {name})),
        )
        for height, floor in zip(reversed(range(len(floors))), floors, strict=True)
        for name in floor
    ]


def purpose(name: str) -> str:
    """Return the first sentence of a room's docstring."""
    file = ROOT / "src" / name.replace(".", "/") / "__init__.py"
    text = ast.get_docstring(ast.parse(file.read_text(encoding="utf-8"))) or ""
    return " ".join(text.split("\n\n")[0].split())


def shown_arrows(found: list[Room]) -> list[tuple[Room, Room]]:
    """Return the imports to draw: those that do not follow from two others."""
    by_name = {room.name: room for room in found}

    def reaches(room: Room, goal: str) -> bool:
        return goal in room.imports or any(reaches(by_name[name], goal) for name in room.imports)

    return [
        (room, by_name[name])
        for room in found
        for name in sorted(room.imports)
        if not any(reaches(by_name[other], name) for other in room.imports - {name})
    ]


def picture(found: list[Room]) -> Scene:
    """Draw the rooms on their floors, with arrows from each room to those that it imports."""
    height = 2 * MARGIN + BOX_HEIGHT + found[0].floor * FLOOR
    places: dict[str, tuple[float, float]] = {}
    for floor in range(found[0].floor + 1):
        here = [room for room in found if room.floor == floor]
        for k, room in enumerate(here):
            x = WIDTH / 2 + (k - (len(here) - 1) / 2) * (BOX + 4)
            places[room.name] = x, height - MARGIN - BOX_HEIGHT / 2 - floor * FLOOR
    shapes: list[Shape] = []
    lanes = {-1: 0, 1: 0}  # the number of long arrows on the left and on the right of the boxes
    for upper, lower in shown_arrows(found):
        start, end = places[upper.name], places[lower.name]
        if upper.floor - lower.floor == 1:
            shapes += arrow([(start[0], start[1] + BOX_HEIGHT / 2), (end[0], end[1] - BOX_HEIGHT / 2)])
            continue
        outer = start[0] + end[0] - WIDTH  # a box on one side is reached from that side
        side = (1 if outer > 0 else -1) if outer else min(lanes, key=lambda one: lanes[one])
        lanes[side] += 1
        lane = WIDTH / 2 + side * (BOX + 3 + 1.6 * lanes[side])
        edges = [(x + side * BOX / 2, y + step) for (x, y), step in ((start, 0.5), (end, -0.5))]
        shapes += arrow([edges[0], (lane, edges[0][1]), (lane, edges[1][1]), edges[1]])
    for room in found:
        x, y = places[room.name]
        shapes.append(Rectangle(x - BOX / 2, y - BOX_HEIGHT / 2, BOX, BOX_HEIGHT, radius=0.6, outline_width=0.2))
        shapes.append(Text(x, y, room.name.removeprefix("edugym."), size=1.8))
    return Scene(WIDTH, height, tuple(shapes), title="The rooms of EduGym: each imports only rooms below it")


def arrow(points: list[tuple[float, float]]) -> list[Shape]:
    """Draw an arrow along points; its last part runs straight down or sideways."""
    (x, y), (tip_x, tip_y) = points[-2], points[-1]
    length = math.hypot(tip_x - x, tip_y - y)
    ahead = (tip_x - x) / length, (tip_y - y) / length
    back = tip_x - 0.9 * ahead[0], tip_y - 0.9 * ahead[1]
    wings = [(back[0] + 0.35 * side * ahead[1], back[1] - 0.35 * side * ahead[0]) for side in (-1, 1)]
    head = Polygon([(tip_x, tip_y), *wings], fill=palette.INK)
    return [Line([*points[:-1], back], line_width=0.12), head]


def table(found: list[Room]) -> str:
    """Return the table of the rooms in Markdown: what each is for, and what it imports."""
    rows = ["| room | what it is for | imports |", "|---|---|---|"]
    for room in found:
        path = f"src/{room.name.replace('.', '/')}"
        below = ", ".join(other.name.removeprefix("edugym.") for other in found if other.name in room.imports)
        rows.append(f"| [`{room.name.removeprefix('edugym.')}`]({path}) | {room.purpose} | {below or 'none'} |")
    return "\n".join(rows) + "\n"


def main() -> int:
    """Write the picture and the table, or check them."""
    parser = argparse.ArgumentParser(description="Draw the rooms of EduGym and write their table.")
    parser.add_argument("--check", action="store_true", help="write nothing; fail if one is out of date")
    check = parser.parse_args().check
    found = rooms()
    text = PAGE.read_text(encoding="utf-8")
    head, _, rest = text.partition(BEGIN)
    made = {PICTURE: to_svg(picture(found)), PAGE: head + BEGIN + table(found) + END + rest.partition(END)[2]}
    stale = [path for path, now in made.items() if not path.exists() or path.read_text(encoding="utf-8") != now]
    for path in stale:
        if check:
            print(f"out of date: {path.name}; run python docs/architecture.py", file=sys.stderr)
        else:
            path.write_text(made[path], encoding="utf-8", newline="\n")
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main())

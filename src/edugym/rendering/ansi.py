"""Scenes as characters, for a terminal."""

import math
from collections.abc import Iterator
from itertools import groupby, pairwise

from edugym.rendering.palette import INK, rgb
from edugym.rendering.scene import (
    ANCHORS,
    Arc,
    Circle,
    Ellipse,
    Filled,
    Line,
    Point,
    Polygon,
    Rectangle,
    Scene,
    Shape,
    Stroke,
    Text,
)

Cell = tuple[str, str, str]
"""A character, its colour, and the colour behind it ("" for the one that is there already)."""
Place = tuple[int, int, Cell]
"""A column, a row, and what is written there."""


def to_text(scene: Scene, columns: int | None = None, colour: bool = False) -> str:
    """Draw a scene with characters, which are taken to be twice as high as wide.

    Only texts and shapes that have a ``glyph`` are drawn. A single character fills the area of a rectangle and follows
    the path of a line or an arc; everything else is written at the middle of the shape. What falls outside is cut off.

    Args:
        scene: What to draw.
        columns: Characters in a line; None for the scene's own ``columns``.
        colour: Whether to colour them with ANSI escape sequences, for terminals that know 24-bit colours.

    Returns:
        The lines, without trailing blanks unless they are coloured, and without a newline at the end.

    Raises:
        ValueError: If ``columns`` is not positive.
        TypeError: If a shape of an unknown class has a glyph.
    """
    columns = scene.columns if columns is None else columns
    if columns < 1:
        raise ValueError(f"columns must be 1 or more, got {columns!r}")
    rows = max(1, round(columns * scene.height / scene.width / 2))
    grid: list[list[Cell]] = [[(" ", INK, scene.background)] * columns for _ in range(rows)]
    for shape in scene.shapes:
        for column, row, (character, front, behind) in _places(shape, columns / scene.width, rows / scene.height):
            if 0 <= row < rows and 0 <= column < columns:
                grid[row][column] = character, front, behind or grid[row][column][2]
    return "\n".join(map(_coloured if colour else _plain, grid))


def _plain(line: list[Cell]) -> str:
    return "".join(character for character, _, _ in line).rstrip()


def _coloured(line: list[Cell]) -> str:
    """Write a line with an escape sequence at each change of colours, and one at the end."""
    pieces = []
    for (front, behind), cells in groupby(line, key=lambda cell: cell[1:]):
        colours = "38;2;{};{};{};48;2;{};{};{}".format(*rgb(front), *rgb(behind))
        pieces.append(f"\x1b[{colours}m" + "".join(character for character, _, _ in cells))
    return "".join(pieces) + "\x1b[0m"


def _places(shape: Shape, across: float, down: float) -> Iterator[Place]:
    """Yield all that a shape writes, where a unit of the scene is ``across`` columns wide and ``down`` rows high."""
    if not isinstance(shape, Text) and not shape.glyph:
        return
    match shape:
        case Text():
            string = shape.glyph or shape.content
            yield from _string(string, shape.x * across, shape.y * down, ANCHORS[shape.anchor], (shape.colour, ""))
        case Rectangle(glyph=glyph) if len(glyph) == 1:
            rows = _span(shape.y * down, shape.height * down)
            columns = _span(shape.x * across, shape.width * across)
            yield from ((column, row, (glyph, *_colours(shape))) for row in rows for column in columns)
        case Line(glyph=glyph) | Arc(glyph=glyph) if len(glyph) == 1:
            for (x, y), (next_x, next_y) in pairwise(shape.points):
                steps = math.ceil(max(abs(next_x - x) * across, abs(next_y - y) * down, 1))
                for part in (k / steps for k in range(steps + 1)):
                    column, row = (x + part * (next_x - x)) * across, (y + part * (next_y - y)) * down
                    yield math.floor(column), math.floor(row), (glyph, *_colours(shape))
        case _:
            x, y = _middle(shape)
            yield from _string(shape.glyph, x * across, y * down, ANCHORS["middle"], _colours(shape))


def _string(characters: str, x: float, y: float, shift: float, colours: tuple[str, str]) -> Iterator[Place]:
    """Yield the characters of a string, of which the share ``shift`` lies before x; x and y count columns and rows."""
    first, row = _first(x - shift * len(characters)), math.floor(round(y, 6))
    yield from ((first + k, row, (character, *colours)) for k, character in enumerate(characters))


def _first(edge: float) -> int:
    """Return the first cell whose middle lies on or after an edge; rounded, lest 0.3 / 0.1 fall short of 3."""
    return math.ceil(round(edge - 0.5, 6))


def _span(start: float, length: float) -> range:
    """Return the cells whose middle lies in [start, start + length), or the one around it if it is too small."""
    middle = math.floor(start + length / 2)
    return range(_first(start), _first(start + length)) or range(middle, middle + 1)


def _middle(shape: Shape) -> Point:
    match shape:
        case Rectangle():
            return shape.x + shape.width / 2, shape.y + shape.height / 2
        case Circle() | Ellipse():
            return shape.x, shape.y
        case Polygon() | Line() | Arc():
            xs, ys = zip(*shape.points, strict=True)
            return (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    raise TypeError(f"no characters for a shape of class {type(shape).__name__}")


def _colours(shape: Shape) -> tuple[str, str]:
    """Return the colours of a shape's character and behind it: those of its edge and of its inside."""
    if isinstance(shape, Filled):
        return shape.outline or shape.fill or INK, shape.fill or ""
    return shape.colour if isinstance(shape, Stroke) else INK, ""

"""Scenes as characters, for a terminal."""

import math
from collections.abc import Iterator
from itertools import groupby, pairwise

from edugym.rendering.clipping import visible
from edugym.rendering.palette import INK, rgb
from edugym.rendering.scene import Scene
from edugym.rendering.shapes import ANCHORS, Arc, Circle, Filled, Line, Point, Polygon, Rectangle, Shape, Stroke, Text

MOST_CELLS = 500
"""The largest number of characters in a line, and of lines."""

Cell = tuple[str, str, str]
"""A character, its colour, and the colour behind it ("" keeps the colour behind it as it is)."""
Place = tuple[int, int, Cell]
"""A column, a row, and the cell to write there."""


def to_text(scene: Scene, columns: int | None = None, colour: bool = False) -> str:
    """Draw a scene with characters, as if each were twice as high as it is wide.

    Only texts and shapes with a `glyph` are drawn. A single character fills the area of a rectangle and follows the
    path of a line or an arc; any other glyph is written at the middle of the shape. The edge of the picture cuts off
    the rest.

    Args:
        scene: The scene.
        columns: Characters in a line; None for the scene's own `columns`. At most `MOST_CELLS` are drawn, and as many
            lines; the picture is squeezed to fit.
        colour: Whether to colour them with ANSI escape sequences, for terminals with 24-bit colours.

    Returns:
        The lines. Trailing blanks are left out unless they are coloured, and so is the newline at the end.

    Raises:
        ValueError: If ``columns`` is not positive.
        TypeError: If a shape of an unknown class has a glyph.
    """
    columns = scene.columns if columns is None else columns
    if columns < 1:
        raise ValueError(f"columns must be 1 or more, got {columns!r}")
    columns = int(min(columns, MOST_CELLS))
    rows = max(1, round(min(columns * scene.height / scene.width / 2, MOST_CELLS)))
    grid: list[list[Cell]] = [[(" ", INK, scene.background)] * columns for _ in range(rows)]
    for shape in visible(scene):
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
    """Yield the characters of a shape, where a unit of the scene is `across` columns wide and `down` rows high."""
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
                    yield math.floor(round(column, 6)), math.floor(round(row, 6)), (glyph, *_colours(shape))
        case _:
            x, y = _middle(shape)
            yield from _string(shape.glyph, x * across, y * down, ANCHORS["middle"], _colours(shape))


def _string(characters: str, x: float, y: float, shift: float, colours: tuple[str, str]) -> Iterator[Place]:
    """Yield the characters of a string, with the share `shift` of them before x; x and y count columns and rows."""
    first, row = _first(x - shift * len(characters)), math.floor(round(y, 6))
    yield from ((first + k, row, (character, *colours)) for k, character in enumerate(characters))


def _first(edge: float) -> int:
    """Return the first cell whose middle lies on or after an edge, after rounding (0.3 / 0.1 is less than 3)."""
    return math.ceil(round(edge - 0.5, 6))


def _span(start: float, length: float) -> range:
    """Return the cells with their middle in [start, start + length); if there is none, the cell around its middle."""
    middle = math.floor(start + length / 2)
    return range(_first(start), _first(start + length)) or range(middle, middle + 1)


def _middle(shape: Shape) -> Point:
    match shape:
        case Rectangle():
            return shape.x + shape.width / 2, shape.y + shape.height / 2
        case Circle():
            return shape.x, shape.y
        case Polygon() | Line() | Arc():
            xs, ys = zip(*shape.points, strict=True)
            return (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    raise TypeError(f"no characters for a shape of class {type(shape).__name__}")


def _colours(shape: Shape) -> tuple[str, str]:
    """Return the colour of a shape's character (its outline) and the colour behind it (its fill)."""
    if isinstance(shape, Filled):
        return shape.outline or shape.fill or INK, shape.fill or ""
    return shape.colour if isinstance(shape, Stroke) else INK, ""

"""Tile coding as a picture."""

from edugym.rendering.palette import BLUE, INK, ORANGE
from edugym.rendering.scene import Circle, Line, Rectangle, Scene, Shape, Text

SIDE, N_TILES, SHIFT = 1.6, 4, 0.5
"""The side of a tile, how many a grid has in a row, and by what share of a tile the second grid is displaced."""
PLACES = {"A": (3.2, 3.37), "B": (4.05, 3.4)}


def tile_coding() -> Scene:
    """Draw two grids, and the tiles in which two places lie."""
    shapes = list[Shape]()
    for grid, (origin, colour) in enumerate(((1.2, BLUE), (1.2 - SHIFT * SIDE, ORANGE))):
        n = N_TILES + grid
        ends = origin, origin + n * SIDE
        for k in range(n + 1):
            at = origin + k * SIDE
            shapes += [Line([(ends[0], at), (ends[1], at)], colour=colour, line_width=0.04)]
            shapes += [Line([(at, ends[0]), (at, ends[1])], colour=colour, line_width=0.04)]
        for x, y in PLACES.values():
            left, top = (origin + SIDE * ((place - origin) // SIDE) for place in (x, y))
            shapes.append(Rectangle(left, top, SIDE, SIDE, fill=None, outline=colour, outline_width=0.16))
    for name, (x, y) in PLACES.items():
        shapes += [Circle(x, y, 0.12, fill=INK), Text(x, y - 0.33, name, 0.42)]
    for k, (words, colour) in enumerate((("grid 1", BLUE), ("grid 2, displaced", ORANGE))):
        shapes += [Line([(9.0, 1.6 + k), (9.8, 1.6 + k)], colour=colour, line_width=0.1)]
        shapes += [Text(10.1, 1.6 + k, words, 0.5, anchor="start")]
    lines = (
        "Each place lies in one tile",
        "of each grid: two features are 1.",
        "A and B have that of grid 1",
        "in common, and not that of grid 2:",
        "B gets half of what A learns.",
    )
    shapes += [Text(9.0, 4.0 + 0.75 * k, line, 0.5, anchor="start") for k, line in enumerate(lines)]
    title = (
        "Two grids of tiles over a plane, the second displaced by half a tile. Two near places, A and B, lie in the"
        " same tile of one grid and in different tiles of the other."
    )
    return Scene(17.4, 8.6, shapes, title=title)

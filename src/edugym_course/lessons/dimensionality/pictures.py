"""The filters of two convolutional networks as a picture."""

from edugym.rendering.palette import BLUE, GREEN, INK, ORANGE, PAPER, SHADE
from edugym.rendering.scene import Line, Rectangle, Scene, Shape, Text

ROWS, COLUMNS = 10, 5
CELL = 0.6


def filters() -> Scene:
    """Draw a board under a filter of 3 by 3, and one under a filter of 10 by 9, each at two places."""
    shapes = list[Shape]()
    _board(shapes, 3.2, 1.4)
    _frame(shapes, 3.2, 1.4, 0, 1, 3, 3, BLUE)
    _frame(shapes, 3.2, 1.4, 2, 5, 3, 3, BLUE)
    _arrow(shapes, 3.2 + 1.5 * CELL, 1.4 + 4.3 * CELL, 3.2 + 2.6 * CELL, 1.4 + 4.9 * CELL)
    left = 12.2
    _board(shapes, left, 1.4)
    for columns, lower, colour in ((-4, 0.1, ORANGE), (-1, -0.1, GREEN)):
        x, y = left + columns * CELL, 1.4 - lower
        shapes.append(Rectangle(x, y, 9 * CELL, ROWS * CELL + 2 * lower, fill=None, outline=colour, outline_width=0.14))
    _arrow(shapes, left - 1.4, 7.95, left + 1.0, 7.95)
    for x, lines in (
        (3.2 + 2.5 * CELL, ("small CNN: 3 by 3 pixels,", "the same weights at every place")),
        (left + 2.5 * CELL, ("CNN over columns: 10 by 9 pixels,", "the ball and the paddle in one look")),
    ):
        shapes += [Text(x, 8.6 + 0.65 * k, line, 0.45) for k, line in enumerate(lines)]
    title = (
        "Left: a filter of 3 by 3 pixels at two places of a board of 10 rows and 5 columns; it sees the ball or the"
        " paddle. Right: a filter of 10 by 9 pixels at two places; it reaches beyond the edges and sees both."
    )
    return Scene(18.6, 9.9, shapes, title=title)


def _board(shapes: list[Shape], x: float, y: float) -> None:
    """Add a board with a ball and a paddle."""
    for row in range(ROWS):
        for column in range(COLUMNS):
            lit = (row, column) in ((2, 1), (9, 3))
            shapes.append(
                Rectangle(x + column * CELL, y + row * CELL, CELL, CELL, fill=INK if lit else PAPER, outline=SHADE)
            )
    shapes.append(Rectangle(x, y, COLUMNS * CELL, ROWS * CELL, fill=None))


def _frame(
    shapes: list[Shape], x: float, y: float, column: int, row: int, width: int, height: int, colour: str
) -> None:
    """Add the frame of a filter that stands at a place of the board."""
    at = x + column * CELL, y + row * CELL
    shapes.append(Rectangle(*at, width * CELL, height * CELL, fill=None, outline=colour, outline_width=0.14))


def _arrow(shapes: list[Shape], x: float, y: float, to_x: float, to_y: float) -> None:
    """Add an arrow: where the filter goes next."""
    dx, dy = to_x - x, to_y - y
    size = (dx * dx + dy * dy) ** 0.5
    dx, dy = 0.3 * dx / size, 0.3 * dy / size
    shapes.append(Line([(x, y), (to_x, to_y)], line_width=0.09))
    head = [(to_x - dx - 0.6 * dy, to_y - dy + 0.6 * dx), (to_x, to_y), (to_x - dx + 0.6 * dy, to_y - dy - 0.6 * dx)]
    shapes.append(Line(head, line_width=0.09))

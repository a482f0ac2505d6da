"""Scenes with lines of text below them, for films and windows."""

from collections.abc import Sequence
from dataclasses import replace

from edugym.rendering.drawing import LONGEST_SIDE
from edugym.rendering.palette import PAPER
from edugym.rendering.scene import Scene
from edugym.rendering.shapes import Arc, Circle, Line, Point, Polygon, Rectangle, Shape, Text

WIDTH = 400
"""The smallest width of a picture with a caption, in pixels: a narrow picture needs room for its text."""
FONT_SIZE = 14
"""In pixels, for lines that fit."""
LINE_HEIGHT = 20
"""In pixels."""
LETTER_WIDTH = 0.58
"""The mean width of a letter as a share of the font size: slightly more than in Helvetica Bold."""


def captioned(scene: Scene, lines: Sequence[str]) -> Scene:
    """Put lines of text below a scene, on paper; a long line is written smaller.

    Args:
        scene: The picture.
        lines: The text; an empty line stays empty.

    Returns:
        The picture with the text below it, with margins on both sides if it is too narrow for text. Scenes of one size
        with the same number of lines give pictures of one size.

    Raises:
        ValueError: If a line has characters that cannot be printed on one line.
        TypeError: If the scene has a shape of an unknown class.
    """
    pixel = scene.longer_side / LONGEST_SIDE
    width, height = max(scene.width, WIDTH * pixel), (len(lines) + 0.5) * LINE_HEIGHT * pixel
    margin = (width - scene.width) / 2
    shapes: list[Shape] = [
        Rectangle(margin, 0, scene.width, scene.height, fill=scene.background, outline=None),
        *(_moved(shape, margin) for shape in scene.shapes),
        # Hide the parts of shapes that reach beyond the edges of the picture.
        Rectangle(0, 0, margin, scene.height, fill=PAPER, outline=None),
        Rectangle(width - margin, 0, margin, scene.height, fill=PAPER, outline=None),
        Rectangle(0, scene.height, width, height, fill=PAPER, outline=None),
    ]
    for k, line in enumerate(lines):
        size = min(FONT_SIZE * pixel, 0.95 * width / (LETTER_WIDTH * max(1, len(line))))
        shapes.append(Text(width / 2, scene.height + (k + 0.75) * LINE_HEIGHT * pixel, line, size=size))
    return replace(scene, width=width, height=scene.height + height, shapes=shapes, background=PAPER)


def _moved(shape: Shape, dx: float) -> Shape:
    """Return a shape moved to the right by `dx`."""
    match shape:
        case Polygon() | Line():
            points: list[Point] = [(x + dx, y) for x, y in shape.points]
            return replace(shape, points=points)
        case Rectangle() | Circle() | Arc() | Text():
            return replace(shape, x=shape.x + dx)
    raise TypeError(f"a shape of class {type(shape).__name__} cannot be moved")

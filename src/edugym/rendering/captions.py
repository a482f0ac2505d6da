"""Scenes with text below them, for films and windows, where no page around the picture can hold it."""

from collections.abc import Sequence
from dataclasses import replace

from edugym.rendering.palette import PAPER
from edugym.rendering.scene import (
    LONGEST_SIDE,
    Arc,
    Circle,
    Ellipse,
    Line,
    Point,
    Polygon,
    Rectangle,
    Scene,
    Shape,
    Text,
)

WIDTH = 400
"""A captioned picture is at least so wide, in pixels, so that a narrow one has room for its text."""
FONT_SIZE = 14
"""Pixels, for lines that fit."""
LINE_HEIGHT = 20
"""Pixels."""
LETTER_WIDTH = 0.58
"""What a letter takes on average, as a share of the font size: slightly more than in Helvetica Bold."""


def captioned(scene: Scene, lines: Sequence[str]) -> Scene:
    """Put lines of text below a scene, on paper; a long line is written smaller.

    Args:
        scene: The picture. Scenes of one size give captioned scenes of one size, if there are as many lines below each.
        lines: The text; an empty line stays empty.

    Returns:
        The picture, in the middle of a wider one where it is too narrow for text, with the text below.

    Raises:
        ValueError: If a line has characters that cannot be printed on one line.
        TypeError: If the scene has a shape of an unknown class.
    """
    pixel = max(scene.width, scene.height) / LONGEST_SIDE
    width, height = max(scene.width, WIDTH * pixel), (len(lines) + 0.5) * LINE_HEIGHT * pixel
    margin = (width - scene.width) / 2
    shapes: list[Shape] = [
        Rectangle(margin, 0, scene.width, scene.height, fill=scene.background, outline=None),
        *(_moved(shape, margin) for shape in scene.shapes),
        # What the picture's edge cut off must not show in the margins.
        Rectangle(0, 0, margin, scene.height, fill=PAPER, outline=None),
        Rectangle(width - margin, 0, margin, scene.height, fill=PAPER, outline=None),
        Rectangle(0, scene.height, width, height, fill=PAPER, outline=None),
    ]
    for k, line in enumerate(lines):
        size = min(FONT_SIZE * pixel, 0.95 * width / (LETTER_WIDTH * max(1, len(line))))
        shapes.append(Text(width / 2, scene.height + (k + 0.75) * LINE_HEIGHT * pixel, line, size=size))
    return replace(scene, width=width, height=scene.height + height, shapes=shapes, background=PAPER)


def _moved(shape: Shape, dx: float) -> Shape:
    """Return the shape, further to the right by ``dx``."""
    match shape:
        case Polygon() | Line():
            points: list[Point] = [(x + dx, y) for x, y in shape.points]
            return replace(shape, points=points)
        case Rectangle() | Circle() | Ellipse() | Arc() | Text():
            return replace(shape, x=shape.x + dx)
    raise TypeError(f"a shape of class {type(shape).__name__} cannot be moved")

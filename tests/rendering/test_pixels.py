"""Pixels of single shapes, counted."""

import numpy as np
import pytest

from edugym.rendering.palette import RED, rgb
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Line, Polygon, Rectangle, Scene, Shape

SQUARE = ((4, 4), (12, 4), (12, 12), (4, 12))


@pytest.mark.parametrize(
    ("shape", "rows", "columns"),
    [
        (Line(((4, 10), (16, 10)), colour=RED, line_width=4), (8, 11), (3, 16)),
        (Line(((10, 4), (10, 16)), colour=RED, line_width=4), (3, 16), (8, 11)),
        (Polygon(SQUARE, fill=RED, outline=None), (4, 11), (4, 11)),
        (Rectangle(4, 4, 8, 8, fill=RED, outline=None), (4, 11), (4, 11)),
    ],
)
def test_where_a_shape_begins_and_ends(shape: Shape, rows: tuple[int, int], columns: tuple[int, int]) -> None:
    """As far to one side as to the other, along the middle of the shape; ends of lines are round."""
    red = (to_pixels(Scene(20, 20, (shape,)), 20) == rgb(RED)).all(axis=-1)
    for line, (first, last) in ((red[:, 10], rows), (red[10], columns)):
        assert np.flatnonzero(line).tolist() == list(range(first, last + 1))

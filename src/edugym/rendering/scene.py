"""Scenes: pictures that an environment describes once, in its own units, and that every back end draws.

    Scene(10, 10, (Circle(5, 5, 3, fill=YELLOW), Text(5, 9, "hello")))

`shapes.py` says what a picture is made of. The back ends are:

    `svg.to_svg`         a drawing for notebooks and pages
    `pixels.to_pixels`   an array of colours, `render_mode="rgb_array"`
    `window.Window`      a window on the screen, `render_mode="human"`
    `ansi.to_text`       characters for a terminal, `render_mode="ansi"`
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from edugym.rendering import palette
from edugym.rendering.shapes import (
    Anchor,
    Arc,
    Circle,
    Filled,
    Line,
    Point,
    Polygon,
    Rectangle,
    Shape,
    Stroke,
    Text,
    as_float,
    check,
    check_line,
)

__all__ = [
    "Anchor",
    "Arc",
    "Circle",
    "Filled",
    "Line",
    "Point",
    "Polygon",
    "Rectangle",
    "Scene",
    "Shape",
    "Stroke",
    "Text",
]

LONGEST_SIDE = 480
"""The default length of a picture's longer side, in pixels."""
MOST_PIXELS = 4096
"""The largest width and the largest height of a picture, in pixels."""
SMALLEST, LARGEST = 1e-100, 1e100
"""The limits of a scene's width and height, which keep all products with them finite."""
OUTLINE_SHARE = 1 / 200
"""The default width of an outline, as a share of the picture's longer side."""
TEXT_SHARE = 1 / 24
"""The default font size, as a share of the picture's longer side."""


@dataclass(frozen=True)
class Scene:
    """A picture for any back end; in a notebook it shows itself.

    Attributes:
        width: Width in the environment's units.
        height: Height in the environment's units.
        shapes: The shapes, from back to front. Unpack a group of shapes into it: `(*smiley(1, 2, 0.4), ...)`.
        background: The colour behind them, `"#rrggbb"`.
        title: The picture in words, for screen readers.
        columns: Width in characters for the character back end. A character is about twice as high as it is wide: two
            columns for each unit give one row for each unit.

    Raises:
        ValueError: If a size is not positive or far too large, or an element of `shapes` is no shape.
    """

    width: float
    height: float
    shapes: Sequence[Shape]
    background: str = palette.PAPER
    title: str = ""
    columns: int = 60

    def __post_init__(self) -> None:
        """Check the sizes and the shapes, and keep the shapes as a tuple."""
        for name, size in (("width", self.width), ("height", self.height)):
            fits = SMALLEST <= as_float(name, size) <= LARGEST
            check(fits, name, f"positive, from {SMALLEST} to {LARGEST}", size)
        check(self.columns >= 1, "columns", "1 or more", self.columns)
        check_line("title", self.title)
        palette.rgb(self.background)
        object.__setattr__(self, "shapes", tuple(self.shapes))
        for shape in self.shapes:
            check(isinstance(shape, Shape), "shapes", "all shapes (unpack a group of them with *)", shape)

    @property
    def longer_side(self) -> float:
        """The width or the height, whichever is larger."""
        return max(self.width, self.height)

    @property
    def outline_width(self) -> float:
        """The default width of an outline, in the scene's units."""
        return OUTLINE_SHARE * self.longer_side

    @property
    def text_size(self) -> float:
        """The default font size, in the scene's units."""
        return TEXT_SHARE * self.longer_side

    def size_in_pixels(self, width_pixels: int | None = None) -> tuple[int, int]:
        """Return the width and height of the picture in pixels, both even because video encoders need even sizes.

        Args:
            width_pixels: The width, rounded up to an even number; None for a picture whose longer side has
                `LONGEST_SIDE` pixels. The height follows from the proportions of the scene.

        Raises:
            ValueError: If the width is not positive, or a side of the picture would have more than `MOST_PIXELS`.
        """
        if width_pixels is None:
            scale = LONGEST_SIDE / self.longer_side
        else:
            check(width_pixels > 0, "width_pixels", "positive", width_pixels)
            most = MOST_PIXELS * self.width / self.longer_side
            check(width_pixels <= most, "width_pixels", f"at most {most:.0f} for this picture", width_pixels)
            scale = 2 * math.ceil(width_pixels / 2) / self.width
        # Half of the exact size, rounded to a whole number and doubled.
        return 2 * max(1, round(scale * self.width / 2)), 2 * max(1, round(scale * self.height / 2))

    def _repr_svg_(self) -> str:
        from edugym.rendering.svg import to_svg

        return to_svg(self)

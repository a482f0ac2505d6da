"""What a picture is: shapes in a frame, in the environment's own units. `scene.py` has the class that users make."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from edugym.rendering import palette
from edugym.rendering.shapes import Shape, as_float, check, check_line

LONGEST_SIDE = 480
"""The default length of a picture's longer side, in pixels."""
MOST_PIXELS = 4096
"""The largest width and the largest height of a picture, in pixels."""
SMALLEST, LARGEST = 1e-100, 1e100
"""The limits of a picture's width and height, which keep all products with them finite."""
OUTLINE_SHARE = 1 / 200
"""The default width of an outline, as a share of the picture's longer side."""
TEXT_SHARE = 1 / 24
"""The default font size, as a share of the picture's longer side."""


@dataclass(frozen=True)
class Drawing:
    """A picture for any back end.

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
        """The default width of an outline, in the environment's units."""
        return OUTLINE_SHARE * self.longer_side

    @property
    def text_size(self) -> float:
        """The default font size, in the environment's units."""
        return TEXT_SHARE * self.longer_side

    def size_in_pixels(self, width_pixels: int | None = None) -> tuple[int, int]:
        """Return the width and height of the picture in pixels, both even because video encoders need even sizes.

        Args:
            width_pixels: The width, rounded up to an even number; None for a picture whose longer side has
                `LONGEST_SIDE` pixels. The height follows from its proportions.

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

"""What a picture shows, said once and drawn by every back end: a ``Scene`` is a size and a tuple of shapes.

The coordinates are the environment's own (grid cells, metres, whatever its dynamics use). As in SVG, the origin is the
top-left corner of the picture, x grows to the right and **y grows downwards**; an environment whose y axis points up
writes ``height - y``. Later shapes cover earlier ones. Everything here is an immutable value, checked where it is made,
so that a mistake is reported at the line that wrote it. How it looks on a screen is for the back ends:

    ``svg.to_svg``         a drawing for notebooks and pages
    ``pixels.to_pixels``   an array of colours, ``render_mode="rgb_array"``
    ``window.Window``      a window on the screen, ``render_mode="human"``
    ``ansi.to_text``       characters for a terminal, ``render_mode="ansi"``
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from edugym.rendering import palette

Point = tuple[float, float]
Anchor = Literal["start", "middle", "end"]
ANCHORS: dict[Anchor, float] = {"start": 0.0, "middle": 0.5, "end": 1.0}
"""How much of a text lies before its anchor."""

LONGEST_SIDE = 480
"""Pixels on the longer side of a picture, unless a width is asked for."""
OUTLINE_SHARE = 1 / 200
"""The family's outline, as a share of the picture's longer side."""
TEXT_SHARE = 1 / 24
"""The family's text size, as a share of the picture's longer side."""

CAPITAL_SHARE = 0.73
"""Height of a capital letter as a share of the font size (Helvetica, Arial and FreeSans Bold agree on it)."""

CURVE_PIECES = 72
"""Straight pieces in a full turn, where a back end has no curves of its own."""


@dataclass(frozen=True, kw_only=True)
class Shape:
    """What all shapes have in common.

    Attributes:
        glyph: What the character back end shows for the shape; nothing if empty. One character fills the area of a
            ``Rectangle`` and follows the path of a ``Line`` or an ``Arc``; anything else is written at the middle of
            the shape.
    """

    glyph: str = ""

    def __post_init__(self) -> None:
        """Check every attribute by what its name says it is.

        Raises:
            ValueError: If a number is not finite, a size is negative, a colour is not ``"#rrggbb"`` or a text has
                characters that cannot be printed on one line.
        """
        for name, value in vars(self).items():
            if value is None:
                _check(name in ("fill", "outline", "outline_width", "line_width", "size"), name, "given", value)
            elif name in ("fill", "outline", "colour"):
                palette.rgb(value)
            elif name in ("content", "glyph"):
                _check_line(name, value)
            elif name == "anchor":
                _check(value in ANCHORS, name, '"start", "middle" or "end"', value)
            elif name == "points":
                path = tuple((float(x), float(y)) for x, y in value)
                least = 3 if isinstance(self, Polygon) else 2
                finite = all(math.isfinite(x) and math.isfinite(y) for x, y in path)
                _check(finite and len(path) >= least, name, f"at least {least} pairs of finite numbers", value)
                object.__setattr__(self, name, path)
            else:
                _check(math.isfinite(value), name, "a finite number", value)
                may_be_negative = name in ("x", "y", "start", "stop")
                _check(may_be_negative or value >= 0, name, "0 or more", value)


def _check(holds: bool, name: str, allowed: str, value: object) -> None:
    if not holds:
        raise ValueError(f"{name} must be {allowed}, got {value!r}")


def _check_line(name: str, value: object) -> None:
    printable = isinstance(value, str) and value.isprintable()
    _check(printable, name, "one line of printable characters", value)


@dataclass(frozen=True, kw_only=True)
class Filled(Shape):
    """A shape with an inside.

    Attributes:
        fill: Colour of the inside, or None to leave it as it is.
        outline: Colour of the edge, or None for no edge.
        outline_width: Width of the edge in the scene's units, centred on the edge; None for the family's outline.
    """

    fill: str | None = palette.PAPER
    outline: str | None = palette.INK
    outline_width: float | None = None


@dataclass(frozen=True, kw_only=True)
class Stroke(Shape):
    """A shape that is only a path, with round ends.

    Attributes:
        colour: Colour of the path.
        line_width: Width of the path in the scene's units; None for the family's outline.
    """

    colour: str = palette.INK
    line_width: float | None = None


@dataclass(frozen=True)
class Rectangle(Filled):
    """A rectangle whose top-left corner is (x, y), its corners rounded by ``radius``."""

    x: float
    y: float
    width: float
    height: float
    radius: float = 0.0


@dataclass(frozen=True)
class Circle(Filled):
    """A disc around (x, y)."""

    x: float
    y: float
    radius: float


@dataclass(frozen=True)
class Ellipse(Filled):
    """An ellipse around (x, y) with its axes along x and y."""

    x: float
    y: float
    radius_x: float
    radius_y: float

    @property
    def points(self) -> list[Point]:
        """Points all around the ellipse, close enough to pass for it."""
        turns = [math.tau * k / CURVE_PIECES for k in range(CURVE_PIECES)]
        return [(self.x + self.radius_x * math.cos(turn), self.y + self.radius_y * math.sin(turn)) for turn in turns]


@dataclass(frozen=True)
class Polygon(Filled):
    """A closed polygon through ``points``: pairs (x, y), of any sequence type."""

    points: Sequence[Point]


@dataclass(frozen=True)
class Line(Stroke):
    """A line through ``points``, two or more pairs (x, y) of any sequence type."""

    points: Sequence[Point]


@dataclass(frozen=True)
class Arc(Stroke):
    """A part of the circle around (x, y), from the angle ``start`` to the angle ``stop``.

    Angles are in degrees and grow clockwise on the screen: 0 points right, 90 down, 180 left, 270 up. So
    ``Arc(x, y, radius, 20, 160)`` is a smile.

    Raises:
        ValueError: If ``stop`` is not in (start, start + 360).
    """

    x: float
    y: float
    radius: float
    start: float
    stop: float

    def __post_init__(self) -> None:
        """Check every attribute, and the angles together."""
        Shape.__post_init__(self)
        _check(0 < self.stop - self.start < 360, "stop", "more than start, by less than 360", self.stop)

    @property
    def points(self) -> list[Point]:
        """Points along the arc, its two ends included, close enough to pass for it."""
        sweep = math.radians(self.stop - self.start)
        pieces = math.ceil(CURVE_PIECES * sweep / math.tau)
        turns = [math.radians(self.start) + sweep * k / pieces for k in range(pieces + 1)]
        return [(self.x + self.radius * math.cos(turn), self.y + self.radius * math.sin(turn)) for turn in turns]


@dataclass(frozen=True)
class Text(Shape):
    """One line of bold text, its capitals vertically centred on y.

    The font has the letters of European languages, Greek and Cyrillic included, digits and the usual signs ("×", "−",
    "²", "●"), but no arrows and no emoji: draw those.

    Attributes:
        x: Where the text starts, has its middle or ends, as ``anchor`` says.
        y: The height of the middle of its capital letters.
        content: The text.
        size: The font size in the scene's units, capitals being 0.73 of it; None for the family's text size.
        colour: Colour of the letters.
        anchor: "start", "middle" or "end".
        glyph: What the character back end writes instead; the content itself if empty.
    """

    x: float
    y: float
    content: str
    size: float | None = None
    colour: str = palette.INK
    anchor: Anchor = "middle"

    def baseline(self, size: float) -> float:
        """Return the y coordinate on which the letters stand, at a font size in the scene's units."""
        return self.y + CAPITAL_SHARE / 2 * size


@dataclass(frozen=True)
class Scene:
    """A picture, to be drawn by any back end. In a notebook it shows itself.

    Attributes:
        width: Width in the environment's units.
        height: Height in the environment's units.
        shapes: The shapes, from back to front. Groups of shapes are unpacked into it: ``(*smiley(1, 2, 0.4), ...)``.
        background: The colour behind them, ``"#rrggbb"``.
        title: What the picture is, in words: a screen reader reads them out.
        columns: How many characters wide the character back end draws it. Characters are about twice as high as wide:
            two columns for each unit give one row for each unit.

    Raises:
        ValueError: If a size is not positive and finite, or one of the shapes is none.
    """

    width: float
    height: float
    shapes: Sequence[Shape]
    background: str = palette.PAPER
    title: str = ""
    columns: int = 60

    def __post_init__(self) -> None:
        """Check the sizes, and keep the shapes as a tuple."""
        for name, size in (("width", self.width), ("height", self.height), ("columns", self.columns)):
            _check(0 < size < math.inf, name, "positive and finite", size)
        _check_line("title", self.title)
        palette.rgb(self.background)
        object.__setattr__(self, "shapes", tuple(self.shapes))
        for shape in self.shapes:
            _check(isinstance(shape, Shape), "shapes", "all shapes (unpack a group of them with *)", shape)

    @property
    def outline_width(self) -> float:
        """The width of the family's outline, in this scene's units."""
        return OUTLINE_SHARE * max(self.width, self.height)

    @property
    def text_size(self) -> float:
        """The family's text size, in this scene's units."""
        return TEXT_SHARE * max(self.width, self.height)

    def size_in_pixels(self, width_pixels: int | None = None) -> tuple[int, int]:
        """Return the width and height of the picture in pixels, both even, as video encoders ask.

        Args:
            width_pixels: The width wished for, rounded up to an even number; None for a picture whose longer side is
                ``LONGEST_SIDE``. The height follows from the scene's proportions.

        Raises:
            ValueError: If the width is not positive.
        """
        if width_pixels is None:
            scale = LONGEST_SIDE / max(self.width, self.height)
        else:
            _check(width_pixels > 0, "width_pixels", "positive", width_pixels)
            scale = 2 * math.ceil(width_pixels / 2) / self.width
        # Half of the exact size, rounded to whole numbers, doubled.
        return 2 * max(1, round(scale * self.width / 2)), 2 * max(1, round(scale * self.height / 2))

    def _repr_svg_(self) -> str:
        from edugym.rendering.svg import to_svg

        return to_svg(self)

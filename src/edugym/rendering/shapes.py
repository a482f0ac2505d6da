"""Shapes: what pictures are made of.

The coordinates are the environment's own (grid cells, metres, whatever its dynamics use). As in SVG, the origin is the
top-left corner of the picture, x grows to the right and **y grows downwards**; an environment whose y axis points up
writes `height - y`. Later shapes cover earlier ones. Everything here is an immutable value. It is checked when it is
made, so that an error points at the line with the mistake. A number may be infinite or very large, as when the dynamics
of a task diverge: the back ends draw the part that lies in the picture. NaN is refused.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from numbers import Real
from typing import Any, Literal

from edugym.rendering import palette

Point = tuple[float, float]
Anchor = Literal["start", "middle", "end"]
ANCHORS: dict[Anchor, float] = {"start": 0.0, "middle": 0.5, "end": 1.0}
"""The share of a text that lies before its anchor."""

CAPITAL_SHARE = 0.73
"""Height of a capital letter as a share of the font size: the same in Helvetica, Arial and FreeSans Bold."""
CURVE_PIECES = 72
"""The number of straight pieces that stand for a full circle in back ends that have no arcs."""


@dataclass(frozen=True, kw_only=True)
class Shape:
    """The base class of all shapes.

    Attributes:
        glyph: What the character back end draws for the shape; nothing if empty. A single character fills the area of a
            `Rectangle` and follows the path of a `Line` or an `Arc`; anything else is written at the middle of the
            shape.
    """

    glyph: str = ""

    def __post_init__(self) -> None:
        """Check every attribute by its name.

        Raises:
            ValueError: If a number is NaN, a size is negative, a colour is not `"#rrggbb"` or a text has characters
                that cannot be printed on one line.
        """
        for name, value in vars(self).items():
            if value is None:
                check(name in ("fill", "outline", "outline_width", "line_width", "size"), name, "given", value)
            elif name in ("fill", "outline", "colour"):
                palette.rgb(value)
            elif name in ("content", "glyph"):
                check_line(name, value)
            elif name == "anchor":
                check(value in ANCHORS, name, '"start", "middle" or "end"', value)
            elif name == "points":
                least = 3 if isinstance(self, Polygon) else 2
                path = tuple((as_float(name, x), as_float(name, y)) for x, y in value)
                check(len(path) >= least, name, f"at least {least} pairs of numbers", value)
                object.__setattr__(self, name, path)
            else:
                number = as_float(name, value)
                may_be_negative = name in ("x", "y", "start", "stop")
                check(may_be_negative or number >= 0, name, "0 or more", value)
                object.__setattr__(self, name, number)


def check(holds: bool, name: str, allowed: str, value: object) -> None:
    """Raise a ValueError that names an attribute, the allowed values and the given one, unless the condition holds."""
    if not holds:
        raise ValueError(f"{name} must be {allowed}, got {value!r}")


def check_line(name: str, value: object) -> None:
    """Refuse anything but one line of printable characters."""
    check(isinstance(value, str) and value.isprintable(), name, "one line of printable characters", value)


def as_float(name: str, value: Any) -> float:
    """Return a number as a float; a whole number too large for a float becomes infinite."""
    check(isinstance(value, Real) and value == value, name, "a number", value)
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


@dataclass(frozen=True, kw_only=True)
class Filled(Shape):
    """A shape with an inside.

    Attributes:
        fill: Colour of the inside, or None to leave it as it is.
        outline: Colour of the edge, or None for no edge.
        outline_width: Width of the line along the edge, in the scene's units; None for the default width.
    """

    fill: str | None = palette.PAPER
    outline: str | None = palette.INK
    outline_width: float | None = None


@dataclass(frozen=True, kw_only=True)
class Stroke(Shape):
    """A shape that is a path with round ends.

    Attributes:
        colour: Colour of the path.
        line_width: Width of the path, in the scene's units; None for the default width.
    """

    colour: str = palette.INK
    line_width: float | None = None


@dataclass(frozen=True)
class Rectangle(Filled):
    """A rectangle with its top-left corner at (x, y); `radius` rounds its corners."""

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
class Polygon(Filled):
    """A closed polygon through `points`, three or more pairs (x, y) in any sequence."""

    points: Sequence[Point]


@dataclass(frozen=True)
class Line(Stroke):
    """A line through `points`, two or more pairs (x, y) in any sequence."""

    points: Sequence[Point]


@dataclass(frozen=True)
class Arc(Stroke):
    """A part of the circle around (x, y), from the angle `start` to the angle `stop`.

    Angles are in degrees and grow clockwise on the screen: 0 points right, 90 down, 180 left, 270 up. For example,
    `Arc(x, y, radius, 20, 160)` is a smile.

    Raises:
        ValueError: If `stop` is not in (start, start + 360).
    """

    x: float
    y: float
    radius: float
    start: float
    stop: float

    def __post_init__(self) -> None:
        """Check every attribute, and that the angles fit together."""
        Shape.__post_init__(self)
        check(0 < self.stop - self.start < 360, "stop", "more than start, by less than 360", self.stop)

    @property
    def points(self) -> list[Point]:
        """Points along the arc, from one end to the other, close enough together to look like it."""
        sweep = math.radians(self.stop - self.start)
        pieces = math.ceil(CURVE_PIECES * sweep / math.tau)
        turns = [math.radians(self.start) + sweep * k / pieces for k in range(pieces + 1)]
        return [(self.x + self.radius * math.cos(turn), self.y + self.radius * math.sin(turn)) for turn in turns]


@dataclass(frozen=True)
class Text(Shape):
    """One line of bold text.

    The font has the letters of European languages including Greek and Cyrillic, digits and common signs ("×", "−", "²",
    "●"). It has no arrows and no emoji: draw those.

    Attributes:
        x: The start, the middle or the end of the text (see `anchor`).
        y: The middle of its capital letters.
        content: The text.
        size: The font size in the scene's units, of which capital letters take 0.73; None for the default size.
        colour: Colour of the letters.
        anchor: Which part of the text stands at x: "start", "middle" or "end".
        glyph: What the character back end writes instead of the content; the content itself if empty.
    """

    x: float
    y: float
    content: str
    size: float | None = None
    colour: str = palette.INK
    anchor: Anchor = "middle"

    def baseline(self, size: float) -> float:
        """Return the y coordinate of the line on which the letters stand, for a font size in the scene's units."""
        return self.y + CAPITAL_SHARE / 2 * size

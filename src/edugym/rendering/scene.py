"""Scenes: pictures that an environment describes once, in its own units, and that every back end draws.

    Scene(10, 10, (Circle(5, 5, 3, fill=YELLOW), Text(5, 9, "hello")))

`shapes.py` says what a picture is made of. The back ends are:

    `svg.to_svg`         a drawing for notebooks and pages
    `pixels.to_pixels`   an array of colours, `render_mode="rgb_array"`
    `window.Window`      a window on the screen, `render_mode="human"`
    `ansi.to_text`       characters for a terminal, `render_mode="ansi"`
"""

from dataclasses import dataclass

from edugym.rendering.drawing import Drawing
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
)
from edugym.rendering.svg import to_svg

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
    "in_words",
]


@dataclass(frozen=True)
class Scene(Drawing):
    """A picture that shows itself in a notebook; its attributes are those of `Drawing`."""

    def _repr_svg_(self) -> str:
        return to_svg(self)


def in_words(state: object) -> Scene:
    """The picture of a state that has none of its own: what it is, in words."""
    return Scene(12.0, 2.0, (Text(6.0, 1.2, f"state {state!r}", 0.6),))

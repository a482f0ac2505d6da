"""Scenes as SVG: for notebooks, pages and print."""

from collections.abc import Sequence
from xml.sax.saxutils import escape

from edugym.rendering.clipping import visible
from edugym.rendering.drawing import Drawing
from edugym.rendering.shapes import Arc, Circle, Filled, Line, Point, Polygon, Rectangle, Shape, Stroke, Text


def to_svg(scene: Drawing, width_pixels: int | None = None) -> str:
    """Write a scene as a standalone SVG document, with one line for each shape that can be seen.

    The same scene always gives the same text. It has no ids and no style sheet: several pictures on one page do not
    disturb each other.

    Args:
        scene: The scene.
        width_pixels: Width on the page in CSS pixels, as in `Scene.size_in_pixels`.

    Returns:
        The SVG document.

    Raises:
        ValueError: If the width is not positive or too large.
        TypeError: If the scene has a shape of an unknown class.
    """
    width, height = scene.size_in_pixels(width_pixels)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
        f' viewBox="0 0 {_number(scene.width)} {_number(scene.height)}" stroke-linejoin="round" stroke-linecap="round"'
        ' font-family="FreeSans, Helvetica, Arial, sans-serif" font-weight="bold">'
    )
    title = f"<title>{escape(scene.title)}</title>"
    background = f'<rect width="100%" height="100%" fill="{scene.background}"/>'
    return "\n".join((head, title, background, *(_element(shape, scene) for shape in visible(scene)), "</svg>"))


def _element(shape: Shape, scene: Drawing) -> str:
    match shape:
        case Rectangle():
            corners = f' rx="{_number(shape.radius)}"' if shape.radius else ""
            place = f'x="{_number(shape.x)}" y="{_number(shape.y)}"'
            size = f'width="{_number(shape.width)}" height="{_number(shape.height)}"'
            return f"<rect {place} {size}{corners} {_paint(shape, scene)}/>"
        case Circle():
            place = f'cx="{_number(shape.x)}" cy="{_number(shape.y)}"'
            return f'<circle {place} r="{_number(shape.radius)}" {_paint(shape, scene)}/>'
        case Polygon():
            return f'<polygon points="{_points(shape.points)}" {_paint(shape, scene)}/>'
        case Line():
            return f'<polyline points="{_points(shape.points)}" {_paint(shape, scene)}/>'
        case Arc():
            radius, points = _number(shape.radius), shape.points
            start, stop = _points(points[:1]), _points(points[-1:])
            is_large = int(shape.stop - shape.start > 180)
            return f'<path d="M {start} A {radius} {radius} 0 {is_large} 1 {stop}" {_paint(shape, scene)}/>'
        case Text():
            em = scene.text_size if shape.size is None else shape.size
            place = f'x="{_number(shape.x)}" y="{_number(shape.baseline(em))}"'
            look = f'font-size="{_number(em)}" text-anchor="{shape.anchor}" fill="{shape.colour}"'
            return f"<text {place} {look}>{escape(shape.content)}</text>"
    raise TypeError(f"no SVG for a shape of class {type(shape).__name__}")


def _paint(shape: Filled | Stroke, scene: Drawing) -> str:
    if isinstance(shape, Filled):
        fill, edge, width = shape.fill, shape.outline, shape.outline_width
    else:
        fill, edge, width = None, shape.colour, shape.line_width
    inside = f'fill="{fill or "none"}"'
    if edge is None:
        return inside
    return f'{inside} stroke="{edge}" stroke-width="{_number(scene.outline_width if width is None else width)}"'


def _points(points: Sequence[Point]) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


def _number(value: float) -> str:
    """Write a number with five digits, which place a point to a small part of a pixel."""
    return f"{float(value):.5g}" if value else "0"

"""The shapes of a picture that can be seen, cut to a size that every back end can draw.

A scene may hold shapes of any size at any distance: a circle a million times as wide as the picture, a ball that flew
out of it, or a street of which only a part is shown. Back ends draw what `visible` yields, so that the time and the
memory of a picture depend on what it shows. (Left to itself, pygame loses lines and fills rings from 100 000 pixels on,
and SVG has no word for infinity.)
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any, NamedTuple

from edugym.rendering.drawing import Drawing
from edugym.rendering.shapes import Arc, Circle, Filled, Line, Point, Polygon, Rectangle, Shape, Stroke, Text

REACH = 2.0
"""How far around the picture shapes are kept, in longer sides of the picture; outlines are at most twice as wide."""
FARTHEST = 1e9
"""The limit of all numbers, in longer sides of the picture, which keeps sums and products finite."""
CURVE_POINTS = 65
"""The number of points on the visible part of a very large circle."""


class Box(NamedTuple):
    """A rectangle by its four edges."""

    left: float
    top: float
    right: float
    bottom: float

    def contains(self, other: "Box") -> bool:
        """Whether another box lies within this one; not if one of its edges is NaN."""
        across = self.left <= other.left and other.right <= self.right
        return across and self.top <= other.top and other.bottom <= self.bottom

    def touches(self, other: "Box") -> bool:
        """Whether another box has a point in common with this one."""
        across = self.left <= other.right and other.left <= self.right
        return across and self.top <= other.bottom and other.top <= self.bottom


def visible(scene: Drawing) -> Iterator[Shape]:
    """Yield the shapes that can be seen, from back to front; replace very large ones by the part near the picture.

    The picture stays the same, except where a line or an outline is more than four times as wide as the picture, or the
    radius of a rectangle's corner more than twice as wide. A shape of an unknown class is yielded unchanged.
    """
    margin = REACH * scene.longer_side
    picture = Box(0.0, 0.0, scene.width, scene.height)
    frame = Box(-margin, -margin, scene.width + margin, scene.height + margin)
    for shape in scene.shapes:
        box = _box(shape, scene)
        too_round = isinstance(shape, Rectangle) and shape.radius > margin
        fits = not too_round and (box is None or frame.contains(box))
        for part in (shape,) if fits else _cut(_limited(shape, scene), scene, frame):
            box = _box(part, scene)
            if box is None or picture.touches(box):
                yield part


def _box(shape: Shape, scene: Drawing) -> Box | None:
    """Return a box around a shape with its outline, or None for a shape of an unknown class."""
    pen = 0.0
    if isinstance(shape, Stroke):
        pen = scene.outline_width if shape.line_width is None else shape.line_width
    elif isinstance(shape, Filled) and shape.outline is not None:
        pen = scene.outline_width if shape.outline_width is None else shape.outline_width
    x_pen = y_pen = pen / 2
    match shape:
        case Rectangle(x=left, y=top):
            right, bottom = left + shape.width, top + shape.height
        case Circle(x=x, y=y, radius=radius) | Arc(x=x, y=y, radius=radius):
            left, top, right, bottom = x - radius, y - radius, x + radius, y + radius
        case Polygon(points=points) | Line(points=points):
            xs, ys = zip(*points, strict=True)
            left, top, right, bottom = min(xs), min(ys), max(xs), max(ys)
        case Text(x=x, y=y):
            left, top, right, bottom = x, y, x, y
            y_pen = scene.text_size if shape.size is None else shape.size
            x_pen = y_pen * len(shape.content)  # no letter is wider than the font size
        case _:
            return None
    return Box(left - x_pen, top - y_pen, right + x_pen, bottom + y_pen)


def _limited(shape: Shape, scene: Drawing) -> Shape:
    """Return a shape without infinite numbers, its outline and its text no larger than the back ends can draw."""
    limits = {
        "outline_width": 2 * REACH * scene.longer_side,
        "line_width": 2 * REACH * scene.longer_side,
        "size": REACH * scene.longer_side,
        "width": 2 * FARTHEST * scene.longer_side,  # from one end to the other
        "height": 2 * FARTHEST * scene.longer_side,
    }
    changes: dict[str, Any] = {}
    for name, value in vars(shape).items():
        most = limits.get(name, FARTHEST * scene.longer_side)
        if isinstance(value, float):
            changes[name] = min(max(value, -most), most)
        elif name == "points":
            changes[name] = [(min(max(x, -most), most), min(max(y, -most), most)) for x, y in value]
    return replace(shape, **changes)


def _cut(shape: Shape, scene: Drawing, frame: Box) -> Iterator[Shape]:
    """Yield the parts of a shape that lie in the frame around the picture."""
    match shape:
        case Rectangle(x=x, y=y):
            left, right = max(x, frame.left), min(x + shape.width, frame.right)
            top, bottom = max(y, frame.top), min(y + shape.height, frame.bottom)
            if left <= right and top <= bottom:
                radius = min(shape.radius, REACH * scene.longer_side)
                yield replace(shape, x=left, y=top, width=right - left, height=bottom - top, radius=radius)
        case Circle():
            yield from _cut_circle(shape, scene, frame)
        case Polygon(points=points):
            points = _cut_polygon(points, frame)
            if points:
                yield replace(shape, points=points)
        case Line(points=points) | Arc(points=points):
            for start, stop in pairwise(points):
                part = _cut_segment(start, stop, frame)
                if part is not None:
                    yield Line(part, colour=shape.colour, line_width=shape.line_width, glyph=shape.glyph)
        case Text():
            yield shape


def _cut_circle(circle: Circle, scene: Drawing, frame: Box) -> Iterator[Shape]:
    """Yield a circle that fits into the frame nearly; of a very large one, the side that passes the picture."""
    margin = REACH * scene.longer_side
    x, y = scene.width / 2, scene.height / 2
    distance = math.hypot(x - circle.x, y - circle.y)
    depth = circle.radius - distance  # of the middle of the picture below the edge of the circle
    if abs(depth) > 2 * margin:  # the edge cannot be seen
        if depth > 0 and circle.fill is not None:
            width, height = frame.right - frame.left, frame.bottom - frame.top
            yield Rectangle(frame.left, frame.top, width, height, fill=circle.fill, outline=None, glyph=circle.glyph)
    elif circle.radius <= 4 * margin:
        yield circle
    else:
        # Unit vectors outwards, and along the edge. Points on the edge are measured from its point nearest to the
        # picture: at a distance `along` beside it, the edge has sunk by radius - sqrt(radius² - along²).
        out_x, out_y = (x - circle.x) / distance, (y - circle.y) / distance
        points = []
        for k in range(CURVE_POINTS):
            along = 3 * margin * (2 * k / (CURVE_POINTS - 1) - 1)
            sunk = along * along / (circle.radius + math.sqrt(circle.radius**2 - along * along))
            points.append((depth - sunk, along))
        points += [(-3 * margin, 3 * margin), (-3 * margin, -3 * margin)]
        corners = [(x + out * out_x - along * out_y, y + out * out_y + along * out_x) for out, along in points]
        yield Polygon(
            corners,
            fill=circle.fill,
            outline=circle.outline,
            outline_width=circle.outline_width,
            glyph=circle.glyph,
        )


def _cut_polygon(points: Sequence[Point], frame: Box) -> Sequence[Point]:
    """Cut a polygon at the four edges of the frame, one after the other (Sutherland and Hodgman, 1974)."""
    for axis, edge, inwards in ((0, frame.left, 1), (0, frame.right, -1), (1, frame.top, 1), (1, frame.bottom, -1)):
        kept: list[Point] = []
        for k, point in enumerate(points):
            before = points[k - 1]
            depth, depth_before = inwards * (point[axis] - edge), inwards * (before[axis] - edge)
            if (depth < 0) != (depth_before < 0):
                kept.append(_between(before, point, depth_before / (depth_before - depth)))
            if depth >= 0:
                kept.append(point)
        points = kept
    return points


def _cut_segment(start: Point, stop: Point, frame: Box) -> tuple[Point, Point] | None:
    """Return the part of a straight line that lies in the frame, if any (Liang and Barsky, 1984)."""
    first, last = 0.0, 1.0
    for axis, low, high in ((0, frame.left, frame.right), (1, frame.top, frame.bottom)):
        step = stop[axis] - start[axis]
        if step == 0:
            if not low <= start[axis] <= high:
                return None
        else:
            enters, leaves = sorted(((low - start[axis]) / step, (high - start[axis]) / step))
            first, last = max(first, enters), min(last, leaves)
    return (_between(start, stop, first), _between(start, stop, last)) if first <= last else None


def _between(start: Point, stop: Point, share: float) -> Point:
    return start[0] + share * (stop[0] - start[0]), start[1] + share * (stop[1] - start[1])

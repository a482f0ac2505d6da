"""Shapes of any size at any distance: the part that is in the picture is drawn, and the rest costs nothing."""

import itertools
import math
from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym.rendering import pixels
from edugym.rendering.ansi import MOST_CELLS, to_text
from edugym.rendering.captions import captioned
from edugym.rendering.clipping import visible
from edugym.rendering.icons import smiley
from edugym.rendering.palette import BLUE, PAPER, RED, rgb
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Arc, Circle, Line, Polygon, Rectangle, Scene, Shape, Text
from edugym.rendering.svg import to_svg

EXTREME = st.sampled_from([math.inf, -math.inf, 1e308, -1e308, 5e-324, 0.0, 1e6])
NUMBERS = st.one_of(st.floats(-30, 30), st.floats(allow_nan=False), EXTREME)
SIZES = NUMBERS.map(abs)
POINTS = st.lists(st.tuples(NUMBERS, NUMBERS), min_size=3, max_size=6)
EDGES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
PEN = st.one_of(st.none(), SIZES)


def arc(x: float, y: float, radius: float, start: float, line_width: float | None) -> Arc:
    """Return an arc of 100 degrees."""
    return Arc(x, y, radius, start, start + 100, line_width=line_width, glyph="-")


def shapes() -> st.SearchStrategy[Shape]:
    """Shapes of every class with numbers of any size."""
    return st.one_of(
        st.builds(Rectangle, NUMBERS, NUMBERS, SIZES, SIZES, SIZES, outline_width=PEN, glyph=st.sampled_from("# ")),
        st.builds(Circle, NUMBERS, NUMBERS, SIZES, outline_width=PEN, glyph=st.just("o")),
        st.builds(Polygon, POINTS, outline_width=PEN, glyph=st.just("two")),
        st.builds(Line, POINTS, line_width=PEN, glyph=st.just("-")),
        st.builds(arc, NUMBERS, NUMBERS, SIZES, st.floats(-1000, 1000), PEN),
        st.builds(Text, NUMBERS, NUMBERS, st.just("hello"), PEN, anchor=st.sampled_from(["start", "middle", "end"])),
    )


def coordinates(shape: Shape) -> list[float]:
    """Return all numbers of a shape but the angles of an arc."""
    points = [number for point in getattr(shape, "points", ()) for number in point]
    own = [value for name, value in vars(shape).items() if isinstance(value, float) and name not in ("start", "stop")]
    return [*points, *own]


@settings(max_examples=300)
@given(shapes())
def test_every_back_end_draws_shapes_of_any_size(shape: Shape) -> None:
    """No number makes a back end raise or draw anything much larger than the picture."""
    picture = Scene(10, 5, (shape,), columns=20)
    kept = list(visible(picture))
    assert len(kept) <= 72
    assert all(abs(number) <= 500 for part in kept for number in coordinates(part))
    ElementTree.fromstring(to_svg(picture))
    assert to_pixels(picture, 40, supersampling=1).shape == (20, 40, 3)
    assert len(to_text(picture).split("\n")) == 5
    to_svg(captioned(picture, ["caption"]))


@pytest.mark.parametrize("radius", [15.0, 70.0, 90.0, 1e8])
def test_large_circles_pass_where_they_should(radius: float) -> None:
    """Every pixel has the colour of the circle's inside, its outline or the paper, by its distance to the centre."""
    for angle, depth in itertools.product((0.7, 4.0), (-3.0, 0.0, 3.0)):
        x, y = 5 - (radius - depth) * math.cos(angle), 5 - (radius - depth) * math.sin(angle)
        drawn = to_pixels(Scene(10, 10, (Circle(x, y, radius, fill=RED, outline=BLUE, outline_width=1.0),)), 100)
        rows, columns = np.mgrid[0:100, 0:100] / 10 + 0.05
        beyond = np.hypot(columns - x, rows - y) - radius
        for colour, where in ((RED, beyond < -0.7), (BLUE, abs(beyond) < 0.3), (PAPER, beyond > 0.7)):
            assert (drawn[where] == rgb(colour)).all()
        assert len(set(map(tuple, drawn.reshape(-1, 3)))) > 1


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_a_circle_around_the_whole_picture(unit: float) -> None:
    """It is one area of its colour, whatever the units of the picture; without a colour it cannot be seen."""
    circle = Circle(5 * unit, 2 * unit, 100 * unit, fill=RED)
    (part,) = visible(Scene(10 * unit, 5 * unit, (circle, replace(circle, fill=None))))
    assert isinstance(part, Rectangle)
    assert (part.fill, part.outline) == (RED, None)
    around = (-20, -20, 50, 45)
    assert (part.x, part.y, part.width, part.height) == pytest.approx([unit * number for number in around])


FAR = st.floats(-200, 200)
LARGE = st.one_of(
    st.builds(Rectangle, FAR, FAR, FAR.map(abs), FAR.map(abs), fill=st.just(RED), outline=st.just(None)),
    st.builds(Polygon, st.lists(st.tuples(FAR, FAR), min_size=3, max_size=4), fill=st.just(RED), outline=st.just(None)),
    st.builds(Line, st.lists(st.tuples(FAR, FAR), min_size=2, max_size=4), line_width=st.just(1.0)),
    st.builds(Circle, FAR, FAR, FAR.map(abs), fill=st.just(RED), outline_width=st.just(1.0)),
)


@settings(max_examples=150)
@given(st.lists(LARGE, min_size=1, max_size=4))
def test_shapes_are_cut_where_nobody_sees_it(shapes: list[Shape]) -> None:
    """A picture is nearly the same if nothing is cut, where pygame can draw it."""
    picture = Scene(10, 10, shapes)
    cut = to_pixels(picture, 100).astype(int)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(pixels, "visible", lambda scene: scene.shapes)
        whole = to_pixels(picture, 100).astype(int)
    assert (abs(cut - whole).max(axis=2) > 128).mean() < 0.005


def test_shapes_in_the_picture_stay_as_they_are() -> None:
    """And in their order; those that cannot be seen are left out."""
    text, line = Text(12, 5, "long enough", anchor="end"), Line(((0, 0), (15, 15)))
    inside: list[Shape] = [Circle(-1, 5, 2), *smiley(5, 5, 3), text, line]
    outside: list[Shape] = [
        Circle(-1, 5, 0.9, outline=None), Circle(5, 5, 1e9, fill=None), Rectangle(10.2, 0, 1e9, 10),
        Rectangle(1e300, 0, math.inf, 1), Line(((11, 0), (11, 1e9))),
        Polygon(((100, 100), (1e9, 100), (100, 1e9))), Text(-1e6, 5, "far away"),
    ]  # fmt: skip
    mixed = [shape for k, one in enumerate(inside) for shape in (*outside[k : k + 1], one)] + outside
    assert list(visible(Scene(10, 10, mixed))) == inside


def test_a_line_that_leaves_the_picture_comes_back() -> None:
    """Of a line the far parts are left out, and all that come after them in the picture are drawn."""
    way = ((1, 1), (90, 1), (90, 90), (2, 90), (2, 3), (4, 3))
    bits: list[Any] = list(visible(Scene(10, 10, (Line(way, colour=RED, line_width=0.5, glyph="#"),))))
    points = [np.round(bit.points, 6).tolist() for bit in bits]
    assert points == [[[1, 1], [30, 1]], [[2, 30], [2, 3]], [[2, 3], [4, 3]]]
    assert {(bit.colour, bit.line_width, bit.glyph) for bit in bits} == {(RED, 0.5, "#")}


PENNED: dict[str, Any] = {
    "Rectangle": lambda x, y, pen: Rectangle(x - 1, y - 1, 2, 2, outline_width=pen),
    "Circle": lambda x, y, pen: Circle(x, y, 1, outline_width=pen),
    "Polygon": lambda x, y, pen: Polygon(((x - 1, y - 1), (x + 1, y - 1), (x, y + 1)), outline_width=pen),
    "Line": lambda x, y, pen: Line(((x - 1, y - 1), (x + 1, y + 1)), line_width=pen),
    "Arc": lambda x, y, pen: Arc(x, y, 1, 20, 160, line_width=pen),
}


@pytest.mark.parametrize("pen", [0.5, None])
@pytest.mark.parametrize("shape", PENNED.values(), ids=PENNED)
def test_half_of_a_pen_reaches_into_the_picture(shape: Any, pen: float | None) -> None:
    """A shape beyond an edge is seen as far as its outline reaches, whether that has a width of its own or not."""
    empty = Scene(10, 6, ())
    for (across, down), (share, seen) in itertools.product(EDGES, ((0.49, True), (0.51, False))):
        gap = share * (empty.outline_width if pen is None else pen)
        one = shape(5 + across * (5 + 1 + gap), 3 + down * (3 + 1 + gap), pen)
        assert list(visible(replace(empty, shapes=(one,)))) == [one] * seen


@pytest.mark.parametrize(("width", "height"), [(1e-100, 1e100), (1e100, 1e-100), (7, 1e9), (1e-9, 1e-9)])
def test_pictures_of_any_proportions(width: float, height: float) -> None:
    """Neither the pixels nor the characters grow without bound."""
    shapes: list[Any] = [Rectangle(0, 0, width, height, glyph="#"), *smiley(width / 2, height / 2, height / 4)]
    picture = Scene(width, height, shapes, columns=10**9)
    lines = to_text(picture).split("\n")
    assert 1 <= len(lines) <= MOST_CELLS
    assert max(map(len, lines)) <= MOST_CELLS
    assert max(to_pixels(picture).shape) == 480
    ElementTree.fromstring(to_svg(picture))

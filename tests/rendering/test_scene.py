"""Scenes: what they accept, and that every back end draws every shape."""

import math
from collections.abc import Callable
from dataclasses import FrozenInstanceError, fields, replace
from typing import Any
from xml.etree import ElementTree

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym.rendering import icons
from edugym.rendering.ansi import to_text
from edugym.rendering.palette import GREEN, INK, PAPER, RED, YELLOW, rgb
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Arc, Circle, Filled, Line, Polygon, Rectangle, Scene, Shape, Text
from edugym.rendering.svg import to_svg

EXAMPLES: tuple[Shape, ...] = (
    Rectangle(2, 2, 6, 6, fill=RED, glyph="#"),
    Circle(5, 5, 3, fill=RED, glyph="#"),
    Polygon(((5, 1), (9, 9), (1, 9)), fill=RED, glyph="#"),
    Line(((1, 5), (9, 5)), colour=RED, line_width=2, glyph="#"),
    Arc(5, 1, 4, 20, 160, colour=RED, line_width=2, glyph="#"),
    Text(5, 5, "I", size=8, colour=RED, glyph="#"),
)
"""One shape of every class, each red at the point (5, 5)."""
each_shape = pytest.mark.parametrize("shape", EXAMPLES, ids=lambda shape: type(shape).__name__)


def scene_of(*shapes: Shape, **options: Any) -> Scene:
    """Return a scene of 10 by 10 units, 20 characters wide."""
    return Scene(10, 10, shapes, **{"columns": 20, **options})


@each_shape
def test_every_back_end_draws_every_shape(shape: Shape) -> None:
    """Each shape reaches the point (5, 5) of the picture in its own colour, and the characters around it."""
    picture = scene_of(shape)
    drawn = ElementTree.fromstring(to_svg(picture))[-1]
    assert RED in (drawn.get("fill"), drawn.get("stroke"))
    assert tuple(to_pixels(picture)[240, 240]) == rgb(RED)
    assert "#" in to_text(picture)
    assert "38;2;" in to_text(picture, colour=True)


@pytest.mark.parametrize("draw", [to_svg, to_pixels, to_text])
def test_unknown_shape_is_refused(draw: Callable[[Scene], object]) -> None:
    """A back end that does not know a shape says so, rather than leaving it out."""
    with pytest.raises(TypeError, match="shape of class Filled"):
        draw(scene_of(Filled(glyph="#")))
    assert to_text(scene_of(Filled())).strip() == ""  # characters leave out all shapes without a glyph


MISTAKES: list[tuple[Callable[..., object], tuple[Any, ...], dict[str, Any], str]] = [
    (Rectangle, (0, 0, -1, 1), {}, "width must be 0 or more, got -1"),
    (Circle, (math.nan, 0, 1), {}, "x must be a number, got nan"),
    (Circle, (0, 0, 1), {"fill": "red"}, "colour must be written"),
    (Line, (((0, 0),),), {}, "points must be at least 2 pairs"),
    (Polygon, (((0, 0), (1, 1)),), {}, "points must be at least 3 pairs"),
    (Line, (((0, 0), (1, math.nan)),), {}, "points must be a number, got nan"),
    (Circle, ("3", 0, 1), {}, "x must be a number, got '3'"),
    (Line, (((0, 0), (1, 1)),), {"colour": None}, "colour must be given"),
    (Arc, (0, 0, 1, 90, 90), {}, "stop must be more than start"),
    (Arc, (0, 0, 1, 0, 360), {}, "stop must be more than start"),
    (Text, (0, 0, "two\nlines"), {}, "content must be one line"),
    (Text, (0, 0, 7), {}, "content must be one line"),
    (Text, (0, 0, "a"), {"anchor": "centre"}, "anchor must be"),
    (Scene, (0, 1, ()), {}, "width must be positive"),
    (Scene, (1, math.inf, ()), {}, "height must be positive"),
    (Scene, (1, 1, ()), {"columns": 0}, "columns must be 1 or more"),
    (Scene, (1, 1, ()), {"background": "sky"}, "colour must be written"),
    (Scene, (1, 1, ()), {"title": "\0"}, "title must be one line"),
    (Scene, (1, 1, (icons.smiley(0, 0, 1),)), {}, "unpack a group"),
    (icons.smiley, (0, 0, 1, "angry"), {}, "mood must be"),
    (Scene(1, 1, ()).size_in_pixels, (0,), {}, "width_pixels must be positive"),
    (Scene(1, 2, ()).size_in_pixels, (2049,), {}, "width_pixels must be at most 2048"),
    (to_pixels, (Scene(1, 1, ()),), {"supersampling": 3}, "supersampling must be 1, 2, 4 or 8"),
    (to_text, (Scene(1, 1, ()),), {"columns": 0}, "columns must be 1 or more"),
]


@pytest.mark.parametrize(("make", "arguments", "options", "message"), MISTAKES)
def test_mistakes_are_named(make: Callable[..., object], arguments: Any, options: Any, message: str) -> None:
    """A wrong value is refused where it is written, with its name and what is allowed."""
    with pytest.raises(ValueError, match=message):
        make(*arguments, **options)


@each_shape
def test_every_shape_checks_all_that_it_has(shape: Shape) -> None:
    """Its class may check more, but not less."""
    wrong: dict[str, Any] = {"x": math.nan, "radius": -1, "colour": "red", "fill": "red", "points": [], "glyph": "\n"}
    for name in wrong.keys() & {field.name for field in fields(shape)}:
        with pytest.raises(ValueError, match="must be"):
            replace(shape, **{name: wrong[name]})


def test_the_smallest_values_are_drawn() -> None:
    """Shapes without any extent, paths of the fewest points, and the narrowest pictures."""
    tiny = (Rectangle(0, 0, 0, 0, 0), Circle(0, 0, 0), Line(((0, 0), (0, 0))), Polygon(((0, 0),) * 3))
    picture = Scene(1, 1, (*tiny, Arc(0, 0, 0, 0, 359.9), Text(0, 0, "", size=0)), columns=1)
    assert to_text(picture, columns=1) == ""
    assert to_pixels(picture, 1, supersampling=1).shape == (2, 2, 3)
    assert to_svg(picture, 1).count("\n") == 9


def test_scene_is_a_value() -> None:
    """Scenes made alike are equal, and none can be changed; points and shapes come in any sequence."""
    one = Scene(2, 2, [Polygon([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])])  # type: ignore[list-item]
    assert one == Scene(2, 2, (Polygon(((0, 0), (1, 0), (0, 1))),))
    assert hash(one) == hash(replace(one))
    assert Circle(10**400, -(10**400), 1) == Circle(math.inf, -math.inf, 1)  # too large for a float
    for name in ("width", "shapes"):
        with pytest.raises(FrozenInstanceError):
            setattr(one, name, 3)


def test_size_in_pixels_is_even() -> None:
    """The longer side has 480 pixels, a width can be asked for, and every size is even and follows the proportions."""
    assert Scene(10, 10, ()).size_in_pixels() == (480, 480)
    assert Scene(19, 9, ()).size_in_pixels() == (480, 228)  # 227.4
    assert Scene(0.01, 30, ()).size_in_pixels() == (2, 480)
    assert Scene(3, 2, ()).size_in_pixels(297) == (298, 198)  # 198.7
    assert Scene(3, 2, ()).size_in_pixels(1) == (2, 2)
    assert Scene(1, 2, ()).size_in_pixels(2048) == (2048, 4096)  # the largest


def test_svg_of_a_small_scene() -> None:
    """The whole text of a picture, one line for each shape."""
    shapes = (
        Rectangle(0, 8, 20, 2, fill=GREEN, outline=None), Rectangle(1, 1, 2.5, 2, 0.5), Circle(10, 5, 2, fill=YELLOW),
        Polygon([(0, 0), (1, 0), (0.5, 1 / 3)], outline_width=0.5), Line([(0, 0), (1, 1)]),
        Arc(10, 5, 1, 0, 180, colour=RED), Arc(10, 5, 1, -90, 180),
        Text(10, 2, "R < 0 & s = 1", size=2), Text(19, 9, "10", colour=RED, anchor="end"),
    )  # fmt: skip
    picture = Scene(20, 10, shapes, title="A & B")
    assert picture._repr_svg_() == (
        f"""<svg xmlns="http://www.w3.org/2000/svg" width="480" height="240" viewBox="0 0 20 10" \
stroke-linejoin="round" stroke-linecap="round" font-family="FreeSans, Helvetica, Arial, sans-serif" font-weight="bold">
<title>A &amp; B</title>
<rect width="100%" height="100%" fill="{PAPER}"/>
<rect x="0" y="8" width="20" height="2" fill="{GREEN}"/>
<rect x="1" y="1" width="2.5" height="2" rx="0.5" fill="{PAPER}" stroke="{INK}" stroke-width="0.1"/>
<circle cx="10" cy="5" r="2" fill="{YELLOW}" stroke="{INK}" stroke-width="0.1"/>
<polygon points="0,0 1,0 0.5,0.33333" fill="{PAPER}" stroke="{INK}" stroke-width="0.5"/>
<polyline points="0,0 1,1" fill="none" stroke="{INK}" stroke-width="0.1"/>
<path d="M 11,5 A 1 1 0 0 1 9,5" fill="none" stroke="{RED}" stroke-width="0.1"/>
<path d="M 10,4 A 1 1 0 1 1 9,5" fill="none" stroke="{INK}" stroke-width="0.1"/>
<text x="10" y="2.73" font-size="2" text-anchor="middle" fill="{INK}">R &lt; 0 &amp; s = 1</text>
<text x="19" y="9.3042" font-size="0.83333" text-anchor="end" fill="{RED}">10</text>
</svg>"""
    )


@settings(max_examples=50, database=None, deadline=None)
@given(st.text().filter(str.isprintable))
def test_every_text_is_drawn(words: str) -> None:
    """Any text that a scene accepts is well-formed XML that says it, and the other back ends take it too."""
    picture = scene_of(Text(0, 5, words, anchor="start"), title=words, columns=max(20, len(words)))
    root = ElementTree.fromstring(to_svg(picture))
    assert (root[0].text or "", root[-1].text or "") == (words, words)
    assert to_pixels(picture, 20).shape == (20, 20, 3)
    assert to_text(picture).strip() == words.strip()

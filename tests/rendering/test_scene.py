"""Scenes: what they accept, that every back end draws every shape, and the pictures as SVG and as pixels."""

import math
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import FrozenInstanceError, fields, replace
from typing import Any, Literal
from xml.etree import ElementTree

import numpy as np
import pygame
import pygame.freetype
import pytest
from gymnasium.error import DependencyNotInstalled
from hypothesis import given, settings
from hypothesis import strategies as st

from edugym.rendering import icons, palette
from edugym.rendering.ansi import to_text
from edugym.rendering.palette import BLUE, GREEN, INK, PAPER, RED, YELLOW, blend, rgb
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import (
    Arc,
    Circle,
    Filled,
    Line,
    Polygon,
    Rectangle,
    Scene,
    Shape,
    Text,
)
from edugym.rendering.svg import to_svg
from edugym.rendering.window import Window

EXAMPLES: dict[type[Shape], Shape] = {
    Rectangle: Rectangle(2, 2, 6, 6, fill=RED, glyph="#"),
    Circle: Circle(5, 5, 3, fill=RED, glyph="#"),
    Polygon: Polygon(((5, 1), (9, 9), (1, 9)), fill=RED, glyph="#"),
    Line: Line(((1, 5), (9, 5)), colour=RED, line_width=2, glyph="#"),
    Arc: Arc(5, 1, 4, 20, 160, colour=RED, line_width=2, glyph="#"),
    Text: Text(5, 5, "I", size=8, colour=RED, glyph="#"),
}
"""One shape of every class, each red at the point (5, 5)."""


def leaves(kind: type[Shape]) -> set[type[Shape]]:
    """Return the classes of the package that are shapes to draw: those from which no other is derived."""
    below = [child for child in kind.__subclasses__() if child.__module__.startswith("edugym.")]
    return set().union(*map(leaves, below)) if below else {kind}


def scene_of(*shapes: Shape, **options: Any) -> Scene:
    """Return a scene of 10 by 10 units, 20 characters wide."""
    return Scene(10, 10, shapes, **{"columns": 20, **options})


# Every back end and every shape


def test_every_shape_class_has_an_example() -> None:
    """A new shape class must be added to the examples, and so to the tests below."""
    assert set(EXAMPLES) == leaves(Shape)


@pytest.mark.parametrize("shape", EXAMPLES.values(), ids=lambda shape: type(shape).__name__)
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


def test_unknown_shape_without_a_glyph() -> None:
    """Characters leave it out, as they do all shapes that have none."""
    assert to_text(scene_of(Filled())).strip() == ""


def every_figure() -> list[tuple[Shape, ...]]:
    """Return one of every figure, and the variants that take another path through its code."""
    return [
        *(icons.smiley(5, 5, 3, mood) for mood in ("happy", "flat", "sad")),
        icons.flag(5, 8, 5),
        icons.sign(5, 8, 5),
        icons.sign(5, 8, 5, "EXIT", danger=False),
        icons.gauge(1, 5, 8, 1, "HP", 0.5),
        icons.lamp(5, 5, 1, lit=True),
        icons.lamp(5, 5, 1, lit=False),
        icons.door(2, 1, 4, 8, BLUE, "1", "?"),
        icons.speech_bubble(1, 1, 6, 2, "hello", (5, 6)),
        icons.speech_bubble(1, 5, 6, 2, "hello", (5, 1)),
    ]


@pytest.mark.parametrize("figure", every_figure())
def test_every_figure_is_drawn(figure: tuple[Shape, ...]) -> None:
    """Every figure makes a mark in each back end."""
    picture = scene_of(*figure)
    ElementTree.fromstring(to_svg(picture))
    assert (to_pixels(picture) != rgb(PAPER)).any()
    assert to_text(picture).strip()


def test_a_flag_flies_above_its_foot() -> None:
    """Its pole is as high as it says, and the cloth hangs at the top of it."""
    cloth, pole, *_ = icons.flag(5, 8, 4)
    assert isinstance(cloth, Polygon)
    assert isinstance(pole, Line)
    assert pole.points == ((5, 8), (5, 4))
    assert min(y for _, y in cloth.points) == 4
    assert max(y for _, y in cloth.points) < 6


@pytest.mark.parametrize("tip", [(-9.0, 9.0), (4.0, 9.0), (99.0, 9.0), (4.0, -9.0)])
def test_the_tail_of_a_speech_bubble_leaves_its_edge(tip: tuple[float, float]) -> None:
    """It begins between the corners of the nearer edge, wherever it points, and ends there."""
    tail = icons.speech_bubble(1, 2, 6, 2, "hello", tip)[0]
    assert isinstance(tail, Polygon)
    (left, y), end, (right, other_y) = tail.points
    assert 1 < left < right < 7
    assert y == other_y == (4 if tip[1] > 0 else 2)
    assert end == pytest.approx(tip)


def test_empty_gauge_is_empty() -> None:
    """A gauge shows as many full characters as its fraction says, and none for nothing."""
    for fraction, full in ((-1.0, 0), (0.0, 0), (0.5, 8), (1.0, 16), (2.0, 16)):
        assert to_text(scene_of(*icons.gauge(1, 5, 8, 1, "HP", fraction))).count("█") == full


# What a scene accepts


@pytest.mark.parametrize(
    ("make", "arguments", "options", "message"),
    [
        (Rectangle, (0, 0, -1, 1), {}, "width must be 0 or more, got -1"),
        (Circle, (math.nan, 0, 1), {}, "x must be a number, got nan"),
        (Circle, (0, 0, 1), {"fill": "red"}, "colour must be written"),
        (Circle, (0, 0, 1), {"fill": 0xFF0000}, "colour must be written .* got 16711680"),
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
        (Scene, (1, 10**400, ()), {}, "height must be positive"),
        (Scene(1, 1, ()).size_in_pixels, (0,), {}, "width_pixels must be positive"),
        (Scene(1, 2, ()).size_in_pixels, (2049,), {}, "width_pixels must be at most 2048"),
        (to_pixels, (Scene(1, 1, ()),), {"supersampling": 3}, "supersampling must be 1, 2, 4 or 8"),
        (to_text, (Scene(1, 1, ()),), {"columns": 0}, "columns must be 1 or more"),
        (blend, (RED, BLUE, 1.5), {}, "share must lie in"),
    ],
)
def test_mistakes_are_named(
    make: Callable[..., object], arguments: tuple[object, ...], options: dict[str, object], message: str
) -> None:
    """A wrong value is refused where it is written, with its name and what is allowed."""
    with pytest.raises(ValueError, match=message):
        make(*arguments, **options)


@pytest.mark.parametrize("shape", EXAMPLES.values(), ids=lambda shape: type(shape).__name__)
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
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    one = Scene(2, 2, [Polygon(corners.tolist())])
    assert one == Scene(2, 2, (Polygon(((0, 0), (1, 0), (0, 1))),))
    assert hash(one) == hash(replace(one))
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


# Colours


def test_palette_is_well_formed() -> None:
    """Every colour of the palette can be read, and no two are the same."""
    colours = [value for name, value in vars(palette).items() if name.isupper()]
    assert len(colours) >= 15
    assert len(set(map(rgb, colours))) == len(colours)


def test_blend() -> None:
    """A mixture goes from the one colour to the other."""
    assert rgb("#0a10ff") == (10, 16, 255)
    assert (blend(RED, BLUE, 0.0), blend(RED, BLUE, 1.0)) == (RED, BLUE)
    assert blend("#000000", "#ff6402", 0.5) == "#803201"


# SVG


def test_svg_of_a_small_scene() -> None:
    """The whole text of a picture, one line for each shape."""
    picture = Scene(
        20,
        10,
        (
            Rectangle(0, 8, 20, 2, fill=GREEN, outline=None),
            Rectangle(1, 1, 2.5, 2, 0.5),
            Circle(10, 5, 2, fill=YELLOW),
            Polygon([(0, 0), (1, 0), (0.5, 1 / 3)], outline_width=0.5),
            Line([(0, 0), (1, 1)]),
            Arc(10, 5, 1, 0, 180, colour=RED),
            Arc(10, 5, 1, -90, 180),
            Text(10, 2, "R < 0 & s = 1", size=2),
            Text(19, 9, "10", colour=RED, anchor="end"),
        ),
        title="A & B",
    )
    assert picture._repr_svg_() == (
        """<svg xmlns="http://www.w3.org/2000/svg" width="480" height="240" viewBox="0 0 20 10" \
stroke-linejoin="round" stroke-linecap="round" font-family="FreeSans, Helvetica, Arial, sans-serif" font-weight="bold">
<title>A &amp; B</title>
<rect width="100%" height="100%" fill="#fffaf0"/>
<rect x="0" y="8" width="20" height="2" fill="#3fae6a"/>
<rect x="1" y="1" width="2.5" height="2" rx="0.5" fill="#fffaf0" stroke="#33313f" stroke-width="0.1"/>
<circle cx="10" cy="5" r="2" fill="#ffd23f" stroke="#33313f" stroke-width="0.1"/>
<polygon points="0,0 1,0 0.5,0.33333" fill="#fffaf0" stroke="#33313f" stroke-width="0.5"/>
<polyline points="0,0 1,1" fill="none" stroke="#33313f" stroke-width="0.1"/>
<path d="M 11,5 A 1 1 0 0 1 9,5" fill="none" stroke="#e8505b" stroke-width="0.1"/>
<path d="M 10,4 A 1 1 0 1 1 9,5" fill="none" stroke="#33313f" stroke-width="0.1"/>
<text x="10" y="2.73" font-size="2" text-anchor="middle" fill="#33313f">R &lt; 0 &amp; s = 1</text>
<text x="19" y="9.3042" font-size="0.83333" text-anchor="end" fill="#e8505b">10</text>
</svg>"""
    )


@settings(max_examples=200, database=None, deadline=None)
@given(st.text().filter(str.isprintable))
def test_every_text_is_drawn(words: str) -> None:
    """Any text that a scene accepts is well-formed XML that says it, and the other back ends take it too."""
    picture = scene_of(Text(0, 5, words, anchor="start"), title=words, columns=max(20, len(words)))
    root = ElementTree.fromstring(to_svg(picture))
    assert (root[0].text or "", root[-1].text or "") == (words, words)
    assert to_pixels(picture, 20).shape == (20, 20, 3)
    assert to_text(picture).strip() == words.strip()


# Pixels


def test_pixels_of_a_small_scene() -> None:
    """Shape and type of the array, y pointing down, later shapes on top, outlines centred on the edge."""
    pixels = to_pixels(
        Scene(
            4,
            2,
            (
                Rectangle(0, 0, 2, 1, fill=RED, outline=None),
                Rectangle(1, 0, 1, 1, fill=BLUE, outline=None),
                Circle(3, 1, 0.5, fill=None, outline=GREEN, outline_width=0.2),
                Line(((0, 1.5), (2, 1.5)), colour=INK, line_width=0.2),
            ),
        ),
        400,
    )
    assert pixels.shape == (200, 400, 3)
    assert pixels.dtype == np.uint8
    pixels[0, 0] = 0  # the array is the caller's own to write to
    assert (pixels[1:99, 1:99] == rgb(RED)).all()
    assert (pixels[1:99, 101:199] == rgb(BLUE)).all()
    assert (pixels[101:138, :199] == rgb(PAPER)).all()
    assert (pixels[142:158, 11:190] == rgb(INK)).all()
    for inside, ring, outside in (((100, 338), (100, 341), (100, 362)), ((62, 300), (41, 300), (38, 300))):
        assert tuple(pixels[inside]) == rgb(PAPER)
        assert tuple(pixels[ring]) == rgb(GREEN)
        assert tuple(pixels[outside]) == rgb(PAPER)


def test_shapes_agree() -> None:
    """A square is the same as a rectangle, as a polygon and as a line, nearly."""
    corners = ((2, 2), (8, 2), (8, 8), (2, 8))
    pairs: list[tuple[Shape, Shape]] = [
        (Rectangle(2, 2, 6, 6, outline=None, fill=RED), Polygon(corners, outline=None, fill=RED)),
        (Rectangle(2, 2, 6, 6, fill=None, outline_width=1), Line((*corners, corners[0]), line_width=1)),
    ]
    for one, other in pairs:
        first, second = (to_pixels(scene_of(shape)).astype(int) for shape in (one, other))
        assert (first != rgb(PAPER)).any()
        assert (abs(first - second).max(axis=2) > 64).mean() < 0.001


def test_neighbours_leave_no_gap() -> None:
    """Rectangles that share an edge cover all between them, wherever the edge falls."""
    tiles = [Rectangle(k / 7, 0, 1 / 7, 1, fill=INK, outline=None) for k in range(7)]
    for supersampling in (1, 2, 4):
        assert (to_pixels(Scene(1, 1, tiles), 100, supersampling) == rgb(INK)).all()


@pytest.mark.parametrize("anchor", ["start", "middle", "end"])
def test_text_stands_where_it_is_anchored(anchor: Literal["start", "middle", "end"]) -> None:
    """The letters begin at, lie around or end at the given point, their capitals centred on y."""
    pixels = to_pixels(Scene(200, 100, (Text(100, 50, "HIH", size=20, anchor=anchor),)), 200)
    rows, columns = np.nonzero((pixels != rgb(PAPER)).any(axis=2))
    edges = {"start": (100, 131), "middle": (84, 115), "end": (68, 99)}[anchor]
    np.testing.assert_allclose((columns.min(), columns.max()), edges, atol=1)
    np.testing.assert_allclose((rows.min() + rows.max() + 1) / 2, 50, atol=1)
    np.testing.assert_allclose(rows.max() + 1 - rows.min(), 14.6, atol=1.5)  # 0.73 of the size


def test_smiley_is_the_same_everywhere() -> None:
    """One smiley, whatever the units of the environment: the same pixels, the same characters."""
    small, large = (Scene(10 * unit, 10 * unit, icons.smiley(5 * unit, 5 * unit, 3 * unit)) for unit in (0.01, 128))
    np.testing.assert_array_equal(to_pixels(small), to_pixels(large))
    assert to_text(small) == to_text(large)
    happy, sad = (to_pixels(scene_of(*icons.smiley(5, 5, 3, mood))) for mood in ("happy", "sad"))
    assert tuple(happy[240, 240]) == rgb(YELLOW)
    assert (happy[300:350] != sad[300:350]).any()
    np.testing.assert_array_equal(happy[:240], sad[:240])


def test_pixels_need_no_screen() -> None:
    """Drawing prints nothing, opens no display and starts nothing of pygame but its fonts; importing starts nothing."""
    program = """
import sys
import edugym.rendering.window
from edugym.rendering.icons import smiley, sign
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Scene
assert "pygame" not in sys.modules
to_pixels(Scene(10, 10, (*smiley(5, 5, 3), *sign(1, 9, 3))))
import pygame
assert not pygame.get_init() and not pygame.display.get_init() and not pygame.font.get_init()
"""
    surroundings = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    surroundings.pop("PYGAME_HIDE_SUPPORT_PROMPT", None)
    result = subprocess.run(
        [sys.executable, "-W", "error", "-c", program], env=surroundings, capture_output=True, text=True, check=False
    )
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


@pytest.mark.parametrize("leave", [pygame.quit, pygame.freetype.quit])
def test_pixels_outlive_pygame(leave: Callable[[], None]) -> None:
    """Another environment that shuts pygame down, as many do when they close, does not break this one."""
    picture = scene_of(Text(5, 5, "text"))
    before = to_pixels(picture)
    leave()
    np.testing.assert_array_equal(to_pixels(picture), before)
    leave()
    pygame.freetype.init()
    np.testing.assert_array_equal(to_pixels(picture), before)


@pytest.mark.parametrize("missing", [["pygame.freetype"], ["pygame.freetype", "pygame"]])
@pytest.mark.parametrize("draw", [to_pixels, Window("none").show])
def test_missing_pygame_says_what_to_install(
    missing: list[str], draw: Callable[[Scene], Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without pygame, the error has the command that installs it."""
    for name in missing:
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(DependencyNotInstalled, match=r'pip install "edugym\[render\]"'):
        draw(scene_of())

"""Pixels: where shapes begin and end, their colours and sizes, and what drawing leaves alone."""

import os
import subprocess
import sys
from collections.abc import Callable
from typing import Any, Literal

import numpy as np
import pygame
import pygame.freetype
import pytest
from gymnasium.error import DependencyNotInstalled

from edugym.rendering.palette import BLUE, GREEN, INK, PAPER, RED, rgb
from edugym.rendering.pixels import to_pixels
from edugym.rendering.scene import Circle, Line, Polygon, Rectangle, Scene, Shape, Text
from edugym.rendering.window import Window

SQUARE = ((4, 4), (12, 4), (12, 12), (4, 12))


@pytest.mark.parametrize(
    ("shape", "rows", "columns"),
    [
        (Line(((4, 10), (16, 10)), colour=RED, line_width=4), (8, 11), (3, 16)),
        (Line(((10, 4), (10, 16)), colour=RED, line_width=4), (3, 16), (8, 11)),
        (Polygon(SQUARE, fill=RED, outline=None), (4, 11), (4, 11)),
        (Rectangle(4, 4, 8, 8, fill=RED, outline=None), (4, 11), (4, 11)),
    ],
)
def test_where_a_shape_begins_and_ends(shape: Shape, rows: tuple[int, int], columns: tuple[int, int]) -> None:
    """As far to one side as to the other, along the middle of the shape; ends of lines are round."""
    red = (to_pixels(Scene(20, 20, (shape,)), 20) == rgb(RED)).all(axis=-1)
    for line, (first, last) in ((red[:, 10], rows), (red[10], columns)):
        assert np.flatnonzero(line).tolist() == list(range(first, last + 1))


def test_pixels_of_a_small_scene() -> None:
    """Shape and type of the array, y pointing down, later shapes on top, outlines centred on the edge."""
    red, blue = Rectangle(0, 0, 2, 1, fill=RED, outline=None), Rectangle(1, 0, 1, 1, fill=BLUE, outline=None)
    ring = Circle(3, 1, 0.5, fill=None, outline=GREEN, outline_width=0.2)
    line = Line(((0, 1.5), (2, 1.5)), colour=INK, line_width=0.2)
    pixels = to_pixels(Scene(4, 2, (red, blue, ring, line)), 400)
    assert pixels.shape == (200, 400, 3)
    assert pixels.dtype == np.uint8
    pixels[0, 0] = 0  # the array is the caller's own to write to
    assert (pixels[1:99, 1:99] == rgb(RED)).all()
    assert (pixels[1:99, 101:199] == rgb(BLUE)).all()
    assert (pixels[101:138, :199] == rgb(PAPER)).all()
    assert (pixels[142:158, 11:190] == rgb(INK)).all()
    for inside, on_it, outside in (((100, 338), (100, 341), (100, 362)), ((62, 300), (41, 300), (38, 300))):
        assert tuple(pixels[inside]) == rgb(PAPER)
        assert tuple(pixels[on_it]) == rgb(GREEN)
        assert tuple(pixels[outside]) == rgb(PAPER)


def test_shapes_agree() -> None:
    """An outlined square is the same as a line around it, nearly."""
    corners = ((2, 2), (8, 2), (8, 8), (2, 8), (2, 2))
    pair = Rectangle(2, 2, 6, 6, fill=None, outline_width=1), Line(corners, line_width=1)
    first, second = (to_pixels(Scene(10, 10, (shape,))).astype(int) for shape in pair)
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
    picture = Scene(10, 10, (Text(5, 5, "text"),))
    before = to_pixels(picture)
    leave()
    np.testing.assert_array_equal(to_pixels(picture), before)
    leave()
    pygame.freetype.init()
    np.testing.assert_array_equal(to_pixels(picture), before)


@pytest.mark.parametrize("draw", [to_pixels, Window("none").show])
def test_missing_pygame_says_what_to_install(draw: Callable[[Scene], Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """Without pygame, the error has the command that installs it; an older one, which has no windows, is told apart."""
    with monkeypatch.context() as older:
        older.delattr(pygame, "Window")
        with pytest.raises(DependencyNotInstalled, match="older pygame"):
            Window("none").show(Scene(10, 10, ()))
    for name in ("pygame.freetype", "pygame"):
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(DependencyNotInstalled, match=r'pip install "edugym\[render\] @ git'):
            draw(Scene(10, 10, ()))

"""Scenes as arrays of pixels, drawn in memory: no window, no display, no effect on the user's own pygame."""

import importlib
import math
from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from gymnasium.error import DependencyNotInstalled
from numpy.typing import NDArray

from edugym.rendering.clipping import visible
from edugym.rendering.palette import rgb
from edugym.rendering.scene import Scene
from edugym.rendering.shapes import ANCHORS, Arc, Circle, Line, Point, Polygon, Rectangle, Shape, Text
from edugym.system.extras import install

if TYPE_CHECKING:
    import pygame
    import pygame.freetype


def to_pixels(scene: Scene, width_pixels: int | None = None, supersampling: int = 4) -> NDArray[np.uint8]:
    """Draw a scene into an array.

    Args:
        scene: The scene.
        width_pixels: Width of the picture, as in `Scene.size_in_pixels`: scenes of one size give arrays of one shape.
        supersampling: Each pixel is the mean of so many by so many: 1 is the fastest, 2, 4 and 8 give smoother and
            smoother edges. (With other numbers pygame would not keep the exact colour of even areas.)

    Returns:
        The colours, shape (height, width, 3): rows from the top, red, green and blue from 0 to 255.

    Raises:
        ValueError: If the width is not positive or too large, or the supersampling is not 1, 2, 4 or 8.
        TypeError: If the scene has a shape of an unknown class.
        gymnasium.error.DependencyNotInstalled: If pygame is not installed.
    """
    surface = to_surface(scene, width_pixels, supersampling)
    import pygame

    width, height = surface.get_size()
    colours = bytearray(pygame.image.tobytes(surface, "RGB"))  # a bytearray, so that the array can be written to
    return np.frombuffer(colours, np.uint8).reshape(height, width, 3)


def to_surface(scene: Scene, width_pixels: int | None = None, supersampling: int = 4) -> "pygame.Surface":
    """Draw a scene onto a new pygame surface of 32 bits a pixel, with the arguments and errors of `to_pixels`."""
    if supersampling not in (1, 2, 4, 8):
        raise ValueError(f"supersampling must be 1, 2, 4 or 8, got {supersampling!r}")
    require_pygame()
    import pygame

    width, height = scene.size_in_pixels(width_pixels)
    # Rounding to whole pixels changes the longer side the least.
    scale = supersampling * max(width, height) / max(scene.width, scene.height)
    surface = pygame.Surface((supersampling * width, supersampling * height), depth=32)
    surface.fill(rgb(scene.background))
    for shape in visible(scene):
        _draw(shape, scene, surface, scale)
    return pygame.transform.smoothscale(surface, (width, height))


def require_pygame() -> None:
    """Import pygame. Gymnasium has already turned off the line that pygame prints.

    Raises:
        gymnasium.error.DependencyNotInstalled: If pygame is not installed.
    """
    try:
        importlib.import_module("pygame.freetype")
    except ModuleNotFoundError as error:
        raise DependencyNotInstalled(f"pygame is not installed, run {install('render')}") from error


def _draw(shape: Shape, scene: Scene, surface: "pygame.Surface", scale: float) -> None:
    """Draw one shape onto a surface that has ``scale`` pixels to a unit of the scene."""
    import pygame

    def pixels(length: float | None) -> int:
        return max(1, round(scale * (scene.outline_width if length is None else length)))

    match shape:
        case Rectangle(fill=fill, outline=outline):
            if fill is not None:
                pygame.draw.rect(surface, rgb(fill), _box(shape, scale), border_radius=round(scale * shape.radius))
            if outline is not None:
                # pygame draws an outline inside the box; a scene's outline is centred on the edge.
                width = pixels(shape.outline_width)
                box, radius = _box(shape, scale).inflate(width, width), round(scale * shape.radius + width / 2)
                pygame.draw.rect(surface, rgb(outline), box, width, border_radius=radius)
        case Circle(fill=fill, outline=outline):
            middle = round(scale * shape.x), round(scale * shape.y)
            if fill is not None:
                pygame.draw.circle(surface, rgb(fill), middle, scale * shape.radius)
            if outline is not None:
                width = pixels(shape.outline_width)
                pygame.draw.circle(surface, rgb(outline), middle, scale * shape.radius + width / 2, width)
        case Polygon(fill=fill, outline=outline):
            path = _scaled(shape.points, scale)
            if fill is not None:
                pygame.draw.polygon(surface, rgb(fill), [(x - 0.5, y - 0.5) for x, y in path])
            if outline is not None:
                _stroke(surface, rgb(outline), [*path, path[0]], pixels(shape.outline_width))
        case Line() | Arc():
            _stroke(surface, rgb(shape.colour), _scaled(shape.points, scale), pixels(shape.line_width))
        case Text():
            _write(surface, shape, scene.text_size if shape.size is None else shape.size, scale)
        case _:
            raise TypeError(f"no pixels for a shape of class {type(shape).__name__}")


def _box(shape: Rectangle, scale: float) -> "pygame.Rect":
    """Round the edges of a rectangle to pixels, so that neighbours with a common edge leave no gap."""
    import pygame

    left, top = round(scale * shape.x), round(scale * shape.y)
    right, bottom = round(scale * (shape.x + shape.width)), round(scale * (shape.y + shape.height))
    return pygame.Rect(left, top, right - left, bottom - top)


def _scaled(points: Sequence[Point], scale: float) -> list[Point]:
    return [(scale * x, scale * y) for x, y in points]


def _stroke(surface: "pygame.Surface", colour: tuple[int, int, int], path: Sequence[Point], width: int) -> None:
    """Draw a path with round ends and joints: a bar along each piece, a disc on each point."""
    import pygame

    for x, y in path:
        pygame.draw.circle(surface, colour, (round(x), round(y)), width / 2)
    for (x, y), (next_x, next_y) in pairwise(path):
        length = math.hypot(next_x - x, next_y - y)
        if length > 0:
            # Half the width, at right angles to the piece. The middle of pixel (i, j) is at (i + 0.5, j + 0.5).
            dx, dy = (y - next_y) / length * (width - 1) / 2, (next_x - x) / length * (width - 1) / 2
            corners = ((x + dx, y + dy), (next_x + dx, next_y + dy), (next_x - dx, next_y - dy), (x - dx, y - dy))
            pygame.draw.polygon(surface, colour, [(a - 0.5, b - 0.5) for a, b in corners])


def _write(surface: "pygame.Surface", text: Text, size: float, scale: float) -> None:
    """Draw a line of text, unless it is too small to read."""
    if scale * size < 1:
        return
    font = _font()
    box = font.get_rect(text.content, size=scale * size)
    left, baseline = scale * text.x - box.x - ANCHORS[text.anchor] * box.width, scale * text.baseline(size)
    font.render_to(surface, (round(left), round(baseline)), text.content, rgb(text.colour), size=scale * size)


def _font() -> "pygame.freetype.Font":
    """Return pygame's own font, which is the same on every machine; load it again after a `pygame.quit`."""
    import pygame

    try:
        _load_font().get_rect("", size=1.0)
    except pygame.error:
        _load_font.cache_clear()
    return _load_font()


@cache
def _load_font() -> "pygame.freetype.Font":
    import pygame.freetype

    pygame.freetype.init()
    font = pygame.freetype.Font(None)
    font.origin = True  # places are the start of the baseline
    return font

"""Pictures of widgets in a narrow cell, as on a phone: they shrink as far as they can be read, and then scroll."""

import re

import numpy as np
import pytest

from edugym.experiments.figures import Lines, Sheet
from edugym.rendering.scene import Scene
from edugym.rendering.shapes import Text
from edugym.rendering.svg import to_svg
from edugym_course.notebook import frames, play, sliders
from edugym_course.notebook.controls import shown
from edugym_course.notebook.widget import picture_html, svg_html


def least(html: str) -> int:
    """The width, in CSS pixels, below which a picture does not shrink."""
    found = re.search(r"max-width: max\(100%, (\d+)px\); height: auto", html)
    assert found
    return int(found[1])


@pytest.mark.parametrize(
    ("texts", "width"),
    [
        ((), 0),
        ((("far", 0.9),), 48),
        ((("far", 0.9), ("near", 0.1)), 432),
        ((("near", 0.01),), 480),
        ((("", 0.01),), 0),
    ],
)
def test_a_scene_shrinks_until_its_text_has_nine_pixels(texts: tuple[tuple[str, float], ...], width: int) -> None:
    """But never grows for it; a text of no letters does not count."""
    scene = Scene(4.8, 4.8, tuple(Text(1, 1, content, size=size) for content, size in texts))
    assert 'width="480"' in to_svg(scene)
    assert least(picture_html(scene)) == width


def test_other_pictures() -> None:
    """A figure keeps three quarters; pixels and pictures from elsewhere shrink as far as they must."""
    sheet = Sheet("two", [[Lines(np.arange(2.0), {"up": np.arange(2.0)})] * 2])
    figure = shown(sheet, "two").html()
    width = re.search(r' width="(\d+)"', figure)
    assert width
    assert least(figure) == round(0.75 * int(width[1]))
    assert least(picture_html(np.zeros((2, 600, 3), np.uint8))) == 0
    assert least(svg_html('<svg width="100%"><text font-size="1">far</text></svg>')) == 0


def test_every_picture_can_be_scrolled() -> None:
    """In a place that stays when the picture changes, so that a reader stays where she has scrolled to."""
    for panel in (play("Boulder"), frames("Boulder", [0]), sliders(lambda speed=1: str(speed), speed=(1, 2))):
        layout = panel._picture.layout
        assert (layout.max_width, layout.overflow) == ("100%", "auto")

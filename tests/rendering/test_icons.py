"""Every icon as it is, in a picture beside this file, and the colours by their names.

After an intended change, run `python -m tests.rendering.test_icons` and look at `icons.svg`.
"""

import colorsys
from dataclasses import replace
from pathlib import Path

import pytest

from edugym.rendering import icons, palette
from edugym.rendering.ansi import to_text
from edugym.rendering.captions import captioned
from edugym.rendering.palette import BLUE, RED, rgb
from edugym.rendering.scene import Scene
from edugym.rendering.shapes import Shape

PICTURE = Path(__file__).with_name("icons.svg")
CHARACTERS = Path(__file__).with_name("icons.txt")

MOODS: tuple[icons.Mood, ...] = ("happy", "flat", "sad")


def every_icon() -> Scene:
    """All icons, in rows, with a caption of two lines."""
    groups: list[tuple[Shape, ...]] = [
        *(icons.smiley(1.5 + 3 * k, 1.5, 1, mood) for k, mood in enumerate(MOODS)),
        icons.flag(10, 2.5, 2),
        icons.flag(13, 2.5, 2, BLUE, "F"),
        icons.sign(1.5, 6, 2.5),
        icons.sign(4.5, 6, 2.5, "EXIT", danger=False),
        icons.gauge(7, 5, 3, 0.7, "HP", 0.75),
        icons.gauge(11, 5, 3, 0.7, "MP", 0, RED),
        icons.lamp(1.5, 8, 0.7, lit=True),
        icons.lamp(4.5, 8, 0.7, lit=False),
        icons.door(6.5, 7, 1.5, 3, BLUE, "1", "?"),
        icons.door(9, 7, 1.5, 3),
        icons.speech_bubble(11, 6.5, 3.5, 1, "hi", (12, 8.5)),
        icons.speech_bubble(11, 10, 3.5, 1, "ho", (20, 8.7)),
    ]
    shapes = [shape for group in groups for shape in group]
    return captioned(
        Scene(15, 12, shapes, columns=60), ["one line", "a line that is so long that it is written smaller " * 2]
    )


def test_icons_are_as_they_were() -> None:
    """In the drawing, line by line, and as characters."""
    assert every_icon()._repr_svg_().splitlines() == PICTURE.read_text(encoding="utf-8").splitlines()
    assert to_text(every_icon()).splitlines() == CHARACTERS.read_text(encoding="utf-8").splitlines()


def test_a_narrow_picture_gets_margins() -> None:
    """Its caption is as wide as 400 of 480 pixels; the picture is in the middle, on its own ground."""
    below = captioned(Scene(1, 48, (), background=RED), ["a", "b"])
    assert (below.width, below.height) == (40, 53)
    lines = replace(below, title="")._repr_svg_().splitlines()
    assert lines[2:] == [
        '<rect width="100%" height="100%" fill="#fffaf0"/>',
        '<rect x="19.5" y="0" width="1" height="48" fill="#e8505b"/>',
        '<rect x="0" y="0" width="19.5" height="48" fill="#fffaf0"/>',
        '<rect x="20.5" y="0" width="19.5" height="48" fill="#fffaf0"/>',
        '<rect x="0" y="48" width="40" height="5" fill="#fffaf0"/>',
        '<text x="20" y="50.011" font-size="1.4" text-anchor="middle" fill="#33313f">a</text>',
        '<text x="20" y="52.011" font-size="1.4" text-anchor="middle" fill="#33313f">b</text>',
        "</svg>",
    ]


@pytest.mark.parametrize(("fraction", "bar"), [(0.0, "░░░░"), (0.5, "██░░"), (1.0, "████")])
def test_a_short_gauge_in_characters(fraction: float, bar: str) -> None:
    """Also one that is less than a unit long is full as far as it should be."""
    text = to_text(Scene(1, 1, icons.gauge(0, 0.5, 1, 0.3, "", fraction), columns=4))
    assert bar in text.splitlines()


@pytest.mark.parametrize(
    ("name", "degrees"),
    [("RED", 0), ("BRICK", 14), ("ORANGE", 24), ("WALL", 24), ("SAND", 41), ("YELLOW", 46), ("GRASS", 98),
     ("GREEN", 145), ("SKY", 197), ("WATER", 203), ("BLUE", 219), ("PURPLE", 268)],
)  # fmt: skip
def test_colours_are_what_their_names_say(name: str, degrees: float) -> None:
    """By their place on the circle of colours."""
    hue, _, _ = colorsys.rgb_to_hsv(*(part / 255 for part in rgb(getattr(palette, name))))
    assert abs((360 * hue - degrees + 180) % 360 - 180) < 6


def test_greys_go_from_dark_to_light() -> None:
    """What is nearly black, ink, road, stone, the quieter paper, paper and white."""
    names = ("CRACK", "INK", "ROAD", "STONE", "SHADE", "PAPER", "WHITE")
    sums = [sum(rgb(getattr(palette, name))) for name in names]
    assert sums == sorted(sums)
    assert sums[1] < 200 < 400 < sums[2] < 500 < 600 < sums[3]
    assert sums[-1] == 3 * 255


if __name__ == "__main__":
    PICTURE.write_text(every_icon()._repr_svg_() + "\n", encoding="utf-8")
    CHARACTERS.write_text(to_text(every_icon()) + "\n", encoding="utf-8")

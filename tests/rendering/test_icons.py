"""The palette; and every icon as it is, in a picture beside this file, whichever colours it has.

After an intended change, run `python -m tests.rendering.test_icons` and look at `icons.svg`.
"""

import re
from pathlib import Path

import pytest

from edugym.rendering import icons, palette
from edugym.rendering.ansi import to_text
from edugym.rendering.captions import captioned
from edugym.rendering.palette import BLUE, PAPER, RED, blend, rgb
from edugym.rendering.scene import Polygon, Rectangle, Scene, Shape, Text

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
    caption = ["one line", "a line that is so long that it is written smaller " * 2]
    return captioned(Scene(15, 12, shapes, columns=60), caption)


def numbered(svg: str) -> list[str]:
    """The lines, with the number of each colour in the order in which they appear."""
    seen: dict[str, int] = {}
    return re.sub("#[0-9a-f]{6}", lambda found: f"#{seen.setdefault(found[0], len(seen))}", svg).splitlines()


def test_icons_are_as_they_were() -> None:
    """In the drawing, line by line, and as characters."""
    assert numbered(every_icon()._repr_svg_()) == numbered(PICTURE.read_text(encoding="utf-8"))
    assert to_text(every_icon()).splitlines() == CHARACTERS.read_text(encoding="utf-8").splitlines()


def test_a_narrow_picture_gets_margins() -> None:
    """Its caption is as wide as 400 of 480 pixels; the picture is in the middle, on its own ground."""
    below = captioned(Scene(1, 48, (), background=RED), ["a", "b"])
    assert (below.width, below.height, below.background) == (40, 53, PAPER)
    *grounds, first, second = below.shapes
    sides = (Rectangle(x, 0, 19.5, 48, fill=PAPER, outline=None) for x in (0, 20.5))
    under = Rectangle(0, 48, 40, 5, fill=PAPER, outline=None)
    assert grounds == [Rectangle(19.5, 0, 1, 48, fill=RED, outline=None), *sides, under]
    size = 14 * (48 / 480)
    assert (first, second) == (Text(20, 49.5, "a", size=size), Text(20, 51.5, "b", size=size))


def test_a_short_gauge_in_characters() -> None:
    """Also one that is less than a unit long is full as far as it should be."""
    for fraction, bar in ((-1.0, "░░░░"), (0.0, "░░░░"), (0.5, "██░░"), (1.0, "████"), (2.0, "████")):
        text = to_text(Scene(1, 1, icons.gauge(0, 0.5, 1, 0.3, "", fraction), columns=4))
        assert bar in text.splitlines()


@pytest.mark.parametrize("tip", [(-9.0, 9.0), (4.0, 9.0), (99.0, 9.0), (4.0, -9.0)])
def test_the_tail_of_a_speech_bubble_leaves_its_edge(tip: tuple[float, float]) -> None:
    """It begins between the corners of the nearer edge, wherever it points, and ends there."""
    tail = icons.speech_bubble(1, 2, 6, 2, "hello", tip)[0]
    assert isinstance(tail, Polygon)
    (left, y), end, (right, other_y) = tail.points
    assert 1 < left < right < 7
    assert y == other_y == (4 if tip[1] > 0 else 2)
    assert end == pytest.approx(tip)


GREYS = ("CRACK", "INK", "ROAD", "STONE", "SHADE", "PAPER", "WHITE")


def test_greys_go_from_dark_to_light() -> None:
    """And no two colours are the same."""
    colours = {name: rgb(value) for name, value in vars(palette).items() if name.isupper()}
    assert len(set(colours.values())) == len(colours)
    assert sorted(GREYS, key=lambda name: sum(colours[name])) == [*GREYS]


def test_blend() -> None:
    """A mixture goes from the one colour to the other."""
    black, orange = "#000000", "#ff6402"
    assert rgb("#0a10ff") == (10, 16, 255)
    assert [blend(black, orange, share) for share in (0.0, 0.5, 1.0)] == [black, "#803201", orange]
    for wrong in (1.5, -0.5):
        with pytest.raises(ValueError, match=f"share .*{wrong}"):
            blend(black, orange, wrong)


if __name__ == "__main__":
    PICTURE.write_text(every_icon()._repr_svg_() + "\n", encoding="utf-8")
    CHARACTERS.write_text(to_text(every_icon()) + "\n", encoding="utf-8")

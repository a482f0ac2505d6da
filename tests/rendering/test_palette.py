"""The palette: the one place that knows which colours there are."""

import colorsys

import pytest

from edugym.rendering import palette
from edugym.rendering.palette import blend, rgb

HUES = {
    "RED": 0, "BRICK": 14, "ORANGE": 24, "WALL": 24, "SAND": 41, "YELLOW": 46, "GRASS": 98, "GREEN": 145, "SKY": 197,
    "WATER": 203, "BLUE": 219, "PURPLE": 268,
}  # fmt: skip
GREYS = ("CRACK", "INK", "ROAD", "STONE", "SHADE", "PAPER", "WHITE")


def test_colours_are_what_their_names_say() -> None:
    """By their place on the circle of colours, or from dark to light; no two are the same."""
    colours = {name: rgb(value) for name, value in vars(palette).items() if name.isupper()}
    assert set(colours) == {*HUES, *GREYS}
    assert len(set(colours.values())) == len(colours)
    for name, degrees in HUES.items():
        hue, _, _ = colorsys.rgb_to_hsv(*(part / 255 for part in colours[name]))
        assert abs((360 * hue - degrees + 180) % 360 - 180) < 6, name
    sums = [sum(colours[name]) for name in GREYS]
    assert sums == sorted(sums)
    assert sums[1] < 200 < 400 < sums[2] < 500 < 600 < sums[3]
    assert sums[-1] == 3 * 255


def test_blend() -> None:
    """A mixture goes from the one colour to the other."""
    black, orange = "#000000", "#ff6402"
    assert rgb("#0a10ff") == (10, 16, 255)
    assert [blend(black, orange, share) for share in (0.0, 0.5, 1.0)] == [black, "#803201", orange]
    for wrong in (1.5, -0.5):
        with pytest.raises(ValueError, match=f"share .*{wrong}"):
            blend(black, orange, wrong)

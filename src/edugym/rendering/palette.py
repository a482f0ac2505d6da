"""The colours of all pictures, so that the environments look like one family.

Every colour is opaque and written `"#rrggbb"`. An environment uses these constants, or a mixture of two (`blend`), and
no colours of its own.
"""

import re
from functools import cache

INK = "#33313f"
"""Outlines, text and faces."""
PAPER = "#fffaf0"
"""Background of boards, calendars and signs."""
SHADE = "#e7dfd1"
"""A quieter paper: empty cells, unlit lamps, the empty part of a gauge."""

SKY = "#c3e6f4"
WATER = "#5fb3e4"
GRASS = "#8fcf6e"
SAND = "#efd9a7"
ROAD = "#8b8f9c"
WALL = "#b07d56"
"""Brown rock of a climbing wall; also wood."""
BRICK = "#cf7a5c"
STONE = "#c9ced6"
CRACK = "#26232e"
"""Nearly black, for grips that do not hold."""

RED = "#e8505b"
ORANGE = "#f6975a"
YELLOW = "#ffd23f"
"""The smiley's colour; nothing near a smiley should have it."""
GREEN = "#3fae6a"
BLUE = "#4a7bd6"
PURPLE = "#9a6fcb"
WHITE = "#ffffff"


@cache
def rgb(colour: str) -> tuple[int, int, int]:
    """Return the red, green and blue of a colour, each from 0 to 255.

    Args:
        colour: A colour written `"#rrggbb"`, as in HTML.

    Raises:
        ValueError: If the colour is not written that way.
    """
    if not isinstance(colour, str) or not re.fullmatch("#[0-9a-fA-F]{6}", colour):
        raise ValueError(f'colour must be written "#rrggbb" with hexadecimal digits, got {colour!r}')
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def blend(colour: str, other: str, share: float) -> str:
    """Mix two colours.

    Args:
        colour: The first colour, `"#rrggbb"`.
        other: The second colour, `"#rrggbb"`.
        share: The share of the second colour in the mixture, from 0 to 1.

    Returns:
        The mixture, `"#rrggbb"`.

    Raises:
        ValueError: If a colour is not written `"#rrggbb"` or `share` is not from 0 to 1.
    """
    if not 0.0 <= share <= 1.0:
        raise ValueError(f"share must lie in [0, 1], got {share!r}")
    mixture = (round(a + share * (b - a)) for a, b in zip(rgb(colour), rgb(other), strict=True))
    return "#" + "".join(f"{part:02x}" for part in mixture)

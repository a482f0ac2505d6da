"""Icons that several environments share, each a tuple of shapes to unpack into a scene.

    Scene(10, 10, (*smiley(2, 3, 0.4), *flag(5, 9, 1)))

An icon scales as a whole: it looks the same at every size and in every environment's units.
"""

from typing import Literal

from edugym.rendering.palette import GREEN, INK, PAPER, RED, SHADE, WALL, WHITE, YELLOW, blend
from edugym.rendering.shapes import Arc, Circle, Line, Point, Polygon, Rectangle, Shape, Text

Mood = Literal["happy", "flat", "sad"]


def smiley(x: float, y: float, radius: float, mood: Mood = "happy", glyph: str = "☺") -> tuple[Shape, ...]:
    """Draw the agent: the same round yellow face in every environment.

    Args:
        x: The middle of the face.
        y: The middle of the face.
        radius: The radius of the face.
        mood: The shape of the mouth: "happy", "flat" or "sad".
        glyph: What the character back end draws.

    Raises:
        ValueError: If the mood is unknown.
    """
    mouth: Shape
    pen = 0.11 * radius
    if mood == "happy":
        mouth = Arc(x, y + 0.02 * radius, 0.56 * radius, 22, 158, line_width=pen)
    elif mood == "flat":
        level = y + 0.38 * radius
        mouth = Line(((x - 0.38 * radius, level), (x + 0.38 * radius, level)), line_width=pen)
    elif mood == "sad":
        mouth = Arc(x, y + 0.86 * radius, 0.54 * radius, 222, 318, line_width=pen)
    else:
        raise ValueError(f'mood must be "happy", "flat" or "sad", got {mood!r}')
    return (
        Circle(x, y, radius, fill=YELLOW, outline_width=pen, glyph=glyph),
        Circle(x - 0.33 * radius, y - 0.22 * radius, 0.13 * radius, fill=INK, outline=None),
        Circle(x + 0.33 * radius, y - 0.22 * radius, 0.13 * radius, fill=INK, outline=None),
        mouth,
    )


def flag(x: float, y: float, height: float, colour: str = RED, glyph: str = "⚑") -> tuple[Shape, ...]:
    """Draw the flag of a goal, with a pole of the given height that stands on (x, y)."""
    top = y - height
    cloth = ((x, top), (x + 0.62 * height, top + 0.22 * height), (x, top + 0.44 * height))
    return (
        Polygon(cloth, fill=colour),
        Line(((x, y), (x, top))),
        Circle(x, y, 0.06 * height, fill=INK, outline=None, glyph=glyph),
    )


def sign(x: float, y: float, height: float, content: str = "!", danger: bool = True) -> tuple[Shape, ...]:
    """Draw a road sign on a post that stands on (x, y).

    Args:
        x: The foot of the post.
        y: The foot of the post.
        height: From the foot of the post to the top of the sign.
        content: The text: one or two characters on a danger sign, a short word on a plain one.
        danger: True for a triangle with a red rim, False for a green board.
    """
    post = Line(((x, y), (x, y - 0.5 * height)), line_width=0.07 * height)
    if danger:
        triangle = ((x, y - height), (x + 0.42 * height, y - 0.3 * height), (x - 0.42 * height, y - 0.3 * height))
        return (
            post,
            Polygon(triangle, fill=PAPER, outline=RED, outline_width=0.09 * height),
            Text(x, y - 0.49 * height, content, size=0.42 * height),
        )
    return (
        post,
        Rectangle(x - 0.6 * height, y - height, 1.2 * height, 0.5 * height, 0.08 * height, fill=GREEN),
        Text(x, y - 0.75 * height, content, size=0.34 * height, colour=WHITE),
    )


def gauge(
    x: float, y: float, width: float, height: float, label: str, fraction: float, colour: str = GREEN
) -> tuple[Shape, ...]:
    """Draw a bar filled from the left to a fraction, with its label above it.

    Args:
        x: Left end of the bar.
        y: Top of the bar.
        width: Width of the bar.
        height: Height of the bar.
        label: The text above its left end.
        fraction: The full share of the bar, clipped to [0, 1].
        colour: Colour of the full part.
    """
    full, radius = width * min(1.0, max(0.0, fraction)), 0.35 * height
    return (
        Text(x, y - 0.8 * height, label, size=height, anchor="start"),
        Rectangle(x, y, width, height, radius, fill=SHADE, outline=None, glyph="░"),
        Rectangle(x, y, full, height, radius, fill=colour, outline=None, glyph="█" if full > 0 else ""),
        Rectangle(x, y, width, height, radius, fill=None),
    )


def lamp(x: float, y: float, radius: float, lit: bool) -> tuple[Shape, ...]:
    """Draw a lamp around (x, y), yellow with a glow if it is lit, else grey."""
    if not lit:
        return (Circle(x, y, radius, fill=SHADE, glyph="○"),)
    glow = blend(PAPER, YELLOW, 0.45)
    return (
        Circle(x, y, 1.6 * radius, fill=glow, outline=None),
        Circle(x, y, radius, fill=YELLOW, glyph="●"),
    )


def door(
    x: float, y: float, width: float, height: float, colour: str = WALL, label: str = "", pane: str = ""
) -> tuple[Shape, ...]:
    """Draw a door with a window and a knob.

    Args:
        x: Left edge.
        y: Top edge.
        width: Width of the door.
        height: Height of the door.
        colour: Colour of the door.
        label: The text below its window, such as the number of the door.
        pane: The text in its window.
    """
    middle, low = x + width / 2, y + 0.64 * height
    plate = (Circle(middle, low, 0.2 * width), Text(middle, low, label, size=0.3 * width)) if label else ()
    return (
        Rectangle(x, y, width, height, 0.06 * width, fill=colour),
        Rectangle(x + 0.2 * width, y + 0.1 * height, 0.6 * width, 0.3 * height, 0.06 * width),
        Text(middle, y + 0.25 * height, pane, size=0.24 * height),
        *plate,
        Circle(x + 0.86 * width, low, 0.06 * width, fill=blend(YELLOW, WHITE, 0.4)),
    )


def speech_bubble(x: float, y: float, width: float, height: float, content: str, tip: Point) -> tuple[Shape, ...]:
    """Draw a speech bubble with its top-left corner at (x, y), and a tail to `tip`, which is above or below it."""
    base_x = min(max(tip[0], x + 0.6 * height), x + width - 0.6 * height)
    base_y = y if tip[1] < y else y + height

    def tail(size: float) -> tuple[Point, Point, Point]:
        end = (base_x + size * (tip[0] - base_x), base_y + size * (tip[1] - base_y))
        return (base_x - 0.28 * size * height, base_y), end, (base_x + 0.28 * size * height, base_y)

    return (
        Polygon(tail(1.0), fill=WHITE),
        Rectangle(x, y, width, height, 0.35 * height, fill=WHITE),
        Polygon(tail(0.7), fill=WHITE, outline=WHITE),  # opens the outline of the bubble towards its tail
        Text(x + width / 2, y + height / 2, content, size=0.5 * height),
    )

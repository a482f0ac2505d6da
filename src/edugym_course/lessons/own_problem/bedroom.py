"""The picture of the worked example: a sleeper, a window, and the alarm clock."""

from edugym.rendering.icons import Mood, smiley
from edugym.rendering.palette import BLUE, INK, ORANGE, PAPER, RED, SAND, SHADE, SKY, WALL, WHITE, YELLOW, blend
from edugym.rendering.scene import Arc, Circle, Line, Rectangle, Scene, Shape, Text

SLEEP = ("awake", "dozing", "fast asleep")
LAST_MINUTES = 8 * 60 + 30
"""The end of the episode is half past eight."""


def clock(time: int, length: int) -> str:
    """Return what the clock shows after `time` steps of ten minutes, when the last of `length` steps ends at 8:30."""
    minutes = LAST_MINUTES - 10 * (length - time)
    return f"{minutes // 60 % 24}:{minutes % 60:02}"


def bedroom(time: int, depth: int, length: int = 8, last_action: int | None = None) -> Scene:
    """Draw the bedroom.

    Args:
        time: the steps of ten minutes that have passed.
        depth: how deep she sleeps: 0 is awake, 1 dozing, 2 fast asleep.
        length: the steps of the episode.
        last_action: what the clock has just done: 0 nothing, 1 a chime, 2 a ring.
    """
    daylight = time / length
    shapes: list[Shape] = [
        Rectangle(0, 6.2, 12, 1.8, fill=blend(WALL, SAND, 0.5), outline=None, glyph="░"),
        *_window(daylight),
        *_bed(depth),
        *_table(clock(time, length), last_action or 0),
    ]
    over = time == length
    text = f"{clock(time, length)}, {SLEEP[depth]}" + (
        ": overslept!" if over and depth else ": in time" if over else ""
    )
    shapes.append(Text(6.0, 0.6, text, size=0.62))
    return Scene(12.0, 8.0, shapes, blend(PAPER, BLUE, 0.28 * (1 - daylight)), f"Morning: {text}", columns=48)


def _window(daylight: float) -> list[Shape]:
    """A window with the sun, which rises."""
    sky = blend(blend(BLUE, INK, 0.5), SKY, daylight)
    sun_y = 4.0 - 2.0 * daylight
    return [
        Rectangle(8.6, 1.3, 2.8, 2.6, fill=sky, outline=None),
        Circle(10.4, min(sun_y, 3.35), 0.45, fill=blend(ORANGE, YELLOW, daylight), outline=None, glyph="☼"),
        Rectangle(8.6, 1.3, 2.8, 2.6, fill=None, outline=WALL, outline_width=0.16),
        Line(((10.0, 1.3), (10.0, 3.9)), colour=WALL, line_width=0.1),
    ]


def _bed(depth: int) -> list[Shape]:
    """The bed and the sleeper: awake she sits up, asleep she lies low and a balloon says so."""
    mood: Mood = "happy" if depth == 0 else "flat"
    x, y = (2.1, 4.0) if depth == 0 else (1.9, 4.75)
    shapes: list[Shape] = [
        Rectangle(0.5, 3.5, 0.35, 3.3, fill=WALL),
        Rectangle(0.85, 5.4, 5.9, 0.9, fill=blend(WALL, WHITE, 0.3)),
        Rectangle(1.0, 4.75, 1.9, 0.7, 0.3, fill=WHITE),
        *smiley(x, y, 0.75, mood),
    ]
    if depth > 0:  # eyes shut
        for eye in (x - 0.25, x + 0.25):
            shapes += [
                Circle(eye, y - 0.17, 0.16, fill=YELLOW, outline=None),
                Arc(eye, y - 0.24, 0.14, 20, 160, line_width=0.07),
            ]
    cover = 4.75 if depth > 0 else 4.45
    shapes += [
        Rectangle(2.3, cover, 4.4, 5.75 - cover, 0.35, fill=(SKY, blend(SKY, BLUE, 0.4), blend(SKY, BLUE, 0.7))[depth]),
        Rectangle(6.7, 4.6, 0.3, 2.2, fill=WALL),
    ]
    shapes += (
        [
            Text(3.0 + 0.75 * k, 4.0 - 0.75 * k, "z" if depth == 1 else "Z", size=0.6 + 0.25 * k)
            for k in range(depth + 1)
        ]
        if depth
        else []
    )
    return shapes


def _table(shown: str, action: int) -> list[Shape]:
    """The clock on its table, with a wave for a chime and three for a ring."""
    waves: list[Shape] = [
        Arc(9.4, 5.05, 1.15 + 0.35 * k, 150, 210, colour=RED if action == 2 else ORANGE, line_width=0.12)
        for k in range((0, 1, 3)[action])
    ]
    return [
        Rectangle(8.0, 6.0, 2.8, 0.25, fill=WALL),
        Rectangle(8.3, 6.25, 0.25, 1.2, fill=WALL),
        Rectangle(10.25, 6.25, 0.25, 1.2, fill=WALL),
        *waves,
        Circle(9.0, 4.35, 0.28, fill=RED),
        Circle(9.8, 4.35, 0.28, fill=RED),
        Rectangle(8.6, 4.5, 1.6, 1.45, 0.35, fill=RED),
        Rectangle(8.75, 4.8, 1.3, 0.75, 0.12, fill=SHADE),
        Text(9.4, 5.18, shown, size=0.5),
    ]

"""The picture of Trashbot."""

from typing import Protocol

from edugym.envs.trashbot.geometry import (
    BASE,
    BOX,
    BOX_SIZE,
    CONTAINER_X,
    RIM_Y,
    SHOULDER_Y,
    STAND,
    Arm,
    Block,
    Robot,
    arm,
)
from edugym.rendering.icons import Mood, smiley
from edugym.rendering.palette import BLUE, GRASS, GREEN, RED, ROAD, SKY, STONE, WALL, blend
from edugym.rendering.scene import Circle, Line, Point, Polygon, Rectangle, Scene, Shape, Text

FRAME, TOP = 2.2, 2.7
"""Half the width of the picture, and how much of it is above the ground."""
MOST_DOTS = 15
"""Of more bins than this the next positions would be too many to tell apart."""


class Task(Protocol):
    """What the picture needs to know of the task, an MDP of the class `Trashbot`."""

    @property
    def action_scale(self) -> float:
        """Radians for an action of 1."""

    @property
    def n_bins(self) -> int:
        """The number of values for each joint, 0 for continuous actions."""

    @property
    def obstacles(self) -> tuple[Block, Block, Block, Block]:
        """The base, the stand and the two walls of the container."""

    def centring(self, state: Robot) -> float:
        """The reward for centring the box, from 0 to 2."""


def picture(task: Task, robot: Robot, outcome: str) -> Scene:
    """The arm on its base between box and container, and where the magnet can be after the next step.

    Args:
        task: the MDP.
        robot: its state.
        outcome: that of the state, in a word.
    """
    now = arm(robot.shoulder, robot.elbow)
    moving, delivered = outcome == "moving", outcome == "delivered"
    mood: Mood = "happy" if delivered else "flat" if moving else "sad"
    box = now.load if robot.holding or delivered else BOX
    if delivered:
        box = box._replace(bottom=0.0, top=BOX_SIZE)
    _, _, left, right = task.obstacles
    text = f"step {robot.steps}"
    if not moving:
        text += f": {outcome}"
    elif robot.holding:
        text += ", holding the box"
    if delivered:
        text += f", {task.centring(robot):.2f} of 2 for centring"
    shapes: list[Shape] = [
        _rectangle(Block(-FRAME, -0.3, FRAME, 0.0), GRASS, "░"),
        _rectangle(Block(left.left, 0.0, right.right, RIM_Y), blend(GREEN, SKY, 0.6), ""),
        Line((_at(CONTAINER_X, 0.1), _at(CONTAINER_X, RIM_Y - 0.1)), colour=GREEN, glyph="¦"),
        _rectangle(STAND, WALL, "║"),
        _rectangle(BASE, STONE, "▒"),
        *(_next_positions(task, robot) if moving else ()),
        _rectangle(box, RED, "■"),
        _rectangle(left, GREEN, "█"),
        _rectangle(right, GREEN, "█"),
        *_links(now),
        *smiley(*_at(0.0, SHOULDER_Y), 0.2, mood),
        Text(FRAME, 0.2, text, size=0.17),
    ]
    return Scene(2 * FRAME, TOP + 0.3, shapes, SKY, f"Trashbot: {text}", columns=72)


def _next_positions(task: Task, robot: Robot) -> list[Shape]:
    """A dot for each place at which the magnet can be after the next step, or a line around them."""
    n, few = task.n_bins, 0 < task.n_bins <= MOST_DOTS
    values = [2 * k / (n - 1) - 1 for k in range(n)] if few else [k / 4 - 1 for k in range(9)]
    border = [(a, -1.0) for a in values] + [(1.0, a) for a in values]
    border += [(a, 1.0) for a in reversed(values)] + [(-1.0, a) for a in reversed(values)]
    places = []
    for a, b in [(a, b) for a in values for b in values] if few else border:
        there = arm(robot.shoulder + task.action_scale * a, robot.elbow + task.action_scale * b)
        places.append(_at(there.wrist_x, there.tip_y))
    colour = blend(SKY, BLUE, 0.5)
    if few:
        return [Circle(x, y, 0.02, fill=colour, outline=None, glyph="·") for x, y in places]
    return [Polygon(places, fill=blend(SKY, BLUE, 0.15), outline=colour)]


def _links(now: Arm) -> list[Shape]:
    """The two links with their joints, and the magnet."""
    shoulder, elbow, wrist = _at(0.0, SHOULDER_Y), _at(now.elbow_x, now.elbow_y), _at(now.wrist_x, now.wrist_y)
    return [
        Line((shoulder, elbow, wrist), line_width=0.12),
        Line((shoulder, elbow, wrist), colour=ROAD, line_width=0.09, glyph="o"),
        Line((wrist, _at(now.wrist_x, now.tip_y)), line_width=0.05, glyph="|"),
        *(Circle(x, y, 0.04, fill=STONE) for x, y in (elbow, wrist)),
    ]


def _rectangle(block: Block, fill: str, glyph: str) -> Shape:
    return Rectangle(
        *_at(block.left, block.top), block.right - block.left, block.top - block.bottom, fill=fill, glyph=glyph
    )


def _at(x: float, y: float) -> Point:
    """A point of the world in the picture, where y grows downwards."""
    return x + FRAME, TOP - y

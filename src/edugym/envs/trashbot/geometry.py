"""The world of Trashbot, seen from the side, and what touches what in it.

Lengths are in units of the upper arm; x grows to the right, from the robot's shoulder, and y upwards, from the ground.
"""

import math
from typing import NamedTuple

UPPER_ARM = 1.0
FOREARM = 0.8
MAGNET = 0.2
"""Lengths of the two links and of the magnet, which hangs straight down from the wrist."""
REACH = UPPER_ARM + FOREARM + MAGNET
"""No part of the arm is ever farther from the shoulder."""
SHOULDER_Y = 0.5
BOX_SIZE = 0.25
CONTAINER_X = 1.6
"""The middle of the container."""
RIM_Y = 0.7
"""The height of its walls."""
WALL = 0.05
"""Their thickness."""


class Block(NamedTuple):
    """A rectangle with level sides."""

    left: float
    bottom: float
    right: float
    top: float

    def meets(self, other: "Block") -> bool:
        """Whether the two rectangles have a point in common."""
        across = self.left <= other.right and other.left <= self.right
        return across and self.bottom <= other.top and other.bottom <= self.top

    def meets_line(self, x0: float, y0: float, x1: float, y1: float) -> bool:
        """Whether the rectangle and the straight line from (x0, y0) to (x1, y1) have a point in common.

        They have none exactly if one of three directions separates them: x, y, or across the line (the theorem of the
        separating axis).
        """
        half_width, half_height = (self.right - self.left) / 2, (self.top - self.bottom) / 2
        half_x, half_y = (x1 - x0) / 2, (y1 - y0) / 2
        # From the middle of the rectangle to the middle of the line:
        x, y = (x0 + x1) / 2 - (self.left + self.right) / 2, (y0 + y1) / 2 - (self.bottom + self.top) / 2
        return (
            abs(x) <= half_width + abs(half_x)
            and abs(y) <= half_height + abs(half_y)
            and abs(half_x * y - half_y * x) <= half_width * abs(half_y) + half_height * abs(half_x)
        )


BASE = Block(-0.2, 0.0, 0.2, 0.4)
STAND = Block(-1.56, 0.0, -1.44, 0.3)
BOX = Block(-1.625, 0.3, -1.375, 0.55)
"""Where the box stands at first: on the stand."""


class Arm(NamedTuple):
    """The arm in one position; it starts from the shoulder, at (0, SHOULDER_Y)."""

    elbow_x: float
    elbow_y: float
    wrist_x: float
    wrist_y: float

    @property
    def tip_y(self) -> float:
        """The height of the magnet's lower end, which is right below the wrist."""
        return self.wrist_y - MAGNET

    @property
    def load(self) -> Block:
        """Where a box is that hangs from the magnet."""
        half = BOX_SIZE / 2
        return Block(self.wrist_x - half, self.tip_y - BOX_SIZE, self.wrist_x + half, self.tip_y)

    def links_meet(self, block: Block) -> bool:
        """Whether one of the two links touches a block."""
        return block.meets_line(0.0, SHOULDER_Y, self.elbow_x, self.elbow_y) or block.meets_line(
            self.elbow_x, self.elbow_y, self.wrist_x, self.wrist_y
        )

    def magnet_meets(self, block: Block) -> bool:
        """Whether the magnet touches a block."""
        return block.meets_line(self.wrist_x, self.wrist_y, self.wrist_x, self.tip_y)


def arm(shoulder: float, elbow: float) -> Arm:
    """The arm with these joint angles.

    Args:
        shoulder: from the direction of x to the upper arm, in radians, counterclockwise.
        elbow: from the direction of the upper arm to the forearm, likewise; 0 is a stretched arm.
    """
    elbow_x = UPPER_ARM * math.cos(shoulder)
    elbow_y = SHOULDER_Y + UPPER_ARM * math.sin(shoulder)
    return Arm(
        elbow_x,
        elbow_y,
        elbow_x + FOREARM * math.cos(shoulder + elbow),
        elbow_y + FOREARM * math.sin(shoulder + elbow),
    )


class Robot(NamedTuple):
    """How the arm stands, and how the episode stands.

    Attributes:
        shoulder: the angle of that joint, in radians, as `arm` takes it.
        elbow: the angle of the other, likewise.
        holding: whether the box hangs from the magnet.
        steps: how many steps this episode has taken.
        outcome: `MOVING`, `DELIVERED`, `COLLIDED` or `LATE` (of `task.py`).
    """

    shoulder: float
    elbow: float
    holding: bool
    steps: int
    outcome: int

"""Where the arm can let go of the box, and how well it can do at best: found by trying everything, for actions in bins.

The angles of both joints stay on a lattice then, so that everything the arm can do can be tried, breadth first (see
`edugym.envs.trashbot.planning`).
"""

import math
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from edugym.compiled.execution import executable
from edugym.envs.trashbot.geometry import BOX_SIZE, CONTAINER_X, arm
from edugym.envs.trashbot.planning import explore
from edugym.envs.trashbot.task import START, Trashbot
from edugym_course.lessons.continuous_actions.methods import WIDTH

FOR_THE_BOX = 3.0
"""What picking up the box and delivering it pay, without the reward for centring."""
BEST_OF_ALL = 5.0
"""The best return, with continuous actions."""


class Deliveries(NamedTuple):
    """Where the box can be let go in the container.

    Attributes:
        places: the distances from the middle, positive to the right, in units of the upper arm, shape (n,).
        best_return: the best return; 0 if nothing can be delivered, for holding the box until time is up.
        fewest_steps: to any delivery; 0 if there is none.
    """

    places: Any
    best_return: float
    fewest_steps: int


@cache
def deliveries(n_bins: int, width: float = WIDTH) -> Deliveries:
    """Return where the box can be let go, with so many bins and a container of this width."""
    task = Trashbot.create(n_bins, width)
    unit = task.action_scale / (n_bins - 1)
    turn = round(math.tau / unit)
    distance, delivered = np.full((2, turn, turn), -1), np.zeros((turn, turn), np.bool_)
    queue, came_from = np.zeros((2 * turn * turn, 3), np.int64), np.zeros((2 * turn * turn, 3), np.int64)
    arguments = (task, np.random.default_rng(0), distance, queue, came_from, delivered)
    explore_all = executable(explore, arguments, expected=queue.size, rehearsed=3)
    centring, _, _, fewest, n_places = explore_all(len(queue), *arguments)
    places = [arm(START[0] + i * unit, START[1] + j * unit).wrist_x - CONTAINER_X for i, j in np.argwhere(delivered)]
    best = FOR_THE_BOX + float(centring) if n_places else 0.0
    return Deliveries(np.sort(np.array(places)), best, int(fewest) if n_places else 0)


def best_return(n_bins: int | None, width: float = WIDTH) -> float:
    """Return the best return with so many bins, or with continuous actions (None)."""
    return BEST_OF_ALL if n_bins is None else deliveries(n_bins, width).best_return


def room(width: float = WIDTH) -> float:
    """Return how far from the middle of the container the box still fits."""
    return (width - BOX_SIZE) / 2

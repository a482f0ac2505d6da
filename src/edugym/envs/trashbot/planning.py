"""What can be done in Trashbot: a scripted controller for continuous actions, and an exact search for those in bins."""

import math
from typing import Any, NamedTuple

import numpy as np

from edugym.compiled.execution import executable
from edugym.envs.trashbot.geometry import (
    BOX,
    BOX_SIZE,
    CONTAINER_X,
    FOREARM,
    MAGNET,
    REACH,
    RIM_Y,
    SHOULDER_Y,
    UPPER_ARM,
    Robot,
)
from edugym.envs.trashbot.task import COLLIDED, DELIVERED, LATE, MOVING, Trashbot
from edugym.mdp.protocol import Integers, Random

CLEARANCE = 0.01
"""How far above the rim the box is brought, how far below it let go, and how far into the box the magnet aims; in units
of the upper arm, as all lengths here."""
MOST_MOVES = 500_000_000
"""That a search may have to try, which takes some twenty seconds: those of 23 bins at the default `action_scale`."""
CENTRED = 0.001
"""How close to the middle of the container the box must be before it is lowered."""


def joint_angles(x: float, y: float, bend: float) -> tuple[float, float]:
    """The angles of shoulder and elbow with which the wrist is at (x, y), as in `trashbot_geometry`.

    Args:
        x: how far to the right of the shoulder the wrist should be, in units of the upper arm.
        y: how far above the ground, likewise.
        bend: 1 for an elbow that bends counterclockwise, -1 for clockwise.

    Returns:
        Both angles, in radians.

    Raises:
        ValueError: the point is out of reach.

    References: inverse kinematics of two links, by the law of cosines.
    """
    y = y - SHOULDER_Y
    cosine = (x * x + y * y - UPPER_ARM * UPPER_ARM - FOREARM * FOREARM) / (2 * UPPER_ARM * FOREARM)
    if abs(cosine) > 1:
        raise ValueError(f"x, y must be a point in reach of the wrist, but are {x!r}, {y + SHOULDER_Y!r}")
    elbow = bend * math.acos(cosine)
    shoulder = math.atan2(y, x) - math.atan2(FOREARM * math.sin(elbow), UPPER_ARM + FOREARM * math.cos(elbow))
    return shoulder, elbow


PICK = joint_angles((BOX.left + BOX.right) / 2, BOX.top + MAGNET - CLEARANCE, 1.0)
ABOVE = joint_angles(CONTAINER_X, RIM_Y + BOX_SIZE + MAGNET + CLEARANCE, -1.0)


class ScriptedController(NamedTuple):
    """A policy for continuous actions that sees what the agent sees, and delivers the box in the very middle.

    Both joints turn at speeds such that they arrive together: at the box, above the container, and in its opening.

    Attributes:
        action_scale: that of the task.
    """

    action_scale: float

    @property
    def tabular(self) -> bool:
        """It takes observations as they are, and has no table."""
        return False

    def act(self, state: Any, rng: Random) -> Any:
        """An action, shape (2,).

        Args:
            state: the observation, shape (7,).
            rng: not used.
        """
        elbow_x, elbow_y, wrist_x, wrist_y = (REACH * float(state[k]) for k in range(4))
        shoulder = math.atan2(elbow_y, elbow_x)
        elbow = math.atan2(wrist_y - elbow_y, wrist_x - elbow_x) - shoulder
        goal = PICK
        if state[6] > 0:
            goal = ABOVE
            if abs(wrist_x - CONTAINER_X) < CENTRED:  # lower the box by no more than the joints can do in one step
                lower = min(2 * CLEARANCE, self.action_scale / 4)
                goal = joint_angles(CONTAINER_X, SHOULDER_Y + wrist_y - lower, -1.0)
        turns = [math.remainder(to - now, math.tau) for to, now in zip(goal, (shoulder, elbow), strict=True)]
        slower = max(self.action_scale, *map(abs, turns))
        return np.array([turn / slower for turn in turns], np.float32)


class Plan(NamedTuple):
    """What can be done with actions in bins.

    Attributes:
        actions: shape (n_steps, 2): a shortest way to the best delivery.
        centring: the reward for how well the box is centred that way, from 0 to 2.
        fewest_steps: how many steps the fastest delivery takes, however well centred.
        places: at how many positions of the arm the box can be delivered.
    """

    actions: Integers
    centring: float
    fewest_steps: int
    places: int


def best_plan(mdp: Trashbot) -> Plan:
    """Search everything that the arm can do, breadth first.

    With actions in bins the joint angles stay on a lattice, which is finite where a full turn is a whole number of its
    steps.

    Args:
        mdp: Trashbot with `n_bins`.

    Raises:
        TypeError: this is no MDP of Trashbot.
        ValueError: actions are continuous, the lattice is not finite or too large, or the box cannot be delivered.
    """
    if not isinstance(mdp, Trashbot):
        raise TypeError(f"mdp must be that of Trashbot (`env.unwrapped.mdp`), but is {mdp!r}")
    if not mdp.n_bins:
        raise ValueError("n_bins must be given: continuous actions cannot be searched one by one")
    unit = mdp.action_scale / (mdp.n_bins - 1)
    turn = round(math.tau / unit)
    if abs(turn * unit - math.tau) > 1e-9:
        raise ValueError(f"action_scale must divide a full turn into whole steps, but is {mdp.action_scale!r}")
    n_moves = 2 * turn * turn * mdp.n_bins * mdp.n_bins  # from each state, with the box and without
    if n_moves > MOST_MOVES:
        raise ValueError(f"n_bins must leave at most {MOST_MOVES} moves to try, but {mdp.n_bins!r} make {n_moves}")
    distance = np.full((2, turn, turn), -1)
    queue, came_from = np.zeros((2 * turn * turn, 3), np.int64), np.zeros((2 * turn * turn, 3), np.int64)
    arguments = (mdp, np.random.default_rng(0), distance, queue, came_from, np.zeros((turn, turn), np.bool_))
    explore_all = executable(explore, arguments, expected=queue.size, rehearsed=3)
    centring, place, last_action, fewest_steps, places = explore_all(len(queue), *arguments)
    if places == 0:
        raise ValueError(f"n_bins must be higher: with {mdp.n_bins!r} the box cannot be delivered")
    actions = [last_action]
    while place > 0:
        actions.append((int(came_from[place, 1]), int(came_from[place, 2])))
        place = int(came_from[place, 0])
    return Plan(np.array(actions[::-1]), float(centring), int(fewest_steps), int(places))


def explore(
    most: int, mdp: Trashbot, rng: Random, distance: Any, queue: Any, came_from: Any, delivered: Any
) -> tuple[float, int, tuple[int, int], int, int]:
    """Visit up to `most` states, those that take fewer steps first.

    Args:
        most: how many states to expand.
        mdp: Trashbot with `n_bins`.
        rng: not used.
        distance: shape (2, turn, turn): the steps to (holding, shoulder, elbow), in lattice steps from the start, -1
            where unknown.
        queue: shape (2 turn², 3): the states in the order of their distance.
        came_from: shape (2 turn², 3): for each the place of the one before it in the queue, and the action.
        delivered: shape (turn, turn): whether the box can be delivered there.

    Returns:
        The best centring; where in the queue the state before it is, and the action from there; the fewest steps to
        any delivery; and the number of places.
    """
    turn, unit = distance.shape[1], mdp.action_scale / (mdp.n_bins - 1)
    start = mdp.initial(rng)
    best, best_place, best_action, fewest_steps, places = -1.0, 0, (0, 0), 0, 0
    distance[0, 0, 0] = 0
    head, tail = 0, 1
    while head < tail and head < most:
        holding, i, j = queue[head, 0], queue[head, 1], queue[head, 2]
        steps = distance[holding, i, j]
        state = Robot(start.shoulder + i * unit, start.elbow + j * unit, holding == 1, int(steps), MOVING)
        for k in range(mdp.n_bins):
            for m in range(mdp.n_bins):
                after = mdp.transition(state, (k, m), rng)
                if after.outcome == COLLIDED or after.outcome == LATE:
                    continue
                next_i, next_j = (i + 2 * k - mdp.n_bins + 1) % turn, (j + 2 * m - mdp.n_bins + 1) % turn
                if after.outcome == DELIVERED:
                    fewest_steps = fewest_steps if places > 0 else after.steps
                    if not delivered[next_i, next_j]:
                        delivered[next_i, next_j] = True
                        places += 1
                        centring = mdp.centring(after)
                        if centring > best:
                            best, best_place, best_action = centring, head, (k, m)
                    continue
                next_holding = 1 if after.holding else 0
                if next_holding != holding:
                    next_i, next_j = i, j  # the arm stays where it is while it picks up the box
                if distance[next_holding, next_i, next_j] < 0:
                    distance[next_holding, next_i, next_j] = steps + 1
                    queue[tail, 0], queue[tail, 1], queue[tail, 2] = next_holding, next_i, next_j
                    came_from[tail, 0], came_from[tail, 1], came_from[tail, 2] = head, k, m
                    tail += 1
        head += 1
    return best, best_place, best_action, fewest_steps, places

"""What the tests of Trashbot have in common: one step from a chosen place to another."""

import math
from typing import Any

import numpy as np

from edugym.envs.trashbot.geometry import Robot
from edugym.envs.trashbot.planning import joint_angles
from edugym.envs.trashbot.task import MOVING, Trashbot

RNG = np.random.default_rng(0)
SCALE = math.pi / 15
DEFAULT = Trashbot(0.45, SCALE, 150, 0)


def robot(x: float, y: float, bend: float = -1.0, holding: bool = False, steps: int = 0) -> Robot:
    """The robot with its wrist in one place."""
    return Robot(*joint_angles(x, y, bend), holding, steps, MOVING)


def towards(state: Robot, x: float, y: float, bend: float = -1.0, task: Trashbot = DEFAULT) -> Any:
    """The action that brings the wrist from where it is to another place, if that is close enough."""
    shoulder, elbow = joint_angles(x, y, bend)
    turns = math.remainder(shoulder - state.shoulder, math.tau), math.remainder(elbow - state.elbow, math.tau)
    action = np.array(turns) / task.action_scale
    assert np.abs(action).max() <= 1, action
    return action


def step(state: Robot, action: Any, task: Trashbot = DEFAULT) -> tuple[Robot, float]:
    """The next state and the reward."""
    after = task.transition(state, action, RNG)
    return after, task.reward(state, action, after, RNG)

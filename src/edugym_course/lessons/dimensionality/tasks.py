"""The tasks of lesson 4: Catch seen in one of three ways, with balls from some columns, noisy or darkened."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from edugym.envs.catch import Catch
from edugym.mdp.brightness import Brightness
from edugym.mdp.in_place import in_place
from edugym.mdp.noisy_observation import NoisyObservation
from edugym_course.lessons.dimensionality.boards import ThrownFrom

COLUMNS, ROWS = 5, 10
TRAINED, WITHHELD = (0, 2, 4), (1, 3)
"""The columns of the balls in training, and of those in the test."""


def catch(observation_type: str, columns: Sequence[int] = range(COLUMNS)) -> Any:
    """Return the task with balls from some columns."""
    return ThrownFrom(in_place(Catch.create(ROWS, COLUMNS, observation_type)), np.array(columns))


def noisy(levels: int = 0, sigma: float = 0.0) -> Any:
    """Return the task with noise of some levels in the first pixel, and normal noise in all."""
    return NoisyObservation.create(catch("grid"), levels, sigma)


def darkened(observation_type: str = "grid") -> Any:
    """Return the task with a new brightness, from 0.4 to 1, at every step."""
    return Brightness.create(catch(observation_type))

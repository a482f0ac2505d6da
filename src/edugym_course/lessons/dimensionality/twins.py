"""A riddle in which no image comes twice, for the project of lesson 4."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.programs import APART

ROWS, COLUMNS = 5, 5
"""The size of the images."""


class Twins(gymnasium.Env[Any, Any]):
    """A riddle in which every image is new: two of its pixels are black or white, and the right action says if alike.

    A value that adds up pixels cannot tell, and hidden units with random weights hardly see two pixels among many.
    After 4 000 steps such units answered 39 to 87 % right in 18 riddles, and units that learn all of them in 30.

    Attributes:
        answers: the actions so far, and whether they were right.
    """

    def __init__(self, seed: int) -> None:
        """Draw the two pixels, and the two right actions."""
        rng = np.random.default_rng(APART + seed)
        self.observation_space = spaces.Box(0.0, 1.0, (ROWS, COLUMNS), np.float32)
        self.action_space = spaces.Discrete(3)
        self.answers: list[bool] = []
        self._places, self._right = rng.choice(ROWS * COLUMNS, 2, replace=False), rng.permutation(3)
        self._are_alike = 0

    def _image(self) -> Any:
        image = self.np_random.random(ROWS * COLUMNS, np.float32)
        image[self._places] = pixels = self.np_random.integers(2, size=2)
        self._are_alike = int(pixels[0] == pixels[1])
        return image.reshape(ROWS, COLUMNS)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Show an image."""
        super().reset(seed=seed)
        return self._image(), {}

    def step(self, action: int) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Pay 1 or −1 for an action; that is all."""
        self.answers.append(bool(action == self._right[self._are_alike]))
        return self._image(), 1.0 if self.answers[-1] else -1.0, True, False, {}

"""A world for double Q-learning in which it shows whether the coin is apart from what draws the actions."""

import math
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import run_program

TRY_RUNS, TRY_PULLS, SIGMAS = 300, 40, 4.25
LITTLE, FIRST, SECOND = 0.001, -1.0, 0.96
"""What the first arm always pays, and what the other one pays at its first pull and at all others.

After two pulls of the other arm its value is 0.1 · 0.96 − 0.09 = 0.006 if one table has learned both, and
0.096 − 0.1 = −0.004 if each has learned one. That of the first arm is from 0 to 0.002.
"""


class Tried(gymnasium.Env[Any, Any]):
    """Two arms: the one that is pulled first always pays a little, so that the other one is only tried at random."""

    observation_space, action_space = spaces.Discrete(1), spaces.Discrete(2)

    def __init__(self) -> None:
        """Nothing was pulled."""
        self._first: int | None = None
        self._has_lost = False

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Stand before the arms."""
        super().reset(seed=seed)
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pull an arm."""
        self._first = action if self._first is None else self._first
        if action == self._first:
            return 0, LITTLE, True, False, {}
        reward, self._has_lost = SECOND if self._has_lost else FIRST, True
        return 0, reward, True, False, {}


def require_coin_apart(answer: Any, seed: int) -> None:
    """Refuse a program whose random actions are always learned by the same table.

    Raises:
        WrongAnswer: it does that.
    """
    same = []
    for number in range(TRY_RUNS * seed, TRY_RUNS * (seed + 1)):
        taken = [step.action for step in run_program(answer, Tried(), TRY_PULLS, number).steps]
        tries = np.flatnonzero(np.array(taken[:-1]) != taken[0])[:2]
        if len(tries) == 2:
            same.append(taken[tries[1] + 1] != taken[0])
    if same and abs(np.mean(same) - 0.5) > SIGMAS * math.sqrt(0.25 / len(same)):
        raise WrongAnswer(
            "of two actions the one that is taken first pays a little, so the other one is only tried at random; it"
            f" pays {FIRST:g} and then {SECOND:g}, which is a gain if one table has learned both. In"
            f" {np.mean(same):.0%} of {len(same)} runs it has, and it should in about 50%: throw the coin anew in each"
            " step, with another random number than the one that is compared with ε, and act by the *sum* of both"
        )

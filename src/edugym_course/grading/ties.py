"""Arms of which many are equally good for ever: whoever draws one of them must do so anew in each step."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import APART, run_program

LOSING, N_ARMS, TIE_RUNS, TIE_PULLS, EARLY = 5, 10, 10, 100, 40
"""How many of the arms lose; how many there are; and the runs, their pulls, and the first ones, which do not count."""
OFTEN = 0.5
"""Who draws one of five equal arms anew pulls the one before again in 0.2 of the pulls, and who does not in 0.8."""


class Equal(gymnasium.Env[Any, Any]):
    """Arms of which half lose, and the others pay nothing: with first values of 0 these are equal for ever."""

    observation_space, action_space = spaces.Discrete(1), spaces.Discrete(N_ARMS)

    def __init__(self, seed: int) -> None:
        """Draw the arms that lose."""
        self._losing = np.random.default_rng(APART + seed).permutation(N_ARMS)[:LOSING]

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Stand before the arms."""
        super().reset(seed=seed)
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pull an arm."""
        return 0, -float(action in self._losing), True, False, {}


def require_new_draws(answer: Any, seed: int) -> None:
    """Refuse a program that takes the same one of several equal actions again and again.

    Raises:
        WrongAnswer: it does.
    """
    again = []
    for number in range(TIE_RUNS * seed, TIE_RUNS * (seed + 1)):
        taken = [step.action for step in run_program(answer, Equal(number), TIE_PULLS, number).steps]
        again += [one == before for before, one in zip(taken[EARLY:], taken[EARLY + 1 :], strict=False)]
    if np.mean(again) > OFTEN:
        raise WrongAnswer(
            f"where half of {N_ARMS} actions lose 1 and the others pay nothing, it takes the action of the step before"
            f" again in {np.mean(again):.0%} of the steps, and it should in about 20%: draw one of the best at random,"
            " anew in each step, also where some other action is worse"
        )

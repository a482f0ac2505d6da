"""A world in which chance pays: what a pair is worth to Dyna with α = 1 is what it brought last."""

from functools import partial
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.agents.q_learning import QLearning
from edugym_course.grading.learners import Learner
from edugym_course.grading.programs import run_program, shape_of
from edugym_course.grading.replay import replay
from edugym_course.grading.surprises import Surprises, refusal
from edugym_course.lessons.model_based.methods import EPSILON

STATES, ACTIONS, N_STEPS = 200, 3, 4_000
RIGHT = Learner(partial(QLearning.create, learning_rate=1.0, discount=0.0))
"""Each episode has one step, and imagined steps repeat what is known: so this is what Dyna comes to."""


class LastRewards(gymnasium.Env[Any, Any]):
    """Two hundred bandits with three arms, whose rewards are drawn anew at each pull; an episode is one pull.

    Who mixes rewards, imagines older ones or begins with other values takes other arms.
    """

    observation_space, action_space = spaces.Discrete(STATES), spaces.Discrete(ACTIONS)

    def __init__(self) -> None:
        """Stand anywhere."""
        self._state = 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Stand before one of the bandits."""
        super().reset(seed=seed)
        self._state = int(self.np_random.integers(STATES))
        return self._state, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pull an arm."""
        return self._state, float(np.round(self.np_random.uniform(-1, 1), 3)), True, False, {}


def require_last_rewards(program: Any, seed: int) -> None:
    """Refuse a program whose values are not the rewards that came last.

    Raises:
        WrongAnswer: they are not, or the program breaks the contract.
    """
    world = LastRewards()
    steps = run_program(program, world, N_STEPS, seed).steps
    found = Surprises.of(replay([steps], RIGHT, shape_of(world), EPSILON))
    if not found.is_usual():
        cause = (
            "Each step ends its episode there, and its reward is drawn by chance, so a value is the last reward of its"
            " pair: is α 1 for real and imagined steps, are the first values 0, and does the model keep what came of"
            " each pair *last*, and no older outcome?"
        )
        raise refusal("a world of bandits", EPSILON, found, cause)

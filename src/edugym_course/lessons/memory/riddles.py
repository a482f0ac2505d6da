"""Environments of one step or two, in which a number of Q-learning shows in how the policy begins."""

from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import actions_of, run_program

MOSTLY = 0.8
"""A right program does what it should in this share of the runs at least."""


class Riddle(NamedTuple):
    """An environment, and what comes of it.

    Attributes:
        shows: what happens, for the sentence.
        why: what is amiss if the policy does otherwise.
        again: whether the policy should begin with the action asked about.
        door: what action 1 pays, which ends the episode.
        room: what actions 0 and 1 pay in the step that follows action 0; without it every action ends the episode, the
            last step but one pays 1 and the last one what `door` says, and the policy is asked about their action.
        n_steps: how many steps a run has.
        runs: how many runs there are.
    """

    shows: str
    why: str
    again: bool
    door: float
    room: tuple[float, float] | None = None
    n_steps: int = 2
    runs: int = 60


_ONCE = "every action ends its episode; one pays 1, and the same one then pays"
_DOORS = "action 1 ends the episode, action 0 pays nothing and leads to a second step, in which"
_ALPHA = "is α 0.2, the same from the first step to the last, and are the first values 0?"
_GAMMA = "is γ 0.8, the same from the first step to the last?"
_BEST = "the target has the value of the *best* next action, max_a Q(S', a), and not that of one that is drawn"
RIDDLES = (
    Riddle(f"{_ONCE} -0.79", _ALPHA, True, -0.79),
    Riddle(f"{_ONCE} -0.81", _ALPHA, False, -0.81),
    Riddle(f"after 298 steps that pay nothing {_ONCE} -0.81", _ALPHA, False, -0.81, n_steps=300, runs=20),
    Riddle(
        f"action 1 pays 0.2; {_DOORS} action 1 pays 1 and action 0 costs 1000",
        _BEST,
        True,
        0.2,
        (-1000.0, 1.0),
        n_steps=600,
        runs=20,
    ),
    Riddle(f"action 1 pays 0.79; {_DOORS} both actions pay 1", _GAMMA, True, 0.79, (1.0, 1.0), 1500, 8),
    Riddle(f"action 1 pays 0.81; {_DOORS} both actions pay 1", _GAMMA, False, 0.81, (1.0, 1.0), 1500, 8),
)


class Doors(gymnasium.Env[Any, Any]):
    """The environment of a riddle.

    Args:
        riddle: the riddle.
    """

    observation_space, action_space = spaces.Discrete(2), spaces.Discrete(2)

    def __init__(self, riddle: Riddle) -> None:
        """Take no step."""
        self._riddle, self._is_inside, self._taken = riddle, False, 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Stand before the doors."""
        super().reset(seed=seed)
        self._is_inside = False
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Go through a door, or act behind it."""
        self._taken += 1
        if self._riddle.room is None:
            left = self._riddle.n_steps - self._taken
            return 1, {0: self._riddle.door, 1: 1.0}.get(left, 0.0), True, False, {}
        if self._is_inside:
            return 1, self._riddle.room[action], True, False, {}
        self._is_inside = action == 0
        return 1, 0.0 if self._is_inside else self._riddle.door, not self._is_inside, False, {}


def require_riddles(answer: Any, seed: int) -> None:
    """Refuse a program that has another α or γ, or that counts a next action other than the best.

    Raises:
        WrongAnswer: it does.
    """
    for riddle in RIDDLES:
        again = []
        for number in range(riddle.runs * seed, riddle.runs * (seed + 1)):
            run = run_program(answer, Doors(riddle), riddle.n_steps, number)
            asked = 0 if riddle.room else run.steps[-1].action
            if riddle.room or run.steps[-2].action == asked:
                again.append(actions_of(run.policy, [(0,)], 2, "history") == [asked])
        share = float(np.mean(again))
        if (share if riddle.again else 1 - share) < MOSTLY:
            what = "action 0" if riddle.room else "this action"
            raise WrongAnswer(
                f"where {riddle.shows}, the policy begins with {what} in {share:.0%} of {len(again)} runs, and it"
                f" should {'nearly always' if riddle.again else 'hardly ever'}"
                f"{'' if nobody_asks_why() else f': {riddle.why}'}"
            )

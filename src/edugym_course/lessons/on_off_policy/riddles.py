"""An environment in which the value of the next state shows in what the policy of a program says.

In state 1 every action pays 1, or −1, and ends its episode. After enough of these steps the value of the next action
there is nearly that, whichever it is, so one step from state 0 to state 1 shows whether it counts. Without those steps
all values but one are the first ones.
"""

from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.choices import action_of
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import POLICY, run_program
from edugym_course.grading.student_code import student_code

RUNS, PULLS = 50, 80
MOSTLY, SOME = 0.7, 0.2
"""The smallest share of the runs in which the policy takes the action of the step again, where it should. The rest is
for actions A' in state 1 that were hardly tried: a right program has 0.9 or more, and one that learns nothing from a
truncated step, whose A' is never taken, about a half."""


class Riddle(NamedTuple):
    """One step from state 0 to state 1, and what comes of it.

    Attributes:
        reward: what the step pays.
        again: whether the policy should take its action again.
        shows: what happens, for the sentence.
        why: what is amiss if the policy does otherwise.
        least: in which share of the runs it should at least, if it should.
        pulls: how many steps in state 1 come before.
        terminated: whether the step ends its episode.
        truncated: whether its episode is cut off there.
        pays: what a step in state 1 pays.
    """

    reward: float
    again: bool
    shows: str
    why: str
    least: float = MOSTLY
    pulls: int = PULLS
    terminated: bool = False
    truncated: bool = False
    pays: float = 1.0


_PAYS = "each step in state 1 pays 1 and ends its episode, and after 80 of these a step in state 0"
_FIRST = "are all first values 0, and is the very first step learned from?"
RIDDLES = (
    Riddle(0.002, True, "the first step pays 0.002 and ends its episode", _FIRST, pulls=0, terminated=True),
    Riddle(-0.002, False, "the first step pays -0.002 and ends its episode", _FIRST, pulls=0, terminated=True),
    Riddle(
        -0.995,
        True,
        f"{_PAYS} pays -0.995 and leads to state 1, where the episode goes on",
        "γ is 1, so 1 follows on the -0.995",
    ),
    Riddle(
        -0.9,
        True,
        f"{_PAYS} pays -0.9 and leads to state 1, where the episode is truncated",
        "only `terminated` means that nothing follows; a step that is truncated has its future, Q(S', A') of the S'"
        " that the step gave, not that of reset, and of the A' that would be next",
        SOME,
        truncated=True,
    ),
    Riddle(
        1.9,
        True,
        "each step in state 1 pays -1 and ends its episode, and after 80 of these a step in state 0 pays 1.9 and leads"
        " to state 1, where the episode is truncated",
        "the reward of a step that is truncated counts, too: its target is R + γ Q(S', A')",
        SOME,
        truncated=True,
        pays=-1.0,
    ),
    Riddle(
        -0.5,
        False,
        f"{_PAYS} pays -0.5 and leads to state 1, where the episode terminates",
        "where `terminated` is True nothing follows: the target is the reward alone",
        terminated=True,
    ),
)


class Leads(gymnasium.Env[Any, Any]):
    """The steps of a riddle, and one more: in state 2, which nobody knows, if the episode is over.

    Args:
        riddle: the riddle.
    """

    observation_space, action_space = spaces.Discrete(3), spaces.Discrete(2)

    def __init__(self, riddle: Riddle) -> None:
        """No step was taken."""
        self._riddle, self._taken = riddle, 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin in state 1, in state 0 for the step of the riddle, or in state 2 after it."""
        super().reset(seed=seed)
        return 2 if self._taken > self._riddle.pulls else int(self._taken < self._riddle.pulls), {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Take a step."""
        self._taken += 1
        if self._taken == self._riddle.pulls + 1:
            return 1, self._riddle.reward, self._riddle.terminated, self._riddle.truncated, {}
        return 1, self._riddle.pays, True, False, {}


def require_riddles(answer: Any, seed: int) -> None:
    """Refuse a program that counts what follows otherwise than it should, or whose first values are not 0.

    Raises:
        WrongAnswer: it does.
    """
    for riddle in RIDDLES:
        again = []
        for number in range(RUNS * seed, RUNS * (seed + 1)):
            run = run_program(answer, Leads(riddle), riddle.pulls + 2, number)
            with student_code(POLICY):
                again.append(action_of(POLICY, run.policy(0), 2) == run.steps[riddle.pulls].action)
        share = float(np.mean(again))
        if share < riddle.least if riddle.again else share > 1 - MOSTLY:
            why = "" if nobody_asks_why() else f": {riddle.why}"
            should = "nearly always" if riddle.again else "hardly ever"
            raise WrongAnswer(
                f"where {riddle.shows}, the policy takes the action of this step again in {share:.0%} of {RUNS} runs,"
                f" and it should do so {should}{why}"
            )

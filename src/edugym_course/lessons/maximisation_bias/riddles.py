"""Environments of two steps, in which each part of double Q-learning shows in what the policy says of the second one.

The first step begins in state 0 and pays 1: the value of its action is 0.1 in one table, and all others are 0. Whether
the second step leaves its own action better than the other one, whose value is still 0, hangs on two coins (which table
learned, and whether action 0 or 1 was the first) and on nothing else. So the share of runs in which it does is known
exactly. Steps before these two pay nothing, and leave all values at 0: they show whether α falls.
"""

import math
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.choices import action_of
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import POLICY, run_program
from edugym_course.grading.student_code import student_code

RUNS, MORE_RUNS = 200, 400
SIGMAS = 4.25
"""How many standard errors the share may be from what it is for double Q-learning."""

NEAR = 0.0005
"""How near to the border a reward is with which it shows what the future is worth."""
MANY, OFTEN = 20, 8
"""So many actions that a random one is seldom the best; steps after which both tables have nearly always learned."""
IDLE = 60
"""Steps after which it shows whether α has fallen: at 0.095 or less a share of a half becomes the whole."""


class Riddle(NamedTuple):
    """What the second step is like, and what comes of it.

    Attributes:
        share: of the runs, those in which the policy takes the action of the second step again.
        shows: what happens, for the sentence.
        fewer: what is amiss where the share is smaller.
        more: the same where it is larger.
        begins: the state of the second step; it leads to state 0.
        reward: what it pays.
        terminated: whether it ends its episode.
        truncated: whether its episode is cut off there.
        asks_second: whether there is a second step; if not, the policy is asked about the first.
        goes_on: whether the episode of the first step goes on.
        idle: how many steps come before the first; they pay nothing, and their episodes are truncated.
        pays: what the first step pays.
        n_paid: how many steps pay this before the second one; only runs count in which they all have the same action.
        with_mean: the reward from which on who takes the *mean* over ties in the target takes the action again in half
            of the runs, and in none with `reward`.
        n_actions: how many there are. With two, a random one is the best one in half of the runs.
        runs: how many runs there are.
    """

    share: float
    shows: str
    fewer: str
    more: str = ""
    begins: int = 0
    reward: float = 0.0
    terminated: bool = False
    truncated: bool = False
    asks_second: bool = True
    goes_on: bool = False
    idle: int = 0
    pays: float = 1.0
    n_paid: int = 1
    with_mean: float | None = None
    n_actions: int = 2
    runs: int = RUNS

    @property
    def n_steps(self) -> int:
        """How many steps there are in all."""
        return self.idle + self.n_paid + self.asks_second


_RATE = "a value moves a *tenth* of the way to its target (α = 0.1), and only that of the table that learns"
_OTHER = (
    "what does the table that learns ask the *other* table? Its own argmax chooses the action in the next state, and"
    " the other table says what that action is worth"
)
_COIN = (
    "a coin says which table learns, each time anew; a value moves a *tenth* of the way to its target (α = 0.1); all"
    " first values are 0"
)
_LOSS = "a loss if one table has learned both, and a gain if each has learned one"
_ONCE = "the first step pays 1 and ends its episode"
RIDDLES = (
    Riddle(
        1.0,
        "a first step has paid 1, and all else is still 0",
        "the policy takes the *best* action, by the sum of both tables, and never a random one",
        asks_second=False,
    ),
    Riddle(
        1.0,
        f"{_ONCE}, the next one begins in state 1, and an action there pays 1",
        "learn about the state that reset() gives: state, info = environment.reset(), and change its value, not that of"
        " the next one",
        begins=1,
        reward=1.0,
        terminated=True,
    ),
    Riddle(
        0.5,
        f"{_ONCE}, and the same action then pays -0.905 and ends one too: {_LOSS}",
        "in each step *one* table learns, and a coin says which, each time anew; are Q1 and Q2 two arrays, 0 at first?",
        _COIN,
        reward=-0.905,
        terminated=True,
    ),
    Riddle(
        0.5,
        f"the first step pays 1, and in the same episode the same action then pays -0.905 and ends it: {_LOSS}",
        "the coin is thrown in each *step*, not in each episode",
        _COIN,
        reward=-0.905,
        terminated=True,
        goes_on=True,
    ),
    Riddle(
        0.5,
        f"{IDLE} steps pay nothing and are truncated, the next one pays 1 and ends its episode, and the same action"
        f" then pays -0.905 and ends one too: {_LOSS}",
        "are α = 0.1 and the coin the same in each step?",
        "does α stay 0.1 to the last step?",
        reward=-0.905,
        terminated=True,
        idle=IDLE,
    ),
    Riddle(
        1.0,
        f"{_ONCE}, and the same action then pays -0.895 and ends one too",
        _RATE,
        reward=-0.895,
        terminated=True,
    ),
    Riddle(
        1.0,
        "the first step pays 3 and ends its episode, and the same action then pays -2 and ends one too",
        "a reward counts in full: is it cut off at 1, or divided by something?",
        reward=-2.0,
        terminated=True,
        pays=3.0,
    ),
    Riddle(
        0.25,
        f"{_ONCE}, and then an action in state 1 pays -0.07 and leads to state 0, where the episode goes on",
        f"{_OTHER}. It counts where the episode goes on, with γ = 1",
        _OTHER,
        begins=1,
        reward=-0.07,
        with_mean=-0.05,
    ),
    Riddle(
        0.25,
        f"{_ONCE}, and then an action in state 1 pays -0.07 and leads to state 0, where the episode is truncated",
        "only `terminated` means that nothing follows; a step that is truncated has its future, from the state that"
        " step gave, not the one that reset gives",
        _OTHER,
        begins=1,
        reward=-0.07,
        truncated=True,
        with_mean=-0.05,
    ),
    Riddle(
        0.0,
        f"{_ONCE}, and then an action in state 1 pays -0.04 and leads to state 0, where it terminates",
        "",
        "where `terminated` is True, nothing follows: the target is the reward",
        begins=1,
        reward=-0.04,
        terminated=True,
    ),
    Riddle(
        0.25,
        f"{_ONCE}, and then an action in state 1 pays -0.0995 and leads to state 0, where the episode goes on",
        "the discount is 1, and α is 0.1: what follows in state 0 is worth 0.1, or 0",
        _OTHER,
        begins=1,
        reward=-0.0995,
        with_mean=-0.05,
    ),
    Riddle(
        0.25,
        f"{_ONCE}, and the same action then pays -1.07 and leads to state 0 again, where the episode is truncated",
        "the table that *learns* chooses the action in the next state, and the *other* one says what it is worth: are"
        " the two swapped, or is the value of the other table taken from the target?",
        _OTHER,
        reward=-1.07,
        with_mean=-1.05,
        truncated=True,
    ),
    Riddle(
        0.5 + 0.25 / MANY,
        f"of {MANY} actions the same one pays 1 in two episodes of one step, and then an action in state 1 pays -0.0975"
        " and leads to state 0, where the episode goes on",
        _OTHER,
        _OTHER,
        begins=1,
        reward=-0.0975,
        n_paid=2,
        n_actions=MANY,
    ),
    Riddle(
        1 - 2 / 2**OFTEN * (1 - 0.5 / MANY),
        f"of {MANY} actions the same one pays 1 in {OFTEN} episodes of one step, and then an action in state 1 pays"
        " -0.05 and leads to state 0, where the episode goes on",
        f"{_OTHER}. This is the *best* one, not one drawn at random nor the one that is taken next."
        " (Or is the coin not a fair one?)",
        begins=1,
        reward=-0.05,
        n_paid=OFTEN,
        n_actions=MANY,
    ),
    Riddle(
        sum(math.comb(OFTEN, k) for k in range(OFTEN // 2, OFTEN + 1)) / 2**OFTEN,
        f"the same action pays 1 in {OFTEN} episodes of one step, and then an action in state 1 pays -0.3 and leads to"
        " state 0, where the episode goes on: that is a gain if the table that does not learn has learned half of the"
        f" {OFTEN}",
        "is the coin a fair one, 0 or 1 with the same probability?",
        "is the coin a fair one, thrown anew in each step, and not one table after the other?",
        begins=1,
        reward=-0.3,
        n_paid=OFTEN,
        runs=MORE_RUNS,
    ),
)


class Twice(gymnasium.Env[Any, Any]):
    """The steps of a riddle; those after them pay nothing, and end their episodes.

    Args:
        riddle: the riddle.
    """

    observation_space = spaces.Discrete(2)

    def __init__(self, riddle: Riddle) -> None:
        """No step was taken."""
        self.action_space = spaces.Discrete(riddle.n_actions)
        self._riddle, self._taken = riddle, -riddle.idle

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin the next of the steps; after the last one, where nothing was learned."""
        super().reset(seed=seed)
        if self._taken > self._riddle.n_paid:
            return 1, {}
        return self._riddle.begins if self._taken == self._riddle.n_paid else 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Take one of the steps."""
        self._taken += 1
        if self._taken <= 0:
            return 0, 0.0, False, True, {}
        paid = self._taken <= self._riddle.n_paid
        if self._taken == self._riddle.n_paid + 1:
            return 0, self._riddle.reward, self._riddle.terminated, self._riddle.truncated, {}
        return 0, self._riddle.pays * paid, not (self._riddle.goes_on and paid), False, {}


def require_riddles(answer: Any, seed: int) -> None:
    """Refuse a program that leaves out a part of double Q-learning, or does it in another way.

    Raises:
        WrongAnswer: it does.
    """
    for riddle in RIDDLES:
        again = _again(answer, riddle, seed)
        kept = float(np.mean(again))
        if not _is_usual(again, riddle.share) and not (kept == 0 and _takes_the_mean(answer, riddle, seed)):
            why = riddle.fewer if kept < riddle.share else riddle.more
            raise WrongAnswer(
                f"in an environment of {riddle.n_steps} step{'s'[: riddle.n_steps - 1]} {riddle.shows}; after that the"
                f" policy takes this action again in {kept:.0%} of {len(again)} runs, and it should in"
                f" {'about ' * (0 < riddle.share < 1)}{riddle.share:.0%}{'' if nobody_asks_why() else f': {why}'}"
            )


def _is_usual(again: list[bool], share: float) -> bool:
    return abs(float(np.mean(again)) - share) <= SIGMAS * math.sqrt(share * (1 - share) / len(again))


def _takes_the_mean(answer: Any, riddle: Riddle, seed: int) -> bool:
    """Whether a program behaves as one that takes the mean over ties in its target, as our code does."""
    if riddle.with_mean is None:
        return False
    below, above = (riddle._replace(reward=riddle.with_mean + by) for by in (-NEAR, NEAR))
    return _is_usual(_again(answer, above, seed), 0.5) and not any(_again(answer, below, seed))


def _again(answer: Any, riddle: Riddle, seed: int) -> list[bool]:
    """Return for each run that counts whether the policy takes the action of the last step of a riddle again."""
    again = list[bool]()
    for number in range(riddle.runs * seed, riddle.runs * (seed + 1)):
        run = run_program(answer, Twice(riddle), riddle.n_steps, number)
        steps = run.steps[riddle.idle : riddle.n_steps]
        same = steps[: riddle.n_paid] if riddle.begins else steps
        if len({step.action for step in same}) == 1:
            with student_code(POLICY):
                again.append(action_of(POLICY, run.policy(steps[-1].state), riddle.n_actions) == steps[-1].action)
    return again

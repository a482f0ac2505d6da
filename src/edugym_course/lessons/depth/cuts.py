"""Episodes that are truncated: what n-step SARSA may learn from them, and what it may not."""

import math
from collections.abc import Iterator
from functools import partial
from typing import Any

import gymnasium
from gymnasium import spaces

from edugym_course.grading.learners import Learner
from edugym_course.grading.programs import run_program, shape_of
from edugym_course.grading.replay import replay
from edugym_course.grading.small_world import LAYERS, WIDTH, SmallWorld
from edugym_course.grading.surprises import Row, Surprises, likeliest, refusal, usual_refusal
from edugym_course.lessons.depth.slips import DISCOUNT, N, slips
from edugym_course.lessons.depth.targets import EPSILON

N_STEPS = 3_000
BEGINS, COST = 0.3, -6.0
"""The share of the episodes that begin in the last state, and what every action brings there."""
CUT = (
    Learner(slips),
    Learner(partial(slips, cut="value")),
    Learner(partial(slips, cut="value", cut_weight=lambda k: DISCOUNT**N if k == N else 0.0)),
)
"""What may be learned where an episode is truncated: the rewards alone; a value too; a value after n rewards only."""
CUT_MISTAKES = {
    "nothing is learned there: all pairs that are left have the rewards that there are": Learner(
        partial(slips, cut="nothing")
    ),
    "nothing is learned from such an episode: all its pairs have the rewards that there are": Learner(
        partial(slips, cut="all")
    ),
    "the last reward is lost there": Learner(partial(slips, cut="last")),
    "the rewards are not discounted there: they have the weights 1, γ and γ²": Learner(partial(slips, cut_total=sum)),
    "a value after k < n rewards has the weight γⁿ, and it should be γᵏ": Learner(
        partial(slips, cut="value", cut_weight=lambda k: DISCOUNT**N)
    ),
    "the value is not discounted: after k rewards it has the weight γᵏ": Learner(
        partial(slips, cut="value", cut_weight=lambda k: 1.0)
    ),
    "the value has the weight γ, and after k rewards it should be γᵏ": Learner(
        partial(slips, cut="value", cut_weight=lambda k: DISCOUNT)
    ),
    "the value is that of the last pair, and it should be one of the state that the last step gave": Learner(
        partial(slips, cut="before")
    ),
    "the value is that of the state after the reset; it should be that of the state which the last step gave": Learner(
        partial(slips, cut="value"), restarts=True
    ),
}
CUT_SIGMAS = 6.0
"""How many standard deviations of surprises are too many there. A right program may count the value of an action that
it draws, and nobody sees which; of 120 runs of right programs, 2.6 was the most."""


class Cuts(gymnasium.Wrapper[Any, Any, Any, Any]):
    """A small world in which the clock stops in one state only, where some episodes begin, too.

    Every action brings the same there and ends the episode, and less than the first values. So all actions are tried
    there, and soon they are worth the same: a program may count the value of any of them.

    Args:
        world: the small world.
    """

    def __init__(self, world: SmallWorld) -> None:
        """Add the state."""
        super().__init__(world)
        self._last, self._is_there = LAYERS * WIDTH, False
        self.observation_space = spaces.Discrete(self._last + 1)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begin in the first layer, or in the last state."""
        state, info = self.env.reset(seed=seed)
        self._is_there = bool(self.unwrapped.np_random.random() < BEGINS)
        return self._last if self._is_there else state, info

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Take a step of the small world, or the last one."""
        if self._is_there:
            return self._last, COST, True, False, {}
        state, reward, terminated, truncated, info = self.env.step(action)
        return self._last if truncated else state, float(reward), terminated, truncated, info


def require_cuts(program: Any, seed: int) -> None:
    """Refuse a program that learns from truncated episodes what it should not.

    Raises:
        WrongAnswer: it does, or it breaks the contract.
    """
    world = Cuts(SmallWorld(seed))
    steps, shape = run_program(program, world, N_STEPS, seed).steps, shape_of(world)

    def found(learner: Learner) -> Iterator[Row]:
        return replay([steps], learner, shape, EPSILON)

    right = max((Surprises.of(found(learner)) for learner in CUT), key=lambda one: float(one.logs.sum()))
    sentences, learners = zip(*CUT_MISTAKES.items(), strict=True)
    highest = math.log(1 - EPSILON + EPSILON / shape[1])
    number, rows = likeliest([found(learner) for learner in learners], len(steps), highest)
    where = "small worlds whose episodes may be truncated,"
    cause = (
        "So look at episodes that are truncated: all pairs that are left learn from the k rewards that there are, with"
        " the weights 1, γ, ..., and then, if you like, from γᵏ times a value of the state that the last step gave"
    )
    slip = Surprises.of(rows)
    is_slip = slip.explains_better_than(right)
    if is_slip and slip.too_many < CUT_SIGMAS * slip.deviation:
        raise usual_refusal(where, EPSILON, right, sentences[number], "where an episode is truncated, ")
    if is_slip or right.too_many > CUT_SIGMAS * right.deviation:
        raise refusal(where, EPSILON, right, cause)

"""Why many learners do not drive from the tee: each of two causes is taken away.

*Bad luck*: a few lost balls, close to each other, make the drive look bad. *The rest of the game*: the cells to which a
drive leads are visited rarely, and their values start at 0.
"""

from typing import Any, NamedTuple

import numpy as np

from edugym.envs.golf import Ball, Golf
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.wrapper import wrapper
from edugym_course.lessons.stochasticity.exact import optimum
from edugym_course.lessons.stochasticity.methods import (
    LEARNING_RATE,
    LEVEL,
    N_STEPS,
    NEUTRAL,
    NEUTRAL_ONLY,
    REPETITIONS,
    first_swings,
    learn,
    methods_with,
    play,
    scripted,
)

AS_IT_IS, NO_BAD_LUCK = "as in the experiment", "little bad luck"
REST_KNOWN, NEITHER = "the rest of the game known", "both"
DRIVE = 2
NEAR = 0.01
"""A player is near the optimum if its mean return is less than this below it."""


@wrapper
class FirstSwing(NamedTuple):
    """A game in which the agent chooses the first swing only; then a rule plays on to the end."""

    mdp: Any  # the game
    rule: Integers  # shape (width, length): the swing from each cell

    def transition(self, state: Ball, action: int, rng: Random) -> Ball:
        """The swing of the agent, and then those of the rule."""
        ball: Ball = self.mdp.transition(state, action, rng)
        while not self.mdp.terminal(ball):
            ball = self.mdp.transition(ball, self.rule[int(ball.x), int(ball.y)], rng)
        return ball


def first_swing_only(level: float) -> FirstSwing:
    """Return the game in which a rule chips and putts after the first swing, which is nearly the best play."""
    golf = Golf.create(stochasticity_level=level, observe_hits=True)
    swings = scripted(np.inf, np.inf, 2.8, golf).argmax(axis=1)
    return FirstSwing(golf, swings.reshape(golf.width, golf.length))


def without_causes(
    level: float = LEVEL,
    learning_rate: float = LEARNING_RATE,
    *,
    as_it_is: Results | None = None,
    repetitions: int = REPETITIONS,
    **how: Any,
) -> dict[str, Reals]:
    """Train Q-learning as it is, and without one or both of two causes for which it may not drive.

    Against bad luck its steps are a quarter as large. Against rare cells a rule plays the rest of the game.

    Args:
        level: the stochasticity level of the game.
        learning_rate: α.
        as_it_is: the runs of Q-learning as it is, if they are there already.
        repetitions: the number of runs of each.
        **how: more arguments of `edugym.experiments.repeat`.

    Returns:
        By what is taken away, for every run whether it starts with a drive in the end: 1 or 0.
    """
    how["repetitions"] = repetitions
    small = learning_rate / 4
    results = {
        AS_IT_IS: _learn(level, learning_rate=learning_rate, **how) if as_it_is is None else as_it_is,
        NO_BAD_LUCK: _learn(level, learning_rate=small, **how),
        REST_KNOWN: _learn_first_swing(level, learning_rate, **how),
        NEITHER: _learn_first_swing(level, small, **how),
    }
    return {label: (first_swings(one, NEUTRAL) == DRIVE).astype(float) for label, one in results.items()}


def _learn(level: float, **how: Any) -> Results:
    return learn(level=level, risks=NEUTRAL_ONLY, points=1, evaluation_episodes=1, **how)


def _learn_first_swing(level: float, learning_rate: float, n_steps: int = N_STEPS, **how: Any) -> Results:
    """Train on as many games: a whole game has about three steps."""
    games = max(1, n_steps // 3)
    methods = methods_with(NEUTRAL_ONLY, learning_rate=learning_rate)
    return repeat(first_swing_only(level), methods, games, evaluate_every=games, evaluation_episodes=1, **how)


def near_optimum(results: Results, level: float) -> Reals:
    """Return for every run of Q-learning whether its greedy policy is near the optimum in the end: 1 or 0."""
    mean = play(results, level=level, n_steps=50_000)[NEUTRAL].mean
    return (mean > optimum(level) - NEAR).astype(float)


def near_optimum_at(results: Results, level: float, step: int) -> Reals:
    """Return the same for the evaluation after a number of training steps."""
    return (results.at(NEUTRAL, step) > optimum(level) - NEAR).astype(float)

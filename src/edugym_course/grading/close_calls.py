"""A world of close calls: small differences in γ, in the rewards or in the first values decide what looks best."""

import math
from collections.abc import Mapping
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.learners import Learner
from edugym_course.grading.programs import APART, run_program, shape_of
from edugym_course.grading.replay import replay
from edugym_course.grading.surprises import NEAR, Surprises, likeliest, refusal, usual_refusal

WHERE = "worlds where small differences decide,"
WORLDS, N_STEPS = 2, 3_000
ACTIONS, BANDITS, CORRIDOR = 2, 30, 10
SMALL, LESS = 0.05, 0.03
"""The size of a bandit's reward: the first action stays the best one if it is above the first value of the other one.
Action 1 brings so much less, there and on the way through a corridor: values that end up equal would be told apart by
their last digits.
"""
END, LEAVE = -4.0, (-3.78, -3.46)
"""What the end of a corridor brings, and what leaving the corridors at once does. The way to the end is worth −4 γ^9:
−3.65 with γ = 0.99; with 0.995 or more it is less than the first of these, with 0.983 or less more than the second.
"""
TOLL, AROUND = -4.0, -3.98
"""What a toll costs, after which there is one more step, and what the way around it costs, which is a single step. Who
discounts rewards as well pays the toll.
"""


class CloseCalls(gymnasium.Env[Any, Any]):
    """Bandits of one step, two corridors that one may leave at once, and a toll that one may go around.

    A bandit brings a little more than 0 or a little less; then the episode is over. In a corridor of ten steps both
    actions go on, and the last step costs 4. But in its first state action 0 ends the episode at once, for a cost near
    that of the way to the end. The values of a corridor are below 0, where they begin, so that a greedy program tries
    both actions until it knows what they cost.

    Args:
        seed: the number from which the numbers of the states are drawn.
    """

    def __init__(self, seed: int) -> None:
        """Number the states anew, so that a corridor does not run from 0 to 9."""
        n = BANDITS + len(LEAVE) * CORRIDOR + 2
        self.observation_space = spaces.Discrete(n)
        self.action_space = spaces.Discrete(ACTIONS)
        self._number = np.random.default_rng(APART + seed).permutation(n)
        self._place = 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin at a bandit, before the toll or in a corridor, there mostly in the first state."""
        super().reset(seed=seed)
        kind = self.np_random.random()
        if kind < 0.3:
            self._place = int(self.np_random.integers(BANDITS))
        elif kind < 0.45:
            self._place = BANDITS + len(LEAVE) * CORRIDOR
        else:
            begins_late = self.np_random.random() < 0.5
            inside = int(self.np_random.integers(CORRIDOR)) if begins_late else 0
            self._place = BANDITS + CORRIDOR * int(self.np_random.integers(len(LEAVE))) + inside
        return int(self._number[self._place]), {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Take the reward of a bandit, pay the toll or go around it, or go on in a corridor."""
        here, (which, inside) = self._place, divmod(self._place - BANDITS, CORRIDOR)
        if here < BANDITS:
            reward, terminated = (SMALL if here % 2 else -SMALL) - LESS * action, True
        elif which == len(LEAVE):
            terminated = inside == 1 or action == 0
            reward = 0.0 if inside == 1 else AROUND if terminated else TOLL
        elif inside == 0:
            reward, terminated = (0.0, False) if action else (LEAVE[which], True)
        else:
            terminated = inside == CORRIDOR - 1
            reward = END * terminated - LESS * action
        self._place += not terminated
        return int(self._number[self._place]), reward, terminated, False, {}


def require_close_calls(
    program: Any, seed: int, right: Learner, mistakes: Mapping[str, Learner], epsilon: float
) -> None:
    """Refuse a program with another γ or other first values, whose update is right in all else.

    Args:
        program: the program.
        seed: the number from which the worlds are drawn.
        right: the method that it should have.
        mistakes: the same with other numbers, by the sentence that tells of each.
        epsilon: how often the program should try a random action.

    Raises:
        WrongAnswer: too many of its actions do not follow from its steps; or it breaks the contract.
    """
    seeds = range(WORLDS * seed, WORLDS * (seed + 1))
    runs = [run_program(program, CloseCalls(number), N_STEPS, number).steps for number in seeds]
    shape = shape_of(CloseCalls(seeds[0]))
    found = Surprises.of(replay(runs, right, shape, epsilon))
    if found.is_usual():
        return
    replays = [replay(runs, mistake, shape, epsilon) for mistake in mistakes.values()]
    number, rows = likeliest(replays, sum(map(len, runs)), math.log(1 - epsilon + epsilon / shape[1]))
    likely = Surprises.of(rows)
    if likely.explains_better_than(found) and likely.is_usual(NEAR):
        raise usual_refusal(WHERE, epsilon, found, [*mistakes][number])
    raise refusal(
        WHERE,
        epsilon,
        found,
        "Are α, γ and the first values those of the text, the first values all the same, and the values neither rounded"
        " nor cut off?",
    )

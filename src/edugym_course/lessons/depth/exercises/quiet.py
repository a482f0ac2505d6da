"""Exercise 1: how deep an agent looks, and with which learning rate and discount."""

import math
from functools import cache
from typing import Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.values import digits, in_brackets
from edugym_course.lessons.depth.exercises.episodes import Episode, learn_from
from edugym_course.lessons.depth.methods import LEARNING_RATE, maker
from edugym_course.lessons.depth.targets import DISCOUNT

RATES = (LEARNING_RATE, 0.01, 0.05, 0.2, 0.3, 0.5, 0.9, 1.0)
DISCOUNTS = (DISCOUNT, 0.0, 0.9, 0.95, 0.99)


def check_depth(agent: Any, days: int, seed: int, learning_rate: float) -> None:
    """Check that an agent learns from whole episodes, with a learning rate and the discount of the lesson.

    Raises:
        WrongAnswer: it looks less deep, or has another rate or discount.
    """
    episode = _episode(days, seed)
    found = _values(agent, episode)
    right = _values(_agent(math.inf, learning_rate, DISCOUNT, days), episode)
    if np.allclose(found, right):
        return
    cases = {} if nobody_asks_why() else _cases(days, seed, learning_rate)
    fits = [case for case, values in cases.items() if np.allclose(found, values)]
    if not fits and np.allclose(found, _values(_agent(math.inf, DISCOUNT, learning_rate, days), episode)):
        raise WrongAnswer(
            f"the learning rate and the discount have changed places: learning_rate={learning_rate:g} and"
            f" discount={DISCOUNT:g}"
        )
    if not fits:
        raise WrongAnswer(
            f"after two equal episodes with rewards {in_brackets(episode.rewards)}, the value of the first action"
            f" should be {digits(right[0], found[0])}, but is {digits(found[0], right[0])}: that is no n-step SARSA"
            " with a usual learning rate"
        )
    n, rate, discount = fits[0]
    wrong = []
    if n != math.inf:
        wrong.append(f"its targets have {n:g} reward{'s' if n > 1 else ''}, and Monte Carlo has n=math.inf")
    if rate != learning_rate:
        wrong.append(f"it has a learning rate of {rate:g}, and it should be {learning_rate:g}")
    if discount != DISCOUNT:
        wrong.append(f"it has a discount of {discount:g}, and it should be {DISCOUNT:g}")
    raise WrongAnswer("the quiet agent should be that of the experiment, but " + "; and ".join(wrong))


@cache
def _cases(days: int, seed: int, learning_rate: float) -> dict[tuple[float, float, float], Reals]:
    """Return the values that other depths, learning rates and discounts would give."""
    episode = _episode(days, seed)
    return {
        (n, rate, discount): _values(_agent(n, rate, discount, days), episode)
        for n in (math.inf, *range(1, days))
        for rate in (learning_rate, *RATES)
        for discount in DISCOUNTS
    }


def _episode(days: int, seed: int) -> Episode:
    rng = np.random.default_rng(seed)
    actions = [int(action) for action in rng.integers(2, size=days)]
    rewards = [float(reward) for reward in rng.choice([-2.0, -1.0, 1.0, 2.0], size=days - 1)]
    return Episode(list(range(days)), actions, [*rewards, 8.0])


def _agent(n: float, rate: float, discount: float, days: int) -> Any:
    return maker(n, learning_rate=rate, discount=discount, total_days=days)((days + 1, 2))


def _values(agent: Any, episode: Episode) -> Reals:
    """Return the values on a path of states 0, 1, ... after two equal episodes."""
    days = len(episode.states)
    for _ in range(2):
        learn_from(agent, episode, days)
    values: Reals = agent.Q[np.arange(days), episode.actions]
    return values.copy()

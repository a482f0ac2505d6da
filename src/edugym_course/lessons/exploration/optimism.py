"""Optimism beside Go-Explore: who is ahead, what it needs, and how the last digit of a number can spoil it."""

import math
from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from edugym.agents.q_learning import QLearning
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Random
from edugym_course.lessons.exploration.climbs import first_at_top
from edugym_course.lessons.exploration.methods import (
    GO_EXPLORE,
    LEARNING_RATE,
    METHODS,
    N_STEPS,
    OPTIMISM,
    OPTIMIST,
    Maker,
    compare,
    optimist,
    visits_of,
)

WALLS = ((100, 2), (100, 3), (30, 3))
"""Heights and numbers of grips."""
LEAD_WALL, LEAD_RUNS = (100, 3), 3
"""The wall on which optimism returns more than Go-Explore, and how many times as many runs show it: with 30 runs the
interval of this difference is as wide as the difference."""


class ByTheLastDigit(QLearning):
    """Q-learning whose ties are only those of exactly equal numbers."""

    __slots__ = ()

    def act(self, state: int, rng: Random) -> int:
        """Never explore."""
        return self.greedy(state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value; among those of exactly the same value, one at random."""
        best, equals = 0, 1
        for action in range(1, self.Q.shape[1]):
            if self.Q[state, action] > self.Q[state, best]:
                best, equals = action, 1
            elif self.Q[state, action] == self.Q[state, best]:
                equals += 1
                if rng.random() * equals < 1.0:
                    best = action
        return best


def by_the_last_digit(environment: Any, discount: float) -> ByTheLastDigit:
    """Return an optimist whose choices hang on the last digit."""
    return ByTheLastDigit(*optimist(environment, discount=discount))


FROM_0, HALF, FAR = "optimism, values from 0", "optimism, α = 0.5", "optimism, γ = 0.99"
DIGIT, DIGIT_EXACT = "last digit, γ = 0.9", "last digit, γ = 0.5"
OPTIMISTS: Mapping[str, Maker] = MappingProxyType(
    {
        OPTIMISM: OPTIMIST,
        GO_EXPLORE: METHODS[GO_EXPLORE],
        FROM_0: partial(optimist, initial_value=0.0),
        HALF: partial(optimist, learning_rate=LEARNING_RATE),
        FAR: partial(optimist, discount=0.99),
        DIGIT: partial(by_the_last_digit, discount=0.9),
        DIGIT_EXACT: partial(by_the_last_digit, discount=0.5),
    }
)


def compare_optimists(height: int, n_grips: int, **how: Any) -> Results:
    """Train optimism, Go-Explore, and optimism with one thing changed; further arguments as in `compare`."""
    return compare(height, methods=OPTIMISTS, n_grips=n_grips, **how)


def compare_leaders(wall: tuple[int, int], **how: Any) -> Results:
    """Train optimism and Go-Explore only, so that many runs cost little; further arguments as in `compare`."""
    height, n_grips = wall
    return compare(height, methods={name: OPTIMISTS[name] for name in (OPTIMISM, GO_EXPLORE)}, n_grips=n_grips, **how)


def named(wall: tuple[int, int]) -> str:
    """Return how claims call a wall."""
    height, n_grips = wall
    return f"height {height} with {n_grips} grips"


def optimism_claims(optimism: Mapping[tuple[int, int], Results], leaders: Results) -> list[Claim]:
    """Return the claims on optimism beside Go-Explore: what it needs, who is ahead, and what limits it.

    Args:
        optimism: for each wall, the results of `compare_optimists`.
        leaders: the results of `compare_leaders` on the high wall with more grips.
    """
    from_0 = {wall: f"With values that start at 0 the same agent does not solve {named(wall)}" for wall in optimism}
    solves = {wall: f"Optimism solves {named(wall)}, without returning first and without a bonus" for wall in optimism}
    ahead = {
        wall: paired_difference(first(results, OPTIMISM), first(results, GO_EXPLORE))
        for wall, results in optimism.items()
    }
    claims = [
        claim
        for wall, results in optimism.items()
        for claim in (
            Claim(
                solves[wall],
                "share of runs that end at the top",
                results.share(OPTIMISM, at_least=1.0),
                Above(0.7),
                "what it has not tried looks best, so that it tries every grip",
                (*from_0.values(),),
            ),
            Claim(
                from_0[wall],
                "share of runs that end at the top",
                results.share(FROM_0, at_least=1.0),
                Below(0.2),
            ),
            Claim(
                f"Optimism first gets to the top sooner than Go-Explore: {named(wall)}",
                "training steps, optimism less Go-Explore",
                ahead[wall],
                Below(-100.0),
                "Go-Explore reaches for random grips at its goal, and so for grips that it has tried",
            ),
        )
    ]
    high = [wall for wall in optimism if wall[0] == max(height for height, _ in optimism)]
    claims += [
        Claim(
            f"With learning rate {LEARNING_RATE:g} optimism solves less than half of the walls of {named(wall)}",
            f"share of runs that end at the top, α = {LEARNING_RATE:g}",
            optimism[wall].share(HALF, at_least=1.0),
            Below(0.5),
            "each disappointment then takes only half of the optimism away",
            tuple(solves[wall] for wall in high),
        )
        for wall in high
    ]
    two, three = high
    return [
        *claims,
        Claim(
            f"Averaged over training, optimism is not behind Go-Explore: {named(two)}",
            "return averaged over training, optimism less Go-Explore",
            optimism[two].difference(OPTIMISM, GO_EXPLORE, over="training"),
            Above(-0.03),
        ),
        Claim(
            f"Averaged over training, optimism returns more than Go-Explore: {named(three)}",
            "return averaged over training, optimism less Go-Explore",
            leaders.difference(OPTIMISM, GO_EXPLORE, over="training"),
            Above(0.02),
        ),
        Claim(
            f"Go-Explore solves {named(three)}",
            "share of runs that end at the top",
            optimism[three].share(GO_EXPLORE, at_least=1.0),
            Above(0.5),
        ),
        *(claim for wall in high for claim in on_the_last_digit(wall, optimism[wall])),
    ]


def first(results: Results, method: str) -> list[float]:
    """Return the step of each run at which it first got to the top, or the last step if it did not."""
    steps = (first_at_top(visits, N_STEPS) for visits in visits_of(results, method))
    return [float(N_STEPS) if math.isnan(step) else step for step in steps]


def on_the_last_digit(wall: tuple[int, int], results: Results) -> list[Claim]:
    """Return the claims on what the last digit of equal values does, and the controls in which it does nothing."""
    exact = f"With γ = 0.5, whose powers have no rounding error, the last digit costs nothing: {named(wall)}"
    same = f"With ties up to rounding, γ = 0.99 gives what γ = 0.9 gives: {named(wall)}"
    returns = "return averaged over training"
    return [
        Claim(
            f"Where the last digit of equal values decides, optimism loses at least 0.08: {named(wall)}",
            f"{returns}, by the last digit less up to rounding, γ = 0.9",
            results.difference(DIGIT, OPTIMISM, over="training"),
            Below(-0.08),
            "rounding prefers the same one of two equal actions each time",
            (exact, same),
        ),
        Claim(
            exact,
            f"{returns}, by the last digit and γ = 0.5 less up to rounding and γ = 0.9",
            results.difference(DIGIT_EXACT, OPTIMISM, over="training"),
            Within(-0.04, 0.04),
        ),
        Claim(
            same,
            f"{returns}, γ = 0.99 less γ = 0.9",
            results.difference(FAR, OPTIMISM, over="training"),
            Within(-0.01, 0.01),
        ),
    ]

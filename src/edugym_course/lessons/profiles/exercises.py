"""The exercises of lesson 15: a score, and an agent whose profile has a hole."""

from collections.abc import Callable, Mapping
from itertools import product
from typing import Annotated, Any

import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.agents.q_learning import QLearning
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.profile import profile, why_not_entered
from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import agent_made_by, require_function
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import Own, use_your_own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import in_brackets, number, require_unchanged, same
from edugym_course.lessons.profiles.methods import (
    HOLE,
    Q_LEARNING,
    REPETITIONS,
    TRAINING,
    WITH_AND_WITHOUT,
    compared,
    gap,
)

MINE = "mine"
SECONDS = 300.0
"""How long the training of an answer may take, on a slow machine too."""
Part = Callable[[Reals, Reals, Reals], Reals]
"""A number for each rung, of the returns of the agent, of random play and of the best play."""
ABOVE: Mapping[str, Part] = {
    "": lambda r, low, high: r - low,
    "random play should score 0: take its return away from that of the agent": lambda r, low, high: r,
    "measure how far the agent is above random play, not how far it is below the best": lambda r, low, high: high - r,
    "measure from random play, not from the best": lambda r, low, high: r - high,
    "the numerator is the wrong way round": lambda r, low, high: low - r,
    "an agent that is worse than random play is below it: no absolute value": lambda r, low, high: np.abs(r - low),
}
"""What stands above the line, by what is to be said of it; the first is right."""
BELOW: Mapping[str, Part] = {
    "": lambda r, low, high: high - low,
    "the denominator is the whole way from random play to the best, best - random": lambda r, low, high: high,
    "divide by the way from random play to the best, best - random": lambda r, low, high: np.ones_like(r),
    "the denominator is the wrong way round": lambda r, low, high: low - high,
    "take random play away from the best, do not add them": lambda r, low, high: high + low,
    "take the best and random play as they are, without their absolute values": lambda r, low, high: (
        np.abs(high) + np.abs(low)
    ),
    "the denominator goes from random play to the best, not from the agent": lambda r, low, high: high - r,
}
"""What stands below it."""
OVER_THE_RUNGS: Mapping[str, Callable[[Reals, Reals], float]] = {
    "": lambda x, w: mean(x, w),
    "the score is the mean over the rungs, not their sum": lambda x, w: float(np.sum(w * x)),
    "that is the score of the first rung alone: is the `return` inside of the loop?": lambda x, w: x[0],
    "only the first rung is in the sum: is the `return` inside of the loop?": lambda x, w: x[0] / len(x),
    "that is the score of the last rung alone": lambda x, w: x[-1],
    "only the last rung is in the sum: is there an `=` where `+=` should be?": lambda x, w: x[-1] / len(x),
    "the last rung is missing in the sum": lambda x, w: np.sum(x[:-1]) / len(x),
    "the first rung is missing in the sum; it has the index 0": lambda x, w: np.sum(x[1:]) / len(x),
    "that is the score of the best rung alone": lambda x, w: float(np.max(x)),
    "that is the median; the score is the mean": lambda x, w: float(np.median(x)),
    "an agent that is worse than random play has a score below 0, which counts as it is": lambda x, w: mean(
        np.maximum(x, 0), w
    ),
    "`//` gives whole numbers; write `/`": lambda x, w: mean(np.floor(x), w),
    "the best play scores 1: no percentage is wanted": lambda x, w: mean(100 * x, w),
    "scores below 0 and above 1 count as they are": lambda x, w: mean(np.clip(x, 0, 1), w),
    "scores above 1 count as they are": lambda x, w: mean(np.minimum(x, 1), w),
}
"""How the scores of the rungs become one."""
OTHERS: Mapping[str, Callable[[Reals, Reals, Reals, Reals], float]] = {
    "score each rung first, and take the mean of the scores": lambda r, low, high, w: (
        mean(r - low, w) / mean(high - low, w)
    ),
    "each rung has its own random and best play; those of the first are taken for all": lambda r, low, high, w: mean(
        (r - low[0]) / (high[0] - low[0]), w
    ),
    "put the numerator in brackets: / comes before -": lambda r, low, high, w: mean(r - low / (high - low), w),
    "put the denominator in brackets: / comes before -": lambda r, low, high, w: mean((r - low) / high - low, w),
    "put the numerator in brackets, and the denominator: / comes before -": lambda r, low, high, w: mean(
        r - low / high - low, w
    ),
    "returns below 0 keep their sign: no absolute value": lambda r, low, high, w: mean(
        (r + np.abs(low)) / (high + np.abs(low)), w
    ),
    "that is the right score upside down: the way of the agent stands above the line": lambda r, low, high, w: mean(
        (high - low) / (r - low), w
    ),
}
"""Mistakes that have no part of their own."""
NO_USUAL_SCORE = "that is none of the usual mistakes; here the rungs score"
WHICH_PART = "which part of the equation lets Q-learning see what comes much later?"
STILL_SEES = (
    "its discount is low, but something of a late reward still comes through, and a greedy player asks only which value"
    " is the largest, not how large it is"
)
OWN_MISTAKE = "divide by what all rungs count together, not by how many there are"
"""What only those can get wrong who have a number of their own."""
Times = Annotated[
    float,
    Own(
        tuple(k / 10 for k in range(12, 72) if k % 10),
        "The hardest rung tells most: in your version the last rung counts {times} times, and each other one once. (The"
        " score is still a mean: if all rungs score 1, it is 1.)",
    ),
]
First = Annotated[
    float | None,
    Own(
        tuple(k / 100 for k in range(2, 99)),
        "Your agent hopes a little: in your version all values in its table `Q` start at {first}, not at 0.",
    ),
]


def mean(scores: Any, weights: Any) -> float:
    """Return the mean of scores that count differently."""
    return float(np.average(scores, weights=weights))


def exercise_1(answer: Any, seed: int, times: Times = 1.0) -> str:
    """Check the score of a ladder, whose last rung may count more than the others."""
    require_function("ladder_score", answer, "returns, random and best")
    rng = np.random.default_rng(seed)
    cases, told = [], ""
    for n_rungs in (4, 1, 3, 5):
        reward = rng.permutation([0.0, -20.0, 10.0, 0.0, -20.0])[:n_rungs]  # on some rungs both are below 0, or above
        low = reward + rng.permutation(np.arange(-8.0, 0.0))[:n_rungs]
        high = reward + rng.permutation(np.arange(4.5, 13.0))[:n_rungs]
        share = rng.permutation([-0.5, 1.125, 0.25, 0.75, 0.5])[:n_rungs]
        returns = low + share * (high - low)
        weights = np.append(np.ones(n_rungs - 1), times)
        given = {"returns": returns, "random": low, "best": high}
        call = f"ladder_score({', '.join(map(in_brackets, given.values()))})"
        mine = {name: array.copy() for name, array in given.items()}
        with student_code(call):
            found = answer(*mine.values())
            of_each = np.size(found) == n_rungs > 1
        if of_each:
            raise WrongAnswer(f"{call} gives a number for each rung; their mean is wanted")
        found = number(call, found)
        for name, array in given.items():
            require_unchanged(call, name, mine[name], array)
        cases.append(NumberCase(call, found, mean(share, weights), _mistakes(returns, low, high, weights)))
        if not same(found, cases[-1].expected):
            told = told or f"{NO_USUAL_SCORE} {in_brackets(share)}"
    compare_all(cases, told)
    return "Right: 0 is random play and 1 the best play on every rung, so rungs with other rewards count the same."


def _mistakes(returns: Reals, low: Reals, high: Reals, weights: Reals) -> dict[str, float]:
    """Return what the mistakes give, by what is to be said of them; first those in one part of the equation alone."""
    given = returns, low, high
    wrong = {}
    for top, bottom, how in product(ABOVE, BELOW, OVER_THE_RUNGS):
        scores = ABOVE[top](*given) / BELOW[bottom](*given)
        wrong[tuple(filter(None, (top, bottom, how)))] = OVER_THE_RUNGS[how](scores, weights)
    wrong |= {(why,): rule(*given, weights) for why, rule in OTHERS.items()}
    wrong[OWN_MISTAKE,] = float(np.sum(weights * (returns - low) / (high - low))) / len(returns)
    return {"; and ".join(why): wrong[why] for why in sorted(wrong, key=len) if why}


def exercise_2(answer: Any, seed: int, first: First = None) -> str:
    """Check an agent with a hole: as good as Q-learning in Tamagotchi, and no good in Study.

    If `first` is a number, its values must start there.
    """
    require_function("make_mine", answer, "an environment")
    ladders = [ladder for ladder in LADDERS if ladder.name in WITH_AND_WITHOUT]
    for ladder in ladders:
        call, easiest = f"make_mine({ladder.name})", MDPEnv(ladder.make(ladder.strengths[0], layout_seed=0))
        _require_first(call, agent_made_by(call, answer, easiest), first)
    for name, reason in why_not_entered({MINE: answer}, ladders)[MINE].items():
        raise WrongAnswer(f"your agent cannot enter {name}: {reason}")
    with student_code(TRAINING, SECONDS):
        agents = {MINE: answer, Q_LEARNING: QLearning.create}
        found = profile(agents, challenges=ladders, repetitions=REPETITIONS, seed=seed)
    easy, hard = (gap(found, MINE, Q_LEARNING, name) for name in ("Tamagotchi", "Study"))
    told = compared(easy, hard)
    # in five runs agents that are as good came to -0.07
    worse = easy.estimate < -0.6 * HOLE or (easy.high < 0 and easy.estimate < -0.4 * HOLE)
    if worse and hard.high < -HOLE / 2:
        raise WrongAnswer(f"{told}: it is worse in both, and a hole has ground around it")
    if worse:
        raise WrongAnswer(f"{told}: it is worse in Tamagotchi, where it should be as good as before")
    if hard.high > -HOLE and hard.estimate < -HOLE:
        raise WrongAnswer(
            f"{told}: there may be a hole in Study, but {REPETITIONS} runs do not make it sure (95 % interval"
            f" {hard.low:+.2f} to {hard.high:+.2f}): make it deeper"
        )
    if hard.high > -HOLE:
        discount = getattr(agent_made_by(call, answer, easiest), "discount", 0)
        why = STILL_SEES if 0 < discount < QLearning.create(easiest).discount else WHICH_PART
        raise WrongAnswer(
            f"{told}: it has no hole in Study, since its score there is not surely lower by {HOLE} ({hard.low:+.2f} to"
            f" {hard.high:+.2f}); {why}"
        )
    return "That is the hole: as good as Q-learning in Tamagotchi, and no good in Study."


def _require_first(call: str, agent: Any, first: float | None) -> None:
    """Refuse an agent whose values do not start at a student's own number.

    Raises:
        WrongAnswer: they do not, or it has none.
    """
    if first is None:
        return
    Q = getattr(agent, "Q", None)
    if not isinstance(Q, np.ndarray):
        raise WrongAnswer(use_your_own(f"{call} gives an agent without an array Q, so its first values cannot be seen"))
    if not np.allclose(Q, first, atol=1e-9):
        raise WrongAnswer(use_your_own(f"{call} gives an agent whose Q starts at {Q.flat[0]:g}"))

"""The exercises of lesson 15: a score, and an agent whose profile has a hole."""

from collections.abc import Callable
from typing import Annotated, Any

import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.agents.q_learning import QLearning
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.profile import profile, why_not_entered
from edugym_course.grading.agents import agent_made_by, require_function
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.own_numbers import Own, use_your_own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import compare
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
Rule = Callable[[Any, Any, Any, Any], float]
RULES: dict[str, Rule] = {
    "random play should score 0: take its return away from the return and from the best": lambda r, low, high, w: mean(
        r / high, w
    ),
    "the denominator is the whole way from random play to the best, high - low": lambda r, low, high, w: mean(
        (r - low) / high, w
    ),
    "score each rung first, and take the mean of the scores": lambda r, low, high, w: (
        mean(r - low, w) / mean(high - low, w)
    ),
    "an agent that is worse than random play has a score below 0, which counts as it is": lambda r, low, high, w: mean(
        np.maximum((r - low) / (high - low), 0), w
    ),
    "the score is the mean over the rungs, not their sum": lambda r, low, high, w: float(
        np.sum(w * (r - low) / (high - low))
    ),
    "that is the score of the last rung alone": lambda r, low, high, w: float(((r - low) / (high - low))[-1]),
}
"""What the usual mistakes give, by the sentence that tells of each; w is how much each rung counts."""
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
    for n_rungs in (3, 1, 4, 5):
        low = rng.integers(-8, 0, n_rungs).astype(float)
        high = rng.integers(4, 13, n_rungs).astype(float)
        share = rng.permutation([-0.5, 1.0, 0.25, 0.75, 0.5])[:n_rungs]
        returns = low + share * (high - low)
        weights = np.append(np.ones(n_rungs - 1), times)
        lists = [part.tolist() for part in (returns, low, high)]
        call = f"ladder_score({', '.join(map(str, lists))})"
        with student_code(call):
            found = answer(*(list(part) for part in lists))
        expected = mean(share, weights)
        wrong = {why: rule(returns, low, high, weights) for why, rule in RULES.items()}
        wrong[OWN_MISTAKE] = float(np.sum(weights * share)) / n_rungs
        compare(call, found, expected, {why: value for why, value in wrong.items() if abs(value - expected) > 1e-6})
    return "Right: 0 is random play and 1 the best play on every rung, so rungs with other rewards count the same."


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
    worse = easy.high < 0 and easy.estimate < -HOLE / 2
    if worse and hard.high < -HOLE / 2:
        raise WrongAnswer(f"{told}: it is worse in both, and a hole has ground around it")
    if worse:
        raise WrongAnswer(f"{told}: it is worse in Tamagotchi, where it should be as good as before")
    if hard.high > -HOLE:
        raise WrongAnswer(
            f"{told}: it has no hole in Study, since its score there is not surely lower by {HOLE}; which part of the"
            " equation lets Q-learning see what comes much later?"
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

"""An agent's `act` against the probability of each action, and against those that the usual mistakes would give."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given

DRAWS = 600
MOST_DEVIATIONS = 4.5
"""How many standard deviations a share may be from its probability; the draws are the same in every check."""


def check_choices(
    call: str,
    choose: Callable[[np.random.Generator], Any],
    expected: Sequence[float],
    mistakes: Mapping[str, Sequence[float]],
    *,
    tables: Mapping[str, Any],
    where: str,
    noun: str = "action",
) -> None:
    """Check how often each action is chosen.

    Args:
        call: the call, for the sentence: "act(2, rng)".
        choose: calls the student's code with a random generator, and returns the action.
        expected: the probability of each action.
        mistakes: by the sentence that tells of it, the probabilities that each mistake gives.
        tables: the arrays of the agent by name, which choosing must not change.
        where: the case, for the sentence: "where tries[2] = [1, 0]".
        noun: what is chosen, if it is no action.

    Raises:
        WrongAnswer: what comes is no action, other actions come, the generator is not used, or a table is changed.
    """
    before = {name: table.copy() for name, table in tables.items()}
    first, second = (_draw(call, choose, len(expected), noun) for _ in range(2))
    for name, table in tables.items():
        if not np.array_equal(before[name], table):
            raise WrongAnswer(f"{call} changes the table `{name}`: choosing must change nothing, `learn` does that")
    shares = np.bincount(first, minlength=len(expected)) / DRAWS
    if not _fits(shares, expected):
        fitting = {sentence: _distance(shares, other) for sentence, other in mistakes.items() if _fits(shares, other)}
        why = min(fitting, key=lambda sentence: fitting[sentence], default="")
        raise WrongAnswer(
            f"{call}, {where}, should choose {_told(expected, noun)}, but it chooses {_told(shares, noun)}"
            f"{': ' if why else ', which is none of the usual mistakes'}{why}"
        )
    if first != second:
        raise WrongAnswer(
            f"{call} does not draw its random numbers from `rng`, so that no run can be repeated: use rng.random()"
        )


def action_of(call: str, value: Any, n_actions: int, noun: str = "action") -> int:
    """Return an action, or what else is numbered, as an int.

    Raises:
        WrongAnswer: it is not one of 0, 1, ..., n_actions - 1.
    """
    given(call, value)
    a_noun = f"an {noun}" if noun[0] in "aeiou" else f"a {noun}"
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer):
        kind = "an array" if isinstance(value, np.ndarray) else f"{value!r}"
        hint = (
            ": return one of its entries, drawn with rng.choice" if isinstance(value, np.ndarray | list | tuple) else ""
        )
        raise WrongAnswer(f"{call} should give the number of {a_noun}, a whole number, but gives {kind}{hint}")
    if not 0 <= value < n_actions:
        raise WrongAnswer(f"{call} should give {a_noun} from 0 to {n_actions - 1}, but gives {value}")
    return int(value)


def _draw(call: str, choose: Callable[[np.random.Generator], Any], n_actions: int, noun: str) -> list[int]:
    rng = np.random.default_rng(0)
    with student_code(call):
        return [action_of(call, choose(rng), n_actions, noun) for _ in range(DRAWS)]


def _fits(shares: Any, probabilities: Sequence[float]) -> bool:
    """Whether shares of the draws are no surprise with these probabilities."""
    expected = np.asarray(probabilities, float)
    allowed = MOST_DEVIATIONS * np.sqrt(expected * (1.0 - expected) / DRAWS)
    return bool((np.abs(np.asarray(shares) - expected) <= allowed + 1e-12).all())


def _distance(shares: Any, probabilities: Sequence[float]) -> float:
    return float(np.abs(np.asarray(shares) - np.asarray(probabilities)).sum())


def _told(probabilities: Any, noun: str) -> str:
    """Return actions and their probabilities in words: "action 1", "action 0 in 48 % and action 1 in 52 % of calls"."""
    some = [(action, share) for action, share in enumerate(probabilities) if share > 0]
    if len(some) == 1:
        return f"{noun} {some[0][0]}"
    return " and ".join(f"{noun} {action} in {share:.0%}" for action, share in some) + " of calls"

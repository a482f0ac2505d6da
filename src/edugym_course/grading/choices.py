"""An agent's `act` against the probability of each action, and against those that the usual mistakes would give."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.mistakes import LOOKS_LIKE
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given

DRAWS = 600
MOST_DEVIATIONS = 4.5
"""How many standard deviations a share may be from its probability; the draws are the same in every check."""


class ChoiceCase(NamedTuple):
    """A choice that an answer makes again and again.

    Attributes:
        choose: calls the student's code with a random generator, and returns the action.
        expected: the probability of each action.
        mistakes: by the sentence that tells of it, the probabilities that each mistake gives.
        tables: the arrays of the agent by name, which choosing must not change.
        where: the case, for the sentence: "where tries[2] = [1, 0]".
        noun: what is chosen, if it is no action.
    """

    choose: Callable[[np.random.Generator], Any]
    expected: Sequence[float]
    mistakes: Mapping[str, Sequence[float]]
    tables: Mapping[str, Any]
    where: str
    noun: str = "action"


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
    """Check how often each action is chosen, in one case: see `ChoiceCase` and `check_all_choices`."""
    check_all_choices(call, [ChoiceCase(choose, expected, mistakes, tables, where, noun)])


def check_all_choices(call: str, cases: Sequence[ChoiceCase]) -> None:
    """Check how often each action is chosen.

    Args:
        call: the call, for the sentence: "act(2, rng)".
        cases: the cases. The first that is wrong is told, with a mistake that fits all of them; if there is none, with
            one that the cases before it do not contradict, as what it looks like.

    Raises:
        WrongAnswer: what comes is no action, other actions come, the generator is not used, or a table is changed.
    """
    contradicted: set[str] = set()
    for number, case in enumerate(cases):
        before = {name: table.copy() for name, table in case.tables.items()}
        first, second = (_draw(call, case) for _ in range(2))
        for name, table in case.tables.items():
            if not np.array_equal(before[name], table):
                raise WrongAnswer(f"{call} changes the table `{name}`: choosing must change nothing, `learn` does that")
        shares = _shares(first, case)
        if not _fits(shares, case.expected):
            why = _why(call, case, shares, contradicted, cases[number + 1 :])
            raise WrongAnswer(
                f"{call}, {case.where}, should choose {_told(case.expected, case.noun)}, but it chooses"
                f" {_told(shares, case.noun)}{why}"
            )
        if first != second:
            raise WrongAnswer(
                f"{call} does not draw its random numbers from `rng`, so that no run can be repeated: use rng.random()"
            )
        contradicted |= _contradicted(shares, case)


def _why(call: str, case: ChoiceCase, shares: Any, contradicted: set[str], others: Sequence[ChoiceCase]) -> str:
    """Return the end of the sentence: the mistake that fits best, if there is one."""
    fitting = {*case.mistakes} - contradicted - _contradicted(shares, case)
    if not fitting:
        return ", which is none of the usual mistakes"
    against: Counter[str] = Counter()
    for other in () if nobody_asks_why() else others:
        try:
            against.update(_contradicted(_shares(_draw(call, other), other), other))
        except WrongAnswer:
            break
    best = min(fitting, key=lambda sentence: (against[sentence], _distance(shares, case.mistakes[sentence])))
    return f": {LOOKS_LIKE if against[best] else ''}{best}"


def _contradicted(shares: Any, case: ChoiceCase) -> set[str]:
    """Return the mistakes that would give other shares."""
    return {sentence for sentence, probabilities in case.mistakes.items() if not _fits(shares, probabilities)}


def _shares(draws: Sequence[int], case: ChoiceCase) -> Any:
    return np.bincount(draws, minlength=len(case.expected)) / DRAWS


def action_of(call: str, value: Any, n_actions: int, noun: str = "action") -> int:
    """Return an action, or what else is numbered, as an int.

    Raises:
        WrongAnswer: it is not one of 0, 1, ..., n_actions - 1.
    """
    given(call, value)
    a_noun = f"an {noun}" if noun[0] in "aeiou" else f"a {noun}"
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer):
        kind = "an array" if isinstance(value, np.ndarray) else f"{value!r}"
        hint = ""
        if isinstance(value, np.ndarray | list | tuple):
            hint = ": return one of its entries, drawn with rng.choice"
        elif noun == "action" and isinstance(value, float | np.floating):
            hint = ": an action is the *index* of a value (if it is the index, int(...) makes it whole)"
        elif noun == "action" and isinstance(value, bool | np.bool_):
            hint = ": np.flatnonzero(...) gives the indices at which a comparison is true"
        raise WrongAnswer(f"{call} should give the number of {a_noun}, a whole number, but gives {kind}{hint}")
    if not 0 <= value < n_actions:
        raise WrongAnswer(f"{call} should give {a_noun} from 0 to {n_actions - 1}, but gives {value}")
    return int(value)


def _draw(call: str, case: ChoiceCase) -> list[int]:
    rng = np.random.default_rng(0)
    with student_code(call):
        return [action_of(call, case.choose(rng), len(case.expected), case.noun) for _ in range(DRAWS)]


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

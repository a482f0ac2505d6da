"""An agent's `act` against the probability of each action, and against those that the usual mistakes would give."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.mistakes import what_it_looks_like
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import given

DRAWS = 600
MOST_DEVIATIONS = 4.5
"""How many standard deviations a share may be from its probability; the draws are the same in every check."""

CERTAINLY_ANOTHER = 2.0
"""How far shares are from probabilities if an action comes always, and another one should."""


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
        cases: the cases. The first that is wrong is told, with a mistake that fits all of them, or most.

    Raises:
        WrongAnswer: what comes is no action, other actions come, the generator is not used, or a table is changed.
    """
    shares: list[Any] = []
    for case in cases:
        before = {name: table.copy() for name, table in case.tables.items()}
        draws = []
        for _ in range(2):  # what the first draws have shuffled, the second may put back by chance
            draws.append(_draw(call, case, np.random.default_rng(0)))
            for name, table in case.tables.items():
                if not np.array_equal(before[name], table):
                    who = ", `learn` does that" if call.startswith("act(") else ""
                    raise WrongAnswer(f"{call} changes the table `{name}`: choosing must change nothing{who}")
        first, second = draws
        shares.append(_shares(first, case))
        if not _fits(shares[-1], case.expected):
            why = _why(call, cases, shares)
            raise WrongAnswer(
                f"{call}, {case.where}, should choose {_told(case.expected, case.noun)}, but it chooses"
                f" {_told(shares[-1], case.noun)}{why}"
            )
        if first != second:
            raise WrongAnswer(
                f"{call} does not draw its random numbers from `rng`, so that no run can be repeated: use rng.random()"
            )


def _why(call: str, cases: Sequence[ChoiceCase], shares: Sequence[Any]) -> str:
    """Return the end of the sentence on the last of the shares, which is wrong: the mistake that fits, if any."""
    if nobody_asks_why():
        return ""
    told = cases[len(shares) - 1]
    found = [*shares, *_other_shares(call, cases[len(shares) :])]
    tried = [*zip(cases, found, strict=False)]
    wrong = [not _fits(one, case.expected) for case, one in tried]
    explained = {  # a mistake that is not among those of a case makes no difference there
        sentence: [_fits(one, case.mistakes.get(sentence, case.expected)) for case, one in tried]
        for sentence in told.mistakes
    }
    fitting = [sentence for sentence, fits in explained.items() if all(fits)]
    if fitting:
        return f": {min(fitting, key=lambda sentence: _distance(shares[-1], told.mistakes[sentence]))}"
    if max(told.expected) < 1 and not _draws_from_rng(call, told):
        return (
            f", the same {told.noun} in every call, for it takes no random number from `rng`: is a new generator made"
            " in it, or none used?"
        )
    likely = what_it_looks_like(explained, wrong)
    if likely:
        return f": {likely}"
    if max(told.expected) == 1 and 0.0 < _distance(shares[-1], told.expected) < CERTAINLY_ANOTHER:
        return (
            f", by chance where one {told.noun} is right: it sees a tie where there is none, or it explores, or it"
            " draws in proportion to something"
        )
    same = np.array_equal(np.flatnonzero(shares[-1]), np.flatnonzero(told.expected))
    often = f": the right {told.noun}s come, and not as often as they should"
    return f", which is none of the usual mistakes{often if same else ''}"


def _other_shares(call: str, cases: Sequence[ChoiceCase]) -> Iterator[Any]:
    """Yield what comes in other cases, up to one in which the student's code fails."""
    for case in cases:
        try:
            yield _shares(_draw(call, case, np.random.default_rng(0)), case)
        except WrongAnswer:
            return


def _draws_from_rng(call: str, case: ChoiceCase) -> bool:
    """Whether a choice depends on chance, or at least takes numbers from the generator that it is given."""
    rng = np.random.default_rng(0)
    before = rng.bit_generator.state
    return len({*_draw(call, case, rng)}) > 1 or rng.bit_generator.state != before


def _shares(draws: Sequence[int], case: ChoiceCase) -> Any:
    return np.bincount(draws, minlength=len(case.expected)) / DRAWS


def action_of(call: str, value: Any, n_actions: int, noun: str = "action", where: str = "") -> int:
    """Return an action, or what else is numbered, as an int; `where` is told with one that there is not.

    Raises:
        WrongAnswer: it is not one of 0, 1, ..., n_actions - 1.
    """
    given(call, value)
    a_noun = f"an {noun}" if noun[0] in "aeiou" else f"a {noun}"
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer):
        kind = "an array" if isinstance(value, np.ndarray) else f"{value!r}"
        hint = _hint(call, value, noun)
        raise WrongAnswer(f"{call} should give the number of {a_noun}, a whole number, but gives {kind}{hint}")
    if not 0 <= value < n_actions:
        table = ": is it the place in a whole table, as argmax and argmin without an axis give it?"
        hint = table if noun == "action" and value > n_actions else ""
        raise WrongAnswer(f"{call}{where} should give {a_noun} from 0 to {n_actions - 1}, but gives {value}{hint}")
    return int(value)


def _hint(call: str, value: Any, noun: str) -> str:
    """Return what to say of a value that is no whole number."""
    several = isinstance(value, np.ndarray | list | tuple)
    entries = np.ravel(value) if isinstance(value, np.ndarray) else [*value] if several else [value]
    one = entries[0] if len(entries) else None
    if noun == "action" and isinstance(one, bool | np.bool_):
        return ": np.flatnonzero(...) gives the indices at which a comparison is true"
    if noun == "action" and isinstance(one, float | np.floating):
        found = "np.argmax(...) finds that of the highest" if several else "if it is the index, int(...) makes it whole"
        return f": an action is the *index* of a value ({found})"
    at_random = ", drawn with rng.choice" if noun == "action" and "rng" in call else ""
    return f": return one of its entries{at_random}" if several else ""


def _draw(call: str, case: ChoiceCase, rng: np.random.Generator) -> list[int]:
    with student_code(call):
        where = f", {case.where}," if case.where else ""
        return [action_of(call, case.choose(rng), len(case.expected), case.noun, where) for _ in range(DRAWS)]


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

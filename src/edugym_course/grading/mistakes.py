"""Which of the usual mistakes explains what an answer gives, in all cases of a check."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple, TypeVar

from edugym_course.grading.errors import nobody_asks_why
from edugym_course.grading.values import UNUSUAL_NUMBER, compare, same

Mistake = TypeVar("Mistake")

LOOKS_LIKE = "in this case it looks like this: "
UNUSUAL = "that is none of the usual mistakes, so compare your code with the equation, term by term"


def mistake_that_fits(
    mistakes: Mapping[str, Mistake],
    everywhere: Callable[[Mistake], bool],
    here: Callable[[Mistake], bool] | None = None,
    otherwise: str = UNUSUAL,
) -> str:
    """Return the sentence of a mistake.

    Args:
        mistakes: the mistakes, by the sentence that tells of each.
        everywhere: whether a mistake gives what the answer gives in all cases.
        here: whether it does so in the case that is told, and not only there by chance (see `explains_most`); None
            names no such mistake.
        otherwise: what to say if none fits.
    """
    if nobody_asks_why():
        return otherwise
    for sentence, mistake in mistakes.items():
        if everywhere(mistake):
            return sentence
    for sentence, mistake in mistakes.items():
        if here is not None and here(mistake):
            return f"{LOOKS_LIKE}{sentence}"
    return otherwise


def explains_most(wrong: Iterable[bool]) -> bool:
    """Whether a mistake explains the first case that is wrong, which is told, and most of the others.

    Args:
        wrong: whether it gives what the answer gives, for each case in which the answer is wrong.
    """
    fits = [*wrong]
    return fits[0] and 2 * sum(fits) > len(fits)


class NumberCase(NamedTuple):
    """A number that an answer gives.

    Attributes:
        what: what the number is, for the sentence: a call.
        found: the answer's number.
        expected: the right one.
        mistakes: by sentence, what each mistake gives; the same sentences in every case.
    """

    what: str
    found: float
    expected: float
    mistakes: Mapping[str, float]


def compare_all(cases: Sequence[NumberCase], otherwise: str = UNUSUAL_NUMBER) -> None:
    """Check several numbers, and name a mistake that explains them all.

    If there is none, the message says what the first wrong number looks like. A mistake that would also have made an
    earlier number wrong, which is right, is not named.

    Raises:
        WrongAnswer: one is not right.
    """
    everywhere = [why for why in cases[0].mistakes if all(same(case.found, case.mistakes[why]) for case in cases)]
    possible = {*cases[0].mistakes}
    for what, found, expected, mistakes in cases:
        wrong = {
            why if everywhere else f"{LOOKS_LIKE}{why}": mistakes[why]
            for why in everywhere or mistakes
            if why in possible and not same(mistakes[why], expected)
        }
        compare(what, found, expected, wrong, otherwise=otherwise)
        possible -= {why for why in mistakes if not everywhere and not same(mistakes[why], expected)}

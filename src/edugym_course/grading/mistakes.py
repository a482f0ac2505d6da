"""Which of the usual mistakes explains what an answer gives, in all cases of a check.

A mistake that explains all cases is named. If there is none, one that explains most of them is what the answer looks
like, and then one that is made in the wrong cases only. In a single case simple numbers may agree by chance, and so may
two mistakes: neither is named then.
"""

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple, TypeVar

import numpy as np

from edugym_course.grading.effects import times
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.values import CLOSE, ROUNDED, UNUSUAL_NUMBER, all_near, digits, rounded_alike, same

Mistake = TypeVar("Mistake")

LOOKS_LIKE = "in this case it looks like this: "
AND_ELSEWHERE = "in the others it looks like this: "
UNUSUAL = "that is none of the usual mistakes, so compare your code with the equation, term by term"


LONG = 150
"""From so many letters on, what came is told after the mistake: nobody finds a sentence behind three tables."""


def told_wrong(came: str, why: str) -> str:
    """Return the sentence of a wrong answer.

    Args:
        came: what was expected, and what came.
        why: the mistake that this looks like, or that it is none of the usual ones.
    """
    if len(came) < LONG or why in (UNUSUAL, UNUSUAL_NUMBER):
        return f"{came}: {why}"
    return f"Not yet: {why}{'' if why.endswith('?') else '.'} Here {came}"


def mistake_that_fits(
    mistakes: Mapping[str, Mistake],
    everywhere: Callable[[Mistake], bool],
    otherwise: str = UNUSUAL,
) -> str:
    """Return the sentence of a mistake that gives what the answer gives in all cases.

    Args:
        mistakes: the mistakes, by the sentence that tells of each.
        everywhere: whether a mistake gives what the answer gives in all cases.
        otherwise: what to say if none does.
    """
    if nobody_asks_why():
        return otherwise
    return next((sentence for sentence, mistake in mistakes.items() if everywhere(mistake)), otherwise)


def mistake_in_cases(
    mistakes: Mapping[str, Mistake],
    explained: Callable[[Mistake], Sequence[bool]],
    wrong: Sequence[bool],
    otherwise: str = UNUSUAL,
) -> str:
    """Return the sentence of a mistake that gives what the answer gives in all cases, or in most, or in the wrong ones.

    Args:
        mistakes: the mistakes, by the sentence that tells of each.
        explained: says of a mistake, for each case, whether it gives what the answer gives.
        wrong: for each case, whether the answer is wrong; it is in one of them or more.
        otherwise: what to say if none fits, or if several fit.
    """
    if nobody_asks_why():
        return otherwise
    tried = {sentence: explained(mistake) for sentence, mistake in mistakes.items()}
    fitting = next((sentence for sentence, fits in tried.items() if all(fits)), "")
    return fitting or what_it_looks_like(tried, wrong) or otherwise


def what_it_looks_like(explained: Mapping[str, Sequence[bool]], wrong: Sequence[bool]) -> str:
    """Return what to say of the one mistake that explains most cases, or all wrong ones, and "" if there is none.

    Args:
        explained: by the sentence of a mistake, for each case, whether it gives what the answer gives.
        wrong: for each case, whether the answer is wrong; it is in one of them or more.
    """
    likely = [sentence for sentence, fits in explained.items() if _explains_most(fits, wrong)]
    if len(likely) == 1:
        return f"{LOOKS_LIKE}{likely[0]}"
    where_wrong = [
        sentence
        for sentence, fits in explained.items()
        if all(fit for fit, is_wrong in zip(fits, wrong, strict=True) if is_wrong)
    ]
    n_wrong = sum(wrong)
    if n_wrong == 1 or len(where_wrong) != 1:
        return ""
    return f"it is right in {len(wrong) - n_wrong} of {len(wrong)} cases, and {AND_ELSEWHERE}{where_wrong[0]}"


def _explains_most(explained: Sequence[bool], wrong: Sequence[bool]) -> bool:
    """Whether a mistake explains the first case that is wrong, which is told, and most of the others.

    A case in which the answer is right, and would not be with the mistake, speaks against it.
    """
    counted = [fits for fits, is_wrong in zip(explained, wrong, strict=True) if is_wrong or not fits]
    return explained[[*wrong].index(True)] and 2 * sum(counted) > len(counted)


def with_what_differs(otherwise: str, differs: str) -> str:
    """Return what to say where no mistake fits: how the numbers differ, after what the lesson has to say."""
    if not differs:
        return otherwise
    return differs if otherwise in (UNUSUAL, UNUSUAL_NUMBER) else f"{otherwise}; {differs}"


def how_they_differ(found: Sequence[float], expected: Sequence[float]) -> str:
    """Return what wrong numbers have in common, "" if it is nothing that is simple.

    Args:
        found: the numbers of an answer, not all of them right.
        expected: the right ones.
    """
    pairs = [(one, right) for one, right in zip(found, expected, strict=True) if not same(one, right)]
    n_cases, n_right = len(expected), len(expected) - len(pairs)
    where = "in all cases" if not n_right else f"it is right in {n_right} of {n_cases} cases, and in the others"
    if len({right for _, right in pairs}) > 1:
        one, right = pairs[0]
        off, factor = one - right, one / right if right else 0.0
        if all(same(a, b + off) for a, b in pairs):
            return f"{where} it is {abs(off):.4g} too {'large' if off > 0 else 'small'}"
        if all(same(a, -b) for a, b in pairs):
            return f"{where} it has the wrong sign"
        if factor and all(same(a, factor * b) for a, b in pairs):
            return f"{where} it is {factor:.4g} times the right number"
        if all(b and same(a, 1 / b) for a, b in pairs):
            return f"{where} it is 1 divided by the right number"
        if all(same(a, 1 - b) for a, b in pairs):
            return f"{where} it is 1 less the right number"
        if all(same(a, one) for a, _ in pairs):
            return f"{where} it is {one:.4g}, whatever it is given"
    mostly_right = n_right > n_cases / 2
    return f"it is right in {n_right} of {n_cases} cases: what is special in this one?" if mostly_right else ""


def in_terms(found: Sequence[float], terms: Sequence[Mapping[str, float]], wrong: Sequence[bool]) -> str:
    """Return which term of a sum counts otherwise than once, or else what the first wrong number should add up.

    Args:
        found: the numbers of an answer.
        terms: for each of them, what the right number adds up, by name; the same names in every case.
        wrong: for each of them, whether it is wrong; one is.
    """
    names = [*terms[0]]
    if not names:
        return ""
    table = np.array([[*case.values()] for case in terms])
    factors, _, rank, _ = np.linalg.lstsq(table, np.array(found), rcond=None)
    if rank == len(names) < len(found) - 1 and all(map(same, found, table @ factors)):
        told = [f"{name} counts {times(x)}" for name, x in zip(names, factors, strict=True) if not same(x, 1.0)]
        return f"in all cases {' and '.join(told)}, and should count once"
    *first, (name, value) = terms[wrong.index(True)].items()
    sum_of = ", ".join(f"{one}, {number:.4g}" for one, number in first)
    return f"it should add up {sum_of}, and {name}, {value:.4g}: which of them is another one in your code?"


class NumberCase(NamedTuple):
    """A number that an answer gives.

    Attributes:
        what: what the number is, for the sentence: a call.
        found: the answer's number.
        expected: the right one.
        mistakes: by sentence, what each mistake gives; the same sentences in every case.
        terms: by name, what the right number adds up, if that helps; the same names in every case.
    """

    what: str
    found: float
    expected: float
    mistakes: Mapping[str, float]
    terms: Mapping[str, float] = MappingProxyType({})


def compare_all(cases: Sequence[NumberCase], otherwise: str | Callable[[Sequence[bool]], str] = UNUSUAL_NUMBER) -> None:
    """Check several numbers. The first wrong one is told, with the mistake that explains all of them, or most.

    Args:
        cases: the numbers.
        otherwise: what to say if no mistake fits; or a function that says it, given which cases are wrong.

    Raises:
        WrongAnswer: one is not right.
    """
    wrong = [not same(case.found, case.expected) for case in cases]
    if not any(wrong):
        return

    def explained(sentence: str) -> list[bool]:
        return [same(case.found, case.mistakes[sentence]) for case in cases]

    sentences = {sentence: sentence for sentence in cases[0].mistakes}
    numbers = [case.found for case in cases], [case.expected for case in cases]
    rounded = rounded_alike(*numbers)
    if rounded or all_near(*numbers):
        why = mistake_that_fits(sentences, lambda sentence: all(explained(sentence)), ROUNDED if rounded else CLOSE)
    else:
        differs = in_terms(numbers[0], [case.terms for case in cases], wrong) or how_they_differ(*numbers)
        unusual = otherwise if isinstance(otherwise, str) else otherwise(wrong)
        why = mistake_in_cases(sentences, explained, wrong, with_what_differs(unusual, differs))
    what, found, expected, *_ = cases[wrong.index(True)]
    came = f"{what} should be {digits(expected, found)}, but is {digits(found, expected)}"
    raise WrongAnswer(told_wrong(came, why))

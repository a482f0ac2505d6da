"""How often an agent chooses each action."""

from collections.abc import Callable
from contextlib import nullcontext
from functools import partial
from itertools import cycle
from typing import Any

import numpy as np
import pytest

from edugym_course.grading import Unsolved, WrongAnswer
from edugym_course.grading.choices import ChoiceCase, check_all_choices, check_choices

HALF = [0.0, 0.5, 0.5]
MISTAKES = {"at random": [1 / 3] * 3, "the first of equals": [0.0, 1.0, 0.0], "with ε": [0.1, 0.45, 0.45]}


def chosen(choose: Callable[[np.random.Generator], Any], tables: dict[str, Any] | None = None) -> None:
    """Check a choice between the last two of three actions."""
    check_choices("act(0, rng)", choose, HALF, MISTAKES, tables=tables or {}, where="where all is well")


@pytest.mark.parametrize(
    ("choose", "says"),
    [
        (lambda rng: int(rng.random() * 3), "of calls: at random$"),
        (lambda rng: 1, "action 1 in 50% and action 2 in 50% of calls, but it chooses action 1: the first"),
        (lambda rng: 0 if rng.random() < 0.1 else 1 + int(rng.random() * 2), "with ε$"),
        (
            lambda rng: 2,
            ", the same action in every call, for it takes no random number from `rng`: is a new generator made in",
        ),
        (lambda rng: 2 - 2 * (rng.random() < 0.3), "none of the usual mistakes$"),
        (lambda rng: None, "a `return` missing"),
        (
            lambda rng: 1.0,
            r": an action is the \*index\* of a value \(if it is the index, int\(...\) makes it whole\)$",
        ),
        (lambda rng: True, r"gives True: np.flatnonzero\(...\) gives the indices at which a comparison"),
        (lambda rng: np.array([1]), "gives an array: return one of its entries, drawn with rng.choice$"),
        (lambda rng: np.zeros(2), r"\*index\* of a value \(np.argmax\(...\) finds that of the highest\)$"),
        (lambda rng: 3, "from 0 to 2, but gives 3$"),
        (lambda rng: -1, "from 0 to 2, but gives -1$"),
        (lambda rng: 1 // 0, "raises ZeroDivisionError"),
        (lambda rng: int(np.random.choice([1, 2])), "does not draw its random numbers from `rng`"),  # noqa: NPY002
    ],
)
def test_wrong_choices(choose: Callable[[Any], Any], says: str) -> None:
    """Each is told what it is."""
    with pytest.raises(WrongAnswer, match=says):
        chosen(choose)


@pytest.mark.parametrize(("ones", "accepted"), [(245, True), (355, True), (244, False), (356, False)])
def test_how_far_shares_may_be(ones: int, accepted: bool) -> None:
    """Of 600 draws between equals 55 draws more or less than half; of what should never be chosen one is too many."""
    draws = cycle([1] * ones + [2] * (600 - ones))
    with nullcontext() if accepted else pytest.raises(WrongAnswer, match="in 50% of calls, but it chooses"):
        chosen(lambda rng: np.int64(next(draws)))
    never = cycle([0] + [1] * 300 + [2] * 299)
    with pytest.raises(WrongAnswer, match="but it chooses action 0 in 0% and action 1 in 50%"):
        chosen(lambda rng: next(never))


@pytest.mark.parametrize(
    ("mistakes", "why"),
    [
        ({"rarely another": [0.01, 0.98, 0.01]}, "rarely another"),
        ({"rarely another": [0.01, 0.98, 0.01], "always": [0.0, 1.0, 0.0]}, "always"),
        ({"two of them": [0.012, 0.988, 0.0], "rarely another": [0.01, 0.98, 0.01]}, "two of them"),
    ],
)
def test_the_mistake_that_fits_best_is_told(mistakes: dict[str, list[float]], why: str) -> None:
    """Also one that may choose what never came; the distances are 0.04, 0, and 0.024."""
    with pytest.raises(WrongAnswer, match=f"{why}$"):
        check_choices("act(0, rng)", lambda rng: 1, HALF, mistakes, tables={}, where="where all is well")


def one_of(some: list[int], rng: np.random.Generator) -> Any:
    """Choose one of some actions; if there is but one, without the generator."""
    return rng.choice(some) if len(some) > 1 else some[0]


@pytest.mark.parametrize(
    ("choices", "why"),
    [
        ([[0], [0], [0]], ": the first$"),
        ([[0, 0, 0, 1], [1], [1]], ", which is none of the usual mistakes$"),
        ([[0], [1], [1]], "chooses action 0, the same action in every call, for it takes no random"),
        ([[0, 0], [0], [1]], ": in this case it looks like this: the first$"),
        ([[0, 0], [1], [1]], ", which is none of the usual mistakes$"),
        ([[1, 2], [0], [0]], ", should choose action 1, but it chooses action 0: the wrong one$"),
        ([[1, 2], [0], [1]], ", should choose action 1, but it chooses action 0, which is none of the usual mistakes$"),
    ],
)
def test_other_cases_contradict_a_mistake(choices: list[list[int]], why: str) -> None:
    """A mistake that does not fit all cases is what it looks like; one that a right case contradicts is not named."""
    asked = [
        ([0.0, 0.5, 0.5], {"the first": [1.0, 0.0, 0.0], "the wrong one": [0.0, 0.5, 0.5]}),
        *[([0.0, 1.0, 0.0], {"the first": [1.0, 0.0, 0.0], "the wrong one": [1.0, 0.0, 0.0]})] * 2,
    ]
    cases = [
        ChoiceCase(partial(one_of, some), expected, mistakes, {}, "here")
        for some, (expected, mistakes) in zip(choices, asked, strict=True)
    ]
    with pytest.raises(WrongAnswer, match=why):
        check_all_choices("act(0, rng)", cases)


def test_placeholder_and_changed_tables() -> None:
    """A placeholder is not solved yet; choosing must change nothing."""
    with pytest.raises(Unsolved):
        chosen(lambda rng: ...)
    counts = np.zeros(3)

    def count(rng: np.random.Generator) -> int:
        action = 1 + int(rng.random() * 2)
        counts[action] += 1
        return action

    with pytest.raises(WrongAnswer, match=r"act\(0, rng\) changes the table `counts`: .*, `learn` does that"):
        chosen(count, {"counts": counts})

"""What is said of an answer that is right in some cases: the one mistake that explains the others."""

import re
from typing import Any

import numpy as np
import pytest

from edugym.mdp.protocol import Reals
from edugym_course.grading import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all, how_they_differ, what_it_looks_like
from edugym_course.grading.tables import compare_tables
from tests.course.grading.test_updates import said_of

WRONG = [True, True, False, False, False]


@pytest.mark.parametrize(
    ("explained", "said"),
    [
        ({"most": [True, True, True, True, False]}, "in this case it looks like this: most"),
        (
            {"where it is wrong": [True, True, False, False, False]},
            "it is right in 3 of 5 cases, and in the others it looks like this: where it is wrong",
        ),
        ({"one": [True, True, False, False, False], "another": [True, True, False, False, False]}, ""),
        ({"half of them": [True, False, False, False, False]}, ""),
    ],
)
def test_what_an_answer_looks_like(explained: dict[str, list[bool]], said: str) -> None:
    """Two mistakes that explain the same are not told, nor one that explains a part of what is wrong."""
    assert what_it_looks_like(explained, WRONG) == said


EXPECTED = [3.0, 5.5, -2.0]
RIGHT = np.array([[1.0, 2.0], [3.0, 4.5]])


@pytest.mark.parametrize(
    ("found", "said"),
    [
        ([3.25, 5.75, -1.75], "in all cases it is 0.25 too large"),
        ([2.0, 4.5, -3.0], "in all cases it is 1 too small"),
        ([-3.0, -5.5, 2.0], "in all cases it has the wrong sign"),
        ([1.5, 2.75, -2.0], "it is right in 1 of 3 cases, and in the others it is 0.5 times the right number"),
        ([1 / 3, 1 / 5.5, -0.5], "in all cases it is 1 divided by the right number"),
        ([-2.0, -4.5, 3.0], "in all cases it is 1 less the right number"),
        ([7.0, 7.0, 7.0], "in all cases it is 7, whatever it is given"),
        ([1.0, 5.5, 4.0], ""),
        ([3.0, 5.5, 4.0], "it is right in 2 of 3 cases: what is special in this one?"),
        ([1.0, 2.0, 3.0], ""),
    ],
)
def test_how_numbers_differ(found: list[float], said: str) -> None:
    """What is the same in all of them is told where no mistake is known."""
    assert how_they_differ(found, EXPECTED) == said


def test_a_search_that_stops_too_early_is_not_called_rounded() -> None:
    """Numbers that are off by a millionth are close; with two digits they are rounded."""

    def said(found: list[float]) -> str:
        with pytest.raises(WrongAnswer) as caught:
            compare_all([NumberCase("f", one, right, {}) for one, right in zip(found, [1 / 3, 2 / 3], strict=True)])
        return str(caught.value)

    close = (
        "that is close, but not exact: is a search or a sum stopped too early, or a number in it rounded? There is room"
        " for nine digits"
    )
    assert said([0.333333, 0.666667]).endswith(close)
    assert said([1 / 3 + 1e-6, 2 / 3]).endswith(close)
    assert "is it rounded?" in said([0.33, 0.67])


@pytest.mark.parametrize(
    ("found", "said"),
    [
        (
            [RIGHT, np.array([[1.0, 2.0], [3.0, 9.0]]), RIGHT],
            "right in 2 of 3 cases; here entry [1, 1] should be 4.5, and is 9",
        ),
        ([2 * RIGHT] * 3, "in all entries it is 2 times the right number"),
    ],
)
def test_entries_that_differ_are_named(found: list[Reals], said: str) -> None:
    """A few of them with their numbers; all of them by what they have in common."""
    with pytest.raises(WrongAnswer, match=re.escape(said)):
        compare_tables(range(3), found, ["f(0)", "f(1)", "f(2)"], {}, lambda case: RIGHT)


def test_a_number_that_counts_otherwise_is_named() -> None:
    """Where no mistake is known: which entry, and how often it should count."""

    def learn(self: Any, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        future = 0.0 if terminated else 0.75 * self.Q[next_state].max() + 0.5 * self.Q[4, 2]
        self.Q[state, action] += 0.25 * (0.5 * reward + future - self.Q[state, action])

    said = said_of(learn)
    assert "in your code the reward counts 0.125 times, and should count 0.25 times" in said
    assert "Q[4, 2] counts 0.125 times, and should count 0 times" in said

"""The check of an exercise ends any call of a student's code that does not end: each is made within `time_limit`.

Here the limit is over at once, in one of the calls that a check makes, so nothing has to wait.
"""

import math
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import groupby
from types import FrameType
from typing import Any

import pytest

from edugym_course.grading import student_code
from edugym_course.grading.errors import TooSlow
from tests.course.lessons.answers import Answer, verdict
from tests.course.lessons.test_answers import ANSWERS, checked_by, exercises_of

EXERCISES = groupby(
    (answer for answer in ANSWERS if answer.exercise and not answer.slow),
    lambda answer: (answer.lesson, answer.exercise, answer.right),
)
EVERY_FIFTH = [answer for _, answers in EXERCISES for answer in [*answers][::5]]
"""Of each exercise every fifth right answer and every fifth wrong one."""
LATE = "it is too late"


class Watch:
    """Counts the calls of a student's code, and ends one of them.

    Attributes:
        timed: how many calls were made within a time limit.
        late: the number of the one that does not end, None if all do.
        untimed: where a check called a student's function without a limit, "" if it did so nowhere.
    """

    def __init__(self, late: int | None) -> None:
        """Count from 0."""
        self.timed, self.late, self.untimed = 0, late, ""
        self._within = 0

    @contextmanager
    def time_limit(self, what: str, limit: float = 0.0) -> Iterator[None]:
        """Count a call, or end it; `check` itself has no limit."""
        if limit == math.inf:
            yield
            return
        self.timed += 1
        if self.timed == self.late:
            raise TooSlow(LATE)
        self._within += 1
        try:
            yield
        finally:
            self._within -= 1

    def look(self, frame: FrameType, event: str, argument: Any) -> None:
        """Look at a call that Python makes."""
        if event != "call" or self._within or not frame.f_code.co_filename.startswith("<answer"):
            return
        callers, caller = list[str](), frame.f_back
        while caller:
            callers.append(f"{caller.f_code.co_filename}, line {caller.f_lineno}")
            caller = caller.f_back
        if any("checking.py" in place for place in callers):  # and not when the answer itself is made
            self.untimed = self.untimed or callers[0]


def watched(answer: Answer, monkeypatch: pytest.MonkeyPatch, late: int | None = None) -> tuple[str, Watch]:
    """Return what a check says of an answer, and what was seen meanwhile."""
    watch = Watch(late)
    monkeypatch.setattr(student_code, "time_limit", watch.time_limit)
    before = sys.getprofile()
    sys.setprofile(watch.look)
    try:
        return verdict(answer, checked_by(answer), exercises_of(answer.lesson)[0]), watch
    finally:
        sys.setprofile(before)


@pytest.mark.slow
@pytest.mark.parametrize("answer", EVERY_FIFTH, ids=lambda one: f"{one.lesson}-{one.exercise}-{one.name}")
def test_a_call_that_does_not_end(answer: Answer, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first call, one in the middle, or the last: then a right answer is refused; each call has a limit."""
    _, watch = watched(answer, monkeypatch)
    assert watch.untimed == ""
    for late in sorted({1, (watch.timed + 1) // 2, watch.timed}) if watch.timed else []:
        said, again = watched(answer, monkeypatch, late)
        assert again.untimed == ""
        assert said != ""
        assert LATE in said or not answer.right  # what is wrong may be said without that call

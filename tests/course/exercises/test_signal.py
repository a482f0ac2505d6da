"""The exercises of lesson 6: their numbers are the package's, and every mistake is one."""

from edugym_course.lessons.signal import exercises
from edugym_course.lessons.signal.words import information


def test_the_number_of_words() -> None:
    """22 words carry 0.4 bit, and 21 do not."""
    assert information(0.1, exercises.WORDS - 1) < exercises.ENOUGH <= information(0.1, exercises.WORDS)

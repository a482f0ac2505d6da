"""Where the lessons' texts are, for tests that still ask here."""

from tests.course.lessons.shown import NOTEBOOKS

__all__ = ["NOTEBOOKS"]

"""`check`: it prints one line if an answer is right, and raises one sentence if it is not."""

import math
import re
from collections.abc import Callable
from typing import Any

from edugym.checks.parameters import in_short, true_or_false, whole_number
from edugym_course.grading.errors import WrongAnswer, folded
from edugym_course.grading.own_numbers import belongs_to_others, own_parameters
from edugym_course.grading.printed import few_lines
from edugym_course.grading.student_code import student_code
from edugym_course.lab.progress import record_passed


def check(exercise: Callable[..., str], answer: Any, *, seed: int = 0, quiet: bool = False, **numbers: Any) -> None:
    """Check an answer, and print one line if it is right.

    In a folder that `edugym lab` made, it also updates the start page.

    Args:
        exercise: the exercise, a function of the answer and a `seed`, such as `exercise_2` of a lesson.
        answer: what the student defined: a number, a function, a class, results.
        seed: the number from which the cases are drawn, 0 or more; another seed draws other cases.
        quiet: whether a right answer prints nothing, as in hidden tests.
        numbers: a student's own numbers, by name, as `edugym assign` draws them; by default the ordinary ones.

    Raises:
        WrongAnswer: the answer is not right. A notebook shows its sentence and no traceback.
        Unsolved: there is no answer yet.
        ValueError: another argument is not as above.
    """
    if isinstance(exercise, type) or not callable(exercise):
        raise ValueError(f"exercise must be a function, such as exercise_1 of a lesson, but is {in_short(exercise)}")
    whole_number("seed", seed, 0)
    true_or_false("quiet", quiet)
    for name in numbers.keys() - own_parameters(exercise).keys():
        raise ValueError(f"{exercise.__name__} has no number {name} of a student's own, but {name} is given")
    with few_lines() as printed, student_code("your code", limit=math.inf):  # calls inside it have limits of their own
        lines_before = printed.lines
        try:
            worth_knowing = exercise(answer, seed, **numbers)
        except WrongAnswer as wrong:
            raise type(wrong)(f"{wrong}{belongs_to_others(exercise, answer, seed, numbers, wrong)}") from None
    lesson = exercise.__module__.removeprefix("edugym_course.lessons.").partition(".")[0]
    number = re.fullmatch(r"exercise_(\d+)", exercise.__name__)
    if number:
        record_passed(lesson, int(number[1]))
    if not quiet:
        print(folded(f"✓ {worth_knowing}"))
        if why := _cannot_be_compiled(answer, prints=printed.lines > lines_before):
            slow = f"But {answer.__name__} {why}: it cannot be compiled, so that what trains it below may take minutes"
            faster = "A race with fewer runs, `repetitions=2`, shows enough to find a mistake."
            print(folded(f"{slow} instead of seconds. {faster}"))


def _cannot_be_compiled(answer: Any, prints: bool) -> str:
    """Say why a class of an agent or a task runs as plain Python, where that shows at once."""
    if not (isinstance(answer, type) and (hasattr(answer, "learn") or hasattr(answer, "transition"))):
        return ""
    if not issubclass(answer, tuple):
        return "is an ordinary class, no NamedTuple"
    return "prints (take the `print` out)" if prints else ""

"""Write `docs/own-numbers.md`: which number each exercise draws for a student, and from what; all of it from the code.

    python docs/own_numbers.py

A test says when the page is out of date.
"""

import math
from collections.abc import Iterator
from operator import sub
from pathlib import Path
from typing import Any

from edugym_course.grading.own_numbers import ordinary_numbers, own_parameters, told
from edugym_course.lab.lessons import CHECKOUT
from edugym_course.lab.records import number_of
from edugym_course.teaching.assignment import Task, read_lesson, tasks_of

PAGE = Path(__file__).parent / "own-numbers.md"
HEAD = """\
# Parameters of assignments

`edugym assign` hands out a lesson in which [each student has other
numbers](teaching.md#numbers-of-a-students-own). This page lists what it draws for the {n_tasks} exercises of the
{n_lessons} lessons. The table quotes the sentence that tells the student the number, with the first value.
The ordinary number is that of the lesson in the repository. Where values are not evenly spaced, since some are left
out, the table gives the first, the last and how many there are; the signature of the check has them all.

You need not choose anything. For other values, change them in the signature of the check, in the folder of the lesson;
[Writing a lesson](writing-lessons.md) says which values do. What you can set in the tasks themselves stands on the page
of [each environment](environments/README.md). The cases of a check are drawn for each student too.

(This page is written by [`docs/own_numbers.py`](own_numbers.py).)
"""
LESSON = """
## Lesson {number}: {title}

[The lesson](../notebooks/{name}.ipynb) and [its folder](../{folder}).

| exercise | a student's version, for example | drawn from | ordinary |
|---|---|---|---|
"""


def page() -> str:
    """Return the page in Markdown."""
    lessons = {path.stem: read_lesson(path) for path in sorted((CHECKOUT / "teacher").glob("*.ipynb"))}
    tasks = {name: tasks_of(lesson) for name, lesson in lessons.items()}
    parts = [HEAD.format(n_tasks=sum(map(len, tasks.values())), n_lessons=len(lessons))]
    for name, lesson in lessons.items():
        title = lesson.cells[0].source.partition("\n")[0].lstrip("# ")
        folder = "/".join(["src", *tasks[name][0].module.split(".")[:3]])
        parts.append(LESSON.format(number=number_of(name), title=title, name=name, folder=folder))
        parts += (f"| {' | '.join(row)} |\n" for row in rows(tasks[name]))
    return "".join(parts)


def rows(tasks: list[Task]) -> Iterator[tuple[str, str, str, str]]:
    """Yield for each number of each exercise the exercise, a student's sentence, the values, and the ordinary one."""
    for task in tasks:
        exercise = task.check()
        own = own_parameters(exercise)
        sentence = told(exercise, {name: declared.values[0] for name, declared in own.items()})
        for name, declared in own.items():
            ordinary = _shown(ordinary_numbers(exercise).get(name))
            yield str(task.number), sentence.replace("|", "\\|"), _listed(declared.values), ordinary


def _listed(values: tuple[Any, ...]) -> str:
    """All values in short: a series that one can continue, or else the two ends."""
    first, second, *_, last = map(_shown, values)
    even = math.isclose(max(map(sub, values[1:], values)), min(map(sub, values[1:], values)))
    return (
        f"{first}, {second}, …, {last} ({len(values)} values)"
        if even
        else f"{len(values)} values from {first} to {last}"
    )


def _shown(number: Any) -> str:
    """A number in short; none where the ordinary lesson leaves it to the student, or where it has no bound."""
    return "none" if number is None or abs(number) == float("inf") else f"{number:.10g}"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8", newline="\n")

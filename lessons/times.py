"""How long a lesson takes, reckoned from its words: its main path, its asides and its exercises.

The two rates are fitted to what two fresh readers of lessons 0 to 7 thought that a student needs: 40 to 140 minutes for
the text and 25 to 70 for the exercises. They are off by up to 30 and 10 minutes there. Nobody has been timed.
"""

import math
import re
from collections.abc import Sequence
from typing import NamedTuple

from asides import OPENS, is_opening
from nbformat import NotebookNode

from edugym_course.teaching.marks import OWN, is_aside, is_code

WORDS = 40  # of a text take a minute, with the code, pictures, predictions and sliders that stand between them
TASK_WORDS = 20  # of an exercise take a minute, and so does each line of its solution
EXTRA = {"The open challenge": "the open challenge", "From a blank file": "the program from a blank file"}
LONGEST = 3_000  # words of the main path of a lesson
TIME = "**Time.** {time}"
"""What stands in the first cell of a lesson; the builder puts the times there."""


class Counts(NamedTuple):
    """Words of a lesson by where they stand, and lines of its solutions.

    Attributes:
        path: words before the exercises and after them, without asides, references and the survey.
        asides: words of each aside, in order.
        tasks: words of the exercises, without the open challenge and the program from a blank file.
        lines: lines of the solutions of the exercises.
        extra: what comes on top, in words.
    """

    path: int
    asides: list[int]
    tasks: int
    lines: int
    extra: list[str]


def count(cells: Sequence[NotebookNode]) -> Counts:
    """Return the words of a lesson; in a formula, whatever stands between two spaces is a word."""
    path = tasks = lines = 0
    asides: list[int] = []
    extra: list[str] = []
    section = ""
    for cell in cells:
        if is_code(cell):
            solutions = re.findall(r"### BEGIN SOLUTION\n(.*?)### END SOLUTION", cell.source, flags=re.DOTALL)
            lines += sum(not line.strip().startswith(OWN) for text in solutions for line in text.strip().splitlines())
            continue
        for part in filter(None, re.split(r"^(?=#{2,3} )", cell.source, flags=re.MULTILINE)):
            heading = part.partition("\n")[0].lstrip("# ").partition(":")[0]
            if part.startswith("## "):
                section = heading
            elif section == "Exercises" and part.startswith("### "):
                extra += [EXTRA[heading]] if heading in EXTRA else []
            words = len(part.split())
            if is_opening(cell):
                asides.append(words)
            elif is_aside(cell):
                asides[-1] += words
            elif section != "Exercises":
                path += 0 if heading in ("Further reading", "Before you go") else words
            elif not extra:
                tasks += words
    return Counts(path, asides, tasks, lines, extra)


def rounded(minutes: float) -> int:
    """Return a time in steps of five minutes, upwards."""
    return 5 * math.ceil(minutes / 5)


def announced(counts: Counts) -> str:
    """Return the times of a lesson in words."""
    asides = sum(rounded(words / WORDS) for words in counts.asides)
    told = f"About {rounded(counts.path / WORDS)} minutes for the text, "
    if asides:
        which = "aside, which is" if len(counts.asides) == 1 else "asides, which are"
        told += f"{asides} more for the {which} folded and can be skipped, "
    told += f"and {rounded(counts.tasks / TASK_WORDS + counts.lines)} more for the exercises"
    if counts.extra:
        told += f"; {' and '.join(counts.extra)} come{'s' if len(counts.extra) == 1 else ''} on top"
    return f"{told} (estimated)."


def announce(cells: Sequence[NotebookNode]) -> None:
    """Write the times into the first cell of a lesson, and into the heading of each aside."""
    counts = count(cells)
    cells[0].source = cells[0].source.replace(TIME, f"**Time.** {announced(counts)}")
    openings = [cell for cell in cells if is_opening(cell)]
    for cell, words in zip(openings, counts.asides, strict=True):
        cell.source = cell.source.replace(OPENS, f"### Aside, {rounded(words / WORDS)} minutes: ", 1)


def length_problems(cells: Sequence[NotebookNode]) -> list[str]:
    """Say where the main path of a lesson is too long."""
    words = count(cells).path
    found = (
        f"the main path has {words:,} words, and {LONGEST:,} are allowed: put what is not its one idea into an aside"
    )
    return [found] if words > LONGEST else []

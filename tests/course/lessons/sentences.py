"""What the checks say of each answer, in full: how it is written down, and compared."""

import contextlib
import io
import re
from pathlib import Path
from unittest.mock import patch

import build
import numpy as np

from edugym.training.train import train
from tests.course.lessons.answers import Answer, read_answers, read_exercises, verdict

SENTENCES = Path(__file__).parent / "sentences"
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")
OF_PYTHON = re.compile(r"(?<= raises )\w+: .*")
"""An error in an answer is told in the words of Python or of a library, which change; its hint has tests of its own."""


def heading(answer: Answer) -> str:
    """Return the line above what is said of an answer."""
    return f"{answer.exercise} {'right' if answer.right else 'wrong'}: {answer.name}"


def said_of(answer: Answer, said: str, printed: str) -> str:
    """Return what is said of an answer in one line: the sentence of a wrong one, the praise of a right one."""
    praise = " / ".join(line for line in printed.splitlines() if line.startswith("✓ "))
    return OF_PYTHON.sub("...", said) or praise


def written(lesson: str) -> dict[str, str]:
    """Return what is written down of a lesson's answers, by their headings; nothing if there is no such file."""
    path = SENTENCES / f"{lesson}.txt"
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return dict(zip(lines[::2], (line.strip() for line in lines[1::2]), strict=True))


def alike(before: str, now: str) -> bool:
    """Whether two sentences are the same but for the last digits of numbers, which depend on the machine."""
    if NUMBER.sub("0", before) != NUMBER.sub("0", now):
        return False
    one, other = ([float(text) for text in NUMBER.findall(sentence)] for sentence in (before, now))
    return bool(np.allclose(one, other, rtol=1e-3, atol=1e-12))


def write(lesson: str) -> None:
    """Try all answers of a lesson, and write down what is said."""
    imports, exercises = read_exercises(build.lesson_sources()[lesson])
    setup, answers = read_answers(lesson)
    lines = []
    for answer in answers:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed), patch("edugym.experiments.repeat.train", train):
            said = verdict(answer, exercises[answer.exercise - 1], (imports, setup))
        lines += [heading(answer), f"  {said_of(answer, said, printed.getvalue())}"]
    (SENTENCES / f"{lesson}.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")

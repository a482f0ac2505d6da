"""The numbers in what the text says was measured are those that the cells of its section show, or are listed here."""

import re

import build
import nbformat
import pytest
from rules import is_code

from tests.course.lessons.test_measured import printed
from tests.course.lessons.transcripts import NOTEBOOKS

NOT_SHOWN = {
    "loop": "248 76 15 22 25 14 2.6 50 15 21 2.7 5.8 50",
    "exploration": "30 7600 9200 99 40000 12000",
    "on_off_policy": "3.9 1.5 30 0.032 6.4 2.7 6.3 25",
    "depth": "40 20 37 150 2.9 4.3 3.7 1.2 5.4 98 17 85 93 71 37 0.65 7.2 2.6",
    "dimensionality": "2048 195",
    "memory": "256 20",
    "signal": "16 64 100000 1994 200000 17.3 2040",
    "continuous_actions": "81 4.31 4.07 150",
    "stochasticity": "0.87 0.87 0.0187 50 14 11 400 0.52",
    "model_based": "25 420",
    "own_problem": "20 2.7 20 4.3 20 1.8 0.34 20 5.7 9.9",
}
"""Numbers that are read from a figure, come from a longer experiment, or are worked out: look at them by hand."""

NUMBER = re.compile(r"(?<![\w.])\d+(?: \d{3})*(?:\.\d+)?")


def numbers(text: str) -> list[str]:
    """Return the numbers of a text, without the spaces between their thousands."""
    return [number.replace(" ", "") for number in NUMBER.findall(text)]


def is_shown(number: str, shown: list[str]) -> bool:
    """Whether one of those that are shown is this one, rounded or as a percentage."""
    digits = -2 if number.endswith("00") else len(number.partition(".")[2])
    exact = [float(one) for one in shown]
    return any(round(one, digits) == float(number) or round(100 * one, digits) == float(number) for one in exact)


def not_shown(lesson: str) -> list[str]:
    """Return the numbers with two digits or more in what was measured that stand nowhere above in their section."""
    path = NOTEBOOKS[lesson]
    solved = nbformat.read(build.ROOT / f"notebooks/solutions/{path.stem}.ipynb", as_version=4)
    outputs = {cell.source: printed(cell) for cell in solved.cells if is_code(cell)}
    found: list[str] = []
    above: list[str] = []
    for cell in build.read_lesson(path).cells:
        if is_code(cell):
            above += numbers(cell.source.replace("_", "")) + numbers(outputs.get(cell.source, ""))
            continue
        if re.search(r"^## ", cell.source, re.MULTILINE):
            above = []
        before, _, measured = cell.source.partition("**Measured.**")
        above += numbers(before)
        told = numbers(measured.partition("</details>")[0])
        long = [number for number in told if len(number.replace(".", "").lstrip("0")) > 1]
        found += [number for number in long if not is_shown(number, above)]
        above += told
    return found


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_numbers_in_the_text_are_shown(lesson: str) -> None:
    """If the text says a number that no cell shows, look at where it comes from, and list it above."""
    assert not_shown(lesson) == NOT_SHOWN.get(lesson, "").split()


@pytest.mark.parametrize(
    ("number", "right"), [("97", True), ("79", False), ("33", True), ("0.33", True), ("0.34", False), ("5800", True)]
)
def test_what_is_shown(number: str, right: bool) -> None:
    """As it is, rounded, as a percentage."""
    assert is_shown(number, ["97", "0.3284", "5812"]) == right

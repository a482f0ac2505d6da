"""What the text of a lesson says was measured is what its notebook shows, or stands in its `by_hand.toml`."""

import ast
import re
import tomllib
from collections.abc import Iterator
from typing import Any, NamedTuple

import build
import nbformat
import pytest
from rules import is_code

from tests.course.lessons.answers import cells_of
from tests.course.lessons.shown import NOTEBOOKS

SMALL = {"none": 0, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "ten": 10}
NUMBER = re.compile(r"(?<![\w.])\d+(?: \d{3})*(?:\.\d+)?")


class Told(NamedTuple):
    """A prediction: what can be chosen (nothing for a number), what was measured, and what the text says of it."""

    name: str
    options: list[str]
    measured: str
    text: str


def by_hand(lesson: str) -> tuple[list[str], dict[str, str]]:
    """Return the numbers that no cell shows, and what is told in other words, by prediction."""
    path = NOTEBOOKS[lesson].with_name("by_hand.toml")
    found = tomllib.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    return found.get("numbers", "").split(), found.get("measured", {})


def printed(cell: Any) -> str:
    """Return the texts that a cell of a notebook shows."""
    return "".join(out.get("text", "") or out.get("data", {}).get("text/plain", "") for out in cell.get("outputs", []))


def solved(lesson: str) -> Any:
    """Return the notebook with solutions."""
    return nbformat.read(build.ROOT / f"notebooks/solutions/{NOTEBOOKS[lesson].stem}.ipynb", as_version=4)


def predictions(lesson: str) -> Iterator[Told]:
    """Yield the predictions of a lesson: the text from its source, what was measured from the notebook."""
    shown = iter(re.findall(r"Measured: (.*?)\. \(You made", "\n".join(map(printed, solved(lesson).cells)), re.DOTALL))
    options: dict[str, Any] = {}
    cells: list[Any] = cells_of(NOTEBOOKS[lesson])
    for cell, after in zip(cells, [*cells[1:], None], strict=True):
        if not is_code(cell):
            continue
        for name, call in re.findall(r"^(\w+) = (predict\(.*?\)\n)", cell.source + "\n", re.DOTALL | re.MULTILINE):
            listed = [node for node in ast.walk(ast.parse(call)) if isinstance(node, ast.List)]
            texts = [node.value for part in listed for node in part.elts if isinstance(node, ast.Constant)]
            options[name] = [str(text) for text in texts]
        if found := re.search(r"^(\w+)\.measured\(", cell.source, re.MULTILINE):
            text = after.source.partition("**Measured.**")[2].partition("</details>")[0]
            yield Told(found[1], options[found[1]], next(shown), " ".join(text.split()))
    assert next(shown, None) is None


def words(text: str) -> set[str]:
    """Return the words of a text without its formulas' marks; a number keeps its letter, as in "γ = 0"."""
    plain = re.sub(r"\\var(?=epsilon)|[\\$*`,:]|\.(?!\d)", "", text.replace("−", "-"))
    for name, letter in (("epsilon", "ε"), ("alpha", "α"), ("gamma", "γ"), ("tau", "τ")):
        plain = plain.replace(name, letter)
    return set(plain.replace(" = ", "=").lower().split())


def says(told: Told) -> bool:
    """Whether the text says what was measured: the number as exactly as it gives it, or the words of the option."""
    number = re.match(r"[−-]?\d+(?:\.\d+)?", told.measured)
    if number and not told.options:
        value, text = float(number[0].replace("−", "-")), told.text.replace("−", "-")
        given = [n.replace(" ", "") for n in re.findall(r"-?\d[\d ]*(?:\.\d+)?", text)]
        small = [str(k) for name, k in SMALL.items() if name in words(text)]
        return any(float(n) == round(value, len(n.partition(".")[2])) for n in [*given, *small])
    first = words(re.split(r"(?<=[.!?:]) ", told.text)[0])
    first |= {str(SMALL[word]) for word in first & SMALL.keys()}
    share = {option: len(words(option) & first) / len(words(option)) for option in (*told.options, told.measured)}
    return share[told.measured] == max(share.values()) >= 0.5


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_the_text_says_what_was_measured(lesson: str) -> None:
    """A number rounded, an option in its own words, or else in the words that somebody has looked at."""
    found = {told.name: told for told in predictions(lesson)}
    _, in_other_words = by_hand(lesson)
    assert found
    not_said = [told for told in found.values() if not says(told) and told.name not in in_other_words]
    assert not_said == [], "begin the text after **Measured.** with the words of the option, or list it in by_hand.toml"
    assert [name for name, text in in_other_words.items() if text not in found[name].text or says(found[name])] == []


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
    outputs = {cell.source: printed(cell) for cell in solved(lesson).cells if is_code(cell)}
    found: list[str] = []
    above: list[str] = []
    for cell in cells_of(NOTEBOOKS[lesson]):
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
    """If the text says a number that no cell shows, look at where it comes from, and list it in `by_hand.toml`."""
    assert not_shown(lesson) == by_hand(lesson)[0]

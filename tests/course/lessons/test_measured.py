"""What the text of a lesson says was measured is what its notebook with solutions shows."""

import ast
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

import build
import nbformat
import pytest
from rules import is_code

from tests.course.lessons.transcripts import NOTEBOOKS

SMALL = {"none": 0, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "ten": 10}
OTHERWISE = {
    ("loop", "next_reward"): "−248 points",
    ("loop", "everywhere"): "In less than half of them",
    ("exploration", "middle"): "The novelty reward solves the middle wall as well. Go-Explore solves all three",
    ("exploration", "two_branches"): "It turns away, sometimes for thousands of steps, and it comes back",
    ("exploration", "far_sighted"): "All runs with 0.9, and none with 0.99",
    ("exploration", "three_grips"): "With two grips and $\\alpha = 1$ optimism solves the high wall",
    (
        "on_off_policy",
        "ahead",
    ): "Each wins one of the two. Without slips Q-learning reaches the optimum, −2, and SARSA takes one",
    ("depth", "kept"): "All of them",
    ("depth", "cards"): "Hardly at all. These three runs cannot tell the difference from 0",
    ("dimensionality", "bound"): "Above one half",
    ("dimensionality", "more"): "Not more: 10 240 against 14 336",
    ("memory", "helps"): "It helps a lot: 9.7 instead of 6.9",
    ("memory", "early"): "It returns more: 6.9 against 6.0",
    ("memory", "far"): "A little more than 21",
    ("memory", "learned"): "It ends near 16, between the two",
    ("continuous_actions", "slower"): "The interval contains 0",
    ("continuous_actions", "rich"): "None. They start narrow",
    ("stochasticity", "highest"): "Neutral and seeking are level, near 0.82",
    ("stochasticity", "pays"): "More: about 0.02",
    ("model_based", "wants_to_know"): "In nearly all runs",
    ("model_based", "never"): "More than nine of ten",
    ("own_problem", "mild"): "It stalls in its first step, with return $-1$",
    ("own_problem", "progress"): "Paid for being awake, the clock chimes from 7:10 on",
    (
        "own_problem",
        "helps",
    ): "At 800 steps Q-learning with the potential of 10 is far *behind* Q-learning without shaping",
}
"""How the text puts it where it says the same in other words, by lesson and prediction."""


class Told(NamedTuple):
    """A prediction: what can be chosen (nothing for a number), what was measured, and what the text says of it."""

    lesson: str
    name: str
    options: list[str]
    measured: str
    text: str


def predictions(lesson: str) -> Iterator[Told]:
    """Yield the predictions of a lesson: the text from its source, what was measured from the notebook."""
    path = NOTEBOOKS[lesson]
    solved = nbformat.read(build.ROOT / f"notebooks/solutions/{path.stem}.ipynb", as_version=4)
    shown = iter(re.findall(r"Measured: (.*?)\. \(You made", "\n".join(map(printed, solved.cells)), re.DOTALL))
    options: dict[str, Any] = {}
    cells = build.read_lesson(path).cells
    for cell, after in zip(cells, [*cells[1:], None], strict=True):
        if not is_code(cell):
            continue
        for name, call in re.findall(r"^(\w+) = (predict\(.*?\)\n)", cell.source + "\n", re.DOTALL | re.MULTILINE):
            listed = [node for node in ast.walk(ast.parse(call)) if isinstance(node, ast.List)]
            texts = [node.value for part in listed for node in part.elts if isinstance(node, ast.Constant)]
            options[name] = [str(text) for text in texts]
        if found := re.search(r"^(\w+)\.measured\(", cell.source, re.MULTILINE):
            text = after.source.partition("**Measured.**")[2].partition("</details>")[0]
            yield Told(lesson, found[1], options[found[1]], next(shown), " ".join(text.split()))
    assert next(shown, None) is None


def printed(cell: Any) -> str:
    """Return the texts that a cell of a notebook shows."""
    return "".join(out.get("text", "") or out.get("data", {}).get("text/plain", "") for out in cell.get("outputs", []))


def words(text: str) -> set[str]:
    """Return the words of a text without its formulas' marks; a number keeps its letter, as in "γ = 0"."""
    plain = re.sub(r"\\var(?=epsilon)|[\\$*`,]|\.(?!\d)", "", text.replace("−", "-"))
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
    """A number rounded, an option in its own words, or else in words that stand above."""
    found = [*predictions(lesson)]
    assert len(found) >= 5
    for told in found:
        in_other_words = OTHERWISE.get((lesson, told.name))
        assert in_other_words in told.text if in_other_words else says(told), told


def test_no_more_is_said_otherwise_than_needed() -> None:
    """A prediction that is gone, or is told in the words of its option, needs no entry."""
    every = {(told.lesson, told.name): told for lesson in NOTEBOOKS for told in predictions(lesson)}
    assert [place for place in OTHERWISE if says(every[place])] == []


@pytest.mark.parametrize(
    ("measured", "options", "text", "right"),
    [
        ("97 episodes", [], "97 episodes with $n = 1$, 37 with $n = 3$", True),
        ("97 episodes", [], "79 episodes with $n = 1$", False),
        ("32.8 %", [], "33 %, only a little more than chance.", True),
        ("0.0321", [], "0.032, so it was close.", True),
        ("2 runs", [], "Two of them.", True),
        ("-313 points", [], "−313 points.", True),
        ("-313 points", [], "313 points.", False),
        ("better", ["better", "worse"], "Better, by more than one.", True),
        ("worse", ["better", "worse"], "Better, by more than one.", False),
        ("γ = 0", ["γ = 0", "γ = 1"], r"With $\gamma = 1$ it is ahead.", False),
        ("2", ["none", "2", "3"], "Two. It is blind.", True),
    ],
)
def test_what_says_it(measured: str, options: list[str], text: str, right: bool) -> None:
    """Numbers, small numbers as words, and the option that fits best."""
    assert says(Told("", "", options, measured, text)) == right

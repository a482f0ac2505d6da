"""One line for a right answer, one sentence for a wrong one, in a notebook too."""

import math
from contextlib import AbstractContextManager
from types import ModuleType
from typing import Any, NamedTuple

import nbformat
import pytest
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_notebook

from edugym_course.grading import Unsolved, WrongAnswer, check, checking
from edugym_course.grading.errors import WIDTH
from edugym_course.grading.student_code import student_code
from tests.messages import named


def exercise(answer: int, seed: int) -> str:
    """An exercise whose right answer is the seed plus 2."""
    if answer is None:
        raise Unsolved("Not solved yet")
    if answer / 1 != seed + 2:
        raise WrongAnswer(f"{answer} is not {seed + 2}: add 2")
    return "two is even"


def test_what_is_said_of_answers(capsys: pytest.CaptureFixture[str]) -> None:
    """A right one prints one line, or nothing; a wrong one raises a sentence, without a chain of tracebacks."""
    check(exercise, 2)
    assert capsys.readouterr().out == "✓ two is even\n"
    check(exercise, 5, seed=3, quiet=True)
    assert capsys.readouterr().out == ""
    with pytest.raises(WrongAnswer, match="3 is not 2: add 2"):
        check(exercise, 3)
    with pytest.raises(Unsolved):
        check(exercise, None)
    with pytest.raises(WrongAnswer, match="raises TypeError: unsupported") as caught:
        check(exercise, "3")
    assert caught.value.__suppress_context__
    assert caught.value.__cause__ is None
    with pytest.raises(ValueError, match=named("seed", 0, -1)):
        check(exercise, 2, seed=-1)
    with pytest.raises(ValueError, match="no number height"):
        check(exercise, 2, height=3)


@pytest.mark.parametrize("n", [0, 19, 20, 21, 13_536])
def test_a_flood_is_cut(n: int, capsys: pytest.CaptureFixture[str]) -> None:
    """Twenty lines of what the answer prints, and the number of the others; in any cut of its writing."""

    def floods(answer: Any, seed: int) -> str:
        answer()
        return "right"

    def answer() -> None:
        for k in range(n):
            print("line", k, end=".\n")

    check(floods, answer)
    out = capsys.readouterr().out.splitlines()
    assert out[: min(n, 20)] == [f"line {k}." for k in range(min(n, 20))]
    more = [f"... and {n - 20:,} more lines".replace(",", " ")] if n > 20 else []
    assert out[min(n, 20) :] == [*more, "✓ right"]


class Quiet(NamedTuple):
    """An agent that can be compiled."""

    def learn(self, state: int) -> None:
        """Learn nothing."""


class Talks(Quiet):
    """One that prints."""

    def learn(self, state: int) -> None:
        """Say it."""
        print(state)


class Ordinary:
    """One that is no NamedTuple."""

    def learn(self, state: int) -> None:
        """Learn nothing."""


@pytest.mark.parametrize(("kind", "why"), [(Quiet, ""), (Talks, "Talks prints"), (Ordinary, "Ordinary is an ordin")])
def test_what_makes_a_race_slow_is_said_before_it_starts(
    kind: Any, why: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """With the shorter race. Nothing is said of a class that can be compiled."""

    def learns(answer: Any, seed: int) -> str:
        answer().learn(3)
        return "right"

    check(learns, kind)
    said = capsys.readouterr().out
    assert why in said
    assert ("repetitions=2" in said) == bool(why)


def noted_limits(monkeypatch: pytest.MonkeyPatch, module: ModuleType) -> list[tuple[str, float]]:
    """Return a list in which the limits of all that a module runs of students will stand."""
    limits: list[tuple[str, float]] = []

    def noted(what: str, limit: float = 30.0) -> AbstractContextManager[None]:
        limits.append((what, limit))
        return student_code(what, limit)

    monkeypatch.setattr(module, "student_code", noted)
    return limits


def test_a_whole_check_may_take_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only each call of the student's code has a limit."""
    limits = noted_limits(monkeypatch, checking)
    check(exercise, 2, quiet=True)
    assert limits == [("your code", math.inf)]


@pytest.mark.slow
def test_in_a_notebook_a_flood_is_cut_until_the_end_of_the_cell() -> None:
    """Also in what follows the check, such as a race. The cell's own lines, and other cells, are not cut."""
    code = (
        "from edugym_course.grading import check\n"
        "def answer(n):\n    for k in range(n): print('line')\n"
        "def exercise(answer, seed): answer(15); return 'right'\n"
        "exercise.__module__ = 'edugym_course.lessons.loop.exercises'\n"
        "check(exercise, answer)\nanswer(3_000)\nfor k in range(30): print('cell')"
    )
    notebook = new_notebook(cells=[new_code_cell(code), new_code_cell("answer(25)")])
    NotebookClient(notebook, kernel_name="python3").execute()
    first, second = ("".join(out["text"] for out in cell.outputs) for cell in notebook.cells)
    assert (first.count("line\n"), first.count("cell\n"), first.count("✓ right")) == (20, 30, 1)
    assert "... and 2 995 more lines" in first
    assert second == "line\n" * 25


def test_lines_of_a_message_are_broken_between_words() -> None:
    """Those that are long; the others, with their spaces, stay as they are."""
    long = "NotImplementedError " * 8
    shown = "\n".join(WrongAnswer(f"it is\n  2   3\n{long}")._render_traceback_())
    assert shown.startswith("✗ it is\n  2   3\nNot")
    assert shown.split() == f"✗ it is 2 3 {long}".split()
    assert max(map(len, shown.splitlines())) <= WIDTH < len(long)


@pytest.mark.slow
def test_a_notebook_shows_the_sentence_and_no_traceback() -> None:
    """The cell has failed all the same: that is how nbgrader knows."""
    code = "from edugym_course.grading import WrongAnswer\ndef f(): raise WrongAnswer('it is 2: add 2')\nf()"
    notebook = new_notebook(cells=[new_code_cell(code, metadata={"tags": ["raises-exception"]})])
    NotebookClient(notebook, kernel_name="python3").execute()
    [output] = notebook.cells[0].outputs
    assert output == nbformat.v4.new_output(
        "error", ename="WrongAnswer", evalue="it is 2: add 2", traceback=["✗ it is 2: add 2"]
    )

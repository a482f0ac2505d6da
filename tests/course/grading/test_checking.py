"""One line for a right answer, one sentence for a wrong one, in a notebook too."""

import math
from contextlib import AbstractContextManager
from types import ModuleType

import nbformat
import pytest
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_notebook

from edugym_course.grading import Unsolved, WrongAnswer, check, checking
from edugym_course.grading.student_code import student_code


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
    with pytest.raises(ValueError, match="seed must be 0 or more"):
        check(exercise, 2, seed=-1)
    with pytest.raises(ValueError, match="no number height"):
        check(exercise, 2, height=3)


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
def test_a_notebook_shows_the_sentence_and_no_traceback() -> None:
    """The cell has failed all the same: that is how nbgrader knows."""
    code = "from edugym_course.grading import WrongAnswer\ndef f(): raise WrongAnswer('it is 2: add 2')\nf()"
    notebook = new_notebook(cells=[new_code_cell(code, metadata={"tags": ["raises-exception"]})])
    NotebookClient(notebook, kernel_name="python3").execute()
    [output] = notebook.cells[0].outputs
    assert output == nbformat.v4.new_output(
        "error", ename="WrongAnswer", evalue="it is 2: add 2", traceback=["✗ it is 2: add 2"]
    )

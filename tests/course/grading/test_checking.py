"""One line for a right answer, one sentence for a wrong one, in a notebook too."""

import math
from contextlib import AbstractContextManager

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


def test_a_right_answer_prints_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    """And nothing when it is asked to be quiet."""
    check(exercise, 2)
    assert capsys.readouterr().out == "✓ two is even\n"
    check(exercise, 5, seed=3, quiet=True)
    assert capsys.readouterr().out == ""


def test_a_wrong_answer_raises_a_sentence() -> None:
    """Other errors of an answer become one as well, without a chain of tracebacks."""
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


def test_a_whole_check_may_take_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only each call of the student's code has a limit."""
    limits: list[tuple[str, float]] = []

    def noted(what: str, limit: float = 30.0) -> AbstractContextManager[None]:
        limits.append((what, limit))
        return student_code(what, limit)

    monkeypatch.setattr(checking, "student_code", noted)
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

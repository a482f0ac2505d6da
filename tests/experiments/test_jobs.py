"""Several runs at a time, in threads and in processes: the same results, and errors that name the line."""

import joblib
import pytest
from joblib.externals.loky.process_executor import _RemoteTraceback

import edugym
from edugym import QLearning
from edugym.checks.tracebacks import end_at_students_line
from edugym.experiments.repeat import MOST_JOBS
from edugym.mdp.protocol import Random
from tests.experiments.experiments import same, small


@pytest.mark.parametrize("n_steps", [500, pytest.param(6_000, marks=pytest.mark.slow)])
def test_jobs_change_nothing(n_steps: int) -> None:
    """One at a time, three at a time, or as many as may be asked for; interpreted and compiled."""
    one = small(n_steps, jobs=1)
    assert same(one, small(n_steps, jobs=3))
    assert same(one, small(n_steps, jobs=MOST_JOBS))


class Faulty(QLearning):
    """A student's agent with a mistake."""

    __slots__ = ()

    def act(self, state: int, rng: Random) -> int:
        """There is no such entry."""
        return [0][state + 1]


@pytest.mark.slow
def test_other_processes_change_nothing() -> None:
    """An error names the student's line, without the traceback of joblib and its processes."""
    with joblib.parallel_config(backend="loky", n_jobs=2):
        assert same(small(), small(jobs=None))
        with pytest.raises(IndexError) as caught:
            small(jobs=None, agents={"faulty": Faulty.create})
    assert caught.value.__cause__ is None
    (note,) = caught.value.__notes__
    assert note.startswith("In another process: ")
    assert note.endswith("in act\n    return [0][state + 1]")
    assert __file__ in note


def test_an_error_of_the_package_in_another_process_names_the_students_line_or_none() -> None:
    """Frames of the package, of joblib and of the standard library are no help."""
    frame = '  File "{}", line 3, in act\n    raise ValueError\n'
    shown = ["/home/me/edugym/mine.py", pytest.__file__]
    for students, notes in (("", []), *((frame.format(file), [file]) for file in shown)):
        error = ValueError("action is 7")
        told = "Traceback (most recent call last):\n" + students + frame.format(edugym.__file__) + "ValueError: 7"
        error.__cause__ = _RemoteTraceback(told)
        end_at_students_line(error)
        assert error.__cause__ is None
        assert [note.split('"')[1] for note in getattr(error, "__notes__", [])] == notes
    for kind in (AttributeError, TypeError):  # which are looked at more closely
        plain = kind("as it is")
        end_at_students_line(plain)
        assert (str(plain), plain.__traceback__) == ("as it is", None)

"""Old names of modules work for one more version, and say what they are called now."""

import importlib
import pickle
import re
import subprocess
import sys
import warnings
from collections.abc import Iterator
from types import ModuleType

import pytest

from edugym import Results
from edugym._old_names import MOVED, RENAMED, new_name
from edugym.adapters import registration


@pytest.fixture(autouse=True)
def _nothing_was_imported_by_its_old_name() -> Iterator[None]:
    """Python says it once a process, and keeps such modules; before and afterwards they are forgotten."""
    forget()
    yield
    forget()


def forget() -> None:
    """Let the next import by an old name be the first."""
    for name in [name for name in sys.modules if name.startswith("edugym.") and new_name(name) is not None]:
        del sys.modules[name]


@pytest.mark.parametrize("old", MOVED)
def test_a_module_that_has_moved(old: str) -> None:
    """It has what the new one has, and the warning names both."""
    with pytest.warns(DeprecationWarning, match="has moved") as said:
        found = importlib.import_module(f"edugym.{old}")
    assert re.fullmatch(rf"edugym\.{old} .*{MOVED[old]}", str(said[-1].message))
    new = importlib.import_module(MOVED[old])
    assert found.__doc__ == new.__doc__
    for name, value in vars(new).items():
        if not name.startswith("_") and not (isinstance(value, ModuleType) and value.__name__.startswith(new.__name__)):
            assert getattr(found, name) is value
    with pytest.raises(AttributeError, match=rf"edugym\.{old}.*'no_such_name'"):
        _ = found.no_such_name


def test_modules_inside() -> None:
    """They moved along with their package, and an exercise into the folder of its lesson."""
    for old, new in {
        "lessons.depth": "edugym_course.lessons.depth",
        "exercises.depth": "edugym_course.lessons.depth.exercises",
        "playing.game": "edugym.adapters.playing.game",
        "training.train": None,
        "no_such_module": None,
    }.items():
        assert new_name(f"edugym.{old}") == new


NOTEBOOK = """
from edugym.lessons.depth import credit_maps, report
from edugym.lessons import depth
from edugym.exercises.depth import exercise_1
import edugym.plotting as plotting
assert depth.credit_maps is credit_maps and report and exercise_1 and plotting.Curves
"""


def test_the_notebook_of_a_student() -> None:
    """What it imports from a lesson may lie in any file of that lesson now; only warnings are new."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        exec(NOTEBOOK, {})


@pytest.mark.filterwarnings("ignore:edugym:DeprecationWarning")
@pytest.mark.parametrize("old", RENAMED)
def test_a_name_that_is_another_now(old: str) -> None:
    """It is found where it was."""
    (before, name), (now, new) = ((path.rpartition(".")[0], path.rpartition(".")[2]) for path in (old, RENAMED[old]))
    assert getattr(importlib.import_module(before), name) is getattr(importlib.import_module(now), new)


def test_a_pickle_with_an_old_name() -> None:
    """As of saved agents and of finished runs."""
    for thing, old, new in (
        (registration.Entry, b"edugym.registration", b"edugym.adapters.registration"),
        (Results, b"edugym.results.tables", b"edugym.experiments.results.tables"),
    ):
        stored = pickle.dumps(thing, protocol=0)
        assert new in stored
        with pytest.warns(DeprecationWarning, match="has moved"):
            assert pickle.loads(stored.replace(new, old)) is thing


def test_the_command_as_a_module() -> None:
    """For those whose shell does not find it: `python -m edugym`, which finds it among the installed commands."""
    done = subprocess.run([sys.executable, "-m", "edugym", "list"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert "edugym/Boulder-v0" in done.stdout

"""Results that are stored with the package: they were made by the code that is there now."""

import runpy
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace

import pandas as pd
import pytest

import edugym_course.lessons
from edugym.experiments.results.tables import Results
from edugym_course import stored
from edugym_course.stored import CODE, REPETITIONS, Stored, stored_in

ROOT = Path(edugym_course.lessons.__path__[0])
MODULES = [".".join(path.relative_to(ROOT).with_suffix("").parts) for path in sorted(ROOT.rglob("*.csv"))]


@pytest.mark.parametrize("module", MODULES)
def test_they_are_current(module: str) -> None:
    """If not, run `python -m edugym_course.stored MODULE`. All runs are whole."""
    found = stored_in(module)
    assert found.is_current()
    results = found.load()
    assert results.complete
    assert results.table["repetition"].nunique() == REPETITIONS
    assert found.path.stat().st_size < 100_000
    for _, run in results.table.groupby(["method", "repetition"]):
        assert (run["step"].diff().dropna() > 0).all()
        assert run["step"].iloc[-1] == run["n_steps"].iloc[-1]


def test_changed_code_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another number is other code; another docstring or comment is not, nor a claim on the results."""
    path = tmp_path / "lesson.py"
    monkeypatch.setattr(stored, "source", lambda module: path)
    found = Stored("lesson", lambda **how: stored_in("memory.recurrent").load(), ())

    def code(text: str) -> str:
        path.write_text(f"{text}\nLATE = rate()\n")
        return found.code_hash()

    before = code('"""Before."""\n\ndef rate():\n    """The rate."""\n    return 0.1\n')
    assert code('"""After."""\n\ndef rate():\n    """Its rate."""\n    return 0.1  # small\n') == before
    assert code('"""Before."""\n\ndef rate():\n    return 0.1\n\ndef rate_claims():\n    return [0.3]\n') == before
    assert code('"""Before."""\n\ndef rate():\n    """The rate."""\n    return 0.2\n') != before


def test_what_stores_nothing() -> None:
    """The module is named."""
    assert "memory.recurrent" in MODULES
    with pytest.raises(ValueError, match=r"edugym_course.lessons.depth .*STORED"):
        stored_in("depth")
    with pytest.raises(ValueError, match=r"edugym_course.lessons.width"):
        stored_in("width")


def test_results_are_made_again_by_their_names(monkeypatch: pytest.MonkeyPatch) -> None:
    """As a command, for every module that is named; without a name it says what to give."""
    made: list[str] = []
    monkeypatch.setattr(stored, "stored_in", lambda name: SimpleNamespace(make_again=lambda: made.append(name)))
    for names in ([], ["depth"], ["memory.recurrent", "depth"]):
        monkeypatch.setattr("sys.argv", ["stored", *names])
        with pytest.raises(SystemExit, match="give the modules") if not names else nullcontext():
            runpy.run_path(stored.__file__, run_name="__main__")
        assert made == names
        made.clear()


def test_made_again_they_are_current(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """They have the hash of the code, also of other modules; finished runs are kept until all are there."""
    table = stored_in("memory.recurrent").load().table.drop(columns=CODE)
    monkeypatch.setattr(stored, "source", lambda module: tmp_path / f"{module.rpartition('.')[2]}.py")
    for name in ("lesson", "other"):
        (tmp_path / f"{name}.py").write_text(f"def {name}_claim():\n    return 1\n")
    asked = []

    def make(repetitions: int, checkpoints: Path) -> Results:
        checkpoints.mkdir()
        asked.append((repetitions, checkpoints))
        return Results(table.copy())

    found = Stored("lesson", make, ("a.other",))
    assert found.make_again().table[CODE].unique().tolist() == [found.code_hash()]
    assert asked == [(REPETITIONS, tmp_path / "lesson.unfinished")]
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["lesson.csv", "lesson.csv.json", "lesson.py", "other.py"]
    pd.testing.assert_frame_equal(found.load().table.drop(columns=CODE), table)
    assert found.is_current()
    assert len(found.code_hash()) == 32
    (tmp_path / "other.py").write_text("def other_claim():\n    return 2\n")
    assert not found.is_current()

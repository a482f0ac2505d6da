"""Results that are stored with the package: they were made by the code that is there now."""

import runpy
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import edugym.lessons
from edugym import stored
from edugym.stored import REPETITIONS, Stored, stored_in

ROOT = Path(edugym.lessons.__path__[0])
MODULES = [".".join(path.relative_to(ROOT).with_suffix("").parts) for path in sorted(ROOT.rglob("*.csv"))]


def test_they_are_found() -> None:
    """Or the other tests would test nothing."""
    assert "memory.recurrent" in MODULES


@pytest.mark.parametrize("module", MODULES)
def test_they_are_current(module: str) -> None:
    """If not, run `python -m edugym.stored MODULE`."""
    found = stored_in(module)
    assert found.is_current()
    results = found.load()
    assert results.complete
    assert results.table["repetition"].nunique() == REPETITIONS
    assert found.path.stat().st_size < 100_000


@pytest.mark.parametrize("module", MODULES)
def test_steps_increase(module: str) -> None:
    """In every run, up to the number of steps that was asked for."""
    table = stored_in(module).load().table
    for _, run in table.groupby(["method", "repetition"]):
        assert (run["step"].diff().dropna() > 0).all()
        assert run["step"].iloc[-1] == run["n_steps"].iloc[-1]


def test_changed_code_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another number is other code; another docstring or comment is not, nor a claim on the results."""
    path = tmp_path / "lesson.py"
    monkeypatch.setattr(stored, "_source", lambda module: path)
    found = Stored("lesson", lambda **how: stored_in("memory.recurrent").load(), ())

    def code(text: str) -> str:
        path.write_text(text)
        return found.code()

    before = code('"""Before."""\n\ndef rate():\n    """The rate."""\n    return 0.1\n')
    assert code('"""After."""\n\ndef rate():\n    """Its rate."""\n    return 0.1  # small\n') == before
    assert code('"""Before."""\n\ndef rate():\n    return 0.1\n\ndef rate_claims():\n    return [0.3]\n') == before
    assert code('"""Before."""\n\ndef rate():\n    """The rate."""\n    return 0.2\n') != before


def test_what_stores_nothing() -> None:
    """A sentence says so."""
    with pytest.raises(ValueError, match=r"edugym.lessons.depth stores no results: it has no STORED"):
        stored_in("depth")
    with pytest.raises(ValueError, match=r"there is no module edugym.lessons.width"):
        stored_in("width")


def test_results_are_made_again_by_their_names(monkeypatch: pytest.MonkeyPatch) -> None:
    """As a command, for every module that is named; without a name it says what to give."""
    made: list[str] = []
    monkeypatch.setattr(stored, "stored_in", lambda name: SimpleNamespace(make_again=lambda: made.append(name)))
    for names in ([], ["memory.recurrent", "depth"]):
        monkeypatch.setattr("sys.argv", ["stored", *names])
        with pytest.raises(SystemExit, match="give the modules") if not names else nullcontext():
            runpy.run_path(stored.__file__, run_name="__main__")
        assert made == names


@pytest.mark.slow
def test_recurrent_ppo_again() -> None:
    """The first points of a stored run, computed once more, are the same where the versions are."""
    pytest.importorskip("sb3_contrib")
    from edugym.deep.repeated import deep_versions
    from edugym.lessons.memory.recurrent import N_STEPS, RECURRENT, trainer

    table = stored_in("memory.recurrent").load().table
    if set(table["versions"]) != {deep_versions()}:
        pytest.skip("the results were made with other versions")
    first = table[table["repetition"] == 0]
    again = trainer()(N_STEPS // 10, seed=int(first["seed"].iloc[0]))
    np.testing.assert_array_equal(again.returns[:2], first["return"].iloc[:2])
    assert first["method"].iloc[0] == RECURRENT

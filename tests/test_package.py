"""The package that is built for users has everything, and no solutions."""

import importlib.util
import itertools
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

import edugym
from tests.test_readme import EXAMPLES

ROOT = Path(__file__).parents[1]


@pytest.mark.skipif(
    importlib.util.find_spec("hatchling") is None, reason="hatchling, which builds it, is not installed"
)
def test_the_wheel_has_every_file_and_the_students_notebooks(tmp_path: Path) -> None:
    """A pattern in `.gitignore` may leave out a whole folder, which an editable installation hides."""
    command = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(tmp_path)]
    made = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    (wheel,) = tmp_path.glob("*.whl")
    assert subprocess.run([sys.executable, "-m", "twine", "check", "--strict", str(wheel)]).returncode == 0
    (metadata,) = (name for name in zipfile.ZipFile(wheel).namelist() if name.endswith("/METADATA"))
    readme = zipfile.ZipFile(wheel).read(metadata).decode()
    assert re.findall(r"\]\((?!https://)", readme) == []  # its links lead somewhere on PyPI too
    inside = {name for name in zipfile.ZipFile(wheel).namelist() if name.startswith(("edugym/", "edugym_course/"))}
    sources = [path for path in (ROOT / "src").rglob("*") if path.is_file() and path.suffix != ".pyc"]
    sources = [path for path in sources if "answers" not in path.parts and not path.name[0].isdigit()]
    sources = [path for path in sources if path.name not in ("report.txt", "cells.txt")]
    expected = {path.relative_to(ROOT / "src").as_posix() for path in sources}
    notebooks = {f"edugym_course/lab/notebooks/{path.name}" for path in (ROOT / "notebooks").glob("*.ipynb")}
    assert notebooks
    assert inside == expected | notebooks


def test_the_version_is_the_same_everywhere() -> None:
    """A release changes it in the code, in the package, in the citation and in the changelog, there with its date."""
    project, citation, changelog = (
        (ROOT / name).read_text(encoding="utf-8") for name in ("pyproject.toml", "CITATION.cff", "CHANGELOG.md")
    )
    cited = dict(re.findall(r"^(version|date-released): (\S+)$", citation, re.MULTILINE))
    released, date = re.findall(r"^## \[(\d\S*)\] - (\S+)$", changelog, re.MULTILINE)[0]
    assert {edugym.__version__, cited["version"], released} == {tomllib.loads(project)["project"]["version"]}
    assert cited["date-released"] == date


def test_tests_that_begin_too_late_are_skipped() -> None:
    """So that a machine whose time is limited still says what has passed, and how much was not run."""
    out = _tested("tests/test_seeds.py", "--begin-until=5")
    assert "the time for tests was over" in out
    assert "passed" not in out


@pytest.mark.slow
def test_limited_time_begins_with_other_files() -> None:
    """Each run of limited time takes files in another order, the same in all its processes, and whole."""
    first, again, other = (
        [
            line.partition("::")
            for line in _tested("tests/system", "--collect-only", *until).splitlines()
            if "::" in line
        ]
        for until in (["--begin-until=1"], ["--begin-until=1"], ["--begin-until=2"])
    )
    assert first == again != other
    assert sorted(first) == sorted(other)
    for tests in (first, other):
        files = [file for file, _ in itertools.groupby(tests, key=lambda test: test[0])]
        assert len(files) == len(set(files)) > 2


@pytest.mark.slow
@pytest.mark.parametrize("hang", ["while True: pass", "all(itertools.repeat(1))"])
def test_a_test_that_hangs_is_named_and_the_others_pass(tmp_path: Path, hang: str) -> None:
    """Also where it hangs when it is run again, and where it never returns to Python, which no signal interrupts."""
    tests = tmp_path / "test_hang.py"
    tests.write_text(f"import itertools\n\ndef test_other(): pass\n\ndef test_hang():\n    {hang}\n", encoding="utf-8")
    limits = ["-o", "timeout=2", "-o", "faulthandler_timeout=6", "--reruns=1", "--only-rerun=Timeout", "-n1"]
    out = _tested(str(tests), "-c", str(ROOT / "pyproject.toml"), "-p", "tests.conftest", *limits, code=1)
    assert "1 failed, 1 passed" in out
    assert "::test_hang" in out


PROGRAM = """
from typing import NamedTuple, assert_type

import edugym
import gymnasium
import numpy as np
from edugym import QLearning, Run, train


class Counting(NamedTuple):
    visits: np.ndarray[tuple[int, ...], np.dtype[np.int64]]

    def act(self, state: int, rng: np.random.Generator) -> int:
        return int(rng.integers(2))

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        self.visits[state] += 1


env: gymnasium.Env[int, int] = gymnasium.make("edugym/Boulder-v0", height=5)
agent = QLearning.create(env, learning_rate=0.5)
run = train(env, agent, 1_000, seed=1)
assert_type(run, Run)
assert_type(agent, QLearning)
print(run.returns[-1], agent.Q.sum())
print(edugym.train(env, Counting(np.zeros(6, np.int64)), 100).steps[-1])


def wrong() -> None:  # and known to be wrong: else mypy would say that the comments are not needed
    train(env, agent, "many")  # type: ignore[arg-type]
    edugym.no_such_name  # type: ignore[attr-defined]
"""


@pytest.mark.slow
def test_a_users_program_passes_mypy_strict_and_runs(tmp_path: Path) -> None:
    """So do the examples of pages that name every type: with the installed package, in a folder without settings."""
    pytest.importorskip("mypy")
    (tmp_path / "program.py").write_text(PROGRAM, encoding="utf-8")
    typed = [code for _, code, _ in EXAMPLES if not re.search("def |class |lambda|stable_baselines3", code)]
    assert len(typed) >= 10
    names = ["program.py", *(f"example_{k}.py" for k in range(len(typed)))]
    for name, code in zip(names[1:], typed, strict=True):
        (tmp_path / name).write_text(code, encoding="utf-8")
    for command in (["-m", "mypy", "--strict", *names], ["program.py"]):
        done = subprocess.run([sys.executable, *command], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr


def _tested(*arguments: str, code: int = 0) -> str:
    """What pytest says that runs with these arguments, and ends with this code."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == code, done.stdout
    return done.stdout

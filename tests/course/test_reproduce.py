"""The command `edugym reproduce`: what it writes, what it says, its exit status, and how it goes on."""

import warnings
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pandas as pd
import pytest

from edugym.experiments.checkpoints import CHECKPOINTS
from edugym.experiments.figures import Lines, Sheet
from edugym.experiments.results.claims import Above, Claim
from edugym.experiments.results.statistics import Interval
from edugym_course import commands
from edugym_course.report import Report
from tests.course.test_commands import run


def claim(share: float) -> Claim:
    """A claim that holds for a share above 0.6."""
    return Claim(
        "It works",
        "share",
        Interval(share, share - 0.1, share + 0.1, 9),
        Above(0.5),
        "why",
        ("It works",),
        "as the paper says",
    )


class Lesson(SimpleNamespace):
    """Something.

    This is how.
    """

    def report(self, **how: Any) -> Report:
        """Note how, warn, save a file, and draw a figure."""
        self.asked.append(how)
        for _ in range(2):
            warnings.warn("a slow one", stacklevel=1)
        (how["folder"] / "runs.csv").write_text(f"{len(self.asked)}")
        (how["folder"] / CHECKPOINTS).mkdir(exist_ok=True)
        x = np.arange(3.0)
        return Report(self.claims, [Sheet("picture", [[Lines(x, {"A": x}, "line")]])])


@pytest.fixture
def lesson(monkeypatch: pytest.MonkeyPatch) -> Lesson:
    """The only lesson, which takes no time: what it claims can be set, and what it was asked for is kept."""
    made = Lesson(claims=[claim(0.9)], asked=[])
    monkeypatch.setattr(commands, "load_experiments", lambda name: made)
    monkeypatch.setattr(commands, "lesson_names", lambda: ["made_up"])
    return made


def names(folder: Path) -> list[str]:
    """What is in it."""
    return sorted(path.name for path in folder.iterdir())


def test_what_it_writes_and_says(lesson: Lesson, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By default in the folder `results`: figures in both forms, the claims as a table and a file, and status 0."""
    monkeypatch.chdir(tmp_path)
    result = run("reproduce")
    assert result.exit_code == 0, result.output
    assert lesson.asked == [{"seed": 0, "jobs": -1, "progress": False, "folder": Path("results/made_up.unfinished")}]
    assert names(tmp_path / "results") == ["made_up", "report.md"]
    folder = tmp_path / "results" / "made_up"
    assert names(folder) == ["claims.csv", "picture.png", "picture.svg", "runs.csv"]
    assert pd.read_csv(folder / "claims.csv").to_dict("records") == [
        {"statement": "It works", "quantity": "share", "expected": "> 0.5", "reason": "why"}
        | {"tested_by": 1, "remark": "as the paper says"}
        | {"estimate": 0.9, "low": 0.8, "high": 1.0, "n": 9, "holds": True}
    ]
    for part in ("made_up", "It works", "share", "0.9 [0.8, 1]", "> 0.5", "yes", "why", "results/made_up"):
        assert part in result.stdout
    assert result.stderr == "edugym: a slow one\n"  # it came twice


def test_a_claim_that_does_not_hold(lesson: Lesson, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One is enough for status 1, and it is said; the others run all the same. The report has those of all commands."""
    monkeypatch.setattr(commands, "lesson_names", lambda: ["one", "two", "three"])
    options = ("--repetitions", "2", "--seed", "3", "--jobs", "1000")
    assert run("reproduce", "one", "--output", str(tmp_path), *options).exit_code == 0
    assert lesson.asked[0].items() > {"repetitions": 2, "seed": 3, "jobs": 1000}.items()
    lesson.claims = [claim(0.9), claim(0.55)]
    result = run("reproduce", "two", "--output", str(tmp_path))
    assert (result.exit_code, "NO" in result.stdout) == (1, True)
    said = (tmp_path / "report.md").read_text()
    assert "| [one](#one) | 1 of 1 | 1 of 1 |" in said
    assert "| [two](#two) | 1 of 2 | 2 of 2 |" in said
    assert "three" not in said
    for name in ("one", "two"):
        assert f'<a id="{name}"></a>\n\n## Something.\n\nThis is how.\n\n|  | claim' in said
        assert f"![picture]({name}/picture.svg)" in said
    left = iter([[claim(0.9)], [claim(0.55)], [claim(0.9)]])
    monkeypatch.setattr(Lesson, "report", lambda lesson, **how: Report(next(left), []))
    assert run("reproduce", "--output", str(tmp_path / "all")).exit_code == 1
    assert names(tmp_path / "all") == ["one", "report.md", "three", "two"]


def test_ctrl_c_is_status_130(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No lesson follows the one that was interrupted, and it is said where errors are."""
    asked = []

    def report(**how: Any) -> Report:
        asked.append(how)
        raise KeyboardInterrupt

    monkeypatch.setattr(commands, "load_experiments", lambda name: SimpleNamespace(report=report))
    monkeypatch.setattr(commands, "lesson_names", lambda: ["one", "two"])
    result = run("reproduce", "--output", str(tmp_path))
    assert (result.exit_code, result.stdout, len(asked)) == (130, "", 1)
    assert str(tmp_path) in result.stderr


def test_an_unfinished_rerun_leaves_complete_results_as_they_are(
    lesson: Lesson, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It works in a folder of its own, in which only finished runs outlast it; a complete rerun takes the place."""
    folder, unfinished = tmp_path / "made_up", tmp_path / "made_up.unfinished"

    def contents() -> dict[str, bytes]:
        return {path.name: path.read_bytes() for path in folder.iterdir()}

    arguments = ("reproduce", "made_up", "--output", str(tmp_path))
    assert run(*arguments).exit_code == 0
    complete = contents()

    def full_disk(figure: Any, path: Path) -> None:
        path.write_text("half a figure")
        raise OSError("no space left")

    with monkeypatch.context() as patched:
        patched.setattr("edugym.experiments.figures.save_figure", full_disk)
        assert run(*arguments).exit_code != 0
    assert contents() == complete
    assert names(unfinished) == [CHECKPOINTS, "picture", "runs.csv"]
    written: list[tuple[str, bool]] = []

    def watched(path: Path, contents: bytes) -> Path:
        written.append((path.name, (folder / commands.CLAIMS).exists()))
        path.write_bytes(contents)
        return path

    monkeypatch.setattr(commands, "write_whole", watched)
    lesson.claims = [claim(0.95)]
    assert run(*arguments).exit_code == 0
    files = [(name, False) for name in ("picture.png", "picture.svg", "runs.csv", "claims.csv")]
    assert written == [("claims.csv", True), *files, ("report.md", True)]  # where claims are, all beside them is theirs
    assert contents().keys() == complete.keys()
    assert contents()["claims.csv"] != complete["claims.csv"]
    assert not unfinished.exists()


def test_what_an_unfinished_command_left_goes(tmp_path: Path) -> None:
    """Files, folders and links; the finished runs stay, and so does what a link leads to."""
    folder, other = tmp_path / "unfinished", tmp_path / "other"
    for path in (folder / CHECKPOINTS, folder / "a folder" / "in it", other):
        path.mkdir(parents=True)
        (path / "file").touch()
    (folder / "a link").symlink_to(other)
    (folder / "a file").touch()
    commands._clear(folder, keep=CHECKPOINTS)
    assert names(folder) == [CHECKPOINTS]
    assert names(folder / CHECKPOINTS) == names(other) == ["file"]

"""The command `edugym`: what it writes, what it says, and its exit status."""

import errno
import inspect
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pandas as pd
import pytest
from typer.testing import CliRunner, Result

from edugym.adapters.registration import ENVIRONMENTS
from edugym.experiments.checkpoints import CHECKPOINTS
from edugym.experiments.figures import Lines, Sheet
from edugym.experiments.results.claims import Above, Claim
from edugym.experiments.results.statistics import Interval
from edugym_course import commands
from edugym_course.commands import app
from edugym_course.report import Report


def run(*arguments: str) -> Result:
    """The command in this process, on a wide terminal."""
    return CliRunner(env={"COLUMNS": "200"}).invoke(app, arguments)


ABOUT = "Something.\n\nThis is how."


@pytest.fixture
def lesson(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """A lesson that takes no time: what it claims can be set, and what it was asked for is kept."""
    asked: dict[str, Any] = {"shares": (0.9,)}

    def report(**how: Any) -> Report:
        asked.update(how)
        x = np.arange(3.0)
        claims = [
            Claim("It works", "share", Interval(s, s - 0.1, s + 0.1, 9), Above(0.5), "why") for s in asked["shares"]
        ]
        return Report(claims, [Sheet("picture", [[Lines(x, {"A": x}, "line")]])])

    monkeypatch.setattr(
        "edugym_course.commands.load_experiments", lambda name: SimpleNamespace(report=report, __doc__=ABOUT)
    )
    monkeypatch.setattr("edugym_course.commands.lesson_names", lambda: ["made_up"])
    return asked


def test_list_has_every_environment() -> None:
    """With its challenge and the defaults of its parameters."""
    said = run("list").output
    assert len(ENVIRONMENTS) > 0
    for entry in ENVIRONMENTS:
        assert entry.id in said
        assert entry.challenge in said
    words = " ".join(said.split())
    for name, parameter in inspect.signature(ENVIRONMENTS[0].load()).parameters.items():
        assert (f"{name} ({parameter.default})" in words) is (name != "render_mode")


def test_without_a_command_there_is_help() -> None:
    """What there is to do, and nothing about completion in shells."""
    said = run()
    assert "reproduce" in said.output
    assert "list" in said.output
    assert "completion" not in said.output


def test_reproduce_writes_and_says_what_holds(lesson: dict[str, Any], tmp_path: Path) -> None:
    """Figures in both forms, the claims as a table and a file, and status 0."""
    result = run("reproduce", "made_up", "--output", str(tmp_path), "--repetitions", "7", "--seed", "3", "--jobs", "1")
    assert result.exit_code == 0, result.output
    assert (lesson["repetitions"], lesson["seed"], lesson["jobs"]) == (7, 3, 1)
    assert lesson["folder"] == tmp_path / "made_up.unfinished"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["made_up", "report.md"]
    assert sorted(path.name for path in (tmp_path / "made_up").iterdir()) == [
        "claims.csv",
        "picture.png",
        "picture.svg",
    ]
    (claim,) = pd.read_csv(tmp_path / "made_up" / "claims.csv").to_dict("records")
    assert (claim["statement"], claim["low"], claim["expected"], claim["holds"]) == ("It works", 0.8, "> 0.5", True)
    for part in ("It works", "0.9 [0.8, 1]", "> 0.5", "yes", "why", str(tmp_path)):
        assert part in result.output


def test_reproduce_writes_a_report(lesson: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It shows the claims and figures of all lessons with results in the folder, also of earlier commands."""
    lesson["shares"] = (0.9, 0.55)
    monkeypatch.setattr("edugym_course.commands.lesson_names", lambda: ["made_up", "other", "never_run"])
    for name in ("made_up", "other"):
        run("reproduce", name, "--output", str(tmp_path))
    said = (tmp_path / "report.md").read_text()
    assert "| [made_up](#made_up) | 1 of 2 |" in said
    assert "| It works — why | 0.9 [0.8, 1]: share | > 0.5 | yes |" in said
    assert "| 0.55 [0.45, 0.65]: share | > 0.5 | **NO** |" in said
    assert "never_run" not in said
    for name in ("made_up", "other"):
        assert f'<a id="{name}"></a>\n\n## Something.\n\nThis is how.\n\n| claim' in said
        assert f"![picture]({name}/picture.svg)" in said
        assert (tmp_path / name / "picture.svg").exists()


def test_a_claim_that_does_not_hold_is_status_1(lesson: dict[str, Any], tmp_path: Path) -> None:
    """One is enough, and it is said."""
    lesson["shares"] = (0.9, 0.55)
    result = run("reproduce", "made_up", "--output", str(tmp_path))
    assert result.exit_code == 1
    assert "NO" in result.output
    assert "repetitions" not in lesson  # the lesson's own number


def test_all_lessons_by_default(lesson: dict[str, Any], tmp_path: Path) -> None:
    """Each in a folder of its own."""
    assert run("reproduce", "--output", str(tmp_path)).exit_code == 0
    assert (tmp_path / "made_up" / "claims.csv").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["explore"], "'explore' is none of: loop, exploration"),
        (["exploration", "--repetitions", "1"], "--repetitions"),
        (["exploration", "--seed", "-1"], "--seed"),
        (["exploration", "--jobs", "0"], "--jobs"),
        (["exploration", "--jobs", "100000000"], "--jobs"),
        (["exploration", "--output", ""], "the path is empty"),
        (["exploration", "--colour"], "--colour"),
    ],
)
def test_bad_usage_is_status_2(arguments: list[str], said: str, tmp_path: Path) -> None:
    """And names what is wrong, before anything is written."""
    result = run("reproduce", "--output", str(tmp_path / "new"), *arguments)
    assert result.exit_code == 2
    assert said in result.output
    assert not (tmp_path / "new").exists()


def test_an_unwritable_folder_is_status_2(lesson: dict[str, Any], tmp_path: Path) -> None:
    """Before anything is computed."""
    (tmp_path / "file").write_text("")
    result = run("reproduce", "made_up", "--output", str(tmp_path / "file"))
    assert result.exit_code == 2
    assert "cannot write to" in result.output
    assert "folder" not in lesson


def test_ctrl_c_is_status_130(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No lesson follows the one that was interrupted."""
    asked = []

    def report(**how: Any) -> Report:
        asked.append(how)
        raise KeyboardInterrupt

    monkeypatch.setattr("edugym_course.commands.load_experiments", lambda name: SimpleNamespace(report=report))
    monkeypatch.setattr("edugym_course.commands.lesson_names", lambda: ["one", "two"])
    result = run("reproduce", "--output", str(tmp_path))
    assert result.exit_code == 130
    assert f"interrupted; what is done is kept in {tmp_path}" in result.output
    assert len(asked) == 1


def test_an_unfinished_rerun_leaves_complete_results_as_they_are(
    lesson: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It works in a folder of its own, in which only finished runs outlast it; a complete rerun takes the place."""

    def contents() -> dict[str, bytes]:
        return {path.name: path.read_bytes() for path in (tmp_path / "made_up").iterdir()}

    arguments = ("reproduce", "made_up", "--output", str(tmp_path))
    assert run(*arguments).exit_code == 0
    complete, unfinished = contents(), tmp_path / "made_up.unfinished"

    def full_disk(figure: Any, path: Path) -> None:
        path.write_text("half a figure")
        (unfinished / CHECKPOINTS).mkdir()
        raise OSError("no space left")

    lesson["shares"] = (0.95,)
    with monkeypatch.context() as patched:
        patched.setattr("edugym.experiments.figures.save_figure", full_disk)
        assert run(*arguments).exit_code != 0
    assert contents() == complete
    assert sorted(path.name for path in unfinished.iterdir()) == [CHECKPOINTS, "picture"]
    assert run(*arguments).exit_code == 0
    assert contents().keys() == complete.keys()
    assert contents() != complete
    assert not unfinished.exists()


def test_a_parameter_is_set_once() -> None:
    """Of two values one would silently win."""
    result = run("play", "Boulder", "--set", "height=3", "--set", "height=4")
    assert result.exit_code == 2
    assert "parameter height must be set once, but is set twice" in result.output


def test_a_film_needs_a_path() -> None:
    """An empty one would be the current folder."""
    result = run("play", "Boulder", "--gif", "")
    assert result.exit_code == 2
    assert "the path is empty" in result.output


COMMAND = [sys.executable, "-m", "edugym"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
def test_output_that_cannot_be_written_is_one_line() -> None:
    """No traceback, neither by the command nor by Python at its end."""
    with open("/dev/full", "w") as full:
        done = subprocess.run([*COMMAND, "list"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert (done.returncode, done.stderr) == (1, f"edugym: cannot write the output: {os.strerror(errno.ENOSPC)}\n")


def test_a_reader_that_leaves_is_no_error() -> None:
    """As in `edugym list | head -1`."""
    read, write = os.pipe()
    os.close(read)
    with os.fdopen(write, "w") as pipe:
        done = subprocess.run([*COMMAND, "list"], stdout=pipe, stderr=subprocess.PIPE, text=True, check=False)
    assert done.stderr == ""


INTERRUPTED_IMPORT = """
import signal, sys

class Interrupting:
    def find_spec(self, name, *_):
        if name == "typer":
            signal.raise_signal(signal.SIGINT)

sys.meta_path.insert(0, Interrupting())
signal.signal(signal.SIGINT, signal.default_int_handler)
from edugym_course.cli import main
main()
"""


def test_ctrl_c_before_the_experiments(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Typer alone would end with the status and no word, and Python would wait for threads that still compile."""

    class AtOnce(Exception):
        pass

    def press() -> list[str]:
        raise KeyboardInterrupt

    def end_at_once(status: int) -> None:
        raise AtOnce(status)

    monkeypatch.setattr("edugym_course.commands.lesson_names", press)
    monkeypatch.setattr(sys, "argv", ["edugym", "reproduce"])
    monkeypatch.setattr(os, "_exit", end_at_once)
    with pytest.raises(AtOnce, match="130"):
        commands.run()
    assert capsys.readouterr().err == "edugym: interrupted\n"


def test_ctrl_c_while_it_starts() -> None:
    """One line, no traceback."""
    done = subprocess.run([sys.executable, "-c", INTERRUPTED_IMPORT], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (130, "edugym: interrupted\n")


def test_without_typer_it_says_what_to_install() -> None:
    """One line, no traceback."""
    code = "import sys; sys.modules['typer'] = None; import edugym_course.commands"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr == 'edugym: typer is not installed, run `pip install "edugym[experiments]"`\n'


def test_without_ipywidgets_notebooks_say_what_to_install() -> None:
    """In place of a module that is missing somewhere within."""
    code = "import sys; sys.modules['ipywidgets'] = None; import edugym_course.notebook"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1].endswith('ipywidgets is not installed, run `pip install "edugym[notebook]"`')


@pytest.mark.slow
def test_the_same_command_goes_on(tmp_path: Path) -> None:
    """Interrupted, killed, and then left to its end, it writes the files of one that was never disturbed."""
    code = """
import signal
from edugym_course.cli import main
from edugym_course.lessons.exploration import experiments

experiments.HEIGHTS, experiments.N_STEPS, experiments.RANDOM_SEARCH = (3, 4), 2_000, ((2, 4),)
experiments.compare.__kwdefaults__["n_steps"] = 2_000
signal.signal(signal.SIGINT, signal.default_int_handler)
main()
"""

    def command(output: str) -> subprocess.Popen[str]:
        arguments = ["reproduce", "exploration", "--repetitions", "8", "--output", str(tmp_path / output)]
        return subprocess.Popen([sys.executable, "-c", code, *arguments], stderr=subprocess.PIPE, text=True)

    unfinished = tmp_path / "b" / "exploration.unfinished"
    for number, runs in ((signal.SIGINT, 5), (signal.SIGKILL, 30)):
        with command("b") as child:
            while len(list(unfinished.glob("checkpoints/*.run"))) < runs and child.poll() is None:
                threading.Event().wait(0.01)
            child.send_signal(number)
            assert child.stderr is not None
            said = child.stderr.read()
        if number == signal.SIGINT:
            assert child.returncode == 130, said
            assert f"interrupted; what is done is kept in {tmp_path / 'b'}" in said
    for output in ("a", "b"):
        with command(output) as child:
            child.communicate(timeout=120)
        assert child.returncode in (0, 1)
        assert sorted(path.name for path in (tmp_path / output).iterdir()) == ["exploration", "report.md"]
    one, other = (
        {path.name: path.read_bytes() for path in (tmp_path / output / "exploration").iterdir()} for output in "ab"
    )
    assert one == other

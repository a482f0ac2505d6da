"""The command `edugym`: its tables, what it hands on, and what it says when something goes wrong."""

import errno
import inspect
import io
import os
import re
import subprocess
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest
from rich.console import Console
from typer.testing import CliRunner, Result

from edugym.adapters import playing
from edugym.adapters.registration import in_course_order
from edugym_course import commands
from edugym_course.lab import server
from edugym_course.warned import warnings_said_at_once


def run(*arguments: str, keys: str = "") -> Result:
    """The command in this process, on a wide terminal."""
    return CliRunner(env={"COLUMNS": "200"}).invoke(commands.app, arguments, input=keys)


def test_the_list(monkeypatch: pytest.MonkeyPatch) -> None:
    """A line for each environment in the order of the course: its id, its challenge, and all defaults."""
    monkeypatch.setattr(commands, "Console", lambda: Console(width=1000))
    first, *lines = run("list").output.splitlines()
    starts = [first.index(head) for head in ("challenge", "parameters")]
    for line, entry in zip(lines, in_course_order(), strict=True):
        assert [line[: starts[0]].strip(), line[starts[0] : starts[1]].strip()] == [entry.id, entry.challenge]
        parameters = inspect.signature(entry.load()).parameters
        assert re.findall(r"(?:^|\), )(\w+) \(", line[starts[1] :].strip()) == [
            name for name in parameters if name != "render_mode"
        ]
    assert "action_scale (0.2094)" in "".join(lines)  # π / 15, rounded


def test_without_a_command_there_is_help() -> None:
    """What there is to do, and nothing about completion in shells."""
    said = run().output
    assert all(command in said for command in ("list", "play", "reproduce", "lab"))
    assert "completion" not in said
    assert not commands.app.pretty_exceptions_enable  # a traceback without the values of all variables


def test_play_hands_everything_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """The parameters, the seed, how to draw, and where the film goes."""
    made: list[Any] = []

    def game(env: Any, seed: Any) -> str:
        made.append((env.unwrapped.mdp.height, seed))
        return "the game"

    monkeypatch.setattr(playing, "Game", game)
    monkeypatch.setattr(playing, "play", lambda *one, **how: made.append((*one, how)))
    arguments = ("--set", "height=4", "--seed", "7", "--render", "human", "--gif", "a.gif")
    assert run("play", "Boulder", *arguments).exit_code == 0
    assert run("play", "Boulder").exit_code == 0
    options = [{"render": "human", "gif": Path("a.gif")}, {"render": "ansi", "gif": None}]
    assert made == [(4, 7), ("the game", options[0]), (10, None), ("the game", options[1])]


def test_playing() -> None:
    """Parameters are numbers, texts and truth values; keys come as lines."""
    played = run("play", "Boulder", "--set", "height=2", "--set", "n_grips=3", "--seed", "1", keys="0\n1\nq\n")
    assert (played.exit_code, played.output.count("[2] grip 2")) == (0, 3)
    assert "step 2: grip 1" in played.output
    lake = run("play", "FrozenLake-v1", "--set", "is_slippery=False", "--set", "map_name=8x8", keys="2\n")
    assert lake.output.count("observation 1,") == 2
    assert run("play", "Tamagotchi", "--set", "tau=inf").exit_code == 0


@pytest.mark.parametrize(
    ("line", "names"),
    [
        ("play Bolder", "Bolder"),
        ("play Boulder --set seed=3", "'seed'"),
        ("play Boulder --set height=low", "height"),
        ("play Boulder --set heigth=2", "heigth"),
        ("play Tamagotchi --set tau=nan", "tau"),
        ("play Boulder --gif /proc/x.gif", "/proc/x.gif"),
        ("play Boulder --gif boulder.mp4", ".gif"),
        ("play Boulder --gif=", "path is empty"),
        ("play Boulder --render svg", "ansi"),
        ("play Boulder --seed -1", "'--seed'"),
        ("play missing.py", "No such file"),
        ("reproduce explore", "LESSON: 'explore' is none of: loop, bandits, exploration"),
        ("reproduce loop --repetitions 1", "'--repetitions'"),
        ("reproduce loop --seed -1", "'--seed'"),
        ("reproduce loop --jobs 0", "--jobs: 0"),
        ("reproduce loop --jobs -2", "'--jobs'"),
        ("reproduce loop --jobs 1001", "'--jobs'"),
        ("reproduce loop --output=", "path is empty"),
        ("reproduce loop --output file", "--output: cannot write to file"),
        ("reproduce loop --colour", "--colour"),
        ("lab a b", "DIRECTORY: one folder is enough, but there are a, b"),
        ("lab file", "DIRECTORY: cannot write to file"),
        ("lab file/in/it", "DIRECTORY: cannot write to file/in/it"),
        ("lab --port -1", "'--port'"),
        ("lab --port 65536", "'--port'"),
    ],
)
def test_bad_usage_is_status_2(line: str, names: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And names what is wrong, with its argument, before anything is computed or written."""
    monkeypatch.setattr(server, "serve", lambda folder, options: pytest.fail("started"))
    monkeypatch.setattr(commands, "load_experiments", lambda name: pytest.fail("begun"))
    monkeypatch.chdir(tmp_path)
    Path("file").touch()
    refused = run(*line.split())
    assert refused.exit_code == 2
    assert names in refused.stderr
    assert os.listdir() == ["file"]


@pytest.mark.parametrize(
    ("line", "options"),
    [
        ("lab", ("edugym-lessons", [])),
        ("lab --ServerApp.ip=0.0.0.0 elsewhere", ("elsewhere", ["--ServerApp.ip=0.0.0.0"])),
        ("lab --no-browser --port 65535", ("edugym-lessons", ["--no-browser", "--port=65535"])),
        ("lab --port 0", ("edugym-lessons", ["--port=0"])),
    ],
)
def test_lab_hands_everything_on(
    line: str, options: tuple[str, list[str]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Options of JupyterLab go to JupyterLab; a line for each lesson with a newer version, and where all are."""
    served: list[Any] = []
    monkeypatch.setattr(server, "prepare", lambda folder: ["one is new", "two is new"])
    monkeypatch.setattr(server, "serve", lambda folder, options: served.append((str(folder), options)))
    monkeypatch.chdir(tmp_path)
    said = run(*line.split())
    assert (said.exit_code, served) == (0, [options])
    *new, where = said.stdout.splitlines()
    assert new == ["edugym: one is new", "edugym: two is new"]
    assert str(tmp_path / options[0]) in where


def test_a_warning_is_said_when_it_comes(capsys: pytest.CaptureFixture[str]) -> None:
    """Not at the end of the command, and once."""
    with warnings_said_at_once():
        for said in ("edugym: it is slow\n", ""):
            warnings.warn("it is slow", stacklevel=1)
            assert capsys.readouterr().err == said


NO_SPACE = OSError(errno.ENOSPC, "No space left")


@pytest.mark.parametrize(
    ("app", "error", "ends"),
    [
        (lambda: None, NO_SPACE, "edugym: cannot write the output: No space left"),
        (lambda: None, OSError(errno.EIO, "broken", "a.csv"), "edugym: [Errno 5] broken: 'a.csv'"),
        (lambda: None, OSError("cannot write to a.csv: it is"), "edugym: cannot write to a.csv: it is"),
        (lambda: None, BrokenPipeError(errno.EPIPE, "Broken pipe"), 1),
        (lambda: sys.exit(2), NO_SPACE, 2),
        (lambda: sys.exit(0), NO_SPACE, "edugym: cannot write the output: No space left"),
    ],
)
def test_output_that_fails(
    app: Callable[[], None], error: OSError, ends: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """One line says why, unless the command has failed already and said so, or nobody reads."""
    monkeypatch.setattr(commands, "app", app)
    with (tmp_path / "output").open("w") as output:
        flush = Mock(side_effect=error)
        monkeypatch.setattr(sys, "stdout", Mock(fileno=output.fileno, flush=flush, write=io.StringIO().write))
        with pytest.raises(SystemExit) as ended:
            commands.run()
        assert os.fstat(output.fileno()).st_rdev == os.stat(os.devnull).st_rdev  # Python's own last flush is lost
    assert ended.value.code == ends


def test_ctrl_c_in_a_command(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Typer alone would end with the status and no word, and Python would wait for threads that still compile."""

    def press() -> list[str]:
        raise KeyboardInterrupt

    def end_at_once(status: int) -> None:
        raise EOFError(status)

    monkeypatch.setattr("edugym_course.commands.lesson_names", press)
    monkeypatch.setattr(sys, "argv", ["edugym", "reproduce"])
    monkeypatch.setattr(os, "_exit", end_at_once)
    with pytest.raises(EOFError, match="130"):
        commands.run()
    assert capsys.readouterr().err == "edugym: interrupted\n"


PRESSED_WHILE_IMPORTING = """
import signal, sys

class Interrupting:
    def find_spec(self, name, *_):
        if name == "typer":
            signal.raise_signal(signal.SIGINT)

sys.meta_path.insert(0, Interrupting())
signal.signal(signal.SIGINT, signal.default_int_handler)
"""
MAIN = "from edugym_course.cli import main; sys.argv = ['edugym', *sys.argv[1:]]; main()"


@pytest.mark.parametrize(
    ("code", "status", "says"),
    [
        (PRESSED_WHILE_IMPORTING + MAIN, 130, r"edugym: interrupted\n"),
        ("import sys; sys.modules['typer'] = None; import edugym_course.commands", 1, "edugym: typer .*experiments.*"),
        ("import sys; sys.modules['ipywidgets'] = None; import edugym_course.notebook", 1, "Traceback.*notebook.*"),
        (f"import sys; sys.modules['jupyterlab'] = None; {MAIN}", 1, "edugym: jupyterlab .*lab.*"),
    ],
    ids=["interrupted", "typer", "ipywidgets", "jupyterlab"],
)
def test_a_start_that_fails(code: str, status: int, says: str, tmp_path: Path) -> None:
    """One line, no traceback (but in a notebook, which shows one anyway), and nothing is written."""
    done = subprocess.run([sys.executable, "-c", code, "lab"], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == status
    assert re.fullmatch(says, done.stderr, re.DOTALL)
    assert "pip install" in done.stderr.splitlines()[-1] or status == 130
    assert done.stderr.count("\n") == 1 or "notebook" in done.stderr
    assert os.listdir(tmp_path) == []

"""The command `edugym`: its tables, what it hands on, and what it says when something goes wrong."""

import errno
import inspect
import io
import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from gymnasium.error import DependencyNotInstalled
from rich.console import Console

from edugym.adapters import playing
from edugym.adapters.registration import in_course_order
from edugym.experiments.checkpoints import CHECKPOINTS
from edugym.experiments.results.claims import Below, Claim, Within
from edugym.experiments.results.statistics import Interval
from edugym_course import commands
from edugym_course.lab import server
from edugym_course.report import Report
from tests.course.test_cli import run

CLAIM = Claim("Fails seldom", "share of failures", Interval(0.25, 0.125, 0.5, 9), Below(0.75), "by design")
FILE = """\
statement,quantity,expected,reason,estimate,low,high,n,holds
Fails seldom,share of failures,< 0.75,by design,0.25,0.125,0.5,9,True
"""
TABLE = """\
made_up
claim measured, with 95 % interval expected holds
─
Fails seldom 0.25 [0.125, 0.5] < 0.75 yes
by design share of failures
"""

NARROW = """\
made_up

            measur…
            with 95
            %
 claim      interv…   expected      holds
 ────────────────────────────────────────
 Fails      0.25      < 0.75        yes
 seldom     [0.125,
 by         0.5]
 design     share
            of
            failur…

 Another    0.25      0.3 to 1.25   NO
 one        [0.125,
            0.5]
            share
            of
            failur…

"""


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    """What a made-up lesson is asked for, one dictionary a command; it warns, saves a file and makes one claim."""
    calls: list[dict[str, Any]] = []

    def report(**how: Any) -> Report:
        import warnings

        calls.append(how)
        for _ in range(2):
            warnings.warn("a slow one", stacklevel=1)
        (how["folder"] / "runs.csv").write_text(f"{len(calls)}")
        (how["folder"] / CHECKPOINTS).mkdir(exist_ok=True)
        return Report([CLAIM], [])

    monkeypatch.setattr(commands, "load_experiments", lambda name: SimpleNamespace(report=report, __doc__="About."))
    monkeypatch.setattr(commands, "lesson_names", lambda: ["made_up"])
    return calls


def in_words(text: str) -> list[str]:
    """Lines with single blanks and single rules, without those that are empty."""
    lines = (" ".join(line.replace("─", " ─ ").split()) for line in text.splitlines())
    return ["─" if line.startswith("─") else line for line in lines if line]


def test_the_list_is_in_the_order_of_the_course() -> None:
    """A line with the heads, then one or more for each environment, which begins with its id."""
    lines = run("list").output.splitlines()
    assert lines[0].split("  ")[0] == "id"
    assert lines[0].split() == ["id", "challenge", "parameters", "(default)"]
    ids = [line.split()[0] for line in lines[1:] if line and not line.startswith(" ")]
    assert ids == [entry.id for entry in in_course_order()]
    assert "action_scale (0.2094)" in run("list").output  # π / 15, rounded


def test_each_column_of_the_list_has_what_its_head_says(monkeypatch: pytest.MonkeyPatch) -> None:
    """In a terminal so wide that every environment takes one line."""
    monkeypatch.setattr(commands, "Console", lambda: Console(width=1000))
    first, *lines = run("list").output.splitlines()
    starts = [first.index(head) for head in ("challenge", "parameters (default)")]
    for line, entry in zip(lines, in_course_order(), strict=True):
        assert line[: starts[0]].strip() == entry.id
        assert line[starts[0] : starts[1]].strip() == entry.challenge
        assert line[starts[1] :].startswith(f"{next(iter(inspect.signature(entry.load()).parameters))} (")


@pytest.mark.parametrize(
    ("text", "value"),
    [("3", 3), ("0.5", 0.5), ("inf", float("inf")), ("None", None), ("[1, 2]", [1, 2]), ("north", "north"), ("", "")],
)
def test_values_are_read_as_python_where_they_can_be(text: str, value: Any) -> None:
    """And else as texts."""
    (read,) = commands._parameters([f"name={text}"]).values()
    assert (type(read), read) == (type(value), value)


@pytest.mark.parametrize("text", ["height", "=3", "1x=3", "a b=3"])
def test_a_parameter_is_a_name_and_a_value(text: str) -> None:
    """The message shows the form, and what came."""
    with pytest.raises(ValueError, match=f"^a parameter is written name=value, but not '{text}'$"):
        commands._parameters([text])
    assert commands._parameters(["a=b=c", "d=1"]) == {"a": "b=c", "d": 1}


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
    assert made == [
        (4, 7),
        ("the game", {"render": "human", "gif": Path("a.gif")}),
        (10, None),
        ("the game", {"render": "ansi", "gif": None}),
    ]


def test_reproduce_by_default(asked: list[dict[str, Any]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In the folder `results`, with the seed 0 and all cores; what the experiments save is beside the claims."""
    monkeypatch.chdir(tmp_path)
    said = run("reproduce", "made_up")
    assert said.exit_code == 0
    assert asked == [{"seed": 0, "jobs": -1, "progress": False, "folder": Path("results/made_up.unfinished")}]
    folder = tmp_path / "results" / "made_up"
    assert sorted(path.name for path in folder.iterdir()) == ["claims.csv", "runs.csv"]
    assert (folder / "claims.csv").read_text() == FILE
    *table, written = in_words(said.stdout)
    assert table == TABLE.splitlines()
    assert written == "Figures and data are in results/made_up, and a report in results/report.md."
    assert said.stderr == "edugym: a slow one\n" * 2


def test_the_claims_are_written_last(
    asked: list[dict[str, Any]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where claims are, everything beside them is theirs: old ones go before anything else comes."""
    folder = tmp_path / "deep" / "made_up"
    arguments = ("reproduce", "made_up", "--output", str(folder.parent))
    assert run(*arguments).exit_code == 0
    seen: list[tuple[str, bool]] = []

    def watched(path: Path, contents: bytes) -> Path:
        seen.append((path.name, (folder / commands.CLAIMS).exists()))
        path.write_bytes(contents)
        return path

    monkeypatch.setattr(commands, "write_whole", watched)
    run(*arguments)
    assert seen == [("claims.csv", True), ("runs.csv", False), ("claims.csv", False), ("report.md", True)]
    assert (folder / "runs.csv").read_text() == "2"


def test_one_lesson_that_fails_is_enough(
    asked: list[dict[str, Any]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The others run all the same, before and after it."""
    claims = iter([CLAIM, CLAIM._replace(expected=Below(0.25)), CLAIM])
    monkeypatch.setattr(
        commands,
        "load_experiments",
        lambda name: SimpleNamespace(report=lambda **_: Report([next(claims)], []), __doc__=name),
    )
    monkeypatch.setattr(commands, "lesson_names", lambda: ["one", "two", "three"])
    assert run("reproduce", "--output", str(tmp_path)).exit_code == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one", "report.md", "three", "two"]


def test_what_an_unfinished_command_left_goes(tmp_path: Path) -> None:
    """Files, folders and links; the finished runs stay, and so does what a link leads to."""
    folder, other = tmp_path / "unfinished", tmp_path / "other"
    for path in (folder / CHECKPOINTS, folder / "a folder" / "in it", other):
        path.mkdir(parents=True)
        (path / "file").touch()
    (folder / "a link").symlink_to(other)
    (folder / "a file").touch()
    commands._clear(folder, keep=CHECKPOINTS)
    assert sorted(tmp_path.rglob("*")) == [
        other,
        other / "file",
        folder,
        folder / CHECKPOINTS,
        folder / CHECKPOINTS / "file",
    ]


def test_the_table_of_claims_on_a_narrow_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """What is expected and whether it holds stay in one line; the name is above its left end."""
    monkeypatch.setattr(commands, "Console", lambda: Console(width=42))
    other = CLAIM._replace(statement="Another one", expected=Within(0.3, 1.25), reason="")
    commands._print_claims("made_up", [CLAIM, other])
    assert [line.rstrip() for line in capsys.readouterr().out.splitlines()] == NARROW.splitlines()


def test_the_colours_of_a_claim() -> None:
    """Green or red for whether it holds; grey for the reason, if there is one, and for what was measured."""
    measured = "0.25 [0.125, 0.5]\n[dim]share of failures[/dim]"
    assert commands._row(CLAIM) == (
        "Fails seldom\n[dim]by design[/dim]", measured, "< 0.75", "[green]yes[/green]"
    )  # fmt: skip
    fails = commands._row(CLAIM._replace(expected=Below(0.3), reason=""))
    assert fails == ("Fails seldom", measured, "< 0.3", "[bold red]NO[/bold red]")


def test_what_is_wrong_is_named_with_its_argument(
    asked: list[dict[str, Any]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As it is written on the command line."""
    monkeypatch.setattr(server, "serve", lambda folder, options: None)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").touch()
    for arguments, hint in (
        (("reproduce", "explore"), "LESSON"),
        (("reproduce", "--jobs", "0"), "--jobs"),
        (("reproduce", "--output", str(tmp_path / "file")), "--output"),
        (("lab", "a", "b"), "DIRECTORY"),
        (("lab", str(tmp_path / "file")), "DIRECTORY"),
    ):
        refused = run(*arguments)
        assert refused.exit_code == 2
        assert f"Invalid value for {hint}:" in refused.stderr
    assert asked == []


@pytest.mark.parametrize(
    ("arguments", "right", "wrong"),
    [
        (("reproduce", "made_up", "--repetitions"), 2, 1),
        (("reproduce", "made_up", "--seed"), 0, -1),
        (("reproduce", "made_up", "--jobs"), -1, -2),
        (("reproduce", "made_up", "--jobs"), 1_000, 1_001),
        (("lab", "--port"), 0, -1),
        (("lab", "--port"), 65_535, 65_536),
        (("play", "Boulder", "--seed"), 0, -1),
    ],
)
@pytest.mark.usefixtures("asked")
def test_the_first_and_last_number_that_will_do(
    arguments: tuple[str, ...], right: int, wrong: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The next one will not, and the message names its option."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(server, "serve", lambda folder, options: None)
    monkeypatch.setattr(server, "prepare", lambda folder: [])
    monkeypatch.setattr(playing, "play", lambda *one, **how: None)
    assert run(*arguments, str(right)).exit_code == 0
    refused = run(*arguments, str(wrong))
    assert refused.exit_code == 2
    assert f"Invalid value for '{arguments[-1]}'" in refused.stderr


def test_an_interruption_is_no_output(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """It is said where errors are."""

    def press(name: str) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(commands, "load_experiments", press)
    said = run("reproduce", "loop", "--output", str(tmp_path))
    assert (said.exit_code, said.stdout) == (130, "")
    assert said.stderr == (f"edugym: interrupted; what is done is kept in {tmp_path}, and the same command goes on\n")


def test_lab_says_what_it_did(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """One line for each lesson with a newer version, and where the lessons are."""
    monkeypatch.setattr(server, "prepare", lambda folder: ["one is new", "two is new"])
    monkeypatch.setattr(server, "serve", lambda folder, options: None)
    said = run("lab", str(tmp_path))
    assert said.stdout.splitlines() == [
        "edugym: one is new",
        "edugym: two is new",
        f"The lessons are in {tmp_path}. Ctrl-C here ends JupyterLab.",
    ]
    assert "the path is empty" in run("lab", "").stderr


class Full(io.StringIO):
    """An output that cannot be written to, with a file of its own."""

    def __init__(self, file: int, error: OSError) -> None:
        """With the error that every flush raises."""
        super().__init__()
        self.file, self.error = file, error

    def fileno(self) -> int:
        """The number of the file."""
        return self.file

    def flush(self) -> None:
        """Fail."""
        raise self.error


@pytest.mark.parametrize(
    ("app", "error", "ends"),
    [
        (lambda: None, OSError(errno.ENOSPC, "No space left"), "edugym: cannot write the output: No space left"),
        (
            lambda: None,
            OSError(errno.EIO, "Input/output error", "a.csv"),
            "edugym: [Errno 5] Input/output error: 'a.csv'",
        ),
        (
            lambda: None,
            OSError("cannot write to a.csv: it is a folder"),
            "edugym: cannot write to a.csv: it is a folder",
        ),
        (lambda: None, BrokenPipeError(errno.EPIPE, "Broken pipe"), 1),
        (lambda: sys.exit(2), OSError(errno.ENOSPC, "No space left"), 2),
        (lambda: sys.exit(0), OSError(errno.ENOSPC, "No space left"), "edugym: cannot write the output: No space left"),
    ],
)
def test_output_that_fails(
    app: Callable[[], None], error: OSError, ends: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """One line says why, unless the command has failed already and said so, or nobody reads."""
    monkeypatch.setattr(commands, "app", app)
    with (tmp_path / "output").open("w") as output:
        monkeypatch.setattr(sys, "stdout", Full(output.fileno(), error))
        with pytest.raises(SystemExit) as ended:
            commands.run()
        assert os.fstat(output.fileno()).st_rdev == os.stat(os.devnull).st_rdev  # Python's own last flush is lost
    assert ended.value.code == ends


def test_a_missing_library_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """No traceback."""

    def missing() -> None:
        raise DependencyNotInstalled("typing is not installed")

    monkeypatch.setattr(commands, "app", missing)
    with pytest.raises(SystemExit, match=r"^edugym: typing is not installed$"):
        commands.run()


def test_a_mistake_of_the_package_has_a_plain_traceback() -> None:
    """Without the values of all variables, among them whole tables."""
    assert not commands.app.pretty_exceptions_enable

"""Playing with keys: through a pipe, in a terminal and in a window."""

import io
import os
import pty
import select
import signal
import subprocess
import sys
import termios
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest
from gymnasium.spaces import Discrete
from PIL import Image

from edugym.adapters.playing import play
from edugym.adapters.playing.game import TERMINATED
from edugym.adapters.playing.keyboard import CLEAR, windows_keys
from tests.adapters.playing.tasks import Still, Walk

SLOW = pytest.mark.slow


def lines_of(keys: list[str], **options: Any) -> list[str]:
    """What is written when these keys come through a pipe to the walk, a line each."""
    screen = io.StringIO()
    play(Walk(), keyboard=io.StringIO("\n".join(keys)), screen=screen, **options)
    return screen.getvalue().splitlines()


def test_play_through_a_pipe() -> None:
    """Keys and names both work, wrong ones are named, a finished episode waits for r, the end of the input ends it."""
    lines = lines_of(["1", "x", "", " right ", "0", "r", "left"])
    scores = [line for line in lines if line.startswith(("start", "step"))]
    assert [score.split(",")[0] for score in scores] == [
        *["start", "step 1: right", "step 1: right", "step 1: right", "step 2: right", "step 2: right"],
        *["start", "step 1: left", "step 1: left"],
    ]
    assert "[0] left   [1] right   [r] new episode   [q] quit" in lines
    assert "'x' is no key here:   [0] left   [1] right   [r] new episode   [q] quit" in lines
    assert "'' is no key here:   [0] left   [1] right   [r] new episode   [q] quit" in lines
    assert "The episode is over:   [r] new episode   [q] quit" in lines
    assert lines.count(TERMINATED) == 2
    assert lines[-1] == "Episodes finished: 1. Totals: 1.5. Mean: 1.5."
    assert not any("\x1b" in line for line in lines)
    lines = lines_of(["q", "1"])  # nothing is read after q
    assert sum(line.startswith(("start", "step")) for line in lines) == 2  # once on the screen, once at the end


def test_interrupts_end_the_game_with_its_score(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C while the game waits for a key is no error."""
    screen, keyboard = io.StringIO(), io.StringIO()
    monkeypatch.setattr(keyboard, "readline", Mock(side_effect=["1\n", "1\n", KeyboardInterrupt]))
    game = play(Walk(), keyboard=keyboard, screen=screen)
    assert game.returns == [1.5]
    assert screen.getvalue().endswith("Episodes finished: 1. Totals: 1.5. Mean: 1.5.\n")


@pytest.mark.parametrize(("name", "coloured"), [("COLOR", True), ("NO_COLOR", False)])
def test_who_wants_no_colours_gets_none(name: str, coloured: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """By a variable that many programs heed, whatever its value is; a terminal is cleared all the same."""
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv(name, "")
    screen = io.StringIO()
    monkeypatch.setattr(screen, "isatty", lambda: True)
    play("Boulder", keyboard=io.StringIO(), screen=screen, height=2)
    assert screen.getvalue().startswith(CLEAR)
    assert ("\x1b[38;2;" in screen.getvalue()) == coloured


def test_an_environment_of_gymnasium_is_drawn_in_characters() -> None:
    """Where it can be: pixels say nothing in a terminal."""
    screen = io.StringIO()
    play("FrozenLake-v1", keyboard=io.StringIO(), screen=screen, is_slippery=False)
    assert "SFFF\nFHFH\n" in screen.getvalue().replace("\x1b[41m", "").replace("\x1b[0m", "")


def test_a_screen_with_few_characters() -> None:
    """What its encoding does not have becomes a question mark."""
    written = io.BytesIO()
    screen = io.TextIOWrapper(written, encoding="ascii")
    play("Boulder", keyboard=io.StringIO(), screen=screen, height=2)
    assert "1  ? ?" in written.getvalue().decode("ascii")


class Terminal:
    """A program that runs in a terminal of its own, as for a person who types."""

    def __init__(self, code: str) -> None:
        """Start it."""
        self.master, self.slave = pty.openpty()
        self.before = termios.tcgetattr(self.slave)
        controlled = f"{CONTROL}\n{code}"
        environment = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        command = [sys.executable, "-c", controlled]
        ends: dict[str, Any] = dict.fromkeys(("stdin", "stdout", "stderr"), self.slave)
        self.process = subprocess.Popen(command, start_new_session=True, env=environment, **ends)
        self.written = ""

    def type(self, keys: str, until: str) -> str:
        """Press keys, and return what is written from then on until a text appears."""
        seen = len(self.written)
        os.write(self.master, keys.encode())
        deadline = time.monotonic() + 60
        while until not in self.written[seen:]:
            assert select.select([self.master], [], [], deadline - time.monotonic())[0], self.written
            self.written += os.read(self.master, 4096).decode()
        return self.written[seen:]

    def end(self) -> int:
        """The exit status, once the terminal was found as it had been."""
        status: int = self.process.wait(60)
        assert termios.tcgetattr(self.slave) == self.before
        os.close(self.master)
        os.close(self.slave)
        return status


CONTROL = """
import fcntl, signal, termios
fcntl.ioctl(0, termios.TIOCSCTTY, 0)
signal.signal(signal.SIGINT, signal.default_int_handler)  # it may be ignored, as in `make test &`
for ending in (signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
    signal.signal(ending, signal.SIG_DFL)
"""
"""What makes the terminal that of the program, and its signals those of a program that a person has started."""
GAME = "from edugym.adapters.playing import play; play('Supermarket')"
ARROW_RIGHT, ARROW_DOWN, DELETE = "\x1b[C", "\x1bOB", "\x1b[3~"


def test_play_in_a_terminal() -> None:
    """Single keys count at once and without echo, arrows are actions, the picture is redrawn in colour."""
    terminal = Terminal(GAME)
    first = terminal.type("", until="[q] quit")
    assert CLEAR in first
    assert "\x1b[38;2;" in first
    assert "step 1: right, " in terminal.type(ARROW_RIGHT, until="[q] quit")
    assert "step 3: right, " in terminal.type(f"{ARROW_DOWN}3", until="step 3: right")
    assert "'' is no key here" in terminal.type(DELETE, until="is no key here")
    assert "start, " in terminal.type("r", until="start, ")
    terminal.type("q", until="No episode finished yet.")
    assert terminal.end() == 0


SHOWN, DONE = ("", "[q] quit"), "No episode finished yet."
OWN_HANDLERS = f"""
import os
signal.signal(signal.SIGHUP, signal.SIG_IGN)
signal.signal(signal.SIGTERM, lambda *_: os.write(1, b"in its own way"))  # `print` might come within another one
{GAME}
assert signal.getsignal(signal.SIGQUIT) is signal.SIG_DFL
"""
WALK = GAME.replace("'Supermarket'", "Walk()")
FAILING = "from tests.adapters.playing.tasks import Walk; Walk.reward = lambda *_: 1 / 0"
Dialogue = list[tuple[str, str] | signal.Signals]
ENDS: dict[str, tuple[str, Dialogue, int]] = {
    "killed": (GAME, [SHOWN, signal.SIGTERM], -signal.SIGTERM),
    "hung up": (GAME, [SHOWN, signal.SIGHUP], -signal.SIGHUP),
    "Ctrl-C": (GAME, [SHOWN, ("1", "step 1: down"), ("\x03", DONE)], 0),
    "Ctrl-D": (GAME, [SHOWN, ("1", "step 1: down"), ("\x04", DONE)], 0),
    "own handlers": (
        OWN_HANDLERS, [SHOWN, signal.SIGHUP, signal.SIGTERM, ("", "in its own way"), ("q", DONE)], 0
    ),
    "an error": (f"{FAILING}; {WALK}", [SHOWN, ("1", "ZeroDivisionError")], 1),
    "outside the main thread": (
        f"import threading\nthreading.Thread(target=lambda: exec({GAME!r})).start()", [SHOWN, ("q", DONE)], 0
    ),
}  # fmt: skip
"""What the program does, what happens to it, and its exit status."""


@pytest.mark.parametrize("name", [pytest.param(name, marks=[SLOW] * (name != "killed")) for name in ENDS])
def test_every_end_leaves_the_terminal_as_it_was(name: str) -> None:
    """And the program ends as any other."""
    code, dialogue, status = ENDS[name]
    terminal = Terminal(code)
    for event in dialogue:
        if isinstance(event, tuple):
            terminal.type(*event)
            assert name == "an error" or "Traceback" not in terminal.written
        else:
            assert termios.tcgetattr(terminal.slave) != terminal.before
            terminal.process.send_signal(event)
    assert terminal.end() == status


@pytest.mark.parametrize(
    ("line", "status", "output", "error"),
    [
        ("yes 0 | (EDUGYM play Boulder; echo $? >&2) | head -1", 0, "\n", "1\n"),
        pytest.param("EDUGYM play Boulder <&-", 0, "No episode finished yet.\n", "", marks=SLOW),
        pytest.param("EDUGYM play Boulder </dev/null >&-", 2, "", "standard output", marks=SLOW),
        pytest.param("EDUGYM play Boulder </dev/null >/dev/full", 2, "", "No space left on device", marks=SLOW),
        pytest.param("EDUGYM list >/dev/full", 1, "", "No space left on device\n", marks=SLOW),
    ],
)
def test_inputs_and_outputs_that_end(line: str, status: int, output: str, error: str) -> None:
    """No traceback, and an exit status that says how it went."""
    code = line.replace("EDUGYM", f"{sys.executable} -c 'from edugym_course.cli import main; main()'")
    result = subprocess.run(["bash", "-c", code], capture_output=True, text=True, timeout=60, check=False)
    assert result.returncode == status
    assert result.stdout.endswith(output)
    assert error in result.stderr if error else result.stderr == ""
    assert "Traceback" not in result.stderr


def test_keys_of_a_windows_console() -> None:
    """Arrows come as two characters, other such keys write nothing, and Ctrl-D and Ctrl-C end it."""

    def typed(characters: str) -> Callable[[], str]:
        return iter(characters).__next__

    assert list(windows_keys(typed("1\xe0K\x00;a\x04b"))) == ["1", "left", "", "a"]
    with pytest.raises(KeyboardInterrupt):
        list(windows_keys(typed("1\x03")))


@pytest.mark.parametrize(
    ("environment", "options", "error", "names"),
    [
        (Walk(), {"render": "svg"}, ValueError, "render .*'ansi', 'human'.*'svg'"),
        (Still(Discrete(10_001)), {}, ValueError, "too many actions"),
        ("CliffWalking-v1", {"gif": "cliff.gif"}, ValueError, "has a scene.*CliffWalking"),
        (Walk(), {"gif": "walk.png"}, ValueError, r"\.gif.*walk\.png"),
        (Walk(), {"gif": "folder.gif"}, OSError, r"folder\.gif"),
    ],
)
def test_what_play_refuses(
    environment: Any, options: Any, error: type[Exception], names: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Before anybody has played in vain."""
    monkeypatch.chdir(tmp_path)
    Path("folder.gif").mkdir()
    screen = io.StringIO()
    with pytest.raises(error, match=names):
        play(environment, keyboard=io.StringIO(), screen=screen, **options)
    assert screen.getvalue() == ""


def test_the_last_episode_as_a_gif(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The finished episode of two steps, not the one that was begun after it."""
    path = tmp_path / "new folder" / "walk.gif"
    lines = lines_of(["1", "1", "r", "0"], gif=path)
    assert lines[-1] == f"The last episode is in {path}"
    gone, other = io.StringIO(), tmp_path / "gone.gif"  # the reader of a pipe may go before the episode is over
    monkeypatch.setattr(gone, "write", Mock(side_effect=lambda text: 1 / ("step 2" not in text)))
    with pytest.raises(ZeroDivisionError):
        play(Walk(), keyboard=io.StringIO("1\n1\n"), screen=gone, gif=other)
    for film in (path, other):
        with Image.open(film) as image:
            assert (getattr(image, "n_frames", 1), image.info["loop"]) == (3, 0)

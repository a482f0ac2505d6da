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

import pytest
from gymnasium.error import DependencyNotInstalled
from PIL import Image
from typer.testing import CliRunner, Result

from edugym.adapters.keys import keys_of
from edugym.adapters.playing import play
from edugym.adapters.playing.game import TERMINATED
from edugym.adapters.playing.keyboard import CLEAR, key_presses, windows_keys
from edugym_course.commands import app
from tests.adapters.playing.tasks import Walk


def lines_of(keys: list[str], **options: Any) -> list[str]:
    """What is written when these keys come through a pipe to the walk, a line each."""
    screen = io.StringIO()
    play(Walk(), keyboard=io.StringIO("\n".join(keys)), screen=screen, **options)
    return screen.getvalue().splitlines()


def test_play_through_a_pipe() -> None:
    """Keys and names both work, wrong ones are named, a finished episode waits for r, the end of the input ends it."""
    lines = lines_of(["1", "x", "", "right", "0", "r", "left"])
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


def test_quitting_ends_the_game() -> None:
    """Nothing is read after q."""
    lines = lines_of(["q", "1"])
    assert sum(line.startswith(("start", "step")) for line in lines) == 2  # once on the screen, once at the end
    assert lines[-1] == "No episode finished yet."


def test_interrupts_end_the_game_with_its_score(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C while the game waits for a key is no error."""
    screen = io.StringIO()
    keyboard = io.StringIO()
    lines = iter(["1\n", "1\n"])

    def interrupted(size: int = -1) -> str:
        for line in lines:
            return line
        raise KeyboardInterrupt

    monkeypatch.setattr(keyboard, "readline", interrupted)
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
        self.process = subprocess.Popen(
            [sys.executable, "-c", controlled],
            stdin=self.slave,
            stdout=self.slave,
            stderr=self.slave,
            start_new_session=True,
            env=environment,
        )
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
        """Wait for the end; the exit status, once the terminal was found as it had been."""
        status = self.process.wait(60)
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


def test_a_keyboard_that_is_not_the_standard_input() -> None:
    """The terminal, opened by its name, is left as it was too."""
    terminal = Terminal("from edugym.adapters.playing import play; play('Supermarket', keyboard=open('/dev/tty'))")
    terminal.type("", until="[q] quit")
    terminal.type("q", until="No episode finished yet.")
    assert terminal.end() == 0


@pytest.mark.parametrize("key", ["\x03", "\x04"])
def test_ctrl_c_and_ctrl_d_leave_the_terminal_as_it_was(key: str) -> None:
    """The score is shown, there is no traceback, and the exit status is 0."""
    terminal = Terminal(GAME)
    terminal.type("", until="[q] quit")
    terminal.type("1", until="step 1: down")
    last = terminal.type(key, until="No episode finished yet.")
    assert "step 1: down" in last
    assert "Traceback" not in last
    assert terminal.end() == 0


def test_ctrl_c_ends_a_game_that_does_not_receive_its_signal() -> None:
    """Another thread may receive it, or it comes just before the wait for a key: both leave that wait alone."""
    other = "import threading, time; threading.Thread(target=time.sleep, args=(600,), daemon=True).start()"
    terminal = Terminal(f"{other}; signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT]); {GAME}")
    terminal.type("", until="[q] quit")
    time.sleep(0.5)  # until it waits
    terminal.type("\x03", until="No episode finished yet.")
    assert terminal.end() == 0


@pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT])
def test_signals_leave_the_terminal_as_it_was(ending: signal.Signals) -> None:
    """And end the program as they end any other."""
    terminal = Terminal(f"import resource; resource.setrlimit(resource.RLIMIT_CORE, (0, 0)); {GAME}")
    terminal.type("", until="[q] quit")
    assert termios.tcgetattr(terminal.slave) != terminal.before
    terminal.process.send_signal(ending)
    assert terminal.end() == -ending


def test_signals_that_the_program_handles_are_left_to_it() -> None:
    """Such as the hang-up that `nohup` lets it ignore; and after the game all are as before."""
    code = """
import os
signal.signal(signal.SIGHUP, signal.SIG_IGN)
signal.signal(signal.SIGTERM, lambda *_: os.write(1, b"in its own way"))  # `print` might come within another one
from edugym.adapters.playing import play; play('Supermarket')
assert signal.getsignal(signal.SIGQUIT) is signal.SIG_DFL
"""
    terminal = Terminal(code)
    terminal.type("", until="[q] quit")
    terminal.process.send_signal(signal.SIGHUP)
    terminal.process.send_signal(signal.SIGTERM)
    terminal.type("", until="in its own way")
    terminal.type("q", until="No episode finished yet.")
    assert terminal.end() == 0


def test_an_error_leaves_the_terminal_as_it_was() -> None:
    """An error of the environment is shown as it is."""
    imports = "from tests.adapters.playing.tasks import Walk; from edugym.adapters.playing import play"
    terminal = Terminal(f"{imports}; Walk.reward = lambda *_: 1 / 0; play(Walk())")
    terminal.type("", until="[q] quit")
    terminal.type("1", until="ZeroDivisionError")
    assert terminal.end() == 1


def test_a_game_can_be_played_outside_the_main_thread() -> None:
    """Where Python does not let it handle signals."""
    terminal = Terminal(f"import threading\nthread = threading.Thread(target=lambda: exec({GAME!r}))\nthread.start()")
    terminal.type("", until="[q] quit")
    terminal.type("q", until="No episode finished yet.")
    assert terminal.end() == 0


def test_a_terminal_that_goes_away_ends_the_program() -> None:
    """Closing its window hangs up."""
    terminal = Terminal(GAME)
    terminal.type("", until="[q] quit")
    os.close(terminal.slave)
    os.close(terminal.master)
    assert terminal.process.wait(60) == -signal.SIGHUP


def command(arguments: str) -> subprocess.CompletedProcess[str]:
    """Run `edugym` in a shell, where EDUGYM stands for it."""
    code = f"{sys.executable} -c 'from edugym_course.cli import main; main()'"
    line = arguments.replace("EDUGYM", code)
    return subprocess.run(["bash", "-c", line], capture_output=True, text=True, timeout=60, check=False)


@pytest.mark.parametrize(
    ("line", "status", "output", "error"),
    [
        ("EDUGYM play Boulder <&-", 0, "No episode finished yet.\n", ""),
        ("yes 0 | (EDUGYM play Boulder; echo $? >&2) | head -1", 0, "\n", "1\n"),
        ("EDUGYM play Boulder </dev/null >&-", 2, "", "standard output is closed"),
        ("EDUGYM play Boulder </dev/null >/dev/full", 2, "", "No space left on device"),
        ("EDUGYM list >/dev/full", 1, "", "No space left on device\n"),
    ],
)
def test_inputs_and_outputs_that_end(line: str, status: int, output: str, error: str) -> None:
    """No traceback, and an exit status that says how it went."""
    result = command(line)
    assert result.returncode == status
    assert result.stdout.endswith(output)
    assert error in result.stderr if error else result.stderr == ""
    assert "Traceback" not in result.stderr


def test_the_film_is_kept_where_the_output_ends(tmp_path: Path) -> None:
    """The reader of a pipe may go before the episode is over."""

    class Gone(io.StringIO):
        def write(self, text: str) -> int:
            if "step 2" in text:
                raise BrokenPipeError
            return super().write(text)

    with pytest.raises(BrokenPipeError):
        play(Walk(), keyboard=io.StringIO("1\n1\n"), screen=Gone(), gif=tmp_path / "walk.gif")
    with Image.open(tmp_path / "walk.gif") as image:
        assert getattr(image, "n_frames", 1) == 3


def test_keys_of_a_windows_console() -> None:
    """Arrows come as two characters, other such keys write nothing, and Ctrl-D and Ctrl-C end it."""

    def typed(characters: str) -> Callable[[], str]:
        return iter(characters).__next__

    assert list(windows_keys(typed("1\xe0K\x00;a\x04b"))) == ["1", "left", "", "a"]
    with pytest.raises(KeyboardInterrupt):
        list(windows_keys(typed("1\x03")))


def test_keys_of_actions() -> None:
    """Numbers, then letters, or the names themselves; never the keys that quit and begin again."""
    assert keys_of(["putt", "chip"]) == {"0": "putt", "1": "chip"}
    assert keys_of(["5", "6"]) == {"5": "5", "6": "6"}
    assert keys_of(["q", "r"]) == {"0": "q", "1": "r"}
    many = keys_of([f"action {k}" for k in range(34)])
    assert len(many) == 34
    assert not {"q", "r"} & set(many)
    assert many["a"] == "action 10"
    with pytest.raises(ValueError, match="at most 34"):
        keys_of([str(k) for k in range(35)])


def test_lines_are_keys_where_there_is_no_terminal() -> None:
    """Without the blanks around them."""
    with key_presses(io.StringIO("1\n go out \n\nq")) as presses:
        assert list(presses) == ["1", "go out", "", "q"]


def test_what_play_refuses(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A picture that there is not, before anybody has played in vain."""
    with pytest.raises(ValueError, match="render must be one of 'ansi', 'human', but is 'svg'"):
        play(Walk(), render="svg")
    with pytest.raises(ValueError, match="need an environment that has a scene"):
        play("CliffWalking-v1", gif=tmp_path / "cliff.gif", keyboard=io.StringIO())
    with pytest.raises(ValueError, match=r"must be a file that ends in \.gif, but is '.*walk\.png'"):
        play(Walk(), gif=tmp_path / "walk.png", keyboard=io.StringIO())
    (tmp_path / "folder.gif").mkdir()
    with pytest.raises(OSError, match=r"cannot write to .*folder\.gif: it is a folder"):
        play(Walk(), gif=tmp_path / "folder.gif", keyboard=io.StringIO())
    monkeypatch.setattr("edugym.system.extras.find_spec", lambda library: None)
    with pytest.raises(DependencyNotInstalled, match="PIL is not installed"):
        play(Walk(), gif=tmp_path / "walk.gif", keyboard=io.StringIO())


def test_the_last_episode_as_a_gif(tmp_path: Path) -> None:
    """The finished episode of two steps, not the one that was begun after it."""
    path = tmp_path / "new folder" / "walk.gif"
    lines = lines_of(["1", "1", "r", "0"], gif=path)
    assert lines[-1] == f"The last episode is in {path}"
    with Image.open(path) as image:
        assert getattr(image, "n_frames", 1) == 3
        assert image.info["loop"] == 0


def test_the_command() -> None:
    """Parameters are read from the command line; what is wrong is a usage error, not a traceback."""

    def run(*arguments: str, keys: str = "") -> Result:
        return CliRunner().invoke(app, ["play", *arguments], input=keys)

    played = run("Boulder", "--set", "height=2", "--set", "n_grips=3", "--seed", "1", keys="0\n1\nq\n")
    assert (played.exit_code, played.output.count("[2] grip 2")) == (0, 3)
    assert "step 2: grip 1" in played.output
    assert (
        run("FrozenLake-v1", "--set", "is_slippery=False", "--set", "map_name=8x8", keys="2\n").output.count(
            "observation 1,"
        )
        == 2
    )
    assert run("Tamagotchi", "--set", "tau=inf").exit_code == 0
    wrong = {
        ("Bolder",): "doesn't exist",
        ("Boulder", "--set", "seed=3"): "has no parameter 'seed'",
        ("Boulder", "--set", "height={[]:1}"): "must be a whole number",
        ("Tamagotchi", "--set", "tau=nan"): "tau must be",
        ("Boulder", "--set", "heigth=2"): "heigth",
        ("Boulder", "--set", "height"): "name=value",
        ("Boulder", "--set", "height=low"): "must be a whole number",
        ("Boulder", "--gif", "/proc/x.gif"): "cannot write to",
        ("Boulder", "--gif", "boulder.mp4"): "ends in .gif",
        ("Boulder", "--render", "svg"): "ansi",
    }
    for arguments, message in wrong.items():
        refused = run(*arguments)
        assert refused.exit_code == 2
        assert message in refused.output

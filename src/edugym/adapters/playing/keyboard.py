"""Play with keys, in a terminal or in a window."""

import io
import os
import re
import select
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from typing import Any, Protocol, TextIO

from edugym.adapters.keys import AGAIN, KEYS, QUIT, keys_of
from edugym.adapters.playing.films import checked_path, record
from edugym.adapters.playing.game import Game
from edugym.checks.parameters import one_of
from edugym.rendering.ansi import to_text
from edugym.rendering.scene import Scene
from edugym.rendering.window import Window
from edugym.system.extras import require

SPACE, LINE_LENGTH = "   ", 62
"""The space between two choices, and the number of characters in a line of a window."""

ARROWS = {"A": "up", "B": "down", "C": "right", "D": "left"}
"""The last character of an arrow key in a terminal, after ESC [ or ESC O."""
WINDOWS_ARROWS = {"H": "up", "P": "down", "M": "right", "K": "left"}
"""The second character of an arrow key in a Windows console."""
CLEAR = "\x1b[H\x1b[2J"


class Display(Protocol):
    """A screen with its keys."""

    def show(self, game: Game, *choices: str) -> None:
        """Show the present picture, the score, and the choices below them."""

    def key(self) -> str | None:
        """Wait for a key. Return its character, or "up", "down", "left" or "right"; None at the end of the input."""


def play(
    environment: Any,
    *,
    render: str = "ansi",
    seed: int | None = None,
    gif: str | Path | None = None,
    keyboard: TextIO | None = None,
    screen: TextIO | None = None,
    **parameters: Any,
) -> Game:
    """Play with keys until you press q or Ctrl-C, close the window, or the input ends.

    In a terminal each key counts at once. In other input (a pipe, a file) each line is a key or the name of an action.
    A terminal is left as it was, however the game ends.

    Args:
        environment: its name ("Boulder"), the id of any Gymnasium environment, an environment, an MDP, or a `Game`.
        render: "ansi" for characters on the screen, "human" for a window.
        seed: the seed of the first episode; None for a different game each time.
        gif: a file for the last finished episode, or for the unfinished one if there is none, written at the end.
        keyboard: the input in a terminal; by default the standard input.
        screen: the output in a terminal; by default the standard output.
        parameters: parameters of an environment that is given by its name or id.

    Returns:
        The game, with its score.

    Raises:
        ValueError: as for `Game`; or `render` is neither of these; there are more actions than keys; a window or a GIF
            needs a scene, and there is none; or the file does not end in .gif.
        OSError: the screen or the GIF cannot be written to (a `BrokenPipeError` if the reader of a pipe has gone).
        gymnasium.error.DependencyNotInstalled: pygame is needed for a window or a GIF, or Pillow for a GIF.
    """
    one_of("render", render, ["ansi", "human"])
    keyboard, screen = keyboard or sys.stdin or io.StringIO(), screen or sys.stdout
    if screen is None:  # Python's word for a standard output that is closed; such an input has no keys
        raise OSError("screen must be open, but the standard output is closed")
    game = environment if isinstance(environment, Game) else Game(environment, seed=seed, picture="ansi", **parameters)
    if not game.actions:
        raise ValueError(f"{game.name} has too many actions to be played with keys, of which there are {len(KEYS)}")
    keys = keys_of(list(game.actions))
    if (render == "human" or gif is not None) and not isinstance(game.frames[0].picture, Scene):
        raise ValueError(f"a window and a GIF need an environment that has a scene, and {game.name} has none")
    if gif is not None:
        require("plot", "PIL")
        gif = checked_path(gif)
    try:
        with suppress(KeyboardInterrupt):
            if render == "human":
                with closing(Window(game.name)) as window:
                    _play(game, keys, InWindow(window))
            else:
                with key_presses(keyboard) as presses:
                    _play(game, keys, InTerminal(presses, screen))
        _write(screen, f"{'' if game.over else game.line()}\n{game.history()}\n")
    finally:
        if gif is not None:
            record(game.replay(), gif)
    if gif is not None:
        _write(screen, f"The last episode is in {gif}\n")
    return game


def _play(game: Game, keys: dict[str, str], display: Display) -> None:
    """Play with the keys of a display until they end."""
    actions = [f"[{key}]" if key == name else f"[{key}] {name}" for key, name in keys.items()]
    message = ""
    while True:
        of_the_game = [] if game.over else actions
        display.show(game, *filter(None, [message, *of_the_game]), f"[{AGAIN}] new episode", f"[{QUIT}] quit")
        key = display.key()
        name = keys.get(key or "", key)
        message = ""
        if key is None or key == QUIT:
            return
        if key == AGAIN:
            game.reset()
        elif game.over:
            message = "The episode is over:"
        elif name in game.actions:
            game.step(name)
        else:
            message = f"{key!r} is no key here:"


class InTerminal:
    """A game in a terminal, as characters. In a file they have no colours."""

    def __init__(self, presses: Iterator[str], screen: TextIO) -> None:
        """Play with the keys `presses` on a screen."""
        self._presses = presses
        self._screen = screen

    def show(self, game: Game, *choices: str) -> None:
        """Show the game; in a terminal, clear it first."""
        live = self._screen.isatty()
        picture = game.picture()
        if isinstance(picture, Scene):
            picture = to_text(picture, colour=live and "NO_COLOR" not in os.environ)
        text = str(picture).strip("\n")
        _write(self._screen, f"{CLEAR if live else ''}{text}\n\n{game.line()}\n{SPACE.join(choices)}\n\n")

    def key(self) -> str | None:
        """Wait for the next key, and return None at the end of the input."""
        return next(self._presses, None)


class InWindow:
    """A game in a window, with the keys that are pressed there."""

    def __init__(self, window: Window) -> None:
        """Play in a window."""
        self._window = window
        self._n_lines = 0

    def show(self, game: Game, *choices: str) -> None:
        """Show the game with its score and the choices below it. The number of lines never falls, nor does the size."""
        lines = [""]
        for choice in choices:
            if len(lines[-1] + SPACE + choice) > LINE_LENGTH:
                lines.append("")
            lines[-1] += SPACE * bool(lines[-1]) + choice
        self._n_lines = max(self._n_lines, len(lines))
        lines += [""] * (self._n_lines - len(lines))
        self._window.show(game.frame().with_caption(*lines), float("inf"))

    def key(self) -> str | None:
        """Wait for the next key, and return None when the window is closed."""
        return self._window.next_key()


def _write(screen: TextIO, text: str) -> None:
    """Write at once, with a question mark for each character that the screen's encoding does not have."""
    encoding = screen.encoding or "utf-8"
    screen.write(text.encode(encoding, "replace").decode(encoding))
    screen.flush()


@contextmanager
def key_presses(keyboard: TextIO) -> Iterator[Iterator[str]]:
    """Give the keys as they are pressed, or the lines of an input that is not a terminal."""
    if not keyboard.isatty():
        yield (line.strip() for line in iter(keyboard.readline, ""))
    elif sys.platform == "win32":
        import msvcrt

        yield windows_keys(msvcrt.getwch)
    else:
        with _single_keys(keyboard.fileno()):
            yield unix_keys(keyboard.fileno())


@contextmanager
def _single_keys(terminal: int) -> Iterator[None]:
    """Make a terminal deliver each key at once, without echo, and leave it as it was.

    A signal that ends the process restores the terminal first. Signals that the process handles in its own way, or
    ignores, are left alone, and outside the main thread Python cannot handle any.
    """
    import termios
    import tty

    before = termios.tcgetattr(terminal)

    def restore() -> None:
        with suppress(termios.error):  # the terminal may be gone
            termios.tcsetattr(terminal, termios.TCSANOW, before)

    def end(number: int, frame: Any) -> None:
        restore()
        signal.signal(number, signal.SIG_DFL)
        signal.raise_signal(number)

    in_main_thread = threading.current_thread() is threading.main_thread()
    ending = (signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT) if in_main_thread else ()
    handled = [number for number in ending if signal.getsignal(number) is signal.SIG_DFL]
    for number in handled:
        signal.signal(number, end)
    try:
        tty.setcbreak(terminal)  # Ctrl-C still interrupts
        yield
    finally:
        restore()
        for number in handled:
            signal.signal(number, signal.SIG_DFL)


def unix_keys(file_descriptor: int) -> Iterator[str]:
    """The keys of a terminal until Ctrl-D or until it closes; "" for a key without a character."""
    sequences = re.compile(r"\x1b[\[O]([A-D])|\x1b\[[0-9;]*[A-Za-z~]|\x1bO[A-Z]|(.)", flags=re.DOTALL)
    with suppress(OSError):
        while typed := _read(file_descriptor).decode(errors="replace"):
            for arrow, key in sequences.findall(typed):
                if key == "\x04":
                    return
                yield ARROWS.get(arrow, key)


def _read(file_descriptor: int) -> bytes:
    """Wait for input and read it.

    A Ctrl-C that comes just before the wait does not end it, nor does one whose signal another thread receives. So each
    wait is short, and Python raises `KeyboardInterrupt` between two of them.
    """
    while not select.select([file_descriptor], [], [], 0.1)[0]:
        pass
    return os.read(file_descriptor, 1024)


def windows_keys(next_character: Callable[[], str]) -> Iterator[str]:
    """The keys of a Windows console until Ctrl-D or Ctrl-Z; Ctrl-C interrupts."""
    while (key := next_character()) not in ("\x04", "\x1a"):
        if key == "\x03":
            raise KeyboardInterrupt
        yield WINDOWS_ARROWS.get(next_character(), "") if key in ("\x00", "\xe0") else key

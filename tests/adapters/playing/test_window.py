"""Playing in a window: keys, pictures, and its end."""

import io
import time
from types import SimpleNamespace
from typing import Any

import pygame
import pytest

from edugym.adapters.keys import keys_of
from edugym.adapters.playing import Game, play
from edugym.adapters.playing.game import TERMINATED
from edugym.adapters.playing.keyboard import LINE_LENGTH, SPACE, InWindow
from edugym.adapters.registration import ENVIRONMENTS
from edugym.rendering.scene import Scene, Text
from edugym.rendering.window import Window
from tests.adapters.playing.tasks import Walk


@pytest.fixture
def windows(monkeypatch: pytest.MonkeyPatch) -> list[pygame.Window]:
    """All windows that are opened, on the pretended screen of the tests."""
    opened: list[pygame.Window] = []

    class Recorded(pygame.Window):
        def __init__(self, *arguments: Any) -> None:
            super().__init__(*arguments)
            opened.append(self)

    monkeypatch.setattr(pygame, "Window", Recorded)
    return opened


def key_down(window: pygame.Window, key: int, written: str) -> pygame.event.Event:
    """A key that is pressed in a window."""
    return pygame.event.Event(pygame.KEYDOWN, key=key, unicode=written, window=window)


def test_a_window_takes_keys(windows: list[pygame.Window], monkeypatch: pytest.MonkeyPatch) -> None:
    """By what they write or are called, in order, and only its own; a closed window has no more."""
    first, second = Window("first"), Window("second")
    assert first.next_key() is None
    for window in (first, second):
        window.show(Scene(10, 10, ()), float("inf"))
    pygame.event.post(key_down(windows[0], pygame.K_LEFT, ""))
    pygame.event.post(key_down(windows[1], pygame.K_b, "b"))
    pygame.event.post(key_down(windows[0], pygame.K_a, "A"))
    pygame.event.post(key_down(windows[0], pygame.K_RETURN, "\r"))
    first.show(Scene(10, 10, ()), float("inf"))  # showing must not lose what was pressed
    assert [first.next_key(), first.next_key(), first.next_key()] == ["left", "A", "return"]
    assert second.next_key() == "b"
    pygame.event.post(pygame.event.Event(pygame.WINDOWCLOSE, window=windows[0]))
    assert first.next_key() is None
    naps: list[float] = []
    looks = iter([[], [], [], [key_down(windows[1], pygame.K_a, "a")]])
    monkeypatch.setattr(time, "sleep", naps.append)
    with monkeypatch.context() as patch:
        patch.setattr(pygame.event, "get", lambda: next(looks))
        assert second.next_key() == "a"
    assert len(naps) >= 3  # between two looks at the keys the program sleeps
    assert min(naps) > 0
    second.close()
    assert second.next_key() is None


def texts(scene: Scene) -> list[str]:
    """What is written in a picture, from the top."""
    return [shape.content for shape in scene.shapes if isinstance(shape, Text)]


@pytest.fixture
def typist(windows: list[pygame.Window], monkeypatch: pytest.MonkeyPatch) -> tuple[list[Any], list[Scene]]:
    """Keys, one of which is pressed after each picture; the window is closed after the last. And the pictures shown."""
    keys: list[tuple[int, str]] = []
    shown: list[Scene] = []
    show = Window.show

    def show_and_type(self: Window, scene: Scene, frames_per_second: float) -> None:
        show(self, scene, frames_per_second)
        shown.append(scene)
        if keys:
            pygame.event.post(key_down(windows[0], *keys.pop(0)))
        else:
            pygame.event.post(pygame.event.Event(pygame.WINDOWCLOSE, window=windows[0]))

    monkeypatch.setattr(Window, "show", show_and_type)
    return keys, shown


def test_play_in_a_window(typist: tuple[list[Any], list[Scene]], windows: list[pygame.Window]) -> None:
    """Keys and arrows count, the score is below the picture, and the user closes the window to end."""
    keys, shown = typist
    keys += [(pygame.K_RIGHT, ""), (pygame.K_1, "1")]
    screen = io.StringIO()
    game = play(Walk(), render="human", screen=screen)
    assert game.returns == [1.5]
    choices = "[r] new episode   [q] quit"
    assert [texts(scene)[-1] for scene in shown] == [*[f"[0] left   [1] right   {choices}"] * 2, choices]
    assert texts(shown[-1])[-3:-1] == ["step 2: right, observation 4, reward 1.5, total 1.5", TERMINATED]
    assert len(windows) == 1
    assert screen.getvalue() == "\nEpisodes finished: 1. Totals: 1.5. Mean: 1.5.\n"


@pytest.mark.parametrize("name", [entry.name for entry in ENVIRONMENTS])
def test_every_environment_in_a_window(name: str, typist: tuple[list[Any], list[Scene]]) -> None:
    """Three steps with the first action, in a window that keeps its size; the keys of all actions are on the screen."""
    keys, shown = typist
    keys += [(pygame.K_0, "0")] * 3
    game = play(name, render="human", screen=io.StringIO(), seed=0)
    first, *_ = game.actions
    assert all(game.environment.action_space.contains(value) for value in game.actions.values())
    assert game._repr_svg_() is not None
    below = " ".join(texts(shown[0]))
    assert all(f"[{key}] {action}" in below for key, action in keys_of(list(game.actions)).items())
    assert f"[0] {first}" in below
    assert "[q] quit" in below
    assert any(text.startswith(f"step 1: {first}, ") for text in texts(shown[1]))
    assert len(shown) == 4
    assert len({(scene.width, scene.height) for scene in shown}) == 1


def test_choices_in_lines_that_fit() -> None:
    """As many as fit stand beside each other; the window does not shrink when there are fewer; nothing waits."""
    shown: list[tuple[Scene, float]] = []
    window: Any = SimpleNamespace(show=lambda *how: shown.append(how))
    display, game = InWindow(window), Game("Boulder", height=3)
    left, right = "x" * 30, "y" * (LINE_LENGTH - 30 - len(SPACE))
    for choices, lines in (
        ([left, right, "[r] new", "[q] quit"], [left + SPACE + right, f"[r] new{SPACE}[q] quit"]),
        ([left, f"{right}y"], [left, f"{right}y"]),
        (["[q] quit"], ["[q] quit", ""]),
    ):
        display.show(game, *choices)
        assert texts(shown[-1][0])[-2:] == lines
        assert shown[-1][1] == float("inf")
    assert shown[-1][0].size_in_pixels() == shown[0][0].size_in_pixels()

"""The windows of ``render_mode="human"``, on a pretended screen."""

import math
import time
from collections.abc import Iterator
from typing import Any

import pygame
import pytest

from edugym.rendering.palette import BLUE, GREEN, PAPER, RED, YELLOW, rgb
from edugym.rendering.scene import Scene
from edugym.rendering.window import Window

pytestmark = pytest.mark.usefixtures("screen")


def plain(colour: str, height: float = 10) -> Scene:
    """Return a picture of nothing but a colour."""
    return Scene(10, height, (), background=colour)


@pytest.fixture
def screen(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A pretended screen."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    yield
    pygame.quit()


def newest_window() -> pygame.Window:
    """Return the window that was opened last, from the event that says so."""
    window = [event.window for event in pygame.event.get() if event.type == pygame.WINDOWSHOWN][-1]
    assert isinstance(window, pygame.Window)
    return window


def test_windows_live_side_by_side() -> None:
    """Two windows and the user's own display each show their own picture, and the user's events stay in the queue."""
    display = pygame.display.set_mode((30, 20))
    display.fill(rgb(GREEN))
    early, key = (pygame.event.Event(pygame.KEYDOWN, key=key, unicode="") for key in (pygame.K_e, pygame.K_a))
    pygame.event.post(early)
    first, second = Window("first"), Window("second")
    first.show(plain(RED), math.inf)
    assert pygame.event.get(pygame.KEYDOWN) == [early]
    first_window = newest_window()
    second.show(plain(BLUE), math.inf)
    second_window = newest_window()
    pygame.event.post(key)
    first.show(plain(YELLOW, height=5), math.inf)
    second.show(plain(BLUE), math.inf)
    assert first_window.get_surface().get_size() == (480, 240)
    assert first_window.get_surface().get_at((3, 3))[:3] == rgb(YELLOW)
    assert second_window.get_surface().get_at((3, 3))[:3] == rgb(BLUE)
    assert pygame.display.get_surface() is display
    assert display.get_at((3, 3))[:3] == rgb(GREEN)
    assert key in pygame.event.get()
    assert (first_window.title, second_window.title) == ("first", "second")
    first.close()
    second.close()


def test_every_picture_reaches_the_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Once, when it is drawn."""
    seen: list[tuple[int, ...]] = []

    def flip(window: Any) -> None:
        seen.append(tuple(window.get_surface().get_at((3, 3))[:3]))

    monkeypatch.setattr(pygame, "Window", type("Screen", (pygame.Window,), {"flip": flip}))
    window = Window("seen")
    for colour in (RED, BLUE):
        window.show(plain(colour), math.inf)
    assert seen == [rgb(RED), rgb(BLUE)]
    window.close()


def test_closing_a_window_stops_only_its_pictures() -> None:
    """The user closes one of two windows: its environment goes on without pictures, the other as before."""
    first, second = Window("first"), Window("second")
    first.show(plain(PAPER), math.inf)
    window = newest_window()
    second.show(plain(PAPER), math.inf)
    pygame.event.post(pygame.event.Event(pygame.WINDOWCLOSE, window=window))
    pygame.event.post(pygame.event.Event(pygame.QUIT))  # what pygame adds when it was the last one
    second.show(plain(PAPER), math.inf)  # must leave the events of the first
    first.show(plain(PAPER), math.inf)
    assert (first.is_closed, second.is_closed) == (True, False)
    assert not pygame.event.get(pygame.QUIT)
    with pytest.raises(pygame.error):
        window.flip()
    first.show(plain(PAPER), math.inf)
    assert not [event for event in pygame.event.get() if event.type == pygame.WINDOWSHOWN]
    pygame.event.post(pygame.event.Event(pygame.QUIT))  # while a window is open, it is for the user's program
    second.show(plain(PAPER), math.inf)
    assert len(pygame.event.get(pygame.QUIT)) == 1
    for _ in range(2):
        second.close()
    second.show(plain(PAPER), math.inf)
    assert second.is_closed


def test_window_outlives_pygame() -> None:
    """When somebody else shuts pygame down, the next scene opens the window again."""
    window = Window("again")
    window.show(plain(RED), math.inf)
    pygame.quit()
    window.show(plain(BLUE), math.inf)
    assert newest_window().get_surface().get_at((3, 3))[:3] == rgb(BLUE)
    pygame.quit()
    window.close()


def test_window_keeps_the_frame_rate(monkeypatch: pytest.MonkeyPatch) -> None:
    """The second scene waits for what is left of its share of a second; the first does not wait."""
    clock = iter([100.0, 100.0, 100.25, 101.0])
    naps: list[float] = []
    monkeypatch.setattr(time, "monotonic", lambda: next(clock))
    monkeypatch.setattr(time, "sleep", naps.append)
    window = Window("slow")
    window.show(plain(PAPER), 2.0)
    window.show(plain(PAPER), 2.0)
    assert naps == [0.0, 0.25]
    with pytest.raises(ValueError, match="frames_per_second must be positive, got 0"):
        window.show(plain(PAPER), 0)

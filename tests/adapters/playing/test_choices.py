"""The choices below a game in a window."""

from typing import Any

from edugym.adapters.playing import Game
from edugym.adapters.playing.keyboard import LINE_LENGTH, SPACE, InWindow
from edugym.rendering.scene import Scene, Text


class Shown:
    """In place of a window: what is shown in it."""

    def __init__(self) -> None:
        """Nothing yet."""
        self.scenes: list[tuple[Scene, float]] = []

    def show(self, scene: Scene, frames_per_second: float) -> None:
        """Keep it."""
        self.scenes.append((scene, frames_per_second))

    def texts(self) -> list[str]:
        """The lines below the picture that was shown last."""
        return [shape.content for shape in self.scenes[-1][0].shapes if isinstance(shape, Text)]


def test_choices_in_lines_that_fit() -> None:
    """As many as fit stand beside each other; the window does not shrink when there are fewer; nothing waits."""
    window: Any = Shown()
    display, game = InWindow(window), Game("Boulder", height=3)
    left, right = "x" * 30, "y" * (LINE_LENGTH - 30 - len(SPACE))
    display.show(game, left, right, "[r] new", "[q] quit")
    assert window.texts()[-2:] == [left + SPACE + right, f"[r] new{SPACE}[q] quit"]
    size, pause = window.scenes[-1][0].size_in_pixels(), window.scenes[-1][1]
    assert pause == float("inf")
    display.show(game, left, f"{right}y")
    assert window.texts()[-2:] == [left, f"{right}y"]
    display.show(game, "[q] quit")
    assert window.texts()[-2:] == ["[q] quit", ""]
    assert window.scenes[-1][0].size_in_pixels() == size

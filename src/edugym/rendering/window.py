"""Scenes in a window on the screen, for ``render_mode="human"``."""

import time
from collections import deque
from typing import TYPE_CHECKING

from gymnasium.error import DependencyNotInstalled

from edugym.rendering.pixels import require_pygame, to_surface
from edugym.rendering.scene import Scene

if TYPE_CHECKING:
    import pygame


class Window:
    """A window of its own, beside any number of others and beside the user's own pygame display.

    It opens with the first scene. A user who closes it stops the pictures, not the training: from then on ``show``
    returns at once. If somebody calls ``pygame.quit`` meanwhile, as some environments do when they close, the next
    scene opens it again. Where there is no screen, pygame draws unseen.

    Attributes:
        title: The caption.
        is_closed: Whether the user or ``close`` has closed the window, which is for good.
    """

    def __init__(self, title: str) -> None:
        """Prepare a window; it is not open yet."""
        self.title = title
        self.is_closed = False
        self._window: pygame.Window | None = None
        self._last_shown = 0.0
        self._keys: deque[str] = deque()

    def show(self, scene: Scene, frames_per_second: float = 30.0) -> None:
        """Show a scene, after waiting as long as the frame rate asks.

        Args:
            scene: What to draw. The window takes its size.
            frames_per_second: At most so many scenes in a second; infinity for no limit.

        Raises:
            ValueError: If the frame rate is not positive.
            TypeError: If the scene has a shape of an unknown class.
            gymnasium.error.DependencyNotInstalled: If pygame-ce is not installed.
        """
        if not frames_per_second > 0:
            raise ValueError(f"frames_per_second must be positive, got {frames_per_second!r}")
        self._handle_events()
        if self.is_closed:
            return
        picture = to_surface(scene)
        window = self._open(picture.get_size())
        window.get_surface().blit(picture, (0, 0))
        time.sleep(max(0.0, self._last_shown + 1.0 / frames_per_second - time.monotonic()))
        window.flip()
        self._last_shown = time.monotonic()

    def next_key(self) -> str | None:
        """Wait until a key has been pressed in the window since the last one.

        Returns:
            What the key writes ("a", "1"), or else its name ("left", "escape"); None when the window is closed or was
            never opened.
        """
        while not self._keys and not self.is_closed and self._window is not None:
            self._handle_events()
            time.sleep(0.01)
        return self._keys.popleft() if self._keys else None

    def close(self) -> None:
        """Close the window; closing it twice does nothing."""
        self.is_closed = True
        if self._window is not None:
            self._window.destroy()
            self._window = None

    def _open(self, size: tuple[int, int]) -> "pygame.Window":
        """Return the window at a size, opened if it is not open."""
        import pygame

        if not hasattr(pygame, "Window"):
            raise DependencyNotInstalled(
                "windows need pygame-ce, and this is the older pygame: run"
                ' `pip uninstall -y pygame pygame-ce` and `pip install "edugym[render]"`'
            )
        if not pygame.display.get_init():
            pygame.display.init()
            self._window = None  # pygame.quit has taken it away
        try:
            # The same, where pygame has been started again since; of all attributes, only the id then raises an error.
            is_open = self._window is not None and self._window.id > 0
        except pygame.error:
            is_open = False
        if self._window is None or not is_open:
            self._window = pygame.Window(self.title, size)
        elif self._window.size != size:
            self._window.size = size
        return self._window

    def _handle_events(self) -> None:
        """Take this window's events off the queue, so that it stays responsive, and put all others back."""
        require_pygame()
        import pygame

        if self._window is None or not pygame.display.get_init():
            return
        for event in pygame.event.get():
            if event.type == pygame.QUIT and self.is_closed:
                continue  # pygame also says so when its last window is closed
            if getattr(event, "window", None) is not self._window:
                pygame.event.post(event)
            elif event.type == pygame.WINDOWCLOSE:
                self.is_closed = True
            elif event.type == pygame.KEYDOWN:
                written = event.unicode.isprintable() and event.unicode
                self._keys.append(written or pygame.key.name(event.key))
        if self.is_closed:
            self.close()

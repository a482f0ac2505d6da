"""Scenes in a window on the screen, for `render_mode="human"`."""

import time
from collections import deque
from typing import TYPE_CHECKING

from gymnasium.error import DependencyNotInstalled

from edugym.rendering.pixels import require_pygame, to_surface
from edugym.rendering.scene import Scene
from edugym.system.extras import install

if TYPE_CHECKING:
    import pygame


class Window:
    """A window on the screen; there can be several of them, and a pygame display of the user's own.

    It opens with the first scene. When the user closes it, training goes on without pictures: `show` then returns at
    once. After a `pygame.quit`, which some environments call when they close, the next scene opens the window again.
    Without a screen, pygame draws in memory only.

    Attributes:
        title: The title of the window.
        is_closed: Whether the user or `close` has closed the window. A closed window stays closed.
    """

    def __init__(self, title: str) -> None:
        """Prepare a window, which opens with the first scene."""
        self.title = title
        self.is_closed = False
        self._window: pygame.Window | None = None
        self._last_shown = 0.0
        self._keys: deque[str] = deque()

    def show(self, scene: Scene, frames_per_second: float = 30.0) -> None:
        """Show a scene; wait first if the frame rate asks for it.

        Args:
            scene: The scene. The window takes its size.
            frames_per_second: The highest number of scenes in a second; infinity for no limit.

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
        """Wait for the next key that is pressed in the window.

        Returns:
            The character of the key ("a", "1"), or its name if it has none ("left", "escape"); None if the window is
            closed or was never opened.
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
        """Return the window at a size; open it if it is not open."""
        import pygame

        if not hasattr(pygame, "Window"):
            raise DependencyNotInstalled(
                "windows need pygame-ce, and this is the older pygame: run"
                f" `pip uninstall -y pygame pygame-ce` and {install('render')}"
            )
        if not pygame.display.get_init():
            pygame.display.init()
            self._window = None  # pygame.quit has closed it
        try:
            # Somebody may have called pygame.quit and then started pygame again: the id, and only the id, then raises.
            is_open = self._window is not None and self._window.id > 0
        except pygame.error:
            is_open = False
        if self._window is None or not is_open:
            self._window = pygame.Window(self.title, size)
        elif self._window.size != size:
            self._window.size = size
        return self._window

    def _handle_events(self) -> None:
        """Handle the events of this window, which keeps it responsive, and put all others back on the queue."""
        require_pygame()
        import pygame

        if self._window is None or not pygame.display.get_init():
            return
        for event in pygame.event.get():
            if event.type == pygame.QUIT and self.is_closed:
                continue  # pygame adds this event when its last window is closed
            if getattr(event, "window", None) is not self._window:
                pygame.event.post(event)
            elif event.type == pygame.WINDOWCLOSE:
                self.is_closed = True
            elif event.type == pygame.KEYDOWN:
                written = event.unicode.isprintable() and event.unicode
                self._keys.append(written or pygame.key.name(event.key))
        if self.is_closed:
            self.close()

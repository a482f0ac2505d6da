"""A person, or an agent, plays an environment: with keys in a terminal or a window, and kept as a film."""

from edugym.playing.films import play_episode, record
from edugym.playing.game import Frame, Game
from edugym.playing.keyboard import play

__all__ = ["Frame", "Game", "play", "play_episode", "record"]

"""Play an environment, as a person with keys or as an agent, and keep the episode as a film."""

from edugym.playing.films import play_episode, record
from edugym.playing.game import Frame, Game
from edugym.playing.keyboard import play

__all__ = ["Frame", "Game", "play", "play_episode", "record"]

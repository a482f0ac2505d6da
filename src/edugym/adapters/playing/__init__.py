"""Play an environment, as a person with keys or as an agent, and keep the episode as a film."""

from edugym.adapters.playing.films import play_episode, record
from edugym.adapters.playing.game import Frame, Game
from edugym.adapters.playing.keyboard import play

__all__ = ["Frame", "Game", "play", "play_episode", "record"]

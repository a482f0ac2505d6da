"""Episodes as films."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np

from edugym.adapters.fitting import tabular
from edugym.adapters.playing.game import Frame, Game, playable
from edugym.checks.interfaces import a_class
from edugym.checks.parameters import in_short, whole_number
from edugym.mdp.protocol import Random
from edugym.system.files import check_writable

MOST_FRAMES = 100_000
"""The most steps of a film: a picture of each is kept."""


def play_episode(
    environment: Any, actor: Any, *, seed: int = 0, max_steps: int = 200, **parameters: Any
) -> list[Frame]:
    """Play one episode, and keep a frame of its start and of every step.

    Args:
        environment: as for `Game`.
        actor: an agent, which acts by `greedy(observation, rng)`, or by `act` if it has no `greedy`; a function of the
            observation; or a sequence of actions or of their names.
        seed: the seed of the environment and of the agent.
        max_steps: the largest number of steps, from 1 to 100 000: a greedy policy may never reach an end.
        parameters: parameters of an environment that is given by its name or id.

    Raises:
        ValueError: as for `Game`; or a number is not as above; or the observations do not fit the agent's table.
    """
    max_steps = whole_number("max_steps", max_steps, 1, MOST_FRAMES)
    seed = whole_number("seed", seed, 0)
    env = playable(environment, "rgb_array", parameters)
    choose = _policy(actor, env, np.random.default_rng([seed, 1]))
    game = Game(env, seed=seed)
    for step in range(max_steps):
        action = None if game.over else choose(game.observation, step)
        if action is None:
            break
        game.step(action)
    return game.frames


def _policy(actor: Any, env: gymnasium.Env[Any, Any], rng: Random) -> Callable[[Any, int], Any]:
    """A function that chooses an action from the observation and the number of the step, or None to stop.

    Raises:
        ValueError: the actor is neither an agent, nor a function, nor a sequence of actions.
    """
    if isinstance(actor, type):
        raise ValueError(f"actor must be an agent, a function or actions, but is {a_class(actor)}")
    if hasattr(actor, "act"):
        choose = getattr(actor, "greedy", actor.act)
        table: Any = tabular(env) if getattr(actor, "tabular", True) else env
        if table is env:
            return lambda observation, step: choose(observation, rng)
        return lambda observation, step: choose(table.observation(observation), rng)
    if callable(actor):
        return lambda observation, step: actor(observation)
    if not isinstance(actor, Iterable) or isinstance(actor, str):
        raise ValueError(f"actor must be an agent, a function or actions, but is {in_short(actor)}")
    actions = [*actor]
    return lambda observation, step: actions[step] if step < len(actions) else None


def checked_path(path: str | Path) -> Path:
    """Refuse a path to which no film can be written, before the game; create its folder if it does not exist.

    Raises:
        ValueError: the path does not end in .gif.
        OSError: no file can be written there.
    """
    if Path(path).suffix.lower() != ".gif":
        raise ValueError(f"a film must be a file that ends in .gif, but is {str(path)!r}")
    return check_writable(path)


def record(frames: Iterable[Frame], path: str | Path, frames_per_second: float = 4.0) -> None:
    """Write an episode to an animated GIF. Below a scene stands the score.

    Args:
        frames: the episode, from `play_episode` or `Game.replay`.
        path: the file to write.
        frames_per_second: how fast it plays, up to 50.

    Raises:
        ValueError: there are no frames, their pictures are only characters, the speed is not above 0 and up to 50, or
            the file does not end in .gif.
        gymnasium.error.DependencyNotInstalled: Pillow or pygame is not installed.
        OSError: the file cannot be written.
    """
    from edugym.rendering.gif import to_gif

    pictures = [frame.picture if isinstance(frame.picture, np.ndarray) else frame.with_caption() for frame in frames]
    to_gif(pictures, checked_path(path), frames_per_second)

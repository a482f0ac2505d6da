"""An environment as a game: its picture, its actions by name, and the score."""

import os
import sys
from collections.abc import Iterable
from typing import Any, NamedTuple, TypeAlias

import gymnasium
import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv, environment_of
from edugym.adapters.keys import named_actions
from edugym.adapters.registration import specification
from edugym.adapters.sharing import read_mdp
from edugym.checks.parameters import one_of
from edugym.rendering.captions import captioned
from edugym.rendering.scene import Scene

Picture: TypeAlias = Scene | np.ndarray[Any, np.dtype[np.uint8]] | str
"""A picture of an environment: a scene, pixels of shape (height, width, 3), or characters."""

TERMINATED = "Terminated: the task itself has ended."
TRUNCATED = "Truncated: the step limit cuts the episode off."
SHOWN, BESIDE = 8, 4
"""An observation of more numbers than `SHOWN` is not shown; one of more than `BESIDE` gets a line of its own."""


class Frame(NamedTuple):
    """A moment of an episode.

    Attributes:
        picture: the picture of the environment.
        line: the score (see `Game.line`).
    """

    picture: Picture
    line: str

    def with_caption(self, *more: str) -> Scene:
        """The picture with the score and more lines below it.

        Raises:
            ValueError: the picture is not a scene.
        """
        if not isinstance(self.picture, Scene):
            raise ValueError(f"picture must be a scene to have text below it, but is of {type(self.picture)}")
        lines = self.line.split("\n")
        place_for_end = [] if lines[-1] in (TERMINATED, TRUNCATED) else [""]
        return captioned(self.picture, [*lines, *place_for_end, *more])


class Game:
    """An environment, the episode under way, and the score.

    Args:
        environment: its name ("Boulder"), the id of any Gymnasium environment, a file that `edugym.share` wrote
            ("kiosk.py", which is run), an environment, or an MDP.
        seed: the seed of the first episode; the later ones go on from there. None for different games each time.
        picture: how to draw a Gymnasium environment without a scene, "rgb_array" or "ansi", if it offers that.
        parameters: parameters of an environment that is given by its name or id.

    Attributes:
        environment: the Gymnasium environment.
        actions: the actions by name, in order; empty if there are more than `MOST_NAMED`.
        observation: the present observation.
        over: whether the episode has ended.
        returns: the undiscounted return of every finished episode.
        frames: the episode up to now, one frame for the start and one for every step.

    Raises:
        ValueError: there is no such environment, it has no such parameter, a parameter has a wrong value, or nobody
            has named its actions.
    """

    def __init__(
        self, environment: Any, *, seed: int | None = 0, picture: str = "rgb_array", **parameters: Any
    ) -> None:
        """See the class."""
        self.environment = playable(environment, picture, parameters)
        self.actions = named_actions(self.environment)
        self.returns: list[float] = []
        self._last_episode: list[Frame] = []
        self.reset(seed)

    @property
    def name(self) -> str:
        """The id of the environment, or the name of its class."""
        spec, unwrapped = self.environment.spec, self.environment.unwrapped
        return spec.id if spec else type(getattr(unwrapped, "mdp", unwrapped)).__name__

    def reset(self, seed: int | None = None) -> None:
        """Start an episode. An unfinished one does not count."""
        self.observation, _ = self.environment.reset(seed=seed)
        self.over = False
        self._steps, self._return = 0, 0.0
        self._happened, self._reward, self._end = "start", "", ""
        self.frames = [self.frame()]

    def step(self, action: Any) -> None:
        """Take a step.

        Args:
            action: the name of an action, or the action itself.

        Raises:
            ValueError: there is no such action.
            gymnasium.error.ResetNeeded: the episode is over.
        """
        if isinstance(action, str):
            one_of("action", action, list(self.actions))
            action = self.actions[action]
        self.observation, reward, terminated, truncated, _ = self.environment.step(action)
        self.over = terminated or truncated
        self._steps += 1
        self._return += float(reward)
        known = (name for name, named in self.actions.items() if np.array_equal(named, action))
        name = next(known, f"action {_in_short(np.ravel(action))}")
        self._happened, self._reward = f"step {self._steps}: {name}", f"reward {float(reward):.4g}"
        self._end = TERMINATED if terminated else TRUNCATED if truncated else ""
        self.frames.append(self.frame())
        if self.over:
            self.returns.append(self._return)
            self._last_episode = self.frames

    def line(self) -> str:
        """The score: the last step, its reward, and the total so far; then a long observation, and the end."""
        seen, own_line = _in_words(self.observation)
        parts = (self._happened, "" if own_line else seen, self._reward, f"total {self._return:.4g}")
        lines = (", ".join(filter(None, parts)), seen if own_line else "", self._end)
        return "\n".join(filter(None, lines))

    def history(self) -> str:
        """A line on the finished episodes: how many there are, the last ten totals, and the mean of all totals."""
        if not self.returns:
            return "No episode finished yet."
        last = ", ".join(f"{value:.4g}" for value in self.returns[-10:])
        more = "..., " if len(self.returns) > 10 else ""
        return f"Episodes finished: {len(self.returns)}. Totals: {more}{last}. Mean: {np.mean(self.returns):.3g}."

    def picture(self) -> Picture:
        """The present picture: the scene, or else the pixels or characters, or else the observation as text."""
        unwrapped: Any = self.environment.unwrapped
        if hasattr(unwrapped, "scene"):
            scene: Scene = unwrapped.scene()
            return scene
        if unwrapped.render_mode in ("rgb_array", "ansi"):
            drawn: Picture = unwrapped.render()
            return drawn
        return f"observation {self.observation!r}"

    def frame(self) -> Frame:
        """The present picture with the present score."""
        return Frame(self.picture(), self.line())

    def replay(self) -> list[Frame]:
        """The last finished episode, or the unfinished one if there is none."""
        return self._last_episode or self.frames

    def _repr_svg_(self) -> str | None:
        """Show the picture and the score in a notebook, also when no kernel runs."""
        frame = self.frame()
        return frame.with_caption()._repr_svg_() if isinstance(frame.picture, Scene) else None


def playable(environment: Any, picture: str, parameters: dict[str, Any]) -> gymnasium.Env[Any, Any]:
    """The Gymnasium environment to play; the arguments are those of `Game`."""
    one_of("picture", picture, ["rgb_array", "ansi"])
    if not isinstance(environment, str):
        if parameters:
            raise ValueError(f"parameters must go with the name of an environment, but are {sorted(parameters)}")
        return environment if isinstance(environment, gymnasium.Env) else environment_of(environment)
    if environment.endswith(".py"):
        return MDPEnv(read_mdp(environment, **parameters))
    spec, _ = specification(environment, parameters)
    env: gymnasium.Env[Any, Any] = gymnasium.make(spec.id, **parameters)
    if not hasattr(env.unwrapped, "scene") and picture in env.metadata["render_modes"]:
        if sys.platform == "linux" and not {"DISPLAY", "WAYLAND_DISPLAY"} & set(os.environ):
            os.environ.setdefault("SDL_VIDEODRIVER", "dummy")  # else pygame complains that there is no screen
        env = gymnasium.make(spec.id, render_mode=picture, **parameters)
    return env


def _in_words(observation: Any) -> tuple[str, bool]:
    """An observation of a few numbers as text, else "", and whether it needs a line of its own."""
    parts = observation if isinstance(observation, tuple) else (observation,)
    arrays = [np.ravel(part) for part in parts if isinstance(part, int | np.number | np.ndarray)]
    numbers = [number for array in arrays for number in array[: SHOWN + 1]]
    return f"observation {_in_short(numbers)}" if 0 < len(numbers) <= SHOWN else "", len(numbers) > BESIDE


def _in_short(numbers: Iterable[Any]) -> str:
    """Write numbers with spaces between them: whole ones as they are, others with three digits."""
    return " ".join(f"{number:.0f}" if number.is_integer() else f"{number:.3g}" for number in map(float, numbers))

"""An environment as a game: its picture, its actions by name, and the score."""

import os
import sys
from collections.abc import Iterable
from typing import Any, NamedTuple, TypeAlias

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks import one_of
from edugym.registration import specification
from edugym.rendering.captions import captioned
from edugym.rendering.scene import Scene

Picture: TypeAlias = Scene | np.ndarray[Any, np.dtype[np.uint8]] | str
"""What an environment looks like: a scene, pixels of shape (height, width, 3), or characters."""

TERMINATED = "Terminated: the task itself has ended."
TRUNCATED = "Truncated: the step limit cuts the episode off."
SHOWN, BESIDE = 8, 4
"""An observation of more numbers than `SHOWN` is not written out, one of more than `BESIDE` gets a line of its own."""


class Frame(NamedTuple):
    """A moment of an episode.

    Attributes:
        picture: what the environment looks like.
        line: the score (see `Game.line`).
    """

    picture: Picture
    line: str

    def with_caption(self, *more: str) -> Scene:
        """The picture with the score, and more lines, below it.

        Raises:
            ValueError: the picture is not a scene.
        """
        if not isinstance(self.picture, Scene):
            raise ValueError(f"picture must be a scene to have text below it, but is of {type(self.picture)}")
        lines = self.line.split("\n")
        place_for_end = [] if lines[-1] in (TERMINATED, TRUNCATED) else [""]
        return captioned(self.picture, [*lines, *place_for_end, *more])


class Game:
    """An environment that is played, with its score.

    Args:
        environment: its name ("Boulder"), the id of any Gymnasium environment, an environment, or an MDP.
        seed: of the first episode; those after it go on from there. None for other games each time.
        picture: how a Gymnasium environment that has no scene is drawn, "rgb_array" or "ansi", if it can be.
        parameters: of the environment, where its name or id is given.

    Attributes:
        environment: the Gymnasium environment.
        actions: the actions that there are to choose from, by name, in order.
        observation: what the agent sees now.
        over: whether the episode has ended.
        returns: the undiscounted return of every episode that was played to its end.
        frames: the episode up to now, one frame for the start and one for every step.

    Raises:
        ValueError: there is no such environment, it has no such parameter, one is not as its class says, or its
            actions have no names.
    """

    def __init__(
        self, environment: Any, *, seed: int | None = 0, picture: str = "rgb_array", **parameters: Any
    ) -> None:
        """See the class."""
        self.environment = made(environment, picture, parameters)
        self.actions = named_actions(self.environment)
        self.returns: list[float] = []
        self._last_episode: list[Frame] = []
        self.reset(seed)

    @property
    def name(self) -> str:
        """The id of the environment, or what the class of its task is called."""
        spec, unwrapped = self.environment.spec, self.environment.unwrapped
        return spec.id if spec else type(getattr(unwrapped, "mdp", unwrapped)).__name__

    def reset(self, seed: int | None = None) -> None:
        """Start an episode; the one under way, if any, does not count."""
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
        """The score: what the last step brought, and the return so far; a long observation and the end below it."""
        seen, own_line = _in_words(self.observation)
        parts = (self._happened, "" if own_line else seen, self._reward, f"return {self._return:.4g}")
        lines = (", ".join(filter(None, parts)), seen if own_line else "", self._end)
        return "\n".join(filter(None, lines))

    def history(self) -> str:
        """The returns of the episodes that were played to their end, the last ten one by one."""
        if not self.returns:
            return "No episode finished yet."
        last = ", ".join(f"{value:.4g}" for value in self.returns[-10:])
        more = "..., " if len(self.returns) > 10 else ""
        return f"Episodes finished: {len(self.returns)}. Returns: {more}{last}. Mean: {np.mean(self.returns):.3g}."

    def picture(self) -> Picture:
        """What the environment looks like now: its scene, else its pixels or characters, else what the agent sees."""
        unwrapped: Any = self.environment.unwrapped
        if hasattr(unwrapped, "scene"):
            scene: Scene = unwrapped.scene()
            return scene
        if unwrapped.render_mode in ("rgb_array", "ansi"):
            drawn: Picture = unwrapped.render()
            return drawn
        return f"observation {self.observation!r}"

    def frame(self) -> Frame:
        """The present moment."""
        return Frame(self.picture(), self.line())

    def replay(self) -> list[Frame]:
        """The last episode that was played to its end; where there is none, the one under way."""
        return self._last_episode or self.frames

    def _repr_svg_(self) -> str | None:
        """In a notebook a game shows its picture and its score, also where no kernel runs."""
        frame = self.frame()
        return frame.with_caption()._repr_svg_() if isinstance(frame.picture, Scene) else None


def made(environment: Any, picture: str, parameters: dict[str, Any]) -> gymnasium.Env[Any, Any]:
    """The Gymnasium environment to play; the arguments are those of `Game`."""
    one_of("picture", picture, ["rgb_array", "ansi"])
    if not isinstance(environment, str):
        if parameters:
            raise ValueError(f"parameters must go with the name of an environment, but are {sorted(parameters)}")
        return environment if isinstance(environment, gymnasium.Env) else MDPEnv(environment)
    spec, _ = specification(environment, parameters)
    env: gymnasium.Env[Any, Any] = gymnasium.make(spec.id, **parameters)
    if not hasattr(env.unwrapped, "scene") and picture in env.metadata["render_modes"]:
        if sys.platform == "linux" and not {"DISPLAY", "WAYLAND_DISPLAY"} & set(os.environ):
            os.environ.setdefault("SDL_VIDEODRIVER", "dummy")  # else pygame complains that there is no screen
        env = gymnasium.make(spec.id, render_mode=picture, **parameters)
    return env


def named_actions(environment: gymnasium.Env[Any, Any]) -> dict[str, Any]:
    """The actions that there are to choose from, by name.

    These are what the environment offers; else every action by its number; else, where an action is several numbers,
    the lowest and the highest of each of them, with the others in the middle.

    Raises:
        ValueError: the actions are something else, and the environment names none.
    """
    unwrapped: Any = environment.unwrapped
    offered: dict[str, Any] = unwrapped.named_actions() if hasattr(unwrapped, "named_actions") else {}
    if offered:
        return offered
    space = environment.action_space
    if isinstance(space, spaces.Discrete):
        return {str(action): action for action in range(int(space.start), int(space.start + space.n))}
    if isinstance(space, spaces.MultiDiscrete) and len(space.shape) == 1:
        low, high = space.start, space.start + space.nvec - 1
        middle = (low + high) // 2
    elif isinstance(space, spaces.Box) and len(space.shape) == 1 and space.is_bounded():
        low, high = space.low, space.high
        middle = (low + high) / 2
    else:
        raise ValueError(f"the actions of {space} have no names: give the environment a method named_actions")
    actions = {"middle": middle.astype(space.dtype)}
    for k in range(len(middle)):
        for name, end in (("low", low), ("high", high)):
            actions[f"{k} {name}"] = np.where(np.arange(len(middle)) == k, end, middle).astype(space.dtype)
    return actions


def _in_words(observation: Any) -> tuple[str, bool]:
    """An observation, or nothing if it is not one or a few numbers; and whether it needs a line of its own."""
    parts = observation if isinstance(observation, tuple) else (observation,)
    arrays = [np.ravel(part) for part in parts if isinstance(part, int | np.number | np.ndarray)]
    numbers = [number for array in arrays for number in array[: SHOWN + 1]]
    return f"observation {_in_short(numbers)}" if 0 < len(numbers) <= SHOWN else "", len(numbers) > BESIDE


def _in_short(numbers: Iterable[Any]) -> str:
    """Whole numbers as they are, others to three digits."""
    return " ".join(f"{number:.0f}" if number.is_integer() else f"{number:.3g}" for number in map(float, numbers))

"""What a student's Gymnasium environment returns is checked, in its first steps in every way."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import gymnasium
from gymnasium.wrappers import FlattenObservation

from edugym.checks.interfaces import HARMLESS
from edugym.checks.mdps import CHECKED_STEPS
from edugym.checks.parameters import in_short
from edugym.checks.values import ANSWERS, fits, is_finite_number, without_flag
from edugym.system.packages import is_own, package_of


@contextmanager
def checked_env(env: gymnasium.Env[Any, Any], steps: float = CHECKED_STEPS) -> Iterator[gymnasium.Env[Any, Any]]:
    """Yield the environment with checks around what is inside our outermost wrapper, and take them away afterwards.

    An environment that plays an MDP has checks of its own; wrappers around it have not. (If its rewards are vectors,
    which no agent can learn from, the checks say so.)

    Args:
        env: the environment.
        steps: how many steps are checked in every way.
    """
    layers = _layers(env)
    if all(map(is_own, layers)) and not hasattr(layers[-1], "reward_space"):
        yield env
    elif isinstance(env, gymnasium.Wrapper) and (is_own(env) or isinstance(env, FlattenObservation)):
        inner = env.env
        env.env = CheckedEnv(inner, steps)
        try:
            yield env
        finally:
            env.env = inner
    else:
        yield CheckedEnv(env, steps)


def _layers(env: gymnasium.Env[Any, Any]) -> list[gymnasium.Env[Any, Any]]:
    """Return an environment's wrappers from outside in, without those of `gymnasium.make`, and what is in them."""
    layers = [env]
    while isinstance(layers[-1], gymnasium.Wrapper):
        layers.append(layers[-1].env)
    return [layer for layer in layers if not isinstance(layer, HARMLESS)]


class CheckedEnv(gymnasium.Wrapper[Any, Any, Any, Any]):
    """A student's Gymnasium environment that checks rewards and ends, and in its first steps everything else.

    Args:
        env: the environment.
        steps: how many steps are checked in every way.
    """

    def __init__(self, env: gymnasium.Env[Any, Any], steps: float = CHECKED_STEPS) -> None:
        """See the class."""
        super().__init__(env)
        self._left = steps
        layers = [layer for layer in _layers(env) if not is_own(layer)]
        students = [layer for layer in layers if package_of(type(layer)) != "gymnasium"]
        inside = env.unwrapped
        self._of = type((students or layers or [inside])[0] if is_own(inside) else inside).__name__

    def reset(self, **options: Any) -> Any:
        """Start an episode.

        Raises:
            ValueError: what it returns is no observation and info.
        """
        returned: Any = self.env.reset(**options)
        if self._left <= 0:
            return returned
        if not (isinstance(returned, tuple) and len(returned) == 2 and isinstance(returned[1], dict)):
            raise ValueError(f"reset of {self._of} must return (observation, info), but returned {in_short(returned)}")
        self._require_observation("reset", returned[0])
        return returned

    def step(self, action: Any) -> Any:
        """Take a step.

        Raises:
            ValueError: what it returns is no observation, reward, terminated, truncated and info, or one of these is
                not what it must be.
        """
        returned: Any = self.env.step(action)
        self._left -= 1
        is_whole = isinstance(returned, tuple) and len(returned) == 5
        answers = is_whole and isinstance(returned[2], ANSWERS) and isinstance(returned[3], ANSWERS)
        if self._left < 0 and answers and is_finite_number(returned[1]):
            return returned
        if not is_whole:
            raise ValueError(
                f"step of {self._of} must return (observation, reward, terminated, truncated, info), but returned"
                f" {in_short(returned)} for action {in_short(action)}"
            )
        observation, reward, *ends, _ = returned
        self._require_observation("step", observation)
        if not is_finite_number(reward):
            raise ValueError(
                f"step of {self._of} must return a finite number as reward, but returned {in_short(reward)} for action"
                f" {in_short(action)}"
            )
        for name, end in zip(("terminated", "truncated"), ends, strict=True):
            if not isinstance(end, ANSWERS):
                raise ValueError(
                    f"step of {self._of} must return True or False as {name}, but returned {in_short(end)}"
                )
        return returned

    def _require_observation(self, method: str, observation: Any) -> None:
        space = self.env.observation_space
        if not fits(space, without_flag(space, observation)):
            raise ValueError(
                f"{method} of {self._of} must return an observation in {self.env.observation_space}, but returned"
                f" {in_short(observation)}"
            )

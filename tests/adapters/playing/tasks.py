"""What the tests of playing play."""

from typing import Any, NamedTuple

import gymnasium
from gymnasium import spaces

from edugym.mdp.protocol import Random


class Walk(NamedTuple):
    """Five places in a row; the walker starts in the middle, and the right end pays."""

    max_steps: int = 4

    @property
    def action_names(self) -> tuple[str, str]:
        """What the actions mean."""
        return "left", "right"

    @property
    def observation_space(self) -> spaces.Discrete:
        """The places."""
        return spaces.Discrete(5)

    @property
    def action_space(self) -> spaces.Discrete:
        """Left and right."""
        return spaces.Discrete(2)

    def initial(self, rng: Random) -> int:
        """The middle."""
        return 2

    def transition(self, state: int, action: int, rng: Random) -> int:
        """One place on."""
        return state + 2 * action - 1

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """1.5 for the right end."""
        return 1.5 if next_state == 4 else 0.0

    def terminal(self, state: int) -> bool:
        """Both ends."""
        return state in (0, 4)

    def observation(self, state: int, rng: Random) -> int:
        """The place."""
        return state


class Still(gymnasium.Env[Any, Any]):
    """An environment with any actions and observations, in which nothing happens and nothing can be seen."""

    def __init__(self, action_space: spaces.Space[Any], observation: Any = 0) -> None:
        """Take the space of its actions, and its only observation."""
        self.action_space = action_space
        self._observation = observation

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Show the observation."""
        return self._observation, {}

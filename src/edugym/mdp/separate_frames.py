"""The last few observations one by one: the window of `FrameStack`, for agents that learn from numbers."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.frame_stack import FrameStack
from edugym.mdp.protocol import Integers, Random
from edugym.mdp.wrapper import wrapper


@wrapper
class SeparateFrames(NamedTuple):
    """A `FrameStack` that shows its observations as separate whole numbers in place of the row of a table.

    The numbers stand in order: the oldest observation, the action after it (if actions are shown), the next
    observation, ..., the latest observation. A network can learn what they have in common, where a table has a row for
    every combination: DQN and the agents of Stable-Baselines3 take each number as a vector with a single 1.

    Make one with `SeparateFrames.create(mdp, k, actions=False)`.

    Attributes:
        mdp: the stack.
        sizes: shape (n,): how many values each number takes.
    """

    mdp: Any
    sizes: Integers

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """A whole number for each observation and each action."""
        return spaces.MultiDiscrete(self.sizes)

    def observation(self, state: Any, rng: Random) -> Any:
        """What `observe_into` writes, as a new array."""
        out = np.empty_like(self.sizes)
        self.observe_into(state, rng, out)
        return out

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write the numbers into `out`, shape (n,)."""
        row = int(self.mdp.observation(state, rng))
        for i in range(len(self.sizes) - 1, -1, -1):
            out[i] = row % self.sizes[i]
            row //= self.sizes[i]

    @classmethod
    def create(cls, mdp: Any, k: int, actions: bool = False) -> "SeparateFrames":
        """The wrapper for an MDP that observes whole numbers.

        Args:
            mdp: the task.
            k: how many observations to show, 1 or more.
            actions: whether to show the actions between them as well.

        Raises:
            ValueError: as `FrameStack.create`.
        """
        stack = FrameStack.create(mdp, k, actions)
        between = [stack.n_actions] if stack.n_actions > 1 else []
        sizes = [stack.n_observations, *(k - 1) * [*between, stack.n_observations]]
        return cls(stack, np.array(sizes, np.int64))

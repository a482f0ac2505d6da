"""A frozen lake with eyes shut: hidden state in an environment of Gymnasium."""

from collections.abc import Sequence
from functools import partial
from typing import Any

import gymnasium
from gymnasium import spaces

from edugym.agents.q_learning import QLearning
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.frame_stack import stack_size
from edugym_course.lessons.memory.players import joined

MAX_STEPS = 100


class EyesShut(gymnasium.ObservationWrapper[Any, Any, Any]):
    """An environment in which every observation is 0, so that the agent sees nothing."""

    def __init__(self, env: Any) -> None:
        """Wrap an environment."""
        super().__init__(env)
        self.observation_space = spaces.Discrete(1)

    def observation(self, observation: Any) -> int:
        """Return 0."""
        return 0


class Window(gymnasium.Wrapper[Any, Any, Any, Any]):
    """The last k observations of an environment of Gymnasium, and the actions between them if wanted, as one number."""

    def __init__(self, env: Any, k: int, actions: bool = False) -> None:
        """Wrap an environment with whole numbers for observations and actions."""
        super().__init__(env)
        self.k, self.actions = k, actions
        self.n, self.m = int(env.observation_space.n), int(env.action_space.n)
        self.observation_space = spaces.Discrete(stack_size(self.n, k, self.m if actions else 1))
        self.seen: list[int] = []
        self.taken: list[int] = []

    def reset(self, **how: Any) -> tuple[int, dict[str, Any]]:
        """Start with k copies of the first observation, and action 0 between them."""
        first, info = self.env.reset(**how)
        self.seen, self.taken = [int(first)] * self.k, [0] * (self.k - 1)
        return self.row(), info

    def step(self, action: Any) -> tuple[int, Any, bool, bool, dict[str, Any]]:
        """Take a step; the oldest observation and action go, the new ones come."""
        seen, reward, terminated, truncated, info = self.env.step(action)
        self.seen = [*self.seen, int(seen)][-self.k :]
        self.taken = [*self.taken, int(action)][1:]
        return self.row(), reward, terminated, truncated, info

    def row(self) -> int:
        """Return the row of a table for what is in the window."""
        row = self.seen[0]
        for action, seen in zip(self.taken, self.seen[1:], strict=True):
            row = (row * self.m + action if self.actions else row) * self.n + seen
        return row


def blind_lake(k: int, actions: bool) -> Any:
    """Make a frozen lake, not slippery, with eyes shut, seen through a window."""
    return Window(EyesShut(gymnasium.make("FrozenLake-v1", is_slippery=False)), k, actions)


def learn_blindly(windows: Sequence[tuple[int, bool]], *, n_steps: int = 20_000, **how: Any) -> Results:
    """Train Q-learning on the lake with eyes shut.

    Args:
        windows: the windows: the number of observations, and whether the actions between them are shown.
        n_steps: the training steps of each run.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions` and `seed`.
    """
    make = partial(QLearning.create, learning_rate=0.1, discount=0.9)
    how = {"max_steps": MAX_STEPS, "evaluate_every": max(n_steps // 20, 1), **how}
    return joined(
        [repeat(blind_lake(k, actions), {lake_label(k, actions): make}, n_steps, **how) for k, actions in windows]
    )


def lake_label(k: int, actions: bool) -> str:
    """Return the label of a window on the lake."""
    return f"k = {k} with actions" if actions else f"k = {k}"

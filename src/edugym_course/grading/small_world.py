"""The small worlds in which programs from a blank file are tried."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.programs import APART

LAYERS, WIDTH, ACTIONS = 6, 2, 4
GOES_ON, ENDS = 0.03, 0.2
"""The probability that an action ends the episode: small or large. Without chance, one that is large always does."""


class SmallWorld(gymnasium.Env[Any, Any]):
    """A small random MDP in layers: no state comes twice in an episode.

    An episode may end after any step. The number that is observed then is that of an ordinary state, as Gymnasium
    allows, so a program that looks up the value of a terminal state finds one.

    Args:
        seed: the number from which the MDP is drawn.
        truncates: whether episodes may also be truncated.
        noisy: whether rewards, next states and ends also depend on chance.
        n_actions: how many actions there are.

    Attributes:
        states: the number of the state at each place, layer by layer.
    """

    def __init__(self, seed: int, truncates: bool = True, noisy: bool = True, n_actions: int = ACTIONS) -> None:
        """Draw an MDP."""
        n, rng = LAYERS * WIDTH, np.random.default_rng(APART + seed)
        self.observation_space = spaces.Discrete(n)
        self.action_space = spaces.Discrete(n_actions)
        self.states = rng.permutation(n)
        self._rewards = rng.choice([-4.0, -2.0, -1.0, 1.0, 2.0, 3.0], (n, n_actions))
        self._ends = rng.choice([GOES_ON, ENDS], (n, n_actions))
        self._next = rng.integers(WIDTH, size=(n, n_actions, 2))
        if not noisy:  # no two actions that were tried are worth the same: which one wins then is up to the program
            self._rewards += rng.random((n, n_actions))
        self._truncates, self._noisy = truncates, noisy
        self._place = 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin in the first layer."""
        super().reset(seed=seed)
        self._place = int(self.np_random.integers(WIDTH))
        return int(self.states[self._place]), {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Go to the next layer, or end."""
        noise, way = (int(self.np_random.integers(*limits)) for limits in ((-2, 3), (0, 2)))
        end = float(self.np_random.random())
        if not self._noisy:
            noise, end, way = 0, (GOES_ON + ENDS) / 2, 0
        reward = float(self._rewards[self._place, action] + noise)
        is_last = self._place >= (LAYERS - 1) * WIDTH
        terminated = bool(is_last or end < self._ends[self._place, action])
        layer = (self._place // WIDTH + 1) % LAYERS
        self._place = layer * WIDTH + int(self._next[self._place, action, way])
        truncated = bool(self._truncates and not terminated and self.np_random.random() < 0.3)
        return int(self.states[self._place]), reward, terminated, truncated, {}

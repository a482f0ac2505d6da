"""Bandits in which the project of lesson 0b is tried: with noise and episodes of two lengths, and without chance."""

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Reals
from edugym_course.grading.programs import APART

PULLS = 100
"""How many pulls an episode has where the arms have no chance."""
CERTAIN_ARMS = 8
FADES = 900
"""So many pulls the best arm pays 1, and 0 from then on. Its mean says for 600 more that it is the best one."""


class Machines(gymnasium.Env[Any, Any]):
    """Four arms with rewards around means of their own; episodes end after 40 pulls, or after 2.

    In every third world all means are below 0. An arm that was never pulled looks best there, with its value of 0. In
    every third one rewards hardly depend on chance: whoever begins with other values than 0 pulls other arms there. In
    three of six episodes are short: whoever does not learn from their last pull misses half of all. In every second
    one episodes end with `terminated`.

    Args:
        seed: the number from which the means are drawn, and which says which of these worlds it is.
        truncates: whether ends may be truncations.
        noisy: whether rewards also depend on chance.
    """

    def __init__(self, seed: int, truncates: bool = True, noisy: bool = True) -> None:
        """Draw the means."""
        rng = np.random.default_rng(APART + seed)
        self.observation_space, self.action_space = spaces.Discrete(1), spaces.Discrete(4)
        self._means: Reals = rng.permutation([-0.5, 0.5, 0.8, 1.0]) - 2.0 * (seed % 3 == 1)
        self._truncates = truncates and seed % 2 == 0
        self._noise, self._pulls = (0.1 if seed % 3 == 2 else 2.0) * noisy, 0
        self._length = 2 if seed % 6 > 2 else 40

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin an episode; the arms stay the same."""
        super().reset(seed=seed)
        self._pulls = 0
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pull an arm."""
        self._pulls += 1
        reward = float(self._means[action] + self._noise * self.np_random.normal())
        over = self._pulls == self._length
        return 0, reward, over and not self._truncates, over and self._truncates, {}


class Certain(gymnasium.Env[Any, Any]):
    """Arms without chance: each always pays the same, 1 or a few thousandths less; or one pays 1 until it fades.

    Where they are alike a small bonus decides which looks best, and where one fades the weight of its old rewards.

    Args:
        seed: the number from which it is drawn which arm pays how much.
        fades: whether the best arm fades; the others then pay 0.6 and less.
        scale: what the best arm pays.
    """

    observation_space, action_space = spaces.Discrete(1), spaces.Discrete(CERTAIN_ARMS)

    def __init__(self, seed: int, fades: bool, scale: float = 1.0) -> None:
        """Draw which arm pays how much."""
        ranks = np.random.default_rng(APART + seed).permutation(CERTAIN_ARMS).tolist()
        self._pays = [scale - (0.35 + 0.05 * rank if fades and rank else 0.001 * rank) for rank in ranks]
        self._fading = ranks.index(0) if fades else -1
        self._pulls = 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin an episode; the arms stay the same."""
        super().reset(seed=seed)
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pull an arm."""
        self._pulls += 1
        has_faded = action == self._fading and self._pulls > FADES
        return 0, 0.0 if has_faded else self._pays[action], False, self._pulls % PULLS == 0, {}

"""A Fourier basis of what an environment shows, for networks that are small."""

import itertools
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.wrappers import TransformObservation


def fourier(env: gymnasium.Env[Any, Any], order: int = 3) -> gymnasium.Env[Any, Any]:
    """Show a Fourier basis of the observation, cos(π c·s) with s from 0 to 1 (Sutton and Barto, section 9.5.2)."""
    box: Any = env.observation_space
    c = np.array(list(itertools.product(range(order + 1), repeat=len(box.low))))
    space = spaces.Box(-1, 1, (len(c),), np.float32)
    return TransformObservation(
        env, lambda s: np.cos(np.pi * c @ ((s - box.low) / (box.high - box.low))).astype(np.float32), space
    )

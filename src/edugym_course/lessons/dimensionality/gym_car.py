"""MountainCar of Gymnasium: real numbers, which no table can list."""

from functools import partial
from typing import Any

import gymnasium

from edugym.agents.semi_gradient_sarsa import SemiGradientSARSA
from edugym.agents.strategies import EpsilonGreedy
from edugym.agents.tile_coding import TileCoding
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results

MAX_STEPS = 1_000


def mountain_car() -> Any:
    """Return the environment, with episodes of at most 1 000 steps."""
    return gymnasium.make("MountainCar-v0", max_episode_steps=MAX_STEPS)


def drive(n_steps: int = 20_000, repetitions: int = 3, **how: Any) -> Results:
    """Train semi-gradient SARSA in the car: linear in position and speed themselves, and with tile coding.

    Args:
        n_steps: the training steps.
        repetitions: how many runs.
        **how: more arguments of `edugym.experiments.repeat`.
    """
    env = mountain_car()
    settings: dict[str, Any] = {"discount": 1.0, "exploration": EpsilonGreedy(0.0)}
    coding = TileCoding.create(env, tiles=8, tilings=8)
    methods = {
        "linear in position and speed": partial(SemiGradientSARSA.create, learning_rate=0.1, **settings),
        "tile coding": partial(SemiGradientSARSA.create, learning_rate=0.5, features=coding, **settings),
    }
    every = max(n_steps // 5, 1)
    return repeat(
        env, methods, n_steps, evaluate_every=every, evaluation_episodes=3, repetitions=repetitions, jobs=1, **how
    )

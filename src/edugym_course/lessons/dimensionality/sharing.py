"""Convolutional networks on balls from columns that were withheld in training."""

import dataclasses
from functools import lru_cache, partial
from typing import Any

import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.experiments.results.tables import Results
from edugym.training.run import Run
from edugym_course.lessons.dimensionality.networks import CNN_SETTINGS, with_cnn
from edugym_course.lessons.dimensionality.tasks import COLUMNS, TRAINED, catch
from edugym_course.stored import Stored

N_STEPS = 30_000
SMALL, COLUMN = "PPO, small CNN", "PPO, CNN over columns"


@lru_cache(maxsize=64)
def train_cnn(label: str, n_steps: int, seed: int = 0) -> Run:
    """Train PPO with a CNN on balls from three columns; the same run is not repeated."""
    from edugym.deep.baselines import stable_baselines3_run
    from edugym_course.lessons.dimensionality.layers import ColumnCNN, SmallCNN

    cnn = with_cnn(SmallCNN if label == SMALL else ColumnCNN)
    return stable_baselines3_run(
        MDPEnv(catch("rgb", TRAINED)), "PPO", n_steps, evaluate_every=n_steps, seed=seed, **CNN_SETTINGS, **cnn
    )


def play(agent: Any, column: int) -> float:
    """Return what an agent of Stable-Baselines3 gets, greedy, for a ball from a column."""
    env = MDPEnv(catch("rgb", [column]))
    observation, _ = env.reset(seed=0)
    over, total = False, 0.0
    while not over:
        observation, reward, over, _, _ = env.step(int(agent.predict(observation, deterministic=True)[0]))
        total += float(reward)
    return total


def train_and_test(label: str, column: int, n_steps: int, *, seed: int = 0) -> Run:
    """Train with balls from three columns; the only point of the curve is the return for a ball from `column`."""
    run = train_cnn(label, n_steps, seed)
    last = {name: getattr(run, name)[-1:] for name in ("steps", "training_returns", "episodes")}
    return dataclasses.replace(run, returns=np.array([play(run.agent, column)]), **last)


def labels(label: str) -> list[str]:
    """Return the labels of a network tested on each column."""
    return [f"{label}: ball from column {column}" for column in range(COLUMNS)]


def learn_to_share(**how: Any) -> Results:
    """Train both networks, and test them on every column.

    Args:
        **how: arguments of `edugym.deep.repeated.repeat_deep`, such as `repetitions`, `seed` and `jobs`.
    """
    from edugym.deep.repeated import repeat_deep

    trainers = {
        name: partial(train_and_test, label, column)
        for label in (SMALL, COLUMN)
        for column, name in enumerate(labels(label))
    }
    return repeat_deep(trainers, N_STEPS, **{"jobs": 1, **how})


STORED = Stored(
    "dimensionality.sharing",
    learn_to_share,
    (
        "edugym.envs.catch",
        "edugym.deep.baselines",
        "edugym_course.lessons.dimensionality.boards",
        "edugym_course.lessons.dimensionality.tasks",
        "edugym_course.lessons.dimensionality.layers",
        "edugym_course.lessons.dimensionality.networks",
    ),
)

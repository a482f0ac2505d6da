"""What the tests of learning from data share: a dataset that is worked out by hand, and data of random models."""

from typing import Any

import numpy as np

from edugym import Dataset, FiniteModel, collect
from tests.exact.tasks import random_model


def by_hand(**change: Any) -> Dataset:
    """Three episodes: (0, 1) pays 2 and leads to 1, where 0 pays 4 and ends; (0, 1) pays 0 and ends; (0, 0) is cut off.

    Each action was taken with probability 1/2, but the last one with 1/4.
    """
    given: dict[str, Any] = {
        "states": [0, 1, 0, 0],
        "actions": [1, 0, 1, 0],
        "rewards": [2.0, 4.0, 0.0, 8.0],
        "next_states": [1, 2, 2, 1],
        "terminated": [False, True, True, False],
        "truncated": [False, False, False, True],
        "probabilities": [0.5, 0.5, 0.5, 0.25],
        "n_states": 3,
        "n_actions": 2,
    }
    return Dataset.create(**(given | change))


def random_data(seed: int, n_episodes: int = 20, max_steps: int = 6) -> tuple[FiniteModel, Any, Any, Dataset]:
    """A random model, a target policy, a behaviour policy, and episodes of the latter."""
    model, rng = going_on(random_model(seed, n_actions=3)), np.random.default_rng(seed)
    target, behaviour = rng.dirichlet(np.ones(3), 4), rng.dirichlet(np.full(3, 2.0), 4)
    return model, target, behaviour, collect(model, behaviour, n_episodes, max_steps=max_steps, seed=seed)


def going_on(model: FiniteModel) -> FiniteModel:
    """A model whose episodes begin anywhere but at the end."""
    inside = np.where(model.terminal, 0.0, model.initial)
    return model._replace(initial=inside / inside.sum())

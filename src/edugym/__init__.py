"""EduGym: a reinforcement-learning course you can run.

Importing it registers the environments with Gymnasium, and nothing more: the names below are loaded when first used.
"""

import importlib
from typing import TYPE_CHECKING, Any

from edugym.registration import ENVIRONMENTS, make_mdp, register_environments

if TYPE_CHECKING:
    from edugym.adapters.gymnasium_env import MDPEnv
    from edugym.adapters.vector_env import MDPVectorEnv
    from edugym.agents.count_based import CountBased
    from edugym.agents.go_explore import GoExplore
    from edugym.agents.q_learning import QLearning
    from edugym.agents.saving import load, save
    from edugym.agents.strategies import (
        UCB,
        EpsilonGreedy,
        ExponentialDecay,
        Greedy,
        LinearDecay,
        ScheduledEpsilonGreedy,
        Softmax,
    )
    from edugym.exact.model import finite_model
    from edugym.exact.tables import FiniteModel
    from edugym.exact.value_iteration import value_iteration
    from edugym.mdp.tabular import Tabular, TabularObservation, table_size
    from edugym.results.tables import Results
    from edugym.training.repeat import repeat
    from edugym.training.train import Run, train

__version__ = "0.1.0"

__all__ = [
    "ENVIRONMENTS",
    "UCB",
    "CountBased",
    "EpsilonGreedy",
    "ExponentialDecay",
    "FiniteModel",
    "GoExplore",
    "Greedy",
    "LinearDecay",
    "MDPEnv",
    "MDPVectorEnv",
    "QLearning",
    "Results",
    "Run",
    "ScheduledEpsilonGreedy",
    "Softmax",
    "Tabular",
    "TabularObservation",
    "finite_model",
    "load",
    "make_mdp",
    "register_environments",
    "repeat",
    "save",
    "table_size",
    "train",
    "value_iteration",
]

_HOMES = {
    "edugym.agents.count_based": ("CountBased",),
    "edugym.agents.strategies": (
        "UCB",
        "EpsilonGreedy",
        "ExponentialDecay",
        "Greedy",
        "LinearDecay",
        "ScheduledEpsilonGreedy",
        "Softmax",
    ),
    "edugym.agents.go_explore": ("GoExplore",),
    "edugym.agents.q_learning": ("QLearning",),
    "edugym.agents.saving": ("load", "save"),
    "edugym.training.repeat": ("repeat",),
    "edugym.results.tables": ("Results",),
    "edugym.training.train": ("Run", "train"),
    "edugym.adapters.gymnasium_env": ("MDPEnv",),
    "edugym.exact.model": ("finite_model",),
    "edugym.exact.tables": ("FiniteModel",),
    "edugym.adapters.vector_env": ("MDPVectorEnv",),
    "edugym.exact.value_iteration": ("value_iteration",),
    "edugym.mdp.tabular": ("Tabular", "TabularObservation", "table_size"),
}

register_environments()


def __getattr__(name: str) -> Any:
    """Load a public name when it is first used."""
    for home, names in _HOMES.items():
        if name in names:
            return getattr(importlib.import_module(home), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

"""EduGym: a reinforcement-learning course you can run.

Importing it registers the environments with Gymnasium, and nothing more: the names below are loaded when first used.
"""

import importlib
from typing import TYPE_CHECKING, Any

from edugym.registration import ENVIRONMENTS, make_mdp, register_environments

if TYPE_CHECKING:
    from edugym.agents.count_based import CountBased
    from edugym.agents.exploration import (
        UCB,
        EpsilonGreedy,
        ExponentialDecay,
        Greedy,
        LinearDecay,
        ScheduledEpsilonGreedy,
        Softmax,
    )
    from edugym.agents.go_explore import GoExplore
    from edugym.agents.q_learning import QLearning
    from edugym.agents.saving import load, save
    from edugym.experiments.repeat import repeat
    from edugym.experiments.results import Results
    from edugym.experiments.training import Run, train
    from edugym.mdp.env import MDPEnv
    from edugym.mdp.model import FiniteModel, finite_model
    from edugym.mdp.vector import MDPVectorEnv
    from edugym.planning.value_iteration import value_iteration
    from edugym.wrappers.tabular import Tabular, TabularObservation, table_size

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
    "edugym.agents.exploration": (
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
    "edugym.experiments.repeat": ("repeat",),
    "edugym.experiments.results": ("Results",),
    "edugym.experiments.training": ("Run", "train"),
    "edugym.mdp.env": ("MDPEnv",),
    "edugym.mdp.model": ("FiniteModel", "finite_model"),
    "edugym.mdp.vector": ("MDPVectorEnv",),
    "edugym.planning.value_iteration": ("value_iteration",),
    "edugym.wrappers.tabular": ("Tabular", "TabularObservation", "table_size"),
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

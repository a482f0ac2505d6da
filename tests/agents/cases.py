"""Every agent and every exploration strategy of the package, for the tests that hold for all of them.

Both are found by their files. An agent that is not in `DESCRIBED` is tested at its defaults.
"""

import importlib
import math
import pkgutil
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium.wrappers import FlattenObservation

import edugym as eg
from edugym import agents, games, objectives
from edugym.adapters.fitting import tabular
from edugym.checks.contract import takes_vectors


class Case(NamedTuple):
    """An agent to test.

    Attributes:
        kind: its class.
        create: makes a new one for an environment (or the shape of its table).
        estimates_return: whether its Q(s, a) estimates the discounted return at learning rate and discount 0.5, for
            which there are closed forms.
        real_actions: whether its actions are real numbers: it is then tested in environments that have such.
    """

    kind: Any
    create: Callable[[Any], Any]
    estimates_return: bool = False
    real_actions: bool = False

    @property
    def vectors(self) -> bool:
        """Whether it takes observations as vectors of numbers."""
        return takes_vectors(self.create((2, 2)))

    def fit(self, environment: Any) -> Any:
        """An MDP or Gymnasium environment with observations as `train` shows them to the agent."""
        if not self.vectors:
            return tabular(environment)
        return FlattenObservation(environment) if isinstance(environment, gymnasium.Env) else environment


def _case(kind: Any, **settings: Any) -> Case:
    return Case(kind, lambda environment: kind.create(environment, **settings))


def _halves(kind: Any, **settings: Any) -> Case:
    """An agent whose values have closed forms."""
    return _case(kind, learning_rate=0.5, discount=0.5, **settings)._replace(estimates_return=True)


FEW: dict[str, Any] = {"hidden": 5, "memory_size": 64, "batch_size": 4, "learn_from": 8, "copy_every": 3}
"""Five hidden units, and learning from the start."""


def small_dqn(environment: Any, **settings: Any) -> eg.DQN:
    """A network of a few units."""
    return eg.DQN.create(environment, **{**FEW, **settings})


def small_hindsight(environment: Any, **settings: Any) -> eg.HindsightDQN:
    """The same with hindsight."""
    return eg.HindsightDQN.create(environment, **{**FEW, **settings})


def small_gaussian(environment: Any, **settings: Any) -> eg.GaussianActorCritic:
    """With two tiles a number."""
    features = eg.TileCoding.create(environment, 2) if hasattr(environment, "action_space") else None
    return eg.GaussianActorCritic.create(environment, features=features, **settings)


DESCRIBED: dict[str, Case] = {
    "QLearning": _halves(eg.QLearning),
    "QLearning, ties by rounding": _case(
        eg.QLearning, learning_rate=1.0, discount=0.9, initial_value=1.0, exploration=eg.Greedy()
    ),
    "SARSA": _halves(eg.SARSA),
    "ExpectedSARSA": _halves(eg.ExpectedSARSA),
    "ExpectedSARSA, softmax": _case(eg.ExpectedSARSA, exploration=eg.Softmax(0.3)),
    "CountBased": _halves(eg.CountBased, bonus=0.0),
    "CountBased with its bonus": _case(eg.CountBased),
    "RiskSensitiveQLearning, neutral": _halves(eg.RiskSensitiveQLearning, risk=0),
    "RiskSensitiveQLearning, averse": _case(eg.RiskSensitiveQLearning, risk=-2),
    "RiskSensitiveQLearning, seeking": _case(eg.RiskSensitiveQLearning, risk=1),
    "MaxminQLearning": _case(eg.MaxminQLearning),
    "MaxminQLearning, one table": _halves(eg.MaxminQLearning, n_tables=1),
    "NStepSARSA": _halves(eg.NStepSARSA, n=3),
    "Monte Carlo": _case(eg.NStepSARSA, n=math.inf, longest=25),
    "TreeBackup": _halves(eg.TreeBackup, n=3),
    "TreeBackup, soft target": _case(eg.TreeBackup, target_policy=eg.EpsilonGreedy(0.3)),
    "SARSALambda": _halves(eg.SARSALambda),
    "SARSALambda, accumulating": _case(eg.SARSALambda, traces=eg.Accumulating()),
    "SARSALambda, Dutch": _case(eg.SARSALambda, traces=eg.Dutch()),
    "QLambda": _halves(eg.QLambda),
    "QLambda, accumulating": _case(eg.QLambda, traces=eg.Accumulating()),
    "QLambda, Dutch": _case(eg.QLambda, traces=eg.Dutch()),
    "DynaQ without planning": _halves(eg.DynaQ, planning_steps=0),
    "DynaQ": _case(eg.DynaQ),
    "Dyna-Q+, expected": _case(eg.DynaQ, exploration_bonus=0.1, expected_updates=True),
    "PrioritisedSweeping": _case(eg.PrioritisedSweeping),
    "PrioritisedSweeping, sampled": _case(eg.PrioritisedSweeping, expected_updates=False, planning_steps=3),
    "RMax": _case(eg.RMax),
    "RMax, known after 3": _case(eg.RMax, known_after=3, planning_steps=4),
    "UCT": _case(eg.UCT, simulations=12, depth=4),
    "UCT, four nodes": _case(eg.UCT, simulations=11, depth=3, nodes=4, initial_value=1.0),
    "GoExplore": _case(eg.GoExplore, explore_steps=3, longest=50),
    "REINFORCE": _case(eg.REINFORCE, longest=200),
    "GaussianActorCritic": Case(eg.GaussianActorCritic, small_gaussian, real_actions=True),
    "DQN": Case(eg.DQN, small_dqn),
    "HindsightDQN": Case(eg.HindsightDQN, small_hindsight),
    "HindsightQLearning": _halves(eg.HindsightQLearning),
}
STRATEGIES: dict[str, Callable[[Any], Any]] = {
    "greedy": lambda environment: eg.Greedy(),
    "epsilon-greedy": lambda environment: eg.EpsilonGreedy(0.2),
    "linear decay": lambda environment: eg.ScheduledEpsilonGreedy.create(eg.LinearDecay(1.0, 0.1, 500)),
    "exponential decay": lambda environment: eg.ScheduledEpsilonGreedy.create(eg.ExponentialDecay(1.0, 0.05, 0.99)),
    "softmax": lambda environment: eg.Softmax(0.3),
    "ucb": lambda environment: eg.UCB.create(environment, 0.5),
    "thompson": lambda environment: eg.ThompsonSampling.create(environment, 0.5),
}


def package_classes(method: str) -> Iterator[type]:
    """Every NamedTuple class in `edugym.agents` that has such a method, and that `edugym.train` trains."""
    others = {*games.__all__, *objectives.__all__}
    for module in pkgutil.iter_modules(agents.__path__, "edugym.agents."):
        for thing in vars(importlib.import_module(module.name)).values():
            mine = isinstance(thing, type) and thing.__module__ == module.name
            if mine and issubclass(thing, tuple) and hasattr(thing, method) and thing.__name__ not in others:
                yield thing


def _described(kind: Any) -> dict[str, Case]:
    """The cases of an agent."""
    described = {name: case for name, case in DESCRIBED.items() if case.kind is kind}
    return described or {kind.__name__: _case(kind)}


def _exploring(make: Callable[[Any], Any]) -> Case:
    return Case(eg.QLearning, lambda environment: eg.QLearning.create(environment, exploration=make(environment)))


AGENTS = {name: case for kind in package_classes("learn") for name, case in _described(kind).items()}
CASES: dict[str, Case] = {**AGENTS, **{f"QLearning, {name}": _exploring(make) for name, make in STRATEGIES.items()}}


def lasting(agent: Any) -> Any:
    """An agent without the tree of its latest search, which evaluation grows too, and which nothing uses afterwards."""
    return agent._replace(tree=None) if "tree" in agent._fields else agent


def same(one: Any, other: Any) -> bool:
    """Whether two agents (or any nested tuples) are of the same classes and equal to the last bit, NaN included."""
    if type(one) is not type(other):
        return False
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, np.ndarray):
        return bool(one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes())
    if isinstance(one, np.random.Generator):
        return bool(one.bit_generator.state == other.bit_generator.state)
    return bool(one == other)

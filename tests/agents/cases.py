"""Every agent and every exploration strategy of the package, for the tests that hold for all of them."""

import importlib
import pkgutil
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from edugym import (
    UCB,
    CountBased,
    EpsilonGreedy,
    ExponentialDecay,
    GoExplore,
    Greedy,
    LinearDecay,
    QLearning,
    ScheduledEpsilonGreedy,
    Softmax,
    agents,
)


class Case(NamedTuple):
    """An agent to test.

    Attributes:
        kind: its class.
        create: makes a new one for an environment (or the shape of its table).
        estimates_return: whether its Q(s, a) estimates the discounted return, for which there are closed forms.
    """

    kind: type
    create: Callable[[Any], Any]
    estimates_return: bool = True


STRATEGIES: dict[str, Callable[[Any], Any]] = {
    "greedy": lambda environment: Greedy(),
    "epsilon-greedy": lambda environment: EpsilonGreedy(0.2),
    "linear decay": lambda environment: ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.1, 500)),
    "exponential decay": lambda environment: ScheduledEpsilonGreedy.create(ExponentialDecay(1.0, 0.05, 0.99)),
    "softmax": lambda environment: Softmax(0.3),
    "ucb": lambda environment: UCB.create(environment, 0.5),
}

AGENTS: dict[str, Case] = {
    "QLearning": Case(QLearning, lambda env: QLearning.create(env, learning_rate=0.5, discount=0.5)),
    "CountBased": Case(CountBased, lambda env: CountBased.create(env, bonus=0.0, learning_rate=0.5, discount=0.5)),
    "CountBased with its bonus": Case(CountBased, CountBased.create, False),
    "GoExplore": Case(GoExplore, lambda env: GoExplore.create(env, explore_steps=3, longest=50), False),
}


def _exploring(make: Callable[[Any], Any]) -> Case:
    return Case(QLearning, lambda env: QLearning.create(env, exploration=make(env)))


CASES: dict[str, Case] = {**AGENTS, **{f"QLearning, {name}": _exploring(make) for name, make in STRATEGIES.items()}}


def package_classes(method: str) -> Iterator[type]:
    """Every NamedTuple class in `edugym.agents` that has such a method."""
    for module in pkgutil.iter_modules(agents.__path__, "edugym.agents."):
        for thing in vars(importlib.import_module(module.name)).values():
            if isinstance(thing, type) and issubclass(thing, tuple) and hasattr(thing, method):
                yield thing


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

"""The remedy for the challenge of each environment, and what it gains, as `docs/isolation.py` has measured it."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from edugym import Interval, mean_interval
from edugym.experiments.profiles.words import rounded

NO_CHANGE = 0.1
"""A remedy changes little where the whole interval of its gain lies within this much of 0."""


class Remedy(NamedTuple):
    """A remedy for one challenge.

    Attributes:
        name: what it is called.
        own: the environment for which it is meant.
        agent: the agent with the remedy: one of the package, whose profile is stored, or one that is measured apart.
        base: the same without the remedy.
    """

    name: str
    own: str
    agent: str
    base: str = "QLearning"


REMEDIES = (
    Remedy("exploration: Go-Explore", "Boulder", "GoExplore"),
    Remedy("on-policy: SARSA", "Roadrunner", "SARSA"),
    Remedy("depth: Q(λ)", "Study", "QLambda"),
    Remedy("function approximation: DQN", "Catch", "DQN"),
    Remedy("memory: 4 frames", "MemoryCorridor", "Frames"),
    Remedy("continuous actions: actor-critic", "Trashbot", "GaussianActorCritic"),
    Remedy("risk: risk-averse Q-learning", "Golf", "RiskSensitiveQLearning"),
    Remedy("planning: Dyna-Q", "Supermarket", "DynaQ"),
    Remedy("hindsight: DQN with hindsight", "Switches", "HindsightDQN", "DQN"),
)


def gain(rungs: Any) -> Interval:
    """The gain over the whole ladder; `rungs` has the shape (n_strengths, n_repetitions)."""
    return mean_interval(np.array(rungs).mean(axis=0))


def shown(interval: Interval) -> str:
    """A gain with its interval, which no line break parts."""
    estimate = rounded(interval.estimate)
    sign = "+" if float(estimate) > 0 else ""
    return f"{sign}{estimate} [{rounded(interval.low)},\N{NO-BREAK SPACE}{rounded(interval.high)}]"


def when_to_take(agent: str, measured: Mapping[str, Any]) -> Iterator[str]:
    """Yield sentences on where an agent that is a remedy gains, and where it costs; none where it is no remedy.

    Args:
        agent: its name.
        measured: the contents of `docs/isolation.json`.
    """
    for remedy in REMEDIES:
        if remedy.agent != agent:
            continue
        sizes = {name: gain(rungs) for name, rungs in measured["gains"][remedy.name].items()}
        own = sizes.pop(remedy.own)
        size = f"There its score differs from that of {remedy.base} by {shown(own)}."
        yield f"In our comparison of remedies it is the one for the challenge of {remedy.own}. {size}"
        more = [f"{name} ({shown(size)})" for name, size in sizes.items() if size.low > NO_CHANGE]
        less = [f"{name} ({shown(size)})" for name, size in sizes.items() if size.high < -NO_CHANGE]
        if more:
            yield f"It also gains in {', '.join(more)}."
        if less:
            yield f"It loses in {', '.join(less)}."
        if len(more) + len(less) < len(sizes):
            yield f"Elsewhere the difference is not surely larger than {NO_CHANGE}."


def what_helps(environment: str, measured: Mapping[str, Any]) -> str:
    """Return what an environment's own remedy gains there, in words; "" where it has none, or where none gains."""
    for remedy in REMEDIES:
        size = gain(measured["gains"][remedy.name][remedy.own]) if remedy.own == environment else None
        if size and size.low > NO_CHANGE:
            before = measured["base"][environment]
            kind, _, name = remedy.name.partition(": ")
            return f"what helps is {kind}: {name} add {shown(size)} to the {rounded(before)} of {remedy.base}"
    return ""

"""Real steps of an MDP against its model: what it does with real random numbers is what it seemed to do.

Following the ways of a random number (`edugym.exact.branching`) goes wrong without an error where code depends on what
kind of thing the number is, or gets its random numbers from elsewhere. Some real steps show that.
"""

import math
import random
from collections import Counter
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from edugym.exact.branching import branches
from edugym.exact.tables import FiniteModel, plain
from edugym.mdp.protocol import Random

PLACES = 200
"""How many states and actions are tried, and how often at least, where the model says that there is no chance."""
REPEATED = 2
CHANCES = 20
"""The same where there is chance."""
DRAWS = 100
FALSE_ALARM = 1e-12
"""How likely a correct model may at most be refused."""


HINT = "the model can only follow random numbers that come from `rng` in the same call and are compared or rounded down"


def compare_with_steps(model: FiniteModel) -> None:
    """Refuse a model that real steps contradict.

    At some states and actions, all of them in a small task, every next state must be among the successors, about as
    often as the model says, and every reward must be one of those that the task can give there.

    Raises:
        ValueError: they contradict it.
    """
    mdp: Any = model.mdp
    rng = np.random.default_rng(0)
    starts = {model.states[s]: float(model.initial[s]) for s in np.flatnonzero(model.initial)}
    _compare([mdp.initial(rng) for _ in range(DRAWS)], starts, "at the start")
    going_on = ~model.terminal[:, np.newaxis]
    random_there = (model.probabilities > 0).sum(axis=2) > 1
    for places, most, least in (
        (np.argwhere(going_on & ~random_there), PLACES, REPEATED),
        (np.argwhere(going_on & random_there), CHANCES, DRAWS),
    ):
        chosen = places if len(places) <= most else rng.choice(places, most, replace=False)
        for s, action in chosen.tolist():
            _compare_steps(model, model.states[s], action, most * least // len(chosen), rng)


def _compare_steps(model: FiniteModel, state: Any, action: int, n_steps: int, rng: Random) -> None:
    """Take so many steps from one state by one action."""
    mdp: Any = model.mdp
    place = f"after action {action} in state {state!r}"
    next_states, rewards = [], []
    for _ in range(n_steps):
        next_states.append(mdp.transition(state, action, rng))
        rewards.append(float(mdp.reward(state, action, next_states[-1], rng)))
    _compare(next_states, {way.next_state: way.probability for way in model.outcomes(state, action)}, place)
    possible: dict[Any, set[float]] = {}
    for next_state, reward in zip(map(plain, next_states), rewards, strict=True):
        if next_state not in possible:
            possible[next_state] = _values(partial(mdp.reward, state, action, next_state))
        expected = possible[next_state]
        if expected and not any(math.isclose(reward, value, rel_tol=1e-9, abs_tol=1e-12) for value in expected):
            raise ValueError(
                f"{place} a real step to {next_state!r} pays {reward}, but the model says {sorted(expected)}: {HINT}"
            )


def _values(draw: Callable[[Any], Any]) -> set[float]:
    """The numbers that a draw can give; none where they are continuous."""
    try:
        return {float(value) for _, value in branches(draw)}
    except ValueError:
        return set()


def _compare(states: list[Any], probabilities: dict[Any, float], place: str) -> None:
    """Compare how often each state came with its probability."""
    counts = Counter(map(plain, states))
    for state in counts:
        if state not in probabilities:
            raise ValueError(f"{place} a real step leads to {state!r}, which the model does not know of: {HINT}")
    n = len(states)
    surprise = math.log(2 * (CHANCES + 1) * len(probabilities) / FALSE_ALARM)
    for state, p in probabilities.items():
        if n * divergence(counts[state] / n, p) > surprise:
            seen = f"{counts[state]} of {n} real steps lead to {state!r}"
            raise ValueError(f"{place} {seen}, but the model says that its probability is {p:.6g}: {HINT}")


def divergence(share: float, p: float) -> float:
    """How unlikely such a share of n draws is, given p: less than exp(-n divergence) on either side (Chernoff)."""
    total = 0.0
    for seen, expected in ((share, p), (1 - share, 1 - p)):
        if seen > 0:
            total += seen * math.log(seen / expected) if expected > 0 else math.inf
    return total


def global_randomness() -> Any:
    """The state of the random generators that anything can draw from."""
    numpys: Any = np.random.get_state()  # noqa: NPY002  only looked at
    return random.getstate(), numpys[1].tobytes(), numpys[2:]

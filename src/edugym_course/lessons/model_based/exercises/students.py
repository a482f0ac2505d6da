"""What the checks of exercises 2 and 3 share: made-up memories, and the student's agent with other settings."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
from gymnasium.spaces import Discrete

from edugym_course.grading.agents import agent_created_by, require_class, with_settings
from edugym_course.grading.cases import FAR_BELOW
from edugym_course.grading.challenge import Sizes

SHAPE = (6, 3)
"""The size of the tables that checks make up."""


class Memory(NamedTuple):
    """What the agent of exercise 2 remembers of one pair of state and action, and of the next state."""

    Q: Any
    rewards: Any
    next_states: Any
    ends: Any
    last: Any
    now: int
    state: int
    action: int


def memories(seed: int) -> Iterator[Memory]:
    """Yield made-up memories: pairs that were tried, that ended the episode, that were never tried.

    Some pairs were tried and look as if not: with a reward of 0, or a reward and a next state of 0. And of those that
    were never tried one is in a state where another action was. One was tried in the first step of all, and one leads
    to values that are all far below 0.
    """
    rng = np.random.default_rng(seed)
    for kind in ("tried", "no reward", "zeros", "ended", "ended", "never", "new state", "far below", "at once"):
        Q = rng.choice(np.arange(-2.0, 4.25, 0.25), SHAPE)
        # Tables are 0 where nothing is known, so that 0 must not be the state itself.
        state, other = (int(s) for s in rng.choice(np.arange(1, SHAPE[0]), 2, replace=False))
        if kind == "zeros":
            other = 0
        action, now = int(rng.integers(SHAPE[1])), int(rng.integers(40, 60))
        Q[other, (action + 1) % SHAPE[1]] = 5.0
        Q[state, (action + 1) % SHAPE[1]] = 4.5
        if kind == "far below":
            Q[other] -= FAR_BELOW
        rewards, next_states = np.zeros(SHAPE), np.zeros(SHAPE, np.int64)
        ends, last = np.zeros(SHAPE, np.int64), np.zeros(SHAPE, np.int64)
        if kind == "never":
            last[state, (action + 1) % SHAPE[1]] = now - 4
        elif kind != "new state":
            rewards[state, action] = 0.0 if kind in ("no reward", "zeros") else float(rng.choice([-1.0, 2.0, 3.0]))
            next_states[state, action] = other
            last[state, action] = 1 if kind == "at once" else now - int(rng.choice([9, 16, 25]))
        ends[state, action] = kind == "ended"
        yield Memory(Q, rewards, next_states, ends, last, now, state, action)


def agent_with(name: str, answer: Any, settings: Mapping[str, float], method: str) -> Any:
    """Make the student's agent for a small shop, with other settings than its own, which a method reads."""
    require_class(name, answer)
    shop = Sizes(Discrete(SHAPE[0]), Discrete(SHAPE[1]))
    return with_settings(name, agent_created_by(name, answer, "shop", shop), settings, method)

"""What the checks of exercises 2 and 3 share: made-up memories, and the student's agent with other settings."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.grading.student_code import running
from edugym.grading.values import given
from edugym.grading.wrong import WrongAnswer

SHAPE = (6, 3)
"""The size of the tables that checks make up."""


class Sizes(NamedTuple):
    """Stands for the shop where an agent is made."""

    observation_space: Any = gymnasium.spaces.Discrete(SHAPE[0])
    action_space: Any = gymnasium.spaces.Discrete(SHAPE[1])


class Memory(NamedTuple):
    """What the agents of exercises 2 and 3 remember of one pair of state and action, and of the next state."""

    Q: Any
    rewards: Any
    next_states: Any
    ends: Any
    last: Any
    now: int
    state: int
    action: int


def memories(seed: int) -> Iterator[Memory]:
    """Yield made-up memories: pairs that were tried, that ended the episode, that were never tried."""
    rng = np.random.default_rng(seed)
    for kind in ("tried", "tried", "ended", "ended", "never", "never"):
        Q = rng.choice(np.arange(-2.0, 4.25, 0.25), SHAPE)
        state, other = (int(s) for s in rng.choice(SHAPE[0], 2, replace=False))
        action, now = int(rng.integers(SHAPE[1])), int(rng.integers(40, 60))
        Q[other, (action + 1) % SHAPE[1]] = 5.0
        Q[state, (action + 1) % SHAPE[1]] = 4.5
        rewards, next_states = np.zeros(SHAPE), np.zeros(SHAPE, np.int64)
        ends, last = np.zeros(SHAPE, np.int64), np.zeros(SHAPE, np.int64)
        if kind != "never":
            rewards[state, action] = float(rng.choice([-1.0, 2.0, 3.0]))
            next_states[state, action] = other
            last[state, action] = now - int(rng.choice([9, 16, 25]))
        elif state == 0:
            Q[0], state = Q[0] - 1.0, 1  # what is not in the tables yet is 0, and must not look like the state itself
        ends[state, action] = kind == "ended"
        yield Memory(Q, rewards, next_states, ends, last, now, state, action)


def made(name: str, answer: Any) -> Any:
    """Make the student's agent."""
    given(name, answer)
    if not isinstance(answer, type):
        raise WrongAnswer(f"{name} should be the class, but is of the type {type(answer).__name__}")
    create: Any = getattr(answer, "create", None)
    if create is None:
        raise WrongAnswer(f"{name} should keep its method `create`, which makes a new agent for a shop")
    with running(f"{name}.create(shop)"):
        made = create(Sizes())
    given(f"{name}.create(shop)", made)
    return made


def with_settings(name: str, agent: Any, settings: Mapping[str, float]) -> Any:
    """Give an agent other settings than its own."""
    for setting in settings:
        if not hasattr(agent, setting):
            raise WrongAnswer(f"{name} should keep its field `{setting}`")
    if hasattr(agent, "_replace"):
        return agent._replace(**settings)
    for setting, value in settings.items():
        setattr(agent, setting, value)
    return agent


def first_that_fits(mistakes: Mapping[str, Any], fits: Callable[[Any], bool]) -> str:
    """Return the sentence of the mistake that gives what was found in every case."""
    for sentence, change in mistakes.items():
        if fits(change):
            return sentence
    return "that is none of the usual mistakes, so compare your code with the equation, term by term"

"""Made-up episodes, and how a student's agent learns from them."""

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from edugym.grading.student_code import running
from edugym.grading.values import given
from edugym.grading.wrong import WrongAnswer
from edugym.training.contract import learns_from

N_STATES, N_ACTIONS = 6, 3
"""The size of the tables on which agents are tried."""


class Episode(NamedTuple):
    """A made-up episode, which terminates.

    Attributes:
        states: the states, all different, without the terminal one.
        actions: the action in each.
        rewards: the reward after each.
    """

    states: list[int]
    actions: list[int]
    rewards: list[float]


def make_episode(length: int, rng: np.random.Generator) -> Episode:
    """Make an episode up, of simple numbers."""
    states = [int(state) for state in rng.permutation(N_STATES - 1)[:length]]
    actions = [int(action) for action in rng.integers(N_ACTIONS, size=length)]
    rewards = [float(reward) for reward in rng.choice([-2.0, -1.0, 1.0, 2.0, 4.0], size=length)]
    return Episode(states, actions, rewards)


def learn_from(agent: Any, episode: Episode, end: int = N_STATES - 1) -> None:
    """Let a student's agent learn from an episode, with whatever its `learn` asks for.

    Args:
        agent: the agent.
        episode: the episode.
        end: the terminal state.
    """
    try:
        names = learns_from(agent)
    except ValueError as error:
        raise WrongAnswer(str(error)) from None
    last = len(episode.states) - 1
    for k, (state, action, reward) in enumerate(zip(*episode, strict=True)):
        step = {
            "state": state,
            "action": action,
            "reward": reward,
            "next_state": episode.states[k + 1] if k < last else end,
            "next_action": episode.actions[k + 1] if k < last else 0,
            "terminated": k == last,
            "truncated": False,
        }
        with running("learn(" + ", ".join(f"{name}={step[name]}" for name in names) + ")"):
            agent.learn(**{name: step[name] for name in names})


def numbers(values: Iterable[float]) -> str:
    """Return numbers in brackets, each as short as it is."""
    return "[" + ", ".join(f"{value:.4g}" for value in values) + "]"


def made_by(call: str, make: Callable[[Any], Any], study: Any) -> Any:
    """Make a student's agent, and refuse what is none."""
    with running(call):
        made = make(study)
    given(call, made)
    if isinstance(made, type):
        raise WrongAnswer(
            f"{call} should give an agent, but gives the class {made.__name__}: write {made.__name__}.create"
        )
    missing = [name for name in ("act", "learn") if not hasattr(made, name)]
    if missing:
        raise WrongAnswer(
            f"{call} should give an agent, but what it gives, of the type {type(made).__name__}, has no `{missing[0]}`"
        )
    return made

"""Made-up episodes, and how a student's agent learns from them."""

from typing import Any, NamedTuple

import numpy as np

from edugym_course.grading.agents import learn_step

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
        learn_step(agent, step)

"""Agents that learn from vectors of rewards, in a loop of one reward: they ask the task for the vector.

The loop of `edugym.objectives` makes a new array at each step, for which a kernel has no room. It takes the same steps.
"""

import inspect
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Random, Reals


class Informed(NamedTuple):
    """An agent that is told the vector of rewards.

    Attributes:
        agent: the agent.
        mdp: the task, which shows its state.
        rewards: shape (n_objectives,): the latest.
    """

    agent: Any
    mdp: Any
    rewards: Reals

    def act(self, state: int, rng: Random) -> int:
        """The agent's action."""
        action: int = self.agent.act(state, rng)
        return action

    def greedy(self, state: int, rng: Random) -> int:
        """The action by which it is evaluated."""
        action: int = self.agent.greedy(state, rng)
        return action

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Let it learn from the vector."""
        value, time = self.mdp.rewards(state, action, next_state)
        self.rewards[0] = value
        self.rewards[1] = time
        self.agent.learn(state, action, self.rewards, next_state, terminated, truncated)


def informed(agent: Any, mdp: Any) -> Any:
    """The agent, told the vector of rewards if it learns from it."""
    if "rewards" not in inspect.signature(agent.learn).parameters:
        return agent
    return Informed(agent, mdp, np.zeros(mdp.reward_space.shape))

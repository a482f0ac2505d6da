"""The last steps of an episode, for agents that learn from several at once."""

from typing import Annotated, NamedTuple

from edugym.agents.settings import Counter, Table
from edugym.mdp.protocol import Integers, Reals


class LastSteps(NamedTuple):
    """The last n steps of the episode under way: step t is at index t mod n (its state at t mod n + 1).

    Attributes:
        t: shape (1,): how many steps this episode has taken.
        states: shape (n + 1,): the states, the one reached last included.
        actions: shape (n,): the actions.
        rewards: shape (n,): the reward after each.
    """

    t: Counter
    states: Annotated[Integers, Table(("n + 1",))]
    actions: Annotated[Integers, Table(("n",))]
    rewards: Annotated[Reals, Table(("n",))]

    def remember(self, state: int, action: int, reward: float, next_state: int) -> int:
        """Store a step, and return its number in the episode."""
        n = len(self.actions)
        t = int(self.t[0])
        self.states[t % (n + 1)] = state
        self.actions[t % n] = action
        self.rewards[t % n] = reward
        self.states[(t + 1) % (n + 1)] = next_state
        self.t[0] = t + 1
        return t

    def forget(self) -> None:
        """Begin another episode."""
        self.t[0] = 0

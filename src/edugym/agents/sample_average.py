"""Sample averages: the simple bandit algorithm."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import ActionValues, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Integers, Random


@shows_settings
class SampleAverage(NamedTuple):
    """The simple bandit algorithm: an action is worth the mean of the rewards that it has brought.

        N(A) <- N(A) + 1
        Q(A) <- Q(A) + (1 / N(A)) [R - Q(A)]

    It looks at the reward alone, not at what comes after it, so it is for bandits. Where there are several states, each
    is a bandit of its own, with its own row of both tables (a contextual bandit). The first reward replaces
    `initial_value`, so optimistic values only make it try every action once. With a constant step size α in the place
    of 1/N(A) this is `QLearning` with discount 0: it forgets old rewards, which helps where arms change (section 2.5).

    Attributes:
        Q: shape (n_states, n_actions): the mean rewards.
        counts: shape (n_states, n_actions): N, how often each action was chosen in each state.
        exploration: how actions are chosen.

    Reference: Sutton and Barto, 2nd edition, the box of section 2.4.
    """

    Q: ActionValues
    counts: Annotated[Integers, Table(("states", "actions"))]
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float) -> None:
        """Take the reward into the mean of its action."""
        self.counts[state, action] += 1
        self.Q[state, action] += (reward - self.Q[state, action]) / self.counts[state, action]

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest mean reward."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "SampleAverage":
        """Create an agent with new tables for an MDP, a Gymnasium environment, or their shape (n_states, n_actions).

        Settings: every field that has a default, and `initial_value`, at which all entries of Q begin.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        return new(cls, environment, settings)

"""Q-learning."""

from typing import Any, NamedTuple

import numpy as np

from edugym.agents.settings import check_exploration, check_learning
from edugym.agents.strategies import EpsilonGreedy, Exploration, best_value, greedy_action
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.tabular import table_size


class QLearning(NamedTuple):
    """Off-policy control: learn the values of the greedy policy, whatever policy chooses the actions.

        Q(S, A) <- Q(S, A) + α [R + γ max_a Q(S', a) - Q(S, A)]

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: Watkins and Dayan (1992); Sutton and Barto, 2nd edition, equation 6.8 and the box of section 6.5.
    """

    Q: Reals
    learning_rate: float = 0.1
    discount: float = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    @classmethod
    def create(
        cls,
        environment: Any,
        *,
        learning_rate: float = 0.1,
        discount: float = 0.99,
        exploration: Exploration = EpsilonGreedy(0.1),
        initial_value: float = 0.0,
    ) -> "QLearning":
        """A new agent.

        Args:
            environment: an MDP or Gymnasium environment with whole numbers for observations and actions, or the shape
                (n_states, n_actions) of the table.
            learning_rate: see the class, as the others.
            discount: see the class.
            exploration: see the class.
            initial_value: what every entry of Q starts from; high values are optimistic and make the agent explore
                (section 2.6).

        Raises:
            ValueError: a parameter is not as the class says.
        """
        check_learning(learning_rate, discount)
        check_exploration(exploration)
        return cls(np.full(table_size(environment), float(initial_value)), learning_rate, discount, exploration)

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """One update, from one transition."""
        value = 0.0 if terminated else best_value(self.Q, next_state)
        self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])

"""Q-learning with a novelty reward: intrinsic motivation by counting."""

import math
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.settings import check_exploration, check_learning
from edugym.agents.strategies import EpsilonGreedy, Exploration, best_value, greedy_action
from edugym.checks import at_least
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.tabular import table_size


class CountBased(NamedTuple):
    """Q-learning on the reward plus a bonus for entering states that were rarely visited.

        N(S') <- N(S') + 1
        R+ = R + β / √N(S')
        Q(S, A) <- Q(S, A) + α [R+ + γ max_a Q(S', a) - Q(S, A)]

    The bonus fades as a state becomes familiar, and Q-learning carries it back along the way that leads there, so
    that the agent is drawn to the edge of what it knows.

    Attributes:
        Q: shape (n_states, n_actions): the action values, of reward and bonus together.
        visits: shape (n_states,): N(s), how often each state was entered.
        bonus: β, the reward for entering a state for the first time, 0 or more.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: Chentanez, Barto and Singh (2004), Intrinsically motivated reinforcement learning; Sutton and Barto, 2nd
    edition, box of section 6.5, and section 8.3 for a bonus in planning. The form β/√N is that of Strehl and Littman
    (2008), who give it for the state and action; here it is for the state entered.
    """

    Q: Reals
    visits: Integers
    bonus: float = 1.0
    learning_rate: float = 0.5
    discount: float = 0.9
    exploration: Exploration = EpsilonGreedy(0.1)

    @classmethod
    def create(
        cls,
        environment: Any,
        *,
        bonus: float = 1.0,
        learning_rate: float = 0.5,
        discount: float = 0.9,
        exploration: Exploration = EpsilonGreedy(0.1),
    ) -> "CountBased":
        """A new agent, all values and counts zero.

        Args:
            environment: an MDP or Gymnasium environment with whole numbers for observations and actions, or the shape
                (n_states, n_actions) of the table.
            bonus: see the class, as the others.
            learning_rate: see the class.
            discount: see the class.
            exploration: see the class.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        at_least("bonus", bonus, 0)
        check_learning(learning_rate, discount)
        check_exploration(exploration)
        n_states, n_actions = table_size(environment)
        visits = np.zeros(n_states, np.int64)
        return cls(np.zeros((n_states, n_actions)), visits, bonus, learning_rate, discount, exploration)

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Q-learning on the reward with the bonus for the state that was entered."""
        self.visits[next_state] += 1
        reward_and_bonus = reward + self.bonus / math.sqrt(self.visits[next_state])
        value = 0.0 if terminated else best_value(self.Q, next_state)
        target = reward_and_bonus + self.discount * value
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])

"""Double Q-learning."""

from typing import Any, NamedTuple

from edugym.agents.settings import ActionValues, Counter, Discount, LearningRate, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action, one_step_target, value_of_best
from edugym.mdp.protocol import Random


@shows_settings
class DoubleQLearning(NamedTuple):
    """Off-policy control without maximisation bias: one table chooses the best action, the other says what it is worth.

        with probability 1/2:  Q₁(S, A) <- Q₁(S, A) + α [R + γ Q₂(S', argmax_a Q₁(S', a)) - Q₁(S, A)]
        otherwise:             Q₂(S, A) <- Q₂(S, A) + α [R + γ Q₁(S', argmax_a Q₂(S', a)) - Q₂(S, A)]

    It acts on the mean of both (the book has the sum, which is the same for ε-greedy). Where several actions are best,
    the mean over them counts. The coin for the next update is tossed when the agent acts, where it has random numbers.

    Attributes:
        Q: shape (n_states, n_actions): the mean of the two tables.
        Q1: shape (n_states, n_actions): Q₁.
        Q2: shape (n_states, n_actions): Q₂.
        coin: shape (1,): 0 if Q₁ is updated next, 1 if Q₂.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: van Hasselt (2010); Sutton and Barto, 2nd edition, equation 6.10 and the box of section 6.7.
    """

    Q: ActionValues
    Q1: ActionValues
    Q2: ActionValues
    coin: Counter
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Update one of the tables, with the other's opinion of its best action."""
        if self.coin[0] == 0:
            target = one_step_target(reward, self.discount, value_of_best(self.Q1, self.Q2, next_state), terminated)
            self.Q1[state, action] += self.learning_rate * (target - self.Q1[state, action])
        else:
            target = one_step_target(reward, self.discount, value_of_best(self.Q2, self.Q1, next_state), terminated)
            self.Q2[state, action] += self.learning_rate * (target - self.Q2[state, action])
        self.Q[state, action] = (self.Q1[state, action] + self.Q2[state, action]) / 2.0

    def act(self, state: int, rng: Random) -> int:
        """Toss the coin for the next update, and choose an action by the exploration strategy."""
        self.coin[0] = int(rng.random() * 2)
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest mean value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "DoubleQLearning":
        """Create an agent with new tables for an MDP, a Gymnasium environment, or the shape (n_states, n_actions).

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q starts
        at `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        return new(cls, environment, settings)

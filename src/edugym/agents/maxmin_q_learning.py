"""Maxmin Q-learning."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import ActionValues, Counter, Discount, LearningRate, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target
from edugym.checks.parameters import whole_number
from edugym.mdp.protocol import Random, Reals

MOST_TABLES = 1_000


@shows_settings
class MaxminQLearning(NamedTuple):
    """Off-policy control with as much pessimism as one likes: the maximum over the smallest of N estimates.

        Q(s, a) = min_i Qᵢ(s, a)
        for an i that is drawn:  Qᵢ(S, A) <- Qᵢ(S, A) + α [R + γ max_a Q(S', a) - Qᵢ(S, A)]

    It acts on the minimum Q. With one table it is Q-learning. The more tables, the lower is the minimum: few of them
    still overestimate, many underestimate. Each table learns from one in N of the steps. Which table is updated next is
    drawn when the agent acts, where it has random numbers. (Lan et al. let the agent update several tables at once, and
    keep earlier steps in a buffer. Here it updates one, with the step just taken.)

    Attributes:
        Q: shape (n_states, n_actions): the minimum of the tables.
        tables: shape (n_tables, n_states, n_actions): Q₁, ..., Q_N.
        turn: shape (1,): which of the tables is updated next, from 0.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    Reference: Lan et al. (2020), algorithm 1.
    """

    Q: ActionValues
    tables: Annotated[Reals, Table(("tables", "states", "actions"), fill="initial_value")]
    turn: Counter
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Update one of the tables, and then the minimum of all."""
        target = one_step_target(reward, self.discount, best_value(self.Q, next_state), terminated)
        i = self.turn[0]
        self.tables[i, state, action] += self.learning_rate * (target - self.tables[i, state, action])
        smallest = self.tables[0, state, action]
        for k in range(1, len(self.tables)):
            smallest = min(smallest, self.tables[k, state, action])
        self.Q[state, action] = smallest

    def act(self, state: int, rng: Random) -> int:
        """Draw the table of the next update, and choose an action by the exploration strategy."""
        self.turn[0] = int(rng.random() * len(self.tables))
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action whose smallest value is the highest."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, *, n_tables: int = 4, **settings: Any) -> "MaxminQLearning":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            n_tables: N, a whole number from 1 to 1000.
            **settings: the learning rate and what follows it above, and `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        return new(cls, environment, settings, tables=whole_number("n_tables", n_tables, 1, MOST_TABLES))

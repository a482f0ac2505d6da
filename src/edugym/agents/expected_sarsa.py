"""Expected SARSA."""

from typing import Any, NamedTuple

from edugym.agents.settings import ActionValues, Discount, LearningRate, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Policy, check_policy
from edugym.agents.tables import greedy_action, one_step_target
from edugym.mdp.protocol import Random


@shows_settings
class ExpectedSARSA(NamedTuple):
    """On-policy control without the noise of the next action: SARSA with the mean over all that it may be.

        Q(S, A) <- Q(S, A) + α [R + γ Σ_a π(a|S') Q(S', a) - Q(S, A)]

    π is the exploration strategy on the present values, and must be one whose probabilities are known: ε-greedy,
    softmax or greedy (with which this is Q-learning), not UCB.

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: van Seijen et al. (2009); Sutton and Barto, 2nd edition, equation 6.9.
    """

    Q: ActionValues
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Policy = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Move Q(S, A) towards the reward and the mean value that follows."""
        next_value = self.exploration.expected_value(self.Q, next_state)
        target = one_step_target(reward, self.discount, next_value, terminated)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "ExpectedSARSA":
        """Create an agent with a new Q. `environment` is an MDP, a Gymnasium environment, or (n_states, n_actions).

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q starts
        at `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        agent = new(cls, environment, settings)
        check_policy("exploration", agent.exploration)
        return agent

"""SARSA."""

from typing import Any, NamedTuple

from edugym.agents.settings import ActionValues, Discount, LearningRate, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action, one_step_target
from edugym.mdp.protocol import Random


@shows_settings
class SARSA(NamedTuple):
    """On-policy control: learn the values of the policy that chooses the actions, its exploration included.

        Q(S, A) <- Q(S, A) + α [R + γ Q(S', A') - Q(S, A)]

    A' is the action chosen for S'. It is taken next, unless the episode ends there. If S' is terminal, Q(S', A') is 0.

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: Rummery and Niranjan (1994); Sutton and Barto, 2nd edition, equation 6.7 and the box of section 6.4.
    """

    Q: ActionValues
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(
        self, state: int, action: int, reward: float, next_state: int, next_action: int, terminated: bool
    ) -> None:
        """Move Q(S, A) towards the target R + γ Q(S', A')."""
        target = one_step_target(reward, self.discount, self.Q[next_state, next_action], terminated)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "SARSA":
        """Create an agent with a new table; `environment` is an environment, or the shape of Q, (n_states, n_actions).

        Settings: every field that has a default, and `initial_value`. Every entry of Q starts at `initial_value`, by
        default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        return new(cls, environment, settings)

"""Q-learning."""

from typing import Any, NamedTuple

from edugym.agents.settings import ActionValues, Discount, LearningRate, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target
from edugym.mdp.protocol import Random


@shows_settings
class QLearning(NamedTuple):
    """Off-policy control: learn the values of the greedy policy, whatever policy chooses the actions.

        Q(S, A) <- Q(S, A) + α [R + γ max_a Q(S', a) - Q(S, A)]

    With optimism it explores although it is greedy: start Q higher than any return can be, as in
    `QLearning.create(env, initial_value=1.0, exploration=Greedy())`, and what was never tried looks best until it is
    tried (section 2.6 of the book).

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: Watkins and Dayan (1992); Sutton and Barto, 2nd edition, equation 6.8 and the box of section 6.5.
    """

    Q: ActionValues
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Move Q(S, A) towards the reward plus γ times the highest value in S'. A terminal S' has the value 0."""
        target = one_step_target(reward, self.discount, best_value(self.Q, next_state), terminated)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "QLearning":
        """Create an agent with a new Q. `environment` is an MDP, a Gymnasium environment, or (n_states, n_actions).

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q starts
        at `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or not allowed, or the environment does not fit a table. It fits if its
                observations are whole numbers or tuples of whole numbers, and its actions are 0, 1, 2 and so on.
        """
        return new(cls, environment, settings)

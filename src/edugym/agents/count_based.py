"""Q-learning with a novelty reward: intrinsic motivation by counting."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target
from edugym.mdp.protocol import Integers, Random


@shows_settings
class CountBased(NamedTuple):
    """Q-learning on the reward plus a novelty bonus, for entering states that were rarely visited.

        N(S') <- N(S') + 1
        R⁺ = R + β / √N(S')
        Q(S, A) <- Q(S, A) + α [R⁺ + γ max_a Q(S', a) - Q(S, A)]

    The bonus fades as a state becomes familiar. Q-learning carries it back along the way that leads there, so the
    agent is drawn to the edge of what it knows. Optimism is another way to that edge: `QLearning` with a high
    `initial_value`, and no bonus.

    A large bonus outweighs the reward: an episode that goes on earns more bonuses than the end pays. On a wall of
    height 8 in Boulder, the default settings end with a greedy policy that never reaches the top; with a discount of
    0.9, or with a bonus of 0.01, it always does (20 000 steps, 5 seeds).

    Attributes:
        Q: shape (n_states, n_actions): the action values, of reward and bonus together.
        visits: shape (n_states,): N(s), how often each state was entered.
        bonus: β, the reward for entering a state for the first time, 0 or more.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: Strehl and Littman (2008), An analysis of model-based interval estimation, give β/√N for the state and
    action; here it is for the state entered. Sutton and Barto, 2nd edition, box of section 6.5 for the update, and
    section 8.3 for a bonus in planning. On intrinsic motivation in general: Singh, Barto and Chentanez (2004).
    """

    Q: ActionValues
    visits: Annotated[Integers, Table(("states",))]
    bonus: Annotated[float, Range(0)] = 1.0
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Q-learning on the reward with the bonus for the state that was entered."""
        self.visits[next_state] += 1
        reward_and_bonus = reward + self.bonus / math.sqrt(self.visits[next_state])
        target = one_step_target(reward_and_bonus, self.discount, best_value(self.Q, next_state), terminated)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "CountBased":
        """Create an agent with a new Q. `environment` is an MDP, a Gymnasium environment, or (n_states, n_actions).

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q starts
        at `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment is not tabular.
        """
        return new(cls, environment, settings)

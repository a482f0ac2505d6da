"""Risk-sensitive Q-learning: dislike bad surprises more than one likes good ones, or the other way round."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target
from edugym.mdp.protocol import Random


@shows_settings
class RiskSensitiveQLearning(NamedTuple):
    """Q-learning that weighs good and bad surprises differently.

        δ = R + γ max_a Q(S', a) - Q(S, A)
        Q(S, A) <- Q(S, A) + α 2σ(β δ) δ                with σ(x) = 1/(1 + e⁻ˣ)

    The weight 2σ(βδ) lies between 0 and 2. With β = 0 it is 1: Q-learning. With β < 0 bad surprises (δ < 0) weigh more
    and the agent avoids risk; with β > 0 good ones do and it seeks risk. A step that pays N(μ, s²) and ends is worth
    μ + β s²/2. As in every method of this kind risk is that of the single TD errors, not the variance of the return. A
    learning rate above 1/2 can overshoot the target.

    This is the rule of Delétang et al., on which the paper's Golf lesson rests, with max_a Q for the value of the next
    state. Mihatsch and Neuneier weigh by 1 - κ if δ > 0 and by 1 + κ if not, with -1 < κ < 1: two weights, whatever the
    size of δ, and the opposite sign (their κ > 0 avoids risk, as β < 0 does here).

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        risk: β: below 0 the agent avoids risk, above 0 it seeks it. In units of 1/reward.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: Delétang et al. (2021), Model-free risk-sensitive reinforcement learning; Mihatsch and Neuneier (2002),
    Risk-sensitive reinforcement learning, Machine Learning 49 (and at NIPS 1998).
    """

    Q: ActionValues
    risk: Annotated[float, Range(-1e300, 1e300)] = -1.0
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Move Q(S, A) by the weighted TD error."""
        target = one_step_target(reward, self.discount, best_value(self.Q, next_state), terminated)
        delta = target - self.Q[state, action]
        weight = 1.0 + math.tanh(self.risk * delta / 2.0)  # 2σ(x) = 1 + tanh(x/2), which cannot overflow
        self.Q[state, action] += self.learning_rate * weight * delta

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "RiskSensitiveQLearning":
        """Create an agent with a new Q. `environment` is an MDP, a Gymnasium environment, or (n_states, n_actions).

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q starts
        at `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        return new(cls, environment, settings)

"""The gradient bandit algorithm."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import LearningRate, Table, new, shows_settings
from edugym.agents.softmax import draw_action, follow_log_gradient, softmax
from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Integers, Random, Reals


@shows_settings
class GradientBandit(NamedTuple):
    """Learn preferences instead of values: an action that pays more than usual gets likelier, and all others rarer.

        H(A) <- H(A) + α (R - R̄) (1 - π(A))
        H(a) <- H(a) - α (R - R̄) π(a)           for all other actions a
        with π(a) ∝ exp(H(a)), and R̄ the mean of the rewards before this one (of R itself, if it is the first)

    It looks at the reward alone, not at what comes after it, so it is for bandits. Where there are several states, each
    is a bandit of its own, with its own row of every table.

    Attributes:
        preferences: shape (n_states, n_actions): H.
        baseline: shape (n_states,): R̄, the mean of all rewards in each state.
        counts: shape (n_states,): how many rewards that is the mean of.
        probabilities: shape (n_actions,): π of the state seen last.
        learning_rate: α, greater than 0 and up to 1.

    Reference: Sutton and Barto, 2nd edition, section 2.8, equation 2.12.
    """

    preferences: Annotated[Reals, Table(("states", "actions"))]
    baseline: Annotated[Reals, Table(("states",))]
    counts: Annotated[Integers, Table(("states",))]
    probabilities: Annotated[Reals, Table(("actions",))]
    learning_rate: LearningRate = 0.1

    def learn(self, state: int, action: int, reward: float) -> None:
        """Follow the gradient of the expected reward, then take the reward into the baseline."""
        if self.counts[state] == 0:
            self.baseline[state] = reward
        softmax(self.preferences, state, self.probabilities)
        size = self.learning_rate * (reward - self.baseline[state])
        follow_log_gradient(self.preferences, state, action, self.probabilities, size)
        self.counts[state] += 1
        self.baseline[state] += (reward - self.baseline[state]) / self.counts[state]

    def act(self, state: int, rng: Random) -> int:
        """Draw an action from π."""
        softmax(self.preferences, state, self.probabilities)
        return draw_action(self.probabilities, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The most likely action."""
        return greedy_action(self.preferences, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "GradientBandit":
        """Create an agent with new tables for an MDP, a Gymnasium environment, or their shape (n_states, n_actions).

        Settings: every field that has a default.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        return new(cls, environment, settings)

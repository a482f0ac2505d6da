"""One-step actor-critic, with tables."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Discount, LearningRate, Table, new, shows_settings
from edugym.agents.softmax import draw_action, follow_log_gradient, softmax
from edugym.agents.tables import greedy_action, one_step_target
from edugym.mdp.protocol import Random, Reals


@shows_settings
class ActorCritic(NamedTuple):
    """An actor that chooses by preferences, and a critic that says whether things went better than expected.

        δ = R + γ V(S') - V(S)                         (γ V(S') is 0 if S' is terminal)
        V(S) <- V(S) + α^w δ
        θ(S, ·) <- θ(S, ·) + α^θ I δ ∇ln π(A|S, θ)     with π(a|s, θ) ∝ exp(θ(s, a))
        I <- γ I                                       from 1 at the start of an episode

    Attributes:
        preferences: shape (n_states, n_actions): θ, the actor.
        V: shape (n_states,): the critic.
        probabilities: shape (n_actions,): π(·|s) of the state seen last.
        weight: shape (1,): I, γ to the power of the steps of this episode.
        learning_rate: α^θ, of the actor, greater than 0 and up to 1.
        value_learning_rate: α^w, of the critic, likewise.
        discount: γ, from 0 to 1.

    Reference: Sutton and Barto, 2nd edition, the box "One-step Actor-Critic (episodic)" of section 13.5, with tables.
    """

    preferences: Annotated[Reals, Table(("states", "actions"))]
    V: Annotated[Reals, Table(("states",))]
    probabilities: Annotated[Reals, Table(("actions",))]
    weight: Annotated[Reals, Table((1,), fill=1.0)]
    learning_rate: LearningRate = 0.1
    value_learning_rate: LearningRate = 0.1
    discount: Discount = 0.99

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Judge the step, and make its action more or less likely."""
        error = one_step_target(reward, self.discount, self.V[next_state], terminated) - self.V[state]
        self.V[state] += self.value_learning_rate * error
        softmax(self.preferences, state, self.probabilities)
        size = self.learning_rate * self.weight[0] * error
        follow_log_gradient(self.preferences, state, action, self.probabilities, size)
        self.weight[0] = 1.0 if terminated or truncated else self.discount * self.weight[0]

    def forget_episode(self) -> None:
        """Begin a new episode: the one under way was not played to its end."""
        self.weight[0] = 1.0

    def act(self, state: int, rng: Random) -> int:
        """Draw an action from π(·|s)."""
        softmax(self.preferences, state, self.probabilities)
        return draw_action(self.probabilities, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The most likely action."""
        return greedy_action(self.preferences, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "ActorCritic":
        """Create an agent with new tables for an MDP, a Gymnasium environment, or their shape (n_states, n_actions).

        Settings: every field that has a default.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        return new(cls, environment, settings)

"""Semi-gradient SARSA: SARSA with values that are linear in features."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.features import (
    Features,
    Identity,
    check_features,
    follow_gradient,
    linear_value,
    linear_values,
)
from edugym.agents.settings import Discount, LearningRate, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action, one_step_target
from edugym.agents.vectors import vector_size
from edugym.mdp.protocol import Random, Reals


@shows_settings
class SemiGradientSARSA(NamedTuple):
    """On-policy control with action values that are linear in features, q̂(s, a, w) = Σ_i x_i(s) w_ia.

        w_A <- w_A + α [R + γ q̂(S', A', w) - q̂(S, A, w)] x(S)

    q̂ of a terminal state is 0; at a truncation the agent bootstraps. The target depends on w as well, and its gradient
    is left out: hence *semi*-gradient.

    Attributes:
        weights: shape (n_features, n_actions): w, a column for each action.
        Q: shape (1, n_actions): room for the action values of one state.
        features: x(s): by default the observation itself; see `TileCoding`.
        learning_rate: α times `features.at_once`, greater than 0 and up to 1. With tile coding that is the number of
            tilings (equation 9.19), with the observation itself it is 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    Reference: Sutton and Barto, 2nd edition, the box "Episodic semi-gradient Sarsa" of section 10.1; for the learning
    rate, equation 9.19.
    """

    weights: Annotated[Reals, Table(("features", "actions"))]
    Q: Annotated[Reals, Table((1, "actions"))]
    features: Features
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(
        self, state: Any, action: int, reward: float, next_state: Any, next_action: int, terminated: bool
    ) -> None:
        """Move q̂(S, A) towards the reward and the value of the next action."""
        next_value = linear_value(self.features, self.weights, next_state, next_action)
        target = one_step_target(reward, self.discount, next_value, terminated)
        error = target - linear_value(self.features, self.weights, state, action)
        follow_gradient(self.features, self.weights, action, self.learning_rate / self.features.at_once * error)

    def act(self, state: Any, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        linear_values(self.features, self.weights, state, self.Q)
        return self.exploration.choose(self.Q, 0, rng)

    def greedy(self, state: Any, rng: Random) -> int:
        """The action with the highest value."""
        linear_values(self.features, self.weights, state, self.Q)
        return greedy_action(self.Q, 0, rng)

    @property
    def tabular(self) -> bool:
        """False: its states are vectors of numbers, not rows of a table."""
        return False

    @property
    def n_inputs(self) -> int:
        """How many numbers a state has."""
        return self.features.n_inputs

    @property
    def n_actions(self) -> int:
        """How many actions it chooses from."""
        return self.weights.shape[1]

    @classmethod
    def create(cls, environment: Any, *, features: Any = None, **settings: Any) -> "SemiGradientSARSA":
        """A new agent for an environment (or the shape (n_inputs, n_actions)).

        Args:
            environment: an MDP or Gymnasium environment, or the shape.
            features: as the class says; None is the inputs themselves.
            **settings: see the class.

        Raises:
            ValueError: a setting is not as the class says, or the environment does not fit.
        """
        n_inputs, n_actions = vector_size(environment)
        features = Identity.create((n_inputs, n_actions)) if features is None else features
        check_features(features, n_inputs)
        return new(cls, None, {**settings, "features": features}, features=features.n_features, actions=n_actions)

"""Actor-critic for actions that are real numbers: a Gaussian policy on features."""

from typing import Annotated, Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.agents.features import Features, Identity, check_features, follow_gradient, linear_value
from edugym.agents.settings import Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.tables import one_step_target
from edugym.agents.tile_coding import TileCoding
from edugym.agents.vectors import vector_size
from edugym.checks.parameters import a_number
from edugym.mdp.protocol import Random, Reals


@shows_settings
class GaussianActorCritic(NamedTuple):
    """One-step actor-critic that draws each number of an action from a normal distribution, whose mean it learns.

        A_k ~ N(μ_k(S), σ²),  μ_k(s) = Σ_i x_i(s) θ_ik,  v̂(s) = Σ_i x_i(s) w_i
        δ = R + γ v̂(S') - v̂(S)                              (γ v̂(S') is 0 if S' is terminal)
        w <- w + α^w δ x(S)
        θ_k <- θ_k + α^θ δ (A_k - μ_k(S)) / σ² x(S)

    The environment gets the action cut off at the bounds of the action space; the agent learns from what it drew. (For
    a task with actions from -1 to 1, σ = 0.5 is a wide spread.)

    Attributes:
        weights: shape (n_features, n_actions): θ, the actor.
        value_weights: shape (n_features, 1): w, the critic.
        drawn: shape (n_actions,): the latest action as it was drawn.
        low: shape (n_actions,): the lower bounds of the action space.
        high: shape (n_actions,): the upper bounds.
        features: x(s): tile coding of the whole observation by default, whose 8 tilings suit one or two numbers; see
            `TileCoding`.
        learning_rate: α^θ times `features.at_once`, greater than 0 and up to 1.
        value_learning_rate: α^w times the same, likewise.
        discount: γ, from 0 to 1.
        spread: σ, greater than 0.

    Deviations from the book: σ is given, not learned; the factor γ^t of the policy gradient theorem is left out, as is
    usual; at a truncation the agent bootstraps.

    Reference: Sutton and Barto, 2nd edition, the box "One-step Actor-Critic (episodic)" of section 13.5, and section
    13.7 with exercise 13.4 for the Gaussian policy.
    """

    weights: Annotated[Reals, Table(("features", "actions"))]
    value_weights: Annotated[Reals, Table(("features", 1))]
    drawn: Annotated[Reals, Table(("actions",))]
    low: Annotated[Reals, Table(("actions",), fill=-1.0)]
    high: Annotated[Reals, Table(("actions",), fill=1.0)]
    features: Features
    learning_rate: LearningRate = 0.01
    value_learning_rate: LearningRate = 0.2
    discount: Discount = 0.99
    spread: Annotated[float, Range(0, open=True)] = 0.5

    def learn(self, state: Any, reward: float, next_state: Any, terminated: bool) -> None:
        """Judge the step, and move the mean towards the action drawn, or away from it."""
        next_value = linear_value(self.features, self.value_weights, next_state, 0)
        target = one_step_target(reward, self.discount, next_value, terminated)
        error = target - linear_value(self.features, self.value_weights, state, 0)
        at_once = self.features.at_once
        follow_gradient(self.features, self.value_weights, 0, self.value_learning_rate / at_once * error)
        for k in range(len(self.drawn)):
            slope = (self.drawn[k] - linear_value(self.features, self.weights, state, k)) / (self.spread * self.spread)
            follow_gradient(self.features, self.weights, k, self.learning_rate / at_once * error * slope)

    def act(self, state: Any, rng: Random) -> Any:
        """Draw an action, shape (n_actions,), cut off at the bounds of the action space."""
        action = np.empty(len(self.drawn), np.float32)
        self.act_into(state, rng, action)
        return action

    def act_into(self, state: Any, rng: Random, action: Any) -> None:
        """Draw an action as `act` does, and write it into the array `action`."""
        for k in range(len(self.drawn)):
            mean = linear_value(self.features, self.weights, state, k)
            self.drawn[k] = rng.normal(mean, self.spread)
            action[k] = min(max(self.drawn[k], self.low[k]), self.high[k])

    def greedy(self, state: Any, rng: Random) -> Any:
        """The mean, shape (n_actions,), cut off likewise."""
        action = np.empty(len(self.drawn), np.float32)
        self.greedy_into(state, rng, action)
        return action

    def greedy_into(self, state: Any, rng: Random, action: Any) -> None:
        """Write the mean, cut off likewise, into the array `action`."""
        for k in range(len(self.drawn)):
            action[k] = min(max(linear_value(self.features, self.weights, state, k), self.low[k]), self.high[k])

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
        """How many numbers an action has."""
        return len(self.drawn)

    @classmethod
    def create(
        cls, environment: Any, initial_value: float = 0.0, *, features: Any = None, **settings: Any
    ) -> "GaussianActorCritic":
        """A new agent for an environment (or (n_inputs, n_actions), with actions from -1 to 1).

        Args:
            environment: an MDP or Gymnasium environment with actions that are vectors of real numbers.
            initial_value: what the critic expects of every state at first. If that is too much, every action
                disappoints, and the agent tries others (Sutton and Barto, section 2.6). Only for features of which
                the same number is 1 in every state and the others are 0, as in tile coding.
            features: as the class says; None is tile coding with its defaults.
            **settings: see the class.

        Raises:
            ValueError: a setting is not as the class says, or the environment does not fit.
        """
        n_inputs, n_actions = vector_size(environment, spaces.Box)
        features = TileCoding.create(environment) if features is None else features
        check_features(features, n_inputs)
        a_number("initial_value", initial_value)
        if initial_value != 0 and isinstance(features, Identity):
            raise ValueError(f"initial_value must be 0 for the features Identity, but is {initial_value!r}")
        settings = {**settings, "features": features}
        agent = new(cls, None, settings, features=features.n_features, actions=n_actions)
        agent.value_weights[:] = initial_value / features.at_once
        space = getattr(environment, "action_space", None)
        if isinstance(space, spaces.Box):
            agent.low[:], agent.high[:] = space.low, space.high
        return agent

"""Q-learning under constraints, with Lagrange multipliers that are learned."""

from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.settings import Discount, LearningRate, Part, Range, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action, one_step_target
from edugym.agents.vector_tables import OfActions, OfObjectives, VectorValues, vector_of_best
from edugym.checks.parameters import an_array, at_least, in_short
from edugym.mdp.multi_objective import table_shape
from edugym.mdp.protocol import Random, Reals


@shows_settings
class LagrangianQLearning(NamedTuple):
    """Maximise the first objective, while the mean return in each other one is to stay above a limit.

        q(s, a) = Q(s, a)_1 + Σ_i λ_i Q(s, a)_i                                       i = 2, 3, ...
        Q(S, A) <- Q(S, A) + α [R + γ Q(S', A*) - Q(S, A)]     where A* = argmax_a q(S', a), and R and Q are vectors
        λ_i     <- max(0, λ_i + η (limit_i - G_i))             at the end of an episode with the return G

    The multiplier λ_i is the price of objective i. It rises with each episode whose return lies below the limit, and
    falls with each one above: *dual ascent*. For fixed λ the agent learns a weighted sum. So it only ever plays
    policies that some weights prefer, and keeps the limit *on average*, if necessary by changing between two of them.

    Q has a vector for each pair, so a new λ weighs anew what was learned before. But what follows a pair was learned
    for the actions that were best at the λ of that time.

    Attributes:
        Q: shape (n_states, n_actions, n_objectives): the vectors of action values.
        limits: shape (n_objectives,): what the return in each objective is to be at least, on average; there is none
            for the first, -∞.
        multipliers: shape (n_objectives,): λ; that of the first objective stays 1.
        total: shape (n_objectives,): the return of this episode so far.
        values: shape (1, n_actions): q in the state that was looked at last.
        learning_rate: α, greater than 0 and up to 1.
        multiplier_rate: η, 0 or more.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen, given q as the values.

    Choices: The textbook's dual ascent changes λ so slowly that the agent has time to learn for each λ. Here a table of
    vectors takes the place of that. G is the undiscounted return of an episode that the agent played while it explored,
    so its exploration has to keep the limit, too. An episode that is truncated counts like one that terminates.

    References: Altman (1999), Constrained Markov decision processes; Borkar (2005), An actor-critic algorithm for
    constrained Markov decision processes; Tessler, Mankowitz and Mannor (2019), Reward constrained policy optimization.
    """

    Q: VectorValues
    limits: Annotated[Reals, Part()]
    multipliers: Annotated[Reals, Part()]
    total: OfObjectives
    values: OfActions
    learning_rate: LearningRate = 0.1
    multiplier_rate: Annotated[float, Range(0)] = 0.01
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(
        self, state: int, action: int, rewards: Reals, next_state: int, terminated: bool, truncated: bool
    ) -> None:
        """Move the vector Q(S, A) towards R plus γ times that of the best action in S'."""
        self.look_at(next_state)
        for i in range(len(self.total)):
            self.total[i] += rewards[i]
            next_value = vector_of_best(self.Q, next_state, self.values, i)
            target = one_step_target(rewards[i], self.discount, next_value, terminated)
            self.Q[state, action, i] += self.learning_rate * (target - self.Q[state, action, i])
        if terminated or truncated:
            self.end_episode()

    def end_episode(self) -> None:
        """Dual ascent: the price of an objective rises if its return lay below the limit, and falls if above."""
        for i in range(1, len(self.total)):
            missing = self.limits[i] - self.total[i]
            self.multipliers[i] = max(0.0, self.multipliers[i] + self.multiplier_rate * missing)
        self.forget_episode()

    def look_at(self, state: int) -> None:
        """Write q(s, a) of every action into `values`."""
        for action in range(self.Q.shape[1]):
            value = 0.0
            for i in range(self.Q.shape[2]):
                value += self.multipliers[i] * self.Q[state, action, i]
            self.values[0, action] = value

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        self.look_at(state)
        return self.exploration.choose(self.values, 0, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value, at the prices of now."""
        self.look_at(state)
        return greedy_action(self.values, 0, rng)

    def forget_episode(self) -> None:
        """Forget the return of an episode that was not played to its end."""
        for i in range(len(self.total)):
            self.total[i] = 0.0

    @classmethod
    def create(
        cls, environment: Any, limits: Any, *, initial_values: Any = None, **settings: Any
    ) -> "LagrangianQLearning":
        """A new agent for a task.

        Args:
            environment: a task with several objectives (see `edugym.mdp.multi_objective`), or the shape (n_states,
                n_actions, n_objectives).
            limits: for each objective but the first, what its mean return is to be at least.
            initial_values: the first value of all Q(s, a), a number for each objective; by default 0. High ones make
                the agent explore.
            **settings: the fields of the class that have a default, and `initial_multiplier`, the first λ, of 0 or
                more, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        states, actions, objectives = table_shape(environment)
        lowest = np.array([-np.inf, *_finite("limits", limits, objectives - 1)])
        first = at_least("initial_multiplier", settings.pop("initial_multiplier", 0.0), 0)
        multipliers = np.array([1.0, *[first] * (objectives - 1)])
        parts = {"limits": lowest, "multipliers": multipliers}
        agent = new(cls, None, settings, parts, states=states, actions=actions, objectives=objectives)
        agent.Q[:] = 0.0 if initial_values is None else _finite("initial_values", initial_values, objectives)
        return agent


def _finite(name: str, values: Any, length: int) -> Reals:
    """So many finite numbers that a user gave."""
    numbers = an_array(name, values, (length,))
    if not np.isfinite(numbers).all():
        raise ValueError(f"{name} must be finite numbers, but is {in_short(values)}")
    return numbers

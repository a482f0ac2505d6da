"""n-step SARSA, from SARSA (n = 1) to Monte Carlo (n = ∞)."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.last_steps import LastSteps
from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action
from edugym.checks.parameters import MOST_ENTRIES, number_of_steps, whole_number
from edugym.mdp.protocol import Random, Reals


@shows_settings
class NStepSARSA(NamedTuple):
    """On-policy control with n rewards in the target.

        G = R_τ+1 + γ R_τ+2 + ... + γⁿ⁻¹ R_τ+n + γⁿ Q(S_τ+n, A_τ+n)
        Q(S_τ, A_τ) <- Q(S_τ, A_τ) + α [G - Q(S_τ, A_τ)]                with τ = t - n + 1

    At time t the agent updates the pair of n - 1 steps ago; in the first n - 1 steps it updates nothing. When the
    episode ends, it updates the remaining pairs, oldest first; their targets have fewer rewards. After termination a
    target does not bootstrap. After truncation it bootstraps from Q(S_t+1, A_t+1), read before these last updates. With
    n = `math.inf` the agent learns only at the end of an episode (if it is no longer than `longest`). For episodes that
    terminate this is Monte Carlo control (every visit, constant α).

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        steps: a ring buffer with the last n transitions.
        returns: shape (min(n, longest),): the target G of each transition in the buffer.
        n: how many rewards, a whole number of 1 or more, or infinity. What counts is the length of the buffer.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.

    References: Sutton and Barto, 2nd edition, equations 7.4 and 7.5 and the box of section 7.2.
    """

    Q: ActionValues
    steps: LastSteps
    returns: Annotated[Reals, Table(("n",))]
    n: Annotated[float, Range(1, math.inf)] = 4.0
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)

    def learn(
        self,
        state: int,
        action: int,
        reward: float,
        next_state: int,
        next_action: int,
        terminated: bool,
        truncated: bool,
    ) -> None:
        """Store the step, and update the pair whose n rewards are complete; at the end, all that are left."""
        n = len(self.steps.rewards)
        t = self.steps.remember(state, action, reward, next_state)
        ended = terminated or truncated
        if ended or t + 1 >= n:
            first = max(t - n + 1, 0)
            G = 0.0 if terminated else float(self.Q[next_state, next_action])
            for k in range(t, first - 1, -1):
                G = self.steps.rewards[k % n] + self.discount * G
                self.returns[k % n] = G
            for tau in range(first, t + 1 if ended else first + 1):
                s, a = self.steps.states[tau % (n + 1)], self.steps.actions[tau % n]
                self.Q[s, a] += self.learning_rate * (self.returns[tau % n] - self.Q[s, a])
        if ended:
            self.steps.forget()

    def forget_episode(self) -> None:
        """Forget the steps of an episode that was not played to its end."""
        self.steps.forget()

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, *, n: float = 4, longest: int = 10_000, **settings: Any) -> "NStepSARSA":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            n: how many rewards the target has: a whole number of 1 or more, or `math.inf` for Monte Carlo.
            longest: the largest size of the buffer, from 1 to 2^28. A larger n acts as n = `longest`.
            **settings: the learning rate and what follows it above, and `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        most = whole_number("longest", longest, 1, MOST_ENTRIES)
        if isinstance(n, str):
            raise ValueError(f"n must be a whole number, 1 or more, or infinity, math.inf, but is {n!r}")
        if not (isinstance(n, float) and n == math.inf):
            most = min(most, number_of_steps("n", int(n) if isinstance(n, float) and n.is_integer() else n))
        return new(cls, environment, {**settings, "n": n}, **{"n": most, "n + 1": most + 1})

"""n-step tree backup: several steps off-policy without importance sampling."""

import math
from typing import Annotated, Any, NamedTuple

from edugym.agents.last_steps import LastSteps
from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration, Greedy, Policy, check_policy
from edugym.agents.tables import greedy_action, one_step_target
from edugym.checks.parameters import MOST_ENTRIES, whole_number
from edugym.mdp.protocol import Random


@shows_settings
class TreeBackup(NamedTuple):
    """Learn the values of one policy from n steps of another: what was not done counts with its present value.

        G <- R_t+1 + γ Σ_a π(a|S_t+1) Q(S_t+1, a)
        for k = t, t - 1, ..., τ + 1:
            G <- R_k + γ Σ_{a≠A_k} π(a|S_k) Q(S_k, a) + γ π(A_k|S_k) G
        Q(S_τ, A_τ) <- Q(S_τ, A_τ) + α [G - Q(S_τ, A_τ)]                with τ = t - n + 1

    π is the target policy, by default the greedy one: with n = 1 that is Q-learning, and with more steps it looks as
    far as the actions were greedy. With a target like the exploration and n = 1 it is expected SARSA.

    At time t the agent updates the pair of n - 1 steps ago; when the episode ends, it updates the remaining pairs,
    oldest first. After termination a target does not bootstrap; after truncation it bootstraps from Σ_a π(a|S_t+1)
    Q(S_t+1, a). The box chooses the next action before the update; here it is chosen after it, as in Q-learning. (A
    `ScheduledEpsilonGreedy` as target policy advances only if it is the exploration as well.)

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        steps: a ring buffer with the last n transitions.
        n: how many steps, from 1 to 2^28.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.
        target_policy: π, whose values are learned.

    References: Precup, Sutton and Singh (2000); Sutton and Barto, 2nd edition, equation 7.16 and the box of section
    7.5.
    """

    Q: ActionValues
    steps: LastSteps
    n: Annotated[int, Range(1)] = 4
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)
    target_policy: Policy = Greedy()

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Store the step, and update the pair of n steps before; at the end, all that are left."""
        t = self.steps.remember(state, action, reward, next_state)
        ended = terminated or truncated
        first = t - self.n + 1
        if ended:
            first = max(first, 0)
            self.steps.forget()
        if first >= 0:
            for tau in range(first, t + 1 if ended else first + 1):
                next_value = self.target_policy.expected_value(self.Q, next_state)
                G = one_step_target(reward, self.discount, next_value, terminated)
                for k in range(t, tau, -1):
                    s, a = self.steps.states[k % (self.n + 1)], self.steps.actions[k % self.n]
                    pi = self.target_policy.probability(self.Q, s, a)
                    others = self.target_policy.expected_value(self.Q, s) - pi * self.Q[s, a]
                    G = self.steps.rewards[(k - 1) % self.n] + self.discount * (others + pi * G)
                s, a = self.steps.states[tau % (self.n + 1)], self.steps.actions[tau % self.n]
                self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])

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
    def create(cls, environment: Any, *, n: int = 4, **settings: Any) -> "TreeBackup":
        """A new agent for an environment (or the shape of a table).

        Args:
            environment: an MDP or Gymnasium environment, or the shape (n_states, n_actions).
            n: how many steps, from 1 to 2^28.
            **settings: see the class, and `initial_value`.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        if isinstance(n, float) and n == math.inf:
            raise ValueError("n must be a whole number, 1 or more, but is inf; the length of an episode is enough")
        n = whole_number("n", n, 1, MOST_ENTRIES)
        agent = new(cls, environment, {**settings, "n": n}, **{"n": n, "n + 1": n + 1})
        check_policy("target_policy", agent.target_policy)
        return agent

"""SARSA(λ): eligibility traces, on-policy."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import greedy_action, one_step_target
from edugym.agents.traces import Replacing, Trace, Traces, check_trace
from edugym.mdp.protocol import Random
from edugym.mdp.task import table_size


@shows_settings
class SARSALambda(NamedTuple):
    """On-policy control in which each TD error updates all pairs visited before it, the more recent ones the more.

        δ = R + γ Q(S', A') - Q(S, A)
        Z(S, A) <- Z(S, A) + 1   (accumulating),   1   (replacing),   (1 - α) Z(S, A) + 1   (Dutch)
        Q(s, a) <- Q(s, a) + α δ Z(s, a)                                    for all s, a
        Z(s, a) <- γ λ Z(s, a)                                              for all s, a

    With Dutch traces it is true online SARSA(λ): δ + Q(S, A) - Q_old takes the place of δ, and α (Q(S, A) - Q_old) is
    taken off Q(S, A), where Q_old is the Q(S', A') of the step before. With λ = 0 all are SARSA.

    All traces end with the episode, by the end of the task or by a step limit (which bootstraps).

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        Z: the eligibility traces that are not 0, as a list of pairs; one below 10⁻⁹ is dropped.
        trace_decay: λ, from 0 to 1.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.
        traces: `Accumulating()`, `Replacing()` or `Dutch()`.

    References: Rummery and Niranjan (1994); Sutton and Barto, 2nd edition, equations 12.5 to 12.7 and the two boxes of
    section 12.7, for a table; van Seijen et al. (2016), True online temporal-difference learning.
    """

    Q: ActionValues
    Z: Traces
    trace_decay: Annotated[float, Range(0, 1)] = 0.9
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.99
    exploration: Exploration = EpsilonGreedy(0.1)
    traces: Trace = Replacing()

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
        """Move all pairs that have a trace by the TD error."""
        value = float(self.Q[state, action])
        next_value = float(self.Q[next_state, next_action])
        delta = one_step_target(reward, self.discount, next_value, terminated) - value
        change = self.traces.true_online * (value - self.Z.next_value[0])  # Q(S, A) - Q_old
        self.Z.put(state, action, self.traces.visited(self.Z.value(state, action), self.learning_rate))
        for k in range(self.Z.n[0]):
            s, a = self.Z.states[k], self.Z.actions[k]
            self.Q[s, a] += self.learning_rate * (delta + change) * self.Z.values[k]
        self.Q[state, action] -= self.learning_rate * change
        self.Z.fade(self.discount * self.trace_decay)
        self.Z.next_value[0] = next_value
        if terminated or truncated:
            self.Z.clear()

    def forget_episode(self) -> None:
        """Forget the traces of an episode that was not played to its end."""
        self.Z.clear()
        self.Z.next_value[0] = 0.0

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by the exploration strategy."""
        return self.exploration.choose(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)

    @classmethod
    def create(cls, environment: Any, **settings: Any) -> "SARSALambda":
        """Create an agent with a new Q. `environment` is an MDP, a Gymnasium environment, or (n_states, n_actions).

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q starts
        at `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or out of range, or the environment does not fit a table.
        """
        n_states, n_actions = table_size(environment)
        agent = new(cls, environment, settings, pairs=n_states * n_actions)
        check_trace(agent.traces)
        return agent

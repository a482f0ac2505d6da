"""Q(λ): eligibility traces, off-policy."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import ActionValues, Discount, LearningRate, Range, new, shows_settings
from edugym.agents.strategies import EpsilonGreedy, Exploration
from edugym.agents.tables import best_value, greedy_action, one_step_target, tied
from edugym.agents.traces import Replacing, Trace, Traces, check_trace
from edugym.mdp.protocol import Random
from edugym.mdp.task import table_size


@shows_settings
class QLambda(NamedTuple):
    """Q-learning in which each TD error updates all pairs from which greedy actions led to it: Watkins's Q(λ).

        δ = R + γ max_a Q(S', a) - Q(S, A)
        Z(S, A) <- Z(S, A) + 1   (accumulating),   1   (replacing),   (1 - α) Z(S, A) + 1   (Dutch)
        Q(s, a) <- Q(s, a) + α δ Z(s, a)                                    for all s, a
        Z(s, a) <- γ λ Z(s, a) if A' is greedy, else 0                      for all s, a

    A' is the action that will be taken next. When it explores, what follows says nothing about the greedy policy, and
    all traces are cut; so with much exploration there is little to gain from them. As with SARSA(λ), Dutch traces come
    with the true online terms; for Q(λ) this is our own combination. With λ = 0 it is Q-learning (that chooses its next
    action before it learns).

    All traces end with the episode, by the end of the task or by a step limit (which bootstraps).

    Attributes:
        Q: shape (n_states, n_actions): the action values.
        Z: the eligibility traces that are not 0, as a list of pairs; one below 10⁻⁹ is dropped.
        trace_decay: λ, from 0 to 1.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        exploration: how actions are chosen.
        traces: `Accumulating()`, `Replacing()` or `Dutch()`.

    References: Watkins (1989); Sutton and Barto, 2nd edition, section 12.10 (the box is in the first edition, section
    7.6).
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
        next_value = best_value(self.Q, next_state)
        next_is_greedy = tied(self.Q[next_state, next_action], next_value)
        delta = one_step_target(reward, self.discount, next_value, terminated) - value
        change = self.traces.true_online * (value - self.Z.next_value[0])  # Q(S, A) - Q_old
        self.Z.put(state, action, self.traces.visited(self.Z.value(state, action), self.learning_rate))
        for k in range(self.Z.n[0]):
            s, a = self.Z.states[k], self.Z.actions[k]
            self.Q[s, a] += self.learning_rate * (delta + change) * self.Z.values[k]
        self.Q[state, action] -= self.learning_rate * change
        self.Z.fade(self.discount * self.trace_decay)
        self.Z.next_value[0] = next_value
        if terminated or truncated or not next_is_greedy:
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
    def create(cls, environment: Any, **settings: Any) -> "QLambda":
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

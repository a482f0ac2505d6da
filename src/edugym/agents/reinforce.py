"""REINFORCE with a baseline, with tables."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Counter, Discount, LearningRate, Range, Table, new, shows_settings
from edugym.agents.softmax import draw_action, follow_log_gradient, softmax
from edugym.agents.tables import greedy_action
from edugym.checks.parameters import MOST_ENTRIES, whole_number
from edugym.mdp.protocol import Integers, Random, Reals


class Episode(NamedTuple):
    """The episode under way.

    Attributes:
        length: shape (1,): how many steps it has taken.
        states: shape (longest + 1,): the state before each step, and the one reached last.
        actions: shape (longest,): the action of each step.
        rewards: shape (longest,): the reward of each step.
    """

    length: Counter
    states: Annotated[Integers, Table(("longest + 1",))]
    actions: Annotated[Integers, Table(("longest",))]
    rewards: Annotated[Reals, Table(("longest",))]


@shows_settings
class REINFORCE(NamedTuple):
    """Monte Carlo policy gradient: at the end of an episode, actions that were followed by high returns get likelier.

    For each step t of the episode, in order, with the return G from there:

        δ = G - V(S_t)
        V(S_t) <- V(S_t) + α^w δ
        θ(S_t, ·) <- θ(S_t, ·) + α^θ γ^t δ ∇ln π(A_t|S_t, θ)     with π(a|s, θ) ∝ exp(θ(s, a))

    The baseline V makes the gradient less noisy, and does not change its mean in episodes that visit no state twice. In
    others V has already moved at the second visit, and then the order of the steps matters. `value_learning_rate=0`
    goes without a baseline. Where an episode is truncated, V of the last state stands for the rewards that are missing
    (so without a baseline they count as 0).

    Attributes:
        preferences: shape (n_states, n_actions): θ.
        V: shape (n_states,): the baseline.
        probabilities: shape (n_actions,): π(·|s) of the state seen last.
        episode: the episode under way.
        learning_rate: α^θ, greater than 0 and up to 1.
        value_learning_rate: α^w, from 0 to 1.
        discount: γ, from 0 to 1.

    References: Williams (1992); Sutton and Barto, 2nd edition, the box "REINFORCE with Baseline (episodic)" of section
    13.4, and that of 13.3 for none, with tables.
    """

    preferences: Annotated[Reals, Table(("states", "actions"))]
    V: Annotated[Reals, Table(("states",))]
    probabilities: Annotated[Reals, Table(("actions",))]
    episode: Episode
    learning_rate: LearningRate = 0.1
    value_learning_rate: Annotated[float, Range(0, 1)] = 0.1
    discount: Discount = 0.99

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Note the step; at the end of the episode (or where there is no more room), learn from it."""
        t = self.episode.length[0]
        self.episode.states[t] = state
        self.episode.actions[t] = action
        self.episode.rewards[t] = reward
        self.episode.states[t + 1] = next_state
        self.episode.length[0] = t + 1
        if terminated or truncated or t + 1 == len(self.episode.rewards):
            self.learn_from_episode(0.0 if terminated else self.V[next_state])

    def learn_from_episode(self, last_value: float) -> None:
        """Update baseline and policy at every step; `last_value` is that of the state in which the episode stopped."""
        episode, n_steps = self.episode, self.episode.length[0]
        G = last_value
        for t in range(n_steps - 1, -1, -1):
            G = episode.rewards[t] + self.discount * G
            episode.rewards[t] = G  # from here on: the return from step t
        power = 1.0  # γ^t
        for t in range(n_steps):
            state = episode.states[t]
            error = episode.rewards[t] - self.V[state]
            self.V[state] += self.value_learning_rate * error
            softmax(self.preferences, state, self.probabilities)
            size = self.learning_rate * power * error
            follow_log_gradient(self.preferences, state, episode.actions[t], self.probabilities, size)
            power *= self.discount
        episode.length[0] = 0

    def forget_episode(self) -> None:
        """Forget the steps of an episode that was not played to its end."""
        self.episode.length[0] = 0

    def act(self, state: int, rng: Random) -> int:
        """Draw an action from π(·|s)."""
        softmax(self.preferences, state, self.probabilities)
        return draw_action(self.probabilities, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The most likely action."""
        return greedy_action(self.preferences, state, rng)

    @classmethod
    def create(cls, environment: Any, longest: int = 10_000, **settings: Any) -> "REINFORCE":
        """Create an agent with new tables for an MDP, a Gymnasium environment, or their shape (n_states, n_actions).

        Settings: every field that has a default.

        Args:
            environment: an MDP or Gymnasium environment with whole numbers for observations and actions.
            longest: how many steps of an episode there is room for, from 1 to 2^28. A longer one is
                learned from in parts, as if it were truncated after each: γ^t starts at 1 again.
            **settings: see the class.

        Raises:
            ValueError: a setting is not as above or as the class says, or the environment does not fit a table.
        """
        longest = whole_number("longest", longest, 1, MOST_ENTRIES)
        return new(cls, environment, settings, longest=longest, **{"longest + 1": longest + 1})

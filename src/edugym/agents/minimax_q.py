"""Minimax Q-learning."""

from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.settings import Discount, LearningRate, Part, Probability, Table, new, shows_settings
from edugym.agents.tables import one_step_target, random_action
from edugym.exact.zero_sum import solve_state, workspace
from edugym.mdp.markov_game import a_player, n_actions, table_shape
from edugym.mdp.player_policies import draw_from, uniform_policy
from edugym.mdp.protocol import Integers, Random, Reals


@shows_settings
class MinimaxQ(NamedTuple):
    """Q-learning for a zero-sum game: expect the worst that the other player can do.

        Q(S, A, O) <- Q(S, A, O) + α [R + γ V(S') - Q(S, A, O)]      O is the other player's action
        V(S)       <- max_π min_o Σ_a π(a) Q(S, a, o),  and π(S) is the policy that reaches it

    Attributes:
        Q: shape (n_observations, n_actions, n_other_actions): the value of each pair of actions.
        V: shape (n_observations,): what the policy guarantees, if Q is right.
        policy: shape (n_observations, n_actions): the probability of each action.
        worst: shape (n_observations, n_other_actions): the other player's best answer to it, which may be random.
        tableau: shape (n_actions + 1, n_other_actions + 1): the tableau of the simplex method (see `zero_sum`).
        labels: shape (n_actions + n_other_actions,): which variable stands at each of its rows and columns.
        share: shape (1,): what the decay has left of the learning rate.
        learning_rate: α at the start, greater than 0 and up to 1.
        decay: α is multiplied by this after each step, from 0 to 1.
        discount: γ, from 0 to 1.
        epsilon: the probability of a uniformly random action, from 0 to 1.

    The defaults are the settings with which Littman trained in soccer for a million steps: α falls from 1 to 0.01, ε is
    0.2, and Q and V start at 1 (the setting `initial_value`), the most that can be won there. For n steps set the decay
    to 0.01 ** (1 / n). All of them are needed: over three seeds of a million steps of soccer they end with an
    exploitability of 0.02 to 0.05; with a constant α of 0.1 it was 0.23 to 0.31, with first values of 0 it was 0.25 to
    0.30, and with both and ε = 0.1 it was 0.55 to 0.61, no better than random play.

    Choices: where several policies guarantee the value, the simplex method finds one of them. α falls with every step
    of the player, whatever its state, as in the paper. Littman goes on after a goal, and his value of the next state
    is then that of the next kick-off; here it is 0, since a goal ends the episode.

    References: Littman (1994), Markov games as a framework for multi-agent reinforcement learning, figure 1 and section
    6.2.
    """

    Q: Annotated[Reals, Table(("states", "actions", "others"), fill="initial_value")]
    V: Annotated[Reals, Table(("states",), fill="initial_value")]
    policy: Annotated[Reals, Part()]
    worst: Annotated[Reals, Part()]
    tableau: Annotated[Reals, Part()]
    labels: Annotated[Integers, Part()]
    share: Annotated[Reals, Table((1,), fill=1.0)]
    learning_rate: LearningRate = 1.0
    decay: Probability = 0.01**1e-6
    discount: Discount = 0.9
    epsilon: Probability = 0.2

    def learn(
        self, state: int, action: int, other_action: int, reward: float, next_state: int, terminated: bool
    ) -> None:
        """Move the value of the pair of actions towards R + γ V(S'), and solve the matrix game of S anew."""
        target = one_step_target(reward, self.discount, float(self.V[next_state]), terminated)
        learning_rate = self.learning_rate * self.share[0]
        self.Q[state, action, other_action] += learning_rate * (target - self.Q[state, action, other_action])
        self.share[0] *= self.decay
        self.V[state] = solve_state(self.Q, state, self.policy, self.worst, self.tableau, self.labels)

    def act(self, state: int, rng: Random) -> int:
        """Draw from the policy, but with probability ε uniformly."""
        if rng.random() < self.epsilon:
            return random_action(self.policy.shape[1], rng)
        return draw_from(self.policy, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """Draw from the policy."""
        return draw_from(self.policy, state, rng)

    @classmethod
    def create(cls, game: Any, player: int, *, initial_value: float = 1.0, **settings: Any) -> "MinimaxQ":
        """Create player 0 or 1 of a game, with new tables and a uniformly random policy.

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q and V
        starts at `initial_value`, by default 1.

        Raises:
            ValueError: a setting is unknown or not allowed, `game` is no game, or `player` is neither 0 nor 1.
        """
        states, actions = table_shape(game, player)
        others = n_actions(game, 1 - a_player(player))
        worst = np.full((states, others), 1.0 / others)
        tableau, labels = workspace(actions, others)
        parts = {"policy": uniform_policy(game, player), "worst": worst, "tableau": tableau, "labels": labels}
        settings["initial_value"] = initial_value
        return new(cls, None, settings, parts, states=states, actions=actions, others=others)

"""Fictitious play, with values that are learned."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Discount, LearningRate, Probability, Table, new, shows_settings
from edugym.agents.tables import one_step_target, random_action, replaces, tied
from edugym.mdp.markov_game import a_player, n_actions, table_shape
from edugym.mdp.protocol import Random, Reals


@shows_settings
class FictitiousPlay(NamedTuple):
    """Answer the other player as if it always drew its actions as often as it has done so far.

        N(S, O)    <- N(S, O) + 1                                     O is the other player's action
        Q(S, A, O) <- Q(S, A, O) + α [R + γ max_a Q̄(S', a) - Q(S, A, O)]
        Q̄(s, a)    = Σ_o Q(s, a, o) N(s, o) / Σ_o N(s, o)

    In a zero-sum matrix game with known payoffs the average play of two such players approaches an equilibrium
    (Robinson), although each move is a best answer and no draw from it. In games of many steps nothing is guaranteed.

    Attributes:
        Q: shape (n_observations, n_actions, n_other_actions): the value of each pair of actions.
        others: shape (n_observations, n_other_actions): N, how often the other has chosen each action.
        played: shape (n_observations, n_actions): how often this player has.
        learning_rate: α, greater than 0 and up to 1.
        discount: γ, from 0 to 1.
        epsilon: the probability of a uniformly random action, from 0 to 1.

    Choices: Brown's players know the payoffs; here they are learned, like action values. Before the first step N is 1
    for every action, as if the other had played all of them once. An action drawn with ε counts as played.

    References: Brown (1951), Iterative solution of games by fictitious play; Robinson (1951), An iterative method of
    solving a game.
    """

    Q: Annotated[Reals, Table(("states", "actions", "others"), fill="initial_value")]
    others: Annotated[Reals, Table(("states", "others"), fill=1.0)]
    played: Annotated[Reals, Table(("states", "actions"))]
    learning_rate: LearningRate = 0.1
    discount: Discount = 0.9
    epsilon: Probability = 0.1

    def learn(
        self, state: int, action: int, other_action: int, reward: float, next_state: int, terminated: bool
    ) -> None:
        """Count what both have played, and learn the value of the pair."""
        self.others[state, other_action] += 1.0
        self.played[state, action] += 1.0
        highest = self.expected(next_state, 0)
        for other in range(1, self.Q.shape[1]):
            highest = max(highest, self.expected(next_state, other))
        target = one_step_target(reward, self.discount, highest, terminated)
        self.Q[state, action, other_action] += self.learning_rate * (target - self.Q[state, action, other_action])

    def expected(self, state: int, action: int) -> float:
        """Q̄(s, a): the mean value of an action, if the other plays as often as so far."""
        total = 0.0
        count = 0.0
        for other in range(self.others.shape[1]):
            total += self.Q[state, action, other] * self.others[state, other]
            count += self.others[state, other]
        return float(total / count)

    def act(self, state: int, rng: Random) -> int:
        """The best answer, but with probability ε any action."""
        if rng.random() < self.epsilon:
            return random_action(self.Q.shape[1], rng)
        return self.greedy(state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The best answer to what the other has played; among equals it draws one."""
        best = 0
        highest = self.expected(state, 0)
        ties = 1
        for action in range(1, self.Q.shape[1]):
            value = self.expected(state, action)
            if tied(value, highest):
                ties += 1
                if replaces(ties, rng):
                    best = action
            elif value > highest:
                best = action
                highest = value
                ties = 1
        return best

    @property
    def policy(self) -> Reals:
        """Its average play: shape (n_observations, n_actions); the uniform policy where it has not been."""
        counts: Reals = self.played + (self.played.sum(axis=1, keepdims=True) == 0)
        shares: Reals = counts / counts.sum(axis=1, keepdims=True)
        return shares

    @classmethod
    def create(cls, game: Any, player: int, **settings: Any) -> "FictitiousPlay":
        """Create player 0 or 1 of a game, with new tables.

        The settings are `initial_value` and the fields that have a default. Pass them by name. Every entry of Q starts
        at `initial_value`, by default 0.

        Raises:
            ValueError: a setting is unknown or not allowed, `game` is no game, or `player` is neither 0 nor 1.
        """
        states, actions = table_shape(game, player)
        return new(cls, None, settings, states=states, actions=actions, others=n_actions(game, 1 - a_player(player)))

"""A player who does not learn."""

from typing import Any, NamedTuple

from edugym.mdp.markov_game import a_player
from edugym.mdp.player_policies import checked_policy, draw_from
from edugym.mdp.protocol import Random, Reals


class FixedPlayer(NamedTuple):
    """A player who follows a given policy and never learns: somebody to train against.

    Attributes:
        policy: shape (n_observations, n_actions): the probability of each action.
    """

    policy: Reals

    def act(self, state: int, rng: Random) -> int:
        """Draw an action from the policy."""
        return draw_from(self.policy, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The same."""
        return draw_from(self.policy, state, rng)

    def learn(self) -> None:
        """Nothing is learned."""

    @classmethod
    def create(cls, game: Any, player: int, policy: Any) -> "FixedPlayer":
        """Make player 0 or 1 of a game with a policy of shape (n_observations, n_actions).

        Raises:
            ValueError: a parameter is something else, or a row of the policy holds no probabilities that sum to 1.
        """
        return cls(checked_policy(game, a_player(player), policy))

"""A game in which the other player's policy does not change is an MDP."""

from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.mdp.markov_game import a_player, scene_of
from edugym.mdp.player_policies import checked_policy, draw_from
from edugym.mdp.protocol import Random, Reals
from edugym.rendering.scene import Scene


class Met(NamedTuple):
    """A state of the MDP: one of the game, and what the other player did last, on which the reward depends.

    Attributes:
        state: the state of the game.
        other_action: the last action of the other player; 0 at the start.
    """

    state: Any
    other_action: int


class Against(NamedTuple):
    """The MDP that one player is in while the other follows a fixed policy; see `against`.

    Attributes:
        game: the game.
        player: who acts: 0 or 1.
        policy: shape (n_observations, n_actions) of the other player: the policy that it follows.
    """

    game: Any
    player: int
    policy: Reals

    def initial(self, rng: Random) -> Met:
        """As in the game."""
        return Met(self.game.initial(rng), 0)

    def transition(self, state: Met, action: int, rng: Random) -> Met:
        """The other player draws its action, and both move."""
        other_action = draw_from(self.policy, self.game.observation(state.state, 1 - self.player, rng), rng)
        actions = (action, other_action) if self.player == 0 else (other_action, action)
        return Met(self.game.transition(state.state, actions, rng), other_action)

    def reward(self, state: Met, action: int, next_state: Met, rng: Random) -> float:
        """What the game gives to this player."""
        other_action = next_state.other_action
        actions = (action, other_action) if self.player == 0 else (other_action, action)
        rewards = self.game.rewards(state.state, actions, next_state.state, rng)
        return float(rewards[0]) if self.player == 0 else float(rewards[1])

    def terminal(self, state: Met) -> bool:
        """Whether the game is over."""
        return bool(self.game.terminal(state.state))

    def observation(self, state: Met, rng: Random) -> int:
        """What this player sees."""
        return int(self.game.observation(state.state, self.player, rng))

    @property
    def observation_space(self) -> spaces.Discrete:
        """As in the game."""
        space: spaces.Discrete = self.game.observation_space(self.player)
        return space

    @property
    def action_space(self) -> spaces.Discrete:
        """As in the game."""
        space: spaces.Discrete = self.game.action_space(self.player)
        return space

    @property
    def max_steps(self) -> int | None:
        """As in the game."""
        return getattr(self.game, "max_steps", None)

    @property
    def action_names(self) -> tuple[str, ...]:
        """As in the game."""
        names: tuple[str, ...] = getattr(self.game, "action_names", ())
        return names

    def scene(self, state: Met) -> Scene:
        """As in the game; without a picture of its own, the state in words."""
        return scene_of(self.game, state.state)


def against(game: Any, player: int, policy: Any) -> Against:
    """The MDP that a player of a game is in while the other player follows a fixed policy.

    It is an ordinary MDP: `edugym.train` learns to play against this opponent, and the best that can be done against it
    is known exactly:

        mdp = against(game, 0, policy)
        values = value_iteration(finite_model(mdp), discount=0.9)
        run = train(mdp, QLearning.create(mdp), 100_000)

    Args:
        game: the game.
        player: who acts in the MDP: 0 or 1.
        policy: of the other player: shape (n_observations, n_actions), its probability of every action.

    Raises:
        ValueError: a parameter is not as above.
    """
    player = a_player(player)
    return Against(game, player, checked_policy(game, 1 - player, policy))

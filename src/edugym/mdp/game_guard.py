"""A guard that stops machine code where a player or a game of a student does what it may not (see `mdp.guards`)."""

import math
from typing import Any, NamedTuple

from edugym.mdp.membership import membership
from edugym.mdp.protocol import Random


class GuardedGame(NamedTuple):
    """A game that stops at a start, an action, a reward or an observation that is invalid; it draws nothing itself.

    Attributes:
        game: what it does.
        actions: for each player, what tells whether an action is in its space.
        seen: for each player, what tells whether an observation is in its space.
    """

    game: Any
    actions: tuple[Any, Any]
    seen: tuple[Any, Any]

    def initial(self, rng: Random) -> Any:
        """The first state of the game.

        Raises:
            ValueError: it is terminal.
        """
        state = self.game.initial(rng)
        if self.game.terminal(state):
            raise ValueError("an episode starts in a terminal state")
        return state

    def transition(self, state: Any, actions: tuple[Any, Any], rng: Random) -> Any:
        """The next state of the game.

        Raises:
            ValueError: an action is not in its space.
        """
        if not (self.actions[0].hold(actions[0]) and self.actions[1].hold(actions[1])):
            raise ValueError("an action is not in the action space")
        return self.game.transition(state, actions, rng)

    def rewards(self, state: Any, actions: tuple[Any, Any], next_state: Any, rng: Random) -> Any:
        """The rewards of the game.

        Raises:
            ValueError: one is not finite.
        """
        reward, other_reward = self.game.rewards(state, actions, next_state, rng)
        if not (math.isfinite(reward) and math.isfinite(other_reward)):
            raise ValueError("a reward is no finite number")
        return reward, other_reward

    def terminal(self, state: Any) -> Any:
        """As in the game."""
        return self.game.terminal(state)

    def observation(self, state: Any, player: int, rng: Random) -> Any:
        """What a player sees.

        Raises:
            ValueError: it is not in its space.
        """
        observation = self.game.observation(state, player, rng)
        if not self.seen[player].hold(observation):
            raise ValueError("an observation is not in the observation space")
        return observation


def guarded(game: Any) -> GuardedGame:
    """Put the guard around a game."""
    actions = membership(game.action_space(0)), membership(game.action_space(1))
    seen = membership(game.observation_space(0)), membership(game.observation_space(1))
    return GuardedGame(game, actions, seen)

"""Soccer in turns: the same field and the same contact, but nobody has to guess what the other does.

And a minimax Q-learner that is told whose action counts.
"""

from typing import NamedTuple

from gymnasium import spaces

from edugym.agents.minimax_q import MinimaxQ
from edugym.envs.games.soccer import Field, Soccer
from edugym.mdp.protocol import Random, Reals


class FieldInTurn(NamedTuple):
    """A field, and whose turn it is.

    Attributes:
        field: where the players and the ball are.
        turn: who moves next, 0 or 1.
    """

    field: Field
    turn: int


class SoccerInTurns(NamedTuple):
    """Soccer in which the players move one after the other, as in chess.

    Both choose an action at every step, but only that of the player whose turn it is counts. So whoever moves sees what
    the other has done. In such a game some action guarantees as much in each state as any random choice.

    Attributes:
        soccer: the game whose rules hold for each move.
        max_steps: the number of steps after which an episode is truncated: two steps are a move of each.
    """

    soccer: Soccer
    max_steps: int = 200

    def initial(self, rng: Random) -> FieldInTurn:
        """The start of soccer; a coin decides whose turn it is."""
        return FieldInTurn(self.soccer.initial(rng), 0 if rng.random() < 0.5 else 1)

    def transition(self, state: FieldInTurn, actions: tuple[int, int], rng: Random) -> FieldInTurn:
        """The player whose turn it is moves."""
        return FieldInTurn(self.soccer.moved(state.field, state.turn, actions[state.turn], rng), 1 - state.turn)

    def rewards(
        self, state: FieldInTurn, actions: tuple[int, int], next_state: FieldInTurn, rng: Random
    ) -> tuple[float, float]:
        """Those of soccer."""
        return self.soccer.rewards(state.field, actions, next_state.field, rng)

    def terminal(self, state: FieldInTurn) -> bool:
        """Whether somebody has scored."""
        return self.soccer.terminal(state.field)

    def observation(self, state: FieldInTurn, player: int, rng: Random) -> int:
        """The number of the state; both players see the same."""
        return 2 * self.soccer.observation(state.field, player, rng) + state.turn

    def observation_space(self, player: int) -> spaces.Discrete:
        """The numbers of states."""
        return spaces.Discrete(2 * int(self.soccer.observation_space(player).n))

    def action_space(self, player: int) -> spaces.Discrete:
        """Those of soccer."""
        return self.soccer.action_space(player)

    @property
    def action_names(self) -> tuple[str, ...]:
        """Those of soccer."""
        return self.soccer.action_names


class ToldWhoseTurn(NamedTuple):
    """A minimax Q-learner in soccer in turns that is told whose action counts.

    It learns from each step for all actions of the player whose turn it is not, as if each of them had been taken: so
    five values share what is learned, where `MinimaxQ` learns each by itself. Nothing else differs.

    Attributes:
        learner: which learns, five times from each step.
        player: which player it is, 0 or 1.
    """

    learner: MinimaxQ
    player: int

    def learn(
        self, state: int, action: int, other_action: int, reward: float, next_state: int, terminated: bool
    ) -> None:
        """Learn as if the player whose turn it is not had taken each of its actions."""
        for any_action in range(self.learner.policy.shape[1]):
            if state % 2 == self.player:  # an observation is odd where it is the turn of player 1
                self.learner.learn(state, action, any_action, reward, next_state, terminated)
            else:
                self.learner.learn(state, any_action, other_action, reward, next_state, terminated)

    def act(self, state: int, rng: Random) -> int:
        """Draw from the policy, but with probability ε uniformly."""
        return self.learner.act(state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """Draw from the policy."""
        return self.learner.greedy(state, rng)

    @property
    def policy(self) -> Reals:
        """What it has learned: shape (n_observations, n_actions)."""
        return self.learner.policy

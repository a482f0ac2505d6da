"""Matrix games: two players choose once, at the same moment, and a table says what each gets."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import a_number, an_array, in_short
from edugym.mdp.protocol import Random, Reals

MOST_ACTIONS = 1_000
"""The most actions of a player."""


class MatrixGame(NamedTuple):
    """Two players choose an action once, at the same moment; the payoffs are parameters.

    ## Description
    The smallest Markov game: an episode is one step. Player 0 chooses a row and player 1 a column, and the table of
    each says what it gets. The subclasses are games that everybody knows: `PrisonersDilemma`, `MatchingPennies`,
    `RockPaperScissors`, `StagHunt` and `Chicken`.

    ## State
    0 before the step, and 1 + n_columns a + b after the actions a and b.

    ## Observation spaces
    `Discrete(1)` for both: there is nothing to see.

    ## Action spaces
    `Discrete(n_rows)` for player 0, `Discrete(n_columns)` for player 1.

    ## Rewards
    `payoffs[a, b, 0]` for player 0 and `payoffs[a, b, 1]` for player 1.

    ## Episode end
    Terminated after one step.

    Attributes:
        payoffs: shape (n_rows, n_columns, 2): what each player gets for each pair of actions.
    """

    payoffs: Reals

    def initial(self, rng: Random) -> int:
        """Before the step."""
        return 0

    def transition(self, state: int, actions: tuple[int, int], rng: Random) -> int:
        """The state that says what was played."""
        return 1 + self.payoffs.shape[1] * actions[0] + actions[1]

    def rewards(self, state: int, actions: tuple[int, int], next_state: int, rng: Random) -> tuple[float, float]:
        """What the tables say."""
        a, b = actions
        return float(self.payoffs[a, b, 0]), float(self.payoffs[a, b, 1])

    def terminal(self, state: int) -> bool:
        """After the step."""
        return state > 0

    def observation(self, state: int, player: int, rng: Random) -> int:
        """Nothing."""
        return 0

    def observation_space(self, player: int) -> spaces.Discrete:
        """Nothing to see."""
        return spaces.Discrete(1)

    def action_space(self, player: int) -> spaces.Discrete:
        """The rows for player 0, the columns for player 1."""
        return spaces.Discrete(self.payoffs.shape[player])

    @property
    def action_names(self) -> tuple[str, ...]:
        """The names of the actions of both players: their numbers."""
        return tuple(map(str, range(max(self.payoffs.shape[:2]))))


class PrisonersDilemma(MatrixGame):
    """Two prisoners: each gains by talking, and both lose if both do.

    Challenge: what is best for each is not best for both. If both keep silent, each gets 3, and if both talk, each gets
    1. Who talks while the other keeps silent gets the temptation, and the other 0. The temptation is the strength:
    above 3, talking is better whatever the other does, and that is the dilemma; at 3 or below, silence is an
    equilibrium too.

    Actions: 0 silent, 1 talk.
    """

    @property
    def action_names(self) -> tuple[str, ...]:
        """Silence is action 0."""
        return "silent", "talk"

    @classmethod
    def create(cls, temptation: float = 5.0) -> "PrisonersDilemma":
        """Make the game with this temptation, a finite number.

        Raises:
            ValueError: it is something else.
        """
        t = a_number("temptation", temptation)
        return cls(_payoffs([[3, 0], [t, 1]], [[3, t], [0, 1]]))


class MatchingPennies(MatrixGame):
    """Player 0 wins 1 from the other if both show the same side of a coin, and player 1 if they do not.

    Challenge: whoever can be predicted loses. The only equilibrium is to toss the coin, and the value is 0.

    Actions: 0 heads, 1 tails.
    """

    @property
    def action_names(self) -> tuple[str, ...]:
        """The sides of the coin."""
        return "heads", "tails"

    @classmethod
    def create(cls) -> "MatchingPennies":
        """Make the game."""
        return cls(_payoffs([[1, -1], [-1, 1]]))


class RockPaperScissors(MatrixGame):
    """Paper beats rock, scissors beat paper, and rock beats scissors; the winner gets 1 from the other.

    Challenge: whoever can be predicted loses. The only equilibrium is a third each, and the value is 0.

    Actions: 0 rock, 1 paper, 2 scissors.
    """

    @property
    def action_names(self) -> tuple[str, ...]:
        """Each beats the one before it."""
        return "rock", "paper", "scissors"

    @classmethod
    def create(cls) -> "RockPaperScissors":
        """Make the game."""
        return cls(_payoffs([[0, -1, 1], [1, 0, -1], [-1, 1, 0]]))


class StagHunt(MatrixGame):
    """Two hunters: together they catch a stag, and each alone a hare.

    Challenge: to trust. With both after the stag each gets 4, and alone after it 0. A hare is worth `hare`, whatever
    the other does: the strength. From 0 to 4 both pairs of equal actions are equilibria; above 2, whoever believes that
    the other tosses a coin hunts the hare.

    Actions: 0 stag, 1 hare.
    """

    @property
    def action_names(self) -> tuple[str, ...]:
        """What is hunted."""
        return "stag", "hare"

    @classmethod
    def create(cls, hare: float = 3.0) -> "StagHunt":
        """Make the game with a hare of this worth, a finite number.

        Raises:
            ValueError: it is something else.
        """
        hare = a_number("hare", hare)
        return cls(_payoffs([[4, 0], [hare, hare]], [[4, hare], [0, hare]]))


class Chicken(MatrixGame):
    """Two drivers race towards each other: who swerves loses face, and if nobody does, both crash.

    Challenge: somebody must give way, and nobody wants to. Going on while the other swerves is worth 1, to the other
    -1, and swerving together 0. A crash costs both `crash`: the strength. Above 1 the equilibria are that exactly one
    of them goes on, and a random one in which each goes on with the probability 1/crash; below 1 both go on.

    Actions: 0 swerve, 1 go on.
    """

    @property
    def action_names(self) -> tuple[str, ...]:
        """Swerving is action 0."""
        return "swerve", "go on"

    @classmethod
    def create(cls, crash: float = 10.0) -> "Chicken":
        """Make the game with a crash that costs so much, a finite number.

        Raises:
            ValueError: it is something else.
        """
        crash = a_number("crash", crash)
        return cls(_payoffs([[0, -1], [1, -crash]], [[0, 1], [-1, -crash]]))


def matrix_game(first: Any, second: Any = None) -> MatrixGame:
    """Make a game of two tables.

    Args:
        first: shape (n_rows, n_columns): what player 0 gets; finite numbers, from 1 to 1000 rows and columns.
        second: what player 1 gets, of the same shape; by default the opposite, which makes the game zero-sum.

    Raises:
        ValueError: they are something else.
    """
    return MatrixGame(_payoffs(first, second))


def _payoffs(first: Any, second: Any = None) -> Reals:
    """Both tables as one array of shape (n_rows, n_columns, 2), checked."""
    tables = [an_array("first", first, ("n_rows", "n_columns"))]
    tables.append(-tables[0] if second is None else an_array("second", second, tables[0].shape))
    if not all(0 < length <= MOST_ACTIONS for length in tables[0].shape):
        raise ValueError(f"first must have from 1 to {MOST_ACTIONS} rows and columns, but has {tables[0].shape}")
    for name, table in zip(("first", "second"), tables, strict=True):
        if not np.isfinite(table).all():
            raise ValueError(f"{name} must hold finite numbers, but is {in_short(table)}")
    return np.stack(tables, axis=2) + 0.0  # -0 becomes 0

"""Boards of Catch: balls from some columns only, and a feature that fits."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Table, new
from edugym.envs.catch import Fall
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.mdp.wrapper import wrapper


@wrapper
class ThrownFrom(NamedTuple):
    """Catch with balls from some columns only, each as likely.

    Attributes:
        mdp: the task.
        columns: shape (n,): the columns.
    """

    mdp: Any
    columns: Integers

    def initial(self, rng: Random) -> Fall:
        """A ball in one of the columns."""
        column = int(self.columns[int(rng.random() * len(self.columns))])
        return Fall(column, 0, self.mdp.initial(rng).paddle_x)

    def observe_into(self, state: Fall, rng: Random, out: Any) -> None:
        """Write what the task shows; without this method each step would make an array."""
        self.mdp.observe_into(state, rng, out)


class Offset(NamedTuple):
    """Features of a board: a 1 for how far the ball is to the right of the paddle, and no more.

    Attributes:
        active: shape (1,): the offset, plus columns - 1.
        values: shape (1,): 1.
        rows: of the board.
        columns: of the board.
    """

    active: Annotated[Integers, Table((1,))]
    values: Annotated[Reals, Table((1,), fill=1.0)]
    rows: int
    columns: int

    @property
    def n_inputs(self) -> int:
        """One for each pixel."""
        return self.rows * self.columns

    @property
    def n_features(self) -> int:
        """One for each offset."""
        return 2 * self.columns - 1

    @property
    def at_once(self) -> int:
        """One feature is 1."""
        return 1

    @property
    def n_active(self) -> int:
        """One."""
        return 1

    def see(self, state: Any) -> None:
        """Look for the ball above the last row, and for the paddle in it."""
        ball = paddle = 0
        for pixel in range(len(state)):
            if state[pixel] > 0.0:
                if pixel < (self.rows - 1) * self.columns:
                    ball = pixel % self.columns
                else:
                    paddle = pixel % self.columns
        self.active[0] = ball - paddle + self.columns - 1

    @classmethod
    def create(cls, rows: int, columns: int) -> "Offset":
        """Features for boards of a size."""
        return new(cls, None, {"rows": rows, "columns": columns})

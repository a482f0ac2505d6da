"""Soccer: an opponent that adapts."""

from typing import NamedTuple

from gymnasium import spaces

from edugym.checks.parameters import between, number_of_steps
from edugym.mdp.protocol import Random
from edugym.rendering.icons import smiley
from edugym.rendering.palette import BLUE, GRASS, INK, RED, WHITE
from edugym.rendering.scene import Circle, Line, Rectangle, Scene, Shape, Text

N_ROWS, N_COLUMNS = 4, 5
N_SQUARES = N_ROWS * N_COLUMNS
GOAL = N_SQUARES
"""The place of a player who has carried the ball into the goal."""
NORTH, SOUTH, EAST, WEST, STAND = range(5)
STARTS = (6, 13)
"""Row 1, column 1 for player 0, and row 2, column 3 for player 1: half a turn of the field exchanges them."""


class Field(NamedTuple):
    """Where the players and the ball are. Squares are numbered by rows: row r, column c is 5 r + c; 20 is the goal.

    Attributes:
        first: the place of player 0.
        second: the place of player 1.
        ball: who has the ball, 0 or 1.
    """

    first: int
    second: int
    ball: int


class Soccer(NamedTuple):
    """Carry the ball past the other player and into the goal.

    ## Description
    Challenge: an opponent that adapts. Two players want to get past each other on a small field. Whoever has the ball
    and runs into the other loses it. So a player who always goes the same way is stopped, and the best policies are
    random in some states. (Against an opponent that does not change, a deterministic policy is as good as any.) The
    strength is `contact`: at 0 who has the ball runs through the other, who does not matter, and the shortest way to
    the goal is best; at 1 the rules are those of Littman (1994).

    ## State
    `Field(first, second, ball)`: the squares of the two players, never the same, and who has the ball. The field has 4
    rows, 0 to 3 from north to south, and 5 columns, 0 to 4 from west to east; square 5 r + c is row r, column c. Square
    20 is the goal: a player who is there has scored. With the 40 states in which somebody has scored there are 800.

    ## Observation spaces
    `Discrete(801)` for both, who see the same: (20 f + s) 2 + b for the squares f and s of players 0 and 1 and the
    owner b of the ball; 800 when the game is over.

    ## Action spaces
    `Discrete(5)` for both: north, south, east, west, stand.

    ## Dynamics
    A fair coin decides who moves first (with `rng.random() < 0.5` player 0); then the two moves are made one after the
    other, each in the field that it finds. A move leads to the next square in its direction; `stand` leads nowhere.

    - Beyond the edge of the field there are two goals: east of rows 1 and 2 in column 4, into which player 0 scores,
      and west of rows 1 and 2 in column 0, into which player 1 scores. A player with the ball who moves into the goal
      in which it scores goes to square 20, and the game is over: a second move is not made. Every other move beyond
      the edge changes nothing.
    - If the other player stands on the square and the mover does not have the ball, nothing changes.
    - If the other player stands on the square and the mover has the ball, then with the probability `contact`
      (`rng.random() < contact`) both stay and the other player gets the ball; else both change places, and the mover
      keeps the ball.

    ## Rewards
    1 for the player who scores and -1 for the other; else 0 for both. The game is zero-sum.

    ## Initial state
    Player 0 in row 1, column 1 and player 1 in row 2, column 3; a fair coin decides who has the ball (with
    `rng.random() < 0.5` player 0). Turned by half a turn, with the players exchanged, the game is the same: its value
    is 0 by symmetry.

    ## Episode end
    Terminated when a player has scored; else truncated after `max_steps` steps.

    ## Parameters
    - `contact` (1.0): the probability that running into the other player costs the ball, from 0 to 1.
    - `max_steps` (100): the number of steps after which an episode is truncated, from 1 to 2^62.

    ## Choices
    What differs from Littman (1994), section 6:

    - There the players start anew after a goal, and play on; here a goal ends the episode. (In his tests, not in
      training, a step is also declared a draw with probability 0.1, in place of the discount of 0.9. Here the discount
      belongs to the players, and there are no draws.)
    - There is no step limit there; `max_steps` is ours.
    - There is no `contact` there: it is 1.
    - His A scores in the west and his B in the east: player 0 is his B.
    - The squares at the start are in a figure that we have not seen. Programs of others that follow the paper start as
      here, or with rows 1 and 2 exchanged, which is the same game in a mirror.
    - That a player without the ball who runs into the other changes nothing follows from his rule, by which the
      player who stands still gets the ball: it has it already.

    ## References
    Littman (1994), Markov games as a framework for multi-agent reinforcement learning, section 6.
    """

    contact: float = 1.0
    max_steps: int = 100

    def initial(self, rng: Random) -> Field:
        """Both at their starts; a coin decides who has the ball."""
        return Field(STARTS[0], STARTS[1], 0 if rng.random() < 0.5 else 1)

    def transition(self, state: Field, actions: tuple[int, int], rng: Random) -> Field:
        """Both move, in random order."""
        earlier = 0 if rng.random() < 0.5 else 1
        later = 1 - earlier
        between_moves = self.moved(state, earlier, actions[earlier], rng)
        if self.terminal(between_moves):
            return between_moves
        return self.moved(between_moves, later, actions[later], rng)

    def moved(self, state: Field, player: int, action: int, rng: Random) -> Field:
        """The field after the move of one player."""
        here = state.first if player == 0 else state.second
        other = state.second if player == 0 else state.first
        square = target(here, player, action, state.ball == player)
        if square != other:
            return Field(square, other, state.ball) if player == 0 else Field(other, square, state.ball)
        if state.ball != player:
            return state
        if rng.random() < self.contact:
            return Field(state.first, state.second, 1 - player)
        return Field(state.second, state.first, state.ball)

    def rewards(self, state: Field, actions: tuple[int, int], next_state: Field, rng: Random) -> tuple[float, float]:
        """1 for who has scored, -1 for the other."""
        if next_state.first == GOAL:
            return 1.0, -1.0
        if next_state.second == GOAL:
            return -1.0, 1.0
        return 0.0, 0.0

    def terminal(self, state: Field) -> bool:
        """Whether somebody has scored."""
        return state.first == GOAL or state.second == GOAL

    def observation(self, state: Field, player: int, rng: Random) -> int:
        """The number of the state; both players see the same."""
        if self.terminal(state):
            return 2 * N_SQUARES * N_SQUARES
        return (N_SQUARES * state.first + state.second) * 2 + state.ball

    def observation_space(self, player: int) -> spaces.Discrete:
        """The numbers of states, with one for all in which the game is over."""
        return spaces.Discrete(2 * N_SQUARES * N_SQUARES + 1)

    def action_space(self, player: int) -> spaces.Discrete:
        """North, south, east, west, stand."""
        return spaces.Discrete(5)

    @property
    def action_names(self) -> tuple[str, ...]:
        """The names of the actions."""
        return "north", "south", "east", "west", "stand"

    @classmethod
    def create(cls, contact: float = 1.0, max_steps: int = 100) -> "Soccer":
        """Check the parameters (see the class) and make the game.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        return cls(float(between("contact", contact, 0, 1)), number_of_steps("max_steps", max_steps))

    def scene(self, state: Field) -> Scene:
        """The field from above, with a goal on either side; player 0 is blue and plays to the right."""
        shapes: list[Shape] = [Rectangle(1.0, 0.5, N_COLUMNS, N_ROWS, fill=GRASS, outline_width=0.06)]
        edges = [((1.0 + column, 0.5), (1.0 + column, 0.5 + N_ROWS)) for column in range(1, N_COLUMNS)]
        edges += [((1.0, 0.5 + row), (1.0 + N_COLUMNS, 0.5 + row)) for row in range(1, N_ROWS)]
        shapes += [Line(edge, colour=WHITE, line_width=0.03) for edge in edges]
        for x, colour, glyph in ((0.1, RED, "["), (1.0 + N_COLUMNS, BLUE, "]")):
            shapes.append(Rectangle(x, 1.5, 0.9, 2.0, fill=WHITE, outline=colour, outline_width=0.1, glyph=glyph))
        places = state.first, state.second
        for player, (place, colour) in enumerate(zip(places, (BLUE, RED), strict=True)):
            x, y = 1.5 + place % N_COLUMNS, 1.0 + place // N_COLUMNS
            if place == GOAL:
                x, y = (1.45 + N_COLUMNS if player == 0 else 0.55), 2.5
            lost = self.terminal(state) and place != GOAL
            shapes.append(Circle(x, y, 0.44, fill=colour))
            shapes += smiley(x, y, 0.34, "sad" if lost else "happy", glyph="AB"[player])
            if state.ball == player:
                shapes.append(Circle(x + 0.3, y + 0.3, 0.14, fill=WHITE, outline_width=0.04, glyph="●"))
        who = f"player {0 if state.first == GOAL else 1} has scored" if self.terminal(state) else ""
        says = who or f"player {state.ball} has the ball"
        shapes.append(Text(1.0 + N_COLUMNS / 2, 5.0, says, size=0.4, colour=INK))
        return Scene(2.0 + N_COLUMNS, 1.5 + N_ROWS, shapes, title=f"Soccer: {says}", columns=28)


def target(here: int, player: int, action: int, has_ball: bool) -> int:
    """The square to which a move leads, were the player alone: its own where the move is not possible."""
    row, column = here // N_COLUMNS, here % N_COLUMNS
    if has_ball and 1 <= row <= 2:
        if player == 0 and action == EAST and column == N_COLUMNS - 1:
            return GOAL
        if player == 1 and action == WEST and column == 0:
            return GOAL
    if action == NORTH:
        row = max(row - 1, 0)
    elif action == SOUTH:
        row = min(row + 1, N_ROWS - 1)
    elif action == EAST:
        column = min(column + 1, N_COLUMNS - 1)
    elif action == WEST:
        column = max(column - 1, 0)
    return row * N_COLUMNS + column

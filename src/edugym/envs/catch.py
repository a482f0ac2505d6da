"""Catch: the dimensionality of observations (lesson 4)."""

import math
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import one_of, whole_number
from edugym.mdp.protocol import Random
from edugym.rendering.icons import Mood, smiley
from edugym.rendering.palette import GRASS, PAPER, RED, SHADE, SKY, YELLOW, rgb
from edugym.rendering.scene import Circle, Line, Rectangle, Scene, Shape, Text

BALL, PADDLE = rgb(YELLOW), rgb(RED)
"""Their colours in the observation type "rgb", on black."""

LONGEST = 1_000
MOST_CELLS = 50
"""On longer sides than this the lines between cells would hide the board."""

MOST_COLUMNS = 120
"""How many characters wide the picture is at most."""


class Fall(NamedTuple):
    """Where the ball and the paddle are: columns count from the left, rows from the top, both from 0."""

    ball_x: int
    ball_y: int
    paddle_x: int


class Catch(NamedTuple):
    """Catch a falling ball with a paddle; the same board is seen as three numbers, as a grid or as an image.

    ## Description
    Challenge: the dimensionality of the state, as the agent observes it. A ball falls from the top of a board; the
    agent moves a paddle along its bottom to catch it. The task is always the same small one, but the agent sees it in
    one of three ways: as the positions of ball and paddle (three numbers: at the defaults a table has 250 rows), as a
    grid (50 numbers, 0 or 1: a table over all grids would have 2^50 rows) or as an image (150 numbers from 0 to 255:
    256^150 rows).

    ## Observation space
    By `observation_type`:
    - `"vectorised"`: `MultiDiscrete([columns, rows, columns])`: the column and the row of the ball, and the column of
      the paddle, counted from 0, from the left and from the top.
    - `"grid"` (the paper's name for it, `"default"`, works too): `Box(0, 1, (rows, columns), float32)`: 1 at the ball
      and at the paddle, else 0.
    - `"rgb"`: `Box(0, 255, (rows, columns, 3), uint8)`: red, green and blue of each cell; the ball is yellow (255, 210,
      63), the paddle red (232, 80, 91), all else black. A ball on the paddle hides it.

    ## Action space
    `Discrete(3)`: the paddle moves 0 left, 1 not at all, 2 right.

    ## State
    The column and the row of the ball, and the column of the paddle. All three observations are Markov: until the ball
    is down, each of them tells the whole state (and the row of the ball the number of steps).

    ## Dynamics
    The paddle moves by one column, unless the edge of the board is in the way; then the ball falls by one row.

    ## Reward
    At the end 1 for a ball that is caught, -1 for one that is not; 0 before. Every ball can be caught, so the best
    return is 1 (discount 1); an agent that acts at random returns -0.6 on average at the defaults.

    ## Initial state
    The ball in the top row, in a column drawn uniformly from the environment's random stream; the paddle in column
    columns // 2.

    ## Episode end
    Terminated when the ball is in the paddle's row, after rows - 1 steps; never truncated.

    ## Parameters
    - `rows` (10): of the board, from 2 to 1000; rows and columns set how large an observation is.
    - `columns` (5): from 1 to 2 * rows - 1; on a wider board the paddle cannot reach every ball.
    - `observation_type` ("grid"): `"grid"`, `"default"`, `"vectorised"` or `"rgb"`.

    ## Info
    - `ball`: the column and the row of the ball.
    - `paddle`: the column of the paddle.

    ## Choices
    - The paper gives the vectorised observation as `MultiDiscrete([rows, rows, columns])`; the ball's column needs
      `columns` values.
    - The paper does not number the actions, does not say what happens at the edge of the board, nor that the paddle
      moves before the ball falls. With an even number of columns the paddle starts on the right of the middle.
    - The colours of the image.

    ## Algorithms
    The paper compares Q-learning with a table and deep Q-learning (Stable-Baselines3).

    ## References
    Moerland et al. (2023), EduGym, section 4 d and appendix A.4; the catch of Osband et al. (2020), bsuite.
    """

    rows: int
    columns: int

    def initial(self, rng: Random) -> Fall:
        """The ball in any column of the top row, the paddle in the middle of the bottom."""
        return Fall(int(rng.random() * self.columns), 0, self.columns // 2)

    def transition(self, state: Fall, action: int, rng: Random) -> Fall:
        """The paddle moves one column at most and stays on the board; the ball falls one row."""
        paddle_x = min(max(state.paddle_x + action - 1, 0), self.columns - 1)
        return Fall(state.ball_x, state.ball_y + 1, paddle_x)

    def reward(self, state: Fall, action: int, next_state: Fall, rng: Random) -> float:
        """1 for a ball that is caught, -1 for one that is missed; 0 while it falls."""
        if next_state.ball_y < self.rows - 1:
            return 0.0
        return 1.0 if next_state.ball_x == next_state.paddle_x else -1.0

    def terminal(self, state: Fall) -> bool:
        """The ball has reached the paddle's row."""
        return state.ball_y == self.rows - 1

    def observation(self, state: Fall, rng: Random) -> Any:
        """The column and the row of the ball and the column of the paddle."""
        return state.ball_x, state.ball_y, state.paddle_x

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """Columns, rows, and columns again."""
        return spaces.MultiDiscrete([self.columns, self.rows, self.columns])

    @property
    def action_space(self) -> spaces.Discrete:
        """Left, stay or right."""
        return spaces.Discrete(3)

    @classmethod
    def create(
        cls,
        rows: int = 10,
        columns: int = 5,
        observation_type: str = "grid",
    ) -> "Catch":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        rows, columns = whole_number("rows", rows, 2, LONGEST), whole_number("columns", columns, 1, LONGEST)
        if columns > 2 * rows - 1:
            raise ValueError(
                f"columns must be at most {2 * rows - 1} with {rows} rows, so that the paddle can reach every ball, "
                f"but is {columns!r}"
            )
        one_of("observation_type", observation_type, list(KINDS))
        return KINDS[observation_type](rows, columns)

    @property
    def reward_threshold(self) -> float:
        """Every ball is caught."""
        return 1.0

    @property
    def action_names(self) -> tuple[str, ...]:
        """Where the paddle moves."""
        return "left", "stay", "right"

    def info(self, state: Fall) -> dict[str, Any]:
        """Where the ball and the paddle are."""
        return {"ball": np.array([state.ball_x, state.ball_y]), "paddle": int(state.paddle_x)}

    def scene(self, state: Fall) -> Scene:
        """The board, a yellow ball, and the agent below with its red paddle; above, how much of it the agent sees."""
        rows, columns = self.rows, self.columns
        ball_x, ball_y, paddle_x = state
        width, top = max(columns + 2.0, 7.0), 2.0
        left, bottom = (width - columns) / 2, top + rows
        mood: Mood = "flat"
        if ball_y == rows - 1:
            mood = "happy" if ball_x == paddle_x else "sad"
        seen = math.prod(self.observation_space.shape or ())
        shapes: list[Shape] = [
            Rectangle(0.0, bottom, width, 1.5, fill=GRASS, outline=None, glyph="░"),
            Rectangle(left, top, columns, rows, fill=PAPER, glyph="·"),
        ]
        if max(rows, columns) <= MOST_CELLS:
            shapes += [Line(((left + k, top), (left + k, bottom)), colour=SHADE) for k in range(1, columns)]
            shapes += [Line(((left, top + k), (left + columns, top + k)), colour=SHADE) for k in range(1, rows)]
        shapes += [
            Rectangle(left, top, columns, rows, fill=None),
            Text(width / 2, 1.0, f"the agent sees {seen} numbers", size=min(width / 16, 1.2), glyph=f"{seen} numbers"),
            Line(((left + paddle_x + 0.5, bottom + 0.4), (left + paddle_x + 0.5, bottom - 0.2)), colour=RED),
            Rectangle(left + paddle_x, bottom - 0.3, 1.0, 0.3, 0.1, fill=RED, glyph="▀"),
            Circle(left + ball_x + 0.5, top + ball_y + 0.36, 0.34, fill=YELLOW, glyph="o"),
            *smiley(left + paddle_x + 0.5, bottom + 0.65, 0.5, mood),
        ]
        return Scene(
            width,
            bottom + 1.5,
            shapes,
            SKY,
            f"Catch: ball in row {ball_y} of {rows}",
            columns=min(int(2 * width), MOST_COLUMNS),
        )


class CatchGrid(Catch):
    """Catch for an agent that sees the board as a grid of numbers, one for each cell."""

    __slots__ = ()

    def observation(self, state: Fall, rng: Random) -> Any:
        """The board: 1 where the ball or the paddle is, else 0."""
        board = np.empty((self.rows, self.columns), np.float32)
        self.observe_into(state, rng, board)
        return board

    def observe_into(self, state: Fall, rng: Random, board: Any) -> None:
        """The same, written into `board`, shape (rows, columns)."""
        board[:] = 0.0
        board[self.rows - 1, state.paddle_x] = 1.0
        board[state.ball_y, state.ball_x] = 1.0

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """A number for each cell."""
        return spaces.Box(0.0, 1.0, (self.rows, self.columns), np.float32)


class CatchImage(Catch):
    """Catch for an agent that sees the board as an image of one pixel for each cell."""

    __slots__ = ()

    def observation(self, state: Fall, rng: Random) -> Any:
        """The image: the ball yellow, the paddle red (yellow under the ball), all else black."""
        image = np.empty((self.rows, self.columns, 3), np.uint8)
        self.observe_into(state, rng, image)
        return image

    def observe_into(self, state: Fall, rng: Random, image: Any) -> None:
        """The same, written into `image`, shape (rows, columns, 3)."""
        image[:] = 0
        for channel in range(3):
            image[self.rows - 1, state.paddle_x, channel] = PADDLE[channel]
            image[state.ball_y, state.ball_x, channel] = BALL[channel]

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """Red, green and blue of each cell, from 0 to 255."""
        return spaces.Box(0, 255, (self.rows, self.columns, 3), np.uint8)


KINDS: dict[str, type[Catch]] = {"grid": CatchGrid, "default": CatchGrid, "vectorised": Catch, "rgb": CatchImage}
"""What the agent sees, by the name of the observation type."""

"""Diver: several objectives, between which weights choose (lesson 12)."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import an_array, between, in_short, number_of_steps
from edugym.mdp.protocol import Random, Reals
from edugym.rendering.icons import smiley
from edugym.rendering.palette import BLUE, INK, ORANGE, RED, SAND, SKY, WALL, WATER, WHITE, blend
from edugym.rendering.scene import Circle, Line, Polygon, Rectangle, Scene, Shape, Text

N_ROWS, N_COLUMNS = 10, 9
"""Row 0 is the surface of the sea; there is a treasure in each column."""
LARGEST_WEIGHT = 1_000_000
DOWN, RIGHT = 0, 1


class Diver(NamedTuple):
    """Dive for one of nine treasures: the deeper ones are worth more, and take more time.

    ## Description
    Challenge: several objectives, between which weights choose. A diver picks up one of nine treasures on the sea
    floor, which falls away from the shore like a staircase. Two objectives are in conflict: the value of the treasure,
    and time. The reward is a vector of two numbers, one for each objective, and no treasure is best in both. So there
    are nine good policies, one for each treasure, which together are the Pareto front. Most agents learn from one
    number: the two rewards are added up, each times a weight. Every choice of weights prefers some treasure; but there
    are treasures that no weights prefer. How many depends on the strength, `concavity`: at 0 weights find all nine, and
    at 1 only the first and the last.

    ## Observation space
    `Discrete(90)`: the cell of the diver, 9 y + x, where y is the row, from 0 at the surface to 9, and x the column,
    from 0 at the shore to 8.

    ## Action space
    `Discrete(2)`: 0 down, 1 right, away from the shore.

    ## State
    The observed number. The number of steps so far is not part of it, so near the step limit the observation is not
    Markov. (That does no harm to an agent that bootstraps at truncation.)

    ## Dynamics
    One cell in the direction of the action; in the last column an action to the right leaves the diver in place.
    Treasure k lies in column x = k and row y = k + 1; there is no water below it. Whoever comes to its cell picks it
    up.

    ## Reward
    The vector of rewards is (value, time): the value of the treasure for the step that picks it up, else 0; and -1 for
    every step. The method `rewards(state, action, next_state)` of the MDP returns it, and so does `info`. The reward,
    one number, is the sum of both, each times its weight.

    With the concavity c, treasure k is worth 10 + 10 k + k (8 - k) (8 + k - 16 c) / 16, from 10 for treasure 0 to 90
    for treasure 8. It takes 2 k + 1 steps (to treasure 8 there are also longer ways). So the points (value, -time) of
    the nine treasures are all Pareto-optimal. Some weights prefer treasure 0, and some prefer treasure k if k is
    8 c - 1/2 or more, but none prefer those between: at c = 0, 0.25, 0.5, 0.75 and 1, weights can find 9, 8, 6, 4 and 2
    treasures. At the defaults the best return is 23.0625, with treasure 7 (discount 1; with 0.99 treasure 6 is best).

    ## Initial state
    At the surface in the first column: state 0.

    ## Episode end
    Terminated when a treasure is picked up; else truncated after `max_steps` steps.

    ## Parameters
    - `concavity` (0.5): c, from 0 to 1.
    - `weights` ((1.0, 4.0)): the weight of the value and that of time, from 0 to one million, not both 0. At the
      defaults a step costs as much as a value of 4.
    - `max_steps` (100): the number of steps after which an episode is truncated, from 1 to 2^62.

    ## Info
    - `vector_reward`: the vector of rewards of the last step, shape (2,); (0, 0) at the start.
    - `vector_return`: the sum of these vectors in this episode, shape (2,).

    ## Choices
    - Vamplew et al. have ten treasures, on a less regular sea floor. Here there are nine, on a staircase, so that the
      times of any two neighbours differ by 2.
    - Their submarine also moves up and left. Without that, a learner finds every treasure soon, and exploration is no
      second challenge.
    - Their front is one fixed concave one. Here the values are a cubic function of time, with the concavity as its
      parameter. In each column they grow with the depth, at every concavity.
    - Their reward is the vector. Here it is the weighted sum, as Gymnasium wants one number, and the vector is beside
      it. `edugym.objectives.VectorRewardEnv` gives the vector, as MO-Gymnasium has it.

    ## Algorithms
    `edugym.objectives.exact_front` computes the Pareto front exactly, and `supported` says which of its points some
    weights prefer. An agent with one number as its reward learns one of those: `edugym.QLearning` with discount 1 and
    `EpsilonGreedy(0.5)` picks up treasure 7 after 100 000 steps at the defaults, with each of 20 seeds. Vamplew et al.
    (2011) measure what weighted sums miss. `edugym.objectives.ParetoQLearning` (Van Moffaert and Nowé, 2014) learns all
    points, with sets of vectors instead of values. `ChebyshevQLearning` there can learn each of them, and
    `LagrangianQLearning` makes one of the objectives a constraint.

    ## References
    Vamplew et al. (2011), Empirical evaluation methods for multiobjective reinforcement learning algorithms. It is not
    one of the nine environments of Moerland et al. (2023), EduGym, who name multi-objective reinforcement learning
    among what they leave out.
    """

    concavity: float
    weights: tuple[float, float]  # of the value and of time
    treasures: Reals  # shape (9,): the value of each treasure
    max_steps: int

    def initial(self, rng: Random) -> int:
        """At the surface, at the shore."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """One cell down or to the right, but not out of the picture."""
        y, x = state // N_COLUMNS, state % N_COLUMNS
        if action == DOWN:
            y += 1  # below there is always water or a treasure
        else:
            x = min(x + 1, N_COLUMNS - 1)
        return N_COLUMNS * y + x

    def rewards(self, state: int, action: int, next_state: int) -> tuple[float, float]:
        """The value of a treasure that is picked up, and -1 for the step."""
        value = float(self.treasures[next_state % N_COLUMNS]) if self.terminal(next_state) else 0.0
        return value, -1.0

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """The weighted sum of `rewards`."""
        value, time = self.rewards(state, action, next_state)
        return self.weights[0] * value + self.weights[1] * time

    def terminal(self, state: int) -> bool:
        """Whether the diver has come to a treasure."""
        return state // N_COLUMNS == state % N_COLUMNS + 1

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The cell, as one number."""
        return spaces.Discrete(N_ROWS * N_COLUMNS)

    @property
    def action_space(self) -> spaces.Discrete:
        """Down, right."""
        return spaces.Discrete(2)

    @property
    def reward_space(self) -> spaces.Box:
        """The Gymnasium space of the vector of rewards: value and time."""
        return spaces.Box(np.array([0.0, -1.0]), np.array([self.treasures[-1], -1.0]), dtype=np.float64)

    @classmethod
    def create(
        cls,
        concavity: float = 0.5,
        weights: tuple[float, float] = (1.0, 4.0),
        max_steps: int = 100,
    ) -> "Diver":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        c = float(between("concavity", concavity, 0, 1))
        first, second = an_array("weights", weights, (2,)).tolist()
        if not (0 <= first <= LARGEST_WEIGHT and 0 <= second <= LARGEST_WEIGHT and first + second > 0):
            raise ValueError(
                f"weights must be two numbers from 0 to {LARGEST_WEIGHT}, not both 0, but is {in_short(weights)}"
            )
        treasures = [10 + 10 * k + k * (8 - k) * (8 + k - 16 * c) / 16 for k in range(N_COLUMNS)]
        return cls(c, (first, second), np.array(treasures, np.float64), number_of_steps("max_steps", max_steps))

    @property
    def reward_threshold(self) -> float:
        """The best return: that of the best treasure within the step limit."""
        value, time = self.weights
        within = [k for k in range(N_COLUMNS) if 2 * k + 1 <= self.max_steps]
        return max(value * float(self.treasures[k]) - time * (2 * k + 1) for k in within)

    @property
    def action_names(self) -> tuple[str, ...]:
        """The directions."""
        return "down", "right"

    def info(self, state: int, last_state: int | None, last_action: int | None, steps: int) -> dict[str, Any]:
        """The vector of rewards of the last step, and the sum of those of the episode."""
        start = last_state is None or last_action is None
        reward = (0.0, 0.0) if start else self.rewards(last_state or 0, last_action or 0, state)
        return {"vector_reward": np.array(reward), "vector_return": np.array([reward[0], -float(steps)])}

    def scene(self, state: int, last_state: int | None = None, steps: int = 0) -> Scene:
        """The sea from the side, with the value of each treasure in the sand below it, and in a corner the front.

        The front has a point for each treasure, value over time: full if some weights prefer it, else hollow.
        """
        state = int(state)
        y, x = state // N_COLUMNS, state % N_COLUMNS
        found = self.terminal(state)
        shapes: list[Shape] = [
            Rectangle(0.0, 1.0 + row, N_COLUMNS, 1.0, fill=blend(WATER, BLUE, row / N_ROWS), outline=None)
            for row in range(N_ROWS)
        ]
        shapes.append(Line(((0.0, 1.0), (N_COLUMNS, 1.0)), colour=WHITE, line_width=0.08))
        shapes.append(Polygon(_floor(), fill=SAND))
        for k in range(N_COLUMNS):
            shapes += _chest(k + 0.5, k + 3.0, 0.4 + 0.04 * k, glyph="" if found and k == x else "▣")
            shapes.append(Text(k + 0.5, k + 3.4, f"{self.treasures[k]:.3g}", size=0.36))
        shapes += self._front(x if found else None)
        value = float(self.treasures[x]) if found else 0.0
        tells = f"{steps} step{'' if steps == 1 else 's'}, value {value:.3g}"
        shapes.append(Text(N_COLUMNS / 2, 0.5, tells, size=0.45))
        bumped = last_state is not None and int(last_state) == state
        centre = y + (1.2 if found else 1.5)  # above the treasure
        shapes += _diver(x + 0.5, centre, "flat" if bumped else "happy", under_water=y > 0)
        return Scene(N_COLUMNS, N_ROWS + 2.0, shapes, SKY, f"Diver: {tells}", columns=4 * N_COLUMNS)

    def _front(self, picked_up: int | None) -> list[Shape]:
        """The points (steps, value) of all treasures, and a line along those that some weights prefer."""
        left, width, bottom, height = 0.8, 2.9, 11.3, 3.4
        points = [(left + width * k / 8, bottom - height * float(self.treasures[k]) / 90) for k in range(N_COLUMNS)]
        preferred = [k == 0 or k >= 8 * self.concavity - 0.5 for k in range(N_COLUMNS)]
        axes = ((left - 0.3, bottom - height - 0.2), (left - 0.3, bottom + 0.1), (left + width + 0.3, bottom + 0.1))
        return [
            Line(axes),
            Text(left - 0.6, bottom - height - 0.45, "value", size=0.32, anchor="start"),
            Text(left + width, bottom + 0.4, "steps", size=0.32),
            Line(tuple(point for point, some in zip(points, preferred, strict=True) if some)),
            *(
                Circle(*point, 0.11, fill=RED if k == picked_up else INK if preferred[k] else WHITE, glyph="")
                for k, point in enumerate(points)
            ),
        ]


def _floor() -> tuple[tuple[float, float], ...]:
    """The sea floor: a step down in each column."""
    stairs = [(float(x), k + 3.0) for k in range(N_COLUMNS) for x in (k, k + 1)]
    return (*stairs, (float(N_COLUMNS), N_ROWS + 2.0), (0.0, N_ROWS + 2.0))


def _chest(x: float, y: float, size: float, glyph: str) -> list[Shape]:
    """A chest that stands on (x, y)."""
    return [
        Rectangle(x - size / 2, y - 0.7 * size, size, 0.7 * size, 0.04, fill=WALL, glyph=glyph),
        Rectangle(x - size / 2, y - 0.9 * size, size, 0.35 * size, 0.08, fill=ORANGE),
        Circle(x, y - 0.45 * size, 0.1 * size, fill=INK, outline=None),
    ]


def _diver(x: float, y: float, mood: Any, under_water: bool) -> list[Shape]:
    """The face with a snorkel, and bubbles under water."""
    snorkel = ((x + 0.2, y + 0.2), (x + 0.42, y + 0.1), (x + 0.42, y - 0.45))
    bubbles = [Circle(x + 0.3, y - 0.55, 0.06, fill=WHITE), Circle(x + 0.42, y - 0.72, 0.08, fill=WHITE)]
    return [
        Line(snorkel, colour=RED, line_width=0.09),
        *smiley(x, y, 0.34, mood),
        *(bubbles if under_water else []),
    ]

"""Roadrunner: credit assignment, on- and off-policy (lesson 2)."""

from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.checks.parameters import between, number_of_steps, whole_number
from edugym.mdp.protocol import Random
from edugym.rendering.icons import Mood, sign, smiley
from edugym.rendering.palette import GRASS, INK, ROAD, SAND, SKY, WALL, WHITE
from edugym.rendering.scene import Circle, Line, Polygon, Rectangle, Scene, Shape, Text

LONGEST = 1_000_000
MOST_CELLS = 50
"""The longest road on which the picture marks single cells."""


class Runner(NamedTuple):
    """Where the runner is, and how fast.

    Attributes:
        x: its cell, from 0. After a fall it is `size`, which is beyond the last cell.
        dx: its speed, in cells a step; -1 after a stall.
    """

    x: int
    dx: int


class Roadrunner(NamedTuple):
    """Run to the edge of a cliff, as fast as possible but not over it.

    ## Description
    Challenge: on- and off-policy credit assignment. A runner speeds along a road of W cells that ends at a cliff. It
    must arrive exactly at the last cell, the target T = W - 1, at any speed. (With a `stop_zone` it may also arrive a
    little before T.) Beyond T is the drop: a runner that falls loses. A runner whose speed goes below 0 stalls, and
    loses too. The best run ends one exploring step away from disaster. An off-policy method still learns this run; an
    on-policy method learns what its own exploring costs, and prefers to arrive more slowly and safely, or, with a stop
    zone, to stop short of the edge.

    ## Observation space
    `MultiDiscrete([size + 1, max_speed + 1])`: the position x and the speed dx.

    ## Action space
    `Discrete(3)`: 0, 1 and 2 change the speed by -1, 0 and +1.

    ## State
    The position x and the speed dx. A stalled runner has dx = -1, and is observed with dx = 0. The steps of the episode
    are counted outside the state, for the step limit, and are not observed. So near the step limit the observation is
    not Markov (which does not matter to an agent that bootstraps at truncation).

    ## Dynamics
    The speed changes first, up to `max_speed`; then x += dx. A runner that would come beyond T is set to W. A speed
    below 0 leaves x as it was.

    ## Reward
    Reaching T: +1. A fall or a stall: R = `negative_reward`. Coming to a cell in the stop zone: 1 - (T - x). Every
    other step: -1. The best return at the defaults (W = 10, no stop zone) is -2, in 4 steps. With only W changed, it is
    -3 at W = 15, -4 at W = 20 and -5 at W = 25 (discount 1).

    ## Initial state
    At x = 0 with a speed of 0.

    ## Episode end
    Terminated at T, by a fall, by a stall, or on coming to one of the `stop_zone` cells before T; else truncated after
    `max_steps` steps.

    ## Parameters
    - `size` (10): W, the number of cells, from 2 to 1 000 000.
    - `max_speed` (10): from 1 to 1 000 000.
    - `negative_reward` (-100.0): R, from -1 000 000 to 0.
    - `stop_zone` (0): the number of cells just before T that end the episode too, from 0 to W - 2 (never the start).
    - `max_steps` (5 * size): 1 or more.

    ## Info
    - `distance`: how many cells the runner is away from T; -1 beyond it.
    - `stalled`: whether the speed fell below 0.

    ## Choices
    - A step that reaches T gets +1 instead of -1; a fall or a stall gets R instead of -1. (The paper could also be
      read as adding +1 or R to the -1.)
    - The paper does not say that the speed changes before the position, and does not list the fall among the ends of an
      episode.
    - The paper gives the place of the drop in different ways: under Dynamics as beyond W, under Reward as W itself, and
      in its description of the task as anything beyond the target T = W - 1. Here it is as in the description. A runner
      that has fallen is given x = W.
    - The paper's space has W positions and `max_speed` speeds; here both have one more, since W and `max_speed`
      themselves can be reached.
    - The paper's main text speaks of "how close it ends up to the edge"; its appendix does not. The parameter
      `stop_zone` adds this. Without a stop zone only T ends a run well.
    - The paper has no step limit. Without one the episode of a runner that stands still would never end.

    ## Algorithms
    The paper compares Q-learning with SARSA, both with a table.

    ## References
    Moerland et al. (2023), EduGym, section 4 b and appendix A.2.
    """

    size: int
    max_speed: int
    negative_reward: float
    stop_zone: int
    max_steps: int

    def initial(self, rng: Random) -> Runner:
        """At cell 0, standing."""
        return Runner(0, 0)

    def transition(self, state: Runner, action: int, rng: Random) -> Runner:
        """First the speed changes by -1, 0 or +1, up to `max_speed`; then the position changes by the speed.

        A runner that comes beyond the last cell, `size` - 1, is at `size`: it falls. A speed below 0 is a stall, and
        leaves the position as it was.
        """
        dx = min(state.dx + action - 1, self.max_speed)
        if dx < 0:
            return Runner(state.x, dx)
        return Runner(min(state.x + dx, self.size), dx)

    def reward(self, state: Runner, action: int, next_state: Runner, rng: Random) -> float:
        """`negative_reward` for a fall or a stall; 1 at the target, less 1 for each cell before it; else -1."""
        if self.has_failed(next_state):
            return self.negative_reward
        distance = self.size - 1 - next_state.x
        return 1.0 - distance if distance <= self.stop_zone else -1.0

    def terminal(self, state: Runner) -> bool:
        """At the target (or in the stop zone just before it), after a fall, and after a stall."""
        return state.dx < 0 or state.x >= self.size - 1 - self.stop_zone

    def has_failed(self, state: Runner) -> bool:
        """Whether the runner fell off the cliff or stalled."""
        return state.dx < 0 or state.x == self.size

    def observation(self, state: Runner, rng: Random) -> tuple[int, ...]:
        """The position and the speed; a stalled runner is seen standing."""
        return state.x, max(state.dx, 0)

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """The position, 0 to W, and the speed, 0 to `max_speed`."""
        return spaces.MultiDiscrete([self.size + 1, self.max_speed + 1])

    @property
    def action_space(self) -> spaces.Discrete:
        """Slower, same speed, faster."""
        return spaces.Discrete(3)

    @classmethod
    def create(
        cls,
        size: int = 10,
        max_speed: int = 10,
        negative_reward: float = -100.0,
        stop_zone: int = 0,
        max_steps: int | None = None,
    ) -> "Roadrunner":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        size = whole_number("size", size, 2, LONGEST)
        max_speed = whole_number("max_speed", max_speed, 1, LONGEST)
        between("negative_reward", negative_reward, -1_000_000, 0)
        stop_zone = whole_number("stop_zone", stop_zone, 0, size - 2)
        max_steps = number_of_steps("max_steps", 5 * size if max_steps is None else max_steps)
        return cls(size, max_speed, float(negative_reward), stop_zone, max_steps)

    @property
    def reward_threshold(self) -> float | None:
        """The best return: the return of the fastest run to T, or R itself if R is higher.

        (A runner that stalls in the first step gets R.) The value is None if there is a stop zone, or if the step limit
        is too low for the fastest run.
        """
        steps, reach, speed = 0, 0, 0
        while reach < self.size - 1:
            speed = min(speed + 1, self.max_speed)
            steps, reach = steps + 1, reach + speed
        return max(2.0 - steps, self.negative_reward) if self.stop_zone == 0 and steps <= self.max_steps else None

    @property
    def action_names(self) -> tuple[str, ...]:
        """The changes of speed."""
        return "slower", "same speed", "faster"

    def info(self, state: Runner) -> dict[str, Any]:
        """The distance to the target, and whether the runner stalled."""
        return {"distance": int(self.size - 1 - state.x), "stalled": bool(state.dx < 0)}

    def scene(self, state: Runner) -> Scene:
        """A side view of road and cliff, with a danger sign at the end of the road and the speed on the runner."""
        task = self
        x, dx = state
        # The scale of everything except the width of the cells. It grows on a long road: the runner stays visible.
        scale = max(1.0, task.size / 20)
        edge, ground, bottom = task.size + 0.5, 3.6 * scale, 5.6 * scale
        width = max(edge + 2.5 * scale, 10.0)
        notch = (edge - 0.3 * scale, ground + 1.1 * scale)
        shapes: list[Shape] = [
            Polygon(((0.0, ground), (edge, ground), notch, (edge, bottom), (0.0, bottom)), fill=WALL),
            Rectangle(0.0, ground, edge, 0.75 * scale, fill=GRASS, glyph="░"),
            Rectangle(0.5, ground, task.size, 0.4 * scale, fill=ROAD, glyph="="),
        ]
        zone = task.stop_zone + 1
        parts = zone if task.size <= MOST_CELLS else 1
        shapes += [
            Rectangle(
                task.size - zone + 0.5 + k * zone / parts, ground, zone / parts, 0.4 * scale, fill=SAND, glyph="_"
            )
            for k in range(parts)
        ]
        if task.size <= MOST_CELLS:
            marks = [((cell + 0.5, ground), (cell + 0.5, ground + 0.4 * scale)) for cell in range(1, task.size)]
            shapes += [Line(mark, colour=WHITE) for mark in marks]
        shapes += sign(edge - 0.15, ground, 2.3 * scale)
        place = (x + 1.0, ground - 0.45 * scale)
        mood: Mood = "happy"
        text = f"position {x} of {task.size - 1}, speed {max(dx, 0)}"
        if x == task.size:
            place, mood, text = (edge + 1.2 * scale, ground + 1.2 * scale), "sad", "over the edge!"
        elif dx < 0:
            mood, text = "sad", f"stalled at position {x} of {task.size - 1}"
        elif task.terminal(Runner(x, dx)):
            text = f"there, at position {x} of {task.size - 1}"
        shapes += _runner(*place, 0.45 * scale, dx, mood)
        shapes.append(Text(width / 2, 0.7 * scale, text, size=0.6 * scale))
        return Scene(width, bottom, shapes, SKY, f"Roadrunner: {text}", columns=round(4 * width / scale))


def _runner(x: float, y: float, radius: float, dx: int, mood: Mood) -> list[Shape]:
    """The smiley, with its speed on a plate. Behind it there is a line for each unit of speed, at most three."""
    wind = [
        Line(((x - (1.3 + length) * radius, y + dy * radius), (x - 1.3 * radius, y + dy * radius)), colour=WHITE)
        for dy, length in ((0.0, 1.2), (-0.5, 0.8), (0.5, 0.8))[: max(dx, 0)]
    ]
    plate = (x + 0.85 * radius, y + 0.65 * radius)
    return [
        *wind,
        *smiley(x, y, radius, mood),
        Circle(*plate, 0.55 * radius, fill=WHITE),
        Text(*plate, str(dx), size=0.8 * radius, colour=INK),
    ]

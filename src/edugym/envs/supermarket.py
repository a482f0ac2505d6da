"""Supermarket: model-based reinforcement learning (lesson 9)."""

import time
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.parameters import between, number_of_steps, whole_number
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Integers, Random
from edugym.rendering.icons import door, sign, smiley
from edugym.rendering.palette import BLUE, BRICK, GREEN, PAPER, RED, SHADE, WHITE, blend
from edugym.rendering.scene import Circle, Line, Polygon, Rectangle, Scene, Shape, Text

MAP = """\
#s########
#.......1#
#........#
######...#
#........#
#..#.3#..#
#..#..#..#
#.2#..#..#
#........#
########e#"""
"""The supermarket from above: s start, e exit, # wall, 1 to 3 the items, red, blue and green."""
UP, DOWN, LEFT, RIGHT = 0, 1, 2, 3
FLOOR, WALL = 0, -1


class Supermarket(NamedTuple):
    """Collect the three items of a shopping list and leave by the exit.

    ## Description
    Challenge: model-based reinforcement learning. A shopper walks through a supermarket, collects three items, each for
    a reward, and leaves by the exit. A real step can take time (`step_timeout`). Meanwhile the agent can plan with a
    model: one that it learned, or the one that is given here, whose rewards can be wrong (`noise`).
    `env.unwrapped.descriptive_model(state, action)` returns every outcome with its probability,
    `generative_model(state, action)` samples one outcome, and `model(state, action, kind)` is the paper's short form of
    both. (Here every action has one outcome.) These calls never wait, and do not change the episode. The model has the
    428 states that can be reached, `finite_model.states`.

    ## Observation space
    `Discrete(800)`: one number that encodes (y, x, item 1, item 2, item 3), as
    `np.ravel_multi_index((y, x, item_1, item_2, item_3), (10, 10, 2, 2, 2))` does. y counts rows from the top, and an
    item is 1 when it has been collected.

    ## Action space
    `Discrete(4)`: 0 up, 1 down, 2 left, 3 right.

    ## State
    The observed number. The steps of the episode are not part of it, so near the step limit the observation is not
    Markov. (That does no harm to an agent that bootstraps at truncation.)

    ## Dynamics
    One cell in the direction of the action; a wall leaves the shopper in place. One cannot leave through the entrance.
    Stepping on an item collects it. Items 1, 2 and 3 are red, blue and green, at (y, x) = (1, 8), (7, 2) and (5, 5).

    ## Reward
    -1 a step, +25 the first time on an item, +50 at the exit, all added up. The best return is 95, in 30 steps
    (discount 1).

    ## Initial state
    At the entrance, (y, x) = (0, 1), with nothing collected.

    ## Episode end
    Terminated at the exit, (y, x) = (9, 8), whatever has been collected; else truncated after `max_steps` steps.

    ## Parameters
    - `step_timeout` (0.0): the minimum time in seconds between the end of one `reset` or `step` and the next step, from
      0 to 3600. `step` waits if necessary; `env.unwrapped.time_until_step()` says how long.
    - `noise` (0.0): the standard deviation of a zero-mean Gaussian error on the rewards of the model, from 0 to one
      million.
    - `max_steps` (500): from 1 to 2^62.
    - `layout_seed` (0): the seed of the model's reward errors, 0 or more. The map is always the same.

    ## Info
    - `position`: the shopper's cell, (y, x).
    - `collected`: whether items 1, 2 and 3 have been collected.

    ## Choices
    - With `noise` every state and action has one fixed error, so planning longer cannot average it out. The errors are
      in the environment's `finite_model`, `descriptive_model`, `generative_model` and `model`, never in `step`. The
      function `edugym.finite_model(mdp)` stays exact.
    - `step` waits before it acts, so that an agent can plan between two calls; the paper says both "between calls" and
      "after each call". The time from `reset` on counts as well.
    - The clock belongs to this Gymnasium environment, not to its MDP: the copies of `gymnasium.make_vec` do not wait.
    - The paper has no step limit; without one an episode need not end.
    - The paper's figure shows no coordinates; the map here is read off it.

    ## Algorithms
    The paper compares dynamic programming, Dyna and prioritised sweeping.

    ## References
    Moerland et al. (2023), EduGym, section 4 i and appendix A.9.
    """

    # A state is the index of (y, x, item 1, item 2, item 3) in a table of (10, 10, 2, 2, 2), the last one fastest: y is
    # state // 80, x is state // 8 % 10, and state % 8 has the items, as the sum of 4, 2 and 1 for items 1, 2 and 3.
    cells: Integers  # shape (10, 10): what is in each cell: the 4, 2 or 1 of its item, 0 for none, -1 for a wall
    start: int  # the cell of the entrance, 10 y + x
    exit: int  # the cell of the exit
    max_steps: int
    noise: float
    layout_seed: int

    def initial(self, rng: Random) -> int:
        """At the entrance, with nothing."""
        return self.start * 8

    def transition(self, state: int, action: int, rng: Random) -> int:
        """One cell up, down, left or right, unless there is a wall; stepping on an item collects it."""
        y, x, items = state // 80, state // 8 % 10, state % 8
        if action == UP:
            y -= 1
        elif action == DOWN:
            y += 1
        elif action == LEFT:
            x -= 1
        else:
            x += 1
        if y < 0 or self.cells[y, x] == WALL:  # above the entrance is outside the map; the exit is terminal
            return state
        return 80 * y + 8 * x + (items | int(self.cells[y, x]))

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """-1 for the step, 25 for an item that is collected, and 50 at the exit."""
        reward = -1.0
        if next_state % 8 != state % 8:
            reward += 25.0
        if self.terminal(next_state):
            reward += 50.0
        return reward

    def terminal(self, state: int) -> bool:
        """The exit is the end."""
        return state // 8 == self.exit

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The place, and what has been collected, as one number."""
        return spaces.Discrete(800)

    @property
    def action_space(self) -> spaces.Discrete:
        """Up, down, left, right."""
        return spaces.Discrete(4)

    @classmethod
    def create(
        cls,
        noise: float = 0.0,
        max_steps: int = 500,
        layout_seed: int = 0,
    ) -> "Supermarket":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        between("noise", noise, 0, 1_000_000)
        max_steps = number_of_steps("max_steps", max_steps)
        layout_seed = whole_number("layout_seed", layout_seed, 0)
        meaning = {"#": WALL, "1": 4, "2": 2, "3": 1}
        cells = np.array([[meaning.get(cell, FLOOR) for cell in row] for row in MAP.split()], np.int64)
        places = MAP.replace("\n", "")
        return cls(cells, places.index("s"), places.index("e"), max_steps, float(noise), layout_seed)

    def distorted(self, model: FiniteModel) -> FiniteModel:
        """The exact model with the `noise` of this task in its rewards."""
        errors = np.random.default_rng(self.layout_seed).normal(0.0, self.noise, (800, 4))[list(model.states)]
        errors[model.terminal] = 0.0  # nothing can be done there
        return model._replace(rewards=model.rewards + errors[:, :, np.newaxis])

    @property
    def reward_threshold(self) -> float | None:
        """The best return; None if the step limit is too low for it."""
        return 95.0 if self.max_steps >= 30 else None

    @property
    def action_names(self) -> tuple[str, ...]:
        """The directions."""
        return "up", "down", "left", "right"

    def info(self, state: int) -> dict[str, Any]:
        """Where the shopper is, and what has been collected."""
        y, x, *items = np.unravel_index(state, (10, 10, 2, 2, 2))
        return {"position": np.array([y, x]), "collected": np.array(items, np.bool_)}

    def scene(self, state: int, last_state: int | None = None) -> Scene:
        """The supermarket from above: brick walls, three different items, the exit with its sign, the shopping list."""
        state = int(state)
        y, x, items = state // 80, state // 8 % 10, state % 8
        walls = [(float(column), float(row)) for row, column in np.argwhere(self.cells == WALL)]
        shapes: list[Shape] = [
            Rectangle(0.0, 0.0, 10.0, 10.0, fill=PAPER, outline=None),
            *(Line(((0.0, k), (10.0, k)), colour=SHADE) for k in range(1, 10)),
            *(Line(((k, 0.0), (k, 10.0)), colour=SHADE) for k in range(1, 10)),
            *(Rectangle(*wall, 1.0, 1.0, outline_width=0.15) for wall in walls),  # bricks leave only their outlines
            Text(10.7, 0.75, "to get", size=0.55, anchor="start"),
        ]
        for wall in walls:
            shapes += _bricks(*wall)
        for k, item in enumerate((4, 2, 1)):
            shapes += _item(11.3, 2.0 + 1.5 * k, item)
            if items & item:
                shapes += _tick(12.3, 2.0 + 1.5 * k)
            else:
                place = np.argwhere(self.cells == item)[0]
                shapes += _item(place[1] + 0.5, place[0] + 0.5, item)
        row, column = divmod(self.exit, 10)
        shapes += [*door(column + 0.1, row, 0.8, 1.0), *sign(column - 0.9, row + 1.4, 1.3, "exit", danger=False)]
        disappointed = last_state == state or (self.terminal(state) and items < 7)
        shapes += smiley(x + 0.5, y + 0.5, 0.38, "flat" if disappointed else "happy")
        title = f"Supermarket: at row {y}, column {x}, with {items.bit_count()} of 3 items"
        return Scene(13.5, 10.0, shapes, SHADE, title, columns=27)


class Countdown:
    """Waits until `seconds` after `start`, accurate to well under a millisecond.

    It sleeps, except in the last 0.3 ms, when it polls the clock.

    Args:
        seconds: how long, a finite number of 0 or more.
        clock: a function that returns the time in seconds.
        sleep: a function that sleeps for a number of seconds; it may oversleep, as operating systems do.
    """

    def __init__(
        self,
        seconds: float,
        clock: Callable[[], float] = time.perf_counter,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        """See the class; it is not running yet."""
        self.seconds, self._clock, self._sleep = seconds, clock, sleep
        self._end: float | None = None

    def start(self) -> None:
        """Begin anew."""
        self._end = self._clock() + self.seconds

    def left(self) -> float:
        """How many seconds are left; 0 when it is over or was never started."""
        if self._end is None:
            return 0.0
        # At most `seconds`: after unpickling on another machine the clock may have another zero.
        return min(max(self._end - self._clock(), 0.0), self.seconds)

    def wait(self) -> None:
        """Return when it is over."""
        while (left := self.left()) > 0.0:
            if left > 0.0003:
                self._sleep(0.8 * left)  # so oversleeping does no harm; the loop handles the rest


class SupermarketEnv(MDPEnv[Supermarket]):
    """Supermarket in real time: `step` blocks until `step_timeout` seconds after the previous call returned.

    The other parameters are those of `Supermarket.create`, and `render_mode` is that of `MDPEnv`.
    """

    def __init__(
        self,
        step_timeout: float = 0.0,
        noise: float = 0.0,
        max_steps: int = 500,
        layout_seed: int = 0,
        render_mode: str | None = None,
    ) -> None:
        """See `Supermarket` for the parameters, and `MDPEnv` for `render_mode`.

        Raises:
            ValueError: a parameter is not as it says there.
        """
        between("step_timeout", step_timeout, 0, 3600)
        super().__init__(Supermarket.create(noise, max_steps, layout_seed), render_mode)
        self.countdown = Countdown(float(step_timeout))

    @property
    def only_plays_its_mdp(self) -> bool:
        """True if `step_timeout` is 0: then the MDP alone gives the same episodes, and training can be compiled."""
        return self.countdown.seconds == 0.0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Start an episode, as `MDPEnv.reset` does."""
        result = super().reset(seed=seed, options=options)
        self.countdown.start()
        return result

    def step(self, action: Any) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        """Take one step, as `MDPEnv.step` does, no earlier than `step_timeout` seconds after the last call returned."""
        if not self._over:
            action = self._checked(action)  # an invalid action is refused at once
            self.countdown.wait()
        result = super().step(action)
        self.countdown.start()
        return result

    def time_until_step(self) -> float:
        """How many seconds `step` would block now: time to plan."""
        return self.countdown.left()

    def can_call_step(self) -> bool:
        """Whether `step` would not block now (the name in the original EduGym)."""
        return self.time_until_step() == 0.0


def _bricks(x: float, y: float) -> list[Shape]:
    """A cell of wall."""
    joints = (
        ((x, y + 0.25), (x + 1.0, y + 0.25)),
        ((x, y + 0.75), (x + 1.0, y + 0.75)),
        ((x + 0.25, y), (x + 0.25, y + 0.25)),
        ((x + 0.75, y + 0.25), (x + 0.75, y + 0.75)),
        ((x + 0.25, y + 0.75), (x + 0.25, y + 1.0)),
    )
    return [
        Rectangle(x, y, 1.0, 1.0, fill=BRICK, outline=None, glyph="#"),
        *(Line(joint, colour=blend(BRICK, PAPER, 0.5)) for joint in joints),
    ]


def _item(x: float, y: float, item: int) -> list[Shape]:
    """What there is to buy: a red apple, a blue bottle and a green carton, around (x, y)."""
    if item == 4:
        stalk = Line(((x, y - 0.15), (x + 0.08, y - 0.36)))
        return [stalk, Circle(x, y + 0.06, 0.28, fill=RED, glyph="1")]
    if item == 2:
        neck = Rectangle(x - 0.08, y - 0.38, 0.16, 0.3, fill=BLUE)
        return [neck, Rectangle(x - 0.2, y - 0.12, 0.4, 0.5, 0.08, fill=BLUE, glyph="2")]
    roof = Polygon(((x - 0.24, y - 0.1), (x, y - 0.38), (x + 0.24, y - 0.1)), fill=GREEN)
    return [roof, Rectangle(x - 0.24, y - 0.1, 0.48, 0.48, fill=GREEN, glyph="3")]


def _tick(x: float, y: float) -> list[Shape]:
    """The mark of what has been collected."""
    mark = ((x - 0.15, y), (x - 0.03, y + 0.14), (x + 0.17, y - 0.14))
    return [Circle(x, y, 0.34, fill=WHITE, glyph="✓"), Line(mark)]

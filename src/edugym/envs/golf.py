"""Golf: stochastic dynamics (lesson 8)."""

import math
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import above, between, in_short, whole_number
from edugym.mdp.protocol import Random
from edugym.rendering.icons import Mood, flag, smiley
from edugym.rendering.palette import GRASS, GREEN, SAND, WATER, WHITE, blend
from edugym.rendering.scene import Circle, Line, Rectangle, Scene, Shape, Text

SWINGS = ("putt", "chip", "drive")
DISTANCES = (1.0, 4.0, 10.0)
"""How far each swing aims, in cells."""
LONGEST, MOST_HITS, WORST = 1_001, 1_000_000, 1_000
"""The highest `length`, `max_hits` and `stochasticity_level`."""
MOST_COLUMNS = 120
"""The maximum width of the picture in a terminal, in characters."""


class Ball(NamedTuple):
    """The position of the ball, in cells from the near left corner of the course, and the number of hits."""

    x: float
    y: float
    hits: int


class Golf(NamedTuple):
    """Get the ball on the green in few hits; the harder the hit, the farther the ball may miss its aim.

    ## Description
    Challenge: stochastic dynamics. From the tee in the middle of the near end the ball must get onto the green around
    the flag. Every hit aims at the flag; the player chooses how hard. The ball misses its aim by Gaussian noise that
    grows with the square of the swing's distance, so a drive is fast and risky, and putts are slow and safe. Water
    surrounds the course.

    ## Observation space
    `MultiDiscrete([width, length])`: the cell of the ball. If the ball is off the course, it is the nearest cell. With
    `observe_hits`: `MultiDiscrete([width, length, max_hits + 1])`, the cell and the number of hits.

    ## Action space
    `Discrete(3)`. 0: putt (1 cell), 1: chip (4 cells), 2: drive (10 cells).

    ## State
    The coordinates of the ball and the number of hits. The observation is not Markov: it rounds the coordinates down to
    a cell, and hides the hits, on which the reward and the end of the game depend, unless `observe_hits` is set.

    ## Dynamics
    ball += d u + N(0, s² I), with d the swing's distance, u the unit vector from the ball to the flag, and s =
    `stochasticity_level` d². The tee is at (width/2, 0), the flag at (width/2, length - width/2). At the defaults s is
    0.015, 0.24 and 1.5 cells for putt, chip and drive.

    ## Reward
    On the green (closer to the flag than `green_radius`): 1 - (hits - 1)/max_hits. Off the course, or not on the green
    after `max_hits` hits: -1. Else 0. At the defaults the best expected return is about 0.87 (discount 1): a drive,
    then a chip or a putt.

    ## Initial state
    The ball on the tee.

    ## Episode end
    Terminated on the green, off the course, or after `max_hits` hits. The limit on hits is part of the task; no episode
    is truncated.

    ## Parameters
    - `width` (7): an odd number of cells, from 3 to 1001.
    - `length` (17): in cells, from `width` to 1001.
    - `green_radius` (2.1): greater than 0, and less than the distance from the tee to the flag.
    - `max_hits` (10): from 1 to 1 000 000.
    - `stochasticity_level` (0.015): the size of the noise, from 0 (a perfect player) to 1000.
    - `observe_hits` (False): whether the agent sees the number of hits.

    ## Info
    - `ball`: the coordinates (x, y) of the ball, in cells.
    - `hits`: how often it was hit.

    ## Choices
    - The noise is the same in all directions, as in the main text of the paper. In the appendix it acts only across
      the shot. The paper squares the action; here we square the swing's distance.
    - The paper gives no sizes. Those of the course and of the green, the place of the flag, the distance of each swing
      and the number of hits are our choices. So is the formula of the reward: the paper only says that the reward is
      proportional to the hits. In its main text the hole ends the game; here the green does, as in the appendix.
    - A ball that is off the course is lost, also where the green would reach beyond the edge.
    - Without noise, `create` refuses parameters with which no straight hits end on the green.

    ## Algorithms
    The paper compares Q-learning with risk-sensitive Q-learning, both with a table.

    ## References
    Moerland et al. (2023), EduGym, section 4 h and appendix A.8.
    """

    width: int
    length: int
    green_radius: float
    max_hits: int
    stochasticity_level: float

    def initial(self, rng: Random) -> Ball:
        """The tee, in the middle of the near end."""
        return Ball(self.width / 2, 0.0, 0)

    def transition(self, state: Ball, action: int, rng: Random) -> Ball:
        """The ball flies d cells towards the flag, and Gaussian noise is added to both coordinates."""
        d = DISTANCES[action]
        deviation = self.stochasticity_level * d * d
        x, y = self.aim(state, d)
        return Ball(x + rng.normal(0.0, deviation), y + rng.normal(0.0, deviation), state.hits + 1)

    def aim(self, state: Ball, d: float) -> tuple[float, float]:
        """The point d cells from the ball in the direction of the flag."""
        to_flag_x = self.width / 2 - state.x
        to_flag_y = self.length - self.width / 2 - state.y
        distance = math.sqrt(to_flag_x * to_flag_x + to_flag_y * to_flag_y)
        return state.x + d * to_flag_x / distance, state.y + d * to_flag_y / distance

    def reward(self, state: Ball, action: int, next_state: Ball, rng: Random) -> float:
        """1 - (hits - 1) / max_hits on the green; -1 off the course or out of hits; else 0."""
        if self.off_course(next_state):
            return -1.0
        if self.on_green(next_state):
            return 1.0 - (next_state.hits - 1) / self.max_hits
        return -1.0 if next_state.hits == self.max_hits else 0.0

    def terminal(self, state: Ball) -> bool:
        """On the green, off the course, or out of hits."""
        return self.off_course(state) or self.on_green(state) or state.hits == self.max_hits

    def on_green(self, state: Ball) -> bool:
        """Whether the ball is closer to the flag than `green_radius`."""
        x = state.x - self.width / 2
        y = state.y - (self.length - self.width / 2)
        return math.sqrt(x * x + y * y) < self.green_radius

    def off_course(self, state: Ball) -> bool:
        """Whether the ball has left the course."""
        return state.x < 0.0 or state.x >= self.width or state.y < 0.0 or state.y >= self.length

    def observation(self, state: Ball, rng: Random) -> tuple[int, ...]:
        """The cell of the ball, or the nearest cell if the ball is off the course."""
        x = math.floor(min(max(state.x, 0.0), self.width - 1.0))
        y = math.floor(min(max(state.y, 0.0), self.length - 1.0))
        return x, y

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """The cells of the course."""
        return spaces.MultiDiscrete([self.width, self.length])

    @property
    def action_space(self) -> spaces.Discrete:
        """Putt, chip or drive."""
        return spaces.Discrete(3)

    @classmethod
    def create(
        cls,
        width: int = 7,
        length: int = 17,
        green_radius: float = 2.1,
        max_hits: int = 10,
        stochasticity_level: float = 0.015,
        observe_hits: bool = False,
    ) -> "Golf":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        width = whole_number("width", width, 3, LONGEST)
        if width % 2 == 0:
            raise ValueError(f"width must be odd, so that the flag stands in the middle of a cell, but is {width!r}")
        length = whole_number("length", length, width, LONGEST)
        above("green_radius", green_radius, 0)
        green_radius = float(green_radius)
        if green_radius >= length - width / 2:
            raise ValueError(
                f"green_radius must be less than {length - width / 2}, so that the tee is not on the green, "
                f"but is {green_radius!r}"
            )
        max_hits = whole_number("max_hits", max_hits, 1, MOST_HITS)
        between("stochasticity_level", stochasticity_level, 0, WORST)
        if not isinstance(observe_hits, bool):
            raise ValueError(f"observe_hits must be True or False, but is {in_short(observe_hits)}")
        kind = GolfWithHits if observe_hits else cls
        golf = kind(width, length, green_radius, max_hits, float(stochasticity_level))
        if stochasticity_level == 0 and not _reachable(golf):
            raise ValueError(
                f"green_radius must be larger (or max_hits, if the flag is far away), but is {green_radius!r}: without "
                f"noise, no straight hits end on such a green while max_hits is {max_hits!r}"
            )
        return golf

    @property
    def reward_threshold(self) -> float | None:
        """At the defaults a little less than the best expected return, with or without `observe_hits`; else None."""
        return 0.85 if tuple(self) == tuple(Golf.create()) else None

    @property
    def action_names(self) -> tuple[str, ...]:
        """The swings."""
        return SWINGS

    def info(self, state: Ball) -> dict[str, Any]:
        """Where the ball lies exactly, and how often it was hit."""
        return {"ball": np.array([state.x, state.y]), "hits": int(state.hits)}

    def scene(self, state: Ball, last_state: Ball | None = None, last_action: int | None = None) -> Scene:
        """The course in water, from above, with the last aim and a circle of two standard deviations around it."""
        golf, margin = self, 1.5
        flag_x, flag_y = golf.width / 2, golf.length - golf.width / 2
        height = golf.length + 2 * margin

        def at(x: float, y: float) -> tuple[float, float]:
            return x + margin, height - margin - y  # the far end is at the top of the picture

        left, top = at(0.0, float(golf.length))
        shapes: list[Shape] = [
            Rectangle(left, top, golf.width, golf.length, 0.6, fill=GRASS, glyph="."),
            Circle(*at(flag_x, flag_y), golf.green_radius, fill=blend(GRASS, GREEN, 0.7), outline=None),
            Rectangle(left + flag_x - 0.6, at(0.0, 0.35)[1], 1.2, 0.3, 0.1, fill=SAND),
            *flag(*at(flag_x, flag_y), 1.6),
        ]
        ball = state
        text = "on the tee"
        if last_state is not None and last_action is not None:
            name, d = SWINGS[last_action], DISTANCES[last_action]
            aim = at(*golf.aim(last_state, d))
            spread = 2 * golf.stochasticity_level * d * d
            shapes.append(Line((at(last_state.x, last_state.y), aim), colour=WHITE))
            if spread < golf.width + height:  # a larger circle lies outside the picture
                shapes.append(Circle(*aim, spread, fill=None, outline=WHITE))
            text = f"hit {ball.hits}: {name}"
        mood: Mood = "happy" if golf.on_green(ball) else "sad" if golf.off_course(ball) else "flat"
        far = golf.width + golf.length  # draw a lost ball no farther away than this: it is outside the picture anyway
        x, y = at(min(max(ball.x, -far), far), min(max(ball.y, -far), far))
        shapes.append(Circle(x, y, 0.22, fill=WHITE, glyph="o"))
        shapes += smiley(min(max(x - 0.9, 0.6), golf.width + 2 * margin - 0.6), min(y, height - 0.6), 0.5, mood)
        shapes.append(Text((golf.width + 2 * margin) / 2, 0.7, text, size=0.7))
        return Scene(
            golf.width + 2 * margin,
            height,
            shapes,
            WATER,
            f"Golf: {text}",
            columns=min(2 * (golf.width + 3), MOST_COLUMNS),
        )


class GolfWithHits(Golf):
    """Golf in which the agent also sees how often it has hit the ball."""

    __slots__ = ()

    def observation(self, state: Ball, rng: Random) -> tuple[int, ...]:
        """The cell of the ball and the number of hits so far."""
        x = math.floor(min(max(state.x, 0.0), self.width - 1.0))
        y = math.floor(min(max(state.y, 0.0), self.length - 1.0))
        return x, y, state.hits

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """The cells of the course, and 0 to `max_hits` hits."""
        return spaces.MultiDiscrete([self.width, self.length, self.max_hits + 1])


def _reachable(golf: Golf) -> bool:
    """Whether some sequence of at most `max_hits` straight hits ends on the green."""
    balls = {(golf.width / 2, 0.0)}
    seen: set[tuple[float, float]] = set()
    for _ in range(golf.max_hits):
        balls = {golf.aim(Ball(x, y, 0), d) for x, y in balls for d in DISTANCES}
        balls = {ball for ball in balls if not golf.off_course(Ball(*ball, 0))} - seen
        seen |= balls
        if any(golf.on_green(Ball(*ball, 0)) for ball in balls):
            return True
        if not balls:
            break
    return False

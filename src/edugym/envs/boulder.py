"""Boulder: exploration (lesson 1)."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import number_of_steps, whole_number
from edugym.mdp.protocol import Integers, Random
from edugym.rendering.icons import flag, smiley
from edugym.rendering.palette import CRACK, GRASS, SKY, STONE, WALL
from edugym.rendering.scene import Circle, Line, Rectangle, Scene, Shape, Text

MOST_LEVELS, MOST_SHOWN = 12, 40
"""The picture shows at most so many levels of a wall (by default), and at most so many grips at each level."""
HIGHEST, MOST_GRIPS = 1_000_000, 1_000


class Boulder(NamedTuple):
    """Climb a wall. At each height exactly one grip holds.

    ## Description
    Challenge: exploration under sparse reward. A climber stands before a wall. At every height there are `n_grips`
    grips. One of them, the right grip, holds. The others are cracked and send the climber back to the ground. Only the
    top is rewarded, so until it has been reached once there is no reward to learn from. Without a step limit, a climber
    who chooses grips at random needs (N^(H+1) - N)/(N - 1) steps on average to reach the top of a wall of height H with
    N grips at each height. With two grips that is 2046 steps for height 10, and 2.5e30 steps for height 100.

    ## Observation space
    `Discrete(height + 1)`: the position on the wall, from 0 (ground) to `height` (top).

    ## Action space
    `Discrete(n_grips)`: the grip to jump to.

    ## State
    The position. Strictly, the number of steps so far in this episode is part of the state too, because of the step
    limit. The Gymnasium environment counts these steps, but the agent does not observe the count. Near the limit the
    position alone is therefore not Markov. (A step limit *truncates* an episode: the episode stops in a state that is
    not terminal. Q-learning bootstraps from this state as from any other. In this way it learns the values of a task
    that has no step limit.)

    ## Dynamics
    The right grip moves the climber up by one. Any other sends it to the ground, without ending the episode.

    ## Reward
    1 for reaching the top, else 0. The best undiscounted return is 1, after `height` steps. If `max_steps` is smaller
    than `height`, nobody gets to the top, and the best return is 0.

    ## Initial state
    The ground.

    ## Episode end
    Terminated at the top; else truncated after `max_steps` steps.

    ## Parameters
    - `height` (10): H, the height of the wall, from 1 to one million. To reach the top, the climber must choose the
      right grip H times in a row.
    - `n_grips` (2): N, how many grips there are at every height; from 2 to 1000.
    - `max_steps` (10 * height): the number of steps after which an episode is truncated; 1 or more.
    - `layout_seed` (0): the seed from which the right grips are drawn, uniformly; 0 or more.

    ## Info
    - `right_grip`: the right action in this state, which moves the climber up by one; -1 at the top.

    ## Choices
    - The paper says that a random climber needs N^H steps. But N^H is the number of attempts (climbs from the ground)
      on average; the number of steps is (N^(H+1) - N)/(N - 1).
    - The paper's state space is `Discrete(H)`; here the top is a position too, because the agent
      observes it when the episode ends.
    - The paper gives no step limit. Here an episode is truncated after 10 H steps, unless `max_steps` says otherwise.

    ## Algorithms
    The paper compares three agents: ε-greedy Q-learning; Q-learning that gets a bonus for rarely visited states (a
    count-based intrinsic reward); and Go-Explore, which first returns to a state that it has reached before, and
    explores from there.

    ## References
    Moerland et al. (2023), EduGym, section 4(a) and appendix A.1. Boulder is based on the chain problem of
    Strens (2000).
    """

    height: int
    n_grips: int
    grips: Integers  # shape (height,): grips[s] is the right grip at position s
    max_steps: int

    def initial(self, rng: Random) -> int:
        """The ground: position 0."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """The right grip moves the climber up by one; any other sends it to the ground, without ending the episode."""
        return state + 1 if action == self.grips[state] else 0

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """1 for reaching the top, else 0."""
        return 1.0 if next_state == self.height else 0.0

    def terminal(self, state: int) -> bool:
        """Whether the climber is at the top."""
        return state == self.height

    def observation(self, state: int, rng: Random) -> int:
        """The position on the wall."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The position, from 0 (ground) to `height` (top)."""
        return spaces.Discrete(self.height + 1)

    @property
    def action_space(self) -> spaces.Discrete:
        """The grip to jump to."""
        return spaces.Discrete(self.n_grips)

    @classmethod
    def create(
        cls,
        height: int = 10,
        n_grips: int = 2,
        max_steps: int | None = None,
        layout_seed: int = 0,
    ) -> "Boulder":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        height, n_grips = whole_number("height", height, 1, HIGHEST), whole_number("n_grips", n_grips, 2, MOST_GRIPS)
        max_steps = number_of_steps("max_steps", 10 * height if max_steps is None else max_steps)
        whole_number("layout_seed", layout_seed, 0)
        grips = np.random.default_rng(layout_seed).integers(0, n_grips, height)
        return cls(height, n_grips, grips, max_steps)

    @property
    def reward_threshold(self) -> float | None:
        """The mean return at which the task counts as solved: 1, which means that every episode reaches the top.

        None if the step limit is too low to reach the top.
        """
        return 1.0 if self.max_steps >= self.height else None

    @property
    def action_names(self) -> tuple[str, ...]:
        """The names of the actions: grip 0 is the leftmost."""
        return tuple(f"grip {grip}" for grip in range(self.n_grips))

    def info(self, state: int) -> dict[str, Any]:
        """The grip that moves the climber up by one from here, or -1 at the top."""
        return {"right_grip": int(self.grips[state]) if state < self.height else -1}

    def scene(self, state: int, levels: int = MOST_LEVELS) -> Scene:
        """A wall from the front. The grip that holds is grey; the others are black and cracked.

        If the wall is higher than `levels`, the picture shows only the part around the climber.
        """
        height, n_grips, grips = self.height, min(self.n_grips, MOST_SHOWN), self.grips
        shown = min(height, levels)
        first = min(max(0, state - shown // 2), height - shown)  # the lowest level that is in the picture
        held = int(grips[max(state - 1, 0)])
        left = min(max(0, held - n_grips // 2), self.n_grips - n_grips)  # the first grip that is in the picture
        width, top = n_grips + 3.0, 2.0
        bottom = top + shown + 0.5
        # If there are more levels above, the wall goes on beyond the top of the picture.
        edge = top if first + shown == height else -1.0
        shapes: list[Shape] = [Rectangle(1.0, edge, n_grips + 1.0, bottom + 3.0 - edge, 0.3, fill=WALL)]
        if first == 0:
            shapes.append(Rectangle(0.0, bottom, width, 1.5, fill=GRASS, glyph="░"))
        if first + shown == height:
            shapes += flag(width - 1.5, top, 1.2)
        for level in range(first, first + shown):
            y = bottom - (level - first) - 0.75
            shapes.append(Text(0.5, y, str(level + 1), size=0.4))
            for grip in range(n_grips):
                shapes += _grip(grip + 2.0, y, holds=left + grip == grips[level])
        if state == 0:
            climber = (width / 2, bottom + 0.5)
        elif state == height:
            climber = (width / 2, top - 0.45)
        else:
            climber = (held - left + 2.0, bottom - (state - first) + 0.25)
        shapes += smiley(*climber, 0.42)
        return Scene(width, bottom + 1.5, shapes, SKY, f"Boulder: {state} of {height}", columns=2 * int(width))


def _grip(x: float, y: float, holds: bool) -> list[Shape]:
    if holds:
        return [Circle(x, y, 0.3, fill=STONE, glyph="●")]
    crack = ((x - 0.12, y - 0.2), (x + 0.06, y - 0.04), (x - 0.06, y + 0.04), (x + 0.12, y + 0.2))
    return [Circle(x, y, 0.3, fill=CRACK, glyph="×"), Line(crack, colour=WALL)]

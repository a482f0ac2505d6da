"""Trashbot: discrete and continuous actions (lesson 7)."""

import math
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import above, between, number_of_steps, whole_number
from edugym.envs.trashbot.geometry import (
    BASE,
    BOX,
    BOX_SIZE,
    CONTAINER_X,
    FOREARM,
    REACH,
    RIM_Y,
    SHOULDER_Y,
    STAND,
    UPPER_ARM,
    WALL,
    Arm,
    Block,
    Robot,
    arm,
)
from edugym.envs.trashbot.picture import picture
from edugym.mdp.protocol import Random
from edugym.rendering.scene import Scene

START = (math.radians(136), math.radians(66))
"""The joint angles at first: the magnet hangs above the box."""
STRIDE = 0.04
"""A move is looked at in parts in which nothing moves farther than this: less than the thinnest thing is thick."""
WIDEST, SCALES = 1.0, (0.001, 0.3)
"""The widest container, in units of the upper arm, and the smallest and the largest `action_scale`, in radians."""
TURNING = 2.5
"""Radians by which each joint must have time to turn: a little more than the delivery takes."""
MOVING, DELIVERED, COLLIDED, LATE = range(4)
OUTCOMES = ("moving", "delivered", "collided", "late")


class Trashbot(NamedTuple):
    """A robot arm with two joints brings a red box to a green container, the closer to its middle, the better.

    ## Description
    Challenge: discrete and continuous states and actions. On its base stands an arm of two links; from its end a magnet
    hangs straight down. It is to pick up the red box at the left and to drop it into the middle of the green container
    at the right. The agent sees where the joints are, and turns them by any angle, or by one of a few (`n_bins`). Few
    bins leave less to learn (with 3, PPO finds the best they can do, a return of 4.31, in 0.3 million steps in 4 of 4
    runs), but take the arm to fewer places. An exact search (`edugym.envs.trashbot.planning`) finds at the defaults,
    and a scripted controller with continuous actions:

    | bins | 2 | 3 | 4 | 5 | 6 | 7 | 9 | 11 | continuous |
    |---|---|---|---|---|---|---|---|---|---|
    | best reward for centring, of 2 | 0.85 | 1.31 | 1.91 | 1.89 | 1.96 | 1.94 | 1.97 | 1.99 | 2 |
    | in how many steps | 11 | 10 | 10 | 11 | 12 | 11 | 10 | 13 | 11 |

    (Few bins more are not always better: even and odd numbers of them lead to different places.) A narrower container
    asks for more: with 3 bins the best is 1.08 in one 0.4 wide and 0.62 in one 0.35 wide; into one 0.3 wide they cannot
    bring the box at all, while 5 bins get 1.58 there.

    ## Observation space
    `Box(-1, 1, (7,), float32)`: elbow x, y, wrist x, y, lower end of the magnet x, y, and 1 if it holds the box, else
    0. Coordinates are as seen from the shoulder, x to the right and y upwards, divided by the arm's reach, which is 2.

    ## Action space
    Continuous: `Box(-1, 1, (2,), float32)`: how far to turn the shoulder and the elbow, counterclockwise, as shares of
    `action_scale`; what is beyond -1 or 1 is clipped. With `n_bins`: `MultiDiscrete([n_bins, n_bins])`: bin k of n
    means 2k/(n-1) - 1, from -1 to 1, ends included. An even number of bins has no bin for 0: neither joint can rest.

    ## State
    The angles of both joints, whether the box is held, the number of steps, and the outcome: moving, delivered,
    collided or late. The clock is not observed (as in the paper), so the observation is not Markov: it does not tell
    when time will be up. All else follows from it.

    ## Dynamics
    Lengths are in units of the upper arm; the ground is at y = 0, the shoulder at (0, 0.5).
    1. Both angles change by action times `action_scale`. The upper arm is 1 long, the forearm 0.8, the magnet 0.2.
    2. If the magnet comes onto the box from above (it was higher than the box until then, and when the step began), it
       picks it up: the box then hangs from its lower end. That takes the step; the arm stays where it was. The box is a
       square of 0.25 on a stand, x from -1.625 to -1.375, y from 0.3 to 0.55.
    3. If the box is held and at the end of the step is between the container's walls, its lower side below the rim, it
       drops and is delivered. The middle of the container is at x = 1.6, its rim at y = 0.7.
    4. If on the way the arm touches the ground, its base, the stand, a wall of the container, or the box in any other
       way, or if a box that it holds touches any of these, it has collided, where it then is.

    The way is looked at in parts so short that nothing moves by more than 0.04 in them, so nothing can pass through a
    wall, which is 0.05 thick; a touch less than 0.02 deep between two looks goes unnoticed. At each look, what touches
    what is computed exactly.

    ## Reward
    +1 for picking up the box; +2 for delivering it, and another 2 (1 - d/r), where d is the distance of its middle from
    that of the container, and r the greatest at which it fits, (`container_width` - 0.25)/2; -2 for a collision; -1 for
    the last step allowed, if it neither delivers nor collides (on top of +1 if it picks up). The best return is 5
    (discount 1): a scripted controller gets 5.00 in 11 steps.

    ## Initial state
    The magnet above the box: the shoulder at 136 degrees, the elbow at 66.

    ## Episode end
    Terminated when the box is delivered, by a collision, or after `max_steps` steps, which is part of the task; never
    truncated.

    ## Parameters
    - `n_bins` (None): the discretisation level: how many values for each joint, from 2 to 2^31; None for continuous
      actions.
    - `container_width` (0.45): between its walls; more than 0.25, at most 1.
    - `action_scale` (pi / 15): radians for an action of 1, 12 degrees; from 0.001 to 0.3.
    - `max_steps` (150): 2.5/`action_scale` or more, in which the scripted controller can deliver the box.

    ## Info
    - `steps`: how many steps this episode has taken.
    - `angles`: of the shoulder (from the direction of x) and the elbow (from the direction of the upper arm), in
      radians, counterclockwise.
    - `outcome`: "moving", "delivered", "collided" or "late".
    - `centring`: the reward for centring, from 0 to 2; 0 until the box is delivered.

    ## Choices
    - The paper shows the scene but gives no sizes. These are chosen such that 3 bins are enough to deliver the box, but
      not to centre it, and such that learning can begin: random actions deliver the box in 1.1 percent of episodes
      (continuous), 1.5 (5 bins) or 2.0 (3 bins). PPO of Stable-Baselines3 (on `edugym.deep.stable_baselines3_env` with
      64 copies, n_steps=256, batch_size=1024, learning_rate=1e-3, gamma=0.999) then returns after 1 million steps (in
      some 40 seconds) 4.89 in 4 of 4 runs with 5 bins, which is the best they can do, and 4.77, 4.80, 4.83 and 4.95
      with continuous actions.
    - An action is a share of `action_scale`, and every joint has its own bins, any number of them; the paper writes
      radians from -1 to 1 and `Discrete(num_bins)` with 3, 5, 7, 9 or 11. It gives no range for the coordinates.
    - There is one box, and to deliver it ends the episode. (The paper speaks of boxes, and of no end but failure.)
    - The stand keeps what the arm does with the box clear of the ground.
    - The arm does not bend to the magnet's touch (2), so with bins the angles stay on a lattice; at the default
      `action_scale` a full turn of a joint comes back to the same angles of it, so winding up a joint gains nothing.
    - Links, magnet and the box that is held pass through each other: the arm is no obstacle to itself.
    - Whether bins are fine enough for a container is not checked: that is the challenge.

    ## Algorithms
    The paper compares PPO with continuous actions and with discrete ones.

    ## References
    Moerland et al. (2023), EduGym, section 4 g and appendix A.7.
    """

    container_width: float
    action_scale: float
    time_limit: int
    n_bins: int

    def initial(self, rng: Random) -> Robot:
        """The magnet above the box."""
        return Robot(START[0], START[1], False, 0, MOVING)

    def transition(self, state: Robot, action: Any, rng: Random) -> Robot:
        """The two joints turn; on its way the arm may touch the box, or something that it should not."""
        shoulder_turn, elbow_turn = self.turns(action)
        parts = self.parts(shoulder_turn, elbow_turn)
        steps = state.steps + 1
        outcome = LATE if steps == self.time_limit else MOVING
        shoulder, elbow = state.shoulder, state.elbow
        start = now = arm(shoulder, elbow)
        for part in range(1, parts + 1):
            before = now
            shoulder = state.shoulder + shoulder_turn * (part / parts)
            elbow = state.elbow + elbow_turn * (part / parts)
            now = arm(shoulder, elbow)
            if self.collides(now, state.holding):
                return Robot(shoulder, elbow, state.holding, steps, COLLIDED)
            if not state.holding and (now.magnet_meets(BOX) or now.links_meet(BOX)):
                # No link gets to the box while the magnet is so high; at the start, to which the arm goes back with the
                # box, it must have been as high, or the box would be in the stand.
                if min(start.tip_y, before.tip_y) > BOX.top:
                    return Robot(state.shoulder, state.elbow, True, steps, outcome)
                return Robot(shoulder, elbow, False, steps, COLLIDED)
        if state.holding and self.in_opening(now):
            return Robot(shoulder, elbow, False, steps, DELIVERED)
        return Robot(shoulder, elbow, state.holding, steps, outcome)

    def turns(self, action: Any) -> tuple[float, float]:
        """How far an action, shape (2,), turns the shoulder and the elbow."""
        return self.action_scale * float(action[0]), self.action_scale * float(action[1])

    def parts(self, shoulder_turn: float, elbow_turn: float) -> int:
        """In how many parts a move is looked at, so that nothing moves by more than a stride in one of them."""
        return 1 + int((abs(shoulder_turn) * (UPPER_ARM + FOREARM) + abs(elbow_turn) * FOREARM) / STRIDE)

    def collides(self, now: Arm, holding: bool) -> bool:
        """Whether the arm, or the box that it holds, touches the ground, the base, the stand or the container."""
        load = now.load
        if min(now.elbow_y, load.bottom if holding else now.tip_y) <= 0.0:
            return True
        for block in self.obstacles:
            if now.links_meet(block) or now.magnet_meets(block) or (holding and load.meets(block)):
                return True
        return False

    @property
    def obstacles(self) -> tuple[Block, Block, Block, Block]:
        """The base, the stand and the two walls of the container."""
        left, right = CONTAINER_X - self.container_width / 2, CONTAINER_X + self.container_width / 2
        return BASE, STAND, Block(left - WALL, 0.0, left, RIM_Y), Block(right, 0.0, right + WALL, RIM_Y)

    def in_opening(self, now: Arm) -> bool:
        """Whether the box that the arm holds is between the walls, its lower side below the rim."""
        return now.load.bottom < RIM_Y and abs(now.wrist_x - CONTAINER_X) <= self.room

    @property
    def room(self) -> float:
        """How far from the middle of the container the box still fits."""
        return (self.container_width - BOX_SIZE) / 2

    def reward(self, state: Robot, action: Any, next_state: Robot, rng: Random) -> float:
        """+1 for the box on the magnet; +2 for it in the container, and up to +2 for how well; -2 for a collision."""
        if next_state.outcome == COLLIDED:
            return -2.0
        if next_state.outcome == DELIVERED:
            return 2.0 + self.centring(next_state)
        picked_up = 1.0 if next_state.holding and not state.holding else 0.0
        return picked_up - 1.0 if next_state.outcome == LATE else picked_up

    def centring(self, state: Robot) -> float:
        """From 2 in the middle of the container down to 0 where the box only just fits."""
        return 2.0 * (1.0 - abs(arm(state.shoulder, state.elbow).wrist_x - CONTAINER_X) / self.room)

    def terminal(self, state: Robot) -> bool:
        """The box has been delivered, something was hit, or time is up."""
        return state.outcome != MOVING

    def observation(self, state: Robot, rng: Random) -> tuple[float, ...]:
        """Elbow, wrist and magnet as seen from the shoulder, in units of the reach, and whether the box is held."""
        now = arm(state.shoulder, state.elbow)
        elbow_x, elbow_y = now.elbow_x / REACH, (now.elbow_y - SHOULDER_Y) / REACH
        wrist_x, wrist_y = now.wrist_x / REACH, (now.wrist_y - SHOULDER_Y) / REACH
        tip_y = (now.tip_y - SHOULDER_Y) / REACH
        return elbow_x, elbow_y, wrist_x, wrist_y, wrist_x, tip_y, 1.0 if state.holding else 0.0

    @property
    def observation_space(self) -> spaces.Box:
        """Elbow x, y, wrist x, y, magnet x, y, and holding."""
        return spaces.Box(-1.0, 1.0, (7,), np.float32)

    @property
    def action_space(self) -> spaces.Space[Any]:
        """How far to turn the shoulder and the elbow, as shares of `action_scale`."""
        return spaces.Box(-1.0, 1.0, (2,), np.float32)

    @classmethod
    def create(
        cls,
        n_bins: int | None = None,
        container_width: float = 0.45,
        action_scale: float = math.pi / 15,
        max_steps: int = 150,
    ) -> "Trashbot":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        if n_bins is not None:
            n_bins = whole_number("n_bins", n_bins, 2, 2**31)
        above("container_width", container_width, BOX_SIZE, WIDEST)
        between("action_scale", action_scale, *SCALES)
        max_steps = number_of_steps("max_steps", max_steps)
        fewest = math.ceil(TURNING / action_scale)
        if max_steps < fewest:
            raise ValueError(
                f"max_steps must be {fewest} or more, so that a joint can turn by {TURNING} radians with an "
                f"action_scale of {action_scale!r}, but is {max_steps!r}"
            )
        kind = Trashbot if n_bins is None else TrashbotInBins
        return kind(float(container_width), float(action_scale), max_steps, n_bins or 0)

    @property
    def reward_threshold(self) -> float:
        """The box is delivered, wherever between the walls."""
        return 3.0

    @property
    def action_names(self) -> dict[str, Any]:
        """Each joint far and a little to either side, while the other rests; where none can rest, both a little."""
        n, last = self.n_bins, self.n_bins - 1
        low, rest, high = (0, last // 2, last) if n else (-1.0, 0.0, 1.0)
        left, right = (rest + 1, last - rest - 1) if n else (0.25, -0.25)
        far = _moves("upper arm", "forearm", (high, rest), (low, rest), (rest, high), (rest, low))
        if n and n % 2 == 0:
            near = _moves("both", "forearm against upper arm", (left, left), (rest, rest), (rest, left), (left, rest))
        else:
            near = _moves("upper arm", "forearm", (left, rest), (right, rest), (rest, left), (rest, right))
        little = {f"{name}, a little": move for name, move in near.items()}
        moves = near if n in (2, 3) else far | little
        return {name: np.array(move, self.action_space.dtype) for name, move in moves.items()}

    def info(self, state: Robot) -> dict[str, Any]:
        """The clock, the joints, how the episode stands, and how well the box was placed."""
        return {
            "steps": int(state.steps),
            "angles": np.array([state.shoulder, state.elbow]),
            "outcome": OUTCOMES[state.outcome],
            "centring": float(self.centring(state)) if state.outcome == DELIVERED else 0.0,
        }

    def scene(self, state: Robot) -> Scene:
        """The arm on its base between box and container, and where the magnet can be after the next step."""
        return picture(self, state, OUTCOMES[state.outcome])


class TrashbotInBins(Trashbot):
    """Trashbot in which an action chooses from `n_bins` values for each joint, evenly spread from -1 to 1."""

    __slots__ = ()

    def turns(self, action: Any) -> tuple[float, float]:
        """How far an action, two whole numbers, turns the shoulder and the elbow."""
        last = self.n_bins - 1
        return self.action_scale * (2 * int(action[0]) / last - 1), self.action_scale * (2 * int(action[1]) / last - 1)

    @property
    def action_space(self) -> spaces.Space[Any]:
        """The bin for the shoulder and the bin for the elbow: 0 is -1, `n_bins` - 1 is 1."""
        return spaces.MultiDiscrete(np.array([self.n_bins, self.n_bins], np.int64))


def _moves(one: str, other: str, *moves: tuple[float, float]) -> dict[str, tuple[float, float]]:
    """Four moves by their names."""
    return dict(zip((f"{one} left", f"{one} right", f"{other} left", f"{other} right"), moves, strict=True))

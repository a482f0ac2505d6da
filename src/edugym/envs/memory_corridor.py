"""MemoryCorridor: partial observability (lesson 5)."""

from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.checks.parameters import number_of_steps, whole_number
from edugym.mdp.protocol import Random
from edugym.rendering.icons import door, lamp, smiley
from edugym.rendering.palette import BRICK, ROAD, SHADE, WALL, blend
from edugym.rendering.scene import Rectangle, Scene, Shape, Text

SEEDS = 2**31
"""The number of different seeds, and so of sequences of doors."""
MOST_DOORS = 1_000
MOST_SHOWN = 40
"""How many of a long row of doors the picture shows."""


class Corridor(NamedTuple):
    """The right doors, the length of the corridor, and where the agent is.

    Attributes:
        seed: determines the right doors of this episode (see `MemoryCorridor.right_door`).
        length: of the corridor; it grows by one each time the agent reaches the end.
        position: the index of the agent's place, from 0.
        opened: the wrong door that was opened, or -1.
    """

    seed: int
    length: int
    position: int
    opened: int


class MemoryCorridor(NamedTuple):
    """Walk through a corridor that gets one place longer each time; only at the last place is the right door marked.

    ## Description
    Challenge: partial observability. At every place of the corridor there are `num_doors` doors, one of them unlocked.
    The first corridor has one place; each time the agent gets through, the same places come again with a new one at the
    end, and only there the unlocked door is marked. To get through a corridor of length L an agent must remember the
    L-1 doors before, so the task scales its own challenge.

    ## Observation space
    `Discrete(num_doors + 1)`: the door marked as right, or `num_doors` where none is marked.

    ## Action space
    `Discrete(num_doors)`: the door to open.

    ## State
    The right doors (as the seed from which they follow), the length of the corridor, the position in it, the wrong door
    that was opened, if any, and the number of steps of this episode. The agent sees none of these but the mark, so the
    observation is not Markov: that is the challenge.

    ## Dynamics
    The right door leads to the next place. After the last place the corridor starts again, one place longer. Doors are
    drawn independently and uniformly from the environment's random stream, new ones in every episode (fixed ones could
    be learned by heart).

    ## Reward
    1 for a right door, 0 for a wrong one. The best return is 1 a step for ever: `max_steps` (discount 1). Perfect play
    up to the end of the corridor of length L has returned L(L+1)/2.

    ## Initial state
    A corridor of length 1, whose only right door is marked.

    ## Episode end
    Terminated by a wrong door; else truncated after `max_steps` steps.

    ## Parameters
    - `num_doors` (3): at every place, from 2 to 1000; more doors make more states, but no more places to remember.
    - `max_steps` (1000): 1 or more.

    ## Info
    - `length`: how long the corridor is.
    - `position`: at which place the agent is, from 0.
    - `right_door`: the door that is unlocked there.

    ## Choices
    - The paper has no step limit; without one perfect play would never end.
    - After a wrong door the position and the observation do not change.

    ## Algorithms
    The paper compares Q-learning with a table and deep Q-learning (Stable-Baselines3), both with stacked frames, and
    recurrent PPO (sb3-contrib).

    ## References
    Moerland et al. (2023), EduGym, section 4 e and appendix A.5.
    """

    num_doors: int
    max_steps: int

    def initial(self, rng: Random) -> Corridor:
        """A corridor of length 1."""
        return Corridor(int(rng.random() * SEEDS), 1, 0, -1)

    def transition(self, state: Corridor, action: int, rng: Random) -> Corridor:
        """The right door leads to the next place; after the last place the corridor starts again, one place longer."""
        if action != self.right_door(state.seed, state.position):
            return Corridor(state.seed, state.length, state.position, action)
        if state.position < state.length - 1:
            return Corridor(state.seed, state.length, state.position + 1, -1)
        return Corridor(state.seed, state.length + 1, 0, -1)

    def right_door(self, seed: int, place: int) -> int:
        """The unlocked door at a place, computed by a hash, so that no list of doors must be stored.

        It behaves like independent uniform draws. The seed and the place are mixed as in the last step of a hash
        function (multiply, shift, exclusive or), in numbers of 31 bits, so that every product fits in 62 bits.
        """
        bits = (seed + place * 0x1E3779B9) % SEEDS
        bits = (bits ^ (bits >> 15)) * 0x2C1B3C6D % SEEDS
        bits = (bits ^ (bits >> 12)) * 0x297A2D39 % SEEDS
        return (bits ^ (bits >> 15)) * self.num_doors // SEEDS

    def reward(self, state: Corridor, action: int, next_state: Corridor, rng: Random) -> float:
        """1 for a right door, else 0."""
        return 1.0 if next_state.opened == -1 else 0.0

    def terminal(self, state: Corridor) -> bool:
        """Whether a wrong door was opened."""
        return state.opened != -1

    def observation(self, state: Corridor, rng: Random) -> int:
        """The door that is marked as right, or `num_doors` where none is: only the last place has a mark."""
        if state.position == state.length - 1:
            return self.right_door(state.seed, state.position)
        return self.num_doors

    @property
    def observation_space(self) -> spaces.Discrete:
        """The marked door, or `num_doors` for none."""
        return spaces.Discrete(self.num_doors + 1)

    @property
    def action_space(self) -> spaces.Discrete:
        """The door to open."""
        return spaces.Discrete(self.num_doors)

    @classmethod
    def create(
        cls,
        num_doors: int = 3,
        max_steps: int = 1000,
    ) -> "MemoryCorridor":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        num_doors = whole_number("num_doors", num_doors, 2, MOST_DOORS)
        return cls(num_doors, number_of_steps("max_steps", max_steps))

    @property
    def reward_threshold(self) -> float:
        """No wrong door up to the step limit."""
        return float(self.max_steps)

    @property
    def action_names(self) -> tuple[str, ...]:
        """The doors, from the left."""
        return tuple(f"door {k}" for k in range(self.num_doors))

    def info(self, state: Corridor) -> dict[str, Any]:
        """The length of the corridor, the agent's place in it and the right door there."""
        right_door = self.right_door(state.seed, state.position)
        return {"length": int(state.length), "position": int(state.position), "right_door": int(right_door)}

    def scene(self, state: Corridor) -> Scene:
        """Numbered doors with windows, a lamp over each, lit over the marked door, and the place in the corridor.

        Of many doors it shows those around the marked or opened one.
        """
        seed, length, position, opened = state
        marked, locked_in = position == length - 1, opened != -1
        right_door = self.right_door(seed, position)
        n = min(self.num_doors, MOST_SHOWN)
        middle = opened if locked_in else right_door if marked else 0
        leftmost = min(max(0, middle - n // 2), self.num_doors - n)
        width = max(2.0 * n + 1.0, 7.0)
        left = (width - 2.0 * n) / 2 + 0.25
        shapes: list[Shape] = [
            Rectangle(0.0, 4.6, width, 1.7, fill=ROAD, outline=None),
            Text(width / 2, 0.5, f"Door {position + 1} of {length}", size=0.5),
        ]
        for k in range(n):
            x, number = left + 2.0 * k, leftmost + k
            right = number == right_door
            shapes += lamp(x + 0.75, 1.15, 0.2, lit=bool(marked and right))
            pane = "?" if not marked else "!" if right else ""
            shapes += door(x, 1.6, 1.5, 3.0, BRICK if number == opened else WALL, str(number), pane)
        shown = length if length <= 24 else 24
        step = min(0.6, (width - 1.0) / shown)
        first = min(max(0, position - shown // 2), length - shown)
        for k in range(first, first + shown):
            x = width / 2 + (k - first - (shown - 1) / 2) * step
            colour = blend(WALL, SHADE, 0.0 if k < position else 0.8)
            shapes.append(Rectangle(x - 0.4 * step, 6.6, 0.8 * step, 0.5, 0.08, fill=colour))
        x = width / 2 + (position - first - (shown - 1) / 2) * step
        shapes.append(Rectangle(x - 0.4 * step, 6.6, 0.8 * step, 0.5, 0.08, fill="#ffd23f"))
        at = left + 2.0 * (opened - leftmost) + 0.75 if locked_in else width / 2
        shapes += smiley(at, 5.45, 0.6, "sad" if locked_in else "happy")
        return Scene(
            width, 7.5, shapes, title=f"MemoryCorridor: door {position + 1} of {length}", columns=int(4 * width)
        )

"""MemoryCorridor: partial observability."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks import number_of_steps, whole_number
from edugym.mdp.protocol import Integers, Random
from edugym.rendering.icons import door, lamp, smiley
from edugym.rendering.palette import BRICK, ROAD, SHADE, WALL, blend
from edugym.rendering.scene import Rectangle, Scene, Shape, Text


class Corridor(NamedTuple):
    """Where the agent is, and what it must remember.

    Attributes:
        doors: shape (length,): the right door at each place of the corridor; one longer whenever it has been solved.
        position: at which place the agent stands, from 0.
        locked_in: whether it has opened a wrong door.
    """

    doors: Integers
    position: int
    locked_in: bool


class MemoryCorridor(NamedTuple):
    """Walk through a corridor of doors that grows by one each time; only the last right door is marked.

    Attributes:
        num_doors: how many doors there are to choose from at every place.
        max_steps: after how many steps an episode is truncated.
    """

    num_doors: int
    max_steps: int

    def initial(self, rng: Random) -> Corridor:
        """A corridor of length 1."""
        doors = np.empty(1, np.int64)
        doors[0] = int(rng.random() * self.num_doors)
        return Corridor(doors, 0, False)

    def transition(self, state: Corridor, action: int, rng: Random) -> Corridor:
        """The right door leads on; behind the last one the corridor starts again, one door longer."""
        if action != state.doors[state.position]:
            return Corridor(state.doors, state.position, True)
        length = len(state.doors)
        if state.position < length - 1:
            return Corridor(state.doors, state.position + 1, False)
        longer = np.empty(length + 1, np.int64)
        longer[:length] = state.doors
        longer[length] = int(rng.random() * self.num_doors)
        return Corridor(longer, 0, False)

    def reward(self, state: Corridor, action: int, next_state: Corridor, rng: Random) -> float:
        """1 for a right door, else 0."""
        return 0.0 if next_state.locked_in else 1.0

    def terminal(self, state: Corridor) -> bool:
        """A wrong door is the end."""
        return state.locked_in

    def observation(self, state: Corridor, rng: Random) -> int:
        """The door that is marked as right, or `num_doors` where none is: only the last place has a mark."""
        if state.position == len(state.doors) - 1:
            return int(state.doors[state.position])
        return self.num_doors

    @property
    def observation_space(self) -> spaces.Discrete:
        """The marked door, or `num_doors` for none."""
        return spaces.Discrete(self.num_doors + 1)

    @property
    def action_space(self) -> spaces.Discrete:
        """The door to open."""
        return spaces.Discrete(self.num_doors)


class MemoryCorridorEnv(MDPEnv[MemoryCorridor]):
    """Walk through a corridor of doors that grows by one each time; only the last right door is marked.

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
    The right doors of the whole corridor, the position in it, whether a wrong door was opened, and the number of steps
    of this episode. The agent sees none of these but the mark, so the observation is not Markov: that is the challenge.

    ## Dynamics
    The right door leads to the next place, the last one to the start of a corridor that is one door longer. Doors are
    drawn independently and uniformly from the environment's random stream, new ones in every episode (fixed ones could
    be learned by heart).

    ## Reward
    1 for a right door, 0 for a wrong one. The best return is 1 a step for ever: `max_steps` (discount 1). Perfect play
    up to the end of the corridor of length L has returned L(L+1)/2.

    ## Initial state
    A corridor of length 1, whose only right door is marked.

    ## Episode end
    Terminated by a wrong door; truncated after `max_steps` steps.

    ## Parameters
    - `num_doors` (3): at every place, 2 or more; more doors make more states, but no more places to remember.
    - `max_steps` (1000): 1 or more.

    ## Info
    - `length`: how long the corridor is.
    - `position`: at which place the agent is, from 0.
    - `right_door`: the door that is unlocked there.

    ## Choices
    - The paper has no step limit; without one perfect play would never end.
    - After a wrong door the agent stays where it was, and so does its observation.

    ## Algorithms
    The paper compares Q-learning with a table and deep Q-learning (Stable-Baselines3), both with stacked frames, and
    recurrent PPO (sb3-contrib).

    ## References
    Moerland et al. (2023), EduGym, section 4 e and appendix A.5.
    """

    def __init__(self, num_doors: int = 3, max_steps: int = 1000, render_mode: str | None = None) -> None:
        """See the class for the parameters.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        whole_number("num_doors", num_doors, 2)
        number_of_steps("max_steps", max_steps)
        super().__init__(MemoryCorridor(num_doors, max_steps), render_mode)

    def info(self) -> dict[str, Any]:
        """The length of the corridor, the agent's place in it and the right door there."""
        doors, position, _ = self.state
        return {"length": len(doors), "position": int(position), "right_door": int(doors[position])}

    def named_actions(self) -> dict[str, Any]:
        """The doors, from the left."""
        return {f"door {k}": k for k in range(self.mdp.num_doors)}

    def scene(self) -> Scene:
        """Numbered doors with windows, a lamp over each, lit over the marked door, and the place in the corridor."""
        doors, position, locked_in = (np.zeros(1, np.int64), 0, False) if self.state is None else self.state
        n, marked = self.mdp.num_doors, position == len(doors) - 1
        width = max(2.0 * n + 1.0, 7.0)
        left = (width - 2.0 * n) / 2 + 0.25
        shapes: list[Shape] = [
            Rectangle(0.0, 4.6, width, 1.7, fill=ROAD, outline=None),
            Text(width / 2, 0.5, f"Door {position + 1} of {len(doors)}", size=0.5),
        ]
        for k in range(n):
            x, right = left + 2.0 * k, k == doors[position]
            opened = locked_in and k == self.last_action
            shapes += lamp(x + 0.75, 1.15, 0.2, lit=bool(marked and right))
            shapes += door(
                x, 1.6, 1.5, 3.0, BRICK if opened else WALL, str(k), "!" if marked and right else "" if marked else "?"
            )
        shown = len(doors) if len(doors) <= 24 else 24
        step = min(0.6, (width - 1.0) / shown)
        first = min(max(0, position - shown // 2), len(doors) - shown)
        for k in range(first, first + shown):
            x = width / 2 + (k - first - (shown - 1) / 2) * step
            colour = blend(WALL, SHADE, 0.0 if k < position else 0.8)
            shapes.append(Rectangle(x - 0.4 * step, 6.6, 0.8 * step, 0.5, 0.08, fill=colour))
        x = width / 2 + (position - first - (shown - 1) / 2) * step
        shapes.append(Rectangle(x - 0.4 * step, 6.6, 0.8 * step, 0.5, 0.08, fill="#ffd23f"))
        at = width / 2 if not locked_in or self.last_action is None else left + 2.0 * self.last_action + 0.75
        shapes += smiley(at, 5.45, 0.6, "sad" if locked_in else "happy")
        return Scene(
            width, 7.5, shapes, title=f"MemoryCorridor: door {position + 1} of {len(doors)}", columns=int(4 * width)
        )

"""Switches: many goals, each with a rare reward (lesson 11)."""

from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.parameters import in_short, number_of_steps, whole_number
from edugym.mdp.protocol import Random
from edugym.rendering.icons import smiley
from edugym.rendering.palette import BLUE, INK, PAPER, SHADE, SKY, WHITE
from edugym.rendering.scene import Rectangle, Scene, Shape, Text

MOST_SWITCHES = 62
"""A pattern is one whole number of 64 bits."""
IN_A_ROW = 8
"""So many switches stand beside each other in the picture."""


class Panel(NamedTuple):
    """Two patterns, each a whole number: in binary, its first of n digits is switch 0, 1 for on and 0 for off.

    Attributes:
        switches: how the switches are.
        goal: how they are wanted.
    """

    switches: int
    goal: int


class Switches(NamedTuple):
    """Flip switches until they show the pattern of this episode.

    ## Description
    Challenge: many goals, each with a rare reward. There are n switches, and a pattern that they should show: the goal,
    another one in each episode. Every step costs 1 until the pattern is there, so an episode that misses its goal says
    nothing, however close it came. In the n steps of an episode one can show at most n of the 2^n - 1 other patterns,
    so whoever has learned nothing yet reaches the goal in less than one of 10 episodes with 6 switches, and in less
    than one of 600 with 13. But every episode does reach *some* patterns, and shows how to reach those. (To learn from
    that is hindsight.)

    ## Observation space
    `Dict(observation, achieved_goal, desired_goal)`, each of them `MultiBinary(n_switches)`, 1 for on and 0 for off:
    the switches, the switches again, and the wanted pattern. This is a goal environment as Gymnasium-Robotics defines
    it: it has `compute_reward`, `compute_terminated` and `compute_truncated`, which take (achieved_goal, desired_goal,
    info), for one step or for a batch of them. The MDP, `env.unwrapped.mdp`, which `edugym.train` plays, shows the same
    as one array of 2 n whole numbers, `MultiDiscrete([2, ..., 2])`: the switches, then the wanted pattern. As a row of
    a table this is 2^n s + g, where s and g are the two patterns as binary numbers, switch 0 their first digit;
    `edugym.TabularObservation(env)` makes this number of the dictionary.

    ## Action space
    `Discrete(n_switches)`: the switch to flip.

    ## State
    `Panel(switches, goal)`: the switches and the wanted pattern, both observed, as the numbers s and g above. The
    number of steps so far is not observed: near the step limit the observation is not Markov, which does no harm to an
    agent that bootstraps at truncation.

    ## Dynamics
    The switch is flipped: on becomes off, and off becomes on. The wanted pattern stays the same during an episode.

    ## Reward
    0 for the step that brings the wanted pattern about, and -1 for every other. If d switches are wrong (the distance),
    the best return is -(d - 1), in d steps, and with the discount γ it is -(1 - γ^(d - 1)) / (1 - γ). The mean of
    the distance at the start is n 2^(n - 1) / (2^n - 1), so the best expected return is about -2.05 at the defaults
    (discount 1).

    ## Initial state
    The switches are drawn uniformly from the 2^n patterns, and the goal uniformly from the 2^n - 1 others.

    ## Episode end
    Terminated when the switches show the wanted pattern; else truncated after `max_steps` steps.

    ## Parameters
    - `n_switches` (6): n, how many switches there are, from 1 to 62.
    - `max_steps` (n_switches): the number of steps after which an episode is truncated, from 1 to 2^62.

    ## Info
    - `distance`: how many switches are wrong, which is the fewest steps to the goal.
    - `is_success`: whether the switches show the wanted pattern.
    - `steps`: how many steps this episode has taken.

    ## Choices
    - Andrychowicz et al. draw start and goal independently, so that an episode may begin at its goal. Here it never
      does.
    - In their text an episode goes on at the goal, and costs nothing there. Here it ends there, as in the bit-flipping
      environment of Stable-Baselines3. The best return is the same.
    - They give -1 as long as the pattern is not there; here it is the state after the step that counts.

    ## Algorithms
    Andrychowicz et al. compare DQN without and with hindsight: without it, DQN learns up to 13 switches; with it, up to
    50. Here, after 20 000 steps with 8 switches, `edugym.HindsightDQN` at its defaults returns -3.06 (95 % interval
    over five seeds: -3.18 to -2.94); the best is -3.02. Without hindsight it learns 6 switches in 200 000 steps, and
    nothing of 8 (-7.94). A table tells nothing of one pair of patterns by another; there, at a learning rate of 1,
    hindsight saves some steps, but not many.

    ## References
    Andrychowicz et al. (2017), Hindsight experience replay, sections 3.1 and 4. It is not one of the nine environments
    of Moerland et al. (2023), EduGym, who name goal-based reinforcement learning among what they leave out.
    """

    n_switches: int
    max_steps: int

    def initial(self, rng: Random) -> Panel:
        """Any pattern, and any other as the goal."""
        n_patterns = 1 << self.n_switches
        switches = int(rng.integers(0, n_patterns))
        goal = int(rng.integers(0, n_patterns - 1))
        return Panel(switches, goal if goal < switches else goal + 1)

    def transition(self, state: Panel, action: int, rng: Random) -> Panel:
        """Flip a switch."""
        return Panel(state.switches ^ (1 << (self.n_switches - 1 - action)), state.goal)

    def reward(self, state: Panel, action: int, next_state: Panel, rng: Random) -> float:
        """0 at the goal, else -1."""
        return 0.0 if self.terminal(next_state) else -1.0

    def terminal(self, state: Panel) -> bool:
        """Whether the switches show the wanted pattern."""
        return state.switches == state.goal

    def observation(self, state: Panel, rng: Random) -> Any:
        """Both patterns, a number for each switch."""
        seen = np.empty(2 * self.n_switches, np.int64)
        self.observe_into(state, rng, seen)
        return seen

    def observe_into(self, state: Panel, rng: Random, seen: Any) -> None:
        """The same, written into `seen`, shape (2 n_switches,)."""
        n = self.n_switches
        for k in range(n):
            seen[k] = (state.switches >> (n - 1 - k)) & 1
            seen[n + k] = (state.goal >> (n - 1 - k)) & 1

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """The switches, then the wanted pattern."""
        return spaces.MultiDiscrete(np.full(2 * self.n_switches, 2, np.int64))

    @property
    def goal_space(self) -> spaces.MultiBinary:
        """A pattern: the second half of an observation is the goal, and the first half what has been achieved."""
        return spaces.MultiBinary(self.n_switches)

    @property
    def action_space(self) -> spaces.Discrete:
        """The switch to flip."""
        return spaces.Discrete(self.n_switches)

    @classmethod
    def create(cls, n_switches: int = 6, max_steps: int | None = None) -> "Switches":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        n_switches = whole_number("n_switches", n_switches, 1, MOST_SWITCHES)
        return cls(n_switches, number_of_steps("max_steps", n_switches if max_steps is None else max_steps))

    def distance(self, state: Panel) -> int:
        """How many switches are wrong: the fewest steps to the goal."""
        return (int(state.switches) ^ int(state.goal)).bit_count()

    @property
    def reward_threshold(self) -> float | None:
        """The best expected return; None if the step limit is too low for the largest distance."""
        if self.max_steps < self.n_switches:
            return None
        n_patterns = 1 << self.n_switches
        return 1.0 - self.n_switches * (n_patterns // 2) / (n_patterns - 1)

    @property
    def action_names(self) -> tuple[str, ...]:
        """Switch 0 is the first one from the left."""
        return tuple(f"switch {k}" for k in range(self.n_switches))

    def info(self, state: Panel, steps: int) -> dict[str, Any]:
        """How far the goal is, whether it is reached, and the steps so far."""
        return {"distance": self.distance(state), "is_success": bool(self.terminal(state)), "steps": steps}

    def scene(self, state: Panel, last_action: int | None = None) -> Scene:
        """Rows of switches: above each, whether it is wanted on or off, and below, the face at the last one flipped."""
        n = self.n_switches
        seen = [int(part) for part in self.observation(state, np.random.default_rng(0))]
        rows, columns = -(-n // IN_A_ROW), min(n, IN_A_ROW)
        width = max(columns, 4) + 2.0
        left = (width - columns) / 2
        shapes: list[Shape] = []
        for k in range(n):
            x, y = left + k % IN_A_ROW, 0.4 + 4.4 * (k // IN_A_ROW)
            shapes += _switch(x, y, k, is_on=seen[k] == 1, wanted_on=seen[n + k] == 1)
        at = 0 if last_action is None else int(last_action)
        x = left - 0.5 if last_action is None else left + at % IN_A_ROW + 0.5
        wrong = self.distance(state)
        shapes += smiley(x, 3.85 + 4.4 * (at // IN_A_ROW), 0.36, "happy" if wrong == 0 else "flat")
        return Scene(width, 0.2 + 4.4 * rows, shapes, SKY, f"Switches: {wrong} of {n} wrong", columns=4 * int(width))


def _switch(x: float, y: float, k: int, is_on: bool, wanted_on: bool) -> list[Shape]:
    """What is wanted of a switch, as a card, and the switch below it, its lever up for on and down for off."""
    card = "on" if wanted_on else "off"
    lever, number = y + (1.4 if is_on else 2.18), y + (2.5 if is_on else 1.7)
    return [
        Rectangle(x + 0.12, y, 0.76, 0.76, 0.08, fill=BLUE if wanted_on else WHITE),
        Text(x + 0.5, y + 0.38, card, size=0.36, colour=WHITE if wanted_on else INK, glyph="●" if wanted_on else "○"),
        Rectangle(x + 0.12, y + 1.2, 0.76, 1.8, 0.12, fill=PAPER),
        Rectangle(x + 0.24, lever, 0.52, 0.62, 0.1, fill=BLUE if is_on else SHADE, glyph="■" if is_on else "□"),
        Text(x + 0.5, number, str(k), size=0.3),
    ]


class SwitchesEnv(MDPEnv[Switches]):
    """Switches as a goal environment, as Gymnasium-Robotics defines it.

    An observation is a dictionary of what is observed, what has been achieved, and what is wanted. The parameters are
    those of `Switches.create`, and `render_mode` is that of `MDPEnv`.
    """

    def __init__(self, n_switches: int = 6, max_steps: int | None = None, render_mode: str | None = None) -> None:
        """See `Switches` for the parameters, and `MDPEnv` for `render_mode`.

        Raises:
            ValueError: a parameter is not as it says there.
        """
        super().__init__(Switches.create(n_switches, max_steps), render_mode)
        goals = self.mdp.goal_space
        self.observation_space = spaces.Dict(observation=goals, achieved_goal=goals, desired_goal=goals)
        self._shown = partial(as_goals, self.mdp.n_switches)

    def _of_rows(self, rows: Any) -> dict[str, Any]:
        """The dictionary of arrays, a row for each of several copies, as a vector environment shows it."""
        return as_goals(self.mdp.n_switches, rows)

    def compute_reward(self, achieved_goal: Any, desired_goal: Any, info: Any) -> Any:
        """The reward of a step that led to a pattern, if the goal was another one.

        Args:
            achieved_goal: shape (..., n_switches): the pattern after the step.
            desired_goal: the goal, of the same shape.
            info: not used.

        Returns:
            0 where both are the same, else -1; shape (...).

        Raises:
            ValueError: the shapes are others.
        """
        return np.where(self.compute_terminated(achieved_goal, desired_goal, info), 0.0, -1.0)[()]

    def compute_terminated(self, achieved_goal: Any, desired_goal: Any, info: Any) -> Any:
        """Whether a step terminates the episode, if the goal is `desired_goal`: see `compute_reward`."""
        achieved, desired, n = np.asarray(achieved_goal), np.asarray(desired_goal), self.mdp.n_switches
        if achieved.shape != desired.shape or achieved.shape[-1:] != (n,):
            raise ValueError(
                f"achieved_goal and desired_goal must be arrays of one shape whose last axis is {n}, but are"
                f" {in_short(achieved_goal)} and {in_short(desired_goal)}"
            )
        return (achieved == desired).all(axis=-1)

    def compute_truncated(self, achieved_goal: Any, desired_goal: Any, info: Any) -> Any:
        """Whether the step limit cuts the episode off there.

        Args:
            achieved_goal: as for `compute_reward`.
            desired_goal: likewise.
            info: the `info` of the step, or a sequence of these for a batch.

        Returns:
            True where `steps` is at the limit and the goal is not reached.
        """
        steps = info["steps"] if isinstance(info, dict) else np.array([one["steps"] for one in info])
        return np.logical_and(steps == self.mdp.max_steps, ~self.compute_terminated(achieved_goal, desired_goal, info))


def as_goals(n: int, seen: Any) -> dict[str, Any]:
    """The dictionary of a goal environment, of new arrays, for 2 n numbers (or several rows of them)."""
    switches, goal = seen[..., :n].astype(np.int8), seen[..., n:].astype(np.int8)
    return {"observation": switches, "achieved_goal": switches.copy(), "desired_goal": goal}

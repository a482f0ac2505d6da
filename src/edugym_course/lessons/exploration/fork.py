"""A wall with two branches, to look for detachment: does the novelty agent give up one of two frontiers?"""

from collections.abc import Mapping
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.experiments.figures import Sheet, VisitMap
from edugym.experiments.repeat import repeat
from edugym.experiments.results.claims import Above, Below, Claim
from edugym.experiments.results.statistics import mean_interval, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Random
from edugym.rendering.icons import flag, smiley
from edugym.rendering.palette import CRACK, GRASS, SKY, STONE, WALL
from edugym.rendering.scene import Circle, Rectangle, Scene, Shape
from edugym.training.visits import record_visits
from edugym_course.lessons.exploration.climbs import frontier
from edugym_course.lessons.exploration.methods import METHODS, N_STEPS, NOVELTY, Maker, visits_of

HEIGHT = 100
MOST_LEVELS = 10
"""The number of levels in the picture."""


class Fork(NamedTuple):
    """Two walls of the same height side by side; the only reward is at the top of the right one.

    On the ground action 0 leads to the left wall and action 1 to the right one. On a wall one of two grips holds, as on
    Boulder, and the other one ends on the ground. At the top of the left wall both do.

    Attributes:
        height: H, the height of both walls.
        grips: shape (2 H,): the right action in each state.
        max_steps: the step limit.
    """

    height: int
    grips: Integers
    max_steps: int

    def initial(self, rng: Random) -> int:
        """Start on the ground, 0. The positions of the left wall are 1 to H, those of the right one H + 1 to 2 H."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """Choose a wall on the ground; take a grip on the wall."""
        if state == 0:
            return 1 + action * self.height
        return state + 1 if action == self.grips[state] and state != self.height else 0

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """Return 1 at the top of the right wall, else 0."""
        return 1.0 if next_state == 2 * self.height else 0.0

    def terminal(self, state: int) -> bool:
        """Whether the climber is at the top of the right wall."""
        return state == 2 * self.height

    def observation(self, state: int, rng: Random) -> int:
        """Return the position."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The positions on both walls, and the ground."""
        return spaces.Discrete(2 * self.height + 1)

    @property
    def action_space(self) -> spaces.Discrete:
        """The two grips."""
        return spaces.Discrete(2)

    @classmethod
    def create(cls, height: int = HEIGHT, layout_seed: int = 0) -> "Fork":
        """Draw the right grips from the seed. An episode has at most 10 times the height steps, as on Boulder."""
        return cls(height, np.random.default_rng(layout_seed).integers(0, 2, 2 * height), 10 * height)

    def scene(self, state: int) -> Scene:
        """Draw both walls from the front, as far as they fit; the grips that hold are grey.

        The climber stands below the two grips that it can reach.
        """
        level = (state - 1) % self.height + 1 if state > 0 else 0
        shown = min(self.height, MOST_LEVELS)
        first = min(max(0, level - shown // 2), self.height - shown)
        bottom = shown + 2.0
        shapes: list[Shape] = []
        for branch, left in enumerate((0.5, 4.5)):
            shapes.append(Rectangle(left, 1.6 if first + shown == self.height else -1.0, 3.0, bottom + 2.0, fill=WALL))
            for height in range(max(first, 1), first + shown):
                for grip in range(2):
                    holds = grip == self.grips[height + branch * self.height]
                    shapes.append(
                        Circle(left + 1.0 + grip, bottom - height + first, 0.3, fill=STONE if holds else CRACK)
                    )
        if first == 0:
            shapes.append(Rectangle(0.0, bottom, 8.0, 2.0, fill=GRASS))
        if first + shown == self.height:
            shapes += flag(6.5, 1.6, 1.2)
        side = 4.0 if state == 0 else 2.0 if state <= self.height else 6.0
        shapes += smiley(side, bottom - level + first + 0.5, 0.42)
        return Scene(8.0, bottom + 1.5, shapes, SKY, f"Fork: position {state}", columns=16)


def compare_on_fork(*, methods: Mapping[str, Maker] = METHODS, height: int = HEIGHT, **how: Any) -> Results:
    """Train every method on walls with two branches, and record the visits; further arguments as in `repeat`."""

    def recorded(make: Maker, environment: Any) -> Any:
        return record_visits(make(environment), environment, N_STEPS)

    agents = {label: partial(recorded, make) for label, make in methods.items()}
    return repeat(partial(Fork.create, height), agents, N_STEPS, **how)


def branches(visits: Integers) -> tuple[Integers, Integers]:
    """Return the visits of the left and of the right branch, each of shape (n_intervals, height)."""
    height = visits.shape[1] // 2
    return visits[:, 1 : height + 1], visits[:, height + 1 :]


def returns_to(visits: Integers) -> bool:
    """Whether the second half of training visits the frontier of the first half on both branches."""
    half = len(visits) // 2
    return all(
        part[half:, np.flatnonzero(part[:half].any(axis=0))].any(axis=0).all()
        for part in branches(visits)
        if part[:half].any()
    )


def turns(visits: Integers) -> int:
    """Return how often the agent turned to the other branch: the changes of the branch with more visits."""
    left, right = (part.sum(axis=1) for part in branches(visits))
    return int(np.count_nonzero(np.diff(left > right)))


def higher_frontier(visits: Integers) -> int:
    """Return how high the agent got on the branch on which it got higher."""
    return max(int(part.any(axis=0).sum()) for part in branches(visits))


def fork_claims(results: Results, one_wall: Results) -> list[Claim]:
    """Return the claims on the two branches.

    Args:
        results: the results on both branches.
        one_wall: the results on a single wall of the same height.
    """
    runs = visits_of(results, NOVELTY)
    higher = [higher_frontier(run) for run in runs]
    return [
        Claim(
            "On a wall with two branches the novelty agent turns from one frontier to the other",
            "changes of the branch with more visits, of 99 possible",
            mean_interval([turns(run) for run in runs]),
            Above(5.0),
        ),
        Claim(
            "The novelty agent returns to both frontiers: no detachment with a table",
            "share of runs that return to both frontiers of the first half of training",
            share_interval([returns_to(run) for run in runs]),
            Above(0.5),
            "a bonus β/√n fades but never ends, and a table does not forget the way",
        ),
        Claim(
            "The higher of two frontiers is lower than the frontier of a single wall",
            "height of the higher frontier less that of the frontier on a single wall",
            paired_difference(higher, [frontier(run) for run in visits_of(one_wall, NOVELTY)]),
            Below(-5.0),
            "the novelty agent divides its steps between the two branches",
        ),
    ]


def fork_maps(visits: Integers, shown: int = 40) -> Sheet:
    """Return where one run is in the course of training, on both branches.

    Args:
        visits: the visits of the run.
        shown: the number of positions of each branch to show.
    """
    return Sheet(
        "fork",
        [
            [
                VisitMap(
                    np.column_stack([visits[:, 0], part])[:, : shown + 1], N_STEPS, f"{name} branch, one run", "height"
                )
                for name, part in zip(("left", "right"), branches(visits), strict=True)
            ]
        ],
    )

"""Hindsight: which goals an agent learns for when an episode is over, besides the one that it pursued.

A task with goals has a `goal_space` (see `edugym.mdp.protocol`): the second half of an observation is the goal, and the
first half what has been achieved. Agents that learn in hindsight put what was achieved later in the place of the goal.
"""

import math
from typing import Annotated, Any, NamedTuple, Protocol

from edugym.agents.settings import Range, check
from edugym.checks.interfaces import SHAPED
from edugym.checks.parameters import in_short
from edugym.mdp.tabular import table_sizes
from edugym.mdp.task import is_shape, task_of


class Hindsight(Protocol):
    """A strategy S of Andrychowicz et al.: it samples goals from an episode that is over."""

    @property
    def goals(self) -> int:
        """For how many goals each step of the episode is learned again."""

    def achieved_after(self, t: int, length: int, draw: float) -> int:
        """The number of the step after which the goal was achieved.

        Args:
            t: the number of the step that is learned again, from 0.
            length: how many steps the episode had.
            draw: a random number, uniform on [0, 1).
        """


class NoHindsight(NamedTuple):
    """No other goals: only what was pursued is learned."""

    @property
    def goals(self) -> int:
        """None."""
        return 0

    def achieved_after(self, t: int, length: int, draw: float) -> int:
        """Not asked for."""
        return t


class FinalGoal(NamedTuple):
    """'final': what the last step of the episode achieved."""

    @property
    def goals(self) -> int:
        """One."""
        return 1

    def achieved_after(self, t: int, length: int, draw: float) -> int:
        """The last step."""
        return length - 1


class FutureGoals(NamedTuple):
    """'future': what random later steps of the episode, or the step itself, achieved.

    Attributes:
        goals: k, how many for each step, from 1 to 1000.
    """

    goals: Annotated[int, Range(1, 1000)] = 4

    def achieved_after(self, t: int, length: int, draw: float) -> int:
        """Any step from t on, each as likely."""
        return t + int(draw * (length - t))


def check_hindsight(hindsight: Any) -> None:
    """Check that something is a strategy of hindsight, with settings in their ranges.

    Raises:
        ValueError: it is not.
    """
    if isinstance(hindsight, type) or not hasattr(hindsight, "achieved_after"):
        raise ValueError(
            f"hindsight must be NoHindsight(), FinalGoal() or FutureGoals(4), but is {in_short(hindsight)}"
        )
    check(hindsight)


def goal_sizes(environment: Any) -> tuple[int, ...]:
    """How many values each number of a goal takes; empty for a task without goals, or for a mere shape."""
    if is_shape(environment):
        return ()
    space = getattr(task_of(environment, allowed=SHAPED).played, "goal_space", None)
    return () if space is None else table_sizes(space)


def number_of_goals(environment: Any, n_states: int) -> int:
    """How many goals a task has, for a table of `n_states` rows (state, goal); 1 if its goal never changes.

    Raises:
        ValueError: it has goals, but its rows are no pairs of them.
    """
    n_goals = math.prod(goal_sizes(environment))
    if n_goals > 1 and n_goals * n_goals != n_states:
        raise ValueError(
            f"environment must show a pair (state, goal), {n_goals}² rows of a table, but has {n_states}: wrappers must"
            " leave it as it is"
        )
    return n_goals


def size_of_goal(environment: Any, n_inputs: int) -> int:
    """How many of the `n_inputs` numbers of an observation are the goal: the last ones, or none.

    Raises:
        ValueError: the task has goals, but they are not half of what it shows.
    """
    size = sum(goal_sizes(environment))
    if size > 0 and 2 * size != n_inputs:
        raise ValueError(
            f"environment must show a pair (state, goal), {size} numbers each, but shows {n_inputs}: wrappers must"
            " leave it as it is"
        )
    return size

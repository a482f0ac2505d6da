"""How much an agent plans between two steps: a number of updates, or a time."""

import math
import time
from typing import Annotated, Any, NamedTuple, Protocol

from edugym.agents.settings import Part
from edugym.checks.parameters import MOST_STEPS, above, whole_number


class Budget(Protocol):
    """What planning may cost between two steps."""

    def start(self) -> float:
        """The moment at which planning begins, in seconds."""

    def lasts(self, done: int, began: float) -> bool:
        """Whether another update may be made, after `done` since `began`."""


class Updates(NamedTuple):
    """So many updates.

    Attributes:
        n: how many, 0 or more; infinity for as many as there are to do.
    """

    n: float

    def start(self) -> float:
        """No clock is needed."""
        return 0.0

    def lasts(self, done: int, began: float) -> bool:
        """Until there are n."""
        return done < self.n


class Seconds(NamedTuple):
    """So much time on the wall clock, as when `step` blocks meanwhile (Supermarket's `step_timeout`).

    Machine code has no clock: an agent with this budget runs interpreted.

    Attributes:
        seconds: how long, greater than 0.
    """

    seconds: float

    def start(self) -> float:
        """Look at the clock."""
        return time.perf_counter()

    def lasts(self, done: int, began: float) -> bool:
        """Until the time is over."""
        return time.perf_counter() - began < self.seconds


Planning = Annotated[Budget, Part()]


def budget(planning_steps: float, planning_seconds: float | None) -> Any:
    """The planning budget; if seconds are given, they count instead of the steps.

    Raises:
        ValueError: the steps are no whole number of 0 or more (or infinity), or the seconds not greater than 0.
    """
    if not (isinstance(planning_steps, float) and planning_steps == math.inf):
        whole_number("planning_steps", planning_steps, 0, MOST_STEPS)
    if planning_seconds is not None:
        above("planning_seconds", planning_seconds, 0)
        return Seconds(float(planning_seconds))
    return Updates(float(planning_steps))

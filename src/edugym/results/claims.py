"""Claims: statements about what an experiment shows, each with what was measured and whether it holds.

A claim says beforehand what the whole confidence interval must do, not the estimate alone. "The method solves the task"
means that the share of its runs that solve it is above one half with confidence: `Above(0.5)`. "It does not" means that
the share is below one half with confidence. In between the data does not tell, and neither claim holds. That a figure
*equals* a theory's is claimed by a margin: the whole interval lies `Within(low, high)` around it (an equivalence test;
an interval that merely contains the figure is one that too little data makes wide).
"""

from typing import NamedTuple, TypeAlias

from edugym.results.statistics import Interval, in_short


class Above(NamedTuple):
    """The interval lies above a threshold."""

    threshold: float

    def holds(self, interval: Interval) -> bool:
        """Whether it does."""
        return interval.low > self.threshold

    def __str__(self) -> str:
        """What is asked, in short."""
        return f"> {in_short(self.threshold)}"


class Below(NamedTuple):
    """The interval lies below a threshold."""

    threshold: float

    def holds(self, interval: Interval) -> bool:
        """Whether it does."""
        return interval.high < self.threshold

    def __str__(self) -> str:
        """What is asked, in short."""
        return f"< {in_short(self.threshold)}"


class Within(NamedTuple):
    """The interval lies within bounds."""

    low: float
    high: float

    def holds(self, interval: Interval) -> bool:
        """Whether it does."""
        return self.low <= interval.low and interval.high <= self.high

    def __str__(self) -> str:
        """What is asked, in short."""
        return f"{in_short(self.low)} to {in_short(self.high)}"


Expectation: TypeAlias = Above | Below | Within


class Claim(NamedTuple):
    """A statement about an experiment, with what was measured.

    Attributes:
        statement: what is claimed, in one sentence.
        quantity: what was measured, and of how many.
        measured: the estimate with its 95 % interval.
        expected: where the interval must lie for the claim to hold.
        reason: why it is so or, where the paper says something else, why not; may be empty.
    """

    statement: str
    quantity: str
    measured: Interval
    expected: Expectation
    reason: str = ""

    @property
    def holds(self) -> bool:
        """Whether the data shows it; what was not measured does not hold."""
        return self.measured.n > 0 and self.expected.holds(self.measured)

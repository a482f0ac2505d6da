"""Claims: statements about an experiment, each with its measurement and whether it holds.

A claim states beforehand where the whole confidence interval must lie, not only the estimate. "The method solves the
task" means that the share of its runs that solve it is above one half with confidence: `Above(0.5)`. "It does not solve
the task" means that the share is below one half with confidence. In between the data cannot tell, and neither claim
holds. A claim that a number *equals* a theory's has a margin: the whole interval lies `Within(low, high)` around it.
(This is an equivalence test. To ask only that the interval contains the number would reward too little data.)
"""

from typing import NamedTuple, TypeAlias

from edugym.results.statistics import Interval, in_short


class Above(NamedTuple):
    """The interval lies above a threshold."""

    threshold: float

    def holds(self, interval: Interval) -> bool:
        """Whether an interval does."""
        return interval.low > self.threshold

    def __str__(self) -> str:
        """The condition, in short."""
        return f"> {in_short(self.threshold)}"


class Below(NamedTuple):
    """The interval lies below a threshold."""

    threshold: float

    def holds(self, interval: Interval) -> bool:
        """Whether an interval does."""
        return interval.high < self.threshold

    def __str__(self) -> str:
        """The condition, in short."""
        return f"< {in_short(self.threshold)}"


class Within(NamedTuple):
    """The interval lies within bounds."""

    low: float
    high: float

    def holds(self, interval: Interval) -> bool:
        """Whether an interval does."""
        return self.low <= interval.low and interval.high <= self.high

    def __str__(self) -> str:
        """The condition, in short."""
        return f"{in_short(self.low)} to {in_short(self.high)}"


Expectation: TypeAlias = Above | Below | Within


def beginning(name: str) -> str:
    """Return a method's name as it begins a sentence: with a capital letter."""
    return f"{name[:1].upper()}{name[1:]}"


class Claim(NamedTuple):
    """A statement about an experiment, with its measurement.

    Attributes:
        statement: the claim, in one sentence.
        quantity: the name of the measured quantity.
        measured: the estimate with its 95 % interval.
        expected: where the interval must lie for the claim to hold.
        reason: why the claim holds or, where the paper says something else, why it differs; may be empty.
    """

    statement: str
    quantity: str
    measured: Interval
    expected: Expectation
    reason: str = ""

    @property
    def holds(self) -> bool:
        """Whether the data shows it; a claim without data does not hold."""
        return self.measured.n > 0 and self.expected.holds(self.measured)

"""Claims: statements about an experiment, each with its measurement and whether it holds.

A claim says in which range a measured number must lie. This range is written in the code: it does not depend on the
measured number. The claim holds only if the whole confidence interval lies in the range; the estimate alone is not
enough.

"The method solves the task" means that the share of runs that solve it is above one half: the whole interval of this
share must lie above 0.5, `Above(0.5)`. "It does not solve the task" means that the whole interval lies below 0.5. If
the interval contains 0.5, the data cannot decide, and neither claim holds.

`Within(low, high)` means that the whole interval lies between two bounds. We also use it for claims that a number
*equals* a prediction. If the number is an estimate, such a claim allows a margin: one bound below the prediction and
one above. (This is an equivalence test. It is not enough that the interval contains the prediction: with little data
the interval is so wide that it contains almost any number.) If the number is exact, both bounds may be the prediction
itself.
"""

from typing import Any, NamedTuple, TypeAlias

from edugym.checks.parameters import a_number, a_text, several
from edugym.checks.parameters import in_short as shown
from edugym.experiments.results.statistics import Interval, in_short


class Above(NamedTuple):
    """The interval lies above a threshold."""

    threshold: float

    def holds(self, interval: Interval) -> bool:
        """Whether an interval lies above the threshold.

        Raises:
            ValueError: it is no interval, or the threshold no finite number.
        """
        return an_interval("interval", interval).low > a_number("threshold", self.threshold)

    def __str__(self) -> str:
        """The condition, in short."""
        return f"> {in_short(self.threshold)}"


class Below(NamedTuple):
    """The interval lies below a threshold."""

    threshold: float

    def holds(self, interval: Interval) -> bool:
        """Whether an interval lies below the threshold.

        Raises:
            ValueError: it is no interval, or the threshold no finite number.
        """
        return an_interval("interval", interval).high < a_number("threshold", self.threshold)

    def __str__(self) -> str:
        """The condition, in short."""
        return f"< {in_short(self.threshold)}"


class Within(NamedTuple):
    """The interval lies within bounds."""

    low: float
    high: float

    def holds(self, interval: Interval) -> bool:
        """Whether an interval lies within the bounds.

        Raises:
            ValueError: it is no interval, or a bound no finite number.
        """
        low, high = a_number("low", self.low), a_number("high", self.high)
        return low <= an_interval("interval", interval).low and interval.high <= high

    def __str__(self) -> str:
        """The condition, in short."""
        return f"{in_short(self.low)} to {in_short(self.high)}"


Expectation: TypeAlias = Above | Below | Within


def an_interval(name: str, value: Any) -> Interval:
    """Refuse a `value` that is not an `Interval`."""
    if not isinstance(value, Interval):
        raise ValueError(f"{name} must be an Interval, such as mean_interval(values), but is {shown(value)}")
    return value


def beginning(name: str) -> str:
    """The name of an algorithm with a capital first letter, for the start of a sentence."""
    return f"{name[:1].upper()}{name[1:]}"


class Claim(NamedTuple):
    """A statement about an experiment, with its measurement.

    Attributes:
        statement: the claim, in one sentence.
        quantity: the name of the measured quantity.
        measured: the estimate with its 95 % interval. If the number is exact, the interval is this number alone.
        expected: where the interval must lie for the claim to hold.
        reason: what brings the effect about, as we believe, without the word "because". It may be empty.
        tested_by: the statements of the claims that test the reason: in their experiments the cause is removed or
            varied, and the effect goes or follows. Without one the reason is a guess, and reports call it so.
        remark: what else a reader should know, such as what the paper says. It claims no cause. It may be empty.
    """

    statement: str
    quantity: str
    measured: Interval
    expected: Expectation
    reason: str = ""
    tested_by: tuple[str, ...] = ()
    remark: str = ""

    @property
    def holds(self) -> bool:
        """Whether the data supports the claim. Without data it does not hold.

        Raises:
            ValueError: an attribute is not as above.
        """
        for name in ("statement", "quantity", "reason", "remark"):
            a_text(name, getattr(self, name))
        several("tested_by", self.tested_by, str, "a tuple of texts")
        an_interval("measured", self.measured)
        if not isinstance(self.expected, Expectation):
            given = shown(self.expected)
            raise ValueError(f"expected must be Above(...), Below(...) or Within(...), but is {given}")
        return self.measured.n > 0 and self.expected.holds(self.measured)

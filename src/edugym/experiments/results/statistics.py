"""Means and shares with their intervals.

The result of one run says little: the next seed gives another. Reports therefore give an estimate over repetitions
with a 95 % confidence interval. If the whole experiment were repeated many times with new seeds, 95 of 100 such
intervals would contain the true value.

* A mean over repetitions has Student's t interval: mean ± t(n - 1) s / √n. It is exact for normal values, and good for
  values that are not too skewed.
* A share (how many runs solved the task) has Wilson's interval, which does not shrink to nothing when all runs or none
  solved it: 10 of 10 gives 0.72 to 1.
* Two methods are compared by their differences within each repetition, where both had the same seed and layout, so that
  the effect of a hard layout on both drops out. The interval is Student's t interval of these differences.

There is no bootstrap: with the usual 10 to 30 repetitions its percentile intervals are too narrow.

References: Wilson (1927), Probable inference, the law of succession, and statistical inference; Brown, Cai and DasGupta
(2001), Interval estimation for a binomial proportion; Student (1908), The probable error of a mean.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from edugym.checks.parameters import a_number, an_array, between, true_or_false, whole_number
from edugym.mdp.protocol import Reals
from edugym.system.extras import require

CONFIDENCE = 0.95
MOST_TRIALS = 10**12


class Interval(NamedTuple):
    """An estimate with its confidence interval.

    Attributes:
        estimate: the mean, share or difference; NaN when nothing was measured.
        low: the lower end; -inf when there is too little data.
        high: the upper end; inf when there is too little data.
        n: the number of values.
    """

    estimate: float
    low: float
    high: float
    n: int

    def __str__(self) -> str:
        """The estimate, and the interval in brackets."""
        if self.n == 0:
            return "not measured"
        return f"{in_short(self.estimate)} [{in_short(self.low)}, {in_short(self.high)}]"


def exactly(value: float) -> Interval:
    """The interval of a value that is computed and not estimated: a point.

    Raises:
        ValueError: it is no finite number.
    """
    a_number("value", value)
    return Interval(value, value, value, 1)


def in_short(number: float) -> str:
    """Format a number with three significant digits, or a large one as a whole number."""
    return f"{number:.3g}" if abs(number) < 999.5 else f"{number:.0f}"


def mean_interval(values: ArrayLike, confidence: float = CONFIDENCE) -> Interval:
    """The mean of independent values, with Student's t interval.

    Args:
        values: one value of each repetition, in any shape; NaN means no value.
        confidence: the share of such intervals that contain the true mean, between 0 and 1.

    Returns:
        The interval; unbounded for a single value.

    Raises:
        ValueError: the values are no numbers, or the confidence is not between 0 and 1.
    """
    between("confidence", confidence, 0, 1)
    known = an_array("values", values).ravel()
    known = known[~np.isnan(known)]
    if len(known) < 2:
        return Interval(float(known[0]) if len(known) else math.nan, -math.inf, math.inf, len(known))
    require("experiments", "scipy")
    from scipy.special import stdtrit  # scipy.stats has it too, but takes half a second to import

    mean = float(known.mean())
    margin = float(stdtrit(len(known) - 1, (1 + confidence) / 2) * known.std(ddof=1) / math.sqrt(len(known)))
    return Interval(mean, mean - margin, mean + margin, len(known))


def proportion_interval(successes: int, n: int, confidence: float = CONFIDENCE) -> Interval:
    """The share of successes in independent trials, with Wilson's interval.

    Args:
        successes: the number of trials that succeeded, from 0 to `n`.
        n: the number of trials, from 0 to a million million.
        confidence: the share of such intervals that contain the true probability, between 0 and 1.

    Returns:
        The interval; from 0 to 1 without any trial.

    Raises:
        ValueError: a number is out of its range.
    """
    n = whole_number("n", n, 0, MOST_TRIALS)
    successes = whole_number("successes", successes, 0, n)
    between("confidence", confidence, 0, 1)
    if n == 0:
        return Interval(math.nan, 0.0, 1.0, 0)
    require("experiments", "scipy")
    from scipy import stats

    ends = stats.binomtest(int(successes), int(n)).proportion_ci(confidence, method="wilson")
    return Interval(successes / n, float(ends.low), float(ends.high), int(n))


def share_interval(values: ArrayLike, confidence: float = CONFIDENCE) -> Interval:
    """The share of ones among values that are 0 or 1, with Wilson's interval.

    Args:
        values: shape (n,): 1 for a success and 0 for a failure; NaN means no value.
        confidence: as in `proportion_interval`.

    Raises:
        ValueError: a value is neither 0 nor 1.
    """
    known = an_array("values", values).ravel()
    known = known[~np.isnan(known)]
    if not np.isin(known, (0.0, 1.0)).all():
        raise ValueError(f"values of a share must be 0 or 1, but there is {known[~np.isin(known, (0.0, 1.0))][0]}")
    return proportion_interval(int(known.sum()), len(known), confidence)


def paired_difference(first: ArrayLike, second: ArrayLike, confidence: float = CONFIDENCE) -> Interval:
    """The mean of `first` minus `second` within each repetition, with Student's t interval.

    Args:
        first: shape (n,): one value of each repetition of a method; NaN means no value.
        second: shape (n,): the values of another method, in the same order, with the same seeds and layouts.
        confidence: as in `mean_interval`.

    Raises:
        ValueError: they are no numbers, or have different lengths.
    """
    one = an_array("first", first)
    other = an_array("second", second, one.shape)
    return mean_interval(one - other, confidence)


def by_point(values: Reals, *, share: bool = False) -> Reals:
    """The interval at each point of a learning curve.

    Args:
        values: shape (n_points, n_repetitions); NaN where a repetition has no value.
        share: whether the values are successes (1) and failures (0), so that their mean is a share.

    Returns:
        Shape (n_points, 3): estimate, lower and upper end; NaN where there is too little data.

    Raises:
        ValueError: a parameter is not as above.
    """
    true_or_false("share", share)
    values = an_array("values", values, ("n_points", "n_repetitions"))
    interval = share_interval if share else mean_interval
    ends = np.array([interval(row)[:3] for row in values]).reshape(-1, 3)
    return np.where(np.isfinite(ends), ends, np.nan)

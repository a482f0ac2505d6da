"""Means and shares with their intervals.

A result of one run says little: the next seed gives another. What is reported is therefore an estimate over repetitions
with a 95 % confidence interval: were the whole experiment done again and again with new seeds, 95 of 100 such intervals
would contain the true value.

* A mean over repetitions has Student's t interval: mean ± t(n - 1) s / √n. Exact where the values are normal, and good
  where they are not too skew.
* A share (how many runs solved the task) has Wilson's interval, which does not shrink to nothing when all or none did:
  10 of 10 gives 0.72 to 1.
* Two methods are compared by their differences within each repetition, where they had the same seed and layout: what
  a hard layout does to both drops out. The interval is Student's t of these differences.

There is no bootstrap: with the 10 to 30 repetitions that are usual here its percentile intervals are too narrow.

References: Wilson (1927), Probable inference, the law of succession, and statistical inference; Brown, Cai and DasGupta
(2001), Interval estimation for a binomial proportion; Student (1908), The probable error of a mean.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from edugym.extras import require
from edugym.checks import whole_number
from edugym.mdp.protocol import Reals

CONFIDENCE = 0.95


class Interval(NamedTuple):
    """An estimate with its confidence interval.

    Attributes:
        estimate: the mean, share or difference; NaN when nothing was measured.
        low: the lower end; -inf when the data says nothing about it.
        high: the upper end; inf when the data says nothing about it.
        n: from how many values it comes.
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


def in_short(number: float) -> str:
    """A number with three significant digits, or as a whole one where it is large."""
    return f"{number:.3g}" if abs(number) < 1_000 or math.isinf(number) else f"{number:.0f}"


def mean_interval(values: ArrayLike, confidence: float = CONFIDENCE) -> Interval:
    """The mean of independent values, with Student's t interval.

    Args:
        values: shape (n,): one value of each repetition; NaN means that there is none.
        confidence: the share of such intervals that contain the true mean, between 0 and 1.

    Returns:
        The interval; unbounded for a single value.
    """
    known = np.asarray(values, float).ravel()
    known = known[~np.isnan(known)]
    if len(known) < 2:
        return Interval(float(known[0]) if len(known) else math.nan, -math.inf, math.inf, len(known))
    require("experiments", "scipy")
    from scipy import stats

    mean = float(known.mean())
    margin = float(stats.t.ppf((1 + confidence) / 2, len(known) - 1) * known.std(ddof=1) / math.sqrt(len(known)))
    return Interval(mean, mean - margin, mean + margin, len(known))


def proportion_interval(successes: int, n: int, confidence: float = CONFIDENCE) -> Interval:
    """The share of successes in independent trials, with Wilson's interval.

    Args:
        successes: how many trials succeeded, from 0 to `n`.
        n: how many trials there were, 0 or more.
        confidence: the share of such intervals that contain the true probability, between 0 and 1.

    Returns:
        The interval; from 0 to 1 when there was no trial.

    Raises:
        ValueError: a number is not as above.
    """
    whole_number("n", n, 0)
    whole_number("successes", successes, 0, n)
    if n == 0:
        return Interval(math.nan, 0.0, 1.0, 0)
    require("experiments", "scipy")
    from scipy import stats

    ends = stats.binomtest(int(successes), int(n)).proportion_ci(confidence, method="wilson")
    return Interval(successes / n, float(ends.low), float(ends.high), int(n))


def share_interval(values: ArrayLike, confidence: float = CONFIDENCE) -> Interval:
    """The share of ones among values that are 0 or 1, with Wilson's interval.

    Args:
        values: shape (n,): 1 for a success and 0 for none; NaN means that there is no value.
        confidence: as in `proportion_interval`.

    Raises:
        ValueError: a value is neither 0 nor 1.
    """
    known = np.asarray(values, float).ravel()
    known = known[~np.isnan(known)]
    if not np.isin(known, (0.0, 1.0)).all():
        raise ValueError(f"values of a share must be 0 or 1, but there is {known[~np.isin(known, (0.0, 1.0))][0]!r}")
    return proportion_interval(int(known.sum()), len(known), confidence)


def paired_difference(first: ArrayLike, second: ArrayLike, confidence: float = CONFIDENCE) -> Interval:
    """How much more `first` is than `second` on average, by their differences within each repetition.

    Args:
        first: shape (n,): one value of each repetition of a method; NaN means that there is none.
        second: shape (n,): those of another method, in the same order, with the same seeds and layouts.
        confidence: as in `mean_interval`.

    Raises:
        ValueError: the two have different lengths.
    """
    one, other = np.asarray(first, float), np.asarray(second, float)
    if one.shape != other.shape:
        raise ValueError(f"second must have the shape of first, {one.shape}, but has {other.shape}")
    return mean_interval(one - other, confidence)


def by_point(values: Reals, *, share: bool = False) -> Reals:
    """The interval at each point of a learning curve.

    Args:
        values: shape (n_points, n_repetitions); NaN where a repetition has no value.
        share: whether the values are successes (1) and failures (0), so that their mean is a share.

    Returns:
        Shape (n_points, 3): estimate, lower and upper end; NaN where the data says nothing.
    """
    interval = share_interval if share else mean_interval
    ends = np.array([interval(row)[:3] for row in values]).reshape(-1, 3)
    return np.where(np.isfinite(ends), ends, np.nan)

"""Intervals: numbers worked out by hand, and how often they contain the truth."""

import math
from collections.abc import Callable

import numpy as np
import pytest

from edugym.experiments.results import statistics as stats
from edugym.experiments.results.claims import Above, Below, Claim, Within, beginning
from edugym.experiments.results.statistics import Interval, by_point, exactly, mean_interval, proportion_interval


@pytest.mark.parametrize(
    ("found", "estimate", "margin", "n"),
    [
        (mean_interval([1, 2, 3, 4, 5]), 3, 2.776445 * math.sqrt(0.5), 5),  # s is √2.5, t(4) 2.7764
        (mean_interval([1, 2, 3, 4, 5], 0.5), 3, 0.740697 * math.sqrt(0.5), 5),  # t(4) for half the confidence
        (stats.paired_difference([11, 22, 33], [10, 20, 30]), 2, 4.302653 / math.sqrt(3), 3),  # s is 1, t(2) 4.3027
        (stats.paired_difference([1, 2, 3, 4, 5], [0, 0, 0, 0, 0], 0.5), 3, 0.523752, 5),
        (proportion_interval(2, 4, 0.5), 0.5, 0.159781, 4),
        (stats.share_interval([1, 0, 1, 0], 0.5), 0.5, 0.159781, 4),
        (mean_interval([7.0]), 7, math.inf, 1),  # a single run has no bounds
        (mean_interval([]), math.nan, math.inf, 0),
        (mean_interval([1, math.nan, 3]), 2, mean_interval([1, 3]).high - 2, 2),  # NaN: a run that was interrupted
    ],
)
def test_intervals_by_hand(found: Interval, estimate: float, margin: float, n: int) -> None:
    """Student's, and for shares Wilson's: as wide below as above the estimate; missing values do not count."""
    assert found.estimate == pytest.approx(estimate, nan_ok=True)
    middle = 0 if math.isnan(estimate) else estimate
    assert (found.low, found.high, found.n) == pytest.approx((middle - margin, middle + margin, n), abs=1e-5)


@pytest.mark.parametrize(
    ("successes", "n", "low", "high"),
    [
        (10, 10, 10 / (10 + 1.959964**2), 1.0),  # Wilson's bounds have this closed form at the ends
        (0, 10, 0.0, 1.959964**2 / (10 + 1.959964**2)),
        (0, 0, 0.0, 1.0),
        (8, 10, 0.490162, 0.943318),  # (p + z²/2n ± z √(p(1-p)/n + z²/4n²)) / (1 + z²/n)
    ],
)
def test_share_has_wilsons_interval(successes: int, n: int, low: float, high: float) -> None:
    """By the formula, which keeps room for doubt where all or none succeeded."""
    interval = proportion_interval(successes, n)
    assert interval.estimate == successes / n if n else math.isnan(interval.estimate)
    assert (interval.low, interval.high) == pytest.approx((low, high), abs=1e-6)
    assert n == 0 or stats.share_interval([1] * successes + [0] * (n - successes) + [math.nan]) == interval


@pytest.mark.parametrize(
    ("call", "names"),
    [
        (lambda: proportion_interval(3, 2), "successes .* 3"),
        (lambda: proportion_interval(-1, 2), "successes .* -1"),
        (lambda: proportion_interval(0, -1), "^n .* -1"),
        (lambda: mean_interval([1, 2], 1.5), "confidence .* 1.5"),
        (lambda: stats.share_interval([0, 1, 0.5]), r"0 or 1.*0\.5"),
        (lambda: stats.paired_difference([1, 2], [1, 2, 3]), r"second .*\(2,\).*\[1, 2, 3\]"),
    ],
)
def test_what_cannot_be_is_refused(call: Callable[[], Interval], names: str) -> None:
    """With its name and value."""
    with pytest.raises(ValueError, match=names):
        call()


def test_points_of_a_curve() -> None:
    """One row a point; a point with a single value has no band."""
    values = np.array([[0.0, 1.0, 1.0], [math.nan, math.nan, 1.0]])
    assert by_point(values)[0].tolist() == list(mean_interval([0, 1, 1])[:3])
    assert by_point(values, share=True)[0].tolist() == list(proportion_interval(2, 3)[:3])
    assert by_point(values)[1][0] == 1.0
    assert np.isnan(by_point(values)[1][1:]).all()
    assert by_point(values[:0]).shape == (0, 3)


@pytest.mark.parametrize(
    ("expected", "low", "high", "holds"),
    [(Above(0.5), 0.51, 1.0, True), (Above(0.5), 0.5, 1.0, False), (Below(0.5), 0.0, 0.5, False),
     (Below(0.5), 0.0, 0.49, True), (Within(1, 2), 1, 2, True), (Within(1, 2), 0.9, 1.9, False),
     (Within(1, 2), 1.1, 2.1, False)],
)  # fmt: skip
def test_claims_ask_the_whole_interval(expected: Above | Below | Within, low: float, high: float, holds: bool) -> None:
    """An estimate on the right side is not enough."""
    interval = Interval((low + high) / 2, low, high, 10)
    assert Claim("it is so", "share", interval, expected).holds is holds


def test_expectations_in_words() -> None:
    """As the tables of a report have them."""
    assert [str(one) for one in (Above(0.5), Below(-2), Within(0.9, 1234.5))] == ["> 0.5", "< -2", "0.9 to 1234"]
    assert exactly(0.25) == (0.25, 0.25, 0.25, 1)
    assert str(exactly(1 / 3)) == "0.333 [0.333, 0.333]"
    assert Claim("it is so", "value", exactly(0.25), Within(0.25, 0.25)).holds
    assert not Claim("it is so", "share", proportion_interval(0, 0), Above(-1)).holds
    assert (beginning("double SARSA"), beginning("")) == ("Double SARSA", "")


@pytest.mark.parametrize(
    ("interval", "shown"),
    [
        (Interval(2046.4, 1999.6, 2100.2, 4), "2046 [2000, 2100]"),
        (Interval(999.5, 999.4, 1000.0, 4), "1000 [999, 1000]"),
        (Interval(-999.9, -1000.0, -999.4, 4), "-1000 [-1000, -999]"),
        (Interval(7.0, -math.inf, math.inf, 1), "7 [-inf, inf]"),
        (mean_interval([]), "not measured"),
    ],
)
def test_intervals_are_shown_in_short(interval: Interval, shown: str) -> None:
    """Three digits, and large numbers in full."""
    assert str(interval) == shown

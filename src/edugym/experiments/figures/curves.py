"""Learning curves."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from edugym.checks.parameters import a_number, a_text, an_array, in_short, one_of, several, true_or_false, whole_number
from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.style import (
    REFERENCE,
    SOFT_REFERENCE,
    Stroke,
    add_legend,
    axes_or_new,
    dress,
    format_steps,
    plot_with_band,
    strokes_of,
)
from edugym.experiments.results.statistics import by_point
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Reals

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LABELS = {
    "return": "return (greedy)",
    "training_return": "return (while exploring)",
    "episodes": "episodes ended",
}
MOST_SMOOTHED = 1_000_000
SHARE_LABEL = "share of runs with return 1 (greedy)"


class Curves(NamedTuple):
    """The learning curve of each method: the mean over repetitions, with its 95 % confidence interval as a band.

    Attributes:
        results: the results to draw.
        title: the text above the axes.
        column: "return" (of evaluation episodes, played without exploring), "training_return" (of the training
            episodes, explored as the method does) or "episodes" (that ended since the point before).
        methods: the labels of the methods to draw; None draws all. Their order gives the colours, so that figures with
            the same methods have the same colours.
        share: whether every value is 1 or 0, so that the mean is a share; the band is then Wilson's interval.
        optimum: the best possible value, drawn as a dashed line; None draws none.
        soft_optimum: the best value of a policy that goes on exploring, drawn as a dotted line; None draws none.
        soft_label: what the legend calls it.
        smooth: the number of points to average, from 1 to 1 000 000, the point itself and those before it; None
            averages none. Training returns are weighted by their numbers of episodes.
        y_label: the label of the y axis; None describes the column.
        y_range: both ends of the y axis, to cut off a bad start; None shows everything.
        strokes: by label of the method, the look of its curve; else it is that of its place among the methods.
    """

    results: Results
    title: str = ""
    column: str = "return"
    methods: Sequence[str] | None = None
    share: bool = False
    optimum: float | None = None
    soft_optimum: float | None = None
    soft_label: str = "best ε-soft policy"
    smooth: int | None = None
    y_label: str | None = None
    y_range: tuple[float, float] | None = None
    strokes: Mapping[str, Stroke] | None = None

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the curves on `ax`, by default in a new figure, and return the axes.

        Raises:
            ValueError: an attribute is not as described in the class.
        """
        self._check()
        ax = axes_or_new(ax)
        for method, drawn in strokes_of(self.shown, self.strokes).items():
            steps, values = self.points(method)
            intervals = by_point(values, share=self.share and self.smooth is None)
            plot_with_band(ax, drawn, steps, intervals, method)
        if self.optimum is not None:
            ax.axhline(self.optimum, label="optimum", **REFERENCE)
        if self.soft_optimum is not None:
            ax.axhline(self.soft_optimum, label=self.soft_label, **SOFT_REFERENCE)
        default = SHARE_LABEL if self.share and self.column == "return" else LABELS[self.column]
        dress(ax, "training steps", default if self.y_label is None else self.y_label, self.title)
        if self.results.last_step:
            ax.set_xlim(0, self.results.last_step)
        if self.y_range is not None:
            ax.set_ylim(self.y_range)
        format_steps(ax)
        if place.alone:
            add_legend(ax)
        return ax

    def _check(self) -> None:
        """Refuse an attribute that is not as described in the class."""
        if not isinstance(self.results, Results):
            what = in_short(self.results)
            raise ValueError(f"results must be Results, as repeat gives or Results.load reads them, but is {what}")
        if self.methods is not None:
            for method in several("methods", self.methods, str, f"labels among {self.results.methods}"):
                one_of("methods", method, self.results.methods)
        one_of("column", self.column, list(LABELS))
        true_or_false("share", self.share)
        if self.smooth is not None:
            whole_number("smooth", self.smooth, 1, MOST_SMOOTHED)
        for name, value in (("optimum", self.optimum), ("soft_optimum", self.soft_optimum)):
            if value is not None:
                a_number(name, value)
        a_text("soft_label", self.soft_label)
        if self.y_range is not None:
            for end in an_array("y_range", self.y_range, (2,)):
                a_number("y_range", end)

    @property
    def shown(self) -> Sequence[str]:
        """The labels of the methods that are drawn, in order."""
        return self.results.methods if self.methods is None else self.methods

    def points(self, method: str) -> tuple[Integers, Reals]:
        """The steps of a method, and its curves, smoothed: shape (n_points, n_repetitions)."""
        learned = self.results.learned(method, self.column)
        if self.smooth is None:
            return learned.steps, learned.values
        weights = (~np.isnan(learned.values)).astype(float)
        if self.column == "training_return":
            weights *= self.results.learned(method, "episodes").values
        sums = [_sums(np.nan_to_num(part), self.smooth) for part in (learned.values * weights, weights)]
        with np.errstate(invalid="ignore"):  # 0 / 0 is NaN: nothing is known so far
            return learned.steps, sums[0] / sums[1]


def _sums(values: Reals, n: int) -> Reals:
    """At each point the sum of the last `n` values of each column, or of as many as there are."""
    n = max(1, min(n, len(values)))
    before = np.zeros((n - 1, values.shape[1]))
    windows = np.lib.stride_tricks.sliding_window_view(np.concatenate([before, values]), n, axis=0)
    sums: Reals = windows.sum(axis=-1)
    return sums

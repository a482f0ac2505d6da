"""What methods measure against a parameter, with intervals."""

from collections.abc import Mapping, Sequence
from itertools import cycle
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.style import (
    REFERENCE,
    SOFT_REFERENCE,
    Stroke,
    add_legend,
    axes_or_new,
    dress,
    plot_with_band,
    strokes_of,
)
from edugym.experiments.results.statistics import by_point
from edugym.mdp.protocol import Reals

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Against(NamedTuple):
    """A line with points for each method against a parameter: means over repetitions, with 95 % intervals as bands.

    Attributes:
        x: the values of the parameter, n of them.
        measured: by label of the method, one row of values for each x: shape (n, n_repetitions).
        title: the text above the axes.
        x_label: the name of the parameter.
        y_label: the label of the y axis.
        theory: by label, the values that theory predicts, shape (n,). A third line looks like the first.
        log: whether the x axis is logarithmic; then each x has a tick.
        strokes: by label, the look of a method; others look as their place among the methods says.
    """

    x: Sequence[float]
    measured: Mapping[str, Sequence[Reals]]
    title: str = ""
    x_label: str = ""
    y_label: str = ""
    theory: Mapping[str, Reals] = MappingProxyType({})
    log: bool = False
    strokes: Mapping[str, Stroke] = MappingProxyType({})

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the lines on `ax`, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        for method, drawn in strokes_of(self.measured, self.strokes).items():
            means = by_point(np.array(self.measured[method]))
            plot_with_band(ax, drawn, np.array(self.x), means, method, marker="o", markersize=3)
        for (label, line), look in zip(self.theory.items(), cycle((REFERENCE, SOFT_REFERENCE)), strict=False):
            ax.plot(self.x, line, label=label, **look)
        if self.log:
            ax.set_xscale("log")
            ax.set_xticks(self.x, [f"{x:g}" for x in self.x])
            ax.minorticks_off()
        else:
            ax.locator_params(axis="x", nbins=5)
        dress(ax, self.x_label, self.y_label, self.title)
        if place.alone:
            add_legend(ax)
        return ax

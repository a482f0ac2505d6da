"""The kinds of panels that only this lesson has."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from edugym.experiments.figures.panel import on_axes
from edugym.experiments.figures.style import GREY, REFERENCE, VERMILION, dress, stroke
from edugym.mdp.protocol import Reals

if TYPE_CHECKING:
    from matplotlib.axes import Axes

PART_COLOURS = (VERMILION, GREY)
"""The colours of the parts of a variance, which are not those of methods."""


class Series(NamedTuple):
    """Lines with points, over n.

    Attributes:
        x: shape (n,): the places of the values.
        lines: by label, the values, shape (n,).
        title: the text above the axes.
        x_label: the label of the x axis.
        y_label: the label of the y axis.
        first: the number of the stroke of the first line, so that a figure need not have the colours of methods.
        zero: whether a thin line marks zero.
    """

    x: Reals
    lines: Mapping[str, Reals]
    title: str = ""
    x_label: str = ""
    y_label: str = ""
    first: int = 0
    zero: bool = False

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the lines."""
        if self.zero:
            ax.axhline(0.0, **REFERENCE)
        for i, (name, line) in enumerate(self.lines.items(), start=self.first):
            color, dashes = stroke(i)
            ax.plot(self.x, line, color=color, linestyle=dashes, linewidth=1.6, marker="o", markersize=3, label=name)
        dress(ax, self.x_label, self.y_label, self.title)


class Parts(NamedTuple):
    """What a variance is made of, one bar for each n.

    Attributes:
        parts: by label, the parts for n = 1, 2, ..., from the lowest to the highest of a bar; shape (n,) each.
        title: the text above the axes.
        top: the end of the y axis, the same for panels that are compared; None fits it.
    """

    parts: Mapping[str, Reals]
    title: str = ""
    top: float | None = None

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the bars."""
        bottom: Reals = np.zeros(0)
        for colour, (name, part) in zip(PART_COLOURS, self.parts.items(), strict=False):
            bottom = bottom if len(bottom) else np.zeros(len(part))
            ax.bar(np.arange(1, len(part) + 1), part, 0.7, bottom, color=colour, label=name)
            bottom = bottom + part
        ax.set_xticks(np.arange(1, len(bottom) + 1))
        ax.set_ylim(0.0, self.top)
        dress(ax, "n", "variance of the target", self.title)

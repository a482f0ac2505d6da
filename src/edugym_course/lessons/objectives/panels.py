"""The picture of lesson 12: the front, what was found on it, and what weights ask for."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from edugym.exact.points import supported
from edugym.experiments.figures.panel import on_axes
from edugym.experiments.figures.style import REFERENCE, SOFT_REFERENCE, dress, stroke
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SIZES = (220, 120, 45)
"""Of the rings around what was found, the first label's outside."""


class Front(NamedTuple):
    """The value of each treasure over the steps to it: full if some weights prefer it, else hollow.

    Attributes:
        returns: shape (n, 2): the values, and the times below 0.
        title: the text above the axes.
        found: by label, the points that were found: each gets a ring.
        weights: the weights of a sum: the line of all points that are as good as the best, none if None.
        distance: the weights of a distance: the box of all points that are as close as the closest, none if None.
        limit: the most steps: a dashed line, none if None.
    """

    returns: Reals
    title: str = ""
    found: Mapping[str, Sequence[int]] = MappingProxyType({})
    weights: tuple[float, float] | None = None
    distance: tuple[float, float] | None = None
    limit: float | None = None

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the points, and what lies around them."""
        steps, values = -self.returns[:, 1], self.returns[:, 0]
        hull = supported(self.returns)
        ax.plot(steps[hull], values[hull], color=INK, linewidth=0.8, alpha=0.5)
        for which, fill, label in ((hull, INK, "some weights prefer it"), (~hull, "white", "no weights prefer it")):
            ax.scatter(steps[which], values[which], 26, facecolors=fill, edgecolors=INK, zorder=3, label=label)
        for i, (label, treasures) in enumerate(self.found.items()):
            places = [k for k in sorted(set(treasures)) if k < len(steps)]
            at, size, colour = (steps[places], values[places]), SIZES[i % len(SIZES)], stroke(i).color
            ax.scatter(*at, size, facecolors="none", edgecolors=colour, linewidths=2.0, label=label)
        x = np.array([0.0, steps.max() + 1.0])
        if self.weights is not None:
            best = float((self.returns @ self.weights).max())
            ax.plot(x, (best + self.weights[1] * x) / self.weights[0], label="as good as the best", **REFERENCE)
        if self.distance is not None:
            corner = self.returns.max(axis=0)
            missing = (np.array(self.distance) * (corner - self.returns)).max(axis=1).min() / np.array(self.distance)
            low, far = corner[0] - missing[0], -corner[1] + missing[1]
            box = [(-corner[1], low), (far, low), (far, corner[0])]
            ax.plot(*zip(*box, strict=True), label="as close as the closest", **REFERENCE)
            ax.scatter(-corner[1], corner[0], 60, marker="*", color=INK, label="utopian point")
        if self.limit is not None:
            ax.axvline(self.limit + 0.5, label=f"at most {self.limit:g} steps", **SOFT_REFERENCE)
        ax.set_xlim(*x)
        ax.set_ylim(0.0, 97.0)
        ax.set_xticks(steps)
        dress(ax, "steps of the dive", "value of the treasure", self.title)
